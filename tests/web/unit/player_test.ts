// A recorded run that is played and scrubbed.
import { beforeEach, expect, it } from 'vitest';
import { Player } from '../../../daemon/web/replay/player.ts';
import type { Frame } from '../../../daemon/web/replay/recording.ts';
import { Store } from '../../../daemon/web/state/store.ts';

function estimate(t_s: number): unknown {
  const pose = { x_m: t_s * 0.1, y_m: 0, z_m: 0, yaw_rad: 0 };
  return { t_s, age_us: 3000, steering: 'odometry', model: pose, odometry: pose, fused: pose, truth: null, tracks: { left_mps: 0.1, right_mps: 0.1 } };
}

const kBegin = 1000;
const frames: Frame[] = [{ time_s: kBegin - 5, topic: '/course', message: { name: '3' } }];
for (let i = 0; i <= 500; i++) frames.push({ time_s: kBegin + 0.02 * i, topic: '/estimate', message: estimate(0.02 * i) });

let player: Player;
beforeEach(() => {
  player = new Player(frames, new Store(() => 0));
});

it('it begins at the first pose, with the course known and nothing stale, and shows no moment outside of the recording', () => {
  expect(player.position_s).toBe(0);
  expect(player.store.get('/course')?.name).toBe('3');
  expect(player.store.stale('/estimate')).toBe(false);
  player.show(-3);
  expect(player.position_s).toBe(0);
  player.show(1e9);
  expect(player.position_s).toBeCloseTo(10);
});

it('it shows the marks of its recording and those that were made afterwards at their times', () => {
  const event = { t_s: 3, kind: 'mark', level: 'info', text: 'slips', cause: '', fix: '' };
  const all: Frame[] = [...frames, { time_s: kBegin + 3, topic: '/event', message: event }];
  const marked = new Player(all.sort((a, b) => a.time_s - b.time_s), new Store(() => 0));
  marked.show(4);
  expect(marked.t_s).toBeCloseTo(4);
  marked.mark(marked.t_s, 'again');
  expect(marked.marks).toEqual([{ position_s: 3, text: 'slips' }, { position_s: 4, text: 'again' }]);
});

it('it plays at its speed, stops at the end and begins anew', () => {
  player.toggle();
  player.speed = 2;
  for (let i = 0; i < 100; i++) player.tick(0.02);
  expect(player.position_s).toBeCloseTo(4);
  for (let i = 0; i < 1000; i++) player.tick(0.02);
  expect(player.playing).toBe(false);
  player.toggle();
  expect([player.position_s, player.playing]).toEqual([0, true]);
});
