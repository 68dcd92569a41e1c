// One line over the view: the most severe current problem, with what to do.
import type { Store } from '../state/store.ts';
import { h, setAttribute, setText } from './dom.ts';

const kAnswer_ms = 6000;

export class Notice {
  readonly element = h('div', { class: 'notice', role: 'status', 'data-level': 'none' });
  private readonly what = h('strong');
  private readonly todo = h('span');
  private answer = '';
  private answerUntil_ms = 0;

  constructor() {
    this.element.append(this.what, this.todo);
  }

  /** The daemon's answer to a request of this page; shown for a few seconds. */
  say(text: string, now_ms: number): void {
    this.answer = text;
    this.answerUntil_ms = now_ms + kAnswer_ms;
  }

  show(store: Store, connected: boolean, retryIn_s: number, now_ms: number): void {
    const state = store.get('/state');
    const fault = state?.faults.find((one) => one.name !== 'stop_requested');
    if (!connected) {
      this.set('bad', 'No connection to tp100d', retryIn_s > 0 ? 'trying again' : 'connecting');
    } else if (now_ms < this.answerUntil_ms) {
      this.set('warn', this.answer, '');
    } else if (fault !== undefined) {
      const more = (state?.faults.length ?? 1) - 1;
      this.set('bad', fault.cause + (more > 0 ? ` (+${more})` : ''), fault.fix);
    } else if (state !== undefined && store.stale('/state')) {
      this.set('bad', 'The daemon is silent', 'what is grey is old');
    } else if (state !== undefined && state.session !== 'ready') {
      this.set('warn', 'No robot', state.why_not_start);
    } else {
      this.set('none', '', '');
    }
  }

  private set(level: string, what: string, todo: string): void {
    setAttribute(this.element, 'data-level', level);
    setText(this.what, what);
    setText(this.todo, todo);
  }
}
