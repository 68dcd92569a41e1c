// Table with all figures of link, loop and viewers.
import { bytes, count, duration, fixed } from '../state/format.ts';
import type { Distribution } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { h, setClass, setText } from './dom.ts';

const middleAndTail = ({ p50, p99 }: Distribution): string => `${duration(p50)}, ${duration(p99)}`;

type Rows = [label: string, value: string][];

export class LinkTable {
  readonly element = h('div', { class: 'facts', tabindex: '0' });
  private readonly groups = new Map<string, { box: HTMLElement; list: HTMLElement }>();

  show(store: Store): void {
    const link = store.get('/link');
    const loop = store.get('/loop');
    const viewers = store.get('/client');
    if (link !== undefined) {
      this.group('Link', store.stale('/link'), [
        ['port', link.port],
        ['robot', link.kind ?? '\u2013'],
        ['firmware', link.firmware ?? '\u2013'],
        ['session', link.session],
        ['samples', `${fixed(link.samples_hz, 1)} Hz`],
        ['in, out', `${bytes(link.in_bytes_ps)}/s, ${bytes(link.out_bytes_ps)}/s`],
        ['round trip', duration(link.round_trip_us)],
        ['clock', link.clock.valid ? `${fixed(link.clock.drift_ppm, 1)} ppm ±${duration(link.clock.uncertainty_us)}` : '\u2013'],
        ['sample age p50', duration(link.sample_age_us.p50)],
        ['sample age p99.9', duration(link.sample_age_us.p999)],
      ]);
      this.group('Counters', store.stale('/link'), Object.entries(link.counters).map(([name, value]) => [name.replaceAll('_', ' '), count(value)]));
    }
    if (loop !== undefined) {
      this.group('Loop', store.stale('/loop'), [
        ['rate', `${fixed(loop.rate_hz, 0)} Hz, by ${loop.pacing}`],
        ['cycles', count(loop.cycles)],
        ['overruns, missed', `${count(loop.overruns)}, ${count(loop.missed)}`],
        ['lateness p50', duration(loop.lateness_us.p50)],
        ['lateness p99.9', duration(loop.lateness_us.p999)],
        ['lateness max', duration(loop.lateness_us.max)],
        ['work p50', duration(loop.work_us.p50)],
        ['work max', duration(loop.work_us.max)],
        ['compute p50, p99', middleAndTail(loop.compute_us)],
        ['write p50, p99', middleAndTail(loop.write_us)],
        ['sample on the wire p50, p99', middleAndTail(loop.sample_wire_us)],
        ['sample waits p50, p99', middleAndTail(loop.sample_wait_us)],
        ...Object.entries(loop.privileges).map(([name, granted]): [string, string] => [name, granted ? 'granted' : 'refused']),
      ]);
    }
    if (viewers !== undefined) {
      this.group('Viewers', store.stale('/client'), [
        ['dropped, refused, closed', [viewers.dropped_total, viewers.refused_total, viewers.closed_total].map(count).join(', ')],
        ...viewers.clients.slice(0, 20).map((viewer): [string, string] => [
          `${viewer.id} ${viewer.address}`,
          `${count(viewer.sent)} sent, ${count(viewer.dropped)} dropped`,
        ]),
      ]);
    }
  }

  private group(title: string, stale: boolean, rows: Rows): void {
    let group = this.groups.get(title);
    if (group === undefined) {
      const list = h('dl');
      group = { box: h('section', { class: 'fact-group' }, h('h3', {}, title), list), list };
      this.groups.set(title, group);
      this.element.append(group.box);
    }
    setClass(group.box, 'stale', stale);
    const { list } = group;
    while (list.children.length > 2 * rows.length) list.lastElementChild?.remove();
    rows.forEach(([label, value], i) => {
      if (list.children.length < 2 * i + 2) list.append(h('dt'), h('dd'));
      const [name, figure] = [list.children[2 * i], list.children[2 * i + 1]];
      if (name) setText(name, label);
      if (figure) setText(figure, value);
    });
  }
}
