// How long a run will about still take.
import type { Course, State } from './messages.ts';

/** The default of control.pivot_rate_radps. */
const kPivot_radps = 0.6;
/** Before that, the robot's pace says little. */
const kPace_s = 3;

/** From `progress_m` to the end, as the course is meant to be driven. */
export function nominal_s(course: Course, progress_m: number): number {
  const turns = (course.segments ?? []).filter(({ kind, from_m }) => kind === 'pivot' && from_m > progress_m);
  const turned_rad = turns.reduce((sum, { angle_rad }) => sum + Math.abs(angle_rad), 0);
  return Math.max(course.length_m - progress_m, 0) / course.speed_mps + turned_rad / kPivot_radps;
}

/** Nominal, corrected by how long the way so far has taken; undefined: no run, or it pauses. */
export function timeLeft_s(state: State | undefined, course: Course | undefined): number | undefined {
  if (state?.run !== 'running' || course === undefined || !(course.length_m > 0) || !(course.speed_mps > 0)) return undefined;
  if ((state.pause_left_s ?? 0) > 0) return undefined;
  const left_s = nominal_s(course, state.progress_m ?? 0);
  const meant_s = nominal_s(course, 0) - left_s;
  const took_s = state.run_s ?? 0;
  const pace = meant_s < kPace_s ? 1 : Math.min(Math.max(took_s / meant_s, 0.7), 2);
  return left_s * pace;
}
