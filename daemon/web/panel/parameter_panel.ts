// The Parameters tab: search, the list, and saving to the configuration file after showing the difference.
import { ParameterEdits, type Difference, type SaveAnswer, type Value } from '../state/parameters.ts';
import type { Store } from '../state/store.ts';
import { button, h, Message, setText } from './dom.ts';
import { ParameterTable, type SetParameter } from './parameter_table.ts';
import { reason, type Call } from '../state/service.ts';

export class ParameterPanel {
  readonly element = h('div', { class: 'parameters', tabindex: '0' });
  private readonly save = button({ class: 'control', id: 'parameters-save' }, 'Save \u2026', () => {
    void this.ask('parameters_save', this.edits.wanted(this.all));
  });
  private readonly restore = button({ class: 'control', id: 'parameters-restore', hidden: '' }, 'Undo the last save \u2026', () => {
    void this.ask('parameters_restore', {});
  });
  private readonly message = new Message('parameters-message');
  private readonly question = h('section', { class: 'parameters-question', id: 'parameters-question', 'aria-label': 'Difference', hidden: '' });
  private readonly edits = new ParameterEdits();
  private readonly table: ParameterTable;
  private store: Store | undefined;
  private mayCommand = false;
  private compared = -1;
  private busy = false;

  constructor(
    set: SetParameter,
    private readonly call: Call,
  ) {
    this.table = new ParameterTable(this.edits, set, () => { this.count(); });
    this.element.append(
      h('div', { class: 'tab-bar' }, this.table.filter, this.save, this.restore, this.message.element, this.question),
      this.table.element,
    );
  }

  show(store: Store, connected: boolean, mayCommand: boolean): void {
    this.store = store;
    this.mayCommand = connected && mayCommand;
    this.count();
    this.table.show(store);
    const received = store.received['/parameter'] ?? 0;
    if (this.mayCommand && received > 0 && received !== this.compared) {
      this.compared = received;
      void this.compare();
    }
  }

  private get all() {
    return this.store?.get('/parameter')?.parameters ?? [];
  }

  private count(): void {
    const edits = this.edits.names.length;
    setText(this.save, edits === 0 ? 'Save \u2026' : `Save \u2026 (${edits})`);
    this.save.disabled = this.restore.disabled = !this.mayCommand || this.busy;
  }

  /** Finds the differences between the file and the values in force. */
  private async compare(): Promise<void> {
    try {
      const answer = (await this.call('parameters_save', { check: true, ...this.edits.inForce(this.all) })) as SaveAnswer;
      this.edits.compared(answer);
      this.restore.hidden = !answer.may_restore;
      this.table.refresh();
    } catch (error: unknown) {
      this.message.say(reason(error), true);
    }
  }

  /** Shows the changes and asks for confirmation. */
  private async ask(service: 'parameters_save' | 'parameters_restore', values: Record<string, Value>): Promise<void> {
    const answer = await this.request(service, { ...values, check: true });
    if (answer === undefined) return;
    if (answer.differences.length === 0) {
      this.message.say(`${answer.file} has these values already.`);
      return;
    }
    const restoring = service === 'parameters_restore';
    const chosen = new Map(answer.differences.map(({ name }) => [name, true]));
    const yes = button({ class: 'control', id: 'parameters-write' }, restoring ? 'Undo it' : `Write ${answer.file}`, () => {
      void this.write(service, Object.fromEntries(Object.entries(values).filter(([name]) => chosen.get(name) === true)));
    });
    const no = button({ class: 'control', id: 'parameters-cancel' }, 'Cancel', () => { this.question.hidden = true; });
    const row = (each: Difference): HTMLElement => this.difference(each, restoring ? undefined : (on) => {
      chosen.set(each.name, on);
      yes.disabled = ![...chosen.values()].includes(true);
    });
    this.question.replaceChildren(
      h('p', {}, restoring ? `${answer.file} will get its previous values:` : `${answer.file} will change:`),
      h('ul', {}, ...answer.differences.map(row)),
      h('div', { class: 'buttons' }, yes, no),
    );
    this.message.say('');
    this.question.hidden = false;
    yes.focus();
  }

  private difference({ name, before, after }: Difference, choose: ((on: boolean) => void) | undefined): HTMLElement {
    const about = [h('strong', {}, name), h('del', {}, before), h('ins', {}, after)];
    if (choose === undefined) return h('li', {}, ...about);
    const check = h('input', { type: 'checkbox', 'aria-label': `Save ${name}` });
    check.checked = true;
    check.addEventListener('change', () => {
      choose(check.checked);
    });
    return h('li', {}, h('label', {}, check, ...about));
  }

  private async write(service: 'parameters_save' | 'parameters_restore', values: Record<string, Value>): Promise<void> {
    const answer = await this.request(service, values);
    if (answer === undefined) return;
    this.question.hidden = true;
    for (const name of Object.keys(values)) this.edits.drop(name);
    const later = answer.differences.some(({ name }) => this.all.find((each) => each.name === name)?.live !== true || service === 'parameters_restore');
    this.message.say(`${answer.file} is saved${later ? '; the running daemon keeps its values until it is started again' : ''}.`);
    await this.compare();
    this.count();
  }

  private async request(service: 'parameters_save' | 'parameters_restore', values: Record<string, Value>): Promise<SaveAnswer | undefined> {
    this.busy = true;
    this.count();
    try {
      return (await this.call(service, values)) as SaveAnswer;
    } catch (error: unknown) {
      this.question.hidden = true;
      this.message.say(reason(error), true);
      return undefined;
    } finally {
      this.busy = false;
      this.count();
    }
  }
}
