// The text of a course file and its pieces. An edit replaces, inserts or removes only the values concerned: comments,
// order and layout of everything else stay as they were written.
import { parseTOML, type AST } from 'toml-eslint-parser';

export type Value = number | string | boolean | Value[];

/** A table: its values by key, and their positions in the text. */
export interface Piece {
  readonly table: string;
  /** Index among the tables of its name. */
  readonly index: number;
  readonly values: Readonly<Record<string, Value>>;
  /** Position of each value in the text. */
  readonly ranges: Readonly<Record<string, readonly [number, number]>>;
  /** From its header to its last value; undefined if it is not written as a table of its own. */
  readonly range: readonly [number, number] | undefined;
}

export class CourseText {
  private readonly pieces_ = new Map<string, Piece[]>();

  /** Throws a SyntaxError for text that is not TOML. */
  constructor(readonly text: string) {
    const [root] = parseTOML(text, { tomlVersion: '1.0.0' }).body;
    this.take('', root.body.filter((each) => each.type === 'TOMLKeyValue'));
    for (const each of root.body) {
      if (each.type === 'TOMLTable') this.take(String(each.resolvedKey[0]), each.body, each.range);
    }
  }

  /** All tables of that name, in the file's order. */
  all(table: string): readonly Piece[] {
    return this.pieces_.get(table) ?? [];
  }

  /** The table of that name, or the keys outside of any table; empty if the file has none. */
  one(table: 'start' | 'fence' | ''): Piece {
    return this.pieces_.get(table)?.[0] ?? { table, index: 0, values: {}, ranges: {}, range: undefined };
  }

  /** The text with other values of a piece. */
  with(piece: Piece, values: Readonly<Record<string, Value>>): string {
    const missing: string[] = [];
    const edits: { from: number; to: number; text: string }[] = [];
    for (const [key, value] of Object.entries(values)) {
      const range = piece.ranges[key];
      if (range === undefined) missing.push(line(key, value));
      else if (!same(piece.values[key], value)) edits.push({ from: range[0], to: range[1], text: written(value) });
    }
    if (missing.length > 0) edits.push(this.inserted(piece, missing));
    // From the end, so that the other positions stay valid.
    edits.sort((a, b) => b.from - a.from);
    return edits.reduce((text, { from, to, text: by }) => text.slice(0, from) + by + text.slice(to), this.text);
  }

  /** The text with one more table, before the one of its name at `index`, or after the last one. */
  added(table: string, values: Readonly<Record<string, Value>>, index = this.all(table).length): string {
    const last = this.all(table).at(-1);
    if (last !== undefined && last.range === undefined) throw inOneLine(last);
    const before = this.all(table)[index]?.range ?? (last === undefined ? this.one('fence').range : undefined);
    const at = before !== undefined ? this.above(before[0]) : last?.range !== undefined ? this.lineEnd(last.range[1]) : this.text.length;
    const body = `[[${table}]]\n${Object.entries(values).map(([key, value]) => line(key, value)).join('')}`;
    return joined(this.text.slice(0, at), body, this.text.slice(at));
  }

  /** The text with `keys` of a piece replaced by `values`. */
  replaced(piece: Piece, keys: readonly string[], values: Readonly<Record<string, Value>>): string {
    const lines = keys.flatMap((key) => piece.ranges[key]?.[0] ?? []).map((at) => this.text.lastIndexOf('\n', at) + 1);
    const first = Math.min(...lines);
    if (!Number.isFinite(first) || piece.range === undefined) throw inOneLine(piece);
    let text = this.text;
    for (const at of lines.sort((a, b) => b - a)) text = text.slice(0, at) + text.slice(this.lineEnd(at));
    return text.slice(0, first) + Object.entries(values).map(([key, value]) => line(key, value)).join('') + text.slice(first);
  }

  /** The text without a piece and without the comments directly above it. */
  removed(piece: Piece): string {
    if (piece.range === undefined) throw inOneLine(piece);
    const from = this.above(piece.range[0]);
    let to = this.lineEnd(piece.range[1]);
    while (this.text[to] === '\n' || this.text.startsWith('\r\n', to)) to += this.text[to] === '\n' ? 1 : 2;
    return this.text.slice(0, from) + this.text.slice(to);
  }

