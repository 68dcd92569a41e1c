// The recorded runs: GET /api/runs, and what a viewer asks of the daemon about them.

export interface RunFile {
  name: string;
  bytes: number;
  url: string;
  kind: string;
}

export interface RunEntry {
  run: string;
  /** What a person says of it; may be empty. */
  name: string;
  note: string;
  tags: string;
  keep: boolean;
  /** Why the note cannot be read, or empty. */
  note_error: string;
  modified_unix_s: number;
  bytes: number;
  active: boolean;
  files: RunFile[];
}

export interface RunsList {
  /** Empty: nothing is recorded. */
  directory: string;
  bytes: number;
  free_bytes: number;
  /** 0: none. */
  quota_bytes: number;
  /** The run that is reported or compared now; empty: none. */
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

export type RunCall =
  | { name: 'run_note'; request: RunNote }
  | { name: 'run_delete'; request: { run: string } }
  | { name: 'run_report'; request: { run: string } }
  | { name: 'run_compare'; request: { run: string; with: string } };

export const titleOf = ({ name, run }: RunEntry): string => (name === '' ? run : name);

/** The page that tp100d report makes; undefined: not yet. */
export const reportOf = (run: RunEntry): RunFile | undefined => run.files.find(({ name }) => name === 'report.html');
