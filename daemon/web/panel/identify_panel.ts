// The Identify tab: drives the calibration courses one by one, evaluates the recordings, and saves the robot file.
import type { Consent } from '../state/consent.ts';
import { calibrationCourses, drive, drivesOf, measuredIn, measuredTable, noteOf, space, type Identified, type Measured, type Reach } from '../state/identify.ts';
import type { RunEntry, RunsList } from '../state/runs.ts';
import { facts, type CourseEntry, type SetupList } from '../state/setup.ts';
import { whyNot, type Store } from '../state/store.ts';
import { button, h, Message, onLeave, setText } from './dom.ts';
import { FoundRobot } from './found_robot.ts';
import { fetched, reason, type Call } from '../state/service.ts';

const kRefresh_ms = 5000;

export class IdentifyPanel {
  readonly element = h('div', { class: 'identify', tabindex: '0' });
  private readonly evaluate = button({ class: 'control', id: 'identify-evaluate' }, 'Evaluate', () => {
    void this.act('Evaluating the drives \u2026', () => this.identify());
  });
  private readonly message = new Message('identify-message', 'Drive the courses on a flat floor, evaluate the drives, and save the resulting robot file.');
  private readonly progress = h('p', { class: 'identify-progress' });
  private readonly why = h('p', { class: 'identify-why', role: 'status' });
  private readonly question = h('section', { class: 'identify-question', role: 'dialog', 'aria-label': 'Before the drive', hidden: '' });
  private readonly list = h('ol', { class: 'identify-courses' });
  private readonly found: FoundRobot;
  private readonly reach: Reach;
  private readonly left = new Set<string>();
  private setup: SetupList | undefined;
  private runs: RunEntry[] = [];
  private store: Store | undefined;
  private shown = '';
  private next_ms = 0;
  private busy = false;
  /** Requests follow one another, so that an older answer never replaces a newer one. */
  private order: Promise<void> = Promise.resolve();
  /** Aborted when STOP is pressed or the person leaves the page: ends an open question, and a drive that has not started. */
  private attended = new AbortController();
  private mayAsk = false;
  private mayDrive = false;

  constructor(
    private readonly call: Call,
    consent: Consent,
  ) {
    this.reach = {
      call,
      move: consent.move,
      state: () => this.store?.get('/state'),
      now: () => performance.now(),
      sleep: (ms) => new Promise((resolve) => setTimeout(resolve, ms)),
      say: (text) => { this.message.say(text); },
      ask: (text) => this.confirm(text, 'Drive', 'identify-drive-now'),
    };
    consent.subscribe((why) => { this.giveUp(why); });
    onLeave(() => { this.giveUp('The page was left'); });
    this.found = new FoundRobot(call, this.message);
    this.element.append(h('div', { class: 'tab-bar' }, this.evaluate, this.message.element), this.progress, this.why, this.question, this.found.element, this.list);
  }

  /** Draws the tab's content; reloads the lists from time to time. */
  show(store: Store, connected: boolean, mayCommand: boolean): void {
    this.store = store;
    const records = store.get('/recording')?.available !== false;
    const why = records ? whyNot(store, connected, mayCommand) : 'Drives are recorded: start tp100d with --record DIR and --stay.';
    this.mayDrive = why === '';
    setText(this.why, this.busy ? '' : why);
    this.mayAsk = connected && mayCommand;
    this.enable();
    if (performance.now() < this.next_ms || !connected) return;
    this.next_ms = performance.now() + kRefresh_ms;
    void this.load();
  }

  private enable(): void {
    const drives = this.chosen();
    setText(this.evaluate, drives.length === 0 ? 'Evaluate' : `Evaluate ${drives.length} drive${drives.length === 1 ? '' : 's'}`);
    this.evaluate.disabled = this.busy || !this.mayAsk || drives.length === 0;
    for (const button of this.element.querySelectorAll<HTMLButtonElement>('.identify-drive')) button.disabled = this.busy || !this.mayDrive || button.dataset.fixed === 'true';
    for (const input of this.list.querySelectorAll<HTMLInputElement>('input')) input.disabled = !this.mayAsk;
    this.found.enable(!this.busy && this.mayDrive);
  }

  private get robot(): string {
    return this.store?.get('/state')?.robot ?? '';
  }

  /** The drives that are evaluated, in the order of the list. */
  private chosen(): RunEntry[] {
    if (this.setup === undefined) return [];
    return calibrationCourses(this.setup).flatMap(({ name }) => drivesOf(this.runs, name, this.robot)).filter(({ run }) => !this.left.has(run));
  }

  private inOrder(work: () => Promise<void>): Promise<void> {
    this.order = this.order.then(work);
    return this.order;
  }

  private load(): Promise<void> {
    return this.inOrder(async () => {
      try {
        const [setup, runs] = await Promise.all([fetched('/api/setup'), fetched('/api/runs')]);
        this.setup = JSON.parse(setup) as SetupList;
        this.runs = (JSON.parse(runs) as RunsList).runs;
        // Do not redraw while a measurement is being typed.
        if (`${setup}${runs}` === this.shown || (document.activeElement?.closest('.identify-measured') ?? null) !== null) return;
        this.shown = `${setup}${runs}`;
        const courses = calibrationCourses(this.setup);
        setText(this.progress, this.progressOf(courses));
        this.list.replaceChildren(...courses.map((course) => this.course(course)));
      } catch {
        this.shown = '';
        this.message.say('The lists of courses and runs are not available now.', true);
      }
    });
  }

