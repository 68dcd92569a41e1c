// What the 3-D scene and the 2-D map share: their interface, whether anything has moved, and how often to draw.
import type { Course } from '../state/messages.ts';
import { kEstimates, type EstimateName, type Store } from '../state/store.ts';
import type { Bounds } from './geometry.ts';

export const kCameraModes = ['chase', 'top', 'free'] as const;
export type CameraMode = (typeof kCameraModes)[number];

export interface View {
  /** Its attribute `data-robot` is the pose at which the robot was last drawn: x, y, z [m], yaw [rad]. */
  readonly element: HTMLElement;
  /** `frame`: what a map shows instead of the course's bounds. */
  setCourse(course: Course | undefined, frame?: Bounds): void;
  /** A map has one point of view. */
  setCamera(mode: CameraMode | 'map'): void;
  /** Draws if anything moved; leaves out the `hidden` poses and paths. */
  draw(store: Store, hidden: ReadonlySet<EstimateName>, dt_s: number): void;
  /** Another store, or others are hidden: the next draw() draws everything anew. */
  reset(): void;
  resize(): void;
  dispose(): void;
}

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
  const asked = store.get('/state')?.continue_from;
  return [...poses, asked === undefined ? -1 : asked.progress_m, ...kEstimates.map((name) => store.path_histories[name].length), store.leftTrack_m, store.rightTrack_m];
}

const kSlow_ms = 45;
const kSlowFrames = 40;
/** Largest fraction of the page's time that slow frames may take. */
const kShare = 0.5;

export class Pace {
  private drawn_ms = -Infinity;
  private free_ms = -Infinity;
  private slow = 0;
  private waiting = false;

  /** Frames are slow: without shadows and coarse. Detail is never restored, which would flicker. */
  coarse = false;

  /** Call on every frame; true if this one may be drawn. */
  tick(now_ms: number): boolean {
    if (this.waiting) {
      this.waiting = false;
      const cost_ms = now_ms - this.drawn_ms;
      this.free_ms = cost_ms > kSlow_ms ? now_ms + cost_ms * (1 / kShare - 1) : -Infinity;
      this.slow = cost_ms > kSlow_ms ? this.slow + 1 : Math.max(0, this.slow - 1);
      if (this.slow > kSlowFrames) this.coarse = true;
    }
    return now_ms >= this.free_ms;
  }

  /** A frame was drawn; the next tick shows how long it took. */
  drawn(now_ms: number): void {
    this.drawn_ms = now_ms;
    this.waiting = true;
  }
}
