import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { findings } from './axe.ts';
import { fits, kPhone, until } from './cockpit.ts';
import type { Pair } from './programs.ts';
import { kOthersEnd, Setting } from './setting.ts';

/** Part of a robot's card. Daemons of other tests may run on this machine: each card is found by its address. */
const part = (page: Page, pair: Pair, selector = ''): ReturnType<Page['locator']> => page.locator(`.card[data-url="${pair.url}"] ${selector}`);
const text = async (page: Page, pair: Pair, selector: string): Promise<string> => (await part(page, pair, selector).textContent()) ?? '';
const becomes = (page: Page, pair: Pair, pattern: RegExp): Promise<boolean> =>
  until(
    async () => (await part(page, pair).count()) > 0 && pattern.test(await text(page, pair, '.card-status')),
    `${pair.url} is ${String(pattern)}`,
    () => page.textContent('.cards'),
  );
const stopped = (pair: Pair): Promise<boolean> => until(() => pair.said.includes('stop_requested'), `STOP of ${pair.url}`);

describe('the page of all robots', () => {
  const setting = new Setting({ each: true });

  it('shows the daemons of this machine, and stops one of them, and only that one', async () => {
    setting.expected = kOthersEnd;
    const second = await setting.another();
    const page = await setting.open(kPhone);
    await page.click('.robots-link');
    for (const pair of [setting.pair, second]) {
      await becomes(page, pair, /running/);
      expect(await text(page, pair, 'h2')).toBe('tp100');
      expect(await text(page, pair, '.badge')).toBe('emulated');
      expect(await text(page, pair, '[data-figure="course"]')).toMatch(/^3, \d\.\d\d of \d\.\d\d m$/);
      expect(await text(page, pair, '[data-figure="battery"]')).toMatch(/^\d+\.\d V$/);
      expect(await part(page, pair, '.card-page a').getAttribute('href')).toBe(pair.url);
      const before = await text(page, pair, '[data-figure="pose"]');
      await until(async () => (await text(page, pair, '[data-figure="pose"]')) !== before, 'its pose follows the robot');
    }
    expect(await text(page, setting.pair, '.card-page')).toContain('serves this page');
    expect(await text(page, second, '.card-page')).not.toContain('serves this page');
    expect(await findings(page)).toEqual([]);
    await fits(page, '.cards', 'robots');

    // Started while the page is open.
    const third = await setting.another();
    await becomes(page, third, /running/);
    await part(page, second, '.stop').click();
    await becomes(page, second, /aborted/);
    await until(async () => (await text(page, second, '.stop-line')).includes('stopped'), 'the robot has acknowledged');
    await stopped(second);
    // The space bar on a card means its robot; it does not press the button once more.
    await part(page, third, '.stop').focus();
    await page.keyboard.press('Space');
    await becomes(page, third, /aborted/);
    await stopped(third);
    expect(setting.pair.said).not.toMatch(/stop_requested/);
    // Anywhere else, Escape means all.
    await page.keyboard.press('Escape');
    await stopped(setting.pair);
  });

  it('says that a daemon hangs or has ended, shows nothing old of it, and outlives the one that served it', async () => {
    setting.expected = /WebSocket|ERR_CONNECTION|Failed to (load|fetch)/;
    const [second, third] = [await setting.another(), await setting.another()];
    const page = await setting.open();
    await page.click('.robots-link');
    for (const pair of [second, third]) await becomes(page, pair, /running/);
    second.daemon.freeze();
    await becomes(page, second, /no answer/);
    expect(await part(page, second, '.card-figures').isVisible()).toBe(false);
    // It is kept, and sent when the daemon is there again.
    await part(page, second, '.stop').click();
    await until(async () => (await text(page, second, '.stop-line')).includes('not acknowledged'), 'not acknowledged');
    await becomes(page, setting.pair, /running|finished|aborted/);
    second.daemon.thaw();
    await stopped(second);
    await becomes(page, second, /aborted/);
    await second.daemon.end('SIGKILL');
    await becomes(page, second, /ended/);
    expect(await part(page, second, '.card-figures').isVisible()).toBe(false);
    expect(await text(page, second, '.card-problem')).toContain('has ended');

    await setting.pair.daemon.end('SIGKILL');
    await becomes(page, setting.pair, /no answer/);
    await until(async () => ((await page.textContent('.robots-note')) ?? '') !== '', 'a note');
    await part(page, third, '.stop').click();
    await stopped(third);
  });

  it('shows a robot of another machine if the configuration names it and it permits the page', async () => {
    setting.expected = /WebSocket|ERR_|Failed to (load|fetch)|blocked/;
    // 127.0.0.1 and localhost are different names: to the browser two machines.
    const named = setting.pair.url.replace('127.0.0.1', 'localhost');
    const near = await setting.another(`[server]\nrobots = "${named}"\n`);
    const page = await setting.open(undefined, { url: `${near.url}robots.html` });
    const card = page.locator(`.card[data-url="${named}"]`);
    await until(async () => ((await card.locator('.card-status').textContent()) ?? '').includes('no answer'), 'it does not permit the page');
    expect(await card.locator('.card-problem').textContent()).toContain(`is ${new URL(near.url).origin} in its server.origins?`);
    await setting.pair.daemon.end();
    const far = await setting.another(`[server]\norigins = "${new URL(near.url).origin}"\n`, new URL(setting.pair.url).host);
    await until(async () => /running|arming/.test((await card.locator('.card-status').textContent()) ?? ''), 'it permits the page');
    await card.locator('.stop').click();
    await stopped(far);
  });
});
