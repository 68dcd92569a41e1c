// Editing of parameters: meaning of typed text, edits that are not saved yet, and the configuration file's values.
import { hasWords } from './format.ts';
import type { Parameter } from './messages.ts';

export type Value = Parameter['value'];

/** A change of the file; `before` and `after` as written in it. */
export interface Difference {
  name: string;
  before: string;
  after: string;
}

/** The answer of `parameters_save` and `parameters_restore`. */
export interface SaveAnswer {
  file: string;
  may_restore: boolean;
  differences: Difference[];
}

/** A value as the daemon writes it: ten digits, which hide binary rounding. */
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

/** The value of a typed text, or why it is not valid. */
export function read(parameter: Parameter, text: string): { value: Value } | { why: string } {
  if (parameter.type === 'text') return { value: text };
  const value = text.trim() === '' ? NaN : Number(text);
  if (!Number.isFinite(value)) return { why: `a number from ${limits(parameter)}` };
  if (parameter.type === 'integer' && !Number.isInteger(value)) return { why: `a whole number from ${limits(parameter)}` };
  const inside = value >= (parameter.min ?? -Infinity) && value <= (parameter.max ?? Infinity);
  return inside ? { value } : { why: `allowed is ${limits(parameter)}` };
}

/** Parameters by table of the file, in its order; `robot` last. */
export function grouped(parameters: readonly Parameter[]): [table: string, parameters: Parameter[]][] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parameters) {
    const table = parameter.name.slice(0, Math.max(parameter.name.lastIndexOf('.'), 0)) || 'run';
    groups.set(table, [...(groups.get(table) ?? []), parameter]);
  }
  return [...groups];
}

/** Whether every word of the search occurs in name, unit, meaning or choices. */
export function matches(parameter: Parameter, search: string): boolean {
  return hasWords(`${parameter.name} ${parameter.unit} ${parameter.meaning} ${parameter.choices.join(' ')}`, search);
}

/** Edits of parameters that take effect only at the next start, and the file's values. */
export class ParameterEdits {
  private readonly edits = new Map<string, Value>();
  private inFile = new Map<string, string>();

  get(name: string): Value | undefined {
    return this.edits.get(name);
  }

  get names(): string[] {
    return [...this.edits.keys()];
  }

  /** Records an edit. The value in force is not an edit, unless the file has another one. */
  set(parameter: Parameter, value: Value): void {
    const back = plain(value) === plain(parameter.value) && !this.inFile.has(parameter.name);
    if (back) this.edits.delete(parameter.name);
    else this.edits.set(parameter.name, value);
  }

  drop(name: string): void {
    this.edits.delete(name);
  }

  /** The file's value as written there, if it is not the one in force. */
  file(name: string): string | undefined {
    return this.inFile.get(name);
  }

  /** Every parameter that may be saved, with the value in force; the daemon compares the file with it. */
  inForce(parameters: readonly Parameter[]): Record<string, Value> {
    const all: Record<string, Value> = {};
    for (const parameter of parameters) {
      // Without texts: a course or a robot that was given as a file has no name to save.
      if (parameter.may_save === true && parameter.type !== 'text') all[parameter.name] = plain(parameter.value);
    }
    return all;
  }

  /** What Save writes: the edits, and the live parameters, whose values are in force already. */
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
