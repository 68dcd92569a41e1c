// The viewpoint: behind the robot, from above, or as set by the mouse.
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Pose } from '../state/messages.ts';
import type { Bounds } from './geometry.ts';
import type { CameraMode } from './view.ts';

const kChaseBack_m = 0.52;
const kChaseUp_m = 0.29;
const kChaseAhead_m = 0.16;
/** Time constant with which the chase camera turns. */
const kChaseTurn_s = 0.5;
const kGlide_s = 0.18;

export class CameraRig {
  readonly camera = new PerspectiveCamera(40, 1, 0.02, 60);
  private readonly controls: OrbitControls;
  private mode: CameraMode = 'free';
  private heading_rad = 0;
  private box: Bounds = { min_x: -1, max_x: 1, min_y: -1, max_y: 1 };
  private moved = true;
  private readonly wantedEye = new Vector3();
  private readonly wantedTarget = new Vector3();

  constructor(
    element: HTMLElement,
    /** Called when the user moves the camera with the mouse. */
    private readonly taken: () => void,
  ) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = Math.PI / 2 - 0.02;
    this.controls.minDistance = 0.15;
    this.controls.maxDistance = 8;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('start', () => {
      if (this.mode === 'free') return;
      this.mode = 'free';
      this.taken();
    });
    this.controls.addEventListener('change', () => {
      this.moved = true;
    });
    this.overview();
  }

  /** Selecting free again returns to the overview of the course. */
  set(mode: CameraMode): void {
    if (mode === 'free' && this.mode === 'free') this.overview();
    this.mode = mode;
    this.moved = true;
  }

  frame(box: Bounds): void {
    this.box = box;
    if (this.mode === 'free') this.overview();
    this.moved = true;
  }

  resize(aspect: number): void {
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    if (this.mode === 'free') this.overview();
    this.moved = true;
  }

  /** Advances by `dt_s`; true if the view changes. */
  update(pose: Pose | undefined, dt_s: number): boolean {
    if (this.mode === 'chase' && pose !== undefined) this.chase(pose, dt_s);
    else if (this.mode === 'top') this.above(dt_s);
    const moved = this.moved;
    this.moved = false;
    return moved;
  }

  /** Viewpoint from the south-east with the whole course in view. */
  private overview(): void {
    const { x, y, reach } = this.middle();
    const distance = reach * 1.02;
    this.controls.target.set(x, y, 0);
    this.camera.position.set(x + 0.16 * distance, y - 0.78 * distance, 0.72 * distance);
    this.controls.update();
  }

  private chase(pose: Pose, dt_s: number): void {
    const turn = Math.atan2(Math.sin(pose.yaw_rad - this.heading_rad), Math.cos(pose.yaw_rad - this.heading_rad));
    this.heading_rad += turn * (1 - Math.exp(-dt_s / kChaseTurn_s));
    const cos = Math.cos(this.heading_rad);
    const sin = Math.sin(this.heading_rad);
    this.wantedEye.set(pose.x_m - kChaseBack_m * cos, pose.y_m - kChaseBack_m * sin, pose.z_m + kChaseUp_m);
    this.wantedTarget.set(pose.x_m + kChaseAhead_m * cos, pose.y_m + kChaseAhead_m * sin, pose.z_m + 0.03);
    this.glide(dt_s);
  }

  private above(dt_s: number): void {
    const { x, y, height } = this.middle();
    // Slightly to the south (-y), so that north (+y) stays up.
    this.wantedEye.set(x, y - 0.002, height);
    this.wantedTarget.set(x, y, 0);
    this.glide(dt_s);
  }

  private glide(dt_s: number): void {
    const share = 1 - Math.exp(-dt_s / kGlide_s);
    const { position } = this.camera;
    const far = position.distanceToSquared(this.wantedEye) + this.controls.target.distanceToSquared(this.wantedTarget);
    if (far < 1e-9) return;
    position.lerp(this.wantedEye, share);
    this.controls.target.lerp(this.wantedTarget, share);
    this.camera.lookAt(this.controls.target);
    this.moved = true;
  }

  private middle(): { x: number; y: number; reach: number; height: number } {
    const { min_x, max_x, min_y, max_y } = this.box;
    const tan = Math.tan((this.camera.fov * Math.PI) / 360);
    const width = max_x - min_x + 0.25;
    const depth = max_y - min_y + 0.25;
    const height = Math.max(depth, width / this.camera.aspect) / (2 * tan);
    const reach = Math.max(width / this.camera.aspect, depth * 0.85) / (2 * tan) + 0.3;
    return { x: (min_x + max_x) / 2, y: (min_y + max_y) / 2, reach, height };
  }
}
