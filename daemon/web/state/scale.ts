// The range of a plot's axis, which changes only in steps.

/** The smallest of 1, 2, 2.5, 5 times a power of ten that is not below `value`. */
function niceStep(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  for (const factor of [1, 2, 2.5, 5]) {
    if (factor * power >= value * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

/** A range around the data that never gets narrower than `soft`, with ends at whole steps. */
export function niceRange(low: number, high: number, soft: readonly [number, number]): [number, number] {
  const from = Math.min(Number.isFinite(low) ? low : soft[0], soft[0]);
  const to = Math.max(Number.isFinite(high) ? high : soft[1], soft[1]);
  const step = niceStep((to - from) / 4);
  const tiny = step * 1e-6;
  return [Math.floor((from + tiny) / step) * step, Math.ceil((to - tiny) / step) * step];
}

/** Smallest and largest number of several columns, gaps left out. */
export function extent(columns: readonly Float64Array[]): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const column of columns) {
    for (const value of column) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
  }
  return [low, high];
}
