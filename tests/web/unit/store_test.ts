// The data that the views draw: current, old, of this run, and bounded.
import { beforeEach, expect, it } from 'vitest';
import { BatteryWatch, column, kEvents, Store, type Column } from '../../../daemon/web/state/store.ts';
import type { Estimate, EstimatedPose, Event, State } from '../../../daemon/web/state/messages.ts';
import { Moved } from '../../../daemon/web/scene/view.ts';

const at = (x_m: number, y_m = 0): EstimatedPose => ({ x_m, y_m, z_m: 0, roll_rad: 0, pitch_rad: 0, yaw_rad: 0 }) as EstimatedPose;
const estimate = (t_s: number, x_m: number, more: object = {}): Estimate =>
  ({ t_s, age_us: 3000, steering: 'odometry', model: at(x_m), odometry: at(x_m, 0.001), fused: at(x_m), truth: null, tracks: { left_mps: 0.1, right_mps: 0.2 }, ...more }) as unknown as Estimate;
const event = (t_s: number): Event => ({ t_s, kind: 'run', level: 'info', text: 'x', cause: '', fix: '' });

let now_ms: number;
let store: Store;
beforeEach(() => {
  now_ms = 0;
  store = new Store(() => now_ms);
});

it('the pose is the one that steers', () => {
  store.receive('/estimate', estimate(0, 1));
  expect(store.pose?.y_m).toBe(0.001);
  store.receive('/estimate', estimate(0.005, 1, { steering: 'model' }));
  expect(store.pose?.y_m).toBe(0);
});

it('a value is stale when its message is old, or the robot’s sample is', () => {
  expect(store.stale('/estimate')).toBe(true);
  store.receive('/estimate', estimate(0, 0));
  expect(store.stale('/estimate')).toBe(false);
  now_ms = 2000;
  expect(store.stale('/estimate')).toBe(true);
  for (const age_us of [2e6, undefined]) {
    store.receive('/estimate', estimate(2, 0, { age_us }));
    expect(store.stale('/estimate')).toBe(true);
  }
});

it('a run adds up how far the tracks ran, and has its path until another run begins or the pose jumps', () => {
  for (let i = 0; i <= 200; i++) store.receive('/estimate', estimate(i * 0.005, i * 0.01));
  expect([store.leftTrack_m, store.rightTrack_m].map((way_m) => way_m.toFixed(6))).toEqual(['0.100000', '0.200000']);
  expect(store.path_histories.model.length).toBe(201);
  store.receive('/estimate', estimate(10, -0.2));
  expect(store.path_histories.model.length).toBe(1);
  for (const run of ['arming', 'running'] as const) store.receive('/state', { run } as State);
  expect(store.path_histories.model.length).toBe(0);
});

it('it stays bounded however long it runs, and takes an event that is repeated after a reconnection once', () => {
  for (let i = 0; i < 2 * store.series.capacity; i++) store.receive('/estimate', estimate(i * 0.02, (i % 1000) * 0.001));
  expect(store.series.length).toBeLessThanOrEqual(store.series.capacity);
  for (let i = 0; i < 1000; i++) for (let n = 0; n < 2; n++) store.receive('/event', event(i));
  expect(store.events.map(({ t_s }) => t_s)).toEqual(Array.from({ length: kEvents }, (_, i) => 1000 - kEvents + i));
  store.clear();
  expect(store.events).toEqual([]);
});

it('the diagrams show what was estimated in their units, and errors only against a truth', () => {
  const yaw = (yaw_deg: number): EstimatedPose => ({ ...at(1), yaw_rad: (yaw_deg * Math.PI) / 180 });
  const of = { model: yaw(10), odometry: yaw(20), fused: { ...yaw(30), camera_age_us: 2000 }, desired_yaw_rad: Math.PI / 2, cross_track_m: 0.002, heading_error_rad: Math.PI / 4, tracks: { left_mps: 0.1, right_mps: 0.2, left_commanded_mps: 0.3 } };
  store.receive('/slip', { t_s: 0, left: 0.16, right: 0.17, fused_left: 0.18, fused_right: 0.19, gyro_bias_radps: 0, fused_gyro_bias_radps: 0, slope_rad: 0 });
  store.receive('/estimate', estimate(0, 1, of));
  store.receive('/estimate', estimate(1, 1, { ...of, truth: at(1, 0.003) }));
  const columns: Partial<Record<Column, [before: number, after: number]>> = {
    t_s: [0, 1], desired_yaw_deg: [90, 90], model_yaw_deg: [10, 10], odometry_yaw_deg: [20, 20], fused_yaw_deg: [30, 30], truth_yaw_deg: [NaN, 0],
    cross_track_mm: [2, 2], heading_error_deg: [45, 45], left_mps: [0.1, 0.1], right_mps: [0.2, 0.2], left_commanded_mps: [0.3, 0.3], right_commanded_mps: [NaN, NaN],
    slip_left_percent: [16, 16], slip_right_percent: [17, 17], fused_slip_left_percent: [18, 18], fused_slip_right_percent: [19, 19],
    model_error_mm: [NaN, 3], odometry_error_mm: [NaN, 3], fused_error_mm: [NaN, 3],
  };
  const shown = Object.keys(columns).map((name) => [...column(store.series.since(-1), name as Column)].map((value) => Math.round(value * 1e6) / 1e6));
  expect(shown).toEqual(Object.values(columns));
});

