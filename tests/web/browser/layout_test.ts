import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, drawn, driveUntil, goOn, picture, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();

/** Elements that extend beyond the side of the page, unless a parent element scrolls or hides them. */
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

/** Pairs of the bar's parts that lie over each other, by what they say. */
function overlaps(): string[] {
  // As wide as it gets: a viewer was too slow for many messages.
  const dropped = document.querySelector('#chip-viewers .chip-detail');
  if (dropped !== null) dropped.textContent = '12345 dropped';
  const parts = [...document.querySelectorAll('h1, .badge, .chip, .controls button, #stop')]
    .map((element) => ({ says: element.textContent, box: element.getBoundingClientRect() }))
    .filter(({ box }) => box.width > 0);
  return parts.flatMap((a, i) =>
    parts
      .slice(i + 1)
      .filter((b) => a.box.left < b.box.right - 0.5 && b.box.left < a.box.right - 0.5 && a.box.top < b.box.bottom - 0.5 && b.box.top < a.box.bottom - 0.5)
      .map((b) => `${a.says} / ${b.says}`),
  );
}

/** Waits for one more frame than was drawn, so that all elements have adapted to the size of the screen. */
const frame = (page: Page): Promise<unknown> =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

const kScreens: Size[] = [
  { width: 360, height: 640 },
  { width: 390, height: 844 },
  { width: 768, height: 1024 },
  { width: 1001, height: 700 },
  { width: 1024, height: 600 },
  { width: 1101, height: 700 },
  { width: 1241, height: 700 },
  { width: 1421, height: 700 },
  { width: 1440, height: 900 },
  { width: 1501, height: 900 },
  { width: 2560, height: 1440 },
];

/** Elements that move within `during_ms`, and how far. The event log moves by design: its newest line is on top. */
async function shifts(page: Page, during_ms: number): Promise<string[]> {
  return page.evaluate(
    (wait_ms) =>
      new Promise<string[]>((resolve) => {
        interface Shift {
          sources: { node: Node | null }[];
        }
        const moved: string[] = [];
        new PerformanceObserver((list) => {
          for (const entry of list.getEntries()) {
            for (const { node } of (entry as unknown as Shift).sources) {
              const element = node instanceof Element ? node : node?.parentElement;
              if (element?.closest('.event-list') === null) moved.push(element.outerHTML.slice(0, 80));
            }
          }
        }).observe({ type: 'layout-shift', buffered: false });
        setTimeout(() => {
          resolve(moved);
        }, wait_ms);
      }),
    during_ms,
  );
}

describe('the layout', () => {
  it('does not move while the numbers do', async () => {
    const page = await setting.open();
    await alive(page);
    // These appear once and may move the page: Pause for Drive, the figures of every topic, the kind of robot, and the font.
    await driveUntil(page, 'running');
    await until(() => page.isVisible('#pause'), 'a way to pause');
    await until(async () => (await page.locator('.number.stale').count()) === 0, 'all figures');
    await until(() => page.textContent('.badge'), 'the kind of robot');
    await page.evaluate(() => document.fonts.ready);
    const before = await page.textContent('#number-x');
    expect(await shifts(page, 3000)).toEqual([]);
    await until(async () => {
      await goOn(page);
      return (await page.textContent('#number-x')) !== before;
    }, 'the numbers move');
  });

  it('fits into every screen with STOP in sight', async () => {
    const page = await setting.open(kScreens[0]);
    await page.click('#camera-free');
    await alive(page);
    for (const { width, height } of kScreens) {
      await page.setViewportSize({ width, height });
      const size = `${width} x ${height}`;
      await until(() => page.evaluate(([w]) => document.documentElement.clientWidth === w, [width]), `the page is ${size}`);
      await frame(page);
      for (const tab of ['events', 'courses', 'runs', 'parameters', 'doctor', 'identify', 'link']) {
        await page.click(`#tab-${tab}`);
        expect(await page.evaluate(sticksOut), `${tab} in ${size}`).toEqual([]);
        const stop = await page.locator('#stop').boundingBox();
        if (stop === null) throw new Error('no STOP');
        expect(stop.x, size).toBeGreaterThanOrEqual(0);
        expect(stop.y, size).toBeGreaterThanOrEqual(0);
        expect(stop.x + stop.width, size).toBeLessThanOrEqual(width);
        expect(stop.y + stop.height, size).toBeLessThanOrEqual(height);
        expect(stop.width * stop.height, size).toBeGreaterThan(180 * 44);
        const top = await page.evaluate(
          ([x, y]) => document.elementFromPoint(x ?? 0, y ?? 0)?.closest('#stop') !== null,
          [stop.x + stop.width / 2, stop.y + stop.height / 2],
        );
        expect(top, `nothing lies over STOP in ${size}`).toBe(true);
      }
      // On a busy machine the run may have been aborted meanwhile.
      await driveUntil(page, 'running');
      expect(await page.evaluate(overlaps), size).toEqual([]);
      await picture(page, `layout-${width}`);
    }
  });
});

describe('without WebGL', () => {
  const setting = new Setting({ flags: ['--disable-3d-apis'] });

  it('the course is a map, and the robot moves on it', async () => {
    const page = await setting.open();
    expect(await page.getAttribute('#camera-map', 'aria-pressed')).toBe('true');
    expect(await page.isDisabled('#camera-chase')).toBe(true);
    const first = await until(() => drawn(page), 'a robot');
    await until(async () => {
      await goOn(page);
      return (await drawn(page))?.join() !== first.join();
    }, 'it moves');
    // Two standard deviations of each estimated position: some millimetres to centimetres.
    for (const name of ['model', 'odometry', 'fused']) {
      const ring = ((await page.getAttribute('.stage canvas', `data-${name}-uncertainty`)) ?? '').split(' ').map(Number);
      expect(ring.length === 2 && ring.every((m) => m > 1e-4 && m < 0.5), `${name} ${ring.join()}`).toBe(true);
    }
    const colours = await page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
      const data = canvas?.getContext('2d')?.getImageData(0, 0, canvas.width, canvas.height).data ?? [];
      const seen = new Set<number>();
      for (let i = 0; i < data.length; i += 4) seen.add(((data[i] ?? 0) << 16) | ((data[i + 1] ?? 0) << 8) | (data[i + 2] ?? 0));
      return seen.size;
    });
    expect(colours).toBeGreaterThan(20);
    await picture(page, 'map');
  });
});
