import { describe, expect, it } from 'vitest';
import { drive, type Reach } from '../../../daemon/web/state/identification_drive.ts';
import { calibrationCourses, decimals, drivesOf, fileName, measuredIn, measuredTable, noteOf, space, tagsOf } from '../../../daemon/web/state/identify.ts';
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

  it('keep what was measured by hand in their notes', () => {
    for (const measured of [{}, { distance_m: 1.5 }, { turned_deg: -360.5 }, { distance_m: 0, turned_deg: 0 }, { distance_m: 0.5, slope_deg: -16 }]) expect(measuredIn(noteOf(measured))).toEqual(measured);
    expect(measuredIn('a wet floor\ndistance_m = 1.25\n')).toEqual({ distance_m: 1.25 });
    expect(measuredIn('distance_m = much')).toEqual({});
  });

  it('are a table of measurements by their number', () => {
    const drives = [entry('1', { note: 'distance_m = 1.5' }), entry('2'), entry('3', { note: noteOf({ distance_m: 0.5, turned_deg: 90, slope_deg: 20 }) })];
    expect(measuredTable(drives)).toBe('run,distance_m,turned_deg,slope_deg\n1,1.5,,\n3,0.5,90,20\n');
    expect(measuredTable([entry('1')])).toBe('');
  });

  it('are on the courses of the robot in driving order, then on those of the user', () => {
    const courses = [course('a'), course('b'), course('c'), course('mine', { from: 'own' }), course('race', { from: 'own', identifies: false })];
    expect(calibrationCourses(setup({ courses })).map(({ name }) => name)).toEqual(['b', 'a', 'mine']);
  });

  it('need the room of the fence', () => {
    expect(space(course('a', { fence: { min_x_m: -0.2, max_x_m: 1.7, min_y_m: -0.5, max_y_m: 0.5 } }))).toBe('1.7 m ahead, 0.2 m behind, 0.5 m to the left, 0.5 m to the right');
  });
});

describe('a new robot file', () => {
  it('replaces only one of the user', () => {
    const robots = [{ name: 'mine', from: 'own' as const, in_force: true, why_not: '' }, { name: 'worn', from: 'bundled' as const, in_force: false, why_not: '' }];
    expect(fileName(setup({ robots }), 'mine')).toBe('mine');
    expect(fileName(setup({ robots }), 'worn')).toBe('worn-identified');
  });

  it('is shown with the digits that its interval leaves', () => {
    expect(decimals(0.0009)).toBe(5);
    expect(decimals(0.01)).toBe(3);
    expect(decimals(2)).toBe(1);
    expect(decimals(undefined)).toBe(5);
  });
});

/** A daemon whose run goes through these states, one with each look at it. */
function daemon(run: Run[], stops: () => number = () => 0): { reach: Reach; calls: string[] } {
  const calls: string[] = [];
  let started = false;
  const state = (): State => ({ course: 'ahead', robot: 'mine', why_not_start: '', can: { start: true }, faults: [{ name: 'tilt', cause: 'it tilts', fix: '', from: 'daemon' }], run: started ? (run.length > 1 ? run.shift() : run[0]) : 'idle' }) as unknown as State;
  const call = (name: string, request: unknown): Promise<unknown> => {
    calls.push(`${name} ${JSON.stringify(request)}`);
    if (name === 'start') started = true;
    return Promise.resolve(name === 'record_start' ? { run: 'r1' } : {});
  };
  return { reach: { call, state, stops, sleep: () => Promise.resolve(), say: () => undefined }, calls };
}

describe('an identification drive', () => {
  it('records the run with its rest, and names it', async () => {
    const { reach, calls } = daemon(['arming', 'running', 'running', 'finished']);
    expect(await drive(reach, 'ahead')).toBe('r1');
    expect(calls).toEqual(['place {"at":"start"}', 'record_start {}', 'start {"from":"start"}', 'record_stop {}', 'run_note {"run":"r1","name":"ahead","tags":"identify mine"}']);
  });

  it('does not begin after a STOP, however shortly before', async () => {
    let looks = 0;
    const { reach, calls } = daemon(['arming', 'running', 'finished'], () => looks++);
    await expect(drive(reach, 'ahead')).rejects.toThrow('STOP was pressed');
    expect(calls).toEqual(['place {"at":"start"}', 'record_start {}', 'record_stop {}']);
  });

  it('that is not completed is no drive of the identification', async () => {
    const { reach, calls } = daemon(['arming', 'running', 'aborted']);
    await expect(drive(reach, 'ahead')).rejects.toThrow('ahead was not completed: it tilts');
    expect(calls.at(-1)).toBe('record_stop {}');
  });
});
