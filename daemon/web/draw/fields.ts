// Input fields for the values of the selected piece.
import { h } from '../panel/dom.ts';
import { kValues } from './draft.ts';
import type { Piece, Value } from './course_text.ts';

/** Keys that a table may have beside those that are written. */
const kOf: Record<string, Record<string, Value>> = {
  ...kValues,
  '': { description: '', speed_mps: 0.1 },
  start: { x_m: 0, y_m: 0, yaw_deg: 0 },
};
const kTitles: Record<string, string> = { '': 'course', keep_out: 'keep-out area' };

const kUnits: Record<string, string> = { m: 'm', mps: 'm/s', deg: '\u00b0', s: 's' };

/** A key of the file in words, for example "speed [m/s]". */
function wordOf(key: string): string {
  const parts = key.split('_');
  const unit = parts.length > 1 ? kUnits[parts.at(-1) ?? ''] : undefined;
  return unit === undefined ? parts.join(' ') : `${parts.slice(0, -1).join(' ')} [${unit}]`;
}

/** The fields of a piece; `set` is called with each value that was typed. */
export function fields(piece: Piece, set: (key: string, value: Value) => void): HTMLElement {
  const many = piece.table in kValues;
  const title = `${kTitles[piece.table] ?? piece.table}${many ? ` ${piece.index + 1}` : ''}`;
  const form = h('div', { class: 'draw-fields', role: 'group', 'aria-label': title }, h('h3', {}, title));
  const known = kOf[piece.table] ?? {};
  for (const key of new Set([...Object.keys(piece.values), ...Object.keys(known)])) {
    const value = piece.values[key] ?? known[key];
    if (value === undefined || Array.isArray(value) || typeof value === 'boolean' || key === 'type') continue;
    const number = typeof value === 'number';
    const input = h('input', { type: number ? 'number' : 'text', name: key, step: 'any', value: String(value) });
    input.addEventListener('change', () => {
      const typed = number ? Number(input.value) : input.value;
      if (input.value !== '' && (!number || Number.isFinite(typed))) set(key, typed);
    });
    form.append(h('label', {}, `${wordOf(key)} `, input));
  }
  return form;
}
