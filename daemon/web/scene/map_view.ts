// The course and the robot from above on a 2-D canvas: needs no WebGL.
import type { Course, EstimatedPose, Pose, RobotShape, State } from '../state/messages.ts';
import { kEstimates, kUncertain, type EstimateName, type Store } from '../state/store.ts';
import { bounds, cornersOf, footprint, kDefaultShape, onStadium, partsOf, stadiumLength, type Bounds, type Point2 } from './geometry.ts';
import { Moved, type View } from './view.ts';
import { colour } from './palette.ts';

const kMargin_m = 0.12;
const kCleat_m = 0.02;
/** A course that ends so near to its start ends there. */
const kSamePlace_m = 0.05;
/** Lengths that the map's measure has, and how long it is at most. */
const kLengths_m = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50];
const kMeasure_px = 140;

/** World to image: x to the right, y up. */
export interface Projection {
  scale: number;
  left: number;
  top: number;
}

/** The largest projection of a box that fits a canvas. */
export function fit(box: Bounds, width: number, height: number): Projection {
  const across = box.max_x - box.min_x + 2 * kMargin_m;
  const up = box.max_y - box.min_y + 2 * kMargin_m;
  const scale = Math.min(width / across, height / up);
  return {
    scale,
    left: width / 2 - (scale * (box.min_x + box.max_x)) / 2,
    top: height / 2 + (scale * (box.min_y + box.max_y)) / 2,
  };
}

export class MapView implements View {
  readonly element = document.createElement('canvas');
  private readonly ground = document.createElement('canvas');
  private course: Course | undefined;
  private frame: Bounds | undefined;
  private projection: Projection = { scale: 100, left: 0, top: 0 };
  private ratio = 1;
  private readonly moved = new Moved();

  setCourse(course: Course | undefined, frame?: Bounds): void {
    this.course = course;
    this.frame = frame;
    this.paintGround();
  }

  setCamera(): void {
    this.moved.reset();
  }

  resize(): void {
    const { clientWidth, clientHeight } = this.element.parentElement ?? this.element;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.ratio = Math.min(window.devicePixelRatio, 2);
    this.element.width = this.ground.width = Math.round(clientWidth * this.ratio);
    this.element.height = this.ground.height = Math.round(clientHeight * this.ratio);
    this.paintGround();
  }

