import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { alive, driveUntil, picture, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ each: true, configuration: '# of the law\n[control]\n  preview_s = 0.05 # mine\n' });

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

async function openParameters(size?: Size): Promise<Page> {
  const page = await setting.open(size);
  await alive(page);
  await page.click('#tab-parameters');
  await until(() => page.isVisible('[data-name="loop.rate_hz"]'), 'the list');
  // An emulated robot starts by itself.
  await page.keyboard.press('Escape');
  await until(async () => ['aborted', 'idle', 'finished'].includes(await run(page)), 'no run is under way');
  return page;
}

async function type(page: Page, name: string, text: string): Promise<void> {
  await page.fill(`input[aria-label="${name}"]`, text);
  await page.press(`input[aria-label="${name}"]`, 'Enter');
}

const file = (): Promise<string> => readFile(join(setting.pair.folder, 'tp100.toml'), 'utf8');
const about = (page: Page, name: string): Promise<string> => page.textContent(`[data-name="${name}"]`).then((text) => text ?? '');
const message = (page: Page, part: string): Promise<unknown> =>
  until(async () => ((await page.textContent('.parameters-message')) ?? '').includes(part), part, () => page.textContent('.parameters-message'));

describe('parameters', () => {
  for (const size of kScreens) {
    it(`are saved after the difference was shown, and taken back, at ${size.width} x ${size.height}`, async () => {
      const page = await openParameters(size);
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
      const lines = await page.locator('#parameters-question li').allTextContents();
      expect(lines).toEqual(['loop.rate_hz200.0100.0', 'control.preview_s0.050.08']);
      if (size.width < 1000) await page.click('#drawer-size');
      await page.locator('#parameters-write').scrollIntoViewIfNeeded();
      await picture(page, `parameters-${size.width}`);
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
  }

  it('are searched, and refused with the reason', async () => {
    const page = await openParameters();
    await page.fill('input[aria-label="Search parameters"]', 'steps per second');
    await until(async () => (await page.locator('.parameter:visible').count()) === 1, 'one is found');
    await type(page, 'loop.rate_hz', '5000');
    await until(async () => (await page.textContent('[data-name="loop.rate_hz"] .parameter-why')) === 'allowed is 50 to 1000 Hz', 'why not');
    await page.fill('input[aria-label="Search parameters"]', 'zzz');
    await until(() => page.isVisible('text=No parameter matches.'), 'nothing is found');

    // What a person wrote wrongly meanwhile is named, and stays.
    await page.fill('input[aria-label="Search parameters"]', '');
    await writeFile(join(setting.pair.folder, 'tp100.toml'), '[control]\npreview = 1\n');
    await page.click('#parameters-save');
    await message(page, "unknown key 'control.preview'");
    expect(await file()).toBe('[control]\npreview = 1\n');
  });

  it('of the next start are not saved during a run', async () => {
    const page = await openParameters();
    const original = await file();
    await type(page, 'loop.rate_hz', '100');
    await driveUntil(page, 'running');
    await page.click('#parameters-save');
    await until(() => page.isVisible('#parameters-question'), 'the difference');
    await page.click('#parameters-write');
    await until(
      async () => {
        if ((await run(page)) !== 'running') return 'the run has ended by itself';
        return ((await page.textContent('.parameters-message')) ?? '').includes('not saved during a run');
      },
      'it is refused',
    );
    if ((await page.textContent('.parameters-message'))?.includes('not saved during a run') === true) expect(await file()).toBe(original);
  });
});

describe('a page that may not command', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('shows the parameters and saves none', async () => {
    const page = await setting.open();
    await alive(page);
    await page.click('#tab-parameters');
    await until(() => page.isVisible('[data-name="loop.rate_hz"]'), 'the list');
    await until(() => page.isDisabled('#parameters-save'), 'Save is off');
  });
});
