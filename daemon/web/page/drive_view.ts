// The view Drive: the robot on its course, the figures, one diagram and the events. Analyse shows a recording in the same
// place.
import { CameraImagePanel } from '../panel/camera_image.ts';
import { button, h, icon, setAttribute } from '../panel/dom.ts';
import type { DrivePanel } from '../panel/drive_panel.ts';
import { EventLog } from '../panel/event_log.ts';
import { Numbers } from '../panel/numbers.ts';
import { Plots } from '../panel/plots.ts';
import type { RunCard } from '../panel/run_card.ts';
import { SceneWords } from '../panel/scene_words.ts';
import { Timeline } from '../panel/timeline.ts';
import type { Transport } from '../panel/transport.ts';
import type { Viewport } from '../panel/viewport.ts';
import type { Player } from '../replay/player.ts';
import type { Daemon } from './daemon.ts';
import { kHistory_s, type Store } from '../state/store.ts';

const kFolded = 'tp100.folded';
const kWindow_s = 60;
const kShortestWindow_s = 20;

export class DriveView {
  /** Beside the view of the course. */
  readonly side: HTMLElement;
  private readonly fold: HTMLButtonElement;
  private readonly words = new SceneWords();
  private readonly image = new CameraImagePanel();
  private readonly timeline = new Timeline();
  private readonly numbers = new Numbers();
  private readonly plots = new Plots();
  private readonly events = new EventLog();
  private readonly past = button({ class: 'control past', hidden: '' }, 'Load the last minute', () => { this.daemon.loadPast(); });

  constructor(
    private readonly viewport: Viewport,
    drive: DrivePanel,
    private readonly card: RunCard,
    private readonly transport: Transport,
    private readonly daemon: Pick<Daemon, 'lacksPast' | 'loadPast'>,
  ) {
    viewport.element.append(this.words.element, this.image.element, drive.element, this.card.element, transport.element, this.timeline.element, this.numbers.element);
    this.fold = button({ class: 'fold', 'aria-controls': 'side' }, icon('fold'), () => { this.show(this.fold.getAttribute('aria-expanded') !== 'true'); });
    viewport.element.append(this.fold);
    this.side = h('aside', { class: 'side', id: 'side', 'aria-label': 'Diagram and events' }, this.plots.element, this.past, this.events.element);
    this.show(localStorage.getItem(kFolded) === null);
  }

  /** Shows or folds the diagram and the events; remembered. */
  private show(open: boolean): void {
    if (open) localStorage.removeItem(kFolded);
    else localStorage.setItem(kFolded, 'yes');
    document.body.classList.toggle('folded', !open);
    setAttribute(this.fold, 'aria-expanded', String(open));
    setAttribute(this.fold, 'aria-label', open ? 'Fold diagram and events' : 'Show diagram and events');
  }

  /** `player`: of the recording that is shown; undefined: the robot. */
  look(player: Player | undefined): void {
    this.plots.window_s = player === undefined ? kWindow_s : Math.min(Math.max(player.duration_s, kShortestWindow_s), kHistory_s);
  }

  /** The image of the same moment as the course. */
  showImage(store: Store, began_unix_s: number | undefined): void {
    this.image.show(store, began_unix_s);
  }

  showFigures(store: Store): void {
    if (!this.viewport.visible) return;
    this.transport.show();
    this.numbers.show(store);
    this.timeline.show(store);
    this.plots.show(store);
    this.past.hidden = !this.daemon.lacksPast;
  }

  showWords(live: Store, store: Store, replayed: boolean, began_unix_s: number | undefined, now_ms: number): void {
    this.card.show(live);
    this.words.show(store, replayed, now_ms);
    this.events.show(store, began_unix_s);
  }
}
