// Detects whether anything in a view has moved, as messages keep coming while the robot stands still.
import type { Pose } from '../state/messages.ts';
import { kEstimates, type Store } from '../state/store.ts';

/** Changes smaller than these are invisible, or noise at standstill. */
const kStill_m = 0.0003;
const kStill_rad = 0.001;

export class Moved {
  private poses: (Pose | undefined)[] = [];
  private tracks_m: number[] = [];
  private points: number[] = [];

  /** True if `store` differs visibly from its state when this was last true. */
  check(store: Store): boolean {
    const estimate = store.get('/estimate');
    const poses = kEstimates.map((name) => estimate?.[name] ?? undefined);
    const tracks_m = [store.leftTrack_m, store.rightTrack_m];
    const points = kEstimates.map((name) => store.path_histories[name].length);
    const still =
      this.poses.length > 0 &&
      poses.every((pose, i) => same(pose, this.poses[i])) &&
      tracks_m.every((track_m, i) => Math.abs(track_m - (this.tracks_m[i] ?? NaN)) < kStill_m) &&
      points.every((count, i) => count === this.points[i]);
    if (still) return false;
    this.poses = poses;
    this.tracks_m = tracks_m;
    this.points = points;
    return true;
  }

  /** Makes the next check true. */
  reset(): void {
    this.poses = [];
  }
}

function same(a: Pose | undefined, b: Pose | undefined): boolean {
  if (a === undefined || b === undefined) return a === b;
  return (
    Math.abs(a.x_m - b.x_m) < kStill_m &&
    Math.abs(a.y_m - b.y_m) < kStill_m &&
    Math.abs(a.z_m - b.z_m) < kStill_m &&
    Math.abs(a.roll_rad - b.roll_rad) < kStill_rad &&
    Math.abs(a.pitch_rad - b.pitch_rad) < kStill_rad &&
    Math.abs(a.yaw_rad - b.yaw_rad) < kStill_rad
  );
}
