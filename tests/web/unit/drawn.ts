// What the daemon answers about a course file, as far as the editor needs it: an independent stand-in.
import type { CourseText } from '../../../daemon/web/draw/course_text.ts';
import type { Course, FloorPose, PathPoint, Segment } from '../../../daemon/web/state/messages.ts';

const kSpacing_m = 0.02;

export function drawn(text: CourseText): Course {
  const { x_m = 0, y_m = 0, yaw_deg = 0 } = text.one('start').values as Record<string, number>;
  let [x, y, yaw, s] = [x_m, y_m, (yaw_deg * Math.PI) / 180, 0];
  const pose = (): FloorPose => ({ x_m: x, y_m: y, yaw_rad: yaw });
  const path: PathPoint[] = [{ ...pose(), z_m: 0, s_m: 0 }];
  const segments = text.all('segment').map((segment): Segment => {
    const { length_m, radius_m = 0, angle_deg = 0 } = segment.values as Record<string, number>;
    const turn = (angle_deg * Math.PI) / 180;
    const length = length_m ?? radius_m * Math.abs(turn);
    const steps = Math.max(Math.ceil(length / kSpacing_m), 1);
    const [begin, from_m, half] = [pose(), s, turn / steps / 2];
    const chord = ((half === 0 ? 1 : Math.sin(half) / half) * length) / steps;
    for (let i = 0; i < steps; i++) {
      yaw += half;
      x += chord * Math.cos(yaw);
      y += chord * Math.sin(yaw);
      yaw += half;
      s += length / steps;
      path.push({ ...pose(), z_m: 0, s_m: s });
    }
    return { kind: String(segment.values.type), from_m, to_m: length === 0 ? from_m : s, begin, end: pose() };
  });
  return { path, segments } as unknown as Course;
}
