// The path of a draft, as the daemon draws it: its points, and the values with which a segment ends at a given point.
import type { Point2 } from '../scene/geometry.ts';
import type { FloorPose, PathPoint } from '../state/messages.ts';
import type { Value } from './course_text.ts';

export const kRad = Math.PI / 180;

/** Words for the types of segments that can be drawn. */
export const kSegmentTools = { line: 'Line', arc: 'Arc', pivot: 'Turn' };

/** By type of segment: the values with which one that begins at `from` ends at a point, or nearest to it. */
export const kEnds: Partial<Record<string, (from: FloorPose, to: Point2) => Record<string, Value>>> = {
  line: (from, to) => ({ length_m: Math.max(seen(from, to).ahead, 0.01) }),
  arc: (from, to) => {
    const { ahead, left } = seen(from, to);
    const far = Math.hypot(ahead, left);
    const radius_m = Math.min((far * far) / Math.max(2 * Math.abs(left), 1e-6), 100);
    const angle_deg = (2 * Math.atan2(Math.abs(left), ahead)) / kRad;
    return { radius_m: Math.max(radius_m, 0.01), angle_deg: (left < 0 ? -1 : 1) * Math.max(angle_deg, 0.1) };
  },
  pivot: (from, to) => {
    const { ahead, left } = seen(from, to);
    return { angle_deg: (left < 0 ? -1 : 1) * Math.max(Math.abs(Math.atan2(left, ahead)) / kRad, 1) };
  },
};

/** A point as seen from a pose. */
function seen(from: FloorPose, to: Point2): { ahead: number; left: number } {
  const [dx, dy] = [to.x - from.x_m, to.y - from.y_m];
  const [cos, sin] = [Math.cos(from.yaw_rad), Math.sin(from.yaw_rad)];
  return { ahead: cos * dx + sin * dy, left: -sin * dx + cos * dy };
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
