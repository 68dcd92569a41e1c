import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { findings } from './axe.ts';
import { driveUntil, fits, kPhone, rest, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();

async function openDoctor(size?: Size): Promise<Page> {
  const page = await setting.openTab('doctor', size);
  await rest(page);
  return page;
}

async function examine(page: Page): Promise<string> {
  await until(() => page.isEnabled('#doctor-examine'), 'it may be examined');
  await page.click('#doctor-examine');
  const message = async (): Promise<string> => (await page.textContent('.doctor-message')) ?? '';
  return until(async () => /ready to drive|not examined/i.test(await message()) && message(), 'the verdict', message);
}

const severity = (page: Page, name: string): Promise<string | null> => page.getAttribute(`.finding[data-name="${name}"]`, 'data-severity');

describe('the doctor', () => {
  it('examines port, robot and machine', async () => {
    const page = await openDoctor(kPhone);
    await page.click('#drawer-size');
    await examine(page);
    expect(await page.locator('.doctor-list section').evaluateAll((all) => all.map((each) => each.getAttribute('data-part')))).toEqual(['port', 'robot', 'machine']);
    for (const name of ['device', 'permission', 'holder', 'firmware', 'start', 'battery', 'imu', 'page-port']) expect(await severity(page, name), name).toBe('ok');
    // How well they are depends on what else this machine does.
    for (const name of ['link', 'real-time', 'disk']) expect(await page.isVisible(`.finding[data-name="${name}"]`), name).toBe(true);
    for (const fix of await page.locator('.finding[data-severity="ok"] .finding-fix').all()) expect(await fix.textContent()).toBe('');
    expect(await page.isVisible('#stop')).toBe(true);
    await fits(page, '#page-doctor', 'doctor');
  });

  it('runs the tracks once they are free', async () => {
    const page = await openDoctor(kPhone);
    await page.click('#drawer-size');
    await until(() => page.isEnabled('#wheels-up-free'), 'it may be confirmed');
    expect(await page.isDisabled('#wheels-up-start')).toBe(true);
    // On a busy machine the page may be silent for so long that the check is broken off: it is then confirmed anew.
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
    for (const name of ['left-track', 'right-track', 'gyro'])
      expect(await page.getAttribute(`.wheels-up .finding[data-name="${name}"]`, 'data-severity'), name).toBe('ok');
    expect(await page.isChecked('#wheels-up-free')).toBe(false);
    expect(await findings(page, '#page-doctor')).toEqual([]);
    await fits(page, '#page-doctor', 'wheels-up');
  });

  it('stops the tracks by STOP', async () => {
    const page = await openDoctor();
    await until(() => page.isEnabled('#wheels-up-free'), 'it may be confirmed');
    await page.check('#wheels-up-free');
    await until(() => page.isEnabled('#wheels-up-start'), 'it may begin');
    const before = setting.pair.robot.lines.length;
    await page.click('#wheels-up-start');
    await setting.pair.robot.line(/motors on/, before);
    await page.click('#stop');
    await until(async () => (await page.getAttribute('.wheels-up .finding[data-name="wheels-up"]', 'data-severity').catch(() => null)) === 'error', 'it is broken off');
    expect(await page.textContent('.wheels-up .finding')).toContain('stopped before it was complete');
  });

  it('waits for the end of a run, and says what to do when the robot is gone', async () => {
    const page = await openDoctor();
    await driveUntil(page, 'running');
    await until(async () => (await page.isDisabled('#doctor-examine')) || (await run(page)) !== 'running', 'Examine is off');
    await setting.pair.robot.end();
    await until(async () => (await run(page)) === 'aborted', 'the run ends');
    expect(await examine(page)).toContain('Not ready to drive');
    expect(await severity(page, 'device')).toBe('error');
    expect(await page.textContent('.finding[data-name="device"] .finding-fix')).toContain('plug the robot in');
  });
});
