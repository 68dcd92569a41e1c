// Drives by hand: holds the wheel's token and sends what the person wants, as long as there is a
// person at this page. It takes the wheel only on request.
import type { State } from '../state/messages.ts';
import type { Inputs, Wish } from './inputs.ts';
import { reason, type Call } from '../state/service.ts';

export const kPeriod_ms = 40;
/** More calls without an answer are a connection that stands still: more would only be late. */
const kMaxUnanswered = 5;

export interface Limits {
  speed_mps: number;
  yaw_rate_radps: number;
}

export class Driver {
  /** Of the robot's limits, 0 to 1. */
  share = 0.5;
  limits: Limits = { speed_mps: 0.2, yaw_rate_radps: 1 };
  wish: Wish | undefined;
  private token: string | undefined;
  private taking = false;
  private wasDriven = false;
  private unanswered = 0;

  /**
   * `attended`: there is a person at this page, which is visible and has the focus. `ended`: the wheel is lost or released,
   * with the reason, if it was not released here.
   */
  constructor(
    private readonly call: Call,
    private readonly inputs: Inputs,
    private readonly attended: () => boolean,
    private readonly ended: (why: string) => void,
  ) {}

  get drives(): boolean {
    return this.token !== undefined;
  }

  async take(): Promise<void> {
    if (this.drives || this.taking) return;
    this.taking = true;
    this.inputs.clear();
    try {
      const answer = (await this.call('drive_take', {})) as { token?: unknown } | undefined;
      if (typeof answer?.token !== 'string') throw new Error('the daemon gave no token');
      this.token = answer.token;
      this.wasDriven = false;
      this.unanswered = 0;
    } catch (error: unknown) {
      this.ended(reason(error));
    } finally {
      this.taking = false;
    }
  }

  release(): void {
    const token = this.token;
    if (token === undefined) return;
    this.forget();
    // The daemon stops the robot without input.
    this.call('drive_release', { token }).catch(() => undefined);
    this.ended('');
  }

  /** The connection ended, or STOP was pressed. */
  lose(why: string): void {
    if (!this.drives) return;
    this.forget();
    this.ended(why);
  }

  /** The focus or the page is gone: a standstill goes out while it still can. */
  leave(): void {
    this.inputs.clear();
    if (this.drives) this.send(this.inputs.wish());
  }

  /** Another state of the daemon. */
  received(state: State): void {
    if (!this.drives) return;
    if (state.run === 'driving') this.wasDriven = true;
    else if (this.wasDriven) this.lose(state.run === 'idle' ? 'the robot was disarmed' : `the drive is over: ${state.run}`);
  }

  /** Call it every kPeriod_ms. */
  tick(): void {
    if (!this.drives || !this.attended()) return;
    this.send(this.inputs.wish());
  }

  private send(wish: Wish): void {
    const token = this.token;
    this.wish = wish;
    if (this.unanswered >= kMaxUnanswered) return;
    ++this.unanswered;
    const request = {
      token,
      speed_mps: wish.forward * this.share * this.limits.speed_mps,
      yaw_rate_radps: wish.left * this.share * this.limits.yaw_rate_radps,
      input_ms: wish.at_ms,
    };
    this.call('drive', request).then(
      () => {
        this.unanswered = Math.max(0, this.unanswered - 1);
      },
      (error: unknown) => {
        // An answer for an older token says nothing about this one.
        if (token === this.token) this.lose(reason(error));
      },
    );
  }

  private forget(): void {
    this.token = undefined;
    this.wish = undefined;
    this.inputs.clear();
  }
}
