// Numbers as text of constant width, so that nothing on the page moves; and words in texts.

const kMinus = '\u2212';
export const kUnknown = '\u2013';

const isKnown = (value: number | null | undefined): value is number =>
  value !== null && value !== undefined && Number.isFinite(value);

/** A number with `decimals` digits after the point and a true minus sign; a dash if not known. Never "-0". */
export function fixed(value: number | null | undefined, decimals: number): string {
  if (!isKnown(value)) return kUnknown;
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? kMinus + text : text;
}

export function degrees(value_rad: number | null | undefined, decimals: number): string {
  return fixed(isKnown(value_rad) ? (value_rad * 180) / Math.PI : null, decimals);
}

export function millimetres(value_m: number | null | undefined, decimals: number): string {
  return fixed(isKnown(value_m) ? value_m * 1000 : null, decimals);
}

export function percent(ratio: number | null | undefined, decimals: number): string {
  return fixed(isKnown(ratio) ? ratio * 100 : null, decimals);
}

/** For example 7 µs, 1.2 ms, 3.4 s. */
export function duration(value_us: number | null | undefined): string {
  if (!isKnown(value_us)) return kUnknown;
  if (value_us > 0 && value_us < 0.95) return `${value_us.toFixed(1)} µs`;
  if (value_us < 1000) return `${value_us.toFixed(0)} µs`;
  if (value_us < 10_000) return `${(value_us / 1000).toFixed(1)} ms`;
  if (value_us < 1_000_000) return `${(value_us / 1000).toFixed(0)} ms`;
  return `${(value_us / 1e6).toFixed(1)} s`;
}

/** For example 1:02.3, or 1:02:03 from an hour on. */
export function clock(value_s: number | null | undefined): string {
  if (!isKnown(value_s) || value_s < 0) return kUnknown;
  const tenths = Math.floor(value_s * 10 + 1e-6);
  const seconds = Math.floor(tenths / 10);
  const two = (value: number): string => String(value).padStart(2, '0');
  if (seconds >= 3600) {
    return `${Math.floor(seconds / 3600)}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
  }
  return `${Math.floor(seconds / 60)}:${two(seconds % 60)}.${tenths % 10}`;
}

/** For example 14:03:07, in the viewer's time zone. */
export function wallClock(unix_s: number): string {
  return new Date(1000 * unix_s).toTimeString().slice(0, 8);
}

export function bytes(value: number | null | undefined): string {
  if (!isKnown(value)) return kUnknown;
  const units = ['B', 'kB', 'MB', 'GB'];
  let unit = 0;
  let size = value;
  while (size >= 1000 && unit < units.length - 1) {
    size /= 1000;
    unit++;
  }
  return `${size.toFixed(unit === 0 || size >= 100 ? 0 : 1)} ${units[unit] ?? ''}`;
}

export function count(value: number | null | undefined): string {
  if (!isKnown(value)) return kUnknown;
  return Math.round(value).toString().replace(/\B(?=(\d{3})+$)/g, '\u2009');
}

/** Whether every word of a search occurs in a text. */
export function hasWords(text: string, search: string): boolean {
  return search.trim().toLowerCase().split(/\s+/).every((word) => text.toLowerCase().includes(word));
}
