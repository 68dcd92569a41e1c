// The Doctor tab: examines port, robot and machine one after the other, and lists what was found.
import { kParts, verdict, type DoctorAnswer, type Finding, type Part } from '../state/doctor.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setClass, setText } from './dom.ts';

/** Calls the service `doctor`. */
type Call = (part: Part) => Promise<unknown>;

export class DoctorPanel {
  readonly element = h('div', { class: 'doctor', tabindex: '0' });
  private readonly button = h('button', { type: 'button', class: 'control', id: 'doctor-examine' }, 'Examine');
  private readonly said = h('p', { class: 'doctor-said', role: 'status' }, 'Finds what keeps the robot from driving. Nothing moves.');
  private readonly progress = h('progress', { max: String(kParts.length), value: '0', 'aria-label': 'Examined', hidden: '' });
  private readonly list = h('div', { class: 'doctor-list' });
  private busy = false;

  constructor(private readonly call: Call) {
    this.element.append(h('div', { class: 'doctor-bar' }, this.button, this.progress, this.said), this.list);
    this.button.addEventListener('click', () => {
      void this.examine();
    });
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const run = store.get('/state')?.run;
    const drives = run === 'arming' || run === 'running' || run === 'driving';
    this.button.disabled = this.busy || !connected || !mayCommand || drives;
    const why = !mayCommand ? 'This daemon takes no commands from here but STOP (server.commands)' : drives ? 'A run is under way; stop it first' : '';
    setAttribute(this.button, 'title', why);
  }

  private async examine(): Promise<void> {
    this.busy = this.button.disabled = true;
    this.progress.hidden = false;
    this.list.replaceChildren();
    const all: Finding[] = [];
    let failed = '';
    for (const [i, { part, title }] of kParts.entries()) {
      this.progress.value = i;
      this.say(`${title}, ${i + 1} of ${kParts.length} \u2026`);
      try {
        const { findings } = (await this.call(part)) as DoctorAnswer;
        all.push(...findings);
        this.list.append(h('section', { 'data-part': part, 'aria-label': title }, h('h3', {}, title), h('ul', {}, ...findings.map(row))));
      } catch (error: unknown) {
        failed = `${title} not examined: ${error instanceof Error ? error.message : String(error)}`;
        break;
      }
    }
    this.progress.hidden = true;
    this.busy = false;
    this.say(failed === '' ? verdict(all) : failed, failed !== '' || all.some(({ severity }) => severity === 'error'));
  }

  private say(text: string, bad = false): void {
    setText(this.said, text);
    setClass(this.said, 'bad', bad);
  }
}

function row({ severity, name, seen, fix }: Finding): HTMLElement {
  const about = h('div', { class: 'finding-about' }, h('p', {}, seen));
  if (fix !== '') about.append(h('p', { class: 'finding-fix' }, `To do: ${fix}`));
  return h('li', { class: 'finding', 'data-severity': severity, 'data-name': name }, h('span', { class: 'finding-severity' }, severity), h('strong', {}, name), about);
}
