// The path of a pose: points at a fixed spacing, bounded by dropping every second one when there are too many.

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
