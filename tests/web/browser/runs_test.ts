// Recorded runs on the page: listed, reported, compared, named, replayed, downloaded and deleted.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { drawn, driveUntil, fits, goTo, rest, shows, until } from './cockpit.ts';
import { bin } from './programs.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ records: true, configuration: '[record]\nquota_mb = 1000\n' });
const folder = (): string => join(setting.pair.folder, 'runs');
const recorded = (course: string): string => readdirSync(folder()).find((name) => name.startsWith(`${course}-`)) ?? '';

beforeAll(() => {
  for (const course of ['1-curve', '1-sharp']) execFileSync(join(bin, 'tp100-sim'), ['course', course, '--record', folder()]);
  mkdirSync(join(folder(), 'corrupted'));
  writeFileSync(join(folder(), 'corrupted', 'run.mcap'), 'no recording');
});

const row = (page: Page, name: string): Locator => page.locator(`.runs tr[data-run="${name}"]`);

async function openRuns(): Promise<Page> {
  const page = await setting.openTab('runs');
  await page.waitForSelector('.runs tbody tr');
  return page;
}

/** The address of the page that the click opens in a tab of its own. A report gives way to everything else on a busy machine. */
async function opened(page: Page, button: Locator): Promise<string> {
  const [tab] = await Promise.all([page.context().waitForEvent('page', { timeout: 120_000 }), button.click()]);
  await tab.waitForLoadState();
  await until(() => tab.isVisible('h1'), 'a page with a title');
  await tab.close();
  return tab.url();
}

