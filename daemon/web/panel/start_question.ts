// The question before a start while the daemon does not know that the robot stands at the course's start: was it put
// there, or shall it continue from the pose that is shown? Nothing moves before one of them is chosen.
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
    this.starts = [answer('start-placed', 'Put back at the start: start there', 'start'), answer('start-here', 'Continue from here', 'here')];
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
    for (const [i, refused] of [at.why_not_placed, at.why_not_here].entries()) {
      const start = this.starts[i];
      if (start === undefined) continue;
      start.disabled = !mayStart || refused !== '';
      setAttribute(start, 'title', mayStart ? refused : (state?.why_not_start ?? ''));
    }
    const place = `x ${fixed(at.x_m, 2)} m, y ${fixed(at.y_m, 2)} m, yaw ${degrees(at.yaw_rad, 0)}\u00b0`;
    const along = at.why_not_here === '' ? `From there it would continue at ${fixed(at.progress_m, 2)} of ${fixed(state?.length_m, 2)} m along the course. ` : `Not from there: ${at.why_not_here}. `;
    const seen = at.why_not_placed === '' ? '' : `Not from the start: ${at.why_not_placed}. `;
    setText(this.text, `The robot may be elsewhere than at the start of the course. It is estimated to be at ${place}. ${along}${seen}Where is it now?`);
  }
}
