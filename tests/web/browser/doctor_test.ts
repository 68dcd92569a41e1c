// The examination of robot and machine on the page. What ends the check of the tracks: tests/programs/wheels_up_test.cpp.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { driveUntil, findings, fits, kPhone, rest, run, shows, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();

async function openDoctor(): Promise<Page> {
  const page = await setting.openTab('doctor', kPhone);
  await rest(page);
  return page;
}

async function examine(page: Page): Promise<string> {
  await until(() => page.isEnabled('#doctor-examine'), 'it may be examined');
  await page.click('#doctor-examine');
  return shows(page, '.doctor-message', /ready to drive|not examined/i);
}

const severity = (page: Page, name: string): Promise<string | null> => page.getAttribute(`.finding[data-name="${name}"]`, 'data-severity');

describe('the doctor', () => {
  it('examines port, robot and machine', async () => {
    const page = await openDoctor();
    await examine(page);
    expect(await page.locator('.doctor-list section').evaluateAll((all) => all.map((each) => each.getAttribute('data-part')))).toEqual(['port', 'robot', 'machine']);
    for (const name of ['device', 'permission', 'holder', 'firmware', 'start', 'battery', 'imu', 'page-port']) expect(await severity(page, name), name).toBe('ok');
    // How well they are depends on what else this machine does.
    for (const name of ['link', 'real-time', 'disk']) expect(await page.isVisible(`.finding[data-name="${name}"]`), name).toBe(true);
    expect(await page.isVisible('#stop')).toBe(true);
    await fits(page, '#page-doctor');
  });

  it('runs the tracks once they are free', async () => {
    const page = await openDoctor();
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
    await fits(page, '#page-doctor');
  });

  it('waits for the end of a run, and says what to do when the robot is gone', async () => {
    const page = await setting.openTab('doctor');
    await driveUntil(page, 'running');
    await until(async () => (await page.isDisabled('#doctor-examine')) || (await run(page)) !== 'running', 'Examine is off');
    await setting.pair.robot.end();
    await until(async () => (await run(page)) === 'aborted', 'the run ends');
    expect(await examine(page)).toContain('Not ready to drive');
    expect(await severity(page, 'device')).toBe('error');
    expect(await page.textContent('.finding[data-name="device"] .finding-fix')).toContain('plug the robot in');
  });
});
