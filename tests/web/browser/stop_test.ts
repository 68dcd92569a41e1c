// STOP on the page, while robot and daemon answer, hang or are dead.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { driveAway, driveUntil, press as pressButton, rests, run, shows, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ each: true });

const says = (page: Page, text: RegExp): Promise<string> => shows(page, '.stop-line', text);

/** Waits until figures and view are shown as stale, or as fresh. */
async function look(page: Page, wanted: 'grey' | 'bright'): Promise<void> {
  let last = {};
  const looks = async (): Promise<boolean> => {
    const { colour, filter } = await page.evaluate(() => {
      const style = (selector: string): CSSStyleDeclaration => getComputedStyle(document.querySelector(selector) ?? document.body);
      return { colour: style('#number-x').color, filter: style('.stage').filter };
    });
    // The largest component of the colour and the range of its components, out of 255.
    const parts = (colour.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
    const light = Math.max(...parts);
    last = { colour, filter };
    return wanted === 'grey' ? light < 150 && light - Math.min(...parts) < 40 && filter === 'grayscale(1)' : light > 180 && filter === 'none';
  };
  await until(looks, `${wanted} figures`).catch(() => {
    throw new Error(`not ${wanted}: ${JSON.stringify(last)}`);
  });
}

/** A page whose robot drives. */
async function running(): Promise<Page> {
  const page = await setting.open();
  await driveAway(page);
  return page;
}

/** Presses the button without releasing it. */
async function press(page: Page): Promise<void> {
  await page.hover('#stop');
  await page.mouse.down();
}

describe('STOP', () => {
  it('acts on press, latches, shows the robot’s acknowledgement to every viewer, and ends with a start', async () => {
    const other = await setting.open();
    const page = await running();
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

    // The stop is latched: afterwards a start asks where the robot stands.
    await until(async () => page.isEnabled('#start'), 'start is possible');
    const progress_m = async (): Promise<number> => parseFloat((await page.textContent('.timeline-progress')) ?? '');
    const stopped_m = await progress_m();
    await page.click('#start');
    await page.waitForSelector('#start-here');
    expect(await page.textContent('#question-text')).toContain(`${stopped_m.toFixed(2)} of 4.06 m along the course`);
    // The question waits while nothing may start.
    setting.pair.robot.freeze();
    await until(() => page.isDisabled('#start-here'), 'the robot is silent');
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
  });

  it('takes space and escape, wherever the focus is, and nothing else', async () => {
    const page = await running();
    await page.focus('#camera-top');
    await page.keyboard.press('x');
    expect(await page.textContent('.stop-line')).toBe('space or esc');
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
    // A list and a box take it as well; a text does not, and the button says so.
    await page.keyboard.press('1');
    for (const focus of ['#choose-plot', '#wheels-up-free', 'input[aria-label="Search events"]']) {
      await until(() => rests(page), 'the run is over');
      await page.click(focus.includes('wheels') ? '#view-setup' : '#view-drive');
      await driveUntil(page, 'running');
      await page.focus(focus);
      if (focus.startsWith('input')) await says(page, /^esc$/);
      await page.keyboard.press(focus.startsWith('input') ? 'Escape' : 'Space');
      await says(page, /^robot stopped in/);
    }
  });

  it.each(['robot', 'daemon'] as const)('is not acknowledged by a %s that hangs, and is the first thing that it hears afterwards', async (who) => {
    const page = await running();
    await look(page, 'bright');
    setting.pair[who].freeze();
    await press(page);
    await says(page, /^not acknowledged/);
    await look(page, 'grey');
    setting.pair[who].thaw();
    await says(page, /^robot stopped in/);
    await until(async () => (await run(page)) !== 'running', 'the run is over');
  });

  it('waits for a daemon that is dead and goes out first when another one comes', async () => {
    const page = await running();
    // The browser itself reports that the daemon cannot be reached.
    setting.expected = /WebSocket connection to/;
    await setting.pair.daemon.end('SIGKILL');
    await shows(page, '#chip-link .chip-value', /^no daemon$/);
    await page.keyboard.press('Space');
    await says(page, /^not acknowledged · no link$/);
    await look(page, 'grey');
    expect(await page.isVisible('#stop')).toBe(true);
    await setting.pair.restart();
    await says(page, /^robot stopped in/);
    await until(async () => !['running', 'arming'].includes(await run(page)), 'stopped, although the daemon starts by itself');
  });
});
