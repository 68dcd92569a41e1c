import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { findings } from './axe.ts';
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
  return message(page, /ready to drive|not examined/i);
}

const message = (page: Page, pattern: RegExp): Promise<string> =>
  until(
    async () => {
      const text = (await page.textContent('.doctor-message')) ?? '';
      return pattern.test(text) && text;
    },
    String(pattern),
    () => page.textContent('.doctor-message'),
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

  for (const size of kScreens) {
    it(`runs the tracks once they are free, at ${size.width} x ${size.height}`, async () => {
      const page = await openDoctor(setting, size);
      await alive(page);
      await page.keyboard.press('Escape');
      await until(async () => ['aborted', 'idle', 'finished'].includes(await run(page)), 'no run is under way');
      await page.click('#drawer-size');
      await until(() => page.isEnabled('#wheels-up-free'), 'it may be confirmed');
      expect(await page.isDisabled('#wheels-up-start')).toBe(true);
      // On a busy machine the page may be silent for so long that the check is broken off: it is then confirmed anew.
      const wheels = ['left-track', 'right-track', 'gyro'];
      await until(
        async () => {
          // Read before the findings: they are there by the time that the next check may be confirmed.
          const confirmable = await page.isEnabled('#wheels-up-free');
          if (await page.isVisible('.wheels-up .finding[data-name="gyro"]')) return true;
          if (!confirmable) return false;
          await page.check('#wheels-up-free', { timeout: 2000 }).catch(() => undefined);
          if (!(await page.isEnabled('#wheels-up-start'))) return false;
          await page.click('#wheels-up-start');
          // Until the page shows that it began, it may be confirmed, and this loop would confirm the next one.
          await until(() => page.isDisabled('#wheels-up-start'), 'the check begins').catch(() => undefined);
          return false;
        },
        'the tracks are judged',
        () => page.textContent('.wheels-up-message'),
      );
      for (const name of wheels) expect(await page.getAttribute(`.wheels-up .finding[data-name="${name}"]`, 'data-severity'), name).toBe('ok');
      expect(await page.isChecked('#wheels-up-free')).toBe(false);
      expect(await findings(page, '#page-doctor')).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth)).toBe(true);
      await picture(page, `wheels-up-${size.width}`);
    });
  }

  it('stops the tracks by STOP', async () => {
    const page = await openDoctor(setting);
    await alive(page);
    await page.keyboard.press('Escape');
    await until(() => page.isEnabled('#wheels-up-free'), 'it may be confirmed');
    await page.check('#wheels-up-free');
    await until(() => page.isEnabled('#wheels-up-start'), 'it may begin');
    await page.click('#wheels-up-start');
    await setting.pair.robot.line(/motors on/, setting.pair.robot.lines.length);
    await page.click('#stop');
    await until(async () => (await page.getAttribute('.wheels-up .finding[data-name="wheels-up"]', 'data-severity').catch(() => null)) === 'error', 'it is broken off');
    expect(await page.textContent('.wheels-up .finding')).toContain('stopped before it was complete');
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
