// The shapes of the course that the page draws.
import { expect, it } from 'vitest';
import * as geometry from '../../../daemon/web/scene/geometry.ts';
import type { Course, Obstacle } from '../../../daemon/web/state/messages.ts';

/** A ramp of 80 mm on the way back, as the daemon gives it. */
const ramp: Obstacle = {
  kind: 'ramp', x_m: 0.7, y_m: -0.8, heading_rad: Math.PI, width_m: 0.4,
  profile: [[-0.5, 0], [-0.2, 0.08], [0.1, 0.08], [0.5, 0]].map(([along_m = 0, height_m = 0]) => ({ along_m, height_m })),
};
const point = (x_m: number, z_m: number, s_m: number): Course['path'][number] => ({ x_m, y_m: -0.8, z_m, yaw_rad: Math.PI, s_m });
const course = {
  path: [point(1.2, 0, 0), point(0.9, 0.08, 0.3), point(0, 0.08, 1.2)],
  obstacles: [ramp],
  fence: { corners: [[-0.05, -1], [1.85, -1], [1.85, 0.1], [-0.05, 0.1]].map(([x_m = 0, y_m = 0]) => ({ x_m, y_m })) },
} as unknown as Course;

it('the path lies on the ground without leaps', () => {
  const points = geometry.drape(course.path, 0.005);
  for (let i = 3; i < points.length; i += 3) {
    const step = Math.hypot((points[i] ?? 0) - (points[i - 3] ?? 0), (points[i + 1] ?? 0) - (points[i - 2] ?? 0));
    expect(step).toBeLessThanOrEqual(0.0051);
    const x = points[i] ?? 0;
    expect(points[i + 2]).toBeCloseTo(x < 0.9 ? 0.08 : (0.08 * (1.2 - x)) / 0.3, 5);
  }
});

it('an obstacle has a part between every two points of its profile, along its heading', () => {
  expect([geometry.lengthOf(ramp), geometry.heightOf(ramp)]).toEqual([1, 0.08]);
  const xs = geometry.partsOf(ramp).map((part) => [Math.max(...part.map(({ x }) => x)), Math.min(...part.map(({ x }) => x))]);
  for (const [i, [from, to]] of [[1.2, 0.9], [0.9, 0.6], [0.6, 0.2]].entries()) {
    expect(xs[i]?.[0]).toBeCloseTo(from ?? 0, 9);
    expect(xs[i]?.[1]).toBeCloseTo(to ?? 0, 9);
  }
});

it('the bounds cover fence, path and obstacles, and something without a course', () => {
  expect(geometry.bounds(course)).toMatchObject({ min_x: -0.05, max_x: 1.85, max_y: 0.1 });
  expect(geometry.bounds(course).min_y).toBeCloseTo(-1);
  const none = geometry.bounds(undefined);
  expect(none.max_x).toBeGreaterThan(none.min_x);
});

it('a footprint turns with the heading', () => {
  const corners = geometry.footprint({ x_m: 1, y_m: 2, heading_rad: Math.PI / 2 }, 4, 2);
  expect(corners.map(({ x, y }) => [x, y].map((value) => Math.round(value * 1e6) / 1e6 + 0))).toEqual([[2, 0], [2, 4], [0, 4], [0, 0]]);
});

it('a map is zoomed about its middle or a point, and stays within reason', () => {
  const box = { min_x: 0, max_x: 4, min_y: 0, max_y: 2 };
  expect(geometry.zoomed(box, 2)).toEqual({ min_x: -2, max_x: 6, min_y: -1, max_y: 3 });
  expect(geometry.zoomed(box, 0.5, { x: 1, y: 1 })).toEqual({ min_x: 0, max_x: 2, min_y: 0.5, max_y: 1.5 });
  for (const factor of [1e3, 1e-3]) expect(geometry.zoomed(box, factor)).toEqual(box);
});
