import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, driveUntil, picture, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];

async function openDoctor(setting: Setting, size?: Size): Promise<Page> {
  const page = await setting.open(size);
  await page.click('#tab-doctor');
  return page;
}

async function examine(page: Page): Promise<string> {
  await until(() => page.isEnabled('#doctor-examine'), 'it may be examined');
  await page.click('#doctor-examine');
  return said(page, /ready to drive|not examined/i);
}

const said = (page: Page, pattern: RegExp): Promise<string> =>
  until(
    async () => {
      const text = (await page.textContent('.doctor-said')) ?? '';
      return pattern.test(text) && text;
    },
    String(pattern),
    () => page.textContent('.doctor-said'),
  );

const severity = (page: Page, name: string): Promise<string | null> => page.getAttribute(`.finding[data-name="${name}"]`, 'data-severity');

describe('the doctor', () => {
  const setting = new Setting({ each: true });

  for (const size of kScreens) {
    it(`examines port, robot and machine at ${size.width} x ${size.height}`, async () => {
      const page = await openDoctor(setting, size);
      await alive(page);
      // An emulated robot starts by itself.
      await page.keyboard.press('Escape');
      await until(async () => ['aborted', 'idle', 'finished'].includes(await run(page)), 'no run is under way');
      await page.click('#drawer-size');
      await examine(page);
      expect(await page.locator('.doctor-list section').evaluateAll((all) => all.map((each) => each.getAttribute('data-part')))).toEqual(['port', 'robot', 'machine']);
      for (const name of ['device', 'permission', 'holder', 'firmware', 'start', 'battery', 'imu', 'page-port']) expect(await severity(page, name), name).toBe('ok');
      // How well they are depends on what else this machine does.
      for (const name of ['link', 'real-time', 'disk']) expect(await page.isVisible(`.finding[data-name="${name}"]`), name).toBe(true);
      for (const fix of await page.locator('.finding[data-severity="ok"] .finding-fix').all()) expect(await fix.textContent()).toBe('');
      expect(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth)).toBe(true);
      expect(await page.isVisible('#stop')).toBe(true);
      await picture(page, `doctor-${size.width}`);
    });
  }

  it('says what to do when the robot is gone', async () => {
    const page = await openDoctor(setting);
    await alive(page);
    await setting.pair.robot.end();
    await until(async () => (await page.textContent('#chip-run .chip-value')) === 'aborted', 'the run ends');
    expect(await examine(page)).toContain('Not ready to drive');
    expect(await severity(page, 'device')).toBe('error');
    expect(await page.textContent('.finding[data-name="device"] .finding-fix')).toContain('plug the robot in');
  });

  it('waits for the end of a run', async () => {
    const page = await openDoctor(setting);
    await alive(page);
    await driveUntil(page, 'running');
    await until(async () => (await page.isDisabled('#doctor-examine')) || (await run(page)) !== 'running', 'Examine is off');
    await page.keyboard.press('Escape');
    await until(() => page.isEnabled('#doctor-examine'), 'Examine is on');
  });
});

describe('a page that may not command', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('examines nothing', async () => {
    const page = await openDoctor(setting);
    await alive(page);
    await until(async () => (await page.getAttribute('#doctor-examine', 'title'))?.includes('server.commands'), 'why not');
    expect(await page.isDisabled('#doctor-examine')).toBe(true);
  });
});
