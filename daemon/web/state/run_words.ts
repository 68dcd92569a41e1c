// The state of a robot in the words of a person who watches it.
import { clock } from './format.ts';
import { asksForMotion, type State } from './messages.ts';

/** Colour of the lamp beside the words. */
export type Lamp = 'good' | 'done' | 'wait' | 'warn' | 'bad' | 'none';

export interface RunWords {
  lamp: Lamp;
  word: string;
  /** Beside or below the word; may be empty. */
  detail: string;
}

/** Of each state of the session, unless it is ready. */
export const kSessions: Record<State['session'], string> = {
  closed: 'no port',
  listening: 'no answer yet',
  hello: 'connecting',
  parameters: 'connecting',
  syncing: 'connecting',
  ready: '',
  refused: 'refused',
};

export function runWords(state: State): RunWords {
  const { run, session } = state;
  if (state.motors_on && !asksForMotion(run)) return { lamp: 'bad', word: 'motors on', detail: 'without a run' };
  if (session !== 'ready' && !asksForMotion(run)) return { lamp: 'bad', word: 'no robot', detail: kSessions[session] };
  const time = typeof state.run_s === 'number' ? clock(state.run_s) : '';
  switch (run) {
    case 'arming':
      return { lamp: 'wait', word: 'starting', detail: state.motors_on ? 'motors on' : 'motors off' };
    case 'running':
      if (state.pause_left_s === undefined) return { lamp: 'good', word: 'running', detail: time };
      return { lamp: 'warn', word: 'paused', detail: `motors on, ends in ${minutes(state.pause_left_s)}` };
    case 'driving':
      return { lamp: 'good', word: 'by hand', detail: state.driver?.by ?? 'motors on' };
    case 'finished':
      return { lamp: 'done', word: outcomeOf(state), detail: time };
    case 'aborted':
      return { lamp: 'bad', word: outcomeOf(state), detail: time };
    case 'idle':
      return { lamp: 'none', word: state.can.start ? 'ready' : 'not ready', detail: state.can.start ? 'motors off' : state.why_not_start };
  }
}

/** How a run ended: a STOP that somebody wanted is no fault, and one after a fault has ended nothing. */
export function outcomeOf({ run, stop, faults }: State): string {
  if (run === 'finished') return 'completed';
  if (run !== 'aborted') return 'ended';
  return stop.latched && faults.every(({ name }) => name === 'stop_requested') ? 'stopped' : 'aborted';
}

/** For example 1:52. */
export function minutes(duration_s: number): string {
  const s = Math.max(0, Math.round(duration_s));
  return `${Math.floor(s / 60)}:${String(s % 60).padStart(2, '0')}`;
}
