// The recorded runs: GET /api/runs, and a viewer's requests about them.

export interface RunFile {
  name: string;
  bytes: number;
  url: string;
  kind: string;
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

/** A run is named by its time and its course. */
export const courseOf = (run: string): string => run.replace(/^\d+-\d+-?/, '');

export const titleOf = ({ name, run }: Pick<RunEntry, 'name' | 'run'>): string => (name === '' ? run : name);

/** The page that tp100d report makes; undefined: not yet. */
export const reportOf = (run: RunEntry): RunFile | undefined => run.files.find(({ name }) => name === 'report.html');
