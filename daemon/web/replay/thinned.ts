// Items over time, bounded: when there are too many, every second one is dropped and fewer are
// accepted.

export class Thinned<T extends { readonly time_s: number }> {
  readonly items: T[] = [];

  constructor(
    private readonly capacity: number,
    private interval_s: number,
  ) {}

  /** Whether an item of this time would be accepted. */
  wants(time_s: number): boolean {
    const last = this.items.at(-1);
    return last === undefined || time_s - last.time_s >= this.interval_s;
  }

  add(item: T): void {
    if (!this.wants(item.time_s)) return;
    if (this.items.length === this.capacity) {
      for (let i = 0; 2 * i < this.capacity; i++) {
        const kept = this.items[2 * i];
        if (kept !== undefined) this.items[i] = kept;
      }
      this.items.length = Math.ceil(this.capacity / 2);
      const span_s = (this.items.at(-1)?.time_s ?? 0) - (this.items[0]?.time_s ?? 0);
      this.interval_s = Math.max(2 * this.interval_s, span_s / this.items.length);
      if (!this.wants(item.time_s)) return;
    }
    this.items.push(item);
  }
}
