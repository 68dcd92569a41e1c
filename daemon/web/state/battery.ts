// Warns when the battery comes close to the voltage below which the daemon aborts the run.

const kMargin_v = 0.3;
/** The voltage must be low for this long, because a starting motor lowers it for a moment. */
const kLasting_s = 2;
const kBack_v = 0.1;

export class BatteryWatch {
  private since_s: number | undefined;
  low = false;
  limit_v = NaN;

  take(t_s: number, voltage_v: number | null | undefined, limit_v: number | undefined): void {
    this.limit_v = limit_v ?? NaN;
    const warn_v = this.limit_v + kMargin_v;
    const known = typeof voltage_v === 'number' && limit_v !== undefined && limit_v > 0;
    if (!known || voltage_v > warn_v + (this.low ? kBack_v : 0)) {
      this.since_s = undefined;
      this.low = false;
      return;
    }
    if (this.since_s === undefined || t_s < this.since_s) this.since_s = t_s;
    if (t_s - this.since_s >= kLasting_s) this.low = true;
  }
}
