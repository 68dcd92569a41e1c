// The editor of a course: its points over the map, its values and its text in the drawer; the daemon checks changes.
import { button, h, Message, setAttribute, setClass, setText } from '../panel/dom.ts';
import type { Viewport } from '../panel/viewport.ts';
import type { Bounds, Point2 } from '../scene/geometry.ts';
import { kDefaultShape } from '../scene/robot_model.ts';
import type { RobotShape } from '../state/messages.ts';
import { nameOf, type CourseCheck } from '../state/setup.ts';
import { CourseText, type Piece, type Value } from './course_text.ts';
import { added, beyond, draftCourse, find, handles, kEmptyCourse, withCorner, withoutCorner, type Handle, type Selected, type Tool } from './draft.ts';
import { fields } from './fields.ts';
import { History } from './history.ts';
import { frameOf, zoomed } from './framing.ts';
import { DrawStage } from './stage.ts';
import { reason, type Call } from '../state/service.ts';

const kCheckAfter_ms = 150;
const kTools: [tool: Tool, title: string][] = [
  ['line', 'Line'],
  ['arc', 'Arc'],
  ['pivot', 'Turn'],
  ['ramp', 'Ramp'],
  ['block', 'Block'],
  ['surface', 'Surface'],
  ['disturbance', 'Disturbance'],
  ['keep_out', 'Keep-out'],
];

export class CourseEditor {
  readonly element = h('div', { class: 'draw', hidden: '' });
  readonly stage: DrawStage;
  private readonly name = h('input', { type: 'text', name: 'course-name', 'aria-label': 'Name of the course', maxlength: '64' });
  private readonly text = h('textarea', { rows: '14', spellcheck: 'false', 'aria-label': 'Text of the course file' });
  private readonly verdict = new Message('draw-verdict');
  private readonly fieldsBox = h('div');
  private readonly replaceButton = deed('draw-replace', 'Replace it', () => void this.save(true));
  private readonly undoButton = deed('draw-undo', 'Undo', () => { this.take(this.history.go(-1)); });
  private readonly redoButton = deed('draw-redo', 'Redo', () => { this.take(this.history.go(1)); });
  private readonly deleteButton = deed('draw-delete', 'Delete', () => { this.remove(); });
  private readonly cornerButton = deed('draw-corner', 'Add corner', () => { this.addCorner(); });
  private readonly closeButton = deed('draw-close', 'Close', () => {
    const lost = this.course.text !== this.saved || this.text.value !== this.course.text;
    if (lost && this.closeButton.textContent === 'Close') setText(this.closeButton, 'Discard the changes');
    else this.close();
  });
  private readonly saves = [['draw-save', 'Save'], ['draw-use', 'Save and choose']].map(([id = '', text = '']) =>
    deed(id, text, () => {
      this.chooses = id === 'draw-use';
      void this.save(false);
    }),
  );
  private readonly tools = new Map<Tool, HTMLButtonElement>();
  private readonly history = new History();
  private course = new CourseText('');
  private handles_: Handle[] = [];
  private selected: Selected | undefined;
  private corner: number | undefined;
  private tool: Tool | undefined;
  private frame: Bounds | undefined;
  private changed = false;
  private opened = '';
  private saved = '';
  private shownFields = '';
  private checkAt_ms = Infinity;
  private checking = false;
  private chooses = false;

  constructor(
    /** The map under the draft. */
    private readonly map: Pick<Viewport, 'draft' | 'pixel' | 'world'>,
    private readonly call: Call,
    private readonly robot: () => RobotShape | undefined,
    /** Called when drawing begins or ends. */
    private readonly opens: (on: boolean) => void,
  ) {
    this.stage = new DrawStage((at) => map.pixel(at), (at) => map.world(at), {
      select: (handle) => { this.select(handle); },
      move: (handle, to, over) => { this.edit(() => handle.drag(rounded(to)), over); },
      press: (at) => { this.press(at); },
      remove: (handle) => { this.select(handle); this.remove(); },
      zoom: (factor) => { this.zoom(factor); },
    });
    this.build();
  }

  get active(): boolean {
    return !this.element.hidden;
  }

