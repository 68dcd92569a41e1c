// What the person at this page wants of the robot: keys, a touch stick or a gamepad, and when the
// person last gave it. A control that may be frozen is ignored.

/** Where a wish comes from. */
export type Source = 'none' | 'keys' | 'stick' | 'gamepad';

export interface Wish {
  /** -1 backwards to 1 forwards. */
  forward: number;
  /** -1 clockwise to 1 counter-clockwise. */
  left: number;
  source: Source;
  /** When the person gave it, on the page's clock. */
  at_ms: number;
}

/** The part of a Gamepad that is read. */
export interface Pad {
  connected: boolean;
  timestamp: number;
  axes: readonly number[];
}

/** Keys by their place on the keyboard, whatever its language. */
const kKeys: Record<string, { forward: number; left: number }> = {
  ArrowUp: { forward: 1, left: 0 },
  KeyW: { forward: 1, left: 0 },
  ArrowDown: { forward: -1, left: 0 },
  KeyS: { forward: -1, left: 0 },
  ArrowLeft: { forward: 0, left: 1 },
  KeyA: { forward: 0, left: 1 },
  ArrowRight: { forward: 0, left: -1 },
  KeyD: { forward: 0, left: -1 },
};

/** Values of a gamepad that have not changed for this long are those of a device that is gone or stuck. */
export const kFrozen_ms = 150;
const kDeadZone = 0.12;
/** Full speed before the stop of the stick: there, its values may stand still in a living hand. */
const kFullTravel = 0.9;

export function isDriveKey(code: string): boolean {
  return code in kKeys;
}

function clamp(value: number): number {
  return Math.max(-1, Math.min(1, value));
}

/** A gamepad's axis, from the edge of the dead zone to full travel. */
export function travel(axis: number): number {
  const size = Math.abs(axis);
  if (!(size > kDeadZone)) return 0;
  return Math.sign(axis) * Math.min(1, (size - kDeadZone) / (kFullTravel - kDeadZone));
}

export class Inputs {
  /** The gamepad is deflected, but its values do not change. */
  frozen = false;
  private readonly held = new Set<string>();
  private stick: { forward: number; left: number } | undefined;
  private padValues = '';
  private padChanged_ms = -Infinity;

  constructor(
    private readonly pads: () => readonly (Pad | null)[],
    private readonly now: () => number,
  ) {}

  /** False: the key is none that drives. */
  key(code: string, down: boolean): boolean {
    if (!isDriveKey(code)) return false;
    if (down) this.held.add(code);
    else this.held.delete(code);
    return true;
  }

  /** The touch stick is held there; undefined: it was let go. */
  touch(at: { forward: number; left: number } | undefined): void {
    this.stick = at;
  }

  /** The focus or the page is gone: whatever was held counts no more. */
  clear(): void {
    this.held.clear();
    this.stick = undefined;
    this.frozen = false;
    this.padChanged_ms = -Infinity;
  }

  wish(): Wish {
    const now_ms = this.now();
    const pad = this.pad(now_ms);
    // The browser reports the end of a press or a touch, or takes the focus away: held means held.
    if (this.stick !== undefined)
      return { forward: clamp(this.stick.forward), left: clamp(this.stick.left), source: 'stick', at_ms: now_ms };
    if (this.held.size > 0) {
      let forward = 0;
      let left = 0;
      for (const code of this.held) {
        forward += kKeys[code]?.forward ?? 0;
        left += kKeys[code]?.left ?? 0;
      }
      return { forward: clamp(forward), left: clamp(left), source: 'keys', at_ms: now_ms };
    }
    return pad ?? { forward: 0, left: 0, source: 'none', at_ms: now_ms };
  }

  /** A gamepad is only polled, and a poll repeats the last values of a pad that is out of reach. */
  private pad(now_ms: number): Wish | undefined {
    const pad = this.pads().find((each) => each?.connected === true && each.axes.length >= 2);
    const values = pad ? `${String(pad.timestamp)} ${pad.axes.join(' ')}` : '';
    // The first look at a pad does not show that it lives.
    if (values !== this.padValues && this.padValues !== '') this.padChanged_ms = now_ms;
    this.padValues = values;
    this.frozen = false;
    if (!pad) return undefined;
    const forward = travel(-(pad.axes[1] ?? 0));
    const left = travel(-(pad.axes[0] ?? 0));
    if (forward === 0 && left === 0) return undefined;
    this.frozen = now_ms - this.padChanged_ms > kFrozen_ms;
    if (this.frozen) return { forward: 0, left: 0, source: 'gamepad', at_ms: now_ms };
    return { forward, left, source: 'gamepad', at_ms: this.padChanged_ms };
  }
}
