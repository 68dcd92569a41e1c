// The offline pages that the programs write, opened from their files at the sizes and in the schemes of their readers.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { findings, kDesktop, kPhone, openBrowser, openPage, type Size } from './cockpit.ts';
import { bin } from './programs.ts';

/** A sheet of US Letter, or A4, less its margins. */
const kPrinted: Size = { width: 680, height: 940 };
const kRun = 'runs/1-straight-end-loaded-1';

let folder = '';
let browser: Browser;

const run = (name: string, ...args: string[]): void => {
  execFileSync(join(bin, name), args, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
};

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'tp100-reports-'));
  browser = await openBrowser();
  run('tp100-sim', 'course', '1-straight', '--camera', '--runs', '2', '--record', 'runs', '--json');
  run('tp100d', 'report', kRun);
  run('tp100d', 'compare', kRun, 'runs/1-straight-end-loaded-2', '--out', 'compared');
  writeFileSync(
    join(folder, 'spec.toml'),
    'runs = 12\ncourse = "1-straight"\n[configuration]\ncontrol.law = { list = ["stanley", "lqr"] }\n' +
      '[robot_values]\nemulated.imu.gyro_scale_error = { normal = [0.0, 0.01] }\n',
  );
  run('tp100-sim', 'campaign', 'spec.toml', '--out', 'campaign');
  run('tp100-sim', 'merge', 'campaign');
});

afterAll(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens a page of the folder, which must ask for nothing but its own file. */
async function open(file: string): Promise<{ page: Page; complaints: string[] }> {
  const complaints: string[] = [];
  const page = await openPage(browser, 'about:blank', complaints, kDesktop);
  page.on('request', (request) => {
    if (!request.url().startsWith('file:')) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(`file://${join(folder, file)}`);
  return { page, complaints };
}

const ground = (page: Page): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

it('a report leads to the replay of its run, and has the errors beside what their covariance expects', async () => {
  const { page } = await open(`${kRun}/report.html`);
  expect(await page.locator('a', { hasText: 'Replay it' }).getAttribute('href')).toBe(`../../#replay=${basename(kRun)}`);
  const names = (await page.locator('figure', { hasText: 'two standard deviations' }).textContent()) ?? '';
  for (const source of ['model', 'odometry', 'fused']) expect(names).toContain(`${source}, 2 sd`);
  await page.close();
});

it.each([
  ['the report of a run', `${kRun}/report.html`],
  ['the comparison of runs', 'compared/compare.html'],
  ['the page of a campaign', 'campaign/index.html'],
])('%s can be read by everybody, dark and light, on a desktop, a phone and paper', async (_, file) => {
  const { page, complaints } = await open(file);
  for (const [scheme, size, colour] of [['light', kPhone, 'rgb(255, 255, 255)'], ['dark', kDesktop, 'rgb(10, 14, 19)']] as const) {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize(size);
    expect(await findings(page), scheme).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), scheme).toBeLessThanOrEqual(size.width);
    expect(await ground(page)).toBe(colour);
  }
  expect(complaints).toEqual([]);
  for (const title of await page.locator('figure > svg').evaluateAll((all) => all.map((one) => one.getAttribute('aria-label')))) expect(title).toBeTruthy();

  // Printed, it is dark on white whatever the screen has. Tables and figures that fit on a sheet are not cut in two, and
  // their headings stay with them.
  await page.setViewportSize(kPrinted);
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  expect(await ground(page)).toBe('rgb(255, 255, 255)');
  const style = (selector: string, name: 'breakInside' | 'breakAfter'): Promise<string[]> =>
    page.locator(selector).evaluateAll((all, of) => all.map((one) => getComputedStyle(one)[of]), name);
  for (const value of await style('table, figure, tr', 'breakInside')) expect(value).toBe('avoid');
  for (const value of await style('h2, h2 + p, caption', 'breakAfter')) expect(value).toBe('avoid');
  await page.close();
});
