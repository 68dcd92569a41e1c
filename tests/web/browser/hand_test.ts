// Driving by hand from the page, with keys, a gamepad and the stick, and every way to let go.
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { again, alive, hide, run, shows, tooWide, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();
let bus: Bus;
beforeEach(() => {
  bus = new Bus(setting.pair.url, ['/estimate', '/state']);
});
afterEach(() => {
  bus.close();
});

const speed_mps = (): number => bus.last('/estimate')?.desired_speed_mps ?? NaN;
const moves = (): Promise<boolean> => until(() => speed_mps() > 0.03, 'forwards');
const stands = (why: string): Promise<boolean> => until(() => speed_mps() === 0, `a standstill: ${why}`);
/** Of the right track against the left one, as commanded. */
const turn_mps = (): number => {
  const tracks = bus.last('/estimate')?.tracks;
  return (tracks?.right_commanded_mps ?? NaN) - (tracks?.left_commanded_mps ?? NaN);
};

/** Ends the run, which begins by itself and perhaps only now, near its start: at its end the fence is near. */
async function mayDrive(page: Page): Promise<void> {
  await alive(page);
  await until(async () => {
    if (['arming', 'running'].includes(await run(page))) await page.keyboard.press('h');
    return page.isEnabled('#by-hand');
  }, 'the robot may be driven');
}

async function takeLease(page: Page): Promise<void> {
  await mayDrive(page);
  await until(async () => {
    if ((await run(page)) === 'driving' && (await page.isVisible('#drive-release'))) return true;
    // The first press asks for confirmation. By key, because a click would wait for a button that is no longer enabled.
    await page.keyboard.press('t');
    return false;
  }, 'this page drives');
}

async function release(page: Page): Promise<void> {
  await page.click('#drive-release');
  await until(async () => (await run(page)) === 'idle', 'the robot is disarmed');
  expect(await page.isVisible('#drive-release')).toBe(false);
}

/** A person who holds keys, until `leave`; the keyboard repeats the one that was pressed last. */
class Typist {
  private code = '';
  private readonly timer: ReturnType<typeof setInterval>;

  constructor(private readonly page: Page) {
    this.timer = setInterval(() => {
      if (this.code !== '') void page.keyboard.down(this.code).catch(() => undefined);
    }, 100);
  }

  async down(code: string): Promise<void> {
    this.code = code;
    await this.page.keyboard.down(code);
  }

  async up(...codes: string[]): Promise<void> {
    this.code = '';
    for (const code of codes) await this.page.keyboard.up(code);
  }

  leave(): void {
    clearInterval(this.timer);
  }
}

describe('driving by hand', () => {
  it('asks for confirmation, follows the keys as long as they are held, and releases', async () => {
    const page = await setting.open();
    await mayDrive(page);
    await page.keyboard.press('t');
    await shows(page, '#by-hand', 'Press again');
    expect(await page.isVisible('#drive-release')).toBe(false);
    await page.keyboard.press('t');
    await until(async () => (await run(page)) === 'driving', 'it is driven');
    await page.keyboard.press('t');
    expect(await run(page), 'what starts does not stop').toBe('driving');

    const typist = new Typist(page);
    await typist.down('KeyW');
    await until(() => speed_mps() > 0.05, 'forwards');
    expect(speed_mps(), 'within half of the limit').toBeLessThanOrEqual(0.1001);
    await shows(page, '#drive-speed', /^0\.(0[3-9]|1)\d* m\/s, commanded 0\.(0[3-9]|1)\d*$/);
    await typist.down('ArrowLeft');
    await until(() => turn_mps() > 0.05, 'and to the left');
    await shows(page, '#drive-turn', /^[1-9]\d*°\/s, wanted [1-9]\d*$/);
    await typist.up('KeyW', 'ArrowLeft');
    await until(() => speed_mps() === 0 && turn_mps() === 0, 'let go');
    await typist.down('ArrowDown');
    await until(() => speed_mps() < -0.02, 'backwards');
    await typist.up('ArrowDown');
    await stands('let go');
    typist.leave();
    await release(page);
    await page.keyboard.down('KeyW');
    await page.waitForTimeout(300);
    expect(await run(page), 'a key alone never arms').toBe('idle');
  });

  it.each<[string, (page: Page) => Promise<unknown>]>([
    ['loses the focus', (page) => page.evaluate(() => window.dispatchEvent(new Event('blur')))],
    ['hears Cmd', (page) => page.keyboard.press('Meta')],
    ['shows another view', (page) => page.click('#view-plan')],
    ['is hidden', hide],
    ['is closed', (page) => page.close()],
  ])('stops when the page %s', async (what, lose) => {
    const page = await setting.open();
    await takeLease(page);
    const typist = new Typist(page);
    await typist.down('KeyW');
    await moves();
    await lose(page);
    await stands(what);
    await new Promise((resolve) => setTimeout(resolve, 200));
    expect(speed_mps(), 'the key that is still held counts no more').toBe(0);
    typist.leave();
    if (['shows another view', 'is hidden', 'is closed'].includes(what)) await until(() => bus.last('/state')?.run === 'idle', 'and disarmed after a while');
    else await release(page);
  });

  // What counts as a hand on it: tests/web/unit/inputs_test.ts.
  it('takes a gamepad while its values move, and stops when they freeze', async () => {
    const page = await setting.open();
    // A gamepad whose values the test changes: it trembles, or it is silent.
    await page.addInitScript(() => {
      const pad = { index: 0, connected: true, axes: [0, 0], buttons: [{ value: 0 }] };
      const hand: { trembles: boolean } = { trembles: false };
      Object.assign(globalThis, { hand });
      setInterval(() => {
        if (hand.trembles) pad.axes = [0, -0.9 - 0.01 * Math.random()];
      }, 20);
      navigator.getGamepads = () => [pad as unknown as Gamepad];
    });
    await page.reload();
    const trembles = (on: boolean): Promise<void> => page.evaluate((on) => { (globalThis as unknown as { hand: { trembles: boolean } }).hand.trembles = on; }, on);
    await takeLease(page);
    await trembles(true);
    await moves();
    await trembles(false);
    await stands('its values freeze');
    await shows(page, '.drive-source', 'do not change');
    await release(page);
  });

  it('gives the lease to one page at a time', async () => {
    // The slow part first: a driver who is not heard for 2 s, because another page opens, is none any more.
    const second = await setting.open({ width: 800, height: 600 });
    await alive(second);
    const first = await setting.open();
    /** False: a busy machine has ended the first page's drive, and the second one has taken the lease. */
    const refused = async (): Promise<boolean> => {
      await takeLease(first);
      const takes = (): Promise<boolean> => second.isVisible('#drive-release');
      await until(async () => {
        await second.keyboard.press('t');
        return (await takes()) || (await second.textContent('.notice'))?.includes('drives') === true;
      }, 'an answer');
      if (!(await takes())) return true;
      await release(second);
      return false;
    };
    await again(refused, 'is refused with the name');
    await shows(second, '#by-hand', 'Ask');
    await shows(first, '.drive-asked', 'asks for the lease');
    expect(await second.isVisible('#drive-release')).toBe(false);
    await release(first);
    await takeLease(second);
    expect(await first.isVisible('#drive-release')).toBe(false);
    // STOP is everybody's.
    await first.keyboard.press('Escape');
    await until(async () => (await run(second)) === 'aborted' && !(await second.isVisible('#drive-release')), 'the drive is over');
  });

  it('drives by the stick on a phone', async () => {
    const page = await setting.open({ width: 360, height: 640 });
    /** False: a busy machine has ended the drive. */
    const pushed = async (): Promise<boolean> => {
      await takeLease(page);
      await page.locator('.drive-stick').scrollIntoViewIfNeeded();
      const box = await page.locator('.drive-stick').boundingBox();
      if (box === null) throw new Error('no stick');
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      await page.mouse.down();
      await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.1);
      await until(async () => speed_mps() > 0.03 || (await run(page)) !== 'driving', 'forwards');
      if (speed_mps() > 0.03) return true;
      await page.mouse.up();
      return false;
    };
    await again(pushed, 'drives');
    expect(await page.evaluate(tooWide, '')).toEqual([]);
    // A remote desktop loses the release; the next move shows it.
    await page.locator('.drive-stick').evaluate((stick) => stick.dispatchEvent(new PointerEvent('pointermove', { pointerId: 1, buttons: 0 })));
    await stands('let go without a word');
    await page.mouse.up();
    await release(page);
  });
});
