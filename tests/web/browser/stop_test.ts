import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { driveUntil, openBrowser, openPage, Pair, picture, run, until } from './programs.ts';

let browser: Browser;
let pair: Pair;

beforeAll(async () => {
  browser = await openBrowser();
});
afterAll(async () => {
  await browser.close();
});
beforeEach(async () => {
  pair = await Pair.start();
});
afterEach(async () => {
  await pair.end();
});

const line = async (page: Page): Promise<string> => (await page.textContent('.stop-line')) ?? '';
const says = (page: Page, text: RegExp): Promise<boolean> => until(async () => text.test(await line(page)), `STOP says ${String(text)}`);
const running = (page: Page): Promise<void> => driveUntil(page, 'running');

/** Presses, without letting go. */
async function press(page: Page): Promise<void> {
  await page.hover('#stop');
  await page.mouse.down();
}

/** What the browser itself says about a daemon that is not there. */
const unexplained = (complaints: string[]): string[] => complaints.filter((text) => !text.includes('WebSocket connection to'));

describe('STOP', () => {
  it('acts on press, latches, shows the robot’s acknowledgement to every viewer, and ends with a start', async () => {
    const other = await openPage(browser, pair.url);
    const { page, complaints } = await openPage(browser, pair.url);
    await running(page);
    await press(page);
    await says(page, /^robot stopped in [\d.]+ ms$/);
    await page.mouse.up();
    await pair.robot.line(/motors off: (disarm|stop)/i);
    await until(async () => (await run(page)) !== 'running', 'the run is over');
    await picture(page, 'stopped');
    // A page that nobody sees draws nothing.
    await other.page.bringToFront();
    await says(other.page, /^robot stopped in [\d.]+ ms$/);
    await page.bringToFront();

    // Latched: after a stop, a start is asked for twice.
    await until(async () => page.isEnabled('#start'), 'start is possible');
    await page.click('#start');
    await until(async () => (await page.textContent('#start')) === 'Really?', 'a question');
    expect(await run(page)).not.toBe('running');
    await page.click('#start');
    await running(page);
    await says(page, /space or esc/);

    await other.page.keyboard.press('Space');
    await says(page, /^robot stopped in/);
    await page.click('#tab-events');
    await until(async () => ((await page.textContent('.event-list')) ?? '').includes('viewer'), 'who pressed');
    expect([...complaints, ...other.complaints]).toEqual([]);
  });

  it('takes space and escape, wherever the focus is, and nothing else', async () => {
    const { page } = await openPage(browser, pair.url);
    await running(page);
    await page.focus('#camera-top');
    await page.keyboard.press('x');
    expect(await line(page)).toBe('space or esc');
    await page.keyboard.press('Escape');
    await says(page, /^robot stopped in/);
    // Space stops; it does not also press the button that has the focus.
    await page.focus('#camera-map');
    await page.keyboard.press('Space');
    expect(await page.getAttribute('#camera-map', 'aria-pressed')).toBe('false');
    await says(page, /^robot stopped in/);
    await page.focus('#stop');
    await page.keyboard.press('Enter');
    await says(page, /^robot stopped in/);
  });

  it('is not acknowledged by a robot that hangs, and is the first thing that it hears afterwards', async () => {
    const { page } = await openPage(browser, pair.url);
    await running(page);
    pair.robot.freeze();
    await press(page);
    await says(page, /^not acknowledged/);
    await picture(page, 'not-acknowledged');
    await until(async () => (await page.getAttribute('.number:has(#number-x)', 'class'))?.includes('stale') === true, 'grey figures');
    pair.robot.thaw();
    await says(page, /^robot stopped in/);
  });

  it('is not acknowledged by a daemon that hangs, and reaches it when it goes on', async () => {
    const { page } = await openPage(browser, pair.url);
    await running(page);
    pair.daemon.freeze();
    await page.keyboard.press('Space');
    await says(page, /^not acknowledged/);
    await until(async () => (await page.getAttribute('.number:has(#number-x)', 'class'))?.includes('stale') === true, 'grey figures');
    pair.daemon.thaw();
    await says(page, /^robot stopped in/);
    await until(async () => (await run(page)) !== 'running', 'the run is over');
  });

  it('waits for a daemon that is dead and goes out first when another one comes', async () => {
    const { page, complaints } = await openPage(browser, pair.url);
    await running(page);
    await pair.daemon.end('SIGKILL');
    await until(async () => (await page.textContent('#chip-link .chip-value')) === 'no daemon', 'no daemon');
    await page.keyboard.press('Space');
    await says(page, /^not acknowledged · no link$/);
    await picture(page, 'no-daemon');
    expect(await page.isVisible('#stop')).toBe(true);
    await pair.restart();
    await says(page, /^robot stopped in/);
    await until(async () => !['running', 'arming'].includes(await run(page)), 'stopped, although the daemon starts by itself');
    expect(unexplained(complaints)).toEqual([]);
  });
});
