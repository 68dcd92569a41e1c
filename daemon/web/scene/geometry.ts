// Geometry of shapes, without drawing: x forward, y left, z up, metres.
import type { Area, Course, Obstacle, PathPoint, Place, RobotShape } from '../state/messages.ts';

export interface Point2 {
  x: number;
  y: number;
}

export const kDefaultShape: RobotShape = {
  length_m: 0.185,
  width_m: 0.2,
  height_m: 0.06,
  gauge_m: 0.155,
  axle_spacing_m: 0.133,
  wheel_radius_m: 0.026,
  shoe_width_m: 0.045,
};

/** A track from the side: two half circles around the axles, standing on z = 0, counter-clockwise. */
export function stadium(spacing: number, radius: number, steps = 12): Point2[] {
  const half = (centre: number, from: number): Point2[] =>
    Array.from({ length: steps + 1 }, (_, i) => around(centre, radius, from + (Math.PI * i) / steps));
  return [...half(spacing / 2, -Math.PI / 2), ...half(-spacing / 2, Math.PI / 2)];
}

/** Length of a track. */
export function stadiumLength(spacing: number, radius: number): number {
  return 2 * spacing + 2 * Math.PI * radius;
}

/** Point and outward direction on a track, `s` along it from the middle of its lower run, towards the front first. */
export function onStadium(spacing: number, radius: number, s: number): Point2 & { outward_rad: number } {
  const length = stadiumLength(spacing, radius);
  const half = Math.PI * radius;
  let rest = ((s % length) + length) % length;
  if (rest < spacing / 2) return { x: rest, y: 0, outward_rad: -Math.PI / 2 };
  rest -= spacing / 2;
  if (rest < half) return around(spacing / 2, radius, -Math.PI / 2 + rest / radius);
  rest -= half;
  if (rest < spacing) return { x: spacing / 2 - rest, y: 2 * radius, outward_rad: Math.PI / 2 };
  rest -= spacing;
  if (rest < half) return around(-spacing / 2, radius, Math.PI / 2 + rest / radius);
  return { x: -spacing / 2 + rest - half, y: 0, outward_rad: -Math.PI / 2 };
}

function around(centre: number, radius: number, angle: number): Point2 & { outward_rad: number } {
  return { x: centre + radius * Math.cos(angle), y: radius + radius * Math.sin(angle), outward_rad: angle };
}

/** Corners of a rectangle around a place, counter-clockwise. */
export function footprint(place: Place, length: number, width: number): Point2[] {
  const cos = Math.cos(place.heading_rad);
  const sin = Math.sin(place.heading_rad);
  return [
    [-1, -1],
    [1, -1],
    [1, 1],
    [-1, 1],
  ].map(([u = 0, v = 0]) => {
    const x = (u * length) / 2;
    const y = (v * width) / 2;
    return { x: place.x_m + cos * x - sin * y, y: place.y_m + sin * x + cos * y };
  });
}

export const lengthOf = ({ profile }: Obstacle): number => (profile.at(-1)?.along_m ?? 0) - (profile[0]?.along_m ?? 0);
/** Where it is farthest from the floor. */
export const heightOf = ({ profile }: Obstacle): number => profile.reduce((most, { height_m }) => (Math.abs(height_m) > Math.abs(most) ? height_m : most), 0);

/** The parts of an obstacle, each between two points of its profile, from above. */
export function partsOf(obstacle: Obstacle): Point2[][] {
  const { x_m, y_m, heading_rad, width_m, profile } = obstacle;
  return profile.slice(1).map(({ along_m: to }, i) => {
    const from = profile[i]?.along_m ?? to;
    const ahead = (from + to) / 2;
    return footprint({ x_m: x_m + ahead * Math.cos(heading_rad), y_m: y_m + ahead * Math.sin(heading_rad), heading_rad }, to - from, width_m);
  });
}

