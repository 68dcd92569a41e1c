// Sends STOP to a daemon until it has accepted it: at once, or as the first request of the next connection.
import { StopButton } from '../state/stop.ts';
import type { Client } from './client.ts';

const kResend_ms = 250;

export class StopSender {
  readonly button = new StopButton();

  constructor(private readonly client: Pick<Client, 'ready' | 'call' | 'retryNow'>) {}

  press(now_ms: number): void {
    this.button.press(now_ms);
    if (this.client.ready) this.send();
    else this.client.retryNow();
  }

  /** The client is connected. */
  ready(): void {
    if (this.button.unsent) this.send();
  }

  private send(): void {
    this.button.sent();
    this.client.call('stop').then(
      (response) => {
        const answer = response as { acknowledged?: unknown; acknowledged_ms?: unknown } | undefined;
        const took_ms = typeof answer?.acknowledged_ms === 'number' ? answer.acknowledged_ms : null;
        this.button.answered(answer?.acknowledged === true, took_ms);
      },
      () => {
        // Refused or lost: send it again, soon or with the next connection.
        this.button.disconnected();
        setTimeout(() => {
          if (this.button.unsent && this.client.ready) this.send();
        }, kResend_ms);
      },
    );
  }
}
