// The page of all robots: what it shows of the daemons of this machine and of others, and STOP from there.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { findings, fits, kPhone, shows, until } from './cockpit.ts';
import type { Pair } from './programs.ts';
import { Setting } from './setting.ts';

/** Part of a robot's card. Daemons of other tests may run on this machine: each card is found by its address. */
const part = (page: Page, { url }: { url: string }, selector: string): ReturnType<Page['locator']> => page.locator(`.card[data-url="${url}"] ${selector}`);
const says = (page: Page, pair: { url: string }, selector: string, pattern: RegExp): Promise<string> => shows(page, `.card[data-url="${pair.url}"] ${selector}`, pattern);
const becomes = (page: Page, pair: { url: string }, pattern: RegExp): Promise<string> => says(page, pair, '.card-status', pattern);
const stopped = (pair: Pair): Promise<boolean> => until(() => pair.said.includes('stop_requested'), `STOP of ${pair.url}`);

describe('the page of all robots', () => {
  const setting = new Setting({ each: true });

  it('shows the daemons of this machine, stops one of them and only that one, and outlives the one that served it', async () => {
    setting.expected = /WebSocket|ERR_CONNECTION|Failed to (load|fetch)/;
    const second = await setting.another();
    const page = await setting.open(kPhone);
    await page.click('.robots-link');
    for (const pair of [setting.pair, second]) {
      await becomes(page, pair, /running/);
      await says(page, pair, 'h2', /^tp100$/);
      await says(page, pair, '.badge', /^emulated$/);
      await says(page, pair, '.card-figures div:has-text("course") dd', /^3, \d\.\d\d of \d\.\d\d m$/);
      await says(page, pair, '.card-figures div:has-text("time") dd', /left$/);
      await until(async () => (await part(page, pair, '.card-map polygon').last().getAttribute('transform'))?.startsWith('translate'), 'it is drawn on its course');
      await says(page, pair, '.card-figures div:has-text("battery") dd', /^\d+\.\d V$/);
      await says(page, pair, '.card-page', pair === second ? /^(?!.*serves this page)/ : /serves this page/);
      expect(await part(page, pair, '.card-page a').getAttribute('href')).toBe(pair.url);
      const pose = part(page, pair, '.card-figures div:has-text("pose") dd');
      const before = await pose.textContent();
      await until(async () => (await pose.textContent()) !== before, 'its pose follows the robot');
    }
    expect(await findings(page)).toEqual([]);
    await fits(page, '.cards');

    // Started while the page is open.
    const third = await setting.another();
    await becomes(page, third, /running/);
    await part(page, second, '.stop').click();
    await becomes(page, second, /stopped/);
    await says(page, second, '.stop-line', /stopped/);
    await stopped(second);
    // The space bar on a card means its robot; it does not press the button once more.
    await part(page, third, '.stop').focus();
    await page.keyboard.press('Space');
    await becomes(page, third, /stopped/);
    await stopped(third);
    expect(setting.pair.said).not.toMatch(/stop_requested/);
    // Anywhere else, Escape means all.
    await page.keyboard.press('Escape');
    await stopped(setting.pair);

    // STOP for a daemon that hangs is kept until it answers again. The page outlives the daemon that served it.
    const fourth = await setting.another();
    await becomes(page, fourth, /running/);
    fourth.daemon.freeze();
    await becomes(page, fourth, /no answer/);
    expect(await part(page, fourth, '.card-figures').isVisible()).toBe(false);
    await part(page, fourth, '.stop').click();
    await says(page, fourth, '.stop-line', /not acknowledged/);
    await setting.pair.daemon.end('SIGKILL');
    await becomes(page, setting.pair, /no answer/);
    await shows(page, '.robots-note', /./);
    fourth.daemon.thaw();
    await stopped(fourth);
  });

  it('shows a robot of another machine if the configuration names it and it permits the page', async () => {
    setting.expected = /WebSocket|ERR_|Failed to (load|fetch)|blocked/;
    // 127.0.0.1 and localhost are different names: to the browser two machines.
    const named = { url: setting.pair.url.replace('127.0.0.1', 'localhost') };
    const near = await setting.another(`[server]\nrobots = "${named.url}"\n`);
    const page = await setting.open(undefined, { url: `${near.url}robots.html` });
    await becomes(page, named, /no answer/);
    expect(await part(page, named, '.card-problem').textContent()).toContain(`is ${new URL(near.url).origin} in its server.origins?`);
    await setting.pair.daemon.end();
    const far = await setting.another(`[server]\norigins = "${new URL(near.url).origin}"\n`, new URL(setting.pair.url).host);
    await becomes(page, named, /running|arming/);
    await part(page, named, '.stop').click();
    await stopped(far);
  });
});
