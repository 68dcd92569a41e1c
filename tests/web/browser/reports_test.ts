// The offline pages that the programs write, opened from their files at the sizes and in the schemes of their readers.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { colours, kThemes } from '../unit/theme.ts';
import { findings } from './axe.ts';
import { openBrowser, openPage, type Size } from './cockpit.ts';
import { bin } from './programs.ts';

const kDesktop: Size = { width: 1280, height: 900 };
/** A sheet of US Letter, or A4, less its margins. */
const kPrinted: Size = { width: 680, height: 940 };
const kPhone: Size = { width: 390, height: 844 };

let folder = '';
let browser: Browser;

const run = (name: string, ...args: string[]): void => {
  execFileSync(join(bin, name), args, { cwd: folder, stdio: ['ignore', 'ignore', 'inherit'] });
};

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'tp100-reports-'));
  browser = await openBrowser();
  run('tp100-sim', 'course', '1-straight', '--camera', '--runs', '2', '--record', 'runs', '--json');
  run('tp100d', 'report', 'runs/1-straight-end-loaded-1');
  run('tp100d', 'compare', 'runs/1-straight-end-loaded-1', 'runs/1-straight-end-loaded-2', '--out', 'compared');
  writeFileSync(
    join(folder, 'spec.toml'),
    'runs = 12\ncourse = "1-straight"\n[configuration]\ncontrol.law = { list = ["stanley", "lqr"] }\n' +
      '[robot_values]\nemulated.imu.gyro_scale_error = { normal = [0.0, 0.01] }\n',
  );
  run('tp100-sim', 'campaign', 'spec.toml', '--out', 'campaign');
  run('tp100-sim', 'merge', 'campaign');
  // A limit that one seed breaks is status 1; the page is there all the same.
  spawnSync(join(bin, 'tp100-sim'), ['reproduce', '--part', 'paper', '--runs', '1', '--out', 'paper'], { cwd: folder });
});

afterAll(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens a page of the folder, which must ask for nothing but its own file. */
async function open(file: string, size: Size, scheme: 'light' | 'dark'): Promise<{ page: Page; complaints: string[] }> {
  const complaints: string[] = [];
  const page = await openPage(browser, 'about:blank', complaints, size);
  page.on('request', (request) => {
    if (!request.url().startsWith('file:')) complaints.push(`asks for ${request.url()}`);
  });
  await page.emulateMedia({ colorScheme: scheme });
  await page.goto(`file://${join(folder, file)}`);
  return { page, complaints };
}

it('a report has the error of each pose beside what its covariance expects', async () => {
  const { page } = await open('runs/1-straight-end-loaded-1/report.html', kDesktop, 'light');
  const names = (await page.locator('figure', { hasText: 'two standard deviations' }).textContent()) ?? '';
  for (const source of ['model', 'odometry', 'fused']) {
    expect(names).toContain(`${source}, 2 sd`);
    expect(names.replaceAll(`${source}, 2 sd`, '')).toContain(source);
  }
});

const kPages = [
  ['the report of a run', 'runs/1-straight-end-loaded-1/report.html'],
  ['the comparison of runs', 'compared/compare.html'],
  ['the page of a campaign', 'campaign/index.html'],
  ["the paper's experiment", 'paper/index.html'],
] as const;

describe.each(kPages)('%s', (_, file) => {
  it.each([
    ['light', kDesktop],
    ['dark', kDesktop],
    ['light', kPhone],
    ['dark', kPhone],
  ] as const)('can be read by everybody, %s, at %o', async (scheme, size) => {
    const { page, complaints } = await open(file, size, scheme);
    expect(await findings(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(size.width);
    expect(complaints).toEqual([]);
    await page.close();
  });

  it('has every caption once and a title on every chart', async () => {
    const { page } = await open(file, kDesktop, 'light');
    const captions = await page.locator('caption, figcaption').allTextContents();
    expect(new Set(captions).size).toBe(captions.length);
    for (const title of await page.locator('figure > svg').evaluateAll((all) => all.map((one) => one.getAttribute('aria-label'))))
      expect(title).toBeTruthy();
    await page.close();
  });

  it('is printed dark on white, whatever the screen has', async () => {
    const { page } = await open(file, kDesktop, 'dark');
    const ground = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    expect(await ground()).toBe('rgb(10, 14, 19)');
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    expect(await ground()).toBe('rgb(255, 255, 255)');
    await page.close();
  });

  // Tables and figures that fit on a sheet are not cut in two, and their headings stay with them.
  it('is printed in whole pieces, figures in pairs', async () => {
    const { page } = await open(file, kPrinted, 'light');
    await page.emulateMedia({ media: 'print' });
    const style = (selector: string, name: 'breakInside' | 'breakAfter'): Promise<string[]> =>
      page.locator(selector).evaluateAll((all, of) => all.map((one) => getComputedStyle(one)[of]), name);
    for (const value of await style('table, figure, tr', 'breakInside')) expect(value).toBe('avoid');
    for (const value of await style('h2, h2 + p, caption', 'breakAfter')) expect(value).toBe('avoid');
    const pairs = await page.locator('figure:not(.wide) + figure:not(.wide)').evaluateAll((all) =>
      all.map((one) => [one.previousElementSibling?.getBoundingClientRect().top, one.getBoundingClientRect().top]),
    );
    const [pair] = pairs;
    if (pair !== undefined) expect(pair[1]).toBe(pair[0]);
    await page.close();
  });
});

it.each(kThemes)('has the %s colours of the live page', async (theme) => {
  const { page } = await open(kPages[0][1], kDesktop, theme);
  const same = ['ground', 'panel', 'line', 'text', 'dim', 'good', 'bad', 'link', 'path', 'truth', 'model', 'odometry', 'fused', 'left', 'right', 'value', 'run-2', 'run-3', 'run-5'];
  for (const name of same)
    expect(await page.evaluate((of) => getComputedStyle(document.documentElement).getPropertyValue(`--${of}`), name), name).toBe(colours(theme).get(name));
  await page.close();
});
