import type { Page } from 'playwright-core';
import { afterEach, describe, expect, it } from 'vitest';
import type { Estimate } from '../../../daemon/web/state/messages.ts';
import { Bus } from './bus.ts';
import { drawn, driveUntil, figure, goOn, picture, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();
let bus: Bus | undefined;
afterEach(() => {
  bus?.close();
});

/** The index, from `from` on, of the published message whose pose is drawn. */
function said(received: Estimate[], from: number, at: number[]): number | undefined {
  const [x = NaN, y = NaN, z = NaN, yaw = NaN] = at;
  for (let i = received.length - 1; i >= from; i--) {
    const estimate = received[i];
    const pose = estimate?.[estimate.steering];
    if (pose && Math.hypot(pose.x_m - x, pose.y_m - y, pose.z_m - z, pose.yaw_rad - yaw) < 1e-6) return i;
  }
  return undefined;
}

describe('the page of a robot that drives course 3', () => {
  it('shows it where the bus says, from the first metre to the end', async () => {
    bus = new Bus(setting.pair.url, ['/estimate', '/state', '/course']);
    const received = (bus.received['/estimate'] ??= []);
    const progress_m = (): number => received.at(-1)?.progress_m ?? 0;
    const page = await setting.open();
    /**
     * The drawn pose and its message, which must not be older than `from`: the page may be late, but not wrong or frozen.
     */
    const follows = (from: number): Promise<{ at: number[]; index: number }> =>
      until(
        async () => {
          const at = await drawn(page);
          const index = at && said(received, from, at);
          return at !== undefined && index !== undefined && { at, index };
        },
        `the robot is drawn where the bus says, after message ${from}`,
        () => received.length,
      );

    await driveUntil(page, 'running');
    const length_m = await until(() => bus?.last('/course')?.length_m, 'a course');
    expect(length_m).toBeCloseTo(4.057, 3);
    const places: number[][] = [];
    const behind_ms: number[] = [];
    for (const share of [0.1, 0.3, 0.5, 0.7, 0.9]) {
      await until(
        async () => {
          if (progress_m() > share * length_m) return true;
          await goOn(page);
          return false;
        },
        `${share} of the way`,
        progress_m,
      );
      const { at, index } = await follows(received.length);
      places.push(at);
      behind_ms.push(1000 * ((received.at(-1)?.t_s ?? NaN) - (received[index]?.t_s ?? NaN)));
      expect(await figure(page, 'x')).toBeGreaterThan(-0.1);
      if (share === 0.7) await chase(page, () => follows(received.length));
    }
    const ways = places.map(([x = 0, y = 0]) => Math.hypot(x - (places[0]?.[0] ?? 0), y - (places[0]?.[1] ?? 0)));
    expect(Math.max(...ways)).toBeGreaterThan(0.8);

    await until(
      async () => {
        const state = await run(page);
        if (state === 'aborted') await goOn(page);
        return state === 'finished';
      },
      'the run is finished',
      progress_m,
    );
    await until(async () => Math.abs((await figure(page, 'y')) - (bus?.last('/estimate')?.odometry.y_m ?? NaN)) < 0.005, 'the last figures');
    await until(async () => /4\.0\d \/ 4\.06 m/.test((await page.textContent('.timeline-progress')) ?? ''), 'the whole way');
    await picture(page, 'finished');
    const ended = setting.pair.daemon.lines.filter((line) => line.includes('running -> aborted')).length;
    console.log(`runs that ended early: ${ended}; picture behind the bus: ${behind_ms.map((ms) => ms.toFixed(0)).join(', ')} ms`);
  });
});

/** The other cameras must show the robot, too. */
async function chase(page: Page, follows: () => Promise<unknown>): Promise<void> {
  await page.click('#camera-chase');
  await follows();
  await picture(page, 'chase');
  await page.click('#camera-free');
  await page.click('#camera-free');
}
