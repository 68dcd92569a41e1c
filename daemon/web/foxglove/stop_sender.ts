// Sends STOP to a daemon until it has accepted it: at once, or as the first request of the next connection, and over a
// connection of its own if the answer takes long.
import { StopButton } from '../state/stop.ts';
import { Client, type ServerInfo } from './client.ts';
import type { Socket } from './connection.ts';

const kResend_ms = 250;
/** A daemon answers within 200 ms. After this time the connection may be slow or dead, though nothing has ended it. */
export const kSecondWay_ms = 300;

export class StopSender {
  readonly button = new StopButton();
  /** The connection that only STOP uses; undefined: none is needed. */
  private second: Client | undefined;

  /** `make`: a new connection to the same daemon; `mine`: whether it is the same. */
  constructor(
    private readonly client: Pick<Client, 'ready' | 'call' | 'retryNow'>,
    private readonly make: () => Socket,
    private readonly mine: (info: ServerInfo) => boolean = () => true,
  ) {}

  press(now_ms: number): void {
    this.button.press(now_ms);
    if (this.client.ready) this.send();
    else this.client.retryNow();
    if (this.second?.ready === true) this.sendBy(this.second).catch(() => undefined);
    else this.second?.retryNow();
    setTimeout(() => {
      if (this.button.unanswered) this.second ??= this.connect();
    }, kSecondWay_ms);
  }

  /** The client is connected. */
  ready(): void {
    if (this.button.unsent) this.send();
  }

  /** Ends the connection that only STOP uses. */
  end(): void {
    const second = this.second;
    this.second = undefined;
    second?.end();
  }

  private send(): void {
    this.button.sent();
    this.sendBy(this.client).catch(() => {
      // Refused or lost: send it again, soon or with the next connection.
      this.button.disconnected();
      setTimeout(() => {
        if (this.button.unsent && this.client.ready) this.send();
      }, kResend_ms);
    });
  }

  private async sendBy(client: Pick<Client, 'call'>): Promise<void> {
    const answer = (await client.call('stop')) as { acknowledged?: unknown; acknowledged_ms?: unknown } | undefined;
    this.button.answered(answer?.acknowledged === true, typeof answer?.acknowledged_ms === 'number' ? answer.acknowledged_ms : null);
    // Not before it is open: a browser reports a connection that is ended on its way as an error.
    if (this.second?.ready === true) this.end();
  }

  private connect(): Client {
    let mine = false;
    const second = new Client(this.make, {
      serverInfo: (info) => {
        mine = this.mine(info);
      },
      ready: () => {
        // Late, it would stop what was started in the meantime.
        if (mine && this.button.unanswered) this.sendBy(second).catch(() => undefined);
        else this.end();
      },
      closed: () => {
        if (!this.button.unanswered) this.end();
      },
    });
    return second;
  }
}
