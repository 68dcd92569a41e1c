// Recorded runs on the page: listed, reported, compared, named, replayed, downloaded and deleted.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { drawn, driveUntil, fits, kDesktop, rest, until, type Size } from './cockpit.ts';
import { bin } from './programs.ts';
import { Setting } from './setting.ts';

/** A report gives way to everything else on a busy machine. */
const kMade_ms = 120_000;

const setting = new Setting({ records: true, configuration: '[record]\nquota_mb = 1000\n' });
const folder = (): string => join(setting.pair.folder, 'runs');
const recorded = (course: string): string => readdirSync(folder()).find((name) => name.startsWith(`${course}-`)) ?? '';

beforeAll(() => {
  for (const course of ['1-curve', '1-sharp']) execFileSync(join(bin, 'tp100-sim'), ['course', course, '--record', folder()]);
  mkdirSync(join(folder(), 'corrupted'));
  writeFileSync(join(folder(), 'corrupted', 'run.mcap'), 'no recording');
});

const row = (page: Page, name: string): Locator => page.locator(`.runs tr[data-run="${name}"]`);
const titled = (page: Page, title: string): Locator => page.locator('.runs tr', { hasText: title });
const message = (page: Page): Promise<string> => page.textContent('.runs-message').then((text) => text ?? '');

async function openRuns(size?: Size): Promise<Page> {
  const page = await setting.openTab('runs', size);
  await page.waitForSelector('.runs tbody tr');
  return page;
}

/** The page that the click opens in a tab of its own. */
async function opened(page: Page, click: () => Promise<void>): Promise<Page> {
  const [tab] = await Promise.all([page.context().waitForEvent('page', { timeout: kMade_ms }), click()]);
  await tab.waitForLoadState();
  await until(() => tab.isVisible('h1'), 'a page with a title');
  return tab;
}

describe('a recorded run', () => {
  it('is reported after it has ended, and compared with another one', async () => {
    const page = await openRuns();
    await driveUntil(page, 'running');
    await rest(page);
    // Its recording ends a second later.
    const last = page.locator('.runs tr[data-run$="-3"]').first();
    await until(async () => (await last.count()) === 1 && (await last.locator('.run-make').isEnabled()), 'it is recorded');
    const report = await opened(page, () => last.locator('.run-make').click());
    expect(report.url()).toMatch(/\/runs\/[\w-]+-3\/report\.html$/);
    await report.close();
    await until(async () => (await last.locator('.run-report').count()) === 1, 'the report stays beside it');
    await until(async () => (await message(page)).startsWith('Open the report of'), 'a link for who closed it', () => message(page));

    expect(await page.isEnabled('#compare')).toBe(false);
    for (const name of ['1-curve', '1-sharp']) await row(page, recorded(name)).locator('.run-box input').check();
    await until(() => page.isEnabled('#compare'), 'two are chosen');
    const comparison = await opened(page, () => page.click('#compare'));
    expect(comparison.url()).toMatch(/\/runs\/[\w-]+\/compare-[\w-]+\.html$/);
    await comparison.close();
    await until(async () => (await page.locator('.runs').getByText('comparison', { exact: true }).count()) === 1, 'it stays');

    await row(page, 'corrupted').locator('.run-make').click();
    await until(async () => (await message(page)).includes('is not made'), 'the reason', () => message(page));
    expect(await message(page)).toMatch(/report of corrupted is not made: corrupted\/run\.mcap: .*not a recording/);
    expect(await message(page)).not.toContain(folder());
    await until(() => row(page, recorded('1-sharp')).locator('.run-make').isEnabled(), 'another one may be made');
  });

  it('gets a name, a note and tags, which stay, and is downloaded whole', async () => {
    const page = await openRuns();
    const name = recorded('1-sharp');
    await row(page, name).getByText('edit').click();
    await page.fill('[name=run-name]', 'Wet floor <b>\u2713');
    await page.fill('[name=run-tags]', 'wet  lab');
    await page.fill('.run-form textarea', 'first line\nsecond line');
    await page.click('.run-save');
    await until(async () => (await titled(page, 'Wet floor <b>\u2713').count()) === 1, 'its name', () => message(page));
    const shown = await row(page, name).locator('.run-what').innerText();
    for (const text of ['wet', 'lab', 'first line', 'second line']) expect(shown).toContain(text);
    expect(readFileSync(join(folder(), name, 'run.toml'), 'utf8')).toContain('tags = "wet lab"');
    await page.reload();
    await page.click('#tab-runs');
    await until(async () => (await titled(page, 'Wet floor').count()) === 1, 'its name on a new page');

    await row(page, name).locator('summary').click();
    const [download] = await Promise.all([page.waitForEvent('download'), row(page, name).locator('.run-zip').click()]);
    expect(download.suggestedFilename()).toBe(`${name}.zip`);
    const script = 'import sys,zipfile; z=zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print(*z.namelist())';
    const names = execFileSync('python3', ['-I', '-c', script, await download.path()], { encoding: 'utf8' });
    expect(names.trim().split(' ')).toEqual(readdirSync(join(folder(), name)).sort().map((file) => `${name}/${file}`));
  });

  it('is shown on every screen, with the room on the disk', async () => {
    const page = await openRuns(kDesktop);
    await until(async () => /^\d+ runs, .* of at most .*free$/.test((await page.textContent('.runs-room')) ?? ''), 'the room', () => page.textContent('.runs-room'));
    await fits(page, '.runs', 'runs');
    await row(page, recorded('1-sharp')).getByText('edit').click();
    await until(() => page.isVisible('.run-form'), 'the form');
    await fits(page, '.runs', 'runs-form');
  });
});

