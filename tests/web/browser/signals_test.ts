// The tabs of signals, events and parameters.
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { alive, driveUntil, fits, kDesktop, kPhone, rest, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ records: true, configuration: '# of the law\n[control]\n  preview_s = 0.05 # mine\n' });

describe('signals', () => {
  async function choose(page: Page, name: string): Promise<void> {
    await page.fill('input[aria-label="Search signals"]', name);
    await until(() => page.isVisible(`.signal-list input[aria-label="${name}"]`), name);
    await page.check(`.signal-list input[aria-label="${name}"]`);
  }

  /** Waits until so many values are shown. */
  async function known(page: Page, count: number): Promise<void> {
    const figures = (): Promise<string[]> => page.locator('.signal-chart .plot-value').allTextContents();
    await until(
      async () => {
        const all = await figures();
        return all.length === count && all.every((text) => /\d/.test(text));
      },
      `${count} values`,
      () => figures().then(String),
    );
  }

  /** What a button saves. */
  async function saved(page: Page, id: string): Promise<Buffer> {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(id)]);
    return readFile(await download.path());
  }

  async function table(page: Page): Promise<number[][]> {
    const lines = (await saved(page, '#signals-csv')).toString().trim().split('\n');
    return lines.slice(1).map((line) => line.split(',').map((cell) => (cell === '' ? NaN : Number(cell))));
  }
  const span_s = (rows: number[][]): number => (rows.at(-1)?.[0] ?? 0) - (rows[0]?.[0] ?? 0);
  const says = (page: Page, text: string): Promise<boolean> => until(async () => (await page.textContent('#signals-pause')) === text, text);

  it('of any channel are chosen, paused, zoomed and saved', async () => {
    const page = await setting.openTab('signals', kDesktop);
    await page.click('#drawer-size');
    for (const name of ['/estimate.tracks.left_mps', '/estimate.tracks.right_mps', '/sample.battery_v', '/loop.work_us.p99']) await choose(page, name);
    await known(page, 4);
    expect(await page.locator('.signal-chart').count()).toBe(3);
    await page.fill('input[aria-label="Search signals"]', '');
    await fits(page, '#page-signals', 'signals');

    await page.click('#signals-pause');
    await says(page, 'Go on');
    const whole = await table(page);
    expect(whole.length).toBeGreaterThan(2);
    await until(async () => (await page.textContent('#number-battery')) !== '\u2013', 'messages come');
    expect((await table(page)).at(-1)?.[0], 'a paused table ends where it did').toBe(whole.at(-1)?.[0]);
    await page.click('#signals-in');
    expect((await table(page)).length).toBeLessThan(whole.length);
    const png = await saved(page, '#signals-png');
    expect(png.subarray(1, 4).toString()).toBe('PNG');
    expect(png.readUInt32BE(20)).toBeGreaterThan(3 * 170);
    await page.click('#signals-pause');
    await says(page, 'Pause');

    const box = await page.locator('.signal-chart .u-over').first().boundingBox();
    if (box === null) throw new Error('no diagram');
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.9 * box.width, box.y + 40, { steps: 5 });
    await page.mouse.up();
    await says(page, 'Go on');
    expect(span_s(await table(page)), 'what was dragged over').toBeLessThan(25);
  });

  it('have their past after a reload, and are those of a recording while it is replayed', async () => {
    const page = await setting.openTab('signals', kDesktop);
    await choose(page, '/sample.left_counts');
    await known(page, 1);
    await driveUntil(page, 'running');
    // The page is at least so old that the past is told from the present.
    const began = Date.now();
    await until(() => Date.now() - began > 3000, 'some past');
    await page.reload();
    await alive(page);
    await page.click('#tab-signals');
    await known(page, 1);
    const loaded_s = await page.evaluate(() => performance.now() / 1000);
    await until(async () => span_s(await table(page)) > loaded_s + 2, 'the past is there');

    await rest(page);
    await page.click('#tab-runs');
    const replay = page.locator('.runs').getByText('replay').first();
    await until(() => replay.isVisible(), 'a recording', () => page.textContent('.runs'));
    await replay.click();
    await until(() => page.evaluate(() => document.body.classList.contains('replaying')), 'it is replayed');
    await page.click('#tab-signals');
    await known(page, 1);
    expect((await table(page)).length).toBeGreaterThan(1);
  });
});

