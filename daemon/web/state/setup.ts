// The files among which an operator chooses: GET /api/setup.
import type { Course, FloorPose, Footprint } from './messages.ts';

export type From = 'given' | 'bundled' | 'own';

/** Fields of the course are missing if its file cannot be read; `why_not` says why. */
export interface CourseEntry {
  name: string;
  from: From;
  in_force: boolean;
  why_not: string;
  description?: string;
  identifies?: boolean;
  length_m?: number;
  duration_s?: number;
  disturbances?: number;
  start?: FloorPose;
  /** The bounds of its polygon. */
  fence?: { min_x_m: number; max_x_m: number; min_y_m: number; max_y_m: number };
  outline?: { x_m: number; y_m: number }[];
  obstacles?: (Footprint & { kind: string })[];
  surfaces?: Footprint[];
}

export interface RobotEntry {
  name: string;
  from: From;
  in_force: boolean;
  why_not: string;
  description?: string;
}

export interface SetupList {
  course: string;
  robot: string;
  setup: string;
  setups: string[];
  may_save: boolean;
  /** The courses that calibrate the robot in force, in driving order. */
  calibration: string[];
  courses: CourseEntry[];
  robots: RobotEntry[];
}

/** The result of checking the text of a course file: valid if `error` is empty. */
export interface CourseCheck {
  error: string;
  line?: number;
  column?: number;
  /** Why it does not fit the robot or the set-up in force; empty: it fits. */
  why_not: string;
  length_m?: number;
  duration_s?: number;
  /** Missing if pieces of the file cannot be read. */
  course?: Course;
}

export type FileKind = 'course' | 'robot';

/** Limit of a text: one message to the daemon may have 64 KiB including everything around it. */
export const kMaxText = 60_000;

/** The kind of a file, by the tables that only one of the kinds has. */
export function kindOf(text: string): FileKind {
  const robot = /^\s*\[(model|shape|drive|emulated)\b/m.test(text);
  return robot && !/^\s*\[\[segment\]\]/m.test(text) ? 'robot' : 'course';
}

/** A name that the daemon accepts, made from that of a file. */
export function nameOf(file: string): string {
  return file
    .replace(/\.toml$/i, '')
    .replace(/[^A-Za-z0-9._-]+/g, '-')
    .replace(/^[.-]+/, '')
    .slice(0, 64);
}

/** For example "4.06 m, 42 s, 1 ramp, 1 block, 2 disturbances". */
export function facts(course: CourseEntry): string {
  const many = (count: number | undefined, one: string): string[] =>
    count === undefined || count === 0 ? [] : [`${count} ${one}${count === 1 ? '' : 's'}`];
  const kinds = (course.obstacles ?? []).map(({ kind }) => kind);
  if (course.length_m === undefined) return '';
  return [
    `${course.length_m.toFixed(2)} m`,
    ...(course.duration_s === undefined ? [] : [`${course.duration_s.toFixed(0)} s`]),
    ...[...new Set(kinds)].flatMap((kind) => many(kinds.filter((each) => each === kind).length, kind)),
    ...many(course.surfaces?.length, 'surface'),
    ...many(course.disturbances, 'disturbance'),
  ].join(' \u00b7 ');
}
