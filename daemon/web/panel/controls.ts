// Start, pause, end and record. Start is confirmed if the daemon requires it, and always when it resumes a paused run;
// what stops the robot never is, and never shares a control with what moves it.
import { Confirmation, type Consent } from '../state/consent.ts';
import { bytes, clock } from '../state/format.ts';
import { asksForMotion, kNoRights, type State } from '../state/messages.ts';
import { minutes } from '../state/run_words.ts';
import type { Store } from '../state/store.ts';
import { reason, type Call } from '../state/service.ts';
import { StartQuestion } from './start_question.ts';
import { button, h, icon, setAttribute, setClass, setText } from './dom.ts';

export class Controls {
  readonly element = h('div', { class: 'controls', role: 'group', 'aria-label': 'Run' });
  private readonly start = control('start', 'play', 'Start', 'r', () => { this.pressStart(); });
  private readonly pause = control('pause', 'pause', 'Pause', 'p', () => { this.pressPause(); });
  private readonly hold = control('hold', 'square', 'End run', 'h', () => { this.pressHold(); });
  private readonly record = control('record', 'record', 'Record', '', () => {
    this.send(this.call(this.recording ? 'record_stop' : 'record_start', {}));
  });
  private readonly mark = control('mark', 'mark', 'Mark', 'm', () => { this.pressMark(); });
  readonly keys = { r: (): void => { this.pressStart(); }, h: (): void => { this.pressHold(); }, p: (): void => { this.pressPause(); } };
  private readonly question: StartQuestion;
  private readonly starts: Confirmation;
  private readonly resumes: Confirmation;
  private state: State | undefined;
  /** Start waits for the second press. */
  asks = false;
  private needsConfirmation = true;
  private recording = false;

  constructor(
    private readonly call: Call,
    private readonly consent: Consent,
    /** The robot is asked to move. */
    private readonly moves: () => void,
    private readonly failed: (why: string) => void,
  ) {
    this.question = new StartQuestion(consent, (from) => { this.move('start', { from }); });
    this.starts = new Confirmation(consent);
    this.resumes = new Confirmation(consent);
    this.hold.button.title = 'End the run and switch the motors off (h)';
    this.hold.label.append(h('small', {}, 'motors off'));
    this.element.append(this.start.button, this.hold.button, this.record.button, this.mark.button, this.pause.button, this.question.element);
  }

  /** Starts, or resumes a paused run. */
  pressStart(): void {
    if (this.start.button.disabled || this.question.open) return;
    if (this.state?.can.resume === true) {
      if (this.resumes.press()) this.move('resume', {});
      return;
    }
    if (this.state?.continue_from !== undefined) {
      this.question.ask(this.state);
      return;
    }
    if (!this.needsConfirmation || this.starts.press()) this.move('start', {});
  }

  /** Pauses; a run that is paused stays so. */
  pressPause(): void {
    if (!this.pause.button.disabled) this.send(this.call('pause', {}));
  }

  pressHold(): void {
    if (!this.hold.button.disabled) this.send(this.call('hold', {}));
  }

  /** Marks this moment in the recording. */
  pressMark(): void {
    if (!this.mark.button.disabled) this.send(this.call('mark', {}));
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const state = store.get('/state');
    const fresh = connected && mayCommand && state !== undefined && !store.stale('/state');
    this.needsConfirmation = state?.confirm_start !== false;
    const mayStart = fresh && state.can.start;
    this.state = state;
    this.question.show(state, mayStart);
    const paused = state?.can.resume === true;
    if (paused) this.starts.close();
    else this.resumes.close();
    const confirm = (this.asks = (paused ? this.resumes : this.starts).show());
    this.start.button.disabled = !(mayStart || (fresh && paused));
    setClass(this.start.button, 'confirm', confirm);
    setText(this.start.label, confirm ? 'Press again' : paused ? 'Resume' : 'Start');
    const end = `the run ends in ${minutes(state?.pause_left_s ?? 0)}`;
    const why = !mayCommand ? kNoRights : (state?.why_not_start ?? '');
    setAttribute(this.start.button, 'title', paused ? `Resume the run (r); ${end}` : why === '' ? 'Drive the course (r)' : why);
    const runs = state?.can.pause === true;
    this.pause.button.hidden = !runs;
    this.pause.button.disabled = !(fresh && runs);
    setClass(this.pause.button, 'paused', paused);
    setText(this.pause.label, paused ? 'Paused' : 'Pause');
    setAttribute(this.pause.button, 'title', paused ? `Paused; ${end}` : 'Stand still on the path, motors on (p)');
    this.hold.button.disabled = !(fresh && state.can.hold && (asksForMotion(state.run) || state.motors_on));

    const recording = store.get('/recording');
    this.recording = recording?.active === true;
    this.record.button.disabled = !(fresh && (state.can.record || this.recording));
    setClass(this.record.button, 'active', this.recording);
    this.mark.button.disabled = !(fresh && this.recording);
    setAttribute(this.mark.button, 'title', this.recording ? 'Mark this moment in the recording (m)' : 'Marks a moment of a recording; nothing is recorded now');
    setText(this.record.label, this.recording ? clock(recording?.elapsed_s) : 'Record');
    const title = recording?.available === false ? 'No directory to record to: start tp100d with --record DIR' : 'Record what the robot does, also without a run';
    const file = this.recording ? `${recording?.run ?? ''}, ${bytes(recording?.bytes)}` : title;
    setAttribute(this.record.button, 'title', recording?.warning === '' || recording === undefined ? file : recording.warning);
    setClass(this.record.button, 'warn', (recording?.warning ?? '') !== '');
  }

  private move(service: string, request: object): void {
    this.send(this.consent.move(service, request));
    this.moves();
  }

  private send(answer: Promise<unknown>): void {
    answer.catch((error: unknown) => { this.failed(reason(error)); });
  }
}

/** A button of the bar, and its text. */
export function control(id: string, symbol: Parameters<typeof icon>[0], text: string, shortcut: string, press: () => void): { button: HTMLButtonElement; label: HTMLElement } {
  const label = h('span', {}, text);
  const element = button({ id, class: 'control', ...(shortcut === '' ? {} : { 'aria-keyshortcuts': shortcut }) }, icon(symbol), press);
  element.append(label);
  return { button: element, label };
}
