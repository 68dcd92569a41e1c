// The state of the run and of the link, in the header.
import { count, duration, fixed } from '../state/format.ts';
import { kSessions, runWords, type Lamp } from '../state/run_words.ts';
import type { LinkPace } from '../state/link_pace.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setText } from './dom.ts';

class Chip {
  readonly element: HTMLElement;
  private readonly value = h('span', { class: 'chip-value' });
  private readonly detail = h('span', { class: 'chip-detail' });

  constructor(name: string) {
    this.element = h('div', { class: 'chip', id: `chip-${name}`, 'data-lamp': 'none' }, this.value, this.detail);
  }

  show(lamp: Lamp, value: string, detail: string, title = detail): void {
    setAttribute(this.element, 'data-lamp', lamp);
    setText(this.value, value);
    setText(this.detail, detail);
    setAttribute(this.element, 'title', title);
  }
}

export const slowText = ({ rate_hz, late_s }: LinkPace): string =>
  `${fixed(rate_hz, 0)} poses a second come, ${fixed(late_s, 1)} s late; images and the past are left out, STOP goes first`;

export class StatusBar {
  readonly element = h('div', { class: 'chips' });
  private readonly run = new Chip('run');
  private readonly link = new Chip('link');

  constructor() {
    this.run.element.setAttribute('role', 'status');
    this.element.append(this.run.element, this.link.element);
  }

  show(store: Store, connected: boolean, pace: LinkPace): void {
    this.showRun(store);
    this.showLink(store, connected, pace);
  }

  private showRun(store: Store): void {
    const state = store.get('/state');
    setAttribute(this.run.element, 'data-run', state?.run ?? '');
    if (state === undefined || store.stale('/state')) {
      this.run.show('none', state === undefined ? '\u2013' : runWords(state).word, 'not known now');
      return;
    }
    const { lamp, word, detail } = runWords(state);
    const watched = state.watch === true ? 'the robot stops when nobody watches' : '';
    this.run.show(lamp, word, detail, [detail, watched].filter((text) => text !== '').join('; '));
  }

  private showLink(store: Store, connected: boolean, pace: LinkPace): void {
    const link = store.get('/link');
    if (!connected) {
      this.link.show('bad', 'no daemon', '');
      return;
    }
    if (pace.slow) {
      this.link.show('warn', 'slow link', `${fixed(pace.rate_hz, 0)} poses/s`, slowText(pace));
      return;
    }
    if (link === undefined || store.stale('/link')) {
      this.link.show('warn', 'silent', '');
      return;
    }
    const title =
      `Link: ${link.kind ?? 'unknown'} robot on ${link.port}, firmware ${link.firmware ?? 'unknown'}; round trip ${duration(link.round_trip_us)}; ` +
      `${count(link.counters.lost)} samples lost, ${count(link.counters.crc_errors)} CRC errors, ${count(link.counters.reconnects)} reconnects`;
    if (link.session !== 'ready') {
      const waiting = link.quality === 'lost' || link.session === 'closed' || link.session === 'refused';
      this.link.show(waiting ? 'bad' : 'wait', 'link', kSessions[link.session], title);
      return;
    }
    const bad_hz = link.lost_hz + link.bad_hz;
    this.link.show(link.quality === 'good' ? 'good' : 'warn', 'link', bad_hz > 0.05 ? `${fixed(bad_hz, 1)} bad/s` : `${fixed(link.samples_hz, 0)} Hz`, title);
  }
}
