// Detects whether anything in a view has moved, as messages keep coming while the robot stands still.
import { kEstimates, type Store } from '../state/store.ts';

/** A smaller change is invisible, or noise at standstill. */
const kStill_m = 0.0003;
/** A turn counts as the way of a point at this distance. */
const kArm_m = 0.3;

export class Moved {
  private last: number[] = [];

  /** True if `store` differs visibly from its state when this was last true. */
  check(store: Store): boolean {
    const now = visible(store);
    const still = now.length === this.last.length && now.every((value, i) => Math.abs(value - (this.last[i] ?? NaN)) < kStill_m);
    if (!still) this.last = now;
    return !still;
  }

  /** Makes the next check true. */
  reset(): void {
    this.last = [];
  }
}

/** Places and ways of all that is drawn, and how many points its paths have. */
function visible(store: Store): number[] {
  const poses = kEstimates.flatMap((name) => {
    const pose = store.get('/estimate')?.[name];
    return pose ? [pose.x_m, pose.y_m, pose.z_m, kArm_m * pose.roll_rad, kArm_m * pose.pitch_rad, kArm_m * pose.yaw_rad] : [];
  });
  return [...poses, ...kEstimates.map((name) => store.path_histories[name].length), store.leftTrack_m, store.rightTrack_m];
}
