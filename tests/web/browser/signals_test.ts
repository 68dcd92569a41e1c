import { mkdtempSync, rmSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, it } from 'vitest';
import { alive, driveUntil, picture, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const folder = mkdtempSync(join(tmpdir(), 'tp100-signals-'));
const setting = new Setting({ options: ['--record', folder] });
afterAll(() => { rmSync(folder, { recursive: true, force: true }); });

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

async function choose(page: Page, name: string): Promise<void> {
  await page.fill('input[aria-label="Search signals"]', name);
  await until(() => page.isVisible(`.signal-list input[aria-label="${name}"]`), name);
  await page.check(`.signal-list input[aria-label="${name}"]`);
}

const figures = (page: Page): Promise<string[]> => page.locator('.signal-chart .plot-value').allTextContents();
const known = (page: Page, count: number): Promise<unknown> =>
  until(async () => {
    const all = await figures(page);
    return all.length === count && all.every((text) => /\d/.test(text));
  }, `${count} values`, () => figures(page).then(String));

/** What a button saves. */
async function saved(page: Page, id: string): Promise<Buffer> {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(id)]);
  return readFile(await download.path());
}

async function table(page: Page): Promise<number[][]> {
  const lines = (await saved(page, '#signals-csv')).toString().trim().split('\n');
  return lines.slice(1).map((line) => line.split(',').map((cell) => (cell === '' ? NaN : Number(cell))));
}

describe('signals', () => {
  for (const size of kScreens) {
    it(`of any channel are chosen, paused, zoomed and saved at ${size.width} x ${size.height}`, async () => {
      const page = await setting.open(size);
      await alive(page);
      await page.click('#tab-signals');
      await page.click('#drawer-size');
      for (const name of ['/estimate.tracks.left_mps', '/estimate.tracks.right_mps', '/sample.battery_v', '/loop.work_us.p99']) await choose(page, name);
      await known(page, 4);
      expect(await page.locator('.signal-chart').count()).toBe(3);
      await page.fill('input[aria-label="Search signals"]', '');
      await page.locator('#signals-pause').scrollIntoViewIfNeeded();
      await picture(page, `signals-${size.width}`);

      await page.click('#signals-pause');
      await until(async () => (await page.textContent('#signals-pause')) === 'Go on', 'it is paused');
      const whole = await table(page);
      expect(whole.length).toBeGreaterThan(2);
      await until(async () => (await page.textContent('#number-battery')) !== '\u2013', 'messages come');
      expect((await table(page)).at(-1)?.[0], 'a paused table ends where it did').toBe(whole.at(-1)?.[0]);
      await page.click('#signals-in');
      const part = await table(page);
      expect(part.length).toBeLessThan(whole.length);

      const png = await saved(page, '#signals-png');
      expect(png.subarray(1, 4).toString()).toBe('PNG');
      expect(png.readUInt32BE(20)).toBeGreaterThan(3 * 170);
      await page.click('#signals-pause');
      await until(async () => (await page.textContent('#signals-pause')) === 'Pause', 'it goes on');
    });
  }

  it('show a part of the time that is dragged over', async () => {
    const page = await setting.open({ width: 1440, height: 900 });
    await alive(page);
    await page.click('#tab-signals');
    await page.click('#drawer-size');
    await choose(page, '/estimate.step');
    await known(page, 1);
    const box = await page.locator('.signal-chart .u-over').boundingBox();
    if (box === null) throw new Error('no diagram');
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.9 * box.width, box.y + 40, { steps: 5 });
    await page.mouse.up();
    await until(async () => (await page.textContent('#signals-pause')) === 'Go on', 'a part is shown');
    const times = (await table(page)).map(([t_s]) => t_s ?? NaN);
    expect((times.at(-1) ?? 0) - (times[0] ?? 0)).toBeLessThan(25);
  });

  it('and diagrams have their past after a reload', async () => {
    const page = await setting.open({ width: 1440, height: 900 });
    await alive(page);
    await page.click('#tab-signals');
    await choose(page, '/estimate.step');
    await known(page, 1);
    // The page is at least so old that the past is told from the present.
    const began = Date.now();
    await until(() => Date.now() - began > 3000, 'some past');
    await page.reload();
    await alive(page);
    await page.click('#tab-signals');
    await known(page, 1);
    const loaded_s = await page.evaluate(() => performance.now() / 1000);
    await until(async () => {
      const rows = await table(page);
      return (rows.at(-1)?.[0] ?? 0) - (rows[0]?.[0] ?? 0) > loaded_s + 2;
    }, 'the past is there');
  });

  it('are those of a recording while it is replayed', async () => {
    const page = await setting.open({ width: 1440, height: 900 });
    await alive(page);
    await page.click('#tab-signals');
    await choose(page, '/sample.left_counts');
    await driveUntil(page, 'running');
    const began = Date.now();
    await until(() => Date.now() - began > 1500, 'some way');
    await page.keyboard.press('Escape');
    await until(async () => ['aborted', 'finished'].includes(await run(page)), 'the run is over');
    await page.click('#tab-runs');
    const replay = page.locator('.runs').getByText('replay').first();
    await until(() => replay.isVisible(), 'a recording', () => page.textContent('.runs'));
    await replay.click();
    await until(() => page.evaluate(() => document.body.classList.contains('replaying')), 'it is replayed');
    await page.click('#tab-signals');
    await known(page, 1);
    const rows = await table(page);
    expect(rows.length).toBeGreaterThan(1);
    await picture(page, 'signals-replay');
  });
});
