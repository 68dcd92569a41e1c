// The list of runs: searched, sorted, saved as a table.
import { expect, it } from 'vitest';
import { arranged, runsTable, type RunEntry, type RunResult } from '../../../daemon/web/state/runs.ts';

const entry = (run: string, result?: Partial<RunResult>, others: Partial<RunEntry> = {}): RunEntry => ({
  run, name: '', note: '', tags: '', keep: false, note_error: '', modified_unix_s: Number(run.slice(0, 3)), bytes: 1, active: false, files: [],
  ...(result === undefined ? {} : { result: { outcome: 'completed', cause: '', course: '3', robot: 'lab', duration_s: 1, distance_m: 1, largest_m: 0.001, by_hand: false, ...result } }),
  ...others,
});
const runs = [
  entry('100-3', { duration_s: 9, largest_m: 0.02 }),
  entry('101-3', { outcome: 'aborted', cause: 'lost, "a wheel"', largest_m: 0.3 }),
  entry('102-old'),
  entry('103-3', { outcome: 'ended', by_hand: true, duration_s: 5 }, { note: 'wet\nfloor', tags: 'lab' }),
];
const order = (...by: Parameters<typeof arranged> extends [unknown, ...infer R] ? R : never): string[] => arranged(runs, ...by).map(({ run }) => run);

it('runs are sorted by any column, both ways, and what is not known comes last', () => {
  expect(order('', 'recorded', true)).toEqual(['103-3', '102-old', '101-3', '100-3']);
  expect(order('', 'error', true)).toEqual(['101-3', '100-3', '102-old', '103-3']);
  expect(order('', 'duration', false)).toEqual(['101-3', '103-3', '100-3', '102-old']);
  expect(order('', 'outcome', false)[0]).toBe('102-old');
});

it('a run is found by its outcome, course, robot, note and tags', () => {
  expect(order('by hand', 'recorded', true)).toEqual(['103-3']);
  expect(order('wet lab', 'recorded', true)).toEqual(['103-3']);
  expect(order('aborted', 'recorded', true)).toEqual(['101-3']);
  expect(order('old', 'recorded', true)).toEqual(['102-old']);
});

it('a table keeps commas, quotes and line breaks of a note in their cell', () => {
  const [head = '', ...rows] = runsTable(runs).trim().split(/\n(?=\d)/);
  expect(head).toMatch(/^run,name,outcome,cause,by_hand,course,/);
  expect(rows).toHaveLength(4);
  expect(rows[1]).toContain('aborted,"lost, ""a wheel""",false,3,lab,1,1,0.3,');
  expect(rows[3]).toMatch(/,lab,"wet\nfloor"$/);
});
