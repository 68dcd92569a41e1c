import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { driveUntil, press as pressButton, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ each: true });

const line = async (page: Page): Promise<string> => (await page.textContent('.stop-line')) ?? '';
const says = (page: Page, text: RegExp): Promise<boolean> => until(async () => text.test(await line(page)), `STOP says ${String(text)}`);
const running = (page: Page): Promise<void> => driveUntil(page, 'running');

interface Look {
  /** Of a figure's colour: the largest component and the range of its components, out of 255. */
  light: number;
  tint: number;
  /** The CSS filter of the 3-D view. */
  filter: string;
}

const look = (page: Page): Promise<Look> =>
  page.evaluate(() => {
    const style = (selector: string): CSSStyleDeclaration => getComputedStyle(document.querySelector(selector) ?? document.body);
    const parts = (style('#number-x').color.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
    const light = Math.max(...parts);
    return { light, tint: light - Math.min(...parts), filter: style('.stage').filter };
  });

/** Expects that figures and 3-D view are shown as stale. */
async function grey(page: Page): Promise<void> {
  let last: Look | undefined;
  const isGrey = async (): Promise<boolean> => {
    last = await look(page);
    return last.light < 150 && last.tint < 40 && last.filter === 'grayscale(1)';
  };
  await until(isGrey, 'grey figures').catch(() => {
    throw new Error(`not grey: ${JSON.stringify(last)}`);
  });
}

const bright = (page: Page): Promise<boolean> =>
  until(async () => {
    const { light, filter } = await look(page);
    return light > 180 && filter === 'none';
  }, 'bright figures');

/** Presses the button without releasing it. */
async function press(page: Page): Promise<void> {
  await page.hover('#stop');
  await page.mouse.down();
}

describe('STOP', () => {
  it('acts on press, latches, shows the robot’s acknowledgement to every viewer, and ends with a start', async () => {
    const other = await setting.open();
    const page = await setting.open();
    await running(page);
    const before = setting.pair.robot.lines.length;
    await press(page);
    await says(page, /^robot stopped in [\d.]+ ms$/);
    await page.mouse.up();
    await setting.pair.robot.line(/motors off: (disarm|stop)/i, before);
    await until(async () => (await run(page)) !== 'running', 'the run is over');
    // A page in the background draws nothing.
    await other.bringToFront();
    await says(other, /^robot stopped in [\d.]+ ms$/);
    await page.bringToFront();

    // The stop is latched: afterwards a start asks where the robot stands, and STOP takes the question away.
    await until(async () => page.isEnabled('#start'), 'start is possible');
    const progress_m = async (): Promise<number> => parseFloat((await page.textContent('.timeline-progress')) ?? '');
    const stopped_m = await progress_m();
    await page.click('#start');
    await page.waitForSelector('#start-here');
    expect(await page.textContent('#question-text')).toContain(`${stopped_m.toFixed(2)} of 4.06 m along the course`);
    // The question waits while nothing may start.
    setting.pair.robot.freeze();
    await until(async () => !(await page.isEnabled('#start-here')), 'the robot is silent');
    setting.pair.robot.thaw();
    // STOP takes the question away, wherever it is pressed.
    for (const anyone of [page, other]) {
      await until(async () => {
        if (await page.isVisible('#start-here')) return page.isEnabled('#start-here');
        if (await page.isEnabled('#start')) await page.keyboard.press('r');
        return false;
      }, 'it may go on');
      await anyone.keyboard.press('Space');
      await page.waitForSelector('#start-here', { state: 'hidden' });
      expect(await run(page)).toBe('aborted');
    }
    // A start is refused until the page has shown that STOP.
    await until(async () => {
      if ((await run(page)) === 'running') return true;
      if (await page.isVisible('#start-here')) await pressButton(page, '#start-here');
      else if (await page.isEnabled('#start')) await pressButton(page, '#start');
      return false;
    }, 'it goes on', () => run(page));
    expect(await progress_m()).toBeGreaterThanOrEqual(stopped_m);
    await says(page, /space or esc/);

    await other.keyboard.press('Space');
    await says(page, /^robot stopped in/);
    await page.click('#tab-events');
    await until(async () => ((await page.textContent('.event-list')) ?? '').includes('viewer'), 'who pressed');
  });

  it('takes space and escape, wherever the focus is, and nothing else', async () => {
    const page = await setting.open();
    await running(page);
    await page.focus('#camera-top');
    await page.keyboard.press('x');
    expect(await line(page)).toBe('space or esc');
    await page.keyboard.press('Escape');
    await says(page, /^robot stopped in/);
    // The space key stops the robot, but must not also press the button that has the focus.
    await page.focus('#camera-free');
    await page.keyboard.press('Space');
    expect(await page.getAttribute('#camera-free', 'aria-pressed')).toBe('false');
    await says(page, /^robot stopped in/);
    await page.focus('#stop');
    await page.keyboard.press('Enter');
    await says(page, /^robot stopped in/);
  });

  it('is not acknowledged by a robot that hangs, and is the first thing that it hears afterwards', async () => {
    const page = await setting.open();
    await running(page);
    await bright(page);
    setting.pair.robot.freeze();
    await press(page);
    await says(page, /^not acknowledged/);
    await grey(page);
    setting.pair.robot.thaw();
    await says(page, /^robot stopped in/);
  });

  it('is not acknowledged by a daemon that hangs, and reaches it when it goes on', async () => {
    const page = await setting.open();
    await running(page);
    await bright(page);
    setting.pair.daemon.freeze();
    await page.keyboard.press('Space');
    await says(page, /^not acknowledged/);
    await grey(page);
    setting.pair.daemon.thaw();
    await says(page, /^robot stopped in/);
    await until(async () => (await run(page)) !== 'running', 'the run is over');
  });

  it('waits for a daemon that is dead and goes out first when another one comes', async () => {
    const page = await setting.open();
    await running(page);
    // The browser itself reports that the daemon cannot be reached.
    setting.expected = /WebSocket connection to/;
    await setting.pair.daemon.end('SIGKILL');
    await until(async () => (await page.textContent('#chip-link .chip-value')) === 'no daemon', 'no daemon');
    await page.keyboard.press('Space');
    await says(page, /^not acknowledged · no link$/);
    await grey(page);
    expect(await page.isVisible('#stop')).toBe(true);
    await setting.pair.restart();
    await says(page, /^robot stopped in/);
    await until(async () => !['running', 'arming'].includes(await run(page)), 'stopped, although the daemon starts by itself');
  });
});
