// Beside Start: what to do next, or why Start is grey.
import { fixed } from '../state/format.ts';
import { asksForMotion, kNoRights, type State } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setText } from './dom.ts';

interface Step {
  text: string;
  /** Where it is done: part of the address, and words for it. */
  link?: readonly [href: string, text: string];
}

/** `asks`: a press that sets the robot in motion waits for the second one. `drives`: this page drives by hand. */
export function nextStep(state: State, mayCommand: boolean, asks: boolean, drives: boolean): Step {
  if (asks) return { text: 'Press again within 3 s: the robot will move.' };
  if (!mayCommand) return { text: `${kNoRights}.` };
  if (state.pause_left_s !== undefined) return { text: 'Paused on the path, motors on: Resume, or End run.' };
  if (state.run === 'driving' && !drives) return { text: `Driven by hand by ${state.driver?.by ?? 'another viewer'}; End run switches the motors off.` };
  if (state.run === 'driving') return { text: 'Arrow keys, stick or gamepad drive while they are held; Release ends it.' };
  if (asksForMotion(state.run)) return { text: 'Pause stands still; End run switches the motors off.' };
  if (state.session !== 'ready') return { text: 'Plug the robot in and switch it on.', link: ['#setup/doctor', 'What is wrong?'] };
  if (state.course === '') return { text: 'Choose a course, or drive by hand.', link: ['#plan', 'Choose'] };
  if (!state.can.start) return { text: `Not now: ${state.why_not_start}.` };
  const what = `course ${state.course}, ${fixed(state.length_m, 2)} m`;
  if (state.continue_from !== undefined) return { text: `Start asks where the robot stands: ${what}.` };
  return { text: `Put the robot at the start of ${what}, and press Start.` };
}

export class NextStep {
  readonly element = h('p', { class: 'next-step', role: 'status' });
  private readonly text = h('span');
  private readonly link = h('a', { class: 'link' });

  constructor() {
    this.element.append(this.text, ' ', this.link);
  }

  show(store: Store, connected: boolean, mayCommand: boolean, asks: boolean, drives: boolean): void {
    const state = store.get('/state');
    const step = !connected || state === undefined || store.stale('/state') ? { text: '' } : nextStep(state, mayCommand, asks, drives);
    setText(this.text, step.text);
    setText(this.link, step.link?.[1] ?? '');
    setAttribute(this.link, 'href', step.link?.[0] ?? '#');
    this.link.hidden = step.link === undefined;
  }
}
