// One identification drive: chooses the course, places the robot at its start, and records the run with the standstill
// before and after it. Time is the clock's: the timers of a page that is hidden ring once a second, or once a minute.
import { kConfirm_ms } from './consent.ts';
import { onCourse, type State } from './messages.ts';
import { tagsOf } from './identify.ts';
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
