// Memory of a page that stays open.
import type { CDPSession } from 'playwright-core';
import { expect, it } from 'vitest';
import { alive, goOn, run } from './cockpit.ts';
import { Setting } from './setting.ts';

/** `scripts/web soak` sets two hours; the tests run long enough to find a leak in every message. */
const kSoak_s = Number(process.env.TP100_SOAK_S ?? 45);
const kWarmUp_s = Math.min(kSoak_s / 3, 180);
/**
 * Allows for noise of the collector and for lists that fill up to their limits. A leak of messages exceeds this in seconds.
 */
const kNoise_bytes = 3e6;

const setting = new Setting();

interface Weight {
  heap_bytes: number;
  nodes: number;
  listeners: number;
}

async function weigh(cdp: CDPSession): Promise<Weight> {
  await cdp.send('HeapProfiler.collectGarbage');
  const { metrics } = await cdp.send('Performance.getMetrics');
  const { JSHeapUsedSize: heap_bytes = NaN, Nodes: nodes = NaN, JSEventListeners: listeners = NaN } = Object.fromEntries(metrics.map(({ name, value }) => [name, value]));
  return { heap_bytes, nodes, listeners };
}

it(`a page that stays open does not grow in ${kSoak_s} s`, { timeout: (kSoak_s + 300) * 1000 }, async () => {
  const page = await setting.open(undefined, { smooth: true });
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
  const before = await weigh(cdp);
  await driveFor(kSoak_s - kWarmUp_s);
  const after = await weigh(cdp);
  console.log(JSON.stringify([before, after]));
  const grown = (what: keyof Weight): number => after[what] - before[what];
  expect(grown('heap_bytes')).toBeLessThan(kNoise_bytes);
  // The event log may grow to its limit, with four nodes and their texts per line.
  expect(grown('nodes')).toBeLessThan(300 * 10);
  expect(grown('listeners')).toBeLessThan(20);
});
