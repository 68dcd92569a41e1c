// What the connection to the daemon carries, measured by the poses that come.

/** Counted over this time. */
const kSpan_ms = 2000;
/** Fewer than this share of the poses asked for come. */
const kSlowShare = 0.6;
/** A pose that comes this much later than the fastest one. */
const kLate_s = 0.4;

export class LinkPace {
  slow = false;
  /** Poses come as often as asked for. */
  fast = false;
  /** Poses a second, and how old the last one is beyond the fastest. */
  rate_hz = 0;
  late_s = 0;
  private expected_ms = 0;
  private began_ms: number | undefined;
  private count = 0;
  private least_s = Infinity;

  /** Asked for one pose in each such time. */
  expect(interval_ms: number): void {
    if (interval_ms === this.expected_ms) return;
    this.expected_ms = interval_ms;
    this.began_ms = undefined;
  }

  received(t_s: number, now_ms: number): void {
    const delay_s = now_ms / 1000 - t_s;
    this.least_s = Math.min(this.least_s, delay_s);
    if (this.began_ms === undefined) {
      this.began_ms = now_ms;
      this.count = 0;
      return;
    }
    this.count++;
    const span_ms = now_ms - this.began_ms;
    if (span_ms < kSpan_ms) return;
    this.rate_hz = (1000 * this.count) / span_ms;
    this.late_s = delay_s - this.least_s;
    this.fast = this.rate_hz * this.expected_ms > 1000 * kSlowShare && this.late_s < kLate_s;
    this.slow = !this.fast;
    this.began_ms = now_ms;
    this.count = 0;
  }

  /** The connection ended: the next daemon has another clock. */
  forget(): void {
    this.slow = this.fast = false;
    this.began_ms = undefined;
    this.least_s = Infinity;
  }
}