it('the diagrams have a gap where nothing is known: slip at standstill, fused without a camera, all of it without a fresh sample', () => {
  store.receive('/slip', { t_s: 0, left: 0.16, right: 0.17, fused_left: 0.18, fused_right: 0.19, gyro_bias_radps: 0, fused_gyro_bias_radps: 0, slope_rad: 0 });
  store.receive('/estimate', estimate(0, 1));
  expect(store.usesCamera).toBe(false);
  expect(store.slip).toEqual({ left: 0.16, right: 0.17 });
  store.receive('/estimate', estimate(1, 1, { tracks: { left_mps: 0.001, right_mps: 0 } as Estimate['tracks'] }));
  expect(store.slip).toEqual({ left: NaN, right: NaN });
  store.receive('/estimate', estimate(2, 1, { age_us: 2e6 }));
  const shown = (name: Column): number[] => [...column(store.series.since(-1), name)];
  expect(shown('slip_left_percent')).toEqual([16, NaN, NaN]);
  expect(shown('fused_yaw_deg')).toEqual([NaN, NaN, NaN]);
  expect(shown('left_mps')).toEqual([0.1, 0.001, NaN]);
  expect(shown('t_s')).toEqual([0, 1, 2]);
});

it('what was driven before is part of the path', () => {
  const points = Array.from({ length: 50 }, (_, i) => ({ x: 0.02 * i, y: 0, z: 0 }));
  store.receive('/path_history', { entities: [{ id: 'path_history/model/0', lines: [{ points }] }] });
  expect(store.path_histories.model.length).toBe(50);
  expect(store.path_histories.fused.length).toBe(0);
});

// Otherwise a computer without a graphics card would spend its processors on pictures that nobody sees change.
it('a view is drawn again when something moves, not with each message of a robot that stands', () => {
  const moved = new Moved();
  const drawn = (t_s: number, x_m: number, more: object = {}): boolean => {
    store.receive('/estimate', estimate(t_s, x_m, { tracks: { left_mps: 0, right_mps: 0 }, ...more }));
    return moved.check(store);
  };
  expect([drawn(0, 1), drawn(0.1, 1), drawn(0.2, 1.0001), drawn(0.3, 1.001)]).toEqual([true, false, false, true]);
  expect(drawn(0.4, 1.001, { tracks: { left_mps: 0.1, right_mps: 0 } }), 'a track runs').toBe(true);
  expect(drawn(0.5, 1.001, { truth: at(1) }), 'a source more').toBe(true);
});

it('the battery is low when it stays near the limit, not when a motor starts', () => {
  const battery = new BatteryWatch();
  const looks: [t_s: number, voltage_v: number | undefined, low: boolean, why: string][] = [
    [0, 6.4, false, 'near the limit'],
    [1.5, 7, false, 'the motor runs'],
    [2.5, 6.4, false, 'near the limit again'],
    [4.6, 6.4, true, 'it stayed there for 2 s'],
    [5, 6.55, true, 'a little more is not enough'],
    [6, 6.7, false, 'it is charged'],
    [7, undefined, false, 'no battery'],
    [10, undefined, false, 'no battery for long'],
  ];
  for (const [t_s, voltage_v, low, why] of looks) {
    battery.take(t_s, voltage_v, 6.2);
    expect(battery.low, why).toBe(low);
  }
  for (const limit_v of [undefined, 0]) for (const t_s of [20, 30]) battery.take(t_s, 6.2, limit_v);
  expect(battery.low, 'no limit is known').toBe(false);
});
