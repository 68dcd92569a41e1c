// The shapes of course and robot that the page draws.
import { expect, it } from 'vitest';
import * as geometry from '../../../daemon/web/scene/geometry.ts';
import type { Course } from '../../../daemon/web/state/messages.ts';

/** Course 3: 1.4 m ahead, a half circle of 0.4 m to the right, and back over a block of 37 mm and a ramp of 80 mm. */
const ramp = { x_m: 0.7, y_m: -0.8, heading_rad: Math.PI, height_m: 0.08, up_rad: (28 * Math.PI) / 180, top_m: 0.2, down_rad: (28 * Math.PI) / 180, width_m: 0.4 };
const block = { x_m: 1.2, y_m: -0.8, heading_rad: Math.PI, height_m: 0.037, depth_m: 0.1, width_m: 0.4 };
const path: Course['path'] = [];
for (let i = 0; i <= 70; i++) path.push({ x_m: 0.02 * i, y_m: 0, yaw_rad: 0, s_m: 0.02 * i });
for (let i = 1; i <= 63; i++) {
  const angle = (Math.PI * i) / 63;
  path.push({ x_m: 1.4 + 0.4 * Math.sin(angle), y_m: -0.4 + 0.4 * Math.cos(angle), yaw_rad: -angle, s_m: 1.4 + 0.4 * angle });
}
for (let i = 1; i <= 70; i++) path.push({ x_m: 1.4 - 0.02 * i, y_m: -0.8, yaw_rad: -Math.PI, s_m: 1.4 + 0.4 * Math.PI + 0.02 * i });
const course3 = { path, ramps: [ramp], blocks: [block], surfaces: [], fence: { min_x_m: -0.05, max_x_m: 1.85, min_y_m: -0.9, max_y_m: 0.1 } } as unknown as Course;

/** Volume of a closed body of triangles whose normals point outwards. */
function volume(triangles: Float32Array): number {
  let six = 0;
  for (let i = 0; i < triangles.length; i += 9) {
    const [ax = 0, ay = 0, az = 0, bx = 0, by = 0, bz = 0, cx = 0, cy = 0, cz = 0] = triangles.subarray(i, i + 9);
    six += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
  }
  return six / 6;
}

it('a prism is closed and faces outwards: its volume is area times width', () => {
  const up = 0.08 / Math.tan(ramp.up_rad);
  expect(volume(geometry.prism(geometry.rampProfile(ramp), 0.4))).toBeCloseTo((0.2 + up) * 0.08 * 0.4, 6);
  expect(volume(geometry.prism(geometry.blockProfile(block), 0.4))).toBeCloseTo(0.1 * 0.037 * 0.4, 7);
  const track = geometry.prism(geometry.stadium(0.133, 0.026, 64), 0.045);
  expect(volume(track)).toBeCloseTo((2 * 0.026 * 0.133 + Math.PI * 0.026 ** 2) * 0.045, 6);
});

it('a shoe goes around its track at even speed and comes back to where it began', () => {
  const [spacing, radius] = [0.133, 0.026];
  const length = geometry.stadiumLength(spacing, radius);
  const steps = 2000;
  let last = geometry.onStadium(spacing, radius, 0);
  for (let i = 1; i <= steps; i++) {
    const next = geometry.onStadium(spacing, radius, (i * length) / steps);
    expect(Math.hypot(next.x - last.x, next.y - last.y)).toBeCloseTo(length / steps, 5);
    last = next;
  }
  expect(last.x).toBeCloseTo(0, 6);
  expect(geometry.onStadium(spacing, radius, -0.01).x).toBeCloseTo(-0.01, 9);
});

it('the ground follows ramp and step of course 3, and the path lies on it without leaps', () => {
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

it('a ribbon has its edges half a width to the left and right of the way', () => {
  const out = new Float32Array(18);
  geometry.ribbon(new Float32Array([0, 0, 0, 1, 0, 0, 2, 0, 0]), 0, 3, 0.2, 0.01, out);
  expect([...out].map((value) => value.toFixed(3))).toEqual([0, 1, 2].flatMap((x) => [x, 0.1, 0.01, x, -0.1, 0.01].map((value) => value.toFixed(3))));
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
