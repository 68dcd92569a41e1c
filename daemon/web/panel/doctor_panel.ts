// The Doctor tab: examines port, robot and machine one after the other and lists the findings; and
// checks the tracks while they are off the ground.
import type { Consent } from '../state/consent.ts';
import { kParts, verdict, type DoctorAnswer, type Finding } from '../state/doctor.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setClass, setText } from './dom.ts';
import { findingRow } from './finding_row.ts';
import { WheelsUpPanel } from './wheels_up_panel.ts';
import { reason, type Call } from '../state/service.ts';
import { asksForMotion, kNoRights } from '../state/messages.ts';

export class DoctorPanel {
  readonly element = h('div', { class: 'doctor', tabindex: '0' });
  private readonly button = h('button', { type: 'button', class: 'control', id: 'doctor-examine' }, 'Examine');
  private readonly message = h('p', { class: 'doctor-message', role: 'status' }, 'Finds what keeps the robot from driving. Nothing moves.');
  private readonly progress = h('progress', { max: String(kParts.length), value: '0', 'aria-label': 'Examined', hidden: '' });
  private readonly list = h('div', { class: 'doctor-list' });
  private readonly wheelsUp: WheelsUpPanel;
  private busy = false;

  constructor(private readonly call: Call, consent: Consent) {
    this.wheelsUp = new WheelsUpPanel(call, consent);
    this.element.append(h('div', { class: 'doctor-bar' }, this.button, this.progress, this.message), this.list, this.wheelsUp.element);
    this.button.addEventListener('click', () => {
      void this.examine();
    });
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const run = store.get('/state')?.run;
    const drives = asksForMotion(run);
    this.button.disabled = this.busy || this.wheelsUp.on || !connected || !mayCommand || drives;
    const why = !mayCommand ? kNoRights : drives ? 'A run is under way; stop it first' : '';
    setAttribute(this.button, 'title', why);
    this.wheelsUp.show(!connected ? 'No connection to tp100d' : why !== '' ? why : this.busy ? 'Examining' : (store.get('/state')?.why_not_drive ?? ''));
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
        const { findings } = (await this.call('doctor', { part })) as DoctorAnswer;
        all.push(...findings);
        this.list.append(h('section', { 'data-part': part, 'aria-label': title }, h('h3', {}, title), h('ul', {}, ...findings.map(findingRow))));
      } catch (error: unknown) {
        failed = `${title} not examined: ${reason(error)}`;
        break;
      }
    }
    this.progress.hidden = true;
    this.busy = false;
    this.say(failed === '' ? verdict(all) : failed, failed !== '' || all.some(({ severity }) => severity === 'error'));
  }

  private say(text: string, bad = false): void {
    setText(this.message, text);
    setClass(this.message, 'bad', bad);
  }
}