  /** Takes the keys of a table; those outside of any table have the name "". */
  private take(table: string, body: readonly AST.TOMLKeyValue[], range?: AST.Range): void {
    const values: Record<string, Value> = {};
    const ranges: Record<string, readonly [number, number]> = {};
    const inner: [table: string, body: readonly AST.TOMLKeyValue[]][] = [];
    const dotted = new Map<string, AST.TOMLKeyValue[]>();
    for (const each of body) {
      const key = each.key.keys.map((part) => (part.type === 'TOMLBare' ? part.name : part.value));
      const within = table === '' ? (key[0] ?? '') : table;
      const list = each.value.type === 'TOMLArray' ? each.value.elements : [each.value];
      if (list[0]?.type === 'TOMLInlineTable') {
        for (const element of list) if (element.type === 'TOMLInlineTable') inner.push([within, element.body]);
      } else if (table === '' && key.length === 2) {
        // start.x_m = 1
        dotted.set(within, [...(dotted.get(within) ?? []), { ...each, key: { ...each.key, keys: each.key.keys.slice(1) } }]);
      } else {
        const value = valueOf(each.value);
        if (value === undefined) continue;
        values[key.join('.')] = value;
        ranges[key.join('.')] = each.value.range;
      }
    }
    this.add(table, values, ranges, range);
    for (const [name, entries] of [...inner, ...dotted]) this.take(name, entries);
  }

  private add(table: string, values: Record<string, Value>, ranges: Piece['ranges'], range: Piece['range']): void {
    const list = this.pieces_.get(table) ?? [];
    list.push({ table, index: list.length, values, ranges, range });
    this.pieces_.set(table, list);
  }

  private inserted(piece: Piece, lines: readonly string[]): { from: number; to: number; text: string } {
    const only = piece.table === 'start' || piece.table === 'fence';
    if (only && Object.keys(piece.values).length === 0 && piece.range === undefined) {
      const at = this.above(this.all('segment')[0]?.range?.[0] ?? this.text.length);
      return { from: at, to: at, text: `[${piece.table}]\n${lines.join('')}\n` };
    }
    if (piece.range === undefined && piece.table !== '') throw inOneLine(piece);
    const last = Math.max(piece.range?.[1] ?? 0, ...Object.values(piece.ranges).map(([, end]) => end));
    const at = last === 0 ? 0 : this.lineEnd(last);
    const text = at > 0 && this.text[at - 1] !== '\n' ? `\n${lines.join('')}` : lines.join('');
    return { from: at, to: at, text };
  }

  /** The beginning of the comment lines directly above a position. */
  private above(at: number): number {
    let from = this.text.lastIndexOf('\n', at - 1) + 1;
    for (;;) {
      const before = this.text.lastIndexOf('\n', from - 2) + 1;
      if (from === 0 || !/^[ \t]*#/.test(this.text.slice(before, from))) return from;
      from = before;
    }
  }

  /** The position after the line of `at`. */
  private lineEnd(at: number): number {
    const end = this.text.indexOf('\n', at);
    return end < 0 ? this.text.length : end + 1;
  }
}

function joined(before: string, body: string, after: string): string {
  const gap = before === '' || /\n\s*\n$/.test(before) ? '' : before.endsWith('\n') ? '\n' : '\n\n';
  const end = after === '' || /^\r?\n/.test(after) ? '' : '\n';
  return before + gap + body + end + after;
}

function inOneLine(piece: Piece): Error {
  return new Error(`${piece.table} is not written as a table of its own: change it in the text`);
}

function valueOf(node: AST.TOMLContentNode): Value | undefined {
  if (node.type === 'TOMLArray') return node.elements.map(valueOf).filter((each) => each !== undefined);
  if (node.type !== 'TOMLValue') return undefined;
  return typeof node.value === 'object' ? undefined : node.value;
}

function same(a: Value | undefined, b: Value): boolean {
  return a !== undefined && written(a) === written(b);
}

function line(key: string, value: Value): string {
  return `${key} = ${written(value)}\n`;
}

/** A value as a person writes it: numbers with a point, at most to millimetres and thousandths of a degree. */
export function written(value: Value): string {
  if (Array.isArray(value)) return `[${value.map(written).join(', ')}]`;
  if (typeof value !== 'number') return JSON.stringify(value);
  const text = String(Number(value.toFixed(3)) + 0);
  return text.includes('.') ? text : `${text}.0`;
}

const kMaxStates = 200;

export class History {
  private texts: string[] = [''];
  private at = 0;

  /** Begins anew with another file. */
  restart(text: string): void {
    this.texts = [text];
    this.at = 0;
  }

  /** Adds the state after a finished change. */
  add(text: string): void {
    if (text === this.text) return;
    this.texts = [...this.texts.slice(0, this.at + 1), text].slice(-kMaxStates);
    this.at = this.texts.length - 1;
  }

  /** Whether there is a state before, -1, or after the present one, 1. */
  can(step: 1 | -1): boolean {
    return this.texts[this.at + step] !== undefined;
  }

  /** The state before or after, which becomes the present one; without one, the present one. */
  go(step: 1 | -1): string {
    if (this.can(step)) this.at += step;
    return this.text;
  }

  private get text(): string {
    return this.texts[this.at] ?? '';
  }
}