  /** For example "3 of 9 courses driven, about 2 min of driving left". */
  private progressOf(courses: readonly CourseEntry[]): string {
    const left = courses.filter(({ name }) => drivesOf(this.runs, name, this.robot).length === 0);
    const left_s = left.reduce((sum_s, { duration_s }) => sum_s + (duration_s ?? 0), 0);
    const time = left_s < 60 ? `${left_s.toFixed(0)} s` : `${Math.ceil(left_s / 60)} min`;
    return `${courses.length - left.length} of ${courses.length} courses driven${left.length === 0 ? '' : `, about ${time} of driving left`}`;
  }

  /** Writes a measurement down. One may be typed at any time, also while a course is driven. */
  private keep(run: string, measured: Measured): Promise<void> {
    return this.inOrder(async () => {
      try {
        await this.call('run_note', { run, note: noteOf(measured) });
      } catch (error: unknown) {
        this.message.say(reason(error), true);
      }
    });
  }

  private course(course: CourseEntry): HTMLElement {
    const attributes = { class: 'control identify-drive', 'aria-label': `Drive ${course.name}`, disabled: '', 'data-fixed': String(course.why_not !== '') };
    const drive = button(attributes, 'Drive \u2026', () => {
      void this.act(`${course.name} \u2026`, () => this.ask(course));
    });
    const drives = drivesOf(this.runs, course.name, this.robot);
    const about = h('div', { class: 'identify-about' }, h('h3', {}, course.name), h('p', {}, `${facts(course)}, ${space(course)}`));
    if (course.why_not !== '') about.append(h('p', { class: 'identify-bad' }, course.why_not));
    return h('li', { 'data-course': course.name, 'data-driven': String(drives.length) }, about, drive, h('ul', {}, ...drives.map((run) => this.drive(run))));
  }

  private drive(run: RunEntry): HTMLElement {
    const box = h('input', { type: 'checkbox' });
    box.checked = !this.left.has(run.run);
    box.addEventListener('change', () => {
      if (box.checked) this.left.delete(run.run);
      else this.left.add(run.run);
    });
    const measured = measuredIn(run.note);
    const input = (name: keyof Measured, label: string): HTMLElement => {
      const element = h('input', { type: 'number', step: 'any', inputmode: 'decimal', name });
      element.value = measured[name] === undefined ? '' : String(measured[name]);
      element.addEventListener('change', () => {
        if (element.value === '') Reflect.deleteProperty(measured, name);
        else measured[name] = Number(element.value);
        void this.keep(run.run, { ...measured });
        void this.load();
      });
      return h('label', {}, `${label} `, element);
    };
    const fields = [
      input('distance_m', 'distance [m]'),
      input('turned_deg', 'turned, left positive [deg]'),
      input('slope_deg', 'straight up a slope of [deg]'),
    ];
    return h('li', { 'data-run': run.run }, h('label', {}, box, ` ${run.run}`), h('span', { class: 'identify-measured' }, 'by hand: ', ...fields));
  }

  /** Chooses the course and asks whether the robot stands at its start. Nothing moves before the answer. */
  private async ask(course: CourseEntry): Promise<string> {
    await this.call('choose', { course: course.name, setup: 'flat' });
    this.attended = new AbortController();
    const text = `Put the robot on a flat floor with ${space(course)} free. It will drive ${facts(course)}. Mark where it stands, unless a camera sees it.`;
    const placed = await this.confirm(text, 'It stands there', 'identify-start');
    if (placed === undefined || (await drive(this.reach, course.name, this.attended.signal)) === '') return 'Nothing was driven.';
    const seen = this.store?.get('/estimate')?.fused.camera_age_us;
    return `${course.name} is driven.${typeof seen !== 'number' ? ' No camera sees the robot: measure the drive and write it down below.' : ''}`;
  }

  /** The time of the press, undefined if it was cancelled. Rejects if STOP is pressed or the person leaves the page. */
  private async confirm(text: string, answer: string, id: string): Promise<number | undefined> {
    const yes = h('button', { type: 'button', class: 'control', id }, answer);
    const no = h('button', { type: 'button', class: 'control', id: 'identify-cancel' }, 'Cancel');
    this.question.replaceChildren(h('p', {}, text), h('div', { class: 'buttons' }, no, yes));
    this.question.hidden = false;
    no.focus();
    const { signal } = this.attended;
    try {
      return await new Promise<number | undefined>((resolve, reject) => {
        yes.addEventListener('click', ({ timeStamp }) => { resolve(timeStamp); });
        no.addEventListener('click', () => { resolve(undefined); });
        signal.addEventListener('abort', () => { reject(signal.reason as Error); });
      });
    } finally {
      this.question.hidden = true;
    }
  }

  private giveUp(why: string): void {
    this.attended.abort(new Error(`${why}: nothing was driven`));
  }

  private async identify(): Promise<string> {
    await this.load();
    const drives = this.chosen();
    const answer = (await this.call('run_identify', { runs: drives.map(({ run }) => run).join(' '), measured: measuredTable(drives) })) as Identified;
    if (this.setup !== undefined) this.found.show(answer, this.setup);
    this.element.scrollTop = 0;
    return `${drives.length} drive${drives.length === 1 ? ' is' : 's are'} evaluated.`;
  }

  private async act(begin: string, work: () => Promise<string>): Promise<void> {
    if (this.busy) return;
    this.busy = true;
    this.enable();
    this.message.say(begin);
    try {
      this.message.say(await work());
    } catch (error: unknown) {
      this.message.say(reason(error), true);
    } finally {
      // Show the result before the next action is enabled.
      await this.load();
      this.busy = false;
    }
  }
}
