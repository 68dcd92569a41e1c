// The consent of the person at this page to a motion of the robot: what the page had shown when the person acted, and the
// end of everything that was asked before a STOP.
import type { State } from './messages.ts';
import type { Call } from './service.ts';

/** A press that makes the robot move is confirmed, and its request sent, within this time. */
export const kConfirm_ms = 3000;

/** What each request that makes the robot move carries (CHANNELS.md): of the newest /state that the page had shown. */
interface Seen {
  stops: number;
  t_s: number;
}

export class Consent {
  private count: number | undefined;
  private newest: Seen | undefined;
  private seen: Seen | undefined;
  private readonly listeners: ((why: string) => void)[] = [];

  constructor(private readonly call: Call) {}

  /**
   * `forget` is called at once when STOP is pressed, on whichever page, and when the connection ends, with the reason.
   * Whatever has asked the person for a motion by then must ask again.
   */
  subscribe(forget: (why: string) => void): void {
    this.listeners.push(forget);
  }

  received({ stop, t_s }: State): void {
    const stopped = this.count !== undefined && this.count !== stop.count;
    this.count = stop.count;
    this.newest = { stops: stop.count, t_s };
    if (stopped) this.tell('STOP was pressed');
  }

  /** Call when the page has shown the newest state. */
  shown(): void {
    this.seen = this.newest;
  }

  /** STOP was pressed on this page, or the connection ended: what was shown before counts no more. */
  forget(why: string): void {
    this.newest = this.seen = undefined;
    this.tell(why);
  }

  /** Sends a request that makes the robot move, with the person's consent. Call it when the person acts, not later. */
  readonly move: Call = (service, request) => {
    if (this.seen === undefined) return Promise.reject(new Error('nothing was shown of the robot since STOP was pressed or the connection ended; look, then press again'));
    return this.call(service, { ...(request as object), ...this.seen });
  };

  private tell(why: string): void {
    for (const forget of this.listeners) forget(why);
  }
}

/** "Press again": a press that makes the robot move counts once it is repeated, after the page has asked for that. */
export class Confirmation {
  private until_ms = -Infinity;
  private asked = false;

  constructor(consent: Consent, private readonly now: () => number = () => performance.now()) {
    consent.subscribe(() => { this.close(); });
  }

  /** True: confirmed. A double click is no confirmation, because nobody can have read the question. */
  press(): boolean {
    if (this.open && this.asked) {
      this.close();
      return true;
    }
    if (!this.open) this.asked = false;
    this.until_ms = this.now() + kConfirm_ms;
    return false;
  }

  /** Call when the page is drawn. True: it asks to press again. */
  show(): boolean {
    this.asked = this.open;
    return this.asked;
  }

  close(): void {
    this.until_ms = -Infinity;
  }

  private get open(): boolean {
    return this.now() < this.until_ms;
  }
}