  /** Opens a file; `own`: it may be replaced under its name. */
  open(name: string, text: string, own: boolean): void {
    this.opened = own ? name : '';
    this.saved = text;
    this.name.value = name;
    this.element.hidden = false;
    this.selected = this.corner = undefined;
    this.pick(undefined);
    this.say('');
    this.history.restart(text);
    this.course = new CourseText('');
    this.take(text);
    this.fit();
    this.stage.show(true);
    this.opens(true);
  }

  openNew(taken: readonly string[]): void {
    let number = 1;
    while (taken.includes(`drawn-${number}`)) number++;
    this.open(`drawn-${number}`, kEmptyCourse, false);
    this.pick('line');
  }

  close(): void {
    this.element.hidden = true;
    this.checkAt_ms = Infinity;
    this.stage.show(false);
    this.map.draft(undefined, undefined);
    this.opens(false);
  }

  /** Draws changes, and has them checked by the daemon once nothing has changed for a moment. */
  tick(now_ms: number, mayChange: boolean): void {
    if (!this.active) return;
    if (this.changed) {
      this.changed = false;
      this.map.draft(draftCourse(this.course, this.name.value, this.robot() ?? kDefaultShape), this.frame);
    }
    this.stage.draw(this.handles_, this.selected);
    this.undoButton.disabled = !this.history.can(-1);
    this.redoButton.disabled = !this.history.can(1);
    const piece = this.selected && find(this.course, this.selected);
    this.deleteButton.disabled = piece === undefined || ['start', 'fence', ''].includes(piece.table) && this.corner === undefined;
    this.cornerButton.disabled = this.corner === undefined;
    for (const save of this.saves) save.disabled = !mayChange;
    this.replaceButton.disabled = !mayChange;
    const shown = JSON.stringify([this.course.one('').values, this.selected, piece?.values]);
    if (shown !== this.shownFields && !this.stage.dragging && !this.fieldsBox.contains(document.activeElement)) {
      this.shownFields = shown;
      this.fieldsBox.replaceChildren(...[this.course.one(''), piece].filter((each) => each !== undefined).map((each) => this.fieldsOf(each)));
    }
    if (now_ms >= this.checkAt_ms && !this.checking) void this.check();
  }

  private build(): void {
    const bar = h('div', { class: 'draw-bar', role: 'toolbar', 'aria-label': 'Draw' });
    for (const [tool, title] of kTools) {
      const element = deed(`draw-${tool}`, title, (event) => {
        // Pressed by key: the piece is added beyond the end of the path.
        if (event.detail === 0) this.add(tool, beyond(this.course));
        else this.pick(this.tool === tool ? undefined : tool);
      });
      setAttribute(element, 'aria-pressed', 'false');
      this.tools.set(tool, element);
      bar.append(element);
    }
    bar.append(this.cornerButton, this.deleteButton, this.undoButton, this.redoButton, deed('draw-fit', 'Fit', () => { this.fit(); }));
    this.closeButton.addEventListener('blur', () => { setText(this.closeButton, 'Close'); });
    this.text.addEventListener('input', () => { this.take(this.text.value, false); });
    this.text.addEventListener('change', () => { this.history.add(this.text.value); });
    this.element.addEventListener('keydown', (event) => { this.key(event); });
    this.stage.element.addEventListener('keydown', (event) => { this.key(event); });
    this.element.append(
      bar,
      h('div', { class: 'draw-answer' }, this.verdict.element, this.replaceButton),
      h('div', { class: 'draw-file' }, h('label', {}, 'name ', this.name), ...this.saves, this.closeButton),
      this.fieldsBox,
      h('details', {}, h('summary', {}, 'Text of the file'), this.text),
    );
  }

  private key(event: KeyboardEvent): void {
    if (!(event.ctrlKey || event.metaKey) || event.target === this.text) return;
    const key = event.key.toLowerCase();
    if (key !== 'z' && key !== 'y') return;
    event.preventDefault();
    this.take(key === 'y' || event.shiftKey ? this.history.go(1) : this.history.go(-1));
  }

  private pick(tool: Tool | undefined): void {
    this.tool = tool;
    for (const [each, element] of this.tools) setAttribute(element, 'aria-pressed', String(each === tool));
    setClass(this.stage.element, 'adds', tool !== undefined);
  }

  private press(at: Point2): void {
    if (this.tool === undefined) return;
    this.add(this.tool, at);
    // Path tools stay selected for the next point; other tools add one piece.
    if (this.tool !== 'line' && this.tool !== 'arc') this.pick(undefined);
  }

