// Columns of numbers over time, bounded: the newest `capacity` rows, contiguous for a plot.

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
