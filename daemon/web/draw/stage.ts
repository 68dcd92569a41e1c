// The handles of a draft over the map: moved with mouse, pen or finger, and with the arrow keys.
import { setAttribute, setClass, svg } from '../panel/dom.ts';
import type { Point2 } from '../scene/geometry.ts';
import type { Handle, Selected } from './draft.ts';

/** Larger than the drawn handle, so that a finger can hit it. */
const kReach_px = 18;
const kNudge_m = 0.01;
const kFarNudge_m = 0.1;
const kArrows: Record<string, Point2> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: 1 },
  ArrowDown: { x: 0, y: -1 },
};

export interface StageActions {
  select(handle: Handle): void;
  /** A handle is moved to a point of the floor; `over`: the gesture has ended. */
  move(handle: Handle, to: Point2, over: boolean): void;
  /** The floor was pressed where there is no handle. */
  press(at: Point2): void;
  remove(handle: Handle): void;
  /** Zooms; a larger factor shows more. */
  zoom(factor: number): void;
}

export class DrawStage {
  readonly element = svg('svg', { class: 'draw-stage', role: 'group', 'aria-label': 'Points of the course' });
  private readonly knobs = new Map<string, SVGGElement>();
  private handles: readonly Handle[] = [];
  private dragged: { id: string; pointer: number } | undefined;

  constructor(
    /** Converts a point of the floor to one of the map, and back; undefined while no map is shown. */
    private readonly pixel: (at: Point2) => Point2 | undefined,
    private readonly world: (at: Point2) => Point2 | undefined,
    private readonly actions: StageActions,
  ) {
    this.element.style.display = 'none';
    this.element.addEventListener('pointerdown', (event) => {
      this.down(event);
    });
    this.element.addEventListener('pointermove', (event) => {
      this.drag(event, false);
    });
    for (const end of ['pointerup', 'pointercancel'] as const) {
      this.element.addEventListener(end, (event) => {
        this.drag(event, true);
      });
    }
    this.element.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        actions.zoom(event.deltaY > 0 ? 1.1 : 1 / 1.1);
      },
      { passive: false },
    );
  }

  show(on: boolean): void {
    this.element.style.display = on ? '' : 'none';
    this.dragged = undefined;
  }

  get dragging(): boolean {
    return this.dragged !== undefined;
  }

  /** Positions the handles on the map; cheap if nothing has changed. */
  draw(handles: readonly Handle[], selected: Selected | undefined): void {
    this.handles = handles;
    const gone = new Set(this.knobs.keys());
    for (const handle of handles) {
      gone.delete(handle.id);
      const knob = this.knobs.get(handle.id) ?? this.make(handle);
      const at = this.pixel(handle.at);
      knob.style.display = at === undefined ? 'none' : '';
      if (at !== undefined) setAttribute(knob, 'transform', `translate(${at.x.toFixed(1)} ${at.y.toFixed(1)})`);
      setAttribute(knob, 'aria-label', `${handle.label}: x ${handle.at.x.toFixed(2)} m, y ${handle.at.y.toFixed(2)} m`);
      setAttribute(knob, 'data-of', handle.piece.table);
      setClass(knob, 'turns', handle.turns);
      setClass(knob, 'selected', handle.piece.table === selected?.table && handle.piece.index === selected.index);
    }
    for (const id of gone) {
      this.knobs.get(id)?.remove();
      this.knobs.delete(id);
    }
  }

  private make(handle: Handle): SVGGElement {
    const { id } = handle;
    const knob = svg('g', { class: 'knob', 'data-handle': id, tabindex: '0', role: 'button' });
    knob.append(svg('circle', { class: 'knob-reach', r: String(kReach_px) }), svg('circle', { class: 'knob-dot', r: '6' }));
    knob.addEventListener('focus', () => {
      const now = this.handle(id);
      if (now !== undefined) this.actions.select(now);
    });
    knob.addEventListener('keydown', (event) => {
      this.key(event, id);
    });
    this.knobs.set(id, knob);
    this.element.append(knob);
    return knob;
  }

  private handle(id: string): Handle | undefined {
    return this.handles.find((each) => each.id === id);
  }

  private key(event: KeyboardEvent, id: string): void {
    const handle = this.handle(id);
    const arrow = kArrows[event.key];
    if (handle === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    if (arrow !== undefined) {
      const step = event.shiftKey ? kFarNudge_m : kNudge_m;
      this.actions.move(handle, { x: handle.at.x + step * arrow.x, y: handle.at.y + step * arrow.y }, true);
    } else if (event.key === 'Delete' || event.key === 'Backspace') this.actions.remove(handle);
    else return;
    event.preventDefault();
  }

  private at(event: PointerEvent): Point2 | undefined {
    const box = this.element.getBoundingClientRect();
    return this.world({ x: event.clientX - box.left, y: event.clientY - box.top });
  }

  private down(event: PointerEvent): void {
    if (!event.isPrimary || event.button !== 0) return;
    event.preventDefault();
    const id = this.nearest(event);
    if (id === undefined) {
      const at = this.at(event);
      if (at !== undefined) this.actions.press(at);
      return;
    }
    this.element.setPointerCapture(event.pointerId);
    this.dragged = { id, pointer: event.pointerId };
    this.knobs.get(id)?.focus();
  }

  /** The nearest of the handles within reach. */
  private nearest(event: PointerEvent): string | undefined {
    const box = this.element.getBoundingClientRect();
    let [best, least]: [string | undefined, number] = [undefined, kReach_px];
    for (const { id, at } of this.handles) {
      const point = this.pixel(at);
      if (point === undefined) continue;
      const distance = Math.hypot(point.x - event.clientX + box.left, point.y - event.clientY + box.top);
      if (distance < least) [best, least] = [id, distance];
    }
    return best;
  }

  private drag(event: PointerEvent, over: boolean): void {
    if (event.pointerId !== this.dragged?.pointer) return;
    const handle = this.handle(this.dragged.id);
    const to = this.at(event);
    if (over) this.dragged = undefined;
    if (handle !== undefined && to !== undefined) this.actions.move(handle, to, over);
  }
}
