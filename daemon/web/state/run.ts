// What the state of a run says of the robot.
import type { Run } from './messages.ts';

/** A course is driven, or about to be. */
export const onCourse = (run: Run | undefined): boolean => run === 'arming' || run === 'running';

/** Somebody has asked for motion: on a course or by hand. */
export const asksForMotion = (run: Run | undefined): boolean => onCourse(run) || run === 'driving';
