// Driving by hand: holds the lease's token and sends the person's input while a person attends this
// page. It takes the lease only on request.
import type { State } from '../state/messages.ts';
import type { Inputs, KeyChange, Wish } from './inputs.ts';
import { reason, type Call } from '../state/service.ts';

export const kPeriod_ms = 40;
/** With this many calls unanswered, the connection is stalled: further input would only arrive late. */
const kMaxUnanswered = 5;

export interface Limits {
  speed_mps: number;
  yaw_rate_radps: number;
}

export class Driver {
  /** Share of the robot's limits, 0 to 1. */
  share = 0.5;
  limits: Limits = { speed_mps: 0.2, yaw_rate_radps: 1 };
  wish: Wish | undefined;
  private token: string | undefined;
  private taking = false;
  private wasDriven = false;
  private unanswered = 0;

  /**
   * `move` sends a request that makes the robot move, with the person's consent. `attended`: whether a person is at this page, which is visible and has the focus. `ended`: called when the lease is
   * lost, with the reason, or released here, with an empty text.
   */
  constructor(
    private readonly call: Call,
    private readonly move: Call,
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
      const answer = (await this.move('drive_take', {})) as { token?: unknown } | undefined;
      if (typeof answer?.token !== 'string') throw new Error('the daemon gave no token');
      this.token = answer.token;
      this.wasDriven = false;
      this.unanswered = 0;
      // The daemon dates the inputs by the time from the token to the first one.
      this.leave();
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
    // A failure does not matter: without input the daemon stops the robot.
    this.call('drive_release', { token }).catch(() => undefined);
    this.ended('');
  }

  /** Call when the connection has ended or STOP was pressed. */
  lose(why: string): void {
    if (!this.drives) return;
    this.forget();
    this.ended(why);
  }

  /** A key of the keyboard; true: this page drives by it. */
  key(code: string, change: KeyChange): boolean {
    // The release of a key counts even if this page no longer drives.
    if (!this.drives && change !== 'released') return false;
    const drives = this.inputs.key(code, change) && this.drives;
    if (drives) this.tick();
    return drives;
  }

  /** Call when the page loses the focus or is closed, or a key may have been lost: sends a standstill while it still can. */
  leave(): void {
    this.inputs.clear();
    if (this.drives) this.send(this.inputs.wish());
  }

  /** A state of the daemon was received. */
  received(state: State): void {
    if (!this.drives) return;
    if (state.run === 'driving') this.wasDriven = true;
    else if (this.wasDriven) this.lose(state.run === 'idle' ? 'the robot was disarmed' : `the drive is over: ${state.run}`);
  }

  /** Call every kPeriod_ms. */
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
        // A failure with an older token does not concern this one.
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
