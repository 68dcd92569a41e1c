// The service `doctor`, which finds what keeps a robot from driving, and its findings.

export type Severity = 'ok' | 'note' | 'warning' | 'error';

export interface Finding {
  severity: Severity;
  name: string;
  /** What was seen, and where. */
  seen: string;
  /** What to do; empty: nothing. */
  fix: string;
}

export interface DoctorAnswer {
  errors: number;
  findings: Finding[];
}

/** The parts, which are examined one by one in this order. */
export const kParts = [
  { part: 'port', title: 'Port' },
  { part: 'robot', title: 'Robot' },
  { part: 'machine', title: 'Machine' },
] as const;

const counted = (n: number, noun: string): string => `${n} ${noun}${n === 1 ? '' : 's'}`;

/** The outcome in one line, for all parts or for one of them. */
export function verdict(findings: readonly Finding[], part = ''): string {
  const number = (severity: Severity): number => findings.filter((each) => each.severity === severity).length;
  const [errors, warnings, notes] = [number('error'), number('warning'), number('note')];
  const whole = errors > 0 ? 'Not ready to drive' : 'Ready to drive';
  const drives = part === '' ? whole : errors > 0 ? `${part} are not as they should be` : `${part} are as they should be`;
  return `${drives}: ${counted(errors, 'error')}, ${counted(warnings, 'warning')}, ${counted(notes, 'note')}.`;
}
