// Identification drives of a robot: the recorded runs that are such drives, their measurements by hand, and the results
// of the service `run_identify`.
import type { RunEntry } from './runs.ts';
import type { CourseEntry, SetupList } from './setup.ts';
import { kConfirm_ms } from './consent.ts';
import { onCourse, type State } from './messages.ts';
import type { Call } from './service.ts';

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

/** The gyro's bias comes from the standstill before the drive. */
const kBefore_ms = 2000;
const kAfter_ms = 1000;
const kLook_ms = 100;
/** Longest wait until a placed robot is ready to start. */
const kReady_ms = 10_000;
const kBegins_ms = 3000;

export interface Reach {
  call: Call;
  /** Sends a request that makes the robot move, with the person's consent. */
  move: Call;
  state(): State | undefined;
  /** The page's clock [ms]. */
  now(): number;
  sleep(ms: number): Promise<void>;
  say(text: string): void;
  /** Asks the person whether to drive: the time of the press, undefined if it was cancelled. Rejects when `attended` of drive() is aborted. */
  ask(text: string): Promise<number | undefined>;
}

const underWay = (state: State | undefined): boolean => onCourse(state?.run);

/** True if `holds` becomes true within the time. */
async function soon(reach: Reach, limit_ms: number, holds: (state: State | undefined) => boolean): Promise<boolean> {
  const end_ms = reach.now() + limit_ms;
  while (!holds(reach.state())) {
    if (reach.now() > end_ms) return false;
    await reach.sleep(kLook_ms);
  }
  return true;
}

/**
 * Drives the chosen course once the robot stands still and the person has pressed again. `attended` is aborted, with the
 * reason, when STOP is pressed or the person leaves the page: then nothing starts any more. Returns the recorded run,
 * empty if the person has cancelled; throws an Error with the reason if there is none.
 */
export async function drive(reach: Reach, course: string, attended: AbortSignal): Promise<string> {
  await reach.call('place', { at: 'start' });
  if (!(await soon(reach, kReady_ms, (state) => state?.can.start === true && state.course === course)))
    throw new Error(reach.state()?.why_not_start ?? 'the daemon is gone');
  attended.throwIfAborted();
  const { run } = (await reach.call('record_start', {})) as { run: string };
  let why = '';
  try {
    reach.say(`${course}: standing still \u2026`);
    await reach.sleep(kBefore_ms);
    attended.throwIfAborted();
    const pressed_ms = await reach.ask('It stands still: press again to drive.');
    if (pressed_ms === undefined) return '';
    if (reach.now() - pressed_ms > kConfirm_ms) throw new Error('The page was held up after the press: nothing was driven');
    await reach.move('start', { from: 'start' });
    reach.say(`${course}: driving \u2026`);
    await soon(reach, kBegins_ms, underWay);
    while (underWay(reach.state())) await reach.sleep(kLook_ms);
    const state = reach.state();
    if (state?.run !== 'finished') why = `${course} was not completed${cause(state)}`;
    await reach.sleep(kAfter_ms);
  } finally {
    await reach.call('record_stop', {});
  }
  if (why !== '') throw new Error(why);
  await reach.call('run_note', { run, name: course, tags: tagsOf(reach.state()?.robot ?? '') });
  return run;
}

function cause(state: State | undefined): string {
  const causes = (state?.faults ?? []).map((fault) => fault.cause);
  return causes.length === 0 ? '' : `: ${causes.join('; ')}`;
}
