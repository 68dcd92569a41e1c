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
/** The width of what is beside the view, and the height of the diagram, as they were dragged. */
const kSizes = ['side-width', 'plot-height'] as const;
const kStep_px = 20;
const kWindow_s = 60;
const kShortestWindow_s = 20;

/** What is dragged, or moved by arrows, to give a panel another size; a double click gives it its own again. */
function handle(name: (typeof kSizes)[number]): HTMLElement {
  const across = name === 'side-width';
  const element = h('div', { class: `handle ${name}`, role: 'separator', tabindex: '0', 'aria-valuenow': '0', 'aria-orientation': across ? 'vertical' : 'horizontal', 'aria-label': across ? 'Width of diagram and events' : 'Height of the diagram', title: 'Drag, or arrow keys; double click: as at first' });
  const panel = (): DOMRect | undefined => (across ? element.parentElement : element.parentElement?.querySelector('.plots'))?.getBoundingClientRect();
  const set = (size_px: number): void => {
    const most = across ? innerWidth - 420 : innerHeight - 260;
    const size = Math.round(Math.min(Math.max(size_px, across ? 260 : 140), most));
    document.body.style.setProperty(`--${name}`, `${size}px`);
    setAttribute(element, 'aria-valuenow', String(size));
    localStorage.setItem(`tp100.${name}`, String(size));
  };
  element.addEventListener('pointerdown', (event) => { element.setPointerCapture(event.pointerId); });
  element.addEventListener('pointermove', (event) => {
    const box = panel();
    if (element.hasPointerCapture(event.pointerId) && box !== undefined) set(across ? box.right - event.clientX : event.clientY - box.top);
  });
  element.addEventListener('keydown', ({ key }) => {
    const by = { ArrowLeft: 1, ArrowRight: -1, ArrowDown: 1, ArrowUp: -1 }[key];
    const box = panel();
    if (by !== undefined && box !== undefined && across === /Left|Right/.test(key)) set((across ? box.width : box.height) + by * kStep_px);
  });
  element.addEventListener('dblclick', () => {
    document.body.style.removeProperty(`--${name}`);
    localStorage.removeItem(`tp100.${name}`);
  });
  const kept = Number(localStorage.getItem(`tp100.${name}`));
  if (kept > 0) set(kept);
  return element;
}

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
    const [wide, high] = kSizes.map((name) => handle(name));
    this.side = h('aside', { class: 'side', id: 'side', 'aria-label': 'Diagram and events' }, wide ?? '', this.plots.element, this.past, high ?? '', this.events.element);
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
