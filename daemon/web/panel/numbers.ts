// The six pairs of large figures.
import { degrees, fixed, millimetres, percent } from '../state/format.ts';
import type { Topic } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { h, setClass, setText } from './dom.ts';
import { kHelp } from './help.ts';

interface Value {
  id: string;
  label: string;
  unit: string;
  help: string;
  /** Where it comes from, if not from the figure's topic. */
  topic?: Topic;
  text(store: Store): string;
}

interface Figure {
  topic: Topic;
  values: Value[];
}

const kFigures: Figure[] = [
  {
    topic: '/estimate',
    values: [
      { id: 'x', label: 'x', unit: 'm', help: kHelp.position, text: (store) => fixed(store.pose?.x_m, 3) },
      { id: 'y', label: 'y', unit: 'm', help: kHelp.position, text: (store) => fixed(store.pose?.y_m, 3) },
    ],
  },
  {
    topic: '/estimate',
    values: [
      { id: 'yaw', label: 'yaw', unit: '°', help: kHelp.yaw, text: (store) => degrees(turned(store.pose?.yaw_rad), 1) },
      // Sign inverted, so that nose-up is positive.
      { id: 'climb', label: 'pitch', unit: '°', help: kHelp.pitch, text: (store) => degrees(store.pose === undefined ? null : -store.pose.pitch_rad, 1) },
    ],
  },
  {
    topic: '/estimate',
    values: [
      { id: 'cross-track', label: 'cross-track', unit: 'mm', help: kHelp['cross-track error'], text: (store) => millimetres(store.get('/estimate')?.cross_track_m, 1) },
      { id: 'heading-error', label: 'heading', unit: '°', help: kHelp['heading error'], text: (store) => degrees(store.get('/estimate')?.heading_error_rad, 1) },
    ],
  },
  {
    topic: '/estimate',
    values: [
      { id: 'left', label: 'left', unit: 'm/s', help: kHelp['track speed'], text: (store) => fixed(store.get('/estimate')?.tracks.left_mps, 3) },
      { id: 'right', label: 'right', unit: 'm/s', help: kHelp['track speed'], text: (store) => fixed(store.get('/estimate')?.tracks.right_mps, 3) },
    ],
  },
  {
    topic: '/slip',
    values: [
      { id: 'slip-left', label: 'slip left', unit: '%', help: kHelp['slip ratio'], text: (store) => percent(store.slip.left, 1) },
      { id: 'slip-right', label: 'slip right', unit: '%', help: kHelp['slip ratio'], text: (store) => percent(store.slip.right, 1) },
    ],
  },
  {
    topic: '/state',
    values: [
      { id: 'battery', label: 'battery', unit: 'V', help: kHelp.battery, text: (store) => fixed(store.get('/state')?.battery_v, 2) },
      { id: 'age', label: 'data age', unit: 'ms', help: kHelp.age, topic: '/estimate', text: (store) => fixed(ageMs(store), (ageMs(store) ?? 0) < 100 ? 1 : 0) },
    ],
  },
];

/** Within a turn of the world's x axis, also after several turns. */
const turned = (yaw_rad: number | undefined): number | null => (yaw_rad === undefined ? null : Math.atan2(Math.sin(yaw_rad), Math.cos(yaw_rad)));

/** 0 or more: clock errors can make the age of a fresh sample negative. */
function ageMs(store: Store): number | null {
  const age_us = store.get('/estimate')?.age_us;
  return age_us === undefined ? null : Math.min(Math.max(age_us / 1000, 0), 99_999);
}

export class Numbers {
  readonly element = h('section', { class: 'numbers', 'aria-label': 'Figures' });
  private readonly rows: { value: Value; topic: Topic; row: HTMLElement; output: HTMLElement }[];

  constructor() {
    this.rows = kFigures.flatMap(({ topic, values }) => {
      const tile = h('div', { class: 'number' });
      this.element.append(tile);
      return values.map((value) => {
        const output = h('output', { class: 'number-value', id: `number-${value.id}` }, '\u2013');
        const row = h('div', { class: 'number-row stale', title: value.help }, h('span', { class: 'number-label' }, value.label), output, h('span', { class: 'number-unit' }, value.unit));
        tile.append(row);
        return { value, topic: value.topic ?? topic, row, output };
      });
    });
  }

  show(store: Store): void {
    for (const { value, topic, row, output } of this.rows) {
      setText(output, value.text(store));
      setClass(row, 'stale', store.stale(topic));
      if (value.id === 'battery') setClass(row, 'low', store.battery.low);
    }
  }
}
