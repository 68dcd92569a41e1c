// Choice of course, robot, set-up and the robot's pose, while no run is under way.
import { kNoRights, onCourse, type State } from '../state/messages.ts';
import { kindOf, kMaxText, nameOf, type CourseEntry, type FileKind, type RobotEntry, type SetupCall, type SetupList } from '../state/setup.ts';
import type { Store } from '../state/store.ts';
import type { CourseEditor } from '../draw/editor.ts';
import { courseCard } from './course_card.ts';
import { h, setAttribute, setText } from './dom.ts';
import { reason } from '../state/service.ts';

const kRefresh_ms = 5000;
const kAboutSetups: Record<string, string> = {
  stand: 'tracks turn freely, everything else is virtual',
  flat: 'a flat floor; ramps and blocks are virtual',
  terrain: 'ramps and blocks are really there',
};
const kFloor =
  'The real floor does not change with the course: with set-up terrain its ramps and blocks must stand there. An emulated robot keeps the floor and the disturbances that it was started with.';

export type Ask = (call: SetupCall) => Promise<unknown>;

export class CourseList {
  readonly element = h('div', { class: 'courses', tabindex: '0' });
  private readonly robots = h('select', { id: 'choose-robot', 'aria-label': 'Robot' });
  private readonly setups = h('select', { id: 'choose-setup', 'aria-label': 'Set-up' });
  private readonly placeStart = h('button', { type: 'button', class: 'control', id: 'place-start' }, 'Place at start');
  private readonly placeMap = h('button', { type: 'button', class: 'control', id: 'place-map', 'aria-pressed': 'false' }, 'Place on the map');
  private readonly upload = h('button', { type: 'button', class: 'control', id: 'upload' }, 'Upload');
  private readonly drawNew = h('button', { type: 'button', class: 'control', id: 'draw-new' }, 'Draw a course');
  private readonly file = h('input', { type: 'file', accept: '.toml', 'aria-label': 'Course or robot file', hidden: '' });
  private readonly why = h('p', { class: 'courses-why', role: 'status' });
  private readonly message = h('p', { class: 'courses-message', role: 'alert' });
  private readonly replace = h('button', { type: 'button', class: 'control', id: 'upload-replace', hidden: '' }, 'Replace it');
  private readonly cards = h('ol', { class: 'cards' });
  private list: SetupList | undefined;
  private shown = '';
  private next_ms = 0;
  private asking = false;
  private mayChange = false;
  private replaced: { kind: FileKind; name: string; text: string } | undefined;

  constructor(
    private readonly ask: Ask,
    /** Shows the map and begins drawing of a pose on it, or ends it. */
    private readonly drawPlace: (on: boolean) => void,
    private readonly editor: CourseEditor,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.element.append(
      h(
        'div',
        { class: 'courses-bar' },
        h('label', {}, 'robot ', this.robots),
        h('label', {}, 'set-up ', this.setups),
        this.placeStart,
        this.placeMap,
        this.upload,
        this.drawNew,
        this.file,
      ),
      this.why,
      h('div', { class: 'courses-answer' }, this.message, this.replace),
      this.cards,
      h('p', { class: 'courses-floor' }, kFloor),
    );
    this.robots.addEventListener('change', () => {
      void this.change({ name: 'choose', request: { robot: this.robots.value } });
    });
    this.setups.addEventListener('change', () => {
      void this.change({ name: 'choose', request: { setup: this.setups.value } });
    });
    this.placeStart.addEventListener('click', () => {
      void this.change({ name: 'place', request: { at: 'start' } });
    });
    this.placeMap.addEventListener('click', () => {
      this.drawPlace(this.placeMap.getAttribute('aria-pressed') !== 'true');
    });
    this.upload.addEventListener('click', () => {
      this.file.click();
    });
    this.drawNew.addEventListener('click', () => {
      this.editor.openNew(this.list?.courses.map(({ name }) => name) ?? []);
    });
    this.file.addEventListener('change', () => {
      const file = this.file.files?.[0];
      if (file !== undefined) void this.take(file);
      this.file.value = '';
    });
    this.replace.addEventListener('click', () => {
      const file = this.replaced;
      if (file !== undefined) void this.save(file, true);
    });
  }

