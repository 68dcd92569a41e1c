import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { openBrowser, openPage, Pair, picture, until } from './programs.ts';

let pair: Pair;
const browsers: Browser[] = [];
async function browserWith(flags: string[] = []): Promise<Browser> {
  const browser = await openBrowser(flags);
  browsers.push(browser);
  return browser;
}

beforeAll(async () => {
  pair = await Pair.start();
});
afterAll(async () => {
  for (const browser of browsers) await browser.close();
  await pair.end();
});

/** Elements that stick out to the side, unless something around them scrolls or hides it. */
function sticksOut(): string[] {
  const width = document.documentElement.clientWidth;
  const out: string[] = [];
  if (document.documentElement.scrollWidth > width) out.push(`page is ${document.documentElement.scrollWidth} wide`);
  for (const element of document.querySelectorAll('body *')) {
    const box = element.getBoundingClientRect();
    if (box.width === 0 || (box.left >= -0.5 && box.right <= width + 0.5)) continue;
    let around = element.parentElement;
    while (around !== null && getComputedStyle(around).overflowX === 'visible') around = around.parentElement;
    if (around === null || around === document.body) out.push(`${element.tagName} ${element.getAttribute('class') ?? ''}`);
  }
  return out;
}

describe('the layout', () => {
  it.each([
    [360, 640],
    [390, 844],
    [768, 1024],
    [1024, 600],
    [1440, 900],
    [2560, 1440],
  ])('fits into %i x %i with STOP in sight', async (width, height) => {
    const { page, complaints } = await openPage(browsers[0] ?? (await browserWith()), pair.url, { width, height });
    await until(async () => (await page.textContent('#number-x')) !== '\u2013', 'figures');
    await until(async () => ((await page.locator('.stage canvas').getAttribute('data-robot')) ?? '') !== '', 'a robot');
    for (const tab of ['events', 'runs', 'parameters', 'link']) {
      await page.click(`#tab-${tab}`);
      expect(await page.evaluate(sticksOut), tab).toEqual([]);
      const stop = await page.locator('#stop').boundingBox();
      if (stop === null) throw new Error('no STOP');
      expect(stop.x).toBeGreaterThanOrEqual(0);
      expect(stop.y).toBeGreaterThanOrEqual(0);
      expect(stop.x + stop.width).toBeLessThanOrEqual(width);
      expect(stop.y + stop.height).toBeLessThanOrEqual(height);
      expect(stop.width * stop.height).toBeGreaterThan(180 * 44);
      const top = await page.evaluate(([x, y]) => document.elementFromPoint(x ?? 0, y ?? 0)?.closest('#stop') !== null, [stop.x + stop.width / 2, stop.y + stop.height / 2]);
      expect(top, 'nothing lies over STOP').toBe(true);
    }
    await picture(page, `layout-${width}`);
    expect(complaints).toEqual([]);
    await page.close();
  });

  it('does not move while the numbers do', async () => {
    const { page } = await openPage(browsers[0] ?? (await browserWith()), pair.url);
    await until(async () => (await page.textContent('#number-x')) !== '\u2013', 'figures');
    const shift = await page.evaluate(
      () =>
        new Promise<number>((resolve) => {
          let sum = 0;
          new PerformanceObserver((list) => {
            for (const entry of list.getEntries()) sum += (entry as PerformanceEntry & { value: number }).value;
          }).observe({ type: 'layout-shift', buffered: false });
          setTimeout(() => {
            resolve(sum);
          }, 3000);
        }),
    );
    expect(shift).toBe(0);
    await page.close();
  });

  it('has a name for everything that can be pressed, and all of it can be reached by keyboard', async () => {
    const { page } = await openPage(browsers[0] ?? (await browserWith()), pair.url);
    await until(async () => (await page.textContent('#number-x')) !== '\u2013', 'figures');
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, select, [tabindex]')]
        .filter((element) => ((element.getAttribute('aria-label') ?? '') + (element.getAttribute('aria-labelledby') ?? '') + element.textContent).trim() === '')
        .map((element) => element.outerHTML.slice(0, 80)),
    );
    expect(nameless).toEqual([]);
    const reached = new Set<string>();
    for (let i = 0; i < 40; i++) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement?.id ?? ''));
    }
    for (const id of ['stop', 'camera-chase', 'camera-map', 'show-model', 'tab-events']) expect(reached).toContain(id);
    await page.close();
  });
});

describe('without WebGL', () => {
  it('the course is a map, and the robot moves on it', async () => {
    const { page, complaints } = await openPage(await browserWith(['--disable-3d-apis']), pair.url);
    expect(await page.getAttribute('#camera-map', 'aria-pressed')).toBe('true');
    expect(await page.isDisabled('#camera-chase')).toBe(true);
    const robot = async (): Promise<string> => (await page.locator('.stage canvas').getAttribute('data-robot')) ?? '';
    const first = await until(async () => (await robot()) || undefined, 'a robot');
    await until(async () => (await robot()) !== first, 'it moves');
    const colours = await page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
      const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      const seen = new Set<number>();
      for (let i = 0; i < data.length; i += 4) seen.add(((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0));
      return seen.size;
    });
    expect(colours).toBeGreaterThan(20);
    await picture(page, 'map');
    expect(complaints).toEqual([]);
    await page.close();
  });
});
