// The path of a draft: where its segments lie, and the values with which a segment ends at a given point.
import type { Point2 } from '../scene/geometry.ts';
import type { PathPoint } from '../state/messages.ts';
import type { Piece } from './course_text.ts';

export interface Frame extends Point2 {
  yaw_rad: number;
  /** Distance along the path. */
  s_m: number;
}

export const kRad = Math.PI / 180;
const kStep_m = 0.02;
const kStep_rad = 3 * kRad;

export function number(piece: Piece, key: string, otherwise = 0): number {
  const value = piece.values[key];
  return typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
}

export function startOf(start: Piece): Frame {
  return { x: number(start, 'x_m'), y: number(start, 'y_m'), yaw_rad: number(start, 'yaw_deg') * kRad, s_m: 0 };
}

/** Length and turn of a segment. */
function extent(segment: Piece): { length_m: number; angle_rad: number } {
  const angle_rad = number(segment, 'angle_deg') * kRad;
  if (segment.values.type === 'line') return { length_m: number(segment, 'length_m'), angle_rad: 0 };
  if (segment.values.type === 'arc') return { length_m: number(segment, 'radius_m') * Math.abs(angle_rad), angle_rad };
  return { length_m: 0, angle_rad };
}

/** The end of the share `part` of a segment that begins at `from`. */
export function along(from: Frame, segment: Piece, part = 1): Frame {
  const { length_m, angle_rad } = extent(segment);
  const [length, angle] = [part * length_m, part * angle_rad];
  const yaw_rad = from.yaw_rad + angle;
  const s_m = from.s_m + length;
  if (angle === 0 || length === 0) {
    return { x: from.x + length * Math.cos(from.yaw_rad), y: from.y + length * Math.sin(from.yaw_rad), yaw_rad, s_m };
  }
  const radius = length / angle;
  return {
    x: from.x + radius * (Math.sin(yaw_rad) - Math.sin(from.yaw_rad)),
    y: from.y - radius * (Math.cos(yaw_rad) - Math.cos(from.yaw_rad)),
    yaw_rad,
    s_m,
  };
}

/** The beginning of each segment, and the end of the last one. */
export function frames(start: Frame, segments: readonly Piece[]): Frame[] {
  const all = [start];
  for (const segment of segments) all.push(along(all.at(-1) ?? start, segment));
  return all;
}

export function points(start: Frame, segments: readonly Piece[]): PathPoint[] {
  const out = [pathPoint(start)];
  let from = start;
  for (const segment of segments) {
    const { length_m, angle_rad } = extent(segment);
    const steps = Math.min(Math.max(Math.ceil(length_m / kStep_m), Math.ceil(Math.abs(angle_rad) / kStep_rad), 1), 2000);
    for (let i = 1; i <= steps; i++) out.push(pathPoint(along(from, segment, i / steps)));
    from = along(from, segment);
  }
  return out;
}

function pathPoint({ x, y, yaw_rad, s_m }: Frame): PathPoint {
  return { x_m: x, y_m: y, yaw_rad, s_m };
}

/** Length of the line from `from` that ends nearest to a point; at least 1 cm. */
export function lineTo(from: Frame, to: Point2): number {
  const ahead = Math.cos(from.yaw_rad) * (to.x - from.x) + Math.sin(from.yaw_rad) * (to.y - from.y);
  return Math.max(ahead, 0.01);
}

/** The arc that begins at `from` along its heading and ends at a point. */
export function arcTo(from: Frame, to: Point2): { radius_m: number; angle_deg: number } {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const ahead = Math.cos(from.yaw_rad) * dx + Math.sin(from.yaw_rad) * dy;
  const left = -Math.sin(from.yaw_rad) * dx + Math.cos(from.yaw_rad) * dy;
  const far = Math.hypot(ahead, left);
  const side = left < 0 ? -1 : 1;
  const radius_m = Math.min((far * far) / Math.max(2 * Math.abs(left), 1e-6), 100);
  const angle_deg = (2 * Math.atan2(Math.abs(left), ahead)) / kRad;
  return { radius_m: Math.max(radius_m, 0.01), angle_deg: side * Math.max(angle_deg, 0.1) };
}

/** The point of a path that is nearest to a point of the floor. */
export function nearest(path: readonly PathPoint[], to: Point2): PathPoint | undefined {
  let best: PathPoint | undefined;
  let least = Infinity;
  for (const point of path) {
    const distance = Math.hypot(point.x_m - to.x, point.y_m - to.y);
    if (distance < least) [best, least] = [point, distance];
  }
  return best;
}

/** The point of the path at a distance along it. */
export function pointAt(path: readonly PathPoint[], s_m: number): PathPoint | undefined {
  return path.find((point) => point.s_m >= s_m - 1e-9) ?? path.at(-1);
}
