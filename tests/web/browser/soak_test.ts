import type { CDPSession, Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, driveUntil, goOn, run } from './cockpit.ts';
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
  frames_hz: number;
}

async function weigh(cdp: CDPSession, page: Page): Promise<Weight> {
  const metrics = async (): Promise<Record<string, number>> => {
    const { metrics: all } = await cdp.send('Performance.getMetrics');
    const frames = await page.evaluate(() => (window as { frames_?: number }).frames_ ?? NaN);
    return { ...Object.fromEntries(all.map(({ name, value }) => [name, value])), frames };
  };
  const windows: { frame_ms: number; frames_hz: number }[] = [];
  for (let i = 0; i < kWindows; i++) {
    const before = await metrics();
    await page.waitForTimeout(1000 * kWindow_s);
    const after = await metrics();
    const during = (key: string): number => (after[key] ?? NaN) - (before[key] ?? NaN);
    windows.push({ frame_ms: (1000 * during('ThreadTime')) / during('frames'), frames_hz: during('frames') / during('Timestamp') });
  }
  await cdp.send('HeapProfiler.collectGarbage');
  const clean = await metrics();
  return {
    heap_bytes: clean.JSHeapUsedSize ?? NaN,
    nodes: clean.Nodes ?? NaN,
    listeners: clean.JSEventListeners ?? NaN,
    frame_ms: Math.min(...windows.map(({ frame_ms }) => frame_ms)),
    frames_hz: Math.max(...windows.map(({ frames_hz }) => frames_hz)),
  };
}

describe('a page that stays open', () => {
  it(`neither grows nor slows in ${kSoak_s} s`, { timeout: (kSoak_s + 300) * 1000 }, async () => {
    const page = await setting.open(undefined, { smooth: true });
    await page.evaluate(() => {
      const counted = window as { frames_?: number };
      counted.frames_ = 0;
      const count = (): void => {
        counted.frames_ = (counted.frames_ ?? 0) + 1;
        requestAnimationFrame(count);
      };
      requestAnimationFrame(count);
    });
    const cdp = await page.context().newCDPSession(page);
    await cdp.send('Performance.enable');
    await alive(page);
    await driveUntil(page, 'running');
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
      const weight = await weigh(cdp, page);
      looks.push(weight);
      console.log(
        `look ${look + 1} of ${kLooks}: heap ${(weight.heap_bytes / 1e6).toFixed(2)} MB, nodes ${weight.nodes}, ` +
          `listeners ${weight.listeners}, frame ${weight.frame_ms.toFixed(1)} ms, ${weight.frames_hz.toFixed(1)} Hz`,
      );
    }
    const [first] = looks;
    const last = looks.at(-1);
    if (first === undefined || last === undefined) throw new Error('it was never weighed');
    const quickest = (some: Weight[]): number => Math.min(...some.map(({ frame_ms }) => frame_ms));
    expect(last.heap_bytes - first.heap_bytes).toBeLessThan(kNoise_bytes);
    // The event log may grow to its limit, with four nodes and their texts per line.
    expect(last.nodes - first.nodes).toBeLessThan(300 * 10);
    expect(last.listeners - first.listeners).toBeLessThan(20);
    expect(quickest(looks.slice(-kCompared))).toBeLessThan(kSlower * quickest(looks.slice(0, kCompared)));
  });
});
