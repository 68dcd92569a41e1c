// Common interface of the 3-D scene and the 2-D map.
import type { Course } from '../state/messages.ts';
import type { EstimateName, Store } from '../state/store.ts';
import type { CameraMode } from './camera_rig.ts';
import type { Bounds } from './geometry.ts';

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