describe('a recorded run', () => {
  it('is reported after it has ended, and compared with another one', async () => {
    const page = await openRuns();
    await driveUntil(page, 'running');
    // So far from the start that a start asks.
    await page.waitForTimeout(1500);
    await rest(page);
    // Drive says how it ended, and leads to its report and its replay.
    await goTo(page, 'events');
    await shows(page, '.run-card p', /^Run stopped .* of 4\.06 m in .* off the path$/);
    await page.click('#card-replay');
    await until(() => page.evaluate(() => document.body.classList.contains('replaying')), 'it is replayed');
    expect(new URL(page.url()).hash).toMatch(/^#analyse\/runs&replay=[\d-]+-3$/);
    // What moves the robot shows the robot.
    await page.keyboard.press('r');
    await until(() => page.isEnabled('#start-placed'), 'it may start');
    await page.click('#start-placed');
    await until(async () => (await page.getAttribute('#view-drive', 'aria-current')) === 'page', 'the robot is shown');
    expect(await page.evaluate(() => document.body.classList.contains('replaying'))).toBe(false);
    await rest(page);
    await goTo(page, 'runs');
    await page.click('#live');
    // Its recording ends a second later.
    const last = page.locator('.runs tr[data-run$="-3"]').first();
    await until(async () => (await last.count()) === 1 && (await last.locator('.run-make').isEnabled()), 'it is recorded');
    // The list says how it went, finds it, and is sorted.
    await shows(last, '.run-outcome', 'stopped');
    await shows(last, '.run-error', /^[\d.]+ mm$/);
    await page.fill('.runs input[type=search]', 'stopped');
    await until(async () => (await page.locator('.runs tbody tr').count()) < (await page.locator('.runs-room').first().textContent().then((text) => parseInt(text ?? ''))), 'others are left out');
    await page.fill('.runs input[type=search]', '');
    await page.locator('.runs th.run-error button').click();
    expect(await page.getAttribute('.runs th.run-error', 'aria-sort')).toBe('ascending');
    const [table] = await Promise.all([page.waitForEvent('download'), page.click('#runs-csv')]);
    expect(table.suggestedFilename()).toBe('runs.csv');
    const report = await opened(page, last.locator('.run-make'));
    expect(report).toMatch(/\/runs\/[\w-]+-3\/report\.html$/);
    await until(async () => (await last.locator('.run-report').count()) === 1, 'the report stays beside it');

    expect(await page.isEnabled('#compare')).toBe(false);
    for (const name of ['1-curve', '1-sharp']) await row(page, recorded(name)).locator('.run-box input').check();
    await until(() => page.isEnabled('#compare'), 'two are chosen');
    expect(await opened(page, page.locator('#compare'))).toMatch(/\/runs\/[\w-]+\/compare-[\w-]+\.html$/);

    await row(page, 'corrupted').locator('.run-make').click();
    const why = await shows(page, '.runs-message', /report of corrupted is not made: corrupted\/run\.mcap: .*not a recording/);
    expect(why).not.toContain(folder());
    await until(() => row(page, recorded('1-sharp')).locator('.run-make').isEnabled(), 'another one may be made');

    // The address of a replay, typed into the open page.
    await page.evaluate((run) => { location.hash = `replay=${run}`; }, recorded('1-sharp'));
    await until(() => page.evaluate(() => document.body.classList.contains('replaying')), 'it is replayed by its address');
    await page.click('#live');
    await page.goto(report);
    await page.getByText('Replay it').click();
    await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 0.5, 'the page replays the run of the report');
  });

  it('that an address names wrongly leaves the page as it is, with its STOP', async () => {
    setting.expected = /404/;
    const page = await setting.open();
    await page.goto('about:blank');
    await page.goto(`${setting.pair.url}#replay=%E0%A4%A`);
    await shows(page, '.notice', /\S/);
    await until(() => page.isEnabled('#stop'), 'STOP may be pressed');
    expect(await page.evaluate(() => document.body.classList.contains('replaying'))).toBe(false);
  });

  it('gets a name, a note and tags, which stay, and is downloaded', async () => {
    const page = await openRuns();
    const name = recorded('1-sharp');
    await row(page, name).getByText('edit').click();
    await page.fill('[name=run-name]', 'Wet floor <b>\u2713');
    await page.fill('[name=run-tags]', 'wet  lab');
    await page.fill('.run-form textarea', 'first line\nsecond line');
    await page.click('.run-save');
    const shown = await shows(row(page, name), '.run-what', 'Wet floor <b>\u2713');
    for (const text of ['wet', 'lab', 'first line', 'second line']) expect(shown).toContain(text);
    expect(readFileSync(join(folder(), name, 'run.toml'), 'utf8')).toContain('tags = "wet lab"');
    await page.reload();
    await goTo(page, 'runs');
    await shows(row(page, name), '.run-what', 'Wet floor');

    await shows(page, '.runs-room', /^\d+ runs, .* of at most .*free$/);
    await row(page, name).locator('summary').click();
    const [download] = await Promise.all([page.waitForEvent('download'), row(page, name).locator('.run-zip').click()]);
    expect(download.suggestedFilename()).toBe(`${name}.zip`);
    await row(page, name).getByText('edit').click();
    await until(() => page.isVisible('.run-form'), 'the form');
    await fits(page, '.runs');
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
    await until(() => remove.isDisabled(), 'it is replayed');
    await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 10, 'all of the recording');

    // The newest step that is not later than the slider; steps are 5 ms apart.
    const five_s = await scrub(5);
    for (const position_s of [12, 7.5, 15, 3]) expect(Math.abs((await scrub(position_s)) - five_s - (position_s - 5))).toBeLessThan(0.02);
    const paused = Number(await page.inputValue('#scrub'));
    await page.click('#play');
    await until(async () => Number(await page.inputValue('#scrub')) > paused + 0.5, 'it plays');
    expect(await page.isEnabled('#stop')).toBe(true);

    await page.click('#live');
    await until(() => page.evaluate(() => !document.body.classList.contains('replaying')), 'the robot itself');
    await until(() => remove.isEnabled(), 'it is left');
    await remove.click();
    await shows(row(page, name), '.run-delete', /^really delete$/);
    expect(existsSync(join(folder(), name))).toBe(true);
    await remove.click();
    await until(async () => (await row(page, name).count()) === 0, 'it is gone', () => page.textContent('.runs-message'));
    expect(existsSync(join(folder(), name))).toBe(false);
  });
});
