// The editor of a course: its points over the map, its values and its text beside it. The daemon checks each change
// and says where everything lies; what it said of the text before stays on the map until it answers.
import { button, h, Message, setAttribute, setClass, setText } from '../panel/dom.ts';
import type { Viewport } from '../panel/viewport.ts';
import { frameOf, zoomed, type Bounds, type Point2 } from '../scene/geometry.ts';
import type { Course } from '../state/messages.ts';
import { nameOf, type CourseCheck } from '../state/setup.ts';
import { CourseText, History, type Piece, type Value } from './course_text.ts';
import { added, beyond, find, handles, kEmptyCourse, kEnds, kTools, withCorner, withoutCorner, type Handle, type Selected } from './draft.ts';
import { fields } from './fields.ts';
import { DrawStage } from './stage.ts';
import { reason, type Call } from '../state/service.ts';

/** The daemon charges requests by the length of their answers: longer courses are asked about less often. */
const kPointsPerMs = 20;
const kRetry_ms = 1000;

/** A handle whose move was the last change, and where to. */
interface Moved {
  id: string;
  at: Point2;
}

export class CourseEditor {
  readonly element = h('div', { class: 'draw', hidden: '' });
  readonly stage: DrawStage;
  private readonly name = h('input', { type: 'text', name: 'course-name', 'aria-label': 'Name of the course', maxlength: '64' });
  private readonly text = h('textarea', { rows: '14', spellcheck: 'false', 'aria-label': 'Text of the course file' });
  private readonly verdict = new Message('draw-verdict');
  private readonly hint = h('p', { class: 'draw-hint', role: 'status' });
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
  private readonly tools = new Map<string, HTMLButtonElement>();
  private readonly history = new History();
  private course = new CourseText('');
  private handles_: Handle[] = [];
  private selected: Selected | undefined;
  private corner: number | undefined;
  private tool: string | undefined;
  private frame: Bounds | undefined;
  /** The daemon's last drawing of the course, the text that it last answered about, and what waits for its next answer. */
  private drawn: Course | undefined;
  private answered: string | undefined;
  private waiting: (() => void)[] = [];
  private moved: Moved | undefined;
  private opened = '';
  private saved = '';
  private shownFields = '';
  /** Counts what is opened and closed: answers about another file are late. */
  private session = 0;
  private asking = false;
  private onMap = false;
  private chooses = false;

