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

export type KeyChange = 'pressed' | 'repeated' | 'released';

/** The part of a Gamepad that is read. Not its `timestamp`, which some browsers renew while the device is silent. */
export interface Pad {
  index: number;
  connected: boolean;
  axes: readonly number[];
  buttons: readonly { value: number }[];
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

/**
 * The release of a key may get lost: by a remote desktop, or with its window. A keyboard repeats the key that was pressed
 * last, first after 250 to 660 ms, then at least twice a second. Silence for this long: that key is released, and with it
 * all others, because they have the same way.
 */
export const kRepeat_ms = 1000;
/**
 * When that key is released, the keyboard falls silent, also if another one is still held (W, then A, then A is let go):
 * this cannot be told from a release that got lost. The key counts for this long after the last sign of the keyboard, long
 * enough to steer by short presses of another key; whoever goes straight on for longer presses it again.
 */
export const kLastKey_ms = 2000;
/**
 * A gamepad with a deflected stick and no change of any axis or button for this long counts as disconnected or stuck. A
 * thumb trembles 8 to 12 times a second, by more than the step of the coarsest sticks (1/128), except at the stick's end.
 */
export const kFrozen_ms = 500;
const kDeadZone = 0.12;
/** Full speed before the stick's end stop: at the stop its values may not change although it is held. */
const kFullTravel = 0.9;

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
  /** True: a key was held until the keyboard fell silent, or will soon count as released for that. */
  silent = false;
  private readonly held = new Set<string>();
  /** The key that the keyboard repeats; empty: none. */
  private repeats = '';
  private spoke_ms = -Infinity;
  private stick: { forward: number; left: number } | undefined;
  private padIndex = -1;
  private padValues = '';
  private padChanged_ms = -Infinity;

  constructor(
    private readonly pads: () => readonly (Pad | null)[],
    private readonly now: () => number,
  ) {}

  /** Records what any key did; false if it is not a driving key. A key that was not pressed here drives nothing. */
  key(code: string, change: KeyChange): boolean {
    // A key may have counted as released before this one shows that the keyboard is alive.
    this.keys(this.now());
    this.spoke_ms = this.now();
    if (change !== 'released') this.repeats = code;
    else if (this.repeats === code) this.repeats = '';
    if (!(code in kKeys)) return false;
    if (change === 'repeated') return true;
    this.silent = false;
    if (change === 'pressed') this.held.add(code);
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
    this.frozen = this.silent = false;
    this.padChanged_ms = -Infinity;
  }

  wish(): Wish {
    const now_ms = this.now();
    const pad = this.pad(now_ms);
    this.keys(now_ms);
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

  /** Forgets the keys that the keyboard no longer vouches for. */
  private keys(now_ms: number): void {
    if (this.held.size === 0) return;
    const silent_ms = now_ms - this.spoke_ms;
    this.silent = silent_ms > kRepeat_ms;
    if (silent_ms > (this.repeats === '' ? kLastKey_ms : kRepeat_ms)) this.held.clear();
  }

  /** Gamepads are only polled, and a pad out of range keeps its last values: they count only while they change. */
  private pad(now_ms: number): Wish | undefined {
    const pad = this.pads().find((each) => each?.connected === true && each.axes.length >= 2);
    const values = pad ? [...pad.axes, ...pad.buttons.map(({ value }) => value)].join(' ') : '';
    const index = pad?.index ?? -1;
    // The first values of a pad do not show that it is connected.
    if (index !== this.padIndex) this.padChanged_ms = -Infinity;
    else if (values !== this.padValues) this.padChanged_ms = now_ms;
    this.padIndex = index;
    this.padValues = values;
    this.frozen = false;
    if (!pad) return undefined;
    const forward = travel(-(pad.axes[1] ?? 0));
    const left = travel(-(pad.axes[0] ?? 0));
    if (forward === 0 && left === 0) return undefined;
    this.frozen = now_ms - this.padChanged_ms > kFrozen_ms;
    if (this.frozen) return { forward: 0, left: 0, source: 'gamepad', at_ms: now_ms };
    return { forward, left, source: 'gamepad', at_ms: now_ms };
  }
}
