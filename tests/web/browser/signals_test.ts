// The tabs of signals, events and parameters.
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { drag, driveUntil, fits, goTo, kDesktop, kPhone, picture, rest, shows, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ records: true, configuration: '# of the law\n[control]\n  preview_s = 0.05 # mine\n' });

describe('signals', () => {
  /** Chooses signals, and waits until each has a value. */
  async function choose(page: Page, ...names: string[]): Promise<void> {
    for (const name of names) {
      await page.fill('input[aria-label="Search signals"]', name);
      await page.check(`.signal-list input[aria-label="${name}"]`);
    }
    await known(page, names.length);
  }

  /** Waits until so many values are shown. */
  async function known(page: Page, count: number): Promise<void> {
    const figures = (): Promise<string[]> => page.locator('.signal-chart .plot-value').allTextContents();
    const all = async (): Promise<boolean> => {
      const shown = await figures();
      return shown.length === count && shown.every((text) => /\d/.test(text));
    };
    await until(all, `${count} values`, () => figures().then(String));
  }

  /** What a button saves. */
  async function saved(page: Page, id: string): Promise<Buffer> {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(id)]);
    return readFile(await download.path());
  }

  /** The times of the table that is saved. */
  async function times_s(page: Page): Promise<number[]> {
    const lines = (await saved(page, '#signals-csv')).toString().trim().split('\n');
    return lines.slice(1).map((line) => parseFloat(line));
  }
  const span_s = async (page: Page): Promise<number> => {
    const times = await times_s(page);
    return (times.at(-1) ?? 0) - (times[0] ?? 0);
  };

  it('of any channel are chosen, paused, zoomed and saved', async () => {
    const page = await setting.openTab('signals', kDesktop);
    await choose(page, '/estimate.tracks.left_mps', '/estimate.tracks.right_mps', '/sample.battery_v', '/loop.work_us.p99');
    expect(await page.locator('.signal-chart').count()).toBe(3);
    await page.fill('input[aria-label="Search signals"]', '');
    await fits(page, '#page-signals');

    await page.click('#signals-pause');
    await shows(page, '#signals-pause', /^Continue$/);
    const whole = await times_s(page);
    expect(whole.length).toBeGreaterThan(2);
    const bus = new Bus(setting.pair.url, ['/estimate']);
    await until(() => bus.last('/estimate') !== undefined, 'messages arrive');
    const paused_s = bus.last('/estimate')?.t_s ?? 0;
    await until(() => (bus.last('/estimate')?.t_s ?? 0) > paused_s + 1, 'messages go on');
    bus.close();
    expect((await times_s(page)).at(-1), 'a paused table ends where it did').toBe(whole.at(-1));
    await page.click('#signals-in');
    expect((await times_s(page)).length).toBeLessThan(whole.length);
    await page.click('#signals-pause');
    await shows(page, '#signals-pause', /^Pause$/);

    const box = await page.locator('.signal-chart .u-over').first().boundingBox();
    if (box === null) throw new Error('no diagram');
    await drag(page, { x: box.x + 0.5 * box.width, y: box.y + 40 }, { x: box.x + 0.9 * box.width, y: box.y + 40 });
    await shows(page, '#signals-pause', /^Continue$/);
    expect(await span_s(page), 'what was dragged over').toBeLessThan(25);
  });

  it('have their past after a reload, and are those of a recording while it is replayed', async () => {
    const page = await setting.openTab('signals', kDesktop);
    await choose(page, '/sample.left_counts');
    await driveUntil(page, 'running');
    // The page is at least so old that the past is told from the present.
    await page.waitForTimeout(3000);
    await page.reload();
    await goTo(page, 'signals');
    await known(page, 1);
    const loaded_s = await page.evaluate(() => performance.now() / 1000);
    await until(async () => (await span_s(page)) > loaded_s + 2, 'the past is there');

    await rest(page);
    await goTo(page, 'runs');
    await page.locator('.runs').getByText('replay').first().click();
    await until(() => page.evaluate(() => document.body.classList.contains('replaying')), 'it is replayed');
    await goTo(page, 'signals');
    await known(page, 1);
    expect((await times_s(page)).length).toBeGreaterThan(1);
    // The picture of TUTORIALS.md.
    await page.fill('#scrub', '3');
    await shows(page, '.transport-time', /^0:03/);
    await picture(page, 'analyse-1440');
  });
});

