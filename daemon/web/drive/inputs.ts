// The person's input by keys, touch stick or gamepad, with the time at which it was given. The input
// of a device that may be frozen is ignored.

/** Source of a wish. */
export type Source = 'none' | 'keys' | 'stick' | 'gamepad';

export interface Wish {
  /** -1 backwards to 1 forwards. */
  forward: number;
  /** -1 clockwise to 1 counter-clockwise. */
  left: number;
  source: Source;
  /** When it was given, on the page's clock. */
  at_ms: number;
}

/** The part of a Gamepad that is read. */
export interface Pad {
  connected: boolean;
  timestamp: number;
  axes: readonly number[];
}

/** Keys by their position on the keyboard, independent of its layout. */
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

/** If the values of a gamepad have not changed for this long, it counts as disconnected or stuck. */
export const kFrozen_ms = 150;
const kDeadZone = 0.12;
/** Full speed before the stick's end stop: at the stop its values may not change although it is held. */
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
  /** True: the gamepad's stick is deflected, but its values do not change. */
  frozen = false;
  private readonly held = new Set<string>();
  private stick: { forward: number; left: number } | undefined;
  private padValues = '';
  private padChanged_ms = -Infinity;

  constructor(
    private readonly pads: () => readonly (Pad | null)[],
    private readonly now: () => number,
  ) {}

  /** Records a key; false if it is not a driving key. */
  key(code: string, down: boolean): boolean {
    if (!isDriveKey(code)) return false;
    if (down) this.held.add(code);
    else this.held.delete(code);
    return true;
  }

  /** Position of the touch stick; undefined: it was released. */
  touch(at: { forward: number; left: number } | undefined): void {
    this.stick = at;
  }

  /** Call when the page loses the focus or is closed: forgets everything that was held. */
  clear(): void {
    this.held.clear();
    this.stick = undefined;
    this.frozen = false;
    this.padChanged_ms = -Infinity;
  }

  wish(): Wish {
    const now_ms = this.now();
    const pad = this.pad(now_ms);
    // Reliable without a time limit: the browser reports the end of a press or touch, or the focus is lost.
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

  /** Gamepads are only polled, and a pad out of range keeps its last values: they count only while they change. */
  private pad(now_ms: number): Wish | undefined {
    const pad = this.pads().find((each) => each?.connected === true && each.axes.length >= 2);
    const values = pad ? `${String(pad.timestamp)} ${pad.axes.join(' ')}` : '';
    // The first values of a pad do not show that it is connected.
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
