// Course 3 as the daemon publishes it on /course.
import type { Course, PathPoint } from '../../../daemon/web/state/messages.ts';

const path: PathPoint[] = [];
for (let i = 0; i <= 70; i++) path.push({ x_m: 0.02 * i, y_m: 0, yaw_rad: 0, s_m: 0.02 * i });
for (let i = 1; i <= 63; i++) {
  const angle = (Math.PI * i) / 63;
  path.push({ x_m: 1.4 + 0.4 * Math.sin(angle), y_m: -0.4 + 0.4 * Math.cos(angle), yaw_rad: -angle, s_m: 1.4 + 0.4 * angle });
}
for (let i = 1; i <= 70; i++) {
  path.push({ x_m: 1.4 - 0.02 * i, y_m: -0.8, yaw_rad: -Math.PI, s_m: 1.4 + 0.4 * Math.PI + 0.02 * i });
}

export const course3: Course = {
  name: '3',
  description: 'U turn, step and ramp',
  speed_mps: 0.1,
  length_m: 2.8 + 0.4 * Math.PI,
  start: { x_m: 0, y_m: 0, yaw_rad: 0 },
  path,
  ramps: [
    {
      x_m: 0.7,
      y_m: -0.8,
      heading_rad: Math.PI,
      height_m: 0.08,
      up_rad: (28 * Math.PI) / 180,
      top_m: 0.2,
      down_rad: (28 * Math.PI) / 180,
      width_m: 0.4,
    },
  ],
  blocks: [{ x_m: 1.2, y_m: -0.8, heading_rad: Math.PI, height_m: 0.037, depth_m: 0.1, width_m: 0.4 }],
  surfaces: [],
  disturbances: [],
  fence: { min_x_m: -0.05, max_x_m: 1.85, min_y_m: -0.9, max_y_m: 0.1 },
  robot: {
    name: 'end-loaded',
    length_m: 0.185,
    width_m: 0.2,
    height_m: 0.06,
    gauge_m: 0.155,
    axle_spacing_m: 0.133,
    wheel_radius_m: 0.026,
    shoe_width_m: 0.045,
  },
};
