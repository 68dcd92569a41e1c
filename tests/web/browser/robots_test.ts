import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { findings } from './axe.ts';
import { openBrowser, openPage, picture, until, type Size } from './cockpit.ts';
import { Pair } from './programs.ts';
import { kOthersEnd, Setting } from './setting.ts';

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];

const setting = new Setting({ each: true });
const others: Pair[] = [];
/** A daemon of which this one only learns that it runs; it begins to drive by itself. */
async function another(options: string[] = []): Promise<Pair> {
  const pair = await Pair.start(options);
  others.push(pair);
  return pair;
}
afterEach(async ({ task }) => {
  for (const pair of others.splice(0)) {
    if (task.result?.state === 'fail') console.log(pair.said);
    await pair.end();
  }
});

async function openRobots(size?: Size): Promise<Page> {
  const page = await setting.open(size);
  setting.expected ??= kOthersEnd;
  await page.click('.robots-link');
  return page;
}

/** Part of a robot's card. Daemons of other tests may run on this machine: each card is found by its address. */
const part = (page: Page, pair: Pair, selector = ''): ReturnType<Page['locator']> => page.locator(`.card[data-url="${pair.url}"] ${selector}`);
const status = async (page: Page, pair: Pair): Promise<string> => (await part(page, pair, '.card-status').textContent()) ?? '';
const becomes = (page: Page, pair: Pair, pattern: RegExp): Promise<string> =>
  until(
    async () => {
      if ((await part(page, pair).count()) === 0) return undefined;
      const text = await status(page, pair);
      return pattern.test(text) ? text : undefined;
    },
    `${pair.url} is ${String(pattern)}`,
    () => page.textContent('.cards'),
  );
const position = async (page: Page, pair: Pair): Promise<string> => (await part(page, pair, '[data-figure="pose"]').textContent()) ?? '';

describe('the page of all robots', () => {
  for (const size of kScreens) {
    it(`shows the daemons of this machine at ${size.width} x ${size.height}`, async () => {
      const second = await another();
      const page = await openRobots(size);
      for (const pair of [setting.pair, second]) {
        await becomes(page, pair, /running/);
        expect(await part(page, pair, 'h2').textContent()).toBe('tp100');
        expect(await part(page, pair, '.badge').textContent()).toBe('emulated');
        expect(await part(page, pair, '[data-figure="course"]').textContent()).toMatch(/^3, \d\.\d\d of \d\.\d\d m$/);
        expect(await part(page, pair, '[data-figure="battery"]').textContent()).toMatch(/^\d+\.\d V$/);
        expect(await part(page, pair, '.card-page a').getAttribute('href')).toBe(pair.url);
        const before = await position(page, pair);
        await until(async () => (await position(page, pair)) !== before, 'its pose follows the robot');
      }
      expect(await part(page, setting.pair, '.card-page').textContent()).toContain('serves this page');
      expect(await part(page, second, '.card-page').textContent()).not.toContain('serves this page');
      expect(await findings(page)).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth)).toBe(true);
      await picture(page, `robots-${size.width}`);
      // Started while the page is open.
      const third = await another();
      await becomes(page, third, /running/);
    });
  }

  it('stops one robot, and only that one', async () => {
    const second = await another();
    const third = await another();
    const page = await openRobots();
    for (const pair of [setting.pair, second, third]) await becomes(page, pair, /running/);
    await part(page, second, '.stop').click();
    await becomes(page, second, /aborted/);
    await until(async () => ((await part(page, second, '.stop-line').textContent()) ?? '').includes('stopped'), 'the robot has acknowledged');
    expect(second.said).toMatch(/stop_requested/);
    // The space bar on a card means its robot; it does not press the button once more.
    await part(page, third, '.stop').focus();
    await page.keyboard.press('Space');
    await becomes(page, third, /aborted/);
    expect(third.said).toMatch(/stop_requested/);
    expect(setting.pair.said).not.toMatch(/stop_requested/);
    // Anywhere else, Escape means all.
    await page.keyboard.press('Escape');
    await until(() => setting.pair.said.includes('stop_requested'), 'all are stopped');
  });

  it('says that a daemon does not answer or has ended, and shows nothing old of it', async () => {
    setting.expected = /WebSocket|ERR_CONNECTION|Failed to load/;
    const second = await another();
    const page = await openRobots();
    await becomes(page, second, /running/);
    second.daemon.freeze();
    await becomes(page, second, /no answer/);
    expect(await part(page, second, '.card-figures').isVisible()).toBe(false);
    // It is kept, and sent when the daemon is there again.
    await part(page, second, '.stop').click();
    await until(async () => ((await part(page, second, '.stop-line').textContent()) ?? '').includes('not acknowledged'), 'not acknowledged');
    await becomes(page, setting.pair, /running|finished|aborted/);
    second.daemon.thaw();
    await until(() => second.said.includes('stop_requested'), 'the STOP that was kept');
    await becomes(page, second, /aborted/);
    await second.daemon.end('SIGKILL');
    await becomes(page, second, /ended/);
    expect(await part(page, second, '.card-figures').isVisible()).toBe(false);
    expect(await part(page, second, '.card-problem').textContent()).toContain('has ended');
  });

  it('outlives the daemon that served it', async () => {
    setting.expected = /WebSocket|ERR_CONNECTION|Failed to (load|fetch)/;
    const second = await another();
    const page = await openRobots();
    await becomes(page, second, /running/);
    await setting.pair.daemon.end('SIGKILL');
    await becomes(page, setting.pair, /no answer/);
    await until(async () => ((await page.textContent('.robots-note')) ?? '') !== '', 'a note');
    await part(page, second, '.stop').click();
    await becomes(page, second, /aborted/);
    expect(second.said).toMatch(/stop_requested/);
  });
});

describe('a robot of another machine', () => {
  let far: Pair;
  beforeEach(async () => {
    far = await another();
  });

  it('is shown if the configuration names it and it permits the page', async () => {
    // 127.0.0.1 and localhost are different names: to the browser two machines.
    const named = far.url.replace('127.0.0.1', 'localhost');
    const near = await Pair.start([], undefined, `[server]\nrobots = "${named}"\n`);
    others.push(near);
    const browser = await openBrowser();
    try {
      const complaints: string[] = [];
      const page = await openPage(browser, `${near.url}robots.html`, complaints);
      const card = page.locator(`.card[data-url="${named}"]`);
      await until(async () => ((await card.locator('.card-status').textContent()) ?? '').includes('no answer'), 'it does not permit the page');
      expect(await card.locator('.card-problem').textContent()).toContain(`is ${new URL(near.url).origin} in its server.origins?`);
      await far.daemon.end();
      const { host } = new URL(far.url);
      far = await Pair.start([], host, `[server]\norigins = "${new URL(near.url).origin}"\n`);
      others.push(far);
      await until(async () => /running|arming/.test((await card.locator('.card-status').textContent()) ?? ''), 'it permits the page');
      await card.locator('.stop').click();
      await until(() => far.said.includes('stop_requested'), 'its STOP');
    } finally {
      await browser.close();
    }
  });
});
