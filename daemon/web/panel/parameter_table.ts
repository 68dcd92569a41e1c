// Parameters by the tables of the file, each with meaning, unit, limits and default. Live ones change at once; edits of
// others that may be saved are kept until Save and take effect at the next start.
import type { Parameter } from '../state/messages.ts';
import { grouped, limits, matches, type ParameterEdits, read, shown, type Value } from '../state/parameters.ts';
import type { Store } from '../state/store.ts';
import { button, h } from './dom.ts';

export type SetParameter = (name: string, value: Value) => void;

export class ParameterTable {
  readonly element = h('div', { class: 'parts parameter-list' });
  readonly filter = h('input', { type: 'search', placeholder: 'search', 'aria-label': 'Search parameters' });
  private readonly none = h('p', { class: 'empty', hidden: '' }, 'No parameter matches.');
  private shown = -1;
  private groups: { element: HTMLElement; rows: { parameter: Parameter; row: HTMLElement }[] }[] = [];

  constructor(
    private readonly edits: ParameterEdits,
    private readonly set: SetParameter,
    /** An edit was made or taken back. */
    private readonly edited: () => void,
  ) {
    this.filter.addEventListener('input', () => {
      this.narrow();
    });
  }

  /** Redraws everything, including edits and the file's values. */
  refresh(): void {
    this.shown = -1;
  }

  show(store: Store): void {
    const received = store.received['/parameter'] ?? 0;
    if (received === this.shown || this.element.contains(document.activeElement?.closest('.parameter-value') ?? null)) return;
    this.shown = received;
    this.groups = grouped(store.get('/parameter')?.parameters ?? []).map(([table, parameters]) => {
      const rows = parameters.map((parameter) => ({ parameter, row: this.row(parameter) }));
      const heading = h('h3', {}, table, ...(table.startsWith('robot.') ? [h('span', {}, ' of the robot\u2019s file')] : []));
      return { element: h('section', { 'aria-label': table }, heading, ...rows.map(({ row }) => row)), rows };
    });
    this.element.replaceChildren(this.none, ...this.groups.map(({ element }) => element));
    this.narrow();
  }

  private narrow(): void {
    const wanted = this.filter.value.trim();
    let any = false;
    for (const { element, rows } of this.groups) {
      let some = false;
      for (const { parameter, row } of rows) {
        row.hidden = !matches(parameter, wanted);
        some ||= !row.hidden;
      }
      element.hidden = !some;
      any ||= some;
    }
    this.none.hidden = any;
  }

  private row(parameter: Parameter): HTMLElement {
    const edit = this.edits.get(parameter.name);
    const file = this.edits.file(parameter.name);
    const changed = parameter.value !== parameter.default;
    const why = h('p', { class: 'parameter-why', role: 'alert' });
    const facts = [limits(parameter), `default ${shown(parameter.default)}`].filter(Boolean).join(' \u00b7 ');
    const when = parameter.live ? (parameter.when === 'not running' ? 'at once, not during a run' : 'at once') : '';
    return h(
      'div',
      { class: ['parameter', parameter.live ? 'live' : '', changed ? 'changed' : '', edit === undefined ? '' : 'edited'].filter(Boolean).join(' '), 'data-name': parameter.name },
      h(
        'div',
        { class: 'parameter-about' },
        h('strong', {}, parameter.name),
        ...(when === '' ? [] : [h('span', { class: 'parameter-when' }, when)]),
        h('p', {}, parameter.meaning),
        h('p', { class: 'parameter-limits' }, facts),
        ...(file === undefined ? [] : [h('p', { class: 'parameter-file' }, `in the file: ${file}`)]),
        why,
      ),
      h(
        'div',
        { class: 'parameter-value' },
        parameter.live || parameter.may_save === true ? this.field(parameter, edit ?? parameter.value, why) : h('output', {}, shown(parameter.value)),
        h('span', { class: 'parameter-unit' }, parameter.unit),
        ...(edit === undefined ? [] : [this.back(parameter)]),
      ),
    );
  }

  private back(parameter: Parameter): HTMLElement {
    return button({ class: 'link', 'aria-label': `Discard the change of ${parameter.name}` }, `back to ${shown(parameter.value)}`, () => {
      this.edits.drop(parameter.name);
      this.refresh();
      this.edited();
    });
  }

  private take(parameter: Parameter, value: Value): void {
    if (parameter.live) {
      this.set(parameter.name, value);
      return;
    }
    this.edits.set(parameter, value);
    this.refresh();
    this.edited();
  }

  private field(parameter: Parameter, value: Value, why: HTMLElement): HTMLElement {
    if (parameter.type === 'choice') {
      const select = h('select', { 'aria-label': parameter.name });
      for (const choice of parameter.choices) select.append(h('option', { value: choice }, choice));
      select.value = String(value);
      select.addEventListener('change', () => {
        select.blur();
        this.take(parameter, select.value);
      });
      return select;
    }
    if (parameter.type === 'boolean') {
      const check = h('input', { type: 'checkbox', 'aria-label': parameter.name });
      check.checked = value === true;
      check.addEventListener('change', () => {
        check.blur();
        this.take(parameter, check.checked);
      });
      return check;
    }
    const text = parameter.type === 'text';
    const input = h('input', { 'aria-label': parameter.name, inputmode: text ? 'text' : 'decimal', size: '8' });
    input.value = text ? String(value) : shown(value);
    input.addEventListener('change', () => {
      const typed = read(parameter, input.value);
      const wrong = 'why' in typed;
      input.setAttribute('aria-invalid', String(wrong));
      why.textContent = wrong ? typed.why : '';
      if (!wrong) this.take(parameter, typed.value);
    });
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
    return input;
  }
}
