// The part of the floor that the map shows while a course is drawn.
import { bounds, type Bounds } from '../scene/geometry.ts';
import type { Course } from '../state/messages.ts';

/** Margin around a course, and least size, so that there is room to draw. */
const kRoom_m = 0.2;
const kLeast_m = 1.2;
const kMaxSize_m = 200;

export function frameOf(course: Course): Bounds {
  const box = bounds(course);
  const wide = Math.max(0, kLeast_m - (box.max_x - box.min_x)) / 2 + kRoom_m;
  const high = Math.max(0, kLeast_m - (box.max_y - box.min_y)) / 2 + kRoom_m;
  return { min_x: box.min_x - wide, max_x: box.max_x + wide, min_y: box.min_y - high, max_y: box.max_y + high };
}

/** The box scaled about its middle; a larger factor shows more. */
export function zoomed(box: Bounds, factor: number): Bounds {
  const [x, y] = [(box.min_x + box.max_x) / 2, (box.min_y + box.max_y) / 2];
  const [wide, high] = [(factor * (box.max_x - box.min_x)) / 2, (factor * (box.max_y - box.min_y)) / 2];
  if (Math.max(wide, high) > kMaxSize_m / 2 || Math.min(wide, high) < kRoom_m) return box;
  return { min_x: x - wide, max_x: x + wide, min_y: y - high, max_y: y + high };
}
