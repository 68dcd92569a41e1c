// Driving by hand from the page, with keys, a gamepad and the stick, and every way to let go.
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { again, alive, run, tooWide, until } from './cockpit.ts';
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
    return page.isEnabled('#drive');
  }, 'the robot may be driven');
}

async function takeWheel(page: Page): Promise<void> {
  await mayDrive(page);
  await until(async () => {
    if ((await run(page)) === 'driving' && (await page.isVisible('#drive-release'))) return true;
    // The first press asks for confirmation. By key, because a click would wait for a button that is no longer enabled.
    await page.keyboard.press('m');
    return false;
  }, 'this page drives');
}

async function release(page: Page): Promise<void> {
  await page.click('#drive-release');
  await until(async () => (await run(page)) === 'idle', 'the robot is disarmed');
  expect(await page.isVisible('#drive-release')).toBe(false);
}

/** A person at the keyboard, which repeats the key that was pressed last. */
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

  async up(code: string): Promise<void> {
    if (this.code === code) this.code = '';
    await this.page.keyboard.up(code);
  }

  leave(): void {
    clearInterval(this.timer);
  }
}

/** A gamepad that the test moves, and whose time the browser renews whatever it does. */
async function plugGamepad(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const pad = { index: 0, connected: true, timestamp: 0, axes: [0, 0], buttons: [{ value: 0 }], noise: false };
    (globalThis as unknown as { pad: typeof pad }).pad = pad;
    setInterval(() => {
      pad.timestamp = performance.now();
      if (pad.noise) pad.buttons = [{ value: Math.random() }];
    }, 20);
    navigator.getGamepads = () => [pad as unknown as Gamepad];
  });
  await page.reload();
}

async function pad(page: Page, values: { axes?: number[]; noise?: boolean; connected?: boolean }): Promise<void> {
  await page.evaluate((values) => {
    Object.assign((globalThis as unknown as { pad: object }).pad, values);
  }, values);
}

describe('driving by hand', () => {
  it('asks for confirmation, follows the keys as long as they are held, and releases', async () => {
    const page = await setting.open();
    await mayDrive(page);
    await page.keyboard.press('m');
    await until(async () => (await page.textContent('#drive')) === 'Press again', 'it asks for confirmation');
    expect(await page.isVisible('#drive-release')).toBe(false);
    await page.keyboard.press('m');
    await until(async () => (await run(page)) === 'driving', 'it is driven');
    expect(await page.isVisible('#drive-release')).toBe(true);
    await page.keyboard.press('m');
    expect(await run(page), 'what starts does not stop').toBe('driving');

    const typist = new Typist(page);
    await typist.down('KeyW');
    await until(() => speed_mps() > 0.05, 'forwards');
    expect(speed_mps(), 'within half of the limit').toBeLessThanOrEqual(0.1001);
    await typist.down('ArrowLeft');
    await until(() => turn_mps() > 0.05, 'and to the left');
    await typist.up('KeyW');
    await typist.up('ArrowLeft');
    await until(() => speed_mps() === 0 && turn_mps() === 0, 'let go');
    await typist.down('ArrowDown');
    await until(() => speed_mps() < -0.02, 'backwards');
    await typist.up('ArrowDown');
    await until(() => speed_mps() === 0, 'let go');
    typist.leave();
    expect(bus.last('/state')?.driver?.by).toMatch(/^viewer \d+$/);
    await release(page);
    await page.keyboard.down('KeyW');
    await page.waitForTimeout(300);
    expect(await run(page), 'a key alone never arms').toBe('idle');
    await page.keyboard.up('KeyW');
  });

  it('stops when the page loses the focus, Cmd is pressed, or it is hidden or closed', async () => {
    const page = await setting.open();
    const typist = new Typist(page);
    for (const lose of ['blur', 'cmd', 'hidden'] as const) {
      await takeWheel(page);
      await typist.down('KeyW');
      await until(() => speed_mps() > 0.03, 'forwards');
      if (lose === 'cmd') await page.keyboard.press('Meta');
      await page.evaluate((lose) => {
        if (lose === 'hidden') {
          Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
          document.dispatchEvent(new Event('visibilitychange'));
        } else if (lose === 'blur') {
          window.dispatchEvent(new Event('blur'));
        }
      }, lose);
      await until(() => speed_mps() === 0, `a standstill after ${lose}`);
      await page.waitForTimeout(200);
      expect(speed_mps(), 'the key that is still held counts no more').toBe(0);
      await typist.up('KeyW');
      if (lose !== 'hidden') await release(page);
    }
    typist.leave();
    await until(async () => (await run(page)) === 'idle', 'a hidden page loses the robot after a while');

    const other = await setting.open();
    await takeWheel(other);
    const another = new Typist(other);
    await another.down('KeyW');
    await until(() => speed_mps() > 0.03, 'forwards');
    another.leave();
    await other.close();
    await until(() => speed_mps() === 0, 'a standstill after the page is closed');
    await until(() => bus.last('/state')?.run === 'idle', 'and disarmed after a while');
  });

  it('takes a gamepad while its values move, and stops when they freeze or it is gone', async () => {
    const page = await setting.open();
    await plugGamepad(page);
    await takeWheel(page);
    await pad(page, { noise: true });
    await pad(page, { axes: [0, -1] });
    await until(() => speed_mps() > 0.03, 'forwards');
    await pad(page, { noise: false });
    await until(() => speed_mps() === 0, 'a standstill when its values freeze');
    await until(async () => (await page.textContent('.drive-source'))?.includes('do not change') === true, 'it says so');
    await pad(page, { noise: true });
    await until(() => speed_mps() > 0.03, 'forwards again');
    await pad(page, { connected: false });
    await until(() => speed_mps() === 0, 'a standstill when it is gone');
    await release(page);
  });

  it('gives the wheel to one page at a time', async () => {
    // The slow part first: a driver who is not heard for 2 s, because another page opens, is none any more.
    const second = await setting.open({ width: 800, height: 600 });
    await alive(second);
    const first = await setting.open();
    await takeWheel(first);
    await until(async () => (await second.textContent('#drive')) === 'Ask', 'another page can only ask', () =>
      JSON.stringify([bus.last('/state')?.run, bus.last('/state')?.driver]));
    await until(async () => {
      await second.keyboard.press('m');
      return (await second.textContent('.notice'))?.includes('drives') === true;
    }, 'it is refused with the name');
    await until(async () => (await first.textContent('.drive-asked'))?.includes('asks for the wheel') === true, 'the driver sees it');
    expect(await second.isVisible('#drive-release')).toBe(false);
    await release(first);
    await takeWheel(second);
    expect(await first.isVisible('#drive-release')).toBe(false);
    // STOP is everybody's.
    await first.keyboard.press('Escape');
    await until(async () => (await run(second)) === 'aborted', 'stopped');
    await until(async () => !(await second.isVisible('#drive-release')), 'the drive is over');
  });

  it('drives by the stick on a phone', async () => {
    const page = await setting.open({ width: 360, height: 640 });
    /** False: a busy machine has ended the drive. */
    const pushed = async (): Promise<boolean> => {
      await takeWheel(page);
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
    await until(() => speed_mps() === 0, 'let go without a word');
    await page.mouse.up();
    await until(() => speed_mps() === 0, 'let go');
    await release(page);
  });
});
