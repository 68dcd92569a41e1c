// The check of the tracks in the Doctor tab: asks whether they are off the ground, shows each step, asks what was seen.
import type { Consent } from '../state/consent.ts';
import { kWatch_ms, verdict, WheelsUp, type Finding, type WheelsUpProgress, type WheelsUpQuestion } from '../state/doctor.ts';
import { attended, button, h, Message, setAttribute } from './dom.ts';
import type { Call } from '../state/service.ts';

export class WheelsUpPanel {
  readonly element = h('section', { class: 'wheels-up', 'aria-label': 'Wheels up' });
  private readonly free = h('input', { type: 'checkbox', id: 'wheels-up-free' });
  private readonly start = button({ class: 'control', id: 'wheels-up-start' }, 'Run the tracks', () => {
    // Each check needs a new confirmation.
    this.free.checked = false;
    this.list.replaceChildren();
    this.message.say('\u2026');
    void this.check.begin();
  });
  private readonly message = new Message('wheels-up-message', 'Both tracks run in opposite directions, then each one forward and back for a second, as long as this page is in sight. STOP ends it.');
  private readonly question = h('div', { class: 'wheels-up-question', role: 'group', 'aria-label': 'Question', hidden: '' });
  private readonly list = h('ul', {});
  private readonly check: WheelsUp;
  private asked = -1;

  constructor(call: Call, consent: Consent) {
    consent.subscribe(() => { this.free.checked = false; });
    this.check = new WheelsUp(
      call,
      consent.move,
      attended,
      () => performance.now(),
      (progress) => { this.progress(progress); },
      (why) => { this.message.say(why, true); },
    );
    this.element.append(
      h('h3', {}, 'Wheels up'),
      h('div', { class: 'wheels-up-bar' }, h('label', {}, this.free, ' The robot stands on a block, and both tracks turn freely'), this.start),
      this.message.element,
      this.question,
      this.list,
    );
    setInterval(() => { void this.check.tick(); }, kWatch_ms);
  }

  get on(): boolean {
    return this.check.on;
  }

  /** `why`: reason why no check may begin now; empty: one may. */
  show(why: string): void {
    this.free.disabled = why !== '' || this.check.on;
    this.start.disabled = this.free.disabled || !this.free.checked;
    setAttribute(this.start, 'title', why);
    if (!this.check.on) this.question.hidden = true;
  }

  private progress({ step, question, result }: WheelsUpProgress): void {
    if (result !== undefined) {
      this.message.say(verdict(result.findings, 'The tracks'), result.errors > 0);
      this.list.replaceChildren(...result.findings.map(findingRow));
    } else {
      this.message.say(step);
    }
    this.question.hidden = question === undefined;
    if (question !== undefined && question.number !== this.asked) this.ask(question);
  }

  private ask({ number, text, choices }: WheelsUpQuestion): void {
    this.asked = number;
    const buttons = choices.map(({ answer, meaning }) => button({ class: 'control', 'data-answer': answer }, meaning, () => { this.check.answer(number, answer); }));
    this.question.replaceChildren(h('p', {}, text), ...buttons);
  }
}

/** One finding of an examination, with its remedy. */
export function findingRow({ severity, name, seen, fix }: Finding): HTMLElement {
  const about = h('div', { class: 'finding-about' }, h('p', {}, seen));
  if (fix !== '') about.append(h('p', { class: 'finding-fix' }, `To do: ${fix}`));
  return h('li', { class: 'finding', 'data-severity': severity, 'data-name': name }, h('span', { class: 'finding-severity' }, severity), h('strong', {}, name), about);
}
