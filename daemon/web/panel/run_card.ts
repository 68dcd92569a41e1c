// After a run: how it ended, and what can be done with it.
import { clock, fixed, millimetres } from '../state/format.ts';
import type { State } from '../state/messages.ts';
import { outcomeOf } from '../state/run_words.ts';
import type { Store } from '../state/store.ts';
import { button, h, icon, setAttribute } from './dom.ts';

interface Deeds {
  report(run: string): void;
  replay(run: string): void;
  /** With the run of the same course before it. */
  compare(run: string): void;
}

export class RunCard {
  readonly element = h('section', { class: 'run-card', 'aria-label': 'The last run', hidden: '' });
  private readonly words = h('p', { role: 'status' });
  private readonly deeds: HTMLButtonElement[];
  /** The run that this page has watched, and its recording; empty: none. */
  private watched = false;
  private run = '';

  constructor(deeds: Deeds) {
    const deed = (id: string, text: string, act: (run: string) => void): HTMLButtonElement => button({ class: 'control', id }, text, () => { act(this.run); });
    this.deeds = [
      deed('card-report', 'Report', (run) => { deeds.report(run); }),
      deed('card-replay', 'Replay', (run) => { deeds.replay(run); }),
      deed('card-compare', 'Compare with the one before', (run) => { deeds.compare(run); }),
    ];
    const close = button({ class: 'card-close', 'aria-label': 'Close' }, icon('close'), () => { this.element.hidden = true; });
    this.element.append(this.words, h('div', { class: 'buttons' }, ...this.deeds), close);
  }

  show(store: Store): void {
    const state = store.get('/state');
    if (state === undefined || store.stale('/state')) return;
    if (state.run === 'running') {
      if (!this.watched) this.begin();
      this.watch(store);
    } else if (this.watched && state.run !== 'arming') {
      this.watch(store);
      this.watched = false;
      this.end(state);
    } else if (state.run === 'arming' || state.run === 'driving') this.element.hidden = true;
  }

  private begin(): void {
    this.watched = true;
    this.element.hidden = true;
    this.run = '';
  }

  private watch(store: Store): void {
    const recording = store.get('/recording');
    if (recording?.active === true) this.run = recording.run;
  }

  private end(state: State): void {
    const cause = state.run === 'finished' ? undefined : state.faults.find(({ name }) => name !== 'stop_requested')?.cause;
    const outcome = outcomeOf(state);
    setAttribute(this.element, 'data-outcome', outcome);
    this.words.replaceChildren(
      h('strong', {}, `Run ${outcome}`),
      cause === undefined ? '' : `: ${cause}`,
      h('span', {}, ` \u00b7 ${fixed(state.progress_m, 2)} of ${fixed(state.length_m, 2)} m in ${clock(state.run_s)} \u00b7 at most ${millimetres(state.largest_m, 1)} mm off the path${this.run === '' ? ' \u00b7 not recorded' : ''}`),
    );
    for (const deed of this.deeds) deed.hidden = this.run === '';
    this.element.hidden = false;
  }
}
