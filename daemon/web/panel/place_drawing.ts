// Drawing of a pose on the map: press where the robot is, drag in the direction in which it points.
import type { Point2 } from '../scene/geometry.ts';
import type { FloorPose } from '../state/messages.ts';
import { h, setAttribute, svg } from './dom.ts';

/** A shorter drag gives no direction. */
const kShortest_px = 12;

export class PlaceDrawing {
  readonly element = h('div', { class: 'placing', hidden: '' });
  private readonly arrow = svg('line');
  private from: Point2 | undefined;

  constructor(
    /** World coordinates of a point of the map. */
    private readonly world: (at: Point2) => Point2 | undefined,
    /** The robot's yaw, for a press without a drag. */
    private readonly yaw_rad: () => number,
    /** Called at the end, without a pose if the map is no longer shown. */
    private readonly done: (pose: FloorPose | undefined) => void,
  ) {
    const image = svg('svg');
    image.append(this.arrow);
    this.element.append(image);
    this.element.addEventListener('pointerdown', (event) => {
      if (!event.isPrimary) return;
      this.element.setPointerCapture(event.pointerId);
      this.from = this.at(event);
      this.draw(this.from);
    });
    this.element.addEventListener('pointermove', (event) => {
      if (this.from !== undefined) this.draw(this.at(event));
    });
    this.element.addEventListener('pointercancel', () => {
      this.from = undefined;
    });
    this.element.addEventListener('pointerup', (event) => {
      this.finish(this.at(event));
    });
  }

  show(on: boolean): void {
    this.element.hidden = !on;
    this.from = undefined;
    this.arrow.style.display = 'none';
  }

  private at(event: PointerEvent): Point2 {
    const box = this.element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  private draw(to: Point2): void {
    const from = this.from ?? to;
    this.arrow.style.display = '';
    for (const [name, value] of [['x1', from.x], ['y1', from.y], ['x2', to.x], ['y2', to.y]] as const)
      setAttribute(this.arrow, name, value.toFixed(1));
  }

  private finish(to: Point2): void {
    const from = this.from;
    this.from = undefined;
    if (from === undefined) return;
    const place = this.world(from);
    const ahead = this.world(to);
    if (place === undefined || ahead === undefined) {
      this.done(undefined);
      return;
    }
    const turned = Math.hypot(to.x - from.x, to.y - from.y) >= kShortest_px;
    const yaw_rad = turned ? Math.atan2(ahead.y - place.y, ahead.x - place.x) : this.yaw_rad();
    this.done({ x_m: place.x, y_m: place.y, yaw_rad });
  }
}
