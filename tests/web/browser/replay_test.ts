import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { drawn, picture, until } from './cockpit.ts';
import { bin } from './programs.ts';
import { Setting } from './setting.ts';

/** The page shows the newest step that is not later than the requested time; steps are 5 ms apart. */
const kSoon_s = 0.02;
const kSame_m = 1e-6;

const folder = mkdtempSync(join(tmpdir(), 'tp100-replay-'));
const setting = new Setting({ smooth: true, options: ['--record', folder] });

interface Moment {
  t_s: number;
  x_m: number;
  y_m: number;
}
let exported: Moment[] = [];

beforeAll(() => {
  execFileSync(join(bin, 'tp100-sim'), ['course', '1-curve', '--record', folder]);
  const run = readdirSync(folder).find((name) => name.includes('1-curve')) ?? '';
  const out = join(folder, 'exported');
  execFileSync(join(bin, 'tp100d'), ['export', join(folder, run), '--csv', '--out', out]);
  const [head = '', ...lines] = readFileSync(join(out, 'poses.csv'), 'utf8').trim().split('\n');
  const at = ['t_s', 'odometry_x_m', 'odometry_y_m'].map((name) => head.split(',').indexOf(name));
  exported = lines.map((line) => {
    const [t_s = NaN, x_m = NaN, y_m = NaN] = at.map((column) => Number(line.split(',')[column]));
    return { t_s, x_m, y_m };
  });
});
afterAll(() => {
  rmSync(folder, { recursive: true, force: true });
});

/** The time at which the robot was at the drawn pose, according to `tp100d export`. */
async function drawnAt(page: Page): Promise<number | undefined> {
  const [x = NaN, y = NaN] = (await drawn(page)) ?? [];
  return exported.find((moment) => Math.hypot(moment.x_m - x, moment.y_m - y) < kSame_m)?.t_s;
}

/** Moves the slider to a time; returns the time that is then drawn. */
async function scrub(page: Page, position_s: number): Promise<number> {
  const before = (await drawn(page))?.join();
  await page.fill('#scrub', String(position_s));
  await until(async () => (await drawn(page))?.join() !== before, `a picture of ${position_s} s`);
  return until(() => drawnAt(page), `a recorded pose at ${position_s} s`);
}

describe('a recording', () => {
  it('is shown at any moment, forwards and back, and left again', async () => {
    const page = await setting.open();
    await page.click('#tab-runs');
    await page.locator('tr', { hasText: '1-curve' }).getByText('replay').click();
    await until(() => page.isVisible('#scrub'), 'the bar of the recording');
    await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 10, 'all of the recording');
    expect(await page.getAttribute('body', 'class')).toContain('replaying');

    const five_s = await scrub(page, 5);
    for (const position_s of [12, 7.5, 15, 3]) expect(Math.abs((await scrub(page, position_s)) - five_s - (position_s - 5))).toBeLessThan(kSoon_s);
    await picture(page, 'replay');

    const paused = await page.inputValue('#scrub');
    await page.click('#play');
    await until(async () => Number(await page.inputValue('#scrub')) > Number(paused) + 0.5, 'it plays');
    expect(await page.isEnabled('#stop')).toBe(true);

    await page.click('#live');
    await until(async () => !((await page.getAttribute('body', 'class')) ?? '').includes('replaying'), 'the robot itself');
  });
});