interface Moment {
  t_s: number;
  x_m: number;
  y_m: number;
}

/** When the robot was where, according to `tp100d export`. */
function poses(run: string): Moment[] {
  const out = join(setting.pair.folder, 'exported');
  execFileSync(join(bin, 'tp100d'), ['export', join(folder(), run), '--csv', '--out', out]);
  const [head = '', ...lines] = readFileSync(join(out, 'poses.csv'), 'utf8').trim().split('\n');
  const columns = ['t_s', 'odometry_x_m', 'odometry_y_m'].map((name) => head.split(',').indexOf(name));
  return lines.map((line) => {
    const [t_s = NaN, x_m = NaN, y_m = NaN] = columns.map((column) => Number(line.split(',')[column]));
    return { t_s, x_m, y_m };
  });
}

describe('a replayed run', () => {
  it('is shown at any moment, forwards and back, and deleted only after it was left, and after a question', async () => {
    const page = await openRuns();
    const name = recorded('1-curve');
    const exported = poses(name);
    const drawnAt = async (): Promise<number | undefined> => {
      const [x = NaN, y = NaN] = (await drawn(page)) ?? [];
      return exported.find((moment) => Math.hypot(moment.x_m - x, moment.y_m - y) < 1e-6)?.t_s;
    };
    /** Moves the slider to a time; returns the time that is drawn once the picture has changed and rests. */
    const scrub = async (position_s: number): Promise<number> => {
      const before = await drawnAt();
      await page.fill('#scrub', String(position_s));
      let last = before;
      return until(async () => {
        await page.waitForTimeout(300);
        const now = await drawnAt();
        const rests = now !== undefined && now !== before && now === last;
        last = now;
        return rests && now;
      }, `a recorded pose at ${position_s} s`);
    };
    const remove = row(page, name).locator('.run-delete');
    await row(page, name).getByText('replay').click();
    await until(() => page.isVisible('#scrub'), 'the bar of the recording');
    await until(() => remove.isDisabled(), 'it is replayed');
    await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 10, 'all of the recording');
    expect(await page.getAttribute('body', 'class')).toContain('replaying');

    // The newest step that is not later than the slider; steps are 5 ms apart.
    const five_s = await scrub(5);
    for (const position_s of [12, 7.5, 15, 3]) expect(Math.abs((await scrub(position_s)) - five_s - (position_s - 5))).toBeLessThan(0.02);
    const paused = Number(await page.inputValue('#scrub'));
    await page.click('#play');
    await until(async () => Number(await page.inputValue('#scrub')) > paused + 0.5, 'it plays');
    expect(await page.isEnabled('#stop')).toBe(true);

    await page.click('#live');
    await until(async () => !((await page.getAttribute('body', 'class')) ?? '').includes('replaying'), 'the robot itself');
    await until(() => remove.isEnabled(), 'it is left');
    await remove.click();
    await until(async () => (await remove.textContent()) === 'really delete', 'the question');
    expect(existsSync(join(folder(), name))).toBe(true);
    await remove.click();
    await until(async () => (await row(page, name).count()) === 0, 'it is gone', () => message(page));
    expect(existsSync(join(folder(), name))).toBe(false);
  });
});
