// Keys, stick and gamepad: what a person wants, and that nothing drives once the person has let go.
import { beforeEach, describe, expect, it } from 'vitest';
import { Inputs, kFrozen_ms, kLastKey_ms, kRepeat_ms, travel, type Pad } from '../../../daemon/web/drive/inputs.ts';
import { random } from './random.ts';

let now_ms = 1000;
let pads: (Pad | null)[] = [];
let inputs: Inputs;

beforeEach(() => {
  now_ms = 1000;
  pads = [];
  inputs = new Inputs(
    () => pads,
    () => now_ms,
  );
});

describe('the inputs', () => {
  it('follow keys by their place, as long as they are held', () => {
    expect(inputs.wish()).toEqual({ forward: 0, left: 0, source: 'none', at_ms: 1000 });
    expect(inputs.key('KeyW', 'pressed')).toBe(true);
    inputs.key('ArrowLeft', 'pressed');
    now_ms = 1900;
    expect(inputs.wish()).toEqual({ forward: 1, left: 1, source: 'keys', at_ms: 1900 });
    inputs.key('KeyS', 'pressed');
    inputs.key('ArrowUp', 'pressed');
    expect(inputs.wish().forward).toBe(1);
    for (const code of ['KeyW', 'ArrowUp']) inputs.key(code, 'released');
    expect(inputs.wish().forward).toBe(-1);
    expect(inputs.key('KeyQ', 'pressed')).toBe(false);
    inputs.touch({ forward: -2, left: 0.5 });
    expect(inputs.wish(), 'the stick comes first').toMatchObject({ forward: -1, left: 0.5, source: 'stick' });
    inputs.touch(undefined);
    expect(inputs.wish().source).toBe('keys');
    inputs.clear();
    expect(inputs.wish().source).toBe('none');
  });

  it('have a dead zone, and full speed before the stop of a gamepad', () => {
    expect([0.1, -0.12, NaN, -0.9, 1].map(travel)).toEqual([0, 0, 0, -1, 1]);
    expect(travel(0.51)).toBeCloseTo(0.5, 6);
  });
});

/** A keyboard as operating systems have it: it repeats the key that was pressed last until that one is released. */
class Keyboard {
  readonly down = new Set<string>();
  private repeats = '';
  private next_ms = 0;
  /** False: no more events arrive, as from a remote desktop whose window lost the focus. */
  works = true;

  constructor(private readonly delay_ms: number, private readonly period_ms: number) {}

  press(code: string): void {
    this.down.add(code);
    this.repeats = code;
    this.next_ms = now_ms + this.delay_ms;
    if (this.works) inputs.key(code, 'pressed');
  }

  release(code: string, heard = true): void {
    this.down.delete(code);
    if (this.repeats === code) this.repeats = '';
    if (this.works && heard) inputs.key(code, 'released');
  }

  /** Lets the time pass, with the inputs read as often as the driver reads them. */
  wait(duration_ms: number, look: () => void): void {
    for (const end_ms = now_ms + duration_ms; now_ms < end_ms; now_ms += 20) {
      if (this.repeats !== '' && now_ms >= this.next_ms) {
        this.next_ms += this.period_ms;
        if (this.works) inputs.key(this.repeats, 'repeated');
      }
      look();
    }
  }
}

describe('keys whose release may get lost', () => {
  const kKeys = ['KeyW', 'KeyA', 'KeyD', 'KeyC'];
  /** What the keys that are really held ask for. */
  const wanted = (down: Set<string>): number[] => [Number(down.has('KeyW')), Number(down.has('KeyA')) - Number(down.has('KeyD'))].map((value) => value + 0);
  const given = (): number[] => {
    const { forward, left } = inputs.wish();
    return [forward, left].map((value) => value + 0);
  };
  const boards: [number, number][] = [250, 400, 660].flatMap((delay_ms) => [20, 33, 500].map((period_ms): [number, number] => [delay_ms, period_ms]));

  // Otherwise the robot of a driver who does nothing wrong would stop in mid-drive.
  it.each(boards)('count as long as they are held, if the first repeat comes after %d ms and the next after %d ms', (delay_ms, period_ms) => {
    const next = random(delay_ms + period_ms);
    const board = new Keyboard(delay_ms, period_ms);
    const wrong: string[] = [];
    for (let i = 0; i < 100; i++) {
      const code = kKeys[Math.floor(next() * kKeys.length)] ?? '';
      const released = board.down.has(code);
      if (released) board.release(code);
      else board.press(code);
      // After a release nothing repeats; such a driver presses another key within the time that REFERENCE.md states.
      const still_ms = next() * (released ? kLastKey_ms - 40 : 5000);
      board.wait(still_ms, () => {
        if (given().join() !== wanted(board.down).join()) wrong.push(`${[...board.down].join(' ')} at ${now_ms} ms: ${given().join()}`);
      });
    }
    expect(wrong).toEqual([]);
  });

  // Otherwise the robot would drive on although nobody holds anything.
  it.each(boards)('drive nothing for long after everything was let go, if the first repeat comes after %d ms and the next after %d ms', (delay_ms, period_ms) => {
    const next = random(7 * delay_ms + period_ms);
    for (let i = 0; i < 100; i++) {
      const board = new Keyboard(delay_ms, period_ms);
      const order: string[] = [];
      for (let n = 0; n < 4; n++) {
        const code = kKeys[Math.floor(next() * kKeys.length)] ?? '';
        if (!board.down.has(code)) {
          board.press(code);
          order.push(code);
        }
        board.wait(next() * 900, given);
      }
      // All of the keyboard is lost, or single releases, in any order.
      board.works = next() < 0.5;
      const heard = new Map([...board.down].map((code) => [code, next() < 0.5]));
      for (const code of [...board.down].sort(() => next() - 0.5)) {
        board.release(code, heard.get(code));
        board.wait(next() * 200, given);
      }
      const newest = order.at(-1) ?? '';
      const limit_ms = board.works && heard.get(newest) === true ? kLastKey_ms : kRepeat_ms;
      board.wait(limit_ms + 20, given);
      if (given().join() !== '0,0') expect.fail(`${order.join(' ')}, ${JSON.stringify([...heard])}: ${given().join()}`);
      inputs.clear();
    }
  });

  // Otherwise the driver would not know what the robot stopped for.
  it('say that they must be pressed again before and after they count as released', () => {
    const board = new Keyboard(400, 33);
    board.press('KeyW');
    board.wait(3000, given);
    board.press('KeyA');
    board.wait(100, given);
    board.release('KeyA');
    expect([given(), inputs.silent]).toEqual([[1, 0], false]);
    board.wait(kRepeat_ms + 100, given);
    expect([given(), inputs.silent]).toEqual([[1, 0], true]);
    board.wait(kLastKey_ms, given);
    expect([given(), inputs.silent]).toEqual([[0, 0], true]);
    board.release('KeyW');
    expect(inputs.silent).toBe(false);
    board.press('KeyW');
    expect([given(), inputs.silent]).toEqual([[1, 0], false]);
  });

  // Otherwise a key that was lost while the page slept would drive again with the next one.
  it('are not revived by another key', () => {
    inputs.key('KeyW', 'pressed');
    now_ms += 5000;
    inputs.key('KeyA', 'pressed');
    expect(given()).toEqual([0, 1]);
  });

  // Otherwise a key that was held before would drive as soon as the page does.
  it('drive by a press only, not by the repeat of a key that was held before', () => {
    inputs.key('KeyW', 'repeated');
    expect(given()).toEqual([0, 0]);
    inputs.key('KeyW', 'pressed');
    inputs.key('KeyW', 'repeated');
    expect(given()).toEqual([1, 0]);
    inputs.clear();
    inputs.key('KeyW', 'repeated');
    expect(given()).toEqual([0, 0]);
  });
});

