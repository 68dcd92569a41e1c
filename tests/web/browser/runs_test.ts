import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { alive, picture, run, until, type Size } from './cockpit.ts';
import { bin } from './programs.ts';
import { Setting } from './setting.ts';

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

/** A report gives way to everything else on a busy machine. */
const kMade_ms = 120_000;

const folder = mkdtempSync(join(tmpdir(), 'tp100-runs-'));
const setting = new Setting({ options: ['--record', folder], configuration: '[record]\nquota_mb = 1000\n' });
const recorded = (course: string): string => readdirSync(folder).find((name) => name.startsWith(`${course}-`)) ?? '';

beforeAll(() => {
  for (const course of ['1-curve', '1-sharp']) execFileSync(join(bin, 'tp100-sim'), ['course', course, '--record', folder]);
  mkdirSync(join(folder, 'corrupted'));
  writeFileSync(join(folder, 'corrupted', 'run.mcap'), 'no recording');
});
afterAll(() => {
  rmSync(folder, { recursive: true, force: true });
});

const row = (page: Page, name: string): Locator => page.locator(`.runs tr[data-run="${name}"]`);
const titled = (page: Page, title: string): Locator => page.locator('.runs tr', { hasText: title });
const message = (page: Page): Promise<string> => page.textContent('.runs-message').then((text) => text ?? '');

async function openRuns(size?: Size): Promise<Page> {
  const page = await setting.open(size);
  await alive(page);
  await page.click('#tab-runs');
  await page.waitForSelector('.runs tbody tr');
  return page;
}

/** The page that the click opens in a tab of its own. */
async function opened(page: Page, click: () => Promise<void>): Promise<Page> {
  const [tab] = await Promise.all([page.context().waitForEvent('page', { timeout: kMade_ms }), click()]);
  await tab.waitForLoadState();
  return tab;
}

describe('a recorded run', () => {
  it('is reported after it has ended, and the report opens', async () => {
    const page = await openRuns();
    await until(async () => (await run(page)) !== 'idle', 'the run has begun by itself');
    await page.click('#stop');
    // Its recording ends a second later.
    const last = page.locator('.runs tr[data-run$="-3"]');
    await until(async () => (await last.count()) === 1 && (await last.locator('.run-make').isEnabled()), 'it is recorded');
    const report = await opened(page, () => last.locator('.run-make').click());
    expect(report.url()).toMatch(/\/runs\/[\w-]+-3\/report\.html$/);
    await until(() => report.isVisible('h1'), 'the report');
    await report.close();
    await until(async () => (await last.locator('.run-report').count()) === 1, 'the report stays beside it');
    await until(async () => (await message(page)).startsWith('Open the report of'), 'a link for who closed it', () => message(page));
  });

  it('is compared with another one', async () => {
    const page = await openRuns();
    expect(await page.isEnabled('#compare')).toBe(false);
    for (const name of ['1-curve', '1-sharp']) await row(page, recorded(name)).locator('.run-box input').check();
    await until(() => page.isEnabled('#compare'), 'two are chosen');
    const comparison = await opened(page, () => page.click('#compare'));
    expect(comparison.url()).toMatch(/\/runs\/[\w-]+\/compare-[\w-]+\.html$/);
    await until(() => comparison.isVisible('h1'), 'the comparison');
    await comparison.close();
    await until(async () => (await page.locator('.runs').getByText('comparison', { exact: true }).count()) === 1, 'it stays');
  });

  it('says why a report is not made', async () => {
    const page = await openRuns();
    await row(page, 'corrupted').locator('.run-make').click();
    await until(async () => (await message(page)).includes('is not made'), 'the reason', () => message(page));
    expect(await message(page)).toMatch(/report of corrupted is not made: corrupted\/run\.mcap: .*not a recording/);
    expect(await message(page)).not.toContain(folder);
    await until(() => row(page, recorded('1-sharp')).locator('.run-make').isEnabled(), 'another one may be made');
  });

  it('gets a name, a note and tags, which stay', async () => {
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
    expect(readFileSync(join(folder, name, 'run.toml'), 'utf8')).toContain('tags = "wet lab"');
    const again = await openRuns();
    await until(async () => (await titled(again, 'Wet floor').count()) === 1, 'its name on another page');
  });

  it('is not deleted while it is replayed, and only after a question', async () => {
    const page = await openRuns();
    const name = recorded('1-curve');
    const remove = row(page, name).locator('.run-delete');
    await row(page, name).getByText('replay').click();
    await until(() => page.isVisible('#scrub'), 'the bar of the recording');
    await until(() => remove.isDisabled(), 'it is replayed');
    await page.click('#live');
    await until(() => remove.isEnabled(), 'it is left');
    await remove.click();
    await until(async () => (await remove.textContent()) === 'really delete', 'the question');
    expect(existsSync(join(folder, name))).toBe(true);
    await remove.click();
    await until(async () => (await row(page, name).count()) === 0, 'it is gone', () => message(page));
    expect(existsSync(join(folder, name))).toBe(false);
  });

  it('is downloaded whole', async () => {
    const page = await openRuns();
    const name = recorded('1-sharp');
    await row(page, name).locator('summary').click();
    const [download] = await Promise.all([page.waitForEvent('download'), row(page, name).locator('.run-zip').click()]);
    expect(download.suggestedFilename()).toBe(`${name}.zip`);
    const script = 'import sys,zipfile; z=zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print(*z.namelist())';
    const names = execFileSync('python3', ['-I', '-c', script, await download.path()], { encoding: 'utf8' });
    expect(names.trim().split(' ')).toEqual(readdirSync(join(folder, name)).sort().map((file) => `${name}/${file}`));
  });

  it('is shown on every screen, with the room on the disk', async () => {
    const page = await openRuns(kScreens[0]);
    await until(async () => /^\d+ runs, .* of at most .*free$/.test((await page.textContent('.runs-room')) ?? ''), 'the room', () => page.textContent('.runs-room'));
    for (const size of kScreens) {
      await page.setViewportSize(size);
      await until(() => page.evaluate(([w]) => document.documentElement.clientWidth === w, [size.width]), 'the page has its size');
      await page.locator('.runs').scrollIntoViewIfNeeded();
      const wide = await page.$eval('.runs', (runs) => runs.scrollWidth > runs.clientWidth + 1);
      expect(wide, String(size.width)).toBe(false);
      await picture(page, `runs-${size.width}`);
      await row(page, recorded('1-sharp')).getByText('edit').click();
      await until(() => page.isVisible('.run-form'), 'the form');
      expect(await page.$eval('.runs', (runs) => runs.scrollWidth > runs.clientWidth + 1), `the form at ${size.width}`).toBe(false);
      await picture(page, `runs-form-${size.width}`);
      await page.locator('.run-form').getByText('Cancel').click();
      await until(async () => !(await page.isVisible('.run-form')), 'the list');
    }
  });
});
