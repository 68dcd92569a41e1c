// Notifies of faults while the page is hidden, by a notification of the browser and by a sound. Both are off until the
// user switches them on; the choice is remembered.
import type { Event } from './messages.ts';
import type { Store } from './store.ts';

const kRemembered = 'tp100.alerts';
/** Events older than this, relative to the daemon's newest message, are repeats at the start of a connection. */
const kNew_s = 1;
/** Least time between two alerts, because one fault causes several events. */
const kQuiet_ms = 3000;

export interface Outlets {
  notify(title: string, text: string): void;
  beep(): void;
}

export class Alerts {
  private notifies_ = false;
  private sounds_ = false;
  private wasLow = false;
  private quietUntil_ms = -Infinity;

  constructor(
    private readonly outlets: Outlets,
    private readonly storage: Pick<Storage, 'getItem' | 'setItem'>,
    private readonly now: () => number = () => performance.now(),
  ) {
    const chosen = (storage.getItem(kRemembered) ?? '').split(' ');
    this.notifies_ = chosen.includes('notify');
    this.sounds_ = chosen.includes('sound');
  }

  get notifies(): boolean {
    return this.notifies_;
  }
  set notifies(on: boolean) {
    this.notifies_ = on;
    this.remember();
  }
  get sounds(): boolean {
    return this.sounds_;
  }
  set sounds(on: boolean) {
    this.sounds_ = on;
    this.remember();
  }

  /** Call for each message that the live robot's store has received. */
  received(topic: string, message: unknown, live: Store): void {
    if (topic === '/event') this.event(message as Event, live.get('/state')?.t_s);
    if (topic !== '/state') return;
    if (live.battery.low && !this.wasLow) this.raise('the battery is low', `${live.get('/state')?.battery_v?.toFixed(2) ?? ''} V`);
    this.wasLow = live.battery.low;
  }

  /** `now_s`: the daemon's newest time; undefined if none was received yet. */
  private event(event: Event, now_s: number | undefined): void {
    if (event.level !== 'error' || now_s === undefined || event.t_s < now_s - kNew_s) return;
    this.raise(event.text, [event.cause, event.fix].filter((text) => text !== '').join(': '));
  }

  private raise(title: string, text: string): void {
    const now_ms = this.now();
    if (now_ms < this.quietUntil_ms) return;
    this.quietUntil_ms = now_ms + kQuiet_ms;
    if (this.notifies_) this.outlets.notify(title, text);
    if (this.sounds_) this.outlets.beep();
  }

  private remember(): void {
    this.storage.setItem(kRemembered, [this.notifies_ ? 'notify' : '', this.sounds_ ? 'sound' : ''].filter(Boolean).join(' '));
  }
}