describe('a gamepad', () => {
  const at = (y: number, more: { connected?: boolean; index?: number; trigger?: number } = {}): void => {
    const { connected = true, index = 0, trigger = 0 } = more;
    // A browser may renew the time of a device that is silent.
    pads = [null, { index, connected, timestamp: now_ms, axes: [0, y], buttons: [{ value: trigger }] } as Pad];
  };

  // Otherwise a pad that is out of range or whose battery is empty would drive on.
  it('stands still once its axes and buttons have not changed for the stated time, whatever its time says, until they do', () => {
    const next = random(3);
    const wrong: string[] = [];
    for (let i = 0; i < 100; i++) {
      const y = (next() < 0.5 ? -1 : 1) * (0.2 + 0.8 * next());
      const expectDirection = (direction: number, frozen: boolean): void => {
        const { forward } = inputs.wish();
        if (Math.sign(forward) !== direction || inputs.frozen !== frozen) wrong.push(`${y}: ${forward}, ${inputs.frozen}`);
      };
      at(0);
      inputs.wish();
      const changed_ms = (now_ms += 20);
      at(y);
      while (now_ms - changed_ms <= kFrozen_ms) {
        expectDirection(-Math.sign(y), false);
        now_ms += 1 + Math.floor(40 * next());
        at(y);
      }
      expectDirection(0, true);
      at(y, { trigger: 0.1 });
      expectDirection(-Math.sign(y), false);
    }
    expect(wrong).toEqual([]);
  });

  // Otherwise the robot would stop now and then although the driver holds the stick.
  it('drives on with a stick that a hand holds still, however coarse its values are', () => {
    const next = random(4);
    const stood: string[] = [];
    for (const steps of [128, 512, 32768]) {
      for (const hertz of [8, 10, 12]) {
        for (let i = 0; i < 20; i++) {
          const y = 0.2 + 0.6 * next();
          const phase = 2 * Math.PI * next();
          for (const end_ms = now_ms + 3000; now_ms < end_ms; now_ms += 10 + Math.floor(30 * next())) {
            at(-Math.round(steps * (y + 0.005 * Math.sin(phase + 2 * Math.PI * hertz * now_ms * 1e-3))) / steps);
            if (!(inputs.wish().forward > 0) && now_ms > end_ms - 2900) stood.push(`${steps} steps, ${hertz} Hz, ${y}`);
          }
        }
      }
    }
    expect(stood).toEqual([]);
  });

  it('that was deflected before anyone looked has to move first, also if it takes the place of another one', () => {
    at(-0.9);
    expect(inputs.wish()).toMatchObject({ forward: 0 });
    expect(inputs.frozen).toBe(true);
    at(-0.8);
    expect(inputs.wish().forward).toBeGreaterThan(0.8);
    at(-0.9, { index: 1 });
    expect(inputs.wish()).toMatchObject({ forward: 0 });
    expect(inputs.frozen).toBe(true);
    at(0, { index: 1 });
    inputs.wish();
    expect(inputs.frozen, 'nobody waits for it').toBe(false);
  });

  it('is nothing when it is gone, and has to move again after the page was left', () => {
    const drives = (): void => {
      at(0);
      inputs.wish();
      at(-0.9);
      expect(inputs.wish().forward).toBe(1);
    };
    drives();
    at(-0.9, { connected: false });
    expect(inputs.wish()).toMatchObject({ forward: 0, source: 'none' });
    pads = [];
    expect(inputs.wish()).toMatchObject({ forward: 0, source: 'none' });
    drives();
    inputs.clear();
    expect(inputs.wish().forward).toBe(0);
  });
});
