// The recorded runs: GET /api/runs, and a viewer's requests about them.
import { bytes, clock, fixed, hasWords } from './format.ts';

export interface RunFile {
  name: string;
  bytes: number;
  url: string;
  kind: string;
}

/** How a run went. */
export interface RunResult {
  /** Empty: nothing was driven. */
  outcome: string;
  cause: string;
  course: string;
  robot: string;
  duration_s: number;
  distance_m: number;
  largest_m: number;
  by_hand: boolean;
}

export interface RunEntry {
  run: string;
  /** Given by a person; may be empty, like note and tags. */
  name: string;
  note: string;
  tags: string;
  keep: boolean;
  /** Those that were made afterwards. */
  marks?: { t_s: number; text: string }[];
  /** Recordings of other programs have none. */
  result?: RunResult;
  /** Why the note cannot be read, or empty. */
  note_error: string;
  modified_unix_s: number;
  bytes: number;
  active: boolean;
  files: RunFile[];
}

export interface RunsList {
  /** Empty: recording is off. */
  directory: string;
  bytes: number;
  free_bytes: number;
  /** 0: no quota. */
  quota_bytes: number;
  /** The run for which a report or comparison is being made; empty: none. */
  making: string;
  runs: RunEntry[];
}

export interface RunNote {
  run: string;
  name: string;
  note: string;
  tags: string;
  keep: boolean;
}

/** Without a result, a run is named by its time and its course. */
export const courseOf = ({ run, result }: Pick<RunEntry, 'run' | 'result'>): string => result?.course ?? run.replace(/^\d+-\d+-?/, '');

export const titleOf = ({ name, run }: Pick<RunEntry, 'name' | 'run'>): string => (name === '' ? run : name);

/** How a run ended, in words. */
export const outcomeText = ({ active, result }: RunEntry): string => (active ? 'recording' : [result?.outcome ?? '', result?.by_hand === true ? 'by hand' : ''].filter((text) => text !== '').join(', '));

export interface RunColumn {
  title: string;
  /** What the list is sorted by: numbers, or texts. */
  of: (run: RunEntry) => number | string;
  /** As it is shown and saved in a table, if otherwise. */
  text?: (run: RunEntry) => string;
}

const figure = (of: (result: RunResult) => number) => (run: RunEntry): number => (run.result === undefined || run.result.outcome === '' ? NaN : of(run.result));

const duration_s = figure((result) => result.duration_s);
const error_mm = figure(({ by_hand, largest_m }) => (by_hand ? NaN : 1000 * largest_m));

export type RunKey = 'run' | 'outcome' | 'course' | 'robot' | 'duration' | 'error' | 'recorded' | 'size';
export const kRunColumns: Record<RunKey, RunColumn> = {
  run: { title: 'run', of: titleOf },
  outcome: { title: 'outcome', of: outcomeText },
  course: { title: 'course', of: courseOf },
  robot: { title: 'robot', of: ({ result }) => result?.robot ?? '' },
  duration: { title: 'time', of: duration_s, text: (run) => clock(duration_s(run)) },
  error: { title: 'largest error', of: error_mm, text: (run) => `${fixed(error_mm(run), 1)} mm` },
  recorded: { title: 'recorded', of: ({ modified_unix_s }) => modified_unix_s, text: ({ modified_unix_s }) => new Date(1000 * modified_unix_s).toLocaleString() },
  size: { title: 'size', of: ({ bytes: size }) => size, text: ({ bytes: size }) => bytes(size) },
};

/** Those whose texts have all words of the search, in order; unknown values last. */
export function arranged(runs: readonly RunEntry[], search: string, key: RunKey, down: boolean): RunEntry[] {
  const words = (run: RunEntry): string => [titleOf(run), run.run, outcomeText(run), courseOf(run), run.result?.robot, run.tags, run.note].join(' ');
  const { of } = kRunColumns[key];
  const order = (a: RunEntry, b: RunEntry): number => {
    const [x, y]: [number | string, number | string] = [of(a), of(b)];
    if (Number.isNaN(x) || Number.isNaN(y)) return Number(Number.isNaN(x)) - Number(Number.isNaN(y));
    const up = typeof x === 'string' ? x.localeCompare(String(y)) : x - Number(y);
    return down ? -up : up;
  };
  return runs.filter((run) => hasWords(words(run), search)).sort(order);
}

/** A table for other programs: SI units. */
export function runsTable(runs: readonly RunEntry[]): string {
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const head = ['run', 'name', 'outcome', 'cause', 'by_hand', 'course', 'robot', 'duration_s', 'distance_m', 'largest_error_m', 'recorded', 'bytes', 'tags', 'note'];
  const rows = runs.map((run) => {
    const { result } = run;
    return [run.run, run.name, result?.outcome, result?.cause, result?.by_hand, courseOf(run), result?.robot, result?.duration_s, result?.distance_m, result?.largest_m, new Date(1000 * run.modified_unix_s).toISOString(), run.bytes, run.tags, run.note];
  });
  return [head, ...rows].map((row) => row.map((value) => quoted(String(value ?? ''))).join(',')).join('\n') + '\n';
}

/** The page that tp100d report makes; undefined: not yet. */
export const reportOf = (run: RunEntry): RunFile | undefined => run.files.find(({ name }) => name === 'report.html');