  private add(tool: Tool, at: Point2): void {
    this.edit(() => {
      const next = added(this.course, tool, rounded(at));
      this.selected = next.piece;
      this.corner = undefined;
      return next.text;
    }, true);
  }

  private select(handle: Handle): void {
    this.selected = handle.piece;
    const corner = /^(fence|keep_out)-\d+-(\d+)$/.exec(handle.id);
    this.corner = corner === null ? undefined : Number(corner[2]);
  }

  private addCorner(): void {
    const piece = this.selected && find(this.course, this.selected);
    const corner = this.corner;
    if (piece !== undefined && corner !== undefined) this.edit(() => withCorner(this.course, piece, corner), true);
  }

  private remove(): void {
    const piece = this.selected && find(this.course, this.selected);
    const corner = this.corner;
    if (piece === undefined) return;
    this.edit(() => {
      const less = corner === undefined ? this.course.text : withoutCorner(this.course, piece, corner);
      if (less !== this.course.text) return less;
      return ['start', 'fence', ''].includes(piece.table) ? less : this.course.removed(piece);
    }, true);
    this.corner = undefined;
  }

  /** Changes the text; `over`: the change is complete and becomes one step of undo. */
  private edit(change: () => string, over: boolean): void {
    try {
      this.take(change());
      if (over) this.history.add(this.course.text);
    } catch (error: unknown) {
      this.say(reason(error), true);
    }
  }

  private take(text: string, show = true): void {
    if (show && this.text.value !== text) this.text.value = text;
    this.checkAt_ms = performance.now() + kCheckAfter_ms;
    try {
      this.course = new CourseText(text);
    } catch {
      // The daemon reports the error; the map keeps the last text that could be read.
      return;
    }
    this.handles_ = handles(this.course);
    this.changed = true;
    // At once, because the next key may come before the next frame.
    if (this.active) this.stage.draw(this.handles_, this.selected);
  }

  private fit(): void {
    this.frame = frameOf(draftCourse(this.course, '', kDefaultShape));
    this.changed = true;
  }

  private zoom(factor: number): void {
    if (this.frame !== undefined) this.frame = zoomed(this.frame, factor);
    this.changed = true;
  }

  private fieldsOf(piece: Piece): HTMLElement {
    const selected: Selected = { table: piece.table, index: piece.index };
    return fields(piece, (key: string, value: Value) => {
      const now = find(this.course, selected);
      if (now !== undefined) this.edit(() => this.course.with(now, { [key]: value }), true);
    });
  }

  private async check(): Promise<void> {
    this.checking = true;
    this.checkAt_ms = Infinity;
    try {
      const answer = (await this.call('file_check', { kind: 'course', name: nameOf(this.name.value) || 'course', text: this.text.value })) as CourseCheck;
      const place = answer.line === undefined ? '' : `line ${answer.line}, column ${answer.column ?? 1}: `;
      const figures = `${answer.length_m?.toFixed(2) ?? ''} m, about ${answer.duration_s?.toFixed(0) ?? '?'} s`;
      if (answer.error !== '') this.say(place + answer.error, true);
      else if (answer.why_not !== '') this.say(`${answer.length_m?.toFixed(2) ?? ''} m; ${answer.why_not}`, true);
      else this.say(figures);
    } catch (error: unknown) {
      this.say(reason(error), true);
    } finally {
      this.checking = false;
    }
  }

  private async save(replace: boolean): Promise<void> {
    const name = this.name.value;
    const text = this.text.value;
    try {
      await this.call('file_save', { kind: 'course', name, text, replace: replace || name === this.opened });
      this.opened = name;
      this.saved = text;
      this.say(`${name} is saved.`);
      if (!this.chooses) return;
      await this.call('choose', { course: name });
      this.close();
    } catch (error: unknown) {
      const why = reason(error);
      this.say(why, true);
      this.replaceButton.hidden = !why.includes('exists already');
    }
  }

  private say(text: string, bad = false): void {
    this.replaceButton.hidden = true;
    this.verdict.say(text, bad);
  }
}

const rounded = ({ x, y }: Point2): Point2 => ({ x: Math.round(x * 1000) / 1000, y: Math.round(y * 1000) / 1000 });

const deed = (id: string, text: string, press: (event: MouseEvent) => void): HTMLButtonElement => button({ id, class: 'control' }, text, press);
