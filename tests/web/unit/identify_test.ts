// The drives of an identification, and that none begins without the person's consent at its time.
import { describe, expect, it } from 'vitest';
import { calibrationCourses, decimals, drive, drivesOf, fileName, measuredIn, measuredTable, noteOf, space, tagsOf, type Reach } from '../../../daemon/web/state/identify.ts';
import type { Run, State } from '../../../daemon/web/state/messages.ts';
import type { RunEntry } from '../../../daemon/web/state/runs.ts';
import type { CourseEntry, SetupList } from '../../../daemon/web/state/setup.ts';

const entry = (run: string, more: Partial<RunEntry> = {}): RunEntry => ({
  run, name: 'ahead', note: '', tags: 'identify mine', keep: false, note_error: '', modified_unix_s: 0, bytes: 0, active: false, files: [], ...more,
});

const course = (name: string, more: Partial<CourseEntry> = {}): CourseEntry => ({ name, from: 'bundled', in_force: false, why_not: '', identifies: true, ...more });

const setup = (more: Partial<SetupList> = {}): SetupList => ({
  course: '', robot: 'mine', setup: 'flat', setups: [], may_save: true, calibration: ['b', 'a'], courses: [], robots: [], ...more,
});

describe('the drives of an identification', () => {
  it('are runs with the tags of the robot and the name of the course, the oldest first', () => {
    const runs = [entry('3'), entry('2', { tags: 'identify other' }), entry('1', { tags: 'wet identify mine' }), entry('0', { name: 'left' }), entry('4', { active: true }), entry('5', { tags: 'mine' })];
    expect(drivesOf(runs, 'ahead', 'mine').map(({ run }) => run)).toEqual(['1', '3']);
    expect(tagsOf('mine').split(' ')).toEqual(['identify', 'mine']);
  });

  it('keep what was measured by hand in their notes, and are a table of measurements by their number', () => {
    for (const measured of [{}, { distance_m: 1.5 }, { turned_deg: -360.5 }, { distance_m: 0.5, slope_deg: -16 }]) expect(measuredIn(noteOf(measured))).toEqual(measured);
    expect(measuredIn('a wet floor\ndistance_m = 1.25\nturned_deg = much')).toEqual({ distance_m: 1.25 });
    const drives = [entry('1', { note: 'distance_m = 1.5' }), entry('2'), entry('3', { note: noteOf({ distance_m: 0.5, turned_deg: 90, slope_deg: 20 }) })];
    expect(measuredTable(drives)).toBe('run,distance_m,turned_deg,slope_deg\n1,1.5,,\n3,0.5,90,20\n');
    expect(measuredTable([entry('1')])).toBe('');
  });

  it('are on the courses of the robot in driving order, then on those of the user, and need the room of the fence', () => {
    const fence = { min_x_m: -0.2, max_x_m: 1.7, min_y_m: -0.5, max_y_m: 0.6 };
    const courses = [course('a'), course('b'), course('c'), course('mine', { from: 'own', fence }), course('race', { from: 'own', identifies: false })];
    expect(calibrationCourses(setup({ courses })).map(({ name }) => name)).toEqual(['b', 'a', 'mine']);
    expect(space(course('a', { fence }))).toBe('1.7 m ahead, 0.2 m behind, 0.6 m to the left, 0.5 m to the right');
  });
});

it('a new robot file replaces only one of the user, and is shown with the digits that its interval leaves', () => {
  const robots = [{ name: 'mine', from: 'own' as const, in_force: true, why_not: '' }, { name: 'worn', from: 'bundled' as const, in_force: false, why_not: '' }];
  expect(['mine', 'worn'].map((robot) => fileName(setup({ robots }), robot))).toEqual(['mine', 'worn-identified']);
  expect([0.0009, 0.01, 2, undefined].map(decimals)).toEqual([5, 3, 1, 5]);
});

interface Script {
  /** The run's states after the start, one with each look at it. */
  run?: Run[];
  /** Until the robot that was placed is ready. */
  ready_ms?: number;
  /** Until the person presses after each question; undefined: cancels. */
  press_ms?: number;
  /** Timers ring at multiples of this time only, as those of a hidden page do at 1000. */
  timer_ms?: number;
  /** When STOP is pressed or the person leaves the page. */
  left_ms?: number;
}

