// The view Analyse: recorded runs and signals; above them the recording that is replayed.
import { RunList } from '../panel/run_list.ts';
import { SignalPanel } from '../panel/signal_panel.ts';
import { Tabs } from '../panel/tabs.ts';
import type { Replay } from '../replay/replay.ts';
import { past } from '../state/service.ts';
import type { Store } from '../state/store.ts';
import type { Daemon } from './daemon.ts';
import { parseAddress, valueIn } from './views.ts';

export class AnalyseView {
  readonly tabs: Tabs;
  readonly runs: RunList;
  readonly signals = new SignalPanel(past);

  /** `shown`: the robot or the recording. `go`: shows the runs. */
  constructor(
    daemon: Daemon,
    private readonly replays: Replay,
    shown: () => Store,
    private readonly go: () => void,
  ) {
    // Before the address is completed, which forgets what is not replayed.
    addEventListener('hashchange', ({ newURL }) => { this.follow(new URL(newURL).hash); });
    this.runs = new RunList((file, run) => void replays.open(run.run, file.url), daemon.call);
    this.tabs = new Tabs('analyse', 'Analyse', [
      { id: 'runs', title: 'Runs', element: this.runs.element, show: () => { this.runs.show(daemon.connected && daemon.mayCommand, replays.run); } },
      { id: 'signals', title: 'Signals', element: this.signals.element, show: () => { this.signals.show(shown()); } },
    ]);
  }

  /** Opens the run that the address names, also one that is typed into an open page. */
  follow(hash: string): void {
    const run = valueIn(parseAddress(hash), 'replay');
    if (run !== undefined && run !== this.replays.run) void this.replays.open(run);
  }

  report(run: string): void {
    this.go();
    this.runs.report(run);
  }

  replay(run: string): void {
    this.go();
    void this.replays.open(run);
  }

  compare(run: string): void {
    this.go();
    void this.runs.compareWithBefore(run);
  }

  /** Whether the channels of every step are needed; those of a signal that is chosen always are. */
  needs(topic: string, shown: boolean): boolean {
    return (shown && this.tabs.selected === 'signals') || this.signals.needs(topic);
  }
}
