// The services `doctor`, which finds what keeps a robot from driving, and `wheels_up`, which runs its tracks in the air.
import { reason, type Call } from './service.ts';

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

/** Period of tick(): the daemon stops the tracks if it receives no call for 150 ms. */
export const kWatch_ms = 40;

export interface WheelsUpQuestion {
  number: number;
  text: string;
  choices: { answer: string; meaning: string }[];
}

export interface WheelsUpProgress {
  step: string;
  question?: WheelsUpQuestion;
  /** Present once the check has ended. */
  result?: DoctorAnswer;
}

/** Runs one check at a time. */
export class WheelsUp {
  private token = '';
  /** True while the request to begin is not answered yet. */
  private beginning = false;
  private answered: { question: number; answer: string } | undefined;

  constructor(
    private readonly call: Call,
    /** Sends a request that makes the tracks run, with the person's consent. */
    private readonly move: Call,
    /** Whether this page is visible to a person. */
    private readonly seen: () => boolean,
    private readonly now_ms: () => number,
    private readonly progress: (progress: WheelsUpProgress) => void,
    private readonly failed: (why: string) => void,
  ) {}

  get on(): boolean {
    return this.beginning || this.token !== '';
  }

  /** Begins a check; does nothing while one is running, so that a double click begins only one. */
  async begin(): Promise<void> {
    if (this.on) return;
    this.beginning = true;
    try {
      const { token } = (await this.move('wheels_up_begin', { tracks: 'free' })) as { token: string };
      this.token = token;
    } catch (error: unknown) {
      this.end(error);
    } finally {
      this.beginning = false;
    }
  }

  answer(question: number, answer: string): void {
    this.answered = { question, answer };
  }

  /** Call every kWatch_ms. Tells the daemon that the check is watched; a hidden page sends nothing: the tracks stop. */
  async tick(): Promise<void> {
    const token = this.token;
    if (token === '' || !this.seen()) return;
    const answered = this.answered;
    this.answered = undefined;
    try {
      const progress = (await this.call('wheels_up_watch', { token, input_ms: this.now_ms(), ...answered })) as WheelsUpProgress;
      if (this.token !== token) return;
      if (progress.result !== undefined) this.token = '';
      this.progress(progress);
    } catch (error: unknown) {
      if (this.token === token) this.end(error);
    }
  }

  private end(error: unknown): void {
    this.token = '';
    this.failed(reason(error));
  }
}
