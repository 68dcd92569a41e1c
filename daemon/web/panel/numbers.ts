// The row of large current figures.
import { degrees, fixed, millimetres, percent } from '../state/format.ts';
import type { Topic } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { h, setClass, setText } from './dom.ts';

interface Figure {
  id: string;
  label: string;
  unit: string;
  topic: Topic;
  text(store: Store): string;
}

const kFigures: Figure[] = [
  { id: 'x', label: 'x', unit: 'm', topic: '/estimate', text: (store) => fixed(store.pose?.x_m, 3) },
  { id: 'y', label: 'y', unit: 'm', topic: '/estimate', text: (store) => fixed(store.pose?.y_m, 3) },
  { id: 'yaw', label: 'yaw', unit: '°', topic: '/estimate', text: (store) => degrees(store.pose?.yaw_rad, 1) },
  // Sign inverted, so that nose-up is positive.
  {
    id: 'climb',
    label: 'pitch, nose up',
    unit: '°',
    topic: '/estimate',
    text: (store) => degrees(store.pose === undefined ? null : -store.pose.pitch_rad, 1),
  },
  {
    id: 'cross-track',
    label: 'cross-track',
    unit: 'mm',
    topic: '/estimate',
    text: (store) => millimetres(store.get('/estimate')?.cross_track_m, 1),
  },
  {
    id: 'heading-error',
    label: 'heading error',
    unit: '°',
    topic: '/estimate',
    text: (store) => degrees(store.get('/estimate')?.heading_error_rad, 1),
  },
  { id: 'left', label: 'left track', unit: 'm/s', topic: '/estimate', text: (store) => fixed(store.get('/estimate')?.tracks.left_mps, 3) },
  { id: 'right', label: 'right track', unit: 'm/s', topic: '/estimate', text: (store) => fixed(store.get('/estimate')?.tracks.right_mps, 3) },
  { id: 'slip-left', label: 'slip left', unit: '%', topic: '/slip', text: (store) => percent(store.get('/slip')?.left, 1) },
  { id: 'slip-right', label: 'slip right', unit: '%', topic: '/slip', text: (store) => percent(store.get('/slip')?.right, 1) },
  {
    id: 'age',
    label: 'data age',
    unit: 'ms',
    topic: '/estimate',
    // ageMs() limits it to 0 or more: clock errors can make the age of a fresh sample negative.
    text: (store) => fixed(ageMs(store), (ageMs(store) ?? 0) < 100 ? 1 : 0),
  },
  { id: 'battery', label: 'battery', unit: 'V', topic: '/state', text: (store) => fixed(store.get('/state')?.battery_v, 2) },
];

function ageMs(store: Store): number | null {
  const age_us = store.get('/estimate')?.age_us ?? null;
  return age_us === null ? null : Math.min(Math.max(age_us / 1000, 0), 99_999);
}

export class Numbers {
  readonly element = h('section', { class: 'numbers', 'aria-label': 'Figures' });
  private readonly rows: { figure: Figure; tile: HTMLElement; value: HTMLElement }[];

  constructor() {
    this.rows = kFigures.map((figure) => {
      const value = h('output', { class: 'number-value', id: `number-${figure.id}` }, '\u2013');
      const tile = h(
        'div',
        { class: 'number stale' },
        h('span', { class: 'number-label' }, figure.label),
        h('span', { class: 'number-line' }, value, h('span', { class: 'number-unit' }, figure.unit)),
      );
      this.element.append(tile);
      return { figure, tile, value };
    });
  }

  show(store: Store): void {
    for (const { figure, tile, value } of this.rows) {
      setText(value, figure.text(store));
      setClass(tile, 'stale', store.stale(figure.topic));
      if (figure.id === 'battery') setClass(tile, 'low', store.battery.low);
    }
  }
}
