// Parameters with unit, limits and default; those that can change while the daemon runs have a
// field.
import type { Parameter } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { h } from './dom.ts';

export type SetParameter = (name: string, value: number | boolean | string) => void;

export class ParameterTable {
  readonly element = h('div', { class: 'parameters', tabindex: '0' });
  private readonly filter = h('input', { type: 'search', placeholder: 'filter', 'aria-label': 'Filter parameters' });
  private readonly body = h('tbody');
  private shown = -1;
  private rows: { text: string; row: HTMLElement }[] = [];

  constructor(private readonly set: SetParameter) {
    const head = ['parameter', 'value', 'unit', 'limits', 'default', 'meaning'].map((title) => h('th', { scope: 'col' }, title));
    this.element.append(this.filter, h('table', {}, h('thead', {}, h('tr', {}, ...head)), this.body));
    this.filter.addEventListener('input', () => {
      this.narrow();
    });
  }

  show(store: Store): void {
    const received = store.received['/parameter'] ?? 0;
    if (received === this.shown || this.element.contains(document.activeElement?.closest('td') ?? null)) return;
    this.shown = received;
    const all = [...(store.get('/parameter')?.parameters ?? [])];
    all.sort((a, b) => Number(b.live) - Number(a.live));
    this.rows = all.map((parameter) => ({
      text: `${parameter.name} ${parameter.meaning}`.toLowerCase(),
      row: this.row(parameter),
    }));
    this.body.replaceChildren(...this.rows.map(({ row }) => row));
    this.narrow();
  }

  private narrow(): void {
    const wanted = this.filter.value.trim().toLowerCase();
    for (const { text, row } of this.rows) row.hidden = !text.includes(wanted);
  }

  private row(parameter: Parameter): HTMLElement {
    const changed = parameter.value !== parameter.default;
    const limits = typeof parameter.min === 'number' ? `${parameter.min} \u2026 ${parameter.max ?? ''}` : parameter.choices.join(' ');
    return h(
      'tr',
      { class: [parameter.live ? 'live' : '', changed ? 'changed' : ''].join(' ').trim() },
      h('th', { scope: 'row' }, parameter.name),
      h('td', { class: 'figure' }, parameter.live ? this.field(parameter) : String(parameter.value)),
      h('td', {}, parameter.unit),
      h('td', { class: 'figure' }, limits),
      h('td', { class: 'figure' }, String(parameter.default)),
      h('td', { class: 'meaning' }, parameter.meaning, parameter.live && parameter.when === 'not running' ? ' (not during a run)' : ''),
    );
  }

  private field(parameter: Parameter): HTMLElement {
    if (parameter.type === 'choice') {
      const select = h('select', { 'aria-label': parameter.name });
      for (const choice of parameter.choices) select.append(h('option', { value: choice }, choice));
      select.value = String(parameter.value);
      select.addEventListener('change', () => {
        this.set(parameter.name, select.value);
        select.blur();
      });
      return select;
    }
    if (parameter.type === 'boolean') {
      const check = h('input', { type: 'checkbox', 'aria-label': parameter.name });
      check.checked = parameter.value === true;
      check.addEventListener('change', () => {
        this.set(parameter.name, check.checked);
      });
      return check;
    }
    const input = h('input', { 'aria-label': parameter.name, inputmode: 'decimal', size: '8' });
    input.value = String(parameter.value);
    const number = parameter.type === 'number' || parameter.type === 'integer';
    input.addEventListener('change', () => {
      const value = number ? Number(input.value) : input.value;
      const outside =
        number &&
        (input.value.trim() === '' || !Number.isFinite(value) || Number(value) < (parameter.min ?? -Infinity) || Number(value) > (parameter.max ?? Infinity));
      input.setAttribute('aria-invalid', String(outside));
      if (!outside) this.set(parameter.name, value);
    });
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') input.blur();
    });
    return input;
  }
}
