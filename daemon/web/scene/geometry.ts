// Geometry of shapes, without drawing: x forward, y left, z up, metres.
import type { Area, Course, Place, Ramp } from '../state/messages.ts';

export interface Point2 {
  x: number;
  y: number;
}

/** Side view of a ramp along its own x axis, centred on its footprint, counter-clockwise from the near foot: x, z. */
export function rampProfile(ramp: Ramp): Point2[] {
  const up = ramp.height_m / Math.tan(ramp.up_rad);
  const down = ramp.height_m / Math.tan(ramp.down_rad);
  const half = (up + ramp.top_m + down) / 2;
  return [
    { x: -half, y: 0 },
    { x: half, y: 0 },
    { x: half - down, y: ramp.height_m },
    { x: -half + up, y: ramp.height_m },
  ];
}

/** All that rises from the floor: the ramps, and the blocks as ramps with upright sides. */
export function obstaclesOf(course: Course | undefined): Ramp[] {
  const upright = { up_rad: Math.PI / 2, down_rad: Math.PI / 2 };
  return [...(course?.ramps ?? []), ...(course?.blocks ?? []).map((block) => ({ ...block, ...upright, top_m: block.depth_m }))];
}

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

/** World coordinates in a piece's own frame. */
export function inside(place: Place, x: number, y: number): Point2 {
  const cos = Math.cos(place.heading_rad);
  const sin = Math.sin(place.heading_rad);
  const dx = x - place.x_m;
  const dy = y - place.y_m;
  return { x: cos * dx + sin * dy, y: -sin * dx + cos * dy };
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

export function rampLength(ramp: Ramp): number {
  return 2 * (rampProfile(ramp)[1]?.x ?? 0);
}

/** Corners of a ramp's level part. */
export function rampTop(ramp: Ramp): Point2[] {
  const ahead = (ramp.height_m / Math.tan(ramp.up_rad) - ramp.height_m / Math.tan(ramp.down_rad)) / 2;
  const x_m = ramp.x_m + ahead * Math.cos(ramp.heading_rad);
  const y_m = ramp.y_m + ahead * Math.sin(ramp.heading_rad);
  return footprint({ x_m, y_m, heading_rad: ramp.heading_rad }, ramp.top_m, ramp.width_m);
}

/** Height of the obstacles at a place of the floor. */
export function groundHeight(course: Course, x: number, y: number): number {
  let height = 0;
  for (const ramp of obstaclesOf(course)) {
    const at = inside(ramp, x, y);
    const half = rampLength(ramp) / 2;
    if (Math.abs(at.y) > ramp.width_m / 2 || Math.abs(at.x) >= half) continue;
    const rise = Math.min((at.x + half) * Math.tan(ramp.up_rad), (half - at.x) * Math.tan(ramp.down_rad));
    height = Math.max(height, Math.min(rise, ramp.height_m));
  }
  return height;
}

/** The path projected onto the ground: x, y, z of points at most `spacing` apart. */
export function drape(course: Course, spacing = 0.005): Float32Array {
  const points: number[] = [];
  course.path.forEach((point, i) => {
    const last = course.path[i - 1];
    const steps = last === undefined ? 1 : Math.ceil(Math.hypot(point.x_m - last.x_m, point.y_m - last.y_m) / spacing);
    for (let k = 1; k <= steps; k++) {
      const x = last === undefined ? point.x_m : last.x_m + ((point.x_m - last.x_m) * k) / steps;
      const y = last === undefined ? point.y_m : last.y_m + ((point.y_m - last.y_m) * k) / steps;
      points.push(x, y, groundHeight(course, x, y));
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
  for (const ramp of obstaclesOf(course)) for (const { x, y } of footprint(ramp, rampLength(ramp), ramp.width_m)) cover(x, y);
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
