import { beforeEach, describe, expect, it } from 'vitest';
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

describe('Player', () => {
  it('begins at the first pose, with the course known and nothing stale', () => {
    expect(player.position_s).toBe(0);
    expect(player.duration_s).toBeCloseTo(10);
    expect(player.store.get('/course')?.name).toBe('3');
    expect(player.store.stale('/estimate')).toBe(false);
  });

  it('shows the same moment from either side', () => {
    player.show(4);
    const there = { pose: player.store.pose, track: player.store.leftTrack_m, path_history: player.store.path_histories.model.length };
    player.show(9);
    expect(player.store.pose?.x_m).toBeCloseTo(0.9);
    player.show(4);
    expect(player.store.pose).toEqual(there.pose);
    expect(player.store.leftTrack_m).toBeCloseTo(there.track, 9);
    expect(player.store.path_histories.model.length).toBe(there.path_history);
  });

  it('plays at its speed, stops at the end and begins anew', () => {
    player.toggle();
    player.speed = 2;
    for (let i = 0; i < 100; i++) player.tick(0.02);
    expect(player.position_s).toBeCloseTo(4);
    for (let i = 0; i < 1000; i++) player.tick(0.02);
    expect(player.playing).toBe(false);
    expect(player.position_s).toBeCloseTo(10);
    player.toggle();
    expect(player.position_s).toBe(0);
    expect(player.playing).toBe(true);
  });

  it('stays within the recording', () => {
    player.show(-3);
    expect(player.position_s).toBe(0);
    player.show(1e9);
    expect(player.position_s).toBeCloseTo(10);
  });
});
