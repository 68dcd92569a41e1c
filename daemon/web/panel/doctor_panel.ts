// The Doctor tab: examines port, robot and machine one after the other and lists the findings; and
// checks the tracks while they are off the ground.
import type { Consent } from '../state/consent.ts';
import { kParts, verdict, type DoctorAnswer, type Finding } from '../state/doctor.ts';
import { whyNot, type Store } from '../state/store.ts';
import { button, h, Message, setAttribute } from './dom.ts';
import { findingRow, WheelsUpPanel } from './wheels_up_panel.ts';
import { reason, type Call } from '../state/service.ts';

export class DoctorPanel {
  readonly element = h('div', { class: 'doctor parts', tabindex: '0' });
  private readonly button = button({ class: 'control', id: 'doctor-examine' }, 'Examine', () => void this.examine());
  private readonly message = new Message('doctor-message', 'Finds what keeps the robot from driving. Nothing moves.');
  private readonly progress = h('progress', { max: String(kParts.length), value: '0', 'aria-label': 'Examined', hidden: '' });
  private readonly list = h('div', { class: 'doctor-list' });
  private readonly wheelsUp: WheelsUpPanel;
  private busy = false;

  constructor(private readonly call: Call, consent: Consent) {
    this.wheelsUp = new WheelsUpPanel(call, consent);
    this.element.append(h('div', { class: 'tab-bar' }, this.button, this.progress, this.message.element), this.list, this.wheelsUp.element);
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    const why = whyNot(store, connected, mayCommand);
    this.button.disabled = this.busy || this.wheelsUp.on || why !== '';
    setAttribute(this.button, 'title', why);
    this.wheelsUp.show(why !== '' ? why : this.busy ? 'Examining' : (store.get('/state')?.why_not_drive ?? ''));
  }

  private async examine(): Promise<void> {
    this.busy = this.button.disabled = true;
    this.progress.hidden = false;
    this.list.replaceChildren();
    const all: Finding[] = [];
    let failed = '';
    for (const [i, { part, title }] of kParts.entries()) {
      this.progress.value = i;
      this.message.say(`${title}, ${i + 1} of ${kParts.length} \u2026`);
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
    this.message.say(failed === '' ? verdict(all) : failed, failed !== '' || all.some(({ severity }) => severity === 'error'));
  }
}
