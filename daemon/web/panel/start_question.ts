// The question before a start after a run that ended early: does the robot stand at the course's start again, or shall
// it continue from where it is estimated to be? Nothing moves before one of them is chosen.
import { degrees, fixed } from '../state/format.ts';
import type { Consent } from '../state/consent.ts';
import type { State } from '../state/messages.ts';
import { button, h, setAttribute, setText } from './dom.ts';

export type Place = 'start' | 'here';

export class StartQuestion {
  readonly element = h('div', { class: 'question', role: 'dialog', 'aria-labelledby': 'question-text', hidden: '' });
  private readonly text = h('p', { id: 'question-text' });
  private readonly first: HTMLButtonElement;
  private readonly starts: HTMLButtonElement[];

  constructor(consent: Consent, chosen: (from: Place) => void) {
    consent.subscribe(() => { this.close(); });
    const answer = (id: string, text: string, from?: Place): HTMLButtonElement =>
      button({ class: 'control', id }, text, () => {
        this.close();
        if (from !== undefined) chosen(from);
      });
    this.first = answer('start-cancel', 'Cancel');
    this.starts = [answer('start-placed', 'Placed back at the start: start there', 'start'), answer('start-here', 'Continue from here', 'here')];
    this.element.append(this.text, this.first, ...this.starts);
  }

  get open(): boolean {
    return !this.element.hidden;
  }

  ask(state: State): void {
    this.element.hidden = false;
    this.show(state, true);
    this.first.focus();
  }

  close(): void {
    this.element.hidden = true;
  }

  /** Closes by itself when the question no longer applies; waits while nothing may start, as when the robot is carried to the start. */
  show(state: State | undefined, mayStart: boolean): void {
    if (!this.open) return;
    const at = state?.continue_from;
    if (at === undefined) {
      this.close();
      return;
    }
    for (const start of this.starts) {
      start.disabled = !mayStart;
      setAttribute(start, 'title', mayStart ? '' : (state?.why_not_start ?? ''));
    }
    const place = `x ${fixed(at.x_m, 2)} m, y ${fixed(at.y_m, 2)} m, yaw ${degrees(at.yaw_rad, 0)}\u00b0`;
    const along = `${fixed(state?.progress_m, 2)} of ${fixed(state?.length_m, 2)} m along the course`;
    setText(this.text, `The last run ended before the end of its course. The robot is estimated to be at ${place}, ${along}. Where is it now?`);
  }
}
