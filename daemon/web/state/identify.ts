// Identification drives of a robot: the recorded runs that are such drives, their measurements by hand, and the results
// of the service `run_identify`.
import type { RunEntry } from './runs.ts';
import type { CourseEntry, SetupList } from './setup.ts';

/** Tag of a run that is an identification drive. Its name is that of the course, another tag that of the robot. */
const kTag = 'identify';

/**
 * What a person can measure of a drive: the straight distance from its start to its end, the angle it turned by, including
 * whole turns, left positive, and the slope of the board that it went straight up (negative: down). Columns of
 * `tp100d identify --measured`.
 */
const kMeasured = ['distance_m', 'turned_deg', 'slope_deg'] as const;

export type Measured = Partial<Record<(typeof kMeasured)[number], number>>;

/** Without a camera there are only the runs' errors against the measurements by hand. */
export interface Errors {
  rms_m?: number;
  max_m?: number;
  rms_rad?: number;
  /** Measured by hand minus predicted. */
  runs: { distance_off_m?: number; turned_off_rad?: number }[];
}

export interface FoundParameter {
  name: string;
  before: number;
  found: boolean;
  value?: number;
  /** Half-width of the 95 % interval. */
  half_interval?: number;
}

/** What a slope adds to the slip ratios of level ground. */
export interface AddedSlip {
  slope_deg: number;
  added_left: number;
  added_right: number;
}

export interface Found {
  robot: string;
  parameters: FoundParameter[];
  slopes: AddedSlip[];
  errors_before: Errors;
  errors_after: Errors;
  warnings: string[];
}

/** The answer of `run_identify`: `text` is the robot file. */
export interface Identified {
  found: Found;
  text: string;
}

/** The courses that calibrate the robot in force, in driving order, then the user's own. */
export function calibrationCourses(list: SetupList): CourseEntry[] {
  const named = list.calibration.flatMap((name) => list.courses.filter((course) => course.name === name));
  return [...named, ...list.courses.filter((course) => course.identifies === true && course.from !== 'bundled' && !named.includes(course))];
}

/** The space that the robot needs around its start: "1.7 m ahead, 0.2 m behind, 0.5 m to each side". */
export function space({ fence }: CourseEntry): string {
  if (fence === undefined) return '';
  const m = (value: number): string => `${Math.max(0, value).toFixed(1)} m`;
  const { min_x_m, max_x_m, min_y_m, max_y_m } = fence;
  return `${m(max_x_m)} ahead, ${m(-min_x_m)} behind, ${m(max_y_m)} to the left, ${m(-min_y_m)} to the right`;
}

export const tagsOf = (robot: string): string => `${kTag} ${robot}`;

/** The drives of a robot on a course, the oldest first. */
export function drivesOf(runs: readonly RunEntry[], course: string, robot: string): RunEntry[] {
  const drive = ({ name, tags, active }: RunEntry): boolean => {
    const words = tags.split(' ');
    return name === course && !active && words.includes(kTag) && words.includes(robot);
  };
  return runs.filter(drive).reverse();
}

/** The measurements as the note of a run holds them. */
export function noteOf(measured: Measured): string {
  return kMeasured.flatMap((name) => (measured[name] === undefined ? [] : [`${name} = ${measured[name]}`])).join('\n');
}

export function measuredIn(note: string): Measured {
  const measured: Measured = {};
  for (const name of kMeasured) {
    const text = new RegExp(`^${name} = (\\S+)$`, 'm').exec(note)?.[1];
    if (text !== undefined && Number.isFinite(Number(text))) measured[name] = Number(text);
  }
  return measured;
}

/** The runs' measurements in this order, in the format of `tp100d identify --measured`; empty if there are none. */
export function measuredTable(drives: readonly RunEntry[]): string {
  const rows = drives.flatMap(({ note }, i) => {
    const measured = measuredIn(note);
    return Object.keys(measured).length === 0 ? [] : [`${i + 1},${kMeasured.map((name) => measured[name] ?? '').join(',')}\n`];
  });
  return rows.length === 0 ? '' : `run,${kMeasured.join(',')}\n${rows.join('')}`;
}

/** Number of decimals that are meaningful with this interval, at most those of the file. */
export function decimals(half_interval: number | undefined): number {
  if (half_interval === undefined || !(half_interval > 0)) return 5;
  return Math.min(5, Math.max(0, 1 - Math.floor(Math.log10(half_interval))));
}

/** A name for the new file: the robot's own if it may be replaced. */
export function fileName(list: SetupList, robot: string): string {
  return list.robots.find(({ name }) => name === robot)?.from === 'own' ? robot : `${robot}-identified`.slice(0, 64);
}