/** The path on the ground: x, y, z of points at most `spacing` apart. */
export function drape(path: readonly PathPoint[], spacing = 0.005): Float32Array {
  const points: number[] = [];
  path.forEach((point, i) => {
    const last = path[i - 1] ?? point;
    const steps = Math.max(1, Math.ceil(Math.hypot(point.x_m - last.x_m, point.y_m - last.y_m) / spacing));
    for (let k = 1; k <= steps; k++) {
      for (const key of ['x_m', 'y_m', 'z_m'] as const) points.push(last[key] + ((point[key] - last[key]) * k) / steps);
    }
  });
  return new Float32Array(points);
}

export interface Bounds {
  min_x: number;
  max_x: number;
  min_y: number;
  max_y: number;
}

/** The corners of a fence or a keep-out area; none without it. */
export const cornersOf = (area: Area | null | undefined): Point2[] => (area?.corners ?? []).map(({ x_m, y_m }) => ({ x: x_m, y: y_m }));

/** Bounds of a course: fence, path and obstacles; 2 m by 1.2 m without a course. */
export function bounds(course: Course | undefined): Bounds {
  const box: Bounds = { min_x: Infinity, max_x: -Infinity, min_y: Infinity, max_y: -Infinity };
  const cover = (x: number, y: number): void => {
    box.min_x = Math.min(box.min_x, x);
    box.max_x = Math.max(box.max_x, x);
    box.min_y = Math.min(box.min_y, y);
    box.max_y = Math.max(box.max_y, y);
  };
  for (const point of course?.path ?? []) cover(point.x_m, point.y_m);
  for (const { x, y } of (course?.obstacles ?? []).flatMap(partsOf).flat()) cover(x, y);
  for (const { x, y } of cornersOf(course?.fence)) cover(x, y);
  if (box.min_x > box.max_x) return { min_x: -1, max_x: 1, min_y: -0.6, max_y: 0.6 };
  return box;
}

/** Edges of a level ribbon of `width` along points (x, y, z each): two vertices per point, left and right. */
export function ribbon(points: Float32Array, from: number, to: number, width: number, lift: number, out: Float32Array): void {
  const total = points.length / 3;
  for (let i = from; i < to; i++) {
    const before = 3 * Math.max(i - 1, 0);
    const after = 3 * Math.min(i + 1, total - 1);
    const at = 3 * i;
    let dx = (points[after] ?? 0) - (points[before] ?? 0);
    let dy = (points[after + 1] ?? 0) - (points[before + 1] ?? 0);
    const length = Math.hypot(dx, dy) || 1;
    dx *= width / 2 / length;
    dy *= width / 2 / length;
    const x = points[at] ?? 0;
    const y = points[at + 1] ?? 0;
    const z = (points[at + 2] ?? 0) + lift;
    out.set([x - dy, y + dx, z, x + dy, y - dx, z], 6 * i);
  }
}

/** Margin around a course, and least size, so that there is room to draw. */
const kRoom_m = 0.2;
const kLeast_m = 1.2;
const kMaxSize_m = 200;

/** The part of the floor that a map shows while the course is drawn. */
export function frameOf(course: Course): Bounds {
  const box = bounds(course);
  const wide = Math.max(0, kLeast_m - (box.max_x - box.min_x)) / 2 + kRoom_m;
  const high = Math.max(0, kLeast_m - (box.max_y - box.min_y)) / 2 + kRoom_m;
  return { min_x: box.min_x - wide, max_x: box.max_x + wide, min_y: box.min_y - high, max_y: box.max_y + high };
}

/** The box scaled, its middle at a point or where it was; a larger factor shows more. */
export function zoomed(box: Bounds, factor: number, middle?: Point2): Bounds {
  const [x, y] = [middle?.x ?? (box.min_x + box.max_x) / 2, middle?.y ?? (box.min_y + box.max_y) / 2];
  const [wide, high] = [(factor * (box.max_x - box.min_x)) / 2, (factor * (box.max_y - box.min_y)) / 2];
  if (Math.max(wide, high) > kMaxSize_m / 2 || Math.min(wide, high) < kRoom_m) return box;
  return { min_x: x - wide, max_x: x + wide, min_y: y - high, max_y: y + high };
}