/** A daemon, a page and a person. `times`: when what was called, in order. */
function scene({ run = ['arming', 'running', 'finished'], ready_ms = 0, press_ms, timer_ms = 1, left_ms = Infinity }: Script): { reach: Reach; attended: AbortSignal; calls: string[]; times: [string, number][] } {
  const calls: string[] = [];
  const times: [string, number][] = [];
  const attended = new AbortController();
  let now_ms = 0;
  let placed_ms = Infinity;
  let started = false;
  const pass = (to_ms: number): void => {
    now_ms = Math.max(now_ms, to_ms);
    if (now_ms >= left_ms) attended.abort(new Error('The page was left: nothing was driven'));
  };
  const state = (): State => ({
    course: 'ahead', robot: 'mine', why_not_start: 'the robot moves', can: { start: now_ms - placed_ms >= ready_ms }, run: started ? (run.length > 1 ? run.shift() : run[0]) : 'idle',
    faults: [{ name: 'tilt', cause: 'it tilts', fix: '', from: 'daemon' }],
  }) as unknown as State;
  const call = (name: string, request: unknown): Promise<unknown> => {
    calls.push(`${name} ${JSON.stringify(request)}`);
    times.push([name, now_ms]);
    if (name === 'place') placed_ms = now_ms;
    if (name === 'start') started = true;
    return Promise.resolve(name === 'record_start' ? { run: 'r1' } : {});
  };
  const reach: Reach = {
    call,
    move: (name, request) => call(name, { ...(request as object), stops: 0 }),
    state,
    now: () => now_ms,
    sleep: (ms) => {
      pass(Math.ceil((now_ms + ms) / timer_ms) * timer_ms);
      return Promise.resolve();
    },
    say: () => undefined,
    ask: () => {
      times.push(['asked', now_ms]);
      const before = attended.signal.aborted;
      pass(now_ms + (press_ms ?? 100));
      // An event that is over tells the question nothing.
      if (attended.signal.aborted && !before) return Promise.reject(attended.signal.reason as Error);
      if (press_ms !== undefined) times.push(['pressed', now_ms]);
      return Promise.resolve(press_ms === undefined ? undefined : now_ms);
    },
  };
  return { reach, attended: attended.signal, calls, times };
}

describe('an identification drive', () => {
  it('records the run with its rest, and names it', async () => {
    const { reach, attended, calls } = scene({ press_ms: 500 });
    expect(await drive(reach, 'ahead', attended)).toBe('r1');
    expect(calls).toEqual(['place {"at":"start"}', 'record_start {}', 'start {"from":"start","stops":0}', 'record_stop {}', 'run_note {"run":"r1","name":"ahead","tags":"identify mine"}']);
  });

  // Otherwise a robot would begin to move long after the press, when the person may stand beside it.
  it('starts by a press that comes after the standstill and at most 3 s before it, however slow timers, robot and person are', async () => {
    for (const timer_ms of [1, 100, 1000, 60_000]) {
      for (const ready_ms of [0, 1500, 9500, 12_000]) {
        for (const press_ms of [undefined, 0, 700, 30_000]) {
          for (const left_ms of [Infinity, 0, 1000, 2500, 11_000, 40_000]) {
            const { reach, attended, times } = scene({ timer_ms, ready_ms, left_ms, ...(press_ms === undefined ? {} : { press_ms }) });
            await drive(reach, 'ahead', attended).catch(() => '');
            const at = (name: string): number => times.find(([each]) => each === name)?.[1] ?? NaN;
            const what = JSON.stringify({ timer_ms, ready_ms, press_ms, left_ms, times });
            expect(at('record_start') > left_ms, what).toBe(false);
            if (Number.isNaN(at('start'))) {
              expect(press_ms === undefined || attended.aborted || Number.isNaN(at('record_start')), what).toBe(true);
              continue;
            }
            expect(at('start') - at('pressed'), what).toBeLessThanOrEqual(3000);
            expect(at('asked') - at('record_start'), what).toBeGreaterThanOrEqual(2000);
            expect(at('start'), what).toBeLessThan(left_ms);
          }
        }
      }
    }
  });

  // Otherwise a page that hung after the press would start the robot when it wakes up.
  it('does not start by a press that came too long ago', async () => {
    const { reach, attended, calls } = scene({});
    reach.ask = () => Promise.resolve(reach.now() - 3001);
    await expect(drive(reach, 'ahead', attended)).rejects.toThrow('held up');
    expect(calls).toEqual(['place {"at":"start"}', 'record_start {}', 'record_stop {}']);
  });

  it('that is not completed is no drive of the identification', async () => {
    const { reach, attended, calls } = scene({ run: ['arming', 'running', 'aborted'], press_ms: 500 });
    await expect(drive(reach, 'ahead', attended)).rejects.toThrow('ahead was not completed: it tilts');
    expect(calls.at(-1)).toBe('record_stop {}');
  });
});
