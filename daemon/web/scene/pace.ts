// Controls frame rate and detail, so that a slow graphics card never delays STOP.

const kSlow_ms = 45;
const kSlowFrames = 40;
/** Largest fraction of the page's time that slow frames may take. */
const kShare = 0.5;

export class Pace {
  private drawn_ms = -Infinity;
  private free_ms = -Infinity;
  private slow = 0;
  private waiting = false;

  /** Frames are slow: without shadows and coarse. Detail is never restored, which would flicker. */
  coarse = false;

  /** Call on every frame; true if this one may be drawn. */
  tick(now_ms: number): boolean {
    if (this.waiting) {
      this.waiting = false;
      const cost_ms = now_ms - this.drawn_ms;
      this.free_ms = cost_ms > kSlow_ms ? now_ms + cost_ms * (1 / kShare - 1) : -Infinity;
      this.slow = cost_ms > kSlow_ms ? this.slow + 1 : Math.max(0, this.slow - 1);
      if (this.slow > kSlowFrames) this.coarse = true;
    }
    return now_ms >= this.free_ms;
  }

  /** A frame was drawn; the next tick shows how long it took. */
  drawn(now_ms: number): void {
    this.drawn_ms = now_ms;
    this.waiting = true;
  }
}
