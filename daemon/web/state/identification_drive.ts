// One identification drive: chooses the course, places the robot at its start, and records the run with the standstill
// before and after it.
import { onCourse, type State } from './messages.ts';
import { noteOf, tagsOf, type Measured } from './identify.ts';
import type { Call } from './service.ts';

/** The gyro's bias comes from the standstill before the drive. */
const kBefore_ms = 2000;
const kAfter_ms = 1000;
const kLook_ms = 100;
/** Longest wait until a placed robot is ready to start. */
const kReady_ms = 10_000;
const kBegins_ms = 3000;

export interface Reach {
  call: Call;
  state(): State | undefined;
  /** Number of STOPs so far; those of this page count as soon as they are pressed. */
  stops(): number;
  sleep(ms: number): Promise<void>;
  say(text: string): void;
}

const underWay = (state: State | undefined): boolean => onCourse(state?.run);

/** True if `holds` becomes true within the time. */
async function soon(reach: Reach, limit_ms: number, holds: (state: State | undefined) => boolean): Promise<boolean> {
  for (let left_ms = limit_ms; left_ms > 0; left_ms -= kLook_ms) {
    if (holds(reach.state())) return true;
    await reach.sleep(kLook_ms);
  }
  return holds(reach.state());
}

/** Chooses the course with the set-up `flat`. */
export async function prepare(reach: Reach, course: string): Promise<void> {
  await reach.call('choose', { course, setup: 'flat' });
}

/** Drives the chosen course. Returns the recorded run; throws an Error with the reason if there is none. */
export async function drive(reach: Reach, course: string): Promise<string> {
  const stops = reach.stops();
  await reach.call('place', { at: 'start' });
  if (!(await soon(reach, kReady_ms, (state) => state?.can.start === true && state.course === course)))
    throw new Error(reach.state()?.why_not_start ?? 'the daemon is gone');
  const { run } = (await reach.call('record_start', {})) as { run: string };
  let why = '';
  try {
    reach.say(`${course}: standing still \u2026`);
    await reach.sleep(kBefore_ms);
    // A start would clear the STOP.
    if (reach.stops() !== stops) throw new Error('STOP was pressed: nothing was driven');
    await reach.call('start', { from: 'start' });
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

export async function measure(reach: Reach, run: string, measured: Measured): Promise<void> {
  await reach.call('run_note', { run, note: noteOf(measured) });
}