  draw(store: Store, hidden: ReadonlySet<EstimateName>): void {
    const estimate = store.get('/estimate');
    const context = this.element.getContext('2d');
    if (context === null || !this.moved.check(store)) return;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.ground, 0, 0);
    for (const name of kEstimates) {
      if (hidden.has(name)) continue;
      const points = store.path_histories[name].coordinates;
      context.strokeStyle = colour(name);
      context.lineWidth = 2 * this.ratio;
      context.lineJoin = 'round';
      context.beginPath();
      for (let i = 0; i < points.length; i += 3) {
        const at = this.pixel(points[i] ?? 0, points[i + 1] ?? 0);
        context.lineTo(at.x, at.y);
      }
      context.stroke();
    }
    if (estimate === undefined) return;
    for (const name of kEstimates) {
      const pose = estimate[name];
      if (!pose || name === estimate.steering || hidden.has(name)) continue;
      this.polygon(context, footprint(place(pose), this.shape.length_m, this.shape.width_m));
      context.strokeStyle = colour(name);
      context.lineWidth = 1.5 * this.ratio;
      context.stroke();
    }
    for (const name of kUncertain) if (!hidden.has(name)) this.uncertainty(context, name, estimate[name]);
    this.starts(context, store.get('/state')?.continue_from);
    const pose = estimate[estimate.steering];
    this.robot(context, pose, store.leftTrack_m, store.rightTrack_m);
    this.element.dataset.robot = [pose.x_m, pose.y_m, pose.z_m, pose.yaw_rad].join(' ');
  }

  reset(): void {
    this.moved.reset();
  }

  dispose(): void {
    this.element.remove();
  }

  /** World coordinates of a point of the element, in its own pixels. */
  world(at: Point2): Point2 {
    const { scale, left, top } = this.projection;
    return { x: (at.x * this.ratio - left) / scale, y: (top - at.y * this.ratio) / scale };
  }

  /** The point of the element, in its own pixels, of a place of the floor. */
  point(at: Point2): Point2 {
    const { x, y } = this.pixel(at.x, at.y);
    return { x: x / this.ratio, y: y / this.ratio };
  }

  private get shape(): RobotShape {
    return this.course?.robot ?? kDefaultShape;
  }

  private pixel(x: number, y: number): Point2 {
    const { scale, left, top } = this.projection;
    return { x: left + scale * x, y: top - scale * y };
  }

  private polygon(context: CanvasRenderingContext2D, corners: readonly Point2[]): void {
    context.beginPath();
    for (const { x, y } of corners) {
      const at = this.pixel(x, y);
      context.lineTo(at.x, at.y);
    }
    context.closePath();
  }

  /** Two standard deviations of an estimated position along x and along y; their correlation is not shown. */
  private uncertainty(context: CanvasRenderingContext2D, name: EstimateName, { x_m, y_m, sd_x_m, sd_y_m }: EstimatedPose): void {
    if (typeof sd_x_m !== 'number' || typeof sd_y_m !== 'number') return;
    const at = this.pixel(x_m, y_m);
    context.beginPath();
    context.ellipse(at.x, at.y, 2 * sd_x_m * this.projection.scale, 2 * sd_y_m * this.projection.scale, 0, 0, 2 * Math.PI);
    context.strokeStyle = colour(name);
    context.lineWidth = this.ratio;
    context.stroke();
    this.element.dataset[`${name}Uncertainty`] = [2 * sd_x_m, 2 * sd_y_m].join(' ');
  }

  private robot(context: CanvasRenderingContext2D, pose: Pose, left_m: number, right_m: number): void {
    const { axle_spacing_m: spacing, wheel_radius_m: radius, gauge_m: gauge, shoe_width_m: width } = this.shape;
    const at = this.pixel(pose.x_m, pose.y_m);
    context.save();
    context.translate(at.x, at.y);
    context.scale(this.projection.scale, -this.projection.scale);
    context.rotate(pose.yaw_rad);
    const length = spacing + 2 * radius;
    context.fillStyle = '#c9d1da';
    context.fillRect(-0.42 * length, -(gauge - width) / 2, 0.84 * length, gauge - width);
    context.fillStyle = '#fff3c4';
    context.fillRect(0.42 * length - 0.008, -0.03, 0.008, 0.06);
    const around = stadiumLength(spacing, radius);
    const count = Math.round(around / kCleat_m);
    for (const [side, travelled_m] of [[1, left_m], [-1, right_m]] as const) {
      const y = (side * gauge) / 2 - width / 2;
      context.fillStyle = '#05080b';
      context.fillRect(-length / 2, y, length, width);
      context.fillStyle = '#5b6672';
      for (let i = 0; i < count; i++) {
        const cleat = onStadium(spacing, radius, (i * around) / count - travelled_m);
        if (cleat.y > radius) context.fillRect(cleat.x - 0.003, y, 0.006, width);
      }
    }
    context.restore();
  }

  /** While Start asks where the robot stands: the robot at the start, and where it would continue on the path. */
  private starts(context: CanvasRenderingContext2D, asked: State['continue_from']): void {
    const course = this.course;
    if (asked === undefined || course === undefined) return;
    const { x_m, y_m, yaw_rad } = course.start;
    context.setLineDash([4 * this.ratio, 3 * this.ratio]);
    context.strokeStyle = colour('path');
    context.lineWidth = 1.5 * this.ratio;
    this.polygon(context, footprint({ x_m, y_m, heading_rad: yaw_rad }, this.shape.length_m, this.shape.width_m));
    context.stroke();
    const onward = course.path.find(({ s_m }) => s_m >= asked.progress_m);
    if (asked.why_not_here === '' && onward !== undefined) {
      const [from, to] = [this.pixel(asked.x_m, asked.y_m), this.pixel(onward.x_m, onward.y_m)];
      context.beginPath();
      context.moveTo(from.x, from.y);
      context.lineTo(to.x, to.y);
      context.stroke();
      this.end(context, onward, 'path', 'continues here');
    }
    context.setLineDash([]);
    const at = this.pixel(x_m, y_m);
    this.write(context, 'put back here?', at.x - 8 * this.ratio, at.y - 14 * this.ratio);
  }

  private paintGround(): void {
    const context = this.ground.getContext('2d');
    if (context === null) return;
    const { width, height } = this.ground;
    this.projection = fit(this.frame ?? bounds(this.course), width, height);
    this.moved.reset();
    context.fillStyle = colour('floor');
    context.fillRect(0, 0, width, height);
    this.grid(context);
    this.measure(context);
    const course = this.course;
    if (course === undefined) return;
    for (const surface of course.surfaces) {
      this.polygon(context, footprint(surface, surface.length_m, surface.width_m));
      context.fillStyle = colour('surface');
      context.fill();
    }
    context.strokeStyle = colour('obstacle-edge');
    context.lineWidth = this.ratio;
    for (const part of (course.obstacles ?? []).flatMap(partsOf)) {
      this.polygon(context, part);
      context.fillStyle = colour('obstacle');
      context.fill();
      context.stroke();
    }
    context.strokeStyle = colour('fence');
    for (const area of course.keep_out ?? []) {
      this.polygon(context, cornersOf(area));
      context.fillStyle = colour('keep-out');
      context.fill();
      context.stroke();
    }
    this.polygon(context, cornersOf(course.fence));
    context.lineWidth = 2 * this.ratio;
    context.stroke();
    context.setLineDash([6 * this.ratio, 5 * this.ratio]);
    context.strokeStyle = colour('path');
    context.lineWidth = 1.5 * this.ratio;
    context.beginPath();
    for (const point of course.path) {
      const at = this.pixel(point.x_m, point.y_m);
      context.lineTo(at.x, at.y);
    }
    context.stroke();
    context.setLineDash([]);
    this.ends(context, course);
  }

  /** Where the course begins and ends. */
  private ends(context: CanvasRenderingContext2D, course: Course): void {
    const last = course.path.at(-1);
    if (last === undefined) return;
    const closed = Math.hypot(last.x_m - course.start.x_m, last.y_m - course.start.y_m) < kSamePlace_m;
    this.end(context, course.start, 'fused', closed ? 'start, goal' : 'start');
    if (!closed) this.end(context, last, 'path', 'goal');
  }

  private end(context: CanvasRenderingContext2D, { x_m, y_m }: { x_m: number; y_m: number }, name: 'fused' | 'path', text: string): void {
    const { x, y } = this.pixel(x_m, y_m);
    context.fillStyle = colour(name);
    context.beginPath();
    context.arc(x, y, 5 * this.ratio, 0, 2 * Math.PI);
    context.fill();
    this.write(context, text, x - 8 * this.ratio, y + 18 * this.ratio);
  }

  private write(context: CanvasRenderingContext2D, text: string, x: number, y: number): void {
    context.font = `${11 * this.ratio}px B612, sans-serif`;
    context.fillStyle = colour('dim');
    context.fillText(text, x, y);
  }

  /** How long a length is, and which way x and y point. */
  private measure(context: CanvasRenderingContext2D): void {
    const px = this.ratio;
    const length_m = kLengths_m.filter((each) => each * this.projection.scale < kMeasure_px * px).at(-1) ?? 0.1;
    const [x, y, length] = [14 * px, this.ground.height - 14 * px, length_m * this.projection.scale];
    context.strokeStyle = colour('dim');
    context.lineWidth = 1.5 * px;
    context.beginPath();
    for (const at of [x, x + length]) {
      context.moveTo(at, y - 4 * px);
      context.lineTo(at, y + 4 * px);
    }
    context.moveTo(x, y);
    context.lineTo(x + length, y);
    // The axes.
    context.moveTo(x, y - 50 * px);
    context.lineTo(x, y - 22 * px);
    context.lineTo(x + 28 * px, y - 22 * px);
    context.stroke();
    this.write(context, `${length_m} m`, x + length + 8 * px, y + 4 * px);
    this.write(context, 'x', x + 32 * px, y - 18 * px);
    this.write(context, 'y', x - 3 * px, y - 55 * px);
  }

  private grid(context: CanvasRenderingContext2D): void {
    const { scale, left, top } = this.projection;
    const { width, height } = this.ground;
    const step = 0.1;
    context.lineWidth = 1;
    const line = (bold: boolean, x0: number, y0: number, x1: number, y1: number): void => {
      context.strokeStyle = bold ? colour('grid-bold') : colour('grid');
      context.beginPath();
      context.moveTo(Math.round(x0) + 0.5, Math.round(y0) + 0.5);
      context.lineTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
      context.stroke();
    };
    for (let i = Math.ceil(-left / scale / step); i * step * scale + left < width; i++) {
      line(i % 5 === 0, left + i * step * scale, 0, left + i * step * scale, height);
    }
    for (let i = Math.ceil((top - height) / scale / step); i * step * scale < top; i++) {
      line(i % 5 === 0, 0, top - i * step * scale, width, top - i * step * scale);
    }
  }
}

const place = (pose: Pose): { x_m: number; y_m: number; heading_rad: number } => ({
  x_m: pose.x_m,
  y_m: pose.y_m,
  heading_rad: pose.yaw_rad,
});
