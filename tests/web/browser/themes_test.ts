import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { findings } from './axe.ts';
import { alive, goOn, kSize, picture, run, until, type Size } from './cockpit.ts';
import { kOthersEnd, Setting } from './setting.ts';

const kTabs = ['events', 'courses', 'runs', 'parameters', 'signals', 'link', 'doctor', 'identify', 'keys'];
const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];
const kThemes = ['dark', 'light'] as const;

const theme = (page: Page): Promise<string | null> => page.getAttribute('html', 'data-theme');
const ground = (page: Page): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
const kGround = { dark: 'rgb(10, 14, 19)', light: 'rgb(255, 255, 255)' };

/** The brightness of the middle of the map's edge, where nothing but floor and grid is, 0 to 255. */
const floor = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
    // A copy, because the browser complains if the page's own canvas is read again and again.
    const copy = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    if (canvas === null || copy === null) return NaN;
    copy.drawImage(canvas, 1, 1, 1, 1, 0, 0, 1, 1);
    const { data } = copy.getImageData(0, 0, 1, 1);
    return ((data[0] ?? 0) + (data[1] ?? 0) + (data[2] ?? 0)) / 3;
  });

describe('the cockpit', () => {
  const setting = new Setting();

  for (const scheme of kThemes) {
    for (const size of kScreens) {
      it(`can be read in the ${scheme} at ${size.width} x ${size.height}, on every tab`, async () => {
        const page = await setting.open(size);
        await page.emulateMedia({ colorScheme: scheme });
        await alive(page);
        await until(async () => (await theme(page)) === scheme, 'the theme that the system prefers');
        expect(await ground(page)).toBe(kGround[scheme]);
        // All of the page once, then what each tab changes.
        const found = await findings(page);
        for (const tab of kTabs) {
          await page.click(`#tab-${tab}`);
          found.push(...(await findings(page, '.drawer')).map((each) => `${tab}: ${each}`));
        }
        expect([...new Set(found)]).toEqual([]);
        await page.click('#tab-events');
        await picture(page, `theme-${scheme}-${size.width}`);
      });
    }

    it(`can be read in the ${scheme} when all of it is old`, async () => {
      setting.expected = /WebSocket|ERR_CONNECTION|Failed to load/;
      const page = await setting.open();
      await page.emulateMedia({ colorScheme: scheme });
      await alive(page);
      setting.pair.daemon.freeze();
      await until(async () => (await page.getAttribute('.viewport', 'class'))?.includes('stale'), 'it is shown as old');
      expect(await findings(page)).toEqual([]);
      await picture(page, `theme-${scheme}-stale`);
      setting.pair.daemon.thaw();
      await alive(page);
    });
  }

  it('is light or dark as it was told last, and draws the map so', async () => {
    const page = await setting.open(kSize);
    await alive(page);
    const before = (await theme(page)) === 'light' ? 'light' : 'dark';
    const other = before === 'light' ? 'dark' : 'light';
    const bright = (which: string): Promise<boolean> => until(async () => (await floor(page)) > 128 === (which === 'light'), `the map is ${which}`);
    await bright(before);
    await page.click('.theme-switch');
    expect(await theme(page)).toBe(other);
    expect(await page.getAttribute('.theme-switch', 'aria-pressed')).toBe(String(other === 'light'));
    await bright(other);
    await page.reload();
    await alive(page);
    expect(await theme(page)).toBe(other);
    await bright(other);
    // The page of all robots has the same.
    setting.expected = kOthersEnd;
    await page.goto(`${setting.pair.url}robots.html`);
    await until(async () => (await page.locator('.card[data-contact="answers"]').count()) > 0, 'a card');
    expect(await theme(page)).toBe(other);
    expect(await findings(page)).toEqual([]);
    // What the system prefers is followed again.
    await page.click('.theme-switch');
    expect(await theme(page)).toBe(before);
    await page.emulateMedia({ colorScheme: other });
    await until(async () => (await theme(page)) === other, 'the system changes');
  });

  it('says in words what the view shows', async () => {
    const page = await setting.open();
    await alive(page);
    await until(async () => {
      await goOn(page);
      return (await run(page)) === 'running';
    }, 'the run begins');
    const words = async (): Promise<string> => (await page.textContent('#scene-words')) ?? '';
    await until(async () => /^Course 3, robot end-loaded, running\. It is at x [\d.\u2212]+ m, y [\d.\u2212]+ m, heading [\d\u2212]+ degrees\./.test(await words()), 'where the robot is');
    expect(await page.getAttribute('#scene-words', 'role')).toBe('status');
    await page.keyboard.press('Escape');
    await until(async () => (await words()).includes('aborted. ') && (await words()).includes('STOP is in force.'), 'it was stopped');
    expect(await words()).toContain('Fault: ');
  });
});
