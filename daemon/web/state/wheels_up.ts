// The check of the tracks with the wheels up: begun once it is confirmed that they are free, and watched until it ends.
import type { DoctorAnswer } from './doctor.ts';
import { reason, type Call } from './service.ts';

/** The daemon stops the tracks when it has heard nothing for 150 ms. */
export const kWatch_ms = 40;

export interface WheelsUpQuestion {
  number: number;
  text: string;
  choices: { answer: string; meaning: string }[];
}

export interface WheelsUpProgress {
  step: string;
  question?: WheelsUpQuestion;
  /** The check has ended. */
  result?: DoctorAnswer;
}

/** One check at a time. */
export class WheelsUp {
  private token = '';
  /** Asked for, and not answered yet. */
  private beginning = false;
  private answered: { question: number; answer: string } | undefined;

  constructor(
    private readonly call: Call,
    /** Whether somebody sees this page. */
    private readonly seen: () => boolean,
    private readonly now_ms: () => number,
    private readonly progress: (progress: WheelsUpProgress) => void,
    private readonly failed: (why: string) => void,
  ) {}

  get on(): boolean {
    return this.beginning || this.token !== '';
  }

  /** Does nothing while a check is on: a second click begins no second one. */
  async begin(): Promise<void> {
    if (this.on) return;
    this.beginning = true;
    try {
      const { token } = (await this.call('wheels_up_begin', { tracks: 'free' })) as { token: string };
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

  /** Call it every kWatch_ms. A page that nobody sees says nothing. */
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
