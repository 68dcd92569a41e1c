// The view of the course with legend and cameras: 3-D if WebGL works, else a map.
import { bounds, zoomed, type Bounds, type Point2 } from '../scene/geometry.ts';
import { MapView } from '../scene/map_view.ts';
import type { SceneView } from '../scene/scene_view.ts';
import { kCameraModes, type View } from '../scene/view.ts';
import type { Course } from '../state/messages.ts';
import { kEstimates, type EstimateName, type Store } from '../state/store.ts';
import { button, h, setAttribute, setClass } from './dom.ts';
import { kHelp } from './help.ts';

const kModes = [...kCameraModes, 'map'] as const;
type Mode = (typeof kModes)[number];

const kZoom = 1.4;
const kAbout: Record<Mode, string> = { chase: 'From behind the robot', top: 'From above the robot', free: 'From where you turn it', map: 'Plan of the course' };

export class Viewport {
  readonly element = h('section', { class: 'viewport', 'aria-label': 'Course' });
  private readonly stage = h('div', { class: 'stage' });
  private readonly zooms = h('div', { class: 'zooms', role: 'group', 'aria-label': 'Zoom of the map' });
  private readonly buttons = new Map<Mode, HTMLButtonElement>();
  private readonly toggles = new Map<EstimateName, HTMLButtonElement>();
  private readonly steers = new Map<EstimateName, HTMLElement>();
  private readonly hidden = new Set<EstimateName>();
  private view: View;
  private mode: Mode = 'free';
  /** What was last asked for: the map is shown until the scene is loaded. */
  private wanted: Mode = 'free';
  private makeScene: typeof SceneView | undefined;
  private loads = false;
  private webgl = true;
  private course: Course | undefined;
  private courseShown = -1;
  private drafted = false;
  private frame: Bounds | undefined;
  private store: Store | undefined;

  constructor() {
    const modes = h('div', { class: 'modes', role: 'group', 'aria-label': 'Camera' });
    for (const mode of kModes) {
      const camera = button({ 'aria-pressed': 'false', id: `camera-${mode}`, title: `${kAbout[mode]} (c: the next one)` }, mode, () => { this.set(mode); });
      this.buttons.set(mode, camera);
      modes.append(camera);
    }
    const key = h('div', { class: 'key', role: 'group', 'aria-label': 'Paths' });
    const plan = h('i', { class: 'swatch dashed' });
    plan.style.color = 'var(--path)';
    key.append(h('span', { class: 'key-item', title: kHelp.plan }, plan, 'plan'));
    const fence = h('i', { class: 'swatch' });
    fence.style.color = 'var(--fence)';
    key.append(h('span', { class: 'key-item key-fence', title: kHelp.fence }, fence, 'fence'));
    for (const name of kEstimates) {
      const swatch = h('i', { class: 'swatch' });
      swatch.style.color = `var(--${name})`;
      const toggle = button({ class: 'key-item', 'aria-pressed': 'true', id: `show-${name}`, title: kHelp[name] }, swatch, () => { this.toggle(name); });
      const steers = h('span', { class: 'key-steers', title: kHelp.steering, hidden: '' }, 'steers');
      toggle.append(name, steers);
      this.steers.set(name, steers);
      this.toggles.set(name, toggle);
      key.append(toggle);
    }
    const zooms = ([['in', '+', 'Nearer, around the robot'], ['out', '\u2212', 'Farther'], ['fit', 'fit', 'The whole course']] as const).map(([id, text, title]) =>
      button({ id: `zoom-${id}`, title }, text, () => { this.zoom(id); }),
    );
    this.zooms.append(...zooms);
    this.element.append(this.stage, key, modes, this.zooms);
    // Rendering 3-D on the processor would leave little of it for the robot's loop: begin with the map.
    const drawnBy = webglDrawnBy();
    if (drawnBy === 'nothing') this.withoutWebgl();
    this.view = this.make('map');
    this.set(drawnBy === 'card' ? 'free' : 'map');
    // Drawn at once, because a canvas is empty after its size has changed.
    new ResizeObserver(() => {
      this.view.resize();
      if (this.store !== undefined) this.view.draw(this.store, this.left_out, 0);
    }).observe(this.stage);
  }

  /** Whether the page shows it. */
  get visible(): boolean {
    return this.stage.clientHeight > 0;
  }

  set(mode: Mode): void {
    if (mode !== 'map' && !this.webgl) return;
    this.wanted = mode;
    if (this.view instanceof MapView !== (mode === 'map')) this.renew(mode);
    this.mode = this.view instanceof MapView ? 'map' : mode;
    this.view.setCamera(this.mode);
    this.mark();
  }

  /** Redraws everything in the colours of the current theme. */
  recolour(): void {
    this.renew(this.mode);
    this.view.setCamera(this.mode);
  }

  private renew(mode: Mode): void {
    this.view.dispose();
    this.view = this.make(mode);
  }

