// The shapes of the course that the page draws.
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { CourseText } from '../../../daemon/web/draw/course_text.ts';
import { draftCourse } from '../../../daemon/web/draw/draft.ts';
import * as geometry from '../../../daemon/web/scene/geometry.ts';
import type { RobotShape } from '../../../daemon/web/state/messages.ts';

/** 1.4 m ahead, a half circle of 0.4 m to the right, and back over a block of 37 mm and a ramp of 80 mm. */
const text = readFileSync(new URL('../../../config/courses/3.toml', import.meta.url), 'utf8');
const course3 = draftCourse(new CourseText(text), '3', {} as RobotShape);

it('the ground follows ramp and step of course 3, and the path lies on it without leaps', () => {
  const [ramp = { down_rad: NaN } as never] = course3.ramps;
  const half = geometry.rampLength(ramp) / 2;
  const places: [x: number, y: number, height: number][] = [[0.7, -0.8, 0.08], [1.2, -0.8, 0.037], [1.2, -0.59, 0], [0, 0, 0], [0.7 + half - 0.01, -0.8, 0.01 * Math.tan(ramp.down_rad)]];
  for (const [x, y, height] of places) expect(geometry.groundHeight(course3, x, y), `${x}, ${y}`).toBeCloseTo(height, 6);
  const points = geometry.drape(course3, 0.005);
  let highest = 0;
  for (let i = 3; i < points.length; i += 3) {
    const step = Math.hypot((points[i] ?? 0) - (points[i - 3] ?? 0), (points[i + 1] ?? 0) - (points[i - 2] ?? 0));
    expect(step).toBeLessThanOrEqual(0.0051);
    highest = Math.max(highest, points[i + 2] ?? 0);
  }
  expect(highest).toBeCloseTo(0.08, 3);
});

it('the bounds cover fence, path and obstacles, and something without a course', () => {
  expect(geometry.bounds(course3)).toMatchObject({ min_x: -0.05, max_x: 1.85, max_y: 0.1 });
  expect(geometry.bounds(course3).min_y).toBeCloseTo(-1);
  const none = geometry.bounds(undefined);
  expect(none.max_x).toBeGreaterThan(none.min_x);
});

it('a footprint turns with the heading', () => {
  const corners = geometry.footprint({ x_m: 1, y_m: 2, heading_rad: Math.PI / 2 }, 4, 2);
  expect(corners.map(({ x, y }) => [x, y].map((value) => Math.round(value * 1e6) / 1e6 + 0))).toEqual([[2, 0], [2, 4], [0, 4], [0, 0]]);
});
