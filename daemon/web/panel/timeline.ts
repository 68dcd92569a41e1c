// Progress along the course as a strip: its obstacles and the robot's position; and the time that is left.
import { clock, fixed } from '../state/format.ts';
import type { Course, Place, Segment } from '../state/messages.ts';
import { minutes } from '../state/run_words.ts';
import type { Store } from '../state/store.ts';
import { heightOf, lengthOf } from '../scene/geometry.ts';
import { h, setClass, setText } from './dom.ts';

/** Another run began, or a recording was wound back. */
const kBack_m = 0.05;
/** An older mark came before this page knew where the robot was. */
const kLate_s = 2;

export class Timeline {
  readonly element = h('section', { class: 'timeline', 'aria-label': 'Progress' });
  private readonly name = h('span', { class: 'timeline-name' });
  private readonly strip = h('div', { class: 'strip' });
  private readonly fill = h('i', { class: 'strip-fill' });
  private readonly marks = h('div', { class: 'strip-marks' });
  private readonly time = h('output', { class: 'timeline-time' });
  private readonly progress = h('output', { class: 'timeline-progress' });
  private readonly left = h('output', { class: 'timeline-left', title: 'At the speed of the course' });
  private courseShown = -1;
  private eventsShown = -1;
  private readonly marked = new Set<number>();
  private last_m = 0;

  constructor() {
    this.strip.append(this.fill, this.marks);
    this.element.append(this.name, this.strip, this.progress, this.left, this.time);
  }

  show(store: Store): void {
    const received = store.received['/course'] ?? 0;
    const course = store.get('/course');
    if (received !== this.courseShown) {
      this.courseShown = received;
      this.build(course);
    }
    const state = store.get('/state');
    const length_m = course?.length_m ?? 0;
    const progress_m = store.get('/estimate')?.progress_m ?? 0;
    if (progress_m < this.last_m - kBack_m) this.unmark();
    this.last_m = progress_m;
    this.markMoments(store, length_m, progress_m);
    const share = length_m > 0 ? Math.min(Math.max(progress_m / length_m, 0), 1) : 0;
    const transform = `scaleX(${share.toFixed(4)})`;
    if (this.fill.style.transform !== transform) this.fill.style.transform = transform;
    setText(this.progress, length_m > 0 ? `${fixed(progress_m, 2)} / ${fixed(length_m, 2)} m` : '\u2013');
    const left_s = course !== undefined && state?.run === 'running' && state.pause_left_s === undefined ? timeLeft_s(course, progress_m) : undefined;
    setText(this.left, left_s === undefined ? '' : `${minutes(left_s)} left`);
    setText(this.time, clock(state?.run_s ?? 0));
    setClass(this.element, 'stale', store.stale('/estimate'));
  }

  /** A mark stands where the robot was when it came. */
  private markMoments(store: Store, length_m: number, progress_m: number): void {
    const received = store.received['/event'] ?? 0;
    if (received === this.eventsShown || length_m <= 0) return;
    this.eventsShown = received;
    for (const { kind, t_s, text } of store.events) {
      if (kind !== 'mark' || this.marked.has(t_s)) continue;
      this.marked.add(t_s);
      if (t_s < (store.get('/estimate')?.t_s ?? 0) - kLate_s) continue;
      const element = h('i', { class: 'mark moment', title: text });
      element.style.left = `${((100 * progress_m) / length_m).toFixed(2)}%`;
      this.marks.append(element);
    }
  }

  private unmark(): void {
    for (const old of this.marks.querySelectorAll('.moment')) old.remove();
    this.marked.clear();
  }

  private build(course: Course | undefined): void {
    setText(this.name, course === undefined || course.name === '' ? 'no course' : `course ${course.name}`);
    this.name.title = course?.description ?? '';
    this.marks.replaceChildren();
    if (course === undefined || course.length_m <= 0) return;
    const mark = (from_m: number, to_m: number, kind: string, title: string): void => {
      const element = h('i', { class: `mark ${kind}`, title });
      element.style.left = `${((100 * from_m) / course.length_m).toFixed(2)}%`;
      element.style.width = `${((100 * (to_m - from_m)) / course.length_m).toFixed(2)}%`;
      this.marks.append(element);
    };
    for (const piece of course.obstacles ?? []) {
      const stretch = along(course, piece, lengthOf(piece));
      if (stretch) mark(stretch[0], stretch[1], piece.kind, `${piece.kind}, ${fixed(1000 * heightOf(piece), 0)} mm high`);
    }
    for (const disturbance of course.disturbances) mark(disturbance.at_m, disturbance.at_m + 0.01, 'disturbance', 'disturbance');
  }
}

/** A usual rate of a turn on the spot. */
const kPivot_radps = 0.5;

/** How long the rest of the course takes at its speed. */
export function timeLeft_s(course: Course, progress_m: number): number {
  const turned_rad = ({ begin, end }: Segment): number => Math.abs(Math.atan2(Math.sin(end.yaw_rad - begin.yaw_rad), Math.cos(end.yaw_rad - begin.yaw_rad)));
  const turns = course.segments.filter(({ kind, from_m }) => kind === 'pivot' && from_m >= progress_m);
  return Math.max(course.length_m - progress_m, 0) / course.speed_mps + turns.reduce((sum_s, turn) => sum_s + turned_rad(turn) / kPivot_radps, 0);
}

/** The part of the path within half of `length` of a piece's middle; undefined if the path does not cross it. */
function along(course: Course, place: Place, length: number): [number, number] | undefined {
  const near = course.path.filter((point) => Math.hypot(point.x_m - place.x_m, point.y_m - place.y_m) <= length / 2);
  const first = near[0];
  const last = near.at(-1);
  return first && last ? [first.s_m, last.s_m] : undefined;
}