  next(): void {
    const all: readonly Mode[] = this.webgl ? kModes : ['map'];
    this.set(all[(all.indexOf(this.wanted) + 1) % all.length] ?? 'map');
  }

  /** World coordinates of a point of the map; undefined while no map is shown. */
  world(at: Point2): Point2 | undefined {
    return this.view instanceof MapView ? this.view.world(at) : undefined;
  }

  /** The point of the map at world coordinates; undefined while no map is shown. */
  pixel(at: Point2): Point2 | undefined {
    return this.view instanceof MapView ? this.view.point(at) : undefined;
  }

  /** Shows a draft in that frame instead of the course in force; undefined: the course again. */
  draft(course: Course | undefined, frame: Bounds | undefined): void {
    this.drafted = course !== undefined;
    this.frame = frame;
    if (course === undefined) this.courseShown = -1;
    else this.setCourse(course);
  }

  private setCourse(course: Course | undefined): void {
    this.course = course;
    this.view.setCourse(course, this.frame);
  }

  draw(store: Store, dt_s: number): void {
    this.store = store;
    if (!this.visible) return;
    const received = store.received['/course'] ?? 0;
    if (received !== this.courseShown && !this.drafted) {
      this.courseShown = received;
      this.frame = undefined;
      this.setCourse(store.get('/course'));
    }
    this.showKey(store);
    setClass(this.element, 'stale', store.stale('/estimate'));
    this.view.draw(store, this.left_out, dt_s);
  }

  /** Call when the data source changes: clears the drawing of the old one. */
  reset(): void {
    this.view.reset();
  }

  /** The legend: what there is to see, and which estimate steers. */
  private showKey(store: Store): void {
    const estimate = store.get('/estimate');
    for (const [name, toggle] of this.toggles) {
      const absent = (name === 'truth' && !estimate?.truth) || (name === 'fused' && !store.usesCamera);
      if (toggle.hidden === absent) continue;
      toggle.hidden = absent;
      this.view.reset();
    }
    for (const [name, steers] of this.steers) steers.hidden = name !== estimate?.steering;
  }

  /** What is not drawn. */
  private get left_out(): ReadonlySet<EstimateName> {
    return this.toggles.get('fused')?.hidden === true ? new Set([...this.hidden, 'fused'] as const) : this.hidden;
  }

  private zoom(how: 'in' | 'out' | 'fit'): void {
    const pose = this.store?.pose;
    const box = this.frame ?? bounds(this.course);
    const near = how === 'in' && pose !== undefined ? { x: pose.x_m, y: pose.y_m } : undefined;
    this.frame = how === 'fit' ? undefined : zoomed(box, how === 'in' ? 1 / kZoom : kZoom, near);
    this.setCourse(this.course);
  }

  private toggle(name: EstimateName): void {
    if (!this.hidden.delete(name)) this.hidden.add(name);
    this.view.reset();
    const button = this.toggles.get(name);
    if (button) setAttribute(button, 'aria-pressed', String(!this.hidden.has(name)));
  }

  private make(mode: Mode): View {
    const view = this.scene(mode) ?? new MapView();
    this.stage.replaceChildren(view.element);
    view.element.setAttribute('aria-hidden', 'true');
    view.resize();
    view.setCourse(this.course, this.frame);
    return view;
  }

  private scene(mode: Mode): View | undefined {
    if (mode === 'map' || !this.webgl) return undefined;
    if (this.makeScene === undefined) {
      this.load();
      return undefined;
    }
    try {
      return new this.makeScene(
        () => {
          this.mode = this.wanted = 'free';
          this.mark();
        },
        () => {
          this.withoutWebgl();
          this.set('map');
        },
      );
    } catch {
      this.withoutWebgl();
      return undefined;
    }
  }

  /** The scene's library is most of the page: on a slow link everything else comes first. */
  private load(): void {
    if (this.loads) return;
    this.loads = true;
    import('../scene/scene_view.ts').then(
      (scene) => {
        this.makeScene = scene.SceneView;
        this.set(this.wanted);
      },
      () => { this.loads = false; },
    );
  }

  private withoutWebgl(): void {
    this.webgl = false;
    for (const mode of kCameraModes) {
      const button = this.buttons.get(mode);
      if (button === undefined) continue;
      button.disabled = true;
      button.title = 'This browser has no WebGL';
    }
  }

  private mark(): void {
    for (const [mode, button] of this.buttons) setAttribute(button, 'aria-pressed', String(mode === this.mode));
    this.zooms.hidden = this.mode !== 'map';
  }
}

/** Checked first, because the scene's library logs errors to the console. */
function webglDrawnBy(): 'card' | 'processor' | 'nothing' {
  const context = document.createElement('canvas').getContext('webgl2');
  if (context === null) return 'nothing';
  const info = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(info?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name) ? 'processor' : 'card';
}