  constructor(
    /** The map under the draft. */
    private readonly map: Pick<Viewport, 'draft' | 'pixel' | 'world'>,
    private readonly call: Call,
    /** Called when drawing begins or ends. */
    private readonly opens: (on: boolean) => void,
  ) {
    this.stage = new DrawStage((at) => map.pixel(at), (at) => map.world(at), {
      select: (handle) => { this.select(handle); },
      move: (handle, to, over) => { this.move(handle.id, rounded(to), over); },
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
    this.selected = this.corner = this.drawn = this.answered = this.frame = undefined;
    this.session++;
    this.handles_ = [];
    this.waiting = [];
    this.pick(undefined);
    this.say('');
    this.history.restart(text);
    this.course = new CourseText('');
    this.take(text);
    this.onMap = true;
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
    this.session++;
    this.showOnMap(false);
    this.opens(false);
  }

  /** Shows the draft on the map instead of the course in force, or that again. */
  showOnMap(on: boolean): void {
    this.onMap = on && this.active;
    this.stage.show(this.onMap);
    this.map.draft(this.onMap ? this.drawn : undefined, this.onMap ? this.frame : undefined);
  }

  /** Shows the state of the controls, and the handles where the map is now. */
  tick(mayChange: boolean): void {
    if (!this.onMap) return;
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
  }

  private build(): void {
    const bar = h('div', { class: 'draw-bar', role: 'toolbar', 'aria-label': 'Draw' });
    for (const [tool, title] of Object.entries(kTools)) {
      const element = deed(`draw-${tool}`, title, (event) => {
        // Pressed by key: the piece is added beyond the end of the path.
        if (event.detail === 0) this.add(tool);
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
      this.hint,
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

  private pick(tool: string | undefined): void {
    this.tool = tool;
    setText(this.hint, tool === undefined ? 'Drag the points of the drawing, or pick what to add.' : tool in kEnds ? `Press on the map where the ${tool === 'pivot' ? 'turn looks to' : `${tool} ends`}.` : 'Press on the map where it shall be.');
    for (const [each, element] of this.tools) setAttribute(element, 'aria-pressed', String(each === tool));
    setClass(this.stage.element, 'adds', tool !== undefined);
  }

  private press(at: Point2): void {
    if (this.tool === undefined) return;
    this.add(this.tool, at);
    // Tools that lengthen the path stay selected for the next point; others add one piece.
    if (!(this.tool in kEnds) || this.tool === 'pivot') this.pick(undefined);
  }

  /** The daemon's drawing of the text as it is now, unless its answer is still awaited. */
  private get current(): Course | undefined {
    return this.answered === this.text.value ? this.drawn : undefined;
  }

  private move(id: string, to: Point2, over: boolean): void {
    // Where a segment begins does not depend on its own end, but on those before it.
    if (id !== this.moved?.id && this.current === undefined) {
      this.waiting.push(() => { this.move(id, to, over); });
      return;
    }
    const handle = this.handles_.find((each) => each.id === id);
    if (handle !== undefined) this.edit(() => handle.drag(to), over, { id, at: to });
  }

  /** Adds a piece at a point, or beyond the end of the path. */
  private add(tool: string, at?: Point2): void {
    const drawn = this.current;
    if (drawn === undefined) {
      this.waiting.push(() => { this.add(tool, at); });
      return;
    }
    this.edit(() => {
      const next = added(this.course, drawn, tool, rounded(at ?? beyond(this.course, drawn)));
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
  private edit(change: () => string, over: boolean, moved?: Moved): void {
    try {
      this.take(change(), true, moved);
      if (over) this.history.add(this.course.text);
    } catch (error: unknown) {
      this.say(reason(error), true);
    }
  }

  private take(text: string, show = true, moved?: Moved): void {
    this.moved = moved;
    if (show && this.text.value !== text) this.text.value = text;
    try {
      this.course = new CourseText(text);
    } catch {
      // The daemon reports the error; the handles remain those of the last text that could be read.
    }
    this.ask();
    this.place();
  }

  /** Places the handles at once, because the next key may come before the next frame. */
  private place(): void {
    if (this.drawn === undefined) return;
    const moved = this.current === undefined ? this.moved : undefined;
    this.handles_ = handles(this.course, this.drawn).map((each) => (each.id === moved?.id ? { ...each, at: moved.at } : each));
    if (this.onMap) this.stage.draw(this.handles_, this.selected);
  }

  private fit(): void {
    if (this.drawn !== undefined) this.show(frameOf(this.drawn));
  }

  private zoom(factor: number): void {
    if (this.frame !== undefined) this.show(zoomed(this.frame, factor));
  }

  private show(frame: Bounds): void {
    this.frame = frame;
    if (this.onMap) this.map.draft(this.drawn, frame);
  }

  private fieldsOf(piece: Piece): HTMLElement {
    const selected: Selected = { table: piece.table, index: piece.index };
    return fields(piece, (key: string, value: Value) => {
      const now = find(this.course, selected);
      if (now !== undefined) this.edit(() => this.course.with(now, { [key]: value }), true);
    });
  }

  /** Has the text drawn and checked; while an answer is awaited, the newest text is asked about next. */
  private ask(): void {
    if (this.active && !this.asking && this.answered !== this.text.value) void this.check(this.text.value);
  }

  private async check(text: string): Promise<void> {
    this.asking = true;
    const session = this.session;
    let pause_ms = kRetry_ms;
    try {
      const answer = (await this.call('file_check', { kind: 'course', name: nameOf(this.name.value) || 'course', text })) as CourseCheck;
      pause_ms = ((answer.course?.path.length ?? 0) + (answer.course?.segments.length ?? 0)) / kPointsPerMs;
      if (session === this.session) this.answer(text, answer);
    } catch (error: unknown) {
      this.waiting = [];
      this.say(`The daemon draws the course, and does not answer: ${reason(error)}`, true);
    }
    setTimeout(() => {
      this.asking = false;
      this.ask();
    }, pause_ms);
  }

  private answer(text: string, { course, ...check }: CourseCheck): void {
    this.answered = text;
    if (course !== undefined) {
      this.drawn = course;
      this.show(this.frame ?? frameOf(course));
    }
    this.place();
    const place = check.line === undefined ? '' : `line ${check.line}, column ${check.column ?? 1}: `;
    const length = `${check.length_m?.toFixed(2) ?? ''} m`;
    if (check.error !== '') this.say(place + check.error, true);
    else if (check.why_not !== '') this.say(`${length}; ${check.why_not}`, true);
    else this.say(`${length}, about ${check.duration_s?.toFixed(0) ?? '?'} s`);
    if (text === this.text.value) for (const change of this.waiting.splice(0)) change();
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
