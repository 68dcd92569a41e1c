// Memory and speed of a page that stays open.
import type { CDPSession, Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { alive, goOn, run } from './cockpit.ts';
import { Setting } from './setting.ts';

/** `scripts/web soak` sets two hours; the tests run long enough to find a leak in every message. */
const kSoak_s = Number(process.env.TP100_SOAK_S ?? 45);
const kWarmUp_s = Math.min(kSoak_s / 3, 180);
/** Number of measurements after the warm-up; the best frame times of the first and of the last ones are compared. */
const kLooks = kSoak_s < 600 ? 2 : 13;
const kCompared = Math.ceil(kLooks / 4);
/**
 * Allows for noise of the collector and for lists that fill up to their limits. A leak of messages exceeds this in seconds.
 */
const kNoise_bytes = 3e6;
/** Other programs also use the caches; work that grows with every message takes far more than this. */
const kSlower = 2.5;
const kWindow_s = 2;
const kWindows = 3;

const setting = new Setting();

interface Weight {
  heap_bytes: number;
  nodes: number;
  listeners: number;
  /** Processor time for one frame of the page, scripts and layout; other programs hardly change it. */
  frame_ms: number;
}

async function weigh(cdp: CDPSession, page: Page): Promise<Weight> {
  const metrics = async (): Promise<Record<string, number>> => {
    const { metrics: all } = await cdp.send('Performance.getMetrics');
    const frames = await page.evaluate(() => (window as { frames_?: number }).frames_ ?? NaN);
    return { ...Object.fromEntries(all.map(({ name, value }) => [name, value])), frames };
  };
  const frames_ms: number[] = [];
  for (let i = 0; i < kWindows; i++) {
    const before = await metrics();
    await page.waitForTimeout(1000 * kWindow_s);
    const after = await metrics();
    const during = (key: string): number => (after[key] ?? NaN) - (before[key] ?? NaN);
    frames_ms.push((1000 * during('ThreadTime')) / during('frames'));
  }
  await cdp.send('HeapProfiler.collectGarbage');
  const { JSHeapUsedSize: heap_bytes = NaN, Nodes: nodes = NaN, JSEventListeners: listeners = NaN } = await metrics();
  return { heap_bytes, nodes, listeners, frame_ms: Math.min(...frames_ms) };
}

it(`a page that stays open neither grows nor slows in ${kSoak_s} s`, { timeout: (kSoak_s + 300) * 1000 }, async () => {
  const page = await setting.open(undefined, { smooth: true });
  await page.evaluate(() => {
    const counted = window as { frames_?: number };
    const count = (): void => {
      counted.frames_ = (counted.frames_ ?? 0) + 1;
      requestAnimationFrame(count);
    };
    count();
  });
  const cdp = await page.context().newCDPSession(page);
  await cdp.send('Performance.enable');
  await alive(page);
  const driveFor = async (duration_s: number): Promise<void> => {
    const end_ms = performance.now() + 1000 * duration_s;
    while (performance.now() < end_ms) {
      await page.waitForTimeout(1000);
      if ((await run(page)) !== 'running') await goOn(page);
    }
  };
  await driveFor(kWarmUp_s);
  const looks: Weight[] = [];
  for (let look = 0; look < kLooks; look++) {
    if (look > 0) await driveFor((kSoak_s - kWarmUp_s) / (kLooks - 1));
    looks.push(await weigh(cdp, page));
    console.log(JSON.stringify(looks.at(-1)));
  }
  const quickest = (some: Weight[]): number => Math.min(...some.map(({ frame_ms }) => frame_ms));
  const grown = (what: keyof Weight): number => (looks.at(-1)?.[what] ?? NaN) - (looks[0]?.[what] ?? NaN);
  expect(grown('heap_bytes')).toBeLessThan(kNoise_bytes);
  // The event log may grow to its limit, with four nodes and their texts per line.
  expect(grown('nodes')).toBeLessThan(300 * 10);
  expect(grown('listeners')).toBeLessThan(20);
  expect(quickest(looks.slice(-kCompared))).toBeLessThan(kSlower * quickest(looks.slice(0, kCompared)));
});
