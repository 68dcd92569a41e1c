// What a plot or a view draws of the past, bounded: columns of numbers over time, driven paths, and the range of an axis.

export class Series {
  private readonly columns: Float64Array[];
  private end = 0;
  private filled = 0;

  /** Column 0 is time, ascending; NaN in the others is a gap. */
  constructor(
    readonly width: number,
    readonly capacity: number,
    /** Rows closer in time than this to the one before are left out. */
    private readonly interval_s = 0,
  ) {
    this.columns = Array.from({ length: width }, () => new Float64Array(2 * capacity));
  }

  get length(): number {
    return this.filled;
  }

  /** Oldest time; NaN without rows. */
  get first_s(): number {
    return this.filled === 0 ? NaN : (this.columns[0]?.[this.end - this.filled] ?? NaN);
  }

  /** Newest time; NaN without rows. */
  get last_s(): number {
    return this.filled === 0 ? NaN : (this.columns[0]?.[this.end - 1] ?? NaN);
  }

  push(row: readonly number[]): void {
    const t_s = row[0] ?? NaN;
    if (this.filled > 0) {
      // Time that goes back means another daemon or a scrubbed recording: start over.
      if (t_s < this.last_s) this.clear();
      else if (t_s - this.last_s < this.interval_s) return;
    }
    if (this.end === 2 * this.capacity) {
      for (const column of this.columns) column.copyWithin(0, this.capacity);
      this.end = this.capacity;
    }
    for (let i = 0; i < this.width; i++) {
      const column = this.columns[i];
      if (column !== undefined) column[this.end] = row[i] ?? NaN;
    }
    this.end++;
    this.filled = Math.min(this.filled + 1, this.capacity);
  }

  /** Prepends earlier rows; those not before the present ones are left out. */
  before(rows: Iterable<readonly number[]>): void {
    const kept = this.since(-Infinity).map((column) => column.slice());
    const count = this.filled;
    const first_s = count === 0 ? Infinity : this.first_s;
    this.clear();
    for (const row of rows) if ((row[0] ?? NaN) < first_s) this.push(row);
    for (let i = 0; i < count; i++) this.push(kept.map((column) => column[i] ?? NaN));
  }

  clear(): void {
    this.end = 0;
    this.filled = 0;
  }

  /** Views of the rows from `from_s` on (and one before, so that a line reaches the edge). */
  since(from_s: number): Float64Array[] {
    const times = this.columns[0];
    let low = this.end - this.filled;
    let high = this.end;
    while (times !== undefined && low < high) {
      const middle = (low + high) >> 1;
      if ((times[middle] ?? Infinity) < from_s) low = middle + 1;
      else high = middle;
    }
    const begin = Math.max(low - 1, this.end - this.filled);
    return this.columns.map((column) => column.subarray(begin, this.end));
  }
}

// Slightly less than 1, because coordinates are stored in single precision.
const kTolerance = 0.999;

export class PathHistory {
  private readonly points: Float32Array;
  private count = 0;
  private spacing_m: number;
  private changes = 0;

  constructor(
    readonly capacity = 4000,
    private readonly firstSpacing_m = 0.01,
  ) {
    this.points = new Float32Array(3 * capacity);
    this.spacing_m = firstSpacing_m;
  }

  get length(): number {
    return this.count;
  }

  /** Increases with every change other than an appended point. */
  get generation(): number {
    return this.changes;
  }

  /** x, y, z of each point in turn, oldest first. */
  get coordinates(): Float32Array {
    return this.points.subarray(0, 3 * this.count);
  }

  /** Appends the point if it is far enough from the last one. */
  add(x_m: number, y_m: number, z_m: number): void {
    if (!Number.isFinite(x_m + y_m + z_m)) return;
    const last = 3 * (this.count - 1);
    if (this.count > 0) {
      const away = Math.hypot(x_m - (this.points[last] ?? 0), y_m - (this.points[last + 1] ?? 0));
      if (away < this.spacing_m * kTolerance) return;
    }
    if (this.count === this.capacity) this.thin();
    this.points.set([x_m, y_m, z_m], 3 * this.count);
    this.count++;
  }

  clear(): void {
    this.count = 0;
    this.spacing_m = this.firstSpacing_m;
    this.changes++;
  }

  private thin(): void {
    const kept = this.count >> 1;
    for (let i = 0; i < kept; i++) this.points.copyWithin(3 * i, 6 * i, 6 * i + 3);
    this.count = kept;
    this.spacing_m *= 2;
    this.changes++;
  }
}

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
