// The recording that this page shows: loaded, played, closed.
import type { RunsList } from '../state/runs.ts';
import { fetched, reason, type Call } from '../state/service.ts';
import { Store } from '../state/store.ts';
import { Transport } from '../panel/transport.ts';
import { Player } from './player.ts';
import { loadRecording } from './recording.ts';

export class Replay {
  readonly transport = new Transport(() => { this.close(); }, () => { void this.mark(); });
  player: Player | undefined;
  /** The run that is loaded or shown; empty: none. */
  run = '';
  private loading: AbortController | undefined;

  constructor(
    /** Another recording is shown, or none. */
    private readonly changed: () => void,
    private readonly failed: (why: string) => void,
    private readonly call: Call,
  ) {}

  /** Marks the moment that is shown, in the note of the run. */
  private async mark(): Promise<void> {
    const player = this.player;
    const t_s = player?.t_s;
    if (player === undefined || t_s === undefined) return;
    try {
      await this.call('mark', { run: this.run, t_s });
      player.mark(t_s, 'mark');
      this.transport.showMarks(player);
    } catch (error: unknown) {
      this.failed(reason(error));
    }
  }

  async open(run: string, url = `/runs/${encodeURIComponent(run)}/run.mcap`): Promise<void> {
    this.loading?.abort();
    const mine = (this.loading = new AbortController());
    this.run = run;
    this.transport.loading(run, 0);
    this.changed();
    try {
      const frames = await loadRecording(url, (share) => { this.transport.loading(run, share); }, mine.signal);
      const list = await fetched('/api/runs').then((text) => (JSON.parse(text) as RunsList).runs, () => []);
      // Data of a recording does not age.
      this.player = new Player(frames, new Store(() => 0));
      for (const { t_s, text } of list.find((each) => each.run === run)?.marks ?? []) this.player.mark(t_s, text);
      this.transport.open(run, this.player);
      this.player.playing = true;
      this.changed();
    } catch (error: unknown) {
      if (mine.signal.aborted) return;
      this.close();
      this.failed(reason(error));
    }
  }

  close(): void {
    this.loading?.abort();
    this.player = undefined;
    this.run = '';
    this.transport.close();
    this.changed();
  }
}
