// The state of STOP in this page, as a pure function of presses, answers and time.
import type { StopState } from './messages.ts';

/** After this long without the robot's acknowledgement the page shows a warning. */
export const kPatience_ms = 200;

export type StopView =
  | { kind: 'ready' }
  /** pressed here, no answer yet, patience not yet over */
  | { kind: 'pending' }
  /** `waiting`: it could not even be sent and will be the first request when the daemon is back */
  | { kind: 'not_acknowledged'; since_ms: number; waiting: boolean }
  /** latched on the robot; `took_ms`: from the daemon's receipt to the robot's acknowledgement */
  | { kind: 'stopped'; took_ms: number | null; by: string };

interface Press {
  at_ms: number;
  sent: boolean;
  /** The daemon received it: from now on /state includes it. */
  received: boolean;
}

export class StopButton {
  private press_: Press | undefined;
  private daemon: StopState | undefined;
  private lastTook_ms: number | null = null;

  /** A press that still has to be sent. */
  get unsent(): boolean {
    return this.press_ !== undefined && !this.press_.sent;
  }

  /** A press that the daemon has not answered. */
  get unanswered(): boolean {
    return this.press_ !== undefined && !this.press_.received;
  }

  press(now_ms: number): void {
    this.press_ = { at_ms: now_ms, sent: false, received: false };
  }

  sent(): void {
    if (this.press_ !== undefined) this.press_.sent = true;
  }

  /** The daemon answered the call. */
  answered(acknowledged: boolean, took_ms: number | null): void {
    if (this.press_ === undefined) return;
    if (acknowledged) {
      this.press_ = undefined;
      this.lastTook_ms = took_ms;
      if (this.daemon !== undefined) {
        this.daemon = { ...this.daemon, latched: true, status: 'acknowledged', acknowledged_ms: took_ms ?? undefined };
      }
    } else {
      this.press_.received = true;
    }
  }

  /** The connection ended: a press that the robot has not confirmed must be sent again. */
  disconnected(): void {
    if (this.press_ === undefined) return;
    this.press_.sent = false;
    this.press_.received = false;
  }

  /** The state from /state. */
  received(state: StopState): void {
    this.daemon = state;
    this.lastTook_ms = state.acknowledged_ms ?? this.lastTook_ms;
    if (this.press_?.received !== true) return;
    // Acknowledged late, or cleared by a new start.
    if (state.status === 'acknowledged' || !state.latched) this.press_ = undefined;
  }

  view(now_ms: number): StopView {
    const press = this.press_;
    if (press !== undefined) {
      const since_ms = now_ms - press.at_ms;
      if (since_ms < kPatience_ms) return { kind: 'pending' };
      return { kind: 'not_acknowledged', since_ms, waiting: !press.sent };
    }
    const daemon = this.daemon;
    if (daemon?.latched !== true) return { kind: 'ready' };
    if (daemon.status === 'acknowledged' || daemon.status === 'none') {
      return { kind: 'stopped', took_ms: daemon.acknowledged_ms ?? this.lastTook_ms, by: daemon.by };
    }
    if (daemon.status === 'pending') return { kind: 'pending' };
    return { kind: 'not_acknowledged', since_ms: kPatience_ms, waiting: false };
  }
}
