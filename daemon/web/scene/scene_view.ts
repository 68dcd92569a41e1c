// The course and the robot in three dimensions (WebGL).
import { Color, DirectionalLight, Fog, HemisphereLight, PCFShadowMap, Scene, WebGLRenderer } from 'three';
import type { Course, RobotShape } from '../state/messages.ts';
import { kEstimates, kUncertain, type EstimateName, type Store } from '../state/store.ts';
import { CameraRig } from './camera_rig.ts';
import { CourseModel } from './course_model.ts';
import { bounds, kDefaultShape } from './geometry.ts';
import { colour } from './palette.ts';
import { Moved, Pace, type CameraMode, type View } from './view.ts';
import { dispose, Ribbon } from './solid.ts';
import { GhostModel, RobotModel, UncertaintyRing } from './robot_model.ts';

const kHistoryWidth_m = 0.007;
const kHistoryLift_m: Record<EstimateName, number> = { model: 0.002, odometry: 0.0025, fused: 0.003, truth: 0.0035 };
const kMaxPixelRatio = 2;

export class SceneView implements View {
  readonly element: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly rig: CameraRig;
  private readonly sun = new DirectionalLight('#ffffff', 2.2);
  private readonly course = new CourseModel();
  private readonly ribbons: Record<EstimateName, Ribbon>;
  private ghosts: Record<EstimateName, GhostModel>;
  private robot: RobotModel;
  private readonly rings = kUncertain.map((name) => ({ name, ring: new UncertaintyRing(colour(name)) }));
  private shape: RobotShape = kDefaultShape;
  private readonly pace = new Pace();
  private lag_s = 0;
  private readonly moved = new Moved();
  private changed = true;

  /** Throws without WebGL. `taken`: the user moved the camera; `lost`: the WebGL context was lost. */
  constructor(taken: () => void, lost: () => void) {
    this.renderer = new WebGLRenderer({ antialias: true, powerPreference: 'low-power' });
    this.element = this.renderer.domElement;
    this.element.addEventListener('webglcontextlost', lost);
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene.background = new Color(colour('sky'));
    this.scene.fog = new Fog(colour('sky'), 3.5, 9);
    this.scene.add(new HemisphereLight('#bcd6f5', '#26303c', 1.4), this.sun, this.sun.target, this.course.group);
    for (const { ring } of this.rings) this.scene.add(ring.line);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.002;
    this.rig = new CameraRig(this.element, taken);
    this.ribbons = record((name) => new Ribbon(4000, colour(name), kHistoryWidth_m, kHistoryLift_m[name]));
    for (const name of kEstimates) this.scene.add(this.ribbons[name].mesh);
    this.robot = new RobotModel(this.shape);
    this.ghosts = this.makeGhosts();
    this.scene.add(this.robot.group);
    this.setCourse(undefined);
  }

  setCourse(course: Course | undefined): void {
    this.course.set(course);
    const box = bounds(course);
    this.rig.frame(box);
    const x = (box.min_x + box.max_x) / 2;
    const y = (box.min_y + box.max_y) / 2;
    const half = Math.hypot(box.max_x - box.min_x, box.max_y - box.min_y) / 2 + 0.2;
    this.sun.target.position.set(x, y, 0);
    this.sun.position.set(x - 0.6 * half, y - 0.35 * half, 1.4 * half);
    const camera = this.sun.shadow.camera;
    [camera.left, camera.right, camera.bottom, camera.top] = [-half, half, -half, half];
    [camera.near, camera.far] = [0.1, 4 * half];
    camera.updateProjectionMatrix();
    if (course !== undefined && JSON.stringify(course.robot) !== JSON.stringify(this.shape)) {
      this.shape = course.robot;
      for (const old of [this.robot, ...Object.values(this.ghosts)]) {
        this.scene.remove(old.group);
        dispose(old.group);
      }
      this.robot = new RobotModel(this.shape);
      this.scene.add(this.robot.group);
      this.ghosts = this.makeGhosts();
    }
    this.moved.reset();
    this.changed = true;
  }

  setCamera(mode: CameraMode | 'map'): void {
    if (mode !== 'map') this.rig.set(mode);
    this.changed = true;
  }

  draw(store: Store, hidden: ReadonlySet<EstimateName>, dt_s: number): void {
    const now_ms = performance.now();
    this.lag_s += dt_s;
    if (!this.pace.tick(now_ms)) return;
    this.degrade();
    for (const name of kEstimates) {
      const ribbon = this.ribbons[name];
      if (ribbon.follow(store.path_histories[name])) this.changed = true;
      ribbon.mesh.visible = !hidden.has(name);
    }
    const estimate = store.get('/estimate');
    if (this.moved.check(store)) {
      this.changed = true;
      this.robot.group.visible = estimate !== undefined;
      if (estimate !== undefined) this.robot.set(estimate[estimate.steering], store.leftTrack_m, store.rightTrack_m);
      for (const { name, ring } of this.rings) {
        if (estimate !== undefined && !hidden.has(name)) ring.set(estimate[name]);
        else ring.line.visible = false;
      }
      for (const name of kEstimates) {
        const pose = estimate?.[name];
        const ghost = this.ghosts[name];
        ghost.group.visible = !!pose && name !== estimate.steering && !hidden.has(name);
        if (pose) ghost.set(pose);
      }
    }
    const turned = this.rig.update(store.pose, this.lag_s);
    this.lag_s = 0;
    if (!turned && !this.changed) return;
    this.changed = false;
    this.renderer.render(this.scene, this.rig.camera);
    this.pace.drawn(now_ms);
    const { position, rotation } = this.robot.group;
    if (estimate !== undefined) this.element.dataset.robot = [position.x, position.y, position.z, rotation.z].join(' ');
  }

  reset(): void {
    this.moved.reset();
    for (const name of kEstimates) this.ribbons[name].reset();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.element.parentElement ?? this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setPixelRatio(this.pace.coarse ? 0.6 : Math.min(window.devicePixelRatio, kMaxPixelRatio));
    this.renderer.setSize(clientWidth, clientHeight);
    this.rig.resize(clientWidth / clientHeight);
    // At once, because its canvas is empty now.
    this.renderer.render(this.scene, this.rig.camera);
    this.changed = true;
  }

  dispose(): void {
    dispose(this.scene);
    this.renderer.dispose();
    this.element.remove();
  }

  private degrade(): void {
    if (!this.pace.coarse || !this.sun.castShadow) return;
    this.sun.castShadow = false;
    this.resize();
  }

  private makeGhosts(): Record<EstimateName, GhostModel> {
    return record((name) => {
      const ghost = new GhostModel(this.shape, colour(name));
      ghost.group.visible = false;
      this.scene.add(ghost.group);
      return ghost;
    });
  }
}

function record<T>(make: (name: EstimateName) => T): Record<EstimateName, T> {
  return { model: make('model'), odometry: make('odometry'), fused: make('fused'), truth: make('truth') };
}
