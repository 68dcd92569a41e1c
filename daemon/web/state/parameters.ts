// Parameters as an operator edits them: what a typed text means, what is not saved yet, and what the configuration file has.
import type { Parameter } from './messages.ts';

export type Value = Parameter['value'];

/** `before` and `after` as written in the file. */
export interface Difference {
  name: string;
  before: string;
  after: string;
}

/** The answer of `parameters_save` and `parameters_restore`. */
export interface SaveAnswer {
  file: string;
  written: boolean;
  may_restore: boolean;
  differences: Difference[];
}

/** As the daemon writes it: ten digits, so that no binary fraction shows. */
export function plain(value: Value): Value {
  return typeof value === 'number' ? Number(value.toPrecision(10)) : value;
}

export function shown(value: Value): string {
  return value === '' ? '""' : String(plain(value));
}

export function limits(parameter: Parameter): string {
  if (parameter.type === 'choice') return parameter.choices.join(', ');
  if (typeof parameter.min !== 'number' || typeof parameter.max !== 'number') return '';
  return `${shown(parameter.min)} to ${shown(parameter.max)}${parameter.unit === '' ? '' : ` ${parameter.unit}`}`;
}

/** What a typed text means for a parameter, or why it means nothing. */
export function read(parameter: Parameter, text: string): { value: Value } | { why: string } {
  if (parameter.type === 'text') return { value: text };
  const value = text.trim() === '' ? NaN : Number(text);
  if (!Number.isFinite(value)) return { why: `a number from ${limits(parameter)}` };
  if (parameter.type === 'integer' && !Number.isInteger(value)) return { why: `a whole number from ${limits(parameter)}` };
  const inside = value >= (parameter.min ?? -Infinity) && value <= (parameter.max ?? Infinity);
  return inside ? { value } : { why: `allowed is ${limits(parameter)}` };
}

/** By the table of the file, in its order; `robot` last, as it comes. */
export function grouped(parameters: readonly Parameter[]): [table: string, parameters: Parameter[]][] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parameters) {
    const table = parameter.name.slice(0, Math.max(parameter.name.lastIndexOf('.'), 0)) || 'run';
    groups.set(table, [...(groups.get(table) ?? []), parameter]);
  }
  return [...groups];
}

/** Whether every word of the search occurs in name, unit or meaning. */
export function matches(parameter: Parameter, search: string): boolean {
  const text = `${parameter.name} ${parameter.unit} ${parameter.meaning} ${parameter.choices.join(' ')}`.toLowerCase();
  return search.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}

/** What was typed for parameters that are in force from the next start only, and the file's values. */
export class ParameterEdits {
  private readonly edits = new Map<string, Value>();
  private inFile = new Map<string, string>();

  get(name: string): Value | undefined {
    return this.edits.get(name);
  }

  get names(): string[] {
    return [...this.edits.keys()];
  }

  /** The value in force again is no edit, unless the file has another one. */
  set(parameter: Parameter, value: Value): void {
    const back = plain(value) === plain(parameter.value) && !this.inFile.has(parameter.name);
    if (back) this.edits.delete(parameter.name);
    else this.edits.set(parameter.name, value);
  }

  drop(name: string): void {
    this.edits.delete(name);
  }

  /** The file's value as written there, where it is not the one in force. */
  file(name: string): string | undefined {
    return this.inFile.get(name);
  }

  /** Every parameter that may be saved, with the value in force: against it the daemon compares the file. */
  inForce(parameters: readonly Parameter[]): Record<string, Value> {
    const all: Record<string, Value> = {};
    for (const parameter of parameters) {
      // A course or a robot that was given as a file has no name to save.
      if (parameter.may_save === true && parameter.type !== 'text') all[parameter.name] = plain(parameter.value);
    }
    return all;
  }

  /** What Save saves: what was typed, and the live parameters, whose values are in force already. */
  wanted(parameters: readonly Parameter[]): Record<string, Value> {
    const all: Record<string, Value> = {};
    for (const parameter of parameters) {
      if (parameter.may_save !== true) continue;
      const edit = this.edits.get(parameter.name);
      if (edit !== undefined) all[parameter.name] = plain(edit);
      else if (parameter.live) all[parameter.name] = plain(parameter.value);
    }
    return all;
  }

  /** The answer to a check of `inForce`. */
  compared(answer: SaveAnswer): void {
    this.inFile = new Map(answer.differences.map(({ name, before }) => [name, before]));
  }
}
