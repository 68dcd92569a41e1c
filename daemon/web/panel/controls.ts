// Start, hold and record. Actions that move the robot are confirmed if the daemon requires it;
// actions that stop it never are.
import { bytes, clock } from '../state/format.ts';
import { kNoRights, type State } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { StartQuestion, type Place } from './start_question.ts';
import { h, icon, setAttribute, setClass, setText } from './dom.ts';

export type Command = 'hold' | 'pause' | 'resume' | 'record_start' | 'record_stop';

const kConfirm_ms = 3000;

export class Controls {
  readonly element = h('div', { class: 'controls', role: 'group', 'aria-label': 'Run' });
  private readonly start = button('start', 'play', 'Start', 'r');
  private readonly pause = button('pause', 'pause', 'Pause', 'p');
  private readonly hold = button('hold', 'square', 'Hold', 'h');
  private readonly record = button('record', 'record', 'Record', '');
  private readonly question: StartQuestion;
  private confirmUntil_ms = 0;
  private state: State | undefined;
  private needsConfirmation = true;
  private recording = false;

  constructor(
    private readonly send: (command: Command) => void,
    private readonly sendStart: (from: Place) => void,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.question = new StartQuestion(this.sendStart);
    this.element.append(this.start.button, this.pause.button, this.hold.button, this.record.button, this.question.element);
    this.start.button.addEventListener('click', () => {
      this.pressStart();
    });
    this.pause.button.addEventListener('click', () => {
      this.pressPause();
    });
    this.hold.button.addEventListener('click', () => {
      this.pressHold();
    });
    this.record.button.addEventListener('click', () => {
      this.send(this.recording ? 'record_stop' : 'record_start');
    });
  }

  pressStart(): void {
    if (this.start.button.disabled || this.question.open) return;
    if (this.state?.go_on_from !== undefined) {
      this.question.ask(this.state);
      return;
    }
    const now_ms = this.now();
    if (this.needsConfirmation && now_ms > this.confirmUntil_ms) {
      this.confirmUntil_ms = now_ms + kConfirm_ms;
      return;
    }
    this.confirmUntil_ms = 0;
    this.sendStart('start');
  }

  /** Pauses a run that drives, resumes one that pauses. */
  pressPause(): void {
    if (!this.pause.button.disabled) this.send(this.state?.pause_left_s === undefined ? 'pause' : 'resume');
  }

  pressHold(): void {
    if (!this.hold.button.disabled) this.send('hold');
  }

  /** STOP was pressed: cancels an unconfirmed start. */
  forget(): void {
    this.question.close();
    this.confirmUntil_ms = 0;
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const state = store.get('/state');
    const fresh = connected && mayCommand && state !== undefined && !store.stale('/state');
    this.needsConfirmation = state?.confirm_start !== false;
    const confirm = this.now() < this.confirmUntil_ms;
    const mayStart = fresh && state.can.start;
    this.start.button.disabled = !mayStart;
    this.state = state;
    this.question.show(state, mayStart);
    setClass(this.start.button, 'confirm', confirm);
    setText(this.start.label, confirm ? 'Press again' : 'Start');
    const why = !mayCommand ? kNoRights : (state?.why_not_start ?? '');
    setAttribute(this.start.button, 'title', why === '' ? 'Start the course (r)' : why);
    const left_s = state?.pause_left_s;
    // Pause replaces Start, which is not needed during a run.
    const runs = state?.can.pause === true || state?.can.resume === true;
    this.start.button.hidden = runs;
    this.pause.button.hidden = !runs;
    this.pause.button.disabled = !(fresh && runs);
    setClass(this.pause.button, 'confirm', left_s !== undefined);
    setText(this.pause.label, left_s === undefined ? 'Pause' : 'Resume');
    setAttribute(this.pause.button, 'title', left_s === undefined ? 'Stand still on the path, armed (p)' : `Go on (p); the run ends in ${left_s.toFixed(0)} s`);
    this.hold.button.disabled = !(fresh && state.can.hold);

    const recording = store.get('/recording');
    this.recording = recording?.active === true;
    this.record.button.disabled = !(fresh && (state.can.record || this.recording));
    setClass(this.record.button, 'active', this.recording);
    setText(this.record.label, this.recording ? clock(recording?.elapsed_s) : 'Record');
    const title = recording?.available === false ? 'No directory to record to: start tp100d with --record DIR' : '';
    const file = this.recording ? `${recording?.run ?? ''}, ${bytes(recording?.bytes)}` : title;
    setAttribute(this.record.button, 'title', recording?.warning === '' || recording === undefined ? file : recording.warning);
    setClass(this.record.button, 'warn', (recording?.warning ?? '') !== '');
  }
}

function button(id: string, symbol: Parameters<typeof icon>[0], text: string, shortcut: string): {
  button: HTMLButtonElement;
  label: HTMLElement;
} {
  const label = h('span', { class: 'button-label' }, text);
  const element = h('button', { type: 'button', id, class: 'control' }, icon(symbol), label);
  if (shortcut !== '') element.setAttribute('aria-keyshortcuts', shortcut);
  return { button: element, label };
}
