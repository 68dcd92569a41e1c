import type { Browser, CDPSession, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { driveUntil, openBrowser, openPage, Pair, run } from './programs.ts';

/** Two hours by scripts/web soak; in the tests, what is enough to see a leak of every message. */
const kSoak_s = Number(process.env.TP100_SOAK_S ?? 30);
const kWarmUp_s = Math.min(kSoak_s / 3, 180);
/** The collector's own noise. */
const kNoise_bytes = 1.5e6;

let browser: Browser;
let pair: Pair;
beforeAll(async () => {
  [browser, pair] = await Promise.all([openBrowser(), Pair.start()]);
});
afterAll(async () => {
  await browser.close();
  await pair.end();
});

interface Weight {
  heap_bytes: number;
  nodes: number;
  listeners: number;
  script_share: number;
}

async function weigh(cdp: CDPSession, page: Page): Promise<Weight> {
  const metrics = async (): Promise<Record<string, number>> => {
    const { metrics: all } = await cdp.send('Performance.getMetrics');
    return Object.fromEntries(all.map(({ name, value }) => [name, value]));
  };
  const before = await metrics();
  await page.waitForTimeout(4000);
  const after = await metrics();
  await cdp.send('HeapProfiler.collectGarbage');
  const clean = await metrics();
  const share = (key: string): number => ((after[key] ?? 0) - (before[key] ?? 0)) / ((after.Timestamp ?? 1) - (before.Timestamp ?? 0));
  return {
    heap_bytes: clean.JSHeapUsedSize ?? NaN,
    nodes: clean.Nodes ?? NaN,
    listeners: clean.JSEventListeners ?? NaN,
    script_share: share('ScriptDuration'),
  };
}

describe('a page that stays open', () => {
  it(`neither grows nor slows in ${kSoak_s} s`, { timeout: (kSoak_s + 300) * 1000 }, async () => {
    const { page, complaints } = await openPage(browser, pair.url);
    const cdp = await page.context().newCDPSession(page);
    await cdp.send('Performance.enable');
    await driveUntil(page, 'running');
    await page.waitForTimeout(1000 * kWarmUp_s);
    const first = await weigh(cdp, page);
    const end_ms = performance.now() + 1000 * (kSoak_s - kWarmUp_s);
    while (performance.now() < end_ms) {
      await page.waitForTimeout(1000);
      if ((await run(page)) !== 'running') await driveUntil(page, 'running');
    }
    const last = await weigh(cdp, page);
    console.log(`heap ${(first.heap_bytes / 1e6).toFixed(2)} -> ${(last.heap_bytes / 1e6).toFixed(2)} MB, ` +
      `nodes ${first.nodes} -> ${last.nodes}, script ${(100 * first.script_share).toFixed(1)} -> ${(100 * last.script_share).toFixed(1)} %`);
    expect(last.heap_bytes - first.heap_bytes).toBeLessThan(kNoise_bytes);
    // The event log may grow to its limit: four nodes and their texts a line.
    expect(last.nodes - first.nodes).toBeLessThan(300 * 10);
    expect(last.listeners - first.listeners).toBeLessThan(20);
    expect(complaints).toEqual([]);
  });
});
