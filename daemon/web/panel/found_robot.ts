// Result of an identification: every parameter and the errors before and after, and the new robot file to save.
import { degrees, fixed } from '../state/format.ts';
import { decimals, fileName, type Errors, type FoundParameter, type Identified, type AddedSlip } from '../state/identify.ts';
import { nameOf, type SetupList } from '../state/setup.ts';
import { button, h, setText, type Message } from './dom.ts';
import { reason, type Call } from '../state/service.ts';

export class FoundRobot {
  readonly element = h('section', { class: 'identify-found', 'aria-label': 'What was identified', hidden: '' });
  private readonly name = h('input', { type: 'text', id: 'identify-name', maxlength: '64', 'aria-label': 'Name of the new robot file' });
  private readonly save = button({ class: 'control', id: 'identify-save' }, 'Save', () => void this.attempt(() => this.write()));
  private readonly use = button({ class: 'control', id: 'identify-use', hidden: '' }, 'Use it for the next run', () => void this.attempt(() => this.choose()));
  private readonly always = button({ class: 'control', id: 'identify-always', hidden: '' }, 'Use it at every start', () => void this.attempt(() => this.configure()));
  private readonly kept = h('p', { class: 'identify-kept' });
  private text = '';
  private saved = '';
  private setup: SetupList | undefined;
  private may = false;

  constructor(
    private readonly call: Call,
    private readonly message: Message,
  ) {
    this.name.addEventListener('input', () => { this.named(); });
  }

  enable(may: boolean): void {
    this.may = may;
    const taken = this.robot();
    this.save.disabled = !may || nameOf(this.name.value) !== this.name.value || this.name.value === '' || (taken !== undefined && taken.from !== 'own');
    this.use.disabled = this.always.disabled = !may;
  }

  show({ found, text }: Identified, setup: SetupList): void {
    this.text = text;
    this.setup = setup;
    this.name.value = fileName(setup, found.robot);
    const changed = found.parameters.filter((each) => each.found && each.value !== each.before);
    const head = ['parameter', 'before', 'identified', '95 %'].map((title) => h('th', { scope: 'col' }, title));
    this.element.replaceChildren(
      h('h3', {}, `Robot ${found.robot}: ${changed.length} of ${found.parameters.length} parameters change`),
      h('table', {}, h('thead', {}, h('tr', {}, ...head)), h('tbody', {}, ...found.parameters.map(row))),
      ...found.slopes.map((slope) => h('p', { class: 'identify-slope' }, added(slope))),
      h('p', { class: 'identify-errors' }, errors('Errors with the file in use', found.errors_before)),
      h('p', { class: 'identify-errors' }, errors('Errors with the new file', found.errors_after)),
      h('ul', { class: 'identify-warnings' }, ...found.warnings.map((line) => h('li', {}, line))),
      h('div', { class: 'buttons' }, h('label', {}, 'save as ', this.name, ' .toml '), this.save, this.use, this.always),
      this.kept,
    );
    this.element.hidden = false;
    this.use.hidden = this.always.hidden = true;
    this.named();
  }

  private robot(): SetupList['robots'][number] | undefined {
    return this.setup?.robots.find(({ name }) => name === this.name.value);
  }

  private named(): void {
    const taken = this.robot();
    const text =
      taken === undefined ? 'The file in use stays as it is.' : taken.from === 'own' ? `${taken.name}.toml is replaced and kept as ${taken.name}.toml.bak.` : `${taken.name} is not one of your own files: give another name.`;
    setText(this.kept, text);
    this.enable(this.may);
  }

  private async attempt(work: () => Promise<string>): Promise<void> {
    try {
      this.message.say(await work());
    } catch (error: unknown) {
      this.message.say(reason(error), true);
    }
  }

  private async write(): Promise<string> {
    const name = this.name.value;
    await this.call('file_save', { kind: 'robot', name, text: this.text, replace: this.robot() !== undefined });
    this.saved = name;
    this.use.hidden = this.always.hidden = false;
    return `${name}.toml is saved, but not in use: tp100d keeps its present robot, also after a restart, until you choose another one.`;
  }

  private async choose(): Promise<string> {
    await this.call('choose', { robot: this.saved });
    return `${this.saved} is in use until tp100d ends.`;
  }

  /** Chooses the saved robot now, and in the configuration file for the next start. */
  private async configure(): Promise<string> {
    await this.choose();
    const { file } = (await this.call('parameters_save', { robot: this.saved })) as { file: string };
    return `${this.saved} is in use, and from ${file} at every start; an option --robot would have priority.`;
  }
}

function row({ name, before, found, value, half_interval }: FoundParameter): HTMLElement {
  const digits = decimals(half_interval);
  const title = h('th', { scope: 'row' }, name);
  if (!found || value === undefined) return h('tr', { 'data-name': name, 'data-found': 'false' }, title, h('td', {}, fixed(before, digits)), h('td', { colspan: '2' }, 'not determined by these drives'));
  const changes = value !== before;
  return h(
    'tr',
    { 'data-name': name, 'data-found': 'true' },
    title,
    h('td', {}, changes ? h('del', {}, fixed(before, digits)) : fixed(before, digits)),
    h('td', {}, changes ? h('ins', {}, fixed(value, digits)) : fixed(value, digits)),
    h('td', {}, `\u00b1 ${fixed(half_interval, digits)}`),
  );
}

function added({ slope_deg, added_left, added_right }: AddedSlip): string {
  return `A slope of ${fixed(slope_deg, 1)}\u00b0 adds ${fixed(added_left, 3)} to the slip ratio of the left track and ${fixed(added_right, 3)} to that of the right one.`;
}

/** Errors against the camera, or those of the worst drive against the measurements by hand. */
function errors(of: string, { rms_m, max_m, rms_rad, runs }: Errors): string {
  if (rms_m !== undefined) return `${of}, against the camera: ${fixed(100 * rms_m, 2)} cm rms, ${fixed(100 * (max_m ?? NaN), 2)} cm at most, ${degrees(rms_rad, 2)}\u00b0 rms.`;
  const worst = (values: (number | undefined)[]): number | undefined => {
    const known = values.flatMap((value) => (value === undefined ? [] : [Math.abs(value)]));
    return known.length === 0 ? undefined : Math.max(...known);
  };
  const distance_m = worst(runs.map((run) => run.distance_off_m));
  const turned_rad = worst(runs.map((run) => run.turned_off_rad));
  return `${of}, against what was measured by hand: ${fixed(distance_m === undefined ? null : 100 * distance_m, 2)} cm and ${degrees(turned_rad, 2)}\u00b0 at most.`;
}
