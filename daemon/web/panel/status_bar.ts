// The row of chips: state of run, link and loop.
import { clock, count, duration, fixed } from '../state/format.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setText } from './dom.ts';
import { asksForMotion } from '../state/messages.ts';

/** State of a chip's lamp. */
type Lamp = 'good' | 'done' | 'wait' | 'warn' | 'bad' | 'none';

class Chip {
  readonly element: HTMLElement;
  private readonly value = h('span', { class: 'chip-value' });
  private readonly detail = h('span', { class: 'chip-detail' });

  constructor(name: string, label: string) {
    this.element = h(
      'div',
      { class: 'chip', id: `chip-${name}`, 'data-lamp': 'none' },
      h('span', { class: 'chip-label' }, label),
      this.value,
      this.detail,
    );
  }

  show(lamp: Lamp, value: string, detail: string, title = ''): void {
    setAttribute(this.element, 'data-lamp', lamp);
    setText(this.value, value);
    setText(this.detail, detail);
    setAttribute(this.element, 'title', title);
  }
}

export const kRunLamps: Record<string, Lamp> = { idle: 'none', arming: 'wait', running: 'good', finished: 'done', aborted: 'bad', driving: 'good' };

export class StatusBar {
  readonly element = h('div', { class: 'chips' });
  private readonly run = new Chip('run', 'run');
  private readonly link = new Chip('link', 'link');
  private readonly loop = new Chip('loop', 'loop');
  private readonly viewers = new Chip('viewers', 'viewers');

  constructor() {
    this.run.element.setAttribute('role', 'status');
    this.element.append(this.run.element, this.link.element, this.loop.element, this.viewers.element);
  }

  show(store: Store, connected: boolean): void {
    this.showRun(store);
    this.showLink(store, connected);
    const loop = store.get('/loop');
    if (!connected || loop === undefined || store.stale('/loop')) {
      this.loop.show('none', '\u2013', '');
    } else {
      const late = loop.overruns + loop.missed;
      this.loop.show(
        late > 0 ? 'warn' : 'good',
        `${fixed(loop.rate_hz, 0)} Hz`,
        `p99.9 ${duration(loop.lateness_us.p999)}`,
        `${count(loop.overruns)} overruns, ${count(loop.missed)} missed cycles, paced by the ${loop.pacing}`,
      );
    }
    const viewers = store.get('/client');
    const dropped = viewers?.dropped_total ?? 0;
    this.viewers.show(
      dropped > 0 ? 'warn' : 'none',
      connected ? fixed(viewers?.clients.length, 0) : '\u2013',
      dropped > 0 ? `${count(dropped)} dropped` : '',
      `Browsers and other clients of this daemon; ${count(dropped)} messages dropped because one was too slow`,
    );
  }

  private showRun(store: Store): void {
    const state = store.get('/state');
    if (state === undefined || store.stale('/state')) {
      this.run.show('none', state?.run ?? '\u2013', 'stale');
      return;
    }
    const asked = asksForMotion(state.run);
    if (state.motors_on && !asked) {
      this.run.show('bad', state.run, 'motors on', 'The motors are on, though no run is under way');
      return;
    }
    const since = typeof state.run_s === 'number' ? clock(state.run_s) : '';
    const detail = state.run === 'driving' && state.driver ? state.driver.by : since;
    const watched = state.watch === true ? 'the robot stops when nobody watches' : '';
    const title = [watched, state.why_not_start].filter((text) => text !== '').join('; ');
    this.run.show(kRunLamps[state.run] ?? 'none', state.run, detail, title);
  }

  private showLink(store: Store, connected: boolean): void {
    const link = store.get('/link');
    if (!connected) {
      this.link.show('bad', 'no daemon', '');
      return;
    }
    if (link === undefined || store.stale('/link')) {
      this.link.show('warn', 'silent', '');
      return;
    }
    const bad_hz = link.lost_hz + link.bad_hz;
    const title =
      `${link.kind ?? 'unknown'} robot on ${link.port}, firmware ${link.firmware ?? 'unknown'}; ` +
      `${count(link.counters.lost)} samples lost, ${count(link.counters.crc_errors)} CRC errors, ` +
      `${count(link.counters.reconnects)} reconnects`;
    if (link.session !== 'ready') {
      const waiting = link.quality === 'lost' || link.session === 'closed' || link.session === 'refused';
      this.link.show(waiting ? 'bad' : 'wait', link.session, link.port, title);
      return;
    }
    this.link.show(
      link.quality === 'good' ? 'good' : 'warn',
      `${fixed(link.samples_hz, 0)} Hz`,
      bad_hz > 0.05 ? `${fixed(bad_hz, 1)} bad/s` : `rtt ${duration(link.round_trip_us)}`,
      title,
    );
  }
}