describe('events', () => {
  it('have the wall clock, and are filtered by level and words', async () => {
    const page = await setting.openTab('events', kPhone);
    const rows = (): Promise<number> => page.locator('.event:visible').count();
    await rest(page);
    await until(async () => (await page.locator('.event[data-kind="stop"]').count()) > 0, 'STOP is an event');
    const time = (await page.locator('.event[data-kind="stop"] time').first().textContent()) ?? '';
    expect(time).toMatch(/^\d\d:\d\d:\d\d$/);
    const age_s = (Date.now() - new Date(`${new Date().toDateString()} ${time}`).getTime()) / 1000;
    expect(Math.abs(age_s), 'now, or around midnight').toSatisfy((s: number) => s < 100 || s > 86_300);
    const all = await rows();
    await page.selectOption('select[aria-label="Level of events"]', '1');
    await until(async () => (await rows()) < all, 'only warnings and errors');
    expect(await page.locator('.event[data-level="info"]:visible').count()).toBe(0);
    await page.fill('input[aria-label="Search events"]', 'stop viewer');
    await until(async () => (await rows()) > 0 && (await page.locator('.event:visible').allTextContents()).every((text) => text.includes('STOP')), 'what was searched');
    await page.fill('input[aria-label="Search events"]', 'zzz');
    await until(() => page.isVisible('text=No event matches.'), 'nothing is found');
  });
});

describe('parameters', () => {
  async function openParameters(size?: Size): Promise<Page> {
    const page = await setting.openTab('parameters', size);
    await until(() => page.isVisible('[data-name="loop.rate_hz"]'), 'the list');
    await rest(page);
    return page;
  }

  async function type(page: Page, name: string, text: string): Promise<void> {
    await page.fill(`input[aria-label="${name}"]`, text);
    await page.press(`input[aria-label="${name}"]`, 'Enter');
  }

  const path = (): string => join(setting.pair.folder, 'tp100.toml');
  const file = (): Promise<string> => readFile(path(), 'utf8');
  const about = (page: Page, name: string): Promise<string> => page.textContent(`[data-name="${name}"]`).then((text) => text ?? '');
  const message = (page: Page, part: string): Promise<unknown> =>
    until(async () => ((await page.textContent('.parameters-message')) ?? '').includes(part), part, () => page.textContent('.parameters-message'));

  it('are saved after the difference was shown, and taken back', async () => {
    const page = await openParameters(kDesktop);
    const bus = new Bus(setting.pair.url, ['/parameter']);
    const original = await file();
    await type(page, 'control.preview_s', '0.08');
    await until(() => bus.last('/parameter')?.parameters.find(({ name }) => name === 'control.preview_s')?.value === 0.08, 'it is in force');
    await until(async () => (await about(page, 'control.preview_s')).includes('in the file: 0.05'), 'what the file has');
    await type(page, 'loop.rate_hz', '100');
    await until(async () => (await page.textContent('#parameters-save'))?.includes('(1)'), 'the edit counts');
    expect(await file()).toBe(original);

    await page.click('#parameters-save');
    await until(() => page.isVisible('#parameters-question'), 'the difference');
    expect(await page.locator('#parameters-question li').allTextContents()).toEqual(['loop.rate_hz200.0100.0', 'control.preview_s0.050.08']);
    await fits(page, '.parameters', 'parameters');
    await page.click('#parameters-write');
    await message(page, 'tp100.toml is saved');
    expect(await file()).toBe(original.replace('preview_s = 0.05', 'preview_s = 0.08').replace('hold_cpu_latency = false\n', 'hold_cpu_latency = false\nrate_hz = 100.0\n'));
    await until(async () => (await about(page, 'loop.rate_hz')).includes('in the file: 100.0'), 'the next start has it');

    await page.click('#parameters-restore');
    await until(() => page.isVisible('#parameters-question'), 'the difference back');
    await page.click('#parameters-write');
    await until(async () => (await file()) === original, 'the file is as before');
    bus.close();
  });

  it('are searched, and refused with the reason', async () => {
    const page = await openParameters();
    const original = await file();
    await page.fill('input[aria-label="Search parameters"]', 'steps per second');
    await until(async () => (await page.locator('.parameter:visible').count()) === 1, 'one is found');
    await type(page, 'loop.rate_hz', '5000');
    await until(async () => (await page.textContent('[data-name="loop.rate_hz"] .parameter-why')) === 'allowed is 50 to 1000 Hz', 'why not');
    await page.fill('input[aria-label="Search parameters"]', 'zzz');
    await until(() => page.isVisible('text=No parameter matches.'), 'nothing is found');

    // What a person wrote wrongly meanwhile is named, and stays.
    await page.fill('input[aria-label="Search parameters"]', '');
    await writeFile(path(), '[control]\npreview = 1\n');
    await page.click('#parameters-save');
    await message(page, "unknown key 'control.preview'");
    expect(await file()).toBe('[control]\npreview = 1\n');
    await writeFile(path(), original);
  });
});
