// The scene in words, for who cannot see it.
import { expect, it } from 'vitest';
import type { Estimate, State } from '../../../daemon/web/state/messages.ts';
import { sceneKey, sceneText } from '../../../daemon/web/panel/scene_words.ts';
import { Store } from '../../../daemon/web/state/store.ts';

const kState = {
  run: 'running', session: 'ready', course: '3', robot: 'worn', progress_m: 1.2, length_m: 3.9, faults: [],
  stop: { latched: false }, t_s: 1,
} as unknown as State;
const kEstimate = {
  t_s: 1, age_us: 3000, steering: 'odometry', cross_track_m: -0.0042, tracks: {},
  model: { x_m: 0, y_m: 0 }, fused: { x_m: 0, y_m: 0 }, odometry: { x_m: 1.204, y_m: -0.31, yaw_rad: 0.5 },
} as unknown as Estimate;

let now_ms = 0;
function store(state: Partial<State> = {}, estimate: Partial<Estimate> = {}): Store {
  const made = new Store(() => now_ms);
  made.receive('/state', { ...kState, ...state });
  made.receive('/estimate', { ...kEstimate, ...estimate });
  return made;
}

it('it says where the robot is, what it does and what is wrong', () => {
  expect(sceneText(store(), false)).toBe(
    'Course 3, robot worn, running. It is at x 1.20 m, y \u22120.31 m, heading 29 degrees. 1.20 of 3.90 m are driven, 4 mm to the right of the path.',
  );
  const faults = [{ name: 'a', cause: 'too far from the path', fix: '', from: 'daemon' as const }];
  expect(sceneText(store({ run: 'aborted', faults, stop: { ...kState.stop, latched: true } }), false)).toMatch(/STOP is in force\. Fault: too far from the path\.$/);
});

it('it tells no pose that is old, and is due when the state changes, not when a figure does', () => {
  const old = store();
  const key = sceneKey(old);
  expect(sceneKey(store({ progress_m: 2 }, { cross_track_m: 0.01 }))).toBe(key);
  for (const changed of [{ run: 'aborted' as const }, { course: '2' }, { faults: [{ name: 'a', cause: '', fix: '', from: 'daemon' as const }] }])
    expect(sceneKey(store(changed))).not.toBe(key);
  now_ms += 1000;
  expect(sceneText(old, false)).toBe('Course 3, robot worn, running. Its pose is not known now.');
  expect(sceneKey(old)).not.toBe(key);
  expect(sceneText(new Store(), false)).toBe('Nothing is known of the robot yet.');
});
