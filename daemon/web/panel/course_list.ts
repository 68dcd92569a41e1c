// Choice of course, robot, set-up and the robot's pose, while no run is under way.
import { kindOf, kMaxText, nameOf, type CourseEntry, type FileKind, type RobotEntry, type SetupList } from '../state/setup.ts';
import { whyNot, type Store } from '../state/store.ts';
import type { CourseEditor } from '../draw/editor.ts';
import { courseCard } from './course_card.ts';
import { button, h, Message, setAttribute, setText } from './dom.ts';
import type { FloorPose } from '../state/messages.ts';
import { fetched, Listing, reason, type Call } from '../state/service.ts';

const kAboutSetups: Record<string, string> = {
  stand: 'tracks turn freely, everything else is virtual',
  flat: 'a flat floor; ramps and blocks are virtual',
  terrain: 'ramps and blocks are really there',
};
const kUnavailable = 'The list of courses is not available now.';
const kFloor =
  'The real floor does not change with the course: with set-up terrain its ramps and blocks must stand there. An emulated robot keeps the floor and the disturbances that it was started with.';

export class CourseList {
  readonly element = h('div', { class: 'courses', tabindex: '0' });
  private readonly robots = h('select', { id: 'choose-robot', 'aria-label': 'Robot' });
  private readonly setups = h('select', { id: 'choose-setup', 'aria-label': 'Set-up' });
  private readonly placeStart = button({ class: 'control', id: 'place-start', title: 'Say that the robot stands at the start of the course' }, 'Place at start', () => void this.change('place', { at: 'start' }));
  private readonly placeMap = button({ class: 'control', id: 'place-map', 'aria-pressed': 'false', title: 'Say where the robot stands, on the map' }, 'Place on the map', () => {
    this.drawPlace(!this.placing);
  });
  private readonly upload = button({ class: 'control', id: 'upload' }, 'Upload', () => { this.file.click(); });
  private readonly drawNew = button({ class: 'control', id: 'draw-new', title: 'Draw a course of your own on the map' }, 'Draw a course', () => {
    this.editor.openNew(this.list?.courses.map(({ name }) => name) ?? []);
  });
  private readonly file = h('input', { type: 'file', accept: '.toml', 'aria-label': 'Course or robot file', hidden: '' });
  private readonly about = h('p', { class: 'courses-about' });
  private readonly why = h('p', { class: 'courses-why', role: 'status' });
  private readonly message = new Message('courses-message');
  private readonly replace = button({ class: 'control', id: 'upload-replace', hidden: '' }, 'Replace it', () => {
    if (this.replaced !== undefined) void this.save(this.replaced, true);
  });
  private readonly cards = h('ol', { class: 'cards' });
  private readonly listing = new Listing<SetupList>('/api/setup', (list) => { this.build(list); }, () => { this.say(kUnavailable); });
  private list: SetupList | undefined;
  private asking = false;
  private mayChange = false;
  private replaced: { kind: FileKind; name: string; text: string } | undefined;

  constructor(
    private readonly call: Call,
    /** Shows the map and begins drawing of a pose on it, or ends it. */
    private readonly drawPlace: (on: boolean) => void,
    private readonly editor: CourseEditor,
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
      this.about,
      this.why,
      h('div', { class: 'courses-answer' }, this.message.element, this.replace),
      this.cards,
      h('p', { class: 'courses-floor' }, kFloor),
    );
    this.robots.addEventListener('change', () => {
      void this.change('choose', { robot: this.robots.value });
    });
    this.setups.addEventListener('change', () => {
      void this.change('choose', { setup: this.setups.value });
    });
    this.file.addEventListener('change', () => {
      const file = this.file.files?.[0];
      if (file !== undefined) void this.take(file);
      this.file.value = '';
    });
  }

  /** Draws the tab's content; reloads the list from time to time. */
  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const state = store.get('/state');
    const why = whyNot(store, connected, mayCommand);
    this.mayChange = why === '' && !this.asking;
    setText(this.why, why);
    this.enable();
    const named = `${state?.course ?? ''} ${state?.robot ?? ''} ${state?.setup ?? ''}`;
    if (this.element.dataset.named !== named) this.listing.reload();
    this.element.dataset.named = named;
    if (connected) this.listing.show();
  }

  /** Whether the daemon accepts a change now. */
  get changeable(): boolean {
    return this.mayChange;
  }

  /** A pose was drawn on the map, or drawing has ended without one. */
  placed(pose: FloorPose | undefined): void {
    setAttribute(this.placeMap, 'aria-pressed', 'false');
    if (pose !== undefined) void this.change('place', pose);
  }

  /** Whether a pose is being drawn on the map. */
  get placing(): boolean {
    return this.placeMap.getAttribute('aria-pressed') === 'true';
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

  private build(list: SetupList): void {
    this.list = list;
    if (this.message.element.textContent === kUnavailable) this.say('');
    const option = (name: string, why: string): HTMLOptionElement => {
      const element = h('option', { value: name }, name);
      element.disabled = why !== '';
      if (why !== '') element.title = why;
      return element;
    };
    this.robots.replaceChildren(...list.robots.map((each: RobotEntry) => option(each.name, each.why_not)));
    this.robots.value = list.robot;
    this.setups.replaceChildren(...list.setups.map((name) => option(name, '')));
    this.setups.value = list.setup;
    const robot = list.robots.find(({ name }) => name === list.robot);
    setText(this.about, [`${list.robot}: ${robot?.description ?? ''}`, `${list.setup}: ${kAboutSetups[list.setup] ?? ''}`].join('. '));
    const rank = (course: CourseEntry): number => Number(course.identifies === true) - Number(course.from !== 'bundled');
    const courses = [...list.courses].sort((a, b) => rank(a) - rank(b));
    const card = (course: CourseEntry): HTMLElement =>
      courseCard(course, {
        edit: () => void this.edit(course),
        choose: () => void this.change('choose', { course: course.name }),
        remove: () => void this.change('file_delete', { kind: 'course', name: course.name }),
      });
    this.cards.replaceChildren(...courses.map(card));
    this.enable();
  }

  private async edit({ name, from }: CourseEntry): Promise<void> {
    try {
      const own = from === 'own';
      this.editor.open(own ? name : `${name}-mine`, await fetched(`/courses/${name}.toml`), own);
    } catch (error: unknown) {
      this.say(reason(error));
    }
  }

  /** Asks the daemon for a change; true: done. */
  private async change(service: string, request: object): Promise<boolean> {
    this.asking = true;
    this.mayChange = false;
    this.say('');
    this.enable();
    try {
      await this.call(service, request);
      return true;
    } catch (error: unknown) {
      this.say(reason(error));
      return false;
    } finally {
      this.asking = false;
      // Redraw also after a refusal, which leaves a wrong choice in a selector.
      this.listing.reload();
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
    if (await this.change('file_save', { ...file, replace })) this.say(`${file.name} is saved.`);
  }

  private say(text: string): void {
    this.replaced = undefined;
    this.replace.hidden = true;
    this.message.say(text);
  }
}
