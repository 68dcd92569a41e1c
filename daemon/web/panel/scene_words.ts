// The content of the view as text for screen readers: read out when the state changes, otherwise kept up to date
// silently.
import { degrees, fixed } from '../state/format.ts';
import type { Store } from '../state/store.ts';
import { h, setText } from './dom.ts';

/** A change of this key makes a new text due at once: the state, not the figures. */
export function sceneKey(store: Store): string {
  const state = store.get('/state');
  const faults = state?.faults.map(({ name }) => name) ?? [];
  return [store.stale('/estimate'), state?.course, state?.run, state?.session, state?.stop.latched, ...faults].join(' ');
}

/** `replayed`: a recording is shown, whose data is never old. */
export function sceneText(store: Store, replayed: boolean): string {
  const state = store.get('/state');
  if (state === undefined) return replayed ? 'The recording is loading.' : 'Nothing is known of the robot yet.';
  const parts: string[] = [];
  const course = state.course === '' ? 'No course' : `Course ${state.course}`;
  const run = state.pause_left_s === undefined ? state.run : 'paused';
  parts.push(`${replayed ? 'Recording. ' : ''}${course}, robot ${state.robot}, ${run}.`);
  const estimate = store.get('/estimate');
  const pose = store.pose;
  if (store.stale('/estimate')) {
    parts.push('Its pose is not known now.');
  } else if (estimate !== undefined && pose !== undefined) {
    parts.push(`It is at x ${fixed(pose.x_m, 2)} m, y ${fixed(pose.y_m, 2)} m, heading ${degrees(pose.yaw_rad, 0)} degrees.`);
    if (typeof state.length_m === 'number') {
      const error_mm = 1000 * estimate.cross_track_m;
      const side = Math.abs(error_mm) < 0.5 ? 'on the path' : `${fixed(Math.abs(error_mm), 0)} mm to the ${error_mm > 0 ? 'left' : 'right'} of the path`;
      parts.push(`${fixed(state.progress_m, 2)} of ${fixed(state.length_m, 2)} m are driven, ${side}.`);
    }
  }
  if (state.stop.latched) parts.push('STOP is in force.');
  for (const { cause } of state.faults) parts.push(`Fault: ${cause}${/[.!?]$/.test(cause) ? '' : '.'}`);
  return parts.join(' ');
}

/** Period of the figures' updates: they change all the time and are not read out. */
const kPeriod_ms = 10_000;

export class SceneWords {
  readonly element = h('p', { class: 'for-reading', id: 'scene-words', role: 'status' });
  private key = '';
  private next_ms = -Infinity;

  show(store: Store, replayed: boolean, now_ms: number): void {
    const key = `${String(replayed)} ${sceneKey(store)}`;
    if (key === this.key && now_ms < this.next_ms) return;
    this.key = key;
    this.next_ms = now_ms + kPeriod_ms;
    setText(this.element, sceneText(store, replayed));
  }
}