  /** Draws the tab's content; reloads the list from time to time. */
  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const state = store.get('/state');
    const why = whyNot(state, connected && !store.stale('/state'), mayCommand);
    this.mayChange = why === '' && !this.asking;
    setText(this.why, why);
    this.enable();
    const named = `${state?.course ?? ''} ${state?.robot ?? ''} ${state?.setup ?? ''}`;
    if (this.element.dataset.named !== named) this.next_ms = 0;
    this.element.dataset.named = named;
    if (this.now() < this.next_ms || !connected) return;
    this.next_ms = this.now() + kRefresh_ms;
    void this.load();
  }

  /** Whether the daemon accepts a change now. */
  get changeable(): boolean {
    return this.mayChange;
  }

  /** A pose was drawn on the map, or drawing has ended without one. */
  placed(pose: { x_m: number; y_m: number; yaw_rad: number } | undefined): void {
    setAttribute(this.placeMap, 'aria-pressed', 'false');
    if (pose !== undefined) void this.change({ name: 'place', request: pose });
  }

  drawing(on: boolean): void {
    setAttribute(this.placeMap, 'aria-pressed', String(on));
    if (on) this.say('Press on the map where the robot is, and drag towards where it points.');
  }

  private enable(): void {
    const on = this.mayChange && this.list !== undefined;
    for (const control of [this.robots, this.setups, this.placeMap]) control.disabled = !on;
    this.placeStart.disabled = !on || this.list?.course === '';
    this.drawNew.disabled = this.list === undefined;
    this.upload.disabled = this.replace.disabled = !on || this.list?.may_save !== true;
    setAttribute(this.upload, 'title', this.list?.may_save === false ? 'There is no folder for your files: set library in the configuration' : 'A course or robot file (TOML)');
    for (const button of this.cards.querySelectorAll('button')) button.disabled = !on || button.dataset.fixed === 'true';
  }

  private async load(): Promise<void> {
    try {
      const response = await fetch('/api/setup', { cache: 'no-store' });
      if (!response.ok) throw new Error(response.statusText);
      const text = await response.text();
      if (text === this.shown) return;
      this.shown = text;
      this.list = JSON.parse(text) as SetupList;
      this.build(this.list);
    } catch {
      this.shown = '';
      this.say('The list of courses is not available now.');
    }
  }

  private build(list: SetupList): void {
    const option = (name: string, about: string, why: string): HTMLOptionElement => {
      const element = h('option', { value: name }, about === '' ? name : `${name}: ${about}`);
      element.disabled = why !== '';
      if (why !== '') element.title = why;
      return element;
    };
    this.robots.replaceChildren(...list.robots.map((each: RobotEntry) => option(each.name, each.description ?? '', each.why_not)));
    this.robots.value = list.robot;
    this.setups.replaceChildren(...list.setups.map((name) => option(name, kAboutSetups[name] ?? '', '')));
    this.setups.value = list.setup;
    const rank = (course: CourseEntry): number => Number(course.identifies === true) - Number(course.from !== 'bundled');
    const courses = [...list.courses].sort((a, b) => rank(a) - rank(b));
    const actions = {
      edit: (course: CourseEntry): void => {
        void this.edit(course);
      },
      choose: ({ name }: CourseEntry): void => {
        void this.change({ name: 'choose', request: { course: name } });
      },
      remove: ({ name }: CourseEntry): void => {
        void this.change({ name: 'file_delete', request: { kind: 'course', name } });
      },
    };
    this.cards.replaceChildren(...courses.map((course) => courseCard(course, actions)));
    this.enable();
  }

  private async edit({ name, from }: CourseEntry): Promise<void> {
    try {
      const response = await fetch(`/courses/${name}.toml`, { cache: 'no-store' });
      if (!response.ok) throw new Error(`${name} cannot be read: ${response.statusText}`);
      const own = from === 'own';
      this.editor.open(own ? name : `${name}-mine`, await response.text(), own);
    } catch (error: unknown) {
      this.say(reason(error));
    }
  }

  /** Asks the daemon for a change; true: done. */
  private async change(call: SetupCall): Promise<boolean> {
    this.asking = true;
    this.mayChange = false;
    this.say('');
    this.enable();
    try {
      await this.ask(call);
      return true;
    } catch (error: unknown) {
      this.say(reason(error));
      return false;
    } finally {
      this.asking = false;
      // Redraw also after a refusal, which leaves a wrong choice in a selector.
      this.shown = '';
      this.next_ms = 0;
    }
  }

  private async take(file: File): Promise<void> {
    if (file.size > kMaxText) {
      this.say(`${file.name} has ${file.size} bytes; at most ${kMaxText} are taken`);
      return;
    }
    const text = await file.text();
    await this.save({ kind: kindOf(text), name: nameOf(file.name), text }, false);
  }

  private async save(file: { kind: FileKind; name: string; text: string }, replace: boolean): Promise<void> {
    const known = file.kind === 'course' ? this.list?.courses : this.list?.robots;
    if (!replace && known?.some(({ name, from }) => name === file.name && from === 'own') === true) {
      this.say(`You have a ${file.kind} named ${file.name} already.`);
      this.replaced = file;
      this.replace.hidden = false;
      return;
    }
    if (await this.change({ name: 'file_save', request: { ...file, replace } })) this.say(`${file.name} is saved.`);
  }

  private say(text: string): void {
    this.replaced = undefined;
    this.replace.hidden = true;
    setText(this.message, text);
  }
}

function whyNot(state: State | undefined, fresh: boolean, mayCommand: boolean): string {
  if (!fresh || state === undefined) return 'No connection to tp100d.';
  if (!mayCommand) return `${kNoRights}.`;
  if (onCourse(state.run)) return 'A run is under way: nothing can be changed.';
  if (state.run === 'driving') return 'The robot is driven by hand: release it first.';
  return '';
}
