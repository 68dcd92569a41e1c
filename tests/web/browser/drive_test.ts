import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { driveUntil, figure, openBrowser, openPage, Pair, picture, run, until } from './programs.ts';

let browser: Browser;
let pair: Pair;

beforeAll(async () => {
  [browser, pair] = await Promise.all([openBrowser(), Pair.start()]);
});

afterAll(async () => {
  await browser.close();
  await pair.end();
});

describe('the page of a robot that drives course 3', () => {
  it('shows it where the bus says, from the first metre to the end', { timeout: 600_000 }, async () => {
    const bus = new Bus(pair.url, ['/estimate', '/state', '/course']);
    const { page, complaints } = await openPage(browser, pair.url);
    const canvas = page.locator('.stage canvas');
    const drawn = async (): Promise<number[]> => ((await canvas.getAttribute('data-robot')) ?? '').split(' ').map(Number);
    /** The pose that steers, as every message so far had it, against what is drawn: the nearest one. */
    const apart = (at: number[]): number => {
      let least = Infinity;
      for (const estimate of bus.heard['/estimate'] ?? []) {
        const pose = estimate[estimate.steering];
        const [x = NaN, y = NaN, z = NaN, yaw = NaN] = at;
        least = Math.min(least, Math.hypot(pose.x_m - x, pose.y_m - y, pose.z_m - z, pose.yaw_rad - yaw));
      }
      return least;
    };

    await driveUntil(page, 'running');
    const length_m = bus.last('/course')?.length_m ?? 0;
    expect(length_m).toBeCloseTo(4.057, 3);
    const places: number[][] = [];
    for (const share of [0.1, 0.3, 0.5, 0.7, 0.9]) {
      await until(
        async () => {
          if ((bus.last('/estimate')?.progress_m ?? 0) > share * length_m) return true;
          await driveUntil(page, 'running');
          return false;
        },
        `${share} of the way`,
        180_000,
      );
      await until(async () => Number.isFinite((await drawn())[0]), 'a robot');
      const at = await drawn();
      // A message of the bus reaches both viewers; give ours the time to hear it.
      await until(() => apart(at) < 1e-6, `drawn at ${at.join(' ')}, which the bus never said`, 5000);
      places.push(at);
      expect(await figure(page, 'x')).toBeGreaterThan(-0.1);
      if (share === 0.7) {
        await page.click('#camera-chase');
        await until(async () => (await drawn())[0] !== at[0], 'the robot moves on in the chase camera');
        await picture(page, 'chase');
        await page.click('#camera-free');
        await page.click('#camera-free');
      }
    }
    const ways = places.map(([x = 0, y = 0]) => Math.hypot(x - (places[0]?.[0] ?? 0), y - (places[0]?.[1] ?? 0)));
    expect(Math.max(...ways)).toBeGreaterThan(0.8);

    await until(async () => ['finished', 'aborted'].includes(await run(page)), 'the run is over', 120_000);
    if ((await run(page)) !== 'finished') await driveUntil(page, 'finished', 240_000);
    const end = bus.last('/estimate');
    await until(async () => Math.abs((await figure(page, 'y')) - (end?.odometry.y_m ?? NaN)) < 0.005, 'the last figures');
    expect(await page.textContent('.timeline-way')).toMatch(/4\.0\d \/ 4\.06 m/);
    await picture(page, 'finished');
    expect(complaints).toEqual([]);
    bus.close();
    await page.close();
  });
});
