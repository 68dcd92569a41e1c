// The view Plan: courses, robot and set-up beside the map; a course is drawn on the map, and so is the robot's pose.
import { CourseEditor } from '../draw/editor.ts';
import { CourseList } from '../panel/course_list.ts';
import { h } from '../panel/dom.ts';
import { PlaceDrawing } from '../panel/place_drawing.ts';
import type { Viewport } from '../panel/viewport.ts';
import type { Daemon } from './daemon.ts';

export class PlanView {
  readonly element: HTMLElement;
  private readonly editor: CourseEditor;
  private readonly courses: CourseList;
  private readonly placing: PlaceDrawing;

  constructor(
    private readonly daemon: Daemon,
    private readonly viewport: Viewport,
  ) {
    this.editor = new CourseEditor(viewport, daemon.call, (on) => { this.drawCourse(on); });
    this.courses = new CourseList(daemon.call, (on) => { this.drawPlace(on); }, this.editor);
    this.placing = new PlaceDrawing(
      (at) => viewport.world(at),
      () => daemon.live.pose?.yaw_rad ?? 0,
      (pose) => {
        this.placing.show(false);
        this.courses.placed(pose);
      },
    );
    viewport.element.append(this.editor.stage.element, this.placing.element);
    this.element = h('section', { class: 'plan page', 'aria-label': 'Plan' }, this.courses.element, this.editor.element);
  }

  show(): void {
    this.courses.show(this.daemon.live, this.daemon.connected, this.daemon.mayCommand);
  }

  /** Shows the points of a draft where the map is now. */
  tick(): void {
    this.editor.tick(this.courses.changeable);
  }

  /** This view is shown, or another one, on whose map nothing is drawn: a draft stays for later. */
  look(shown: boolean): void {
    if (!shown && this.courses.placing) this.drawPlace(false);
    if (this.editor.active) this.editor.showOnMap(shown);
    if (shown && this.editor.active) this.viewport.set('map');
  }

  /** Begins or ends drawing of a pose. */
  private drawPlace(on: boolean): void {
    if (on) this.viewport.set('map');
    this.placing.show(on);
    this.courses.drawing(on);
  }

  /** Begins or ends drawing of a course; the editor replaces the list of courses. */
  private drawCourse(on: boolean): void {
    if (on) {
      this.drawPlace(false);
      this.viewport.set('map');
    }
    this.courses.element.hidden = on;
    document.body.classList.toggle('drawing', on);
  }
}