it('events have the wall clock, and are filtered by level and words', async () => {
  const page = await setting.openTab('events', kPhone);
  const rows = page.locator('.event:visible');
  await rest(page);
  const time = await shows(page, '.event[data-kind="stop"] time', /^\d\d:\d\d:\d\d$/);
  const age_s = (Date.now() - new Date(`${new Date().toDateString()} ${time}`).getTime()) / 1000;
  expect(Math.abs(age_s), 'now, or around midnight').toSatisfy((s: number) => s < 100 || s > 86_300);
  const all = await rows.count();
  await page.selectOption('select[aria-label="Level of events"]', '1');
  await until(async () => (await rows.count()) < all, 'only warnings and errors');
  expect(await page.locator('.event[data-level="info"]:visible').count()).toBe(0);
  await page.fill('input[aria-label="Search events"]', 'stop viewer');
  await until(async () => (await rows.count()) > 0 && (await rows.allTextContents()).every((text) => text.includes('STOP')), 'what was searched');
});

describe('parameters', () => {
  async function openParameters(): Promise<Page> {
    const page = await setting.openTab('parameters', kDesktop);
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

  it('are saved after the difference was shown, and taken back', async () => {
    const page = await openParameters();
    const bus = new Bus(setting.pair.url, ['/parameter']);
    const original = await file();
    await type(page, 'control.preview_s', '0.08');
    await until(() => bus.last('/parameter')?.parameters.find(({ name }) => name === 'control.preview_s')?.value === 0.08, 'it is in force');
    await shows(page, '[data-name="control.preview_s"]', 'in the file: 0.05');
    await type(page, 'loop.rate_hz', '100');
    await shows(page, '#parameters-save', '(1)');
    expect(await file()).toBe(original);

    await page.click('#parameters-save');
    await until(() => page.isVisible('#parameters-question'), 'the difference');
    expect(await page.locator('#parameters-question li').allTextContents()).toEqual(['loop.rate_hz200.0100.0', 'control.preview_s0.050.08']);
    await fits(page, '.parameters');
    await page.click('#parameters-write');
    await shows(page, '.parameters-message', 'tp100.toml is saved');
    expect(await file()).toBe(original.replace('preview_s = 0.05', 'preview_s = 0.08').replace('hold_cpu_latency = false\n', 'hold_cpu_latency = false\nrate_hz = 100.0\n'));
    await shows(page, '[data-name="loop.rate_hz"]', 'in the file: 100.0');

    await page.click('#parameters-restore');
    await until(() => page.isVisible('#parameters-question'), 'the difference back');
    await page.click('#parameters-write');
    await until(async () => (await file()) === original, 'the file is as before');
    bus.close();
  });

  it('are searched, and refused with the reason', async () => {
    const page = await openParameters();
    await page.fill('input[aria-label="Search parameters"]', 'steps per second');
    await until(async () => (await page.locator('.parameter:visible').count()) === 1, 'one is found');
    await type(page, 'loop.rate_hz', '5000');
    await shows(page, '[data-name="loop.rate_hz"] .parameter-why', /^allowed is 50 to 1000 Hz$/);

    // What a person wrote wrongly meanwhile is named, and stays.
    await writeFile(path(), '[control]\npreview = 1\n');
    await page.click('#parameters-save');
    await shows(page, '.parameters-message', "unknown key 'control.preview'");
    expect(await file()).toBe('[control]\npreview = 1\n');
  });
});
