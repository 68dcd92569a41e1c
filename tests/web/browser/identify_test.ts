// The identification on the page, from the drives to the robot file in use. Its estimates: tests/identify.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { findings, fits, kPhone, rest, run, shows, until } from './cockpit.ts';
import { Setting } from './setting.ts';

/** Short calibration courses of the user's own. */
const course = (segment: string): string =>
  `speed_mps = 0.15\nidentifies = true\n[[segment]]\n${segment}\n[fence]\nmin_x_m = -0.5\nmax_x_m = 0.6\nmin_y_m = -0.5\nmax_y_m = 0.5\n`;

const message = (page: Page, pattern: RegExp): Promise<string> => shows(page, '.identify-message', pattern);

/** Presses Drive of a course and waits for the question that follows. */
async function askToDrive(page: Page, name: string): Promise<void> {
  await until(() => page.isEnabled(`[data-course="${name}"] .identify-drive`), 'it may be driven');
  await page.click(`[data-course="${name}"] .identify-drive`);
  await until(() => page.isVisible('#identify-start'), 'the question');
}

/** Drives a course until it is completed: a busy machine may stop the robot on its way. */
async function driveCourse(page: Page, name: string): Promise<void> {
  const course = `[data-course="${name}"]`;
  await until(
    async () => {
      // Read at once: the button is enabled again when the list shows the drive, and would be pressed for another one.
      const { driven, enabled } = await page.locator(course).evaluate((item) => ({
        driven: item.dataset.driven !== '0',
        enabled: item.querySelector<HTMLButtonElement>('.identify-drive')?.disabled === false,
      }));
      if (driven) return true;
      if (await page.isVisible('#identify-start')) await page.click('#identify-start');
      // The second press is the consent to the motion.
      else if (await page.isVisible('#identify-drive-now')) await page.click('#identify-drive-now');
      else if (enabled) await page.click(`${course} .identify-drive`);
      return false;
    },
    `${name} is driven`,
    () => page.textContent('.identify-message'),
  );
}

async function write(page: Page, name: string, what: string, value: string): Promise<void> {
  const input = `[data-course="${name}"] input[name="${what}"]`;
  await until(() => page.isEnabled(input), 'it may be written');
  await page.fill(input, value);
  await page.press(input, 'Tab');
}

describe('the identification', () => {
  const setting = new Setting({ records: true });
  beforeAll(async () => {
    const courses = join(setting.pair.folder, 'library', 'courses');
    await mkdir(courses, { recursive: true });
    await writeFile(join(courses, 'ahead.toml'), course('type = "line"\nlength_m = 0.3'));
    await writeFile(join(courses, 'left.toml'), course('type = "pivot"\nangle_deg = 90.0'));
  });

  it('goes from the drives to a new robot file in use', async () => {
    const page = await setting.openTab('identify', kPhone);
    await rest(page);
    const bus = new Bus(setting.pair.url, ['/state']);
    await until(() => page.isVisible('[data-course="ahead"]'), 'the courses');
    expect(await page.isDisabled('#identify-evaluate')).toBe(true);

    // Nothing moves before it is confirmed.
    await askToDrive(page, 'ahead');
    expect(await page.textContent('.identify-question')).toContain('0.6 m ahead');
    expect(await run(page)).not.toBe('running');
    await page.click('#identify-cancel');
    await message(page, /Nothing was driven/);

    // Nor when the person has gone, or somebody has pressed STOP.
    const gone = [
      { leave: () => page.evaluate(() => window.dispatchEvent(new Event('blur'))), why: /The page was left/ },
      { leave: () => page.keyboard.press('Escape'), why: /STOP was pressed/ },
    ];
    for (const { leave, why } of gone) {
      await askToDrive(page, 'ahead');
      await page.click('#identify-start');
      await until(() => page.isVisible('#identify-drive-now'), 'it stands still', () => page.textContent('.identify-message'));
      await leave();
      await message(page, why);
      expect(await page.isVisible('#identify-drive-now')).toBe(false);
      expect(['arming', 'running']).not.toContain(await run(page));
    }

    await driveCourse(page, 'ahead');
    await driveCourse(page, 'left');
    // Less than the robot's file says. A measurement is also kept while a question is open.
    await askToDrive(page, 'ahead');
    await write(page, 'ahead', 'distance_m', '0.28');
    await page.click('#identify-cancel');
    await write(page, 'ahead', 'turned_deg', '0');
    await until(async () => (await page.textContent('#identify-evaluate')) === 'Evaluate 2 drives' && (await page.isEnabled('#identify-evaluate')), 'two drives');
    // Pressed at once, it evaluates what has just been typed.
    await write(page, 'left', 'turned_deg', '90');
    await page.click('#identify-evaluate');
    await message(page, /2 drives are evaluated/);
    const kept = page.locator('[data-course="left"] input[name="turned_deg"], [data-course="ahead"] input[name="distance_m"]');
    await until(async () => (await kept.evaluateAll((all) => all.map((each) => (each as HTMLInputElement).value))).join() === '0.28,90', 'the measurements');
    expect(Number(await page.textContent('.identify-found [data-name="slip_left"] ins'))).toBeGreaterThan(0.17);
    expect(Number(await page.textContent('.identify-found [data-name="slip_left"] del'))).toBeCloseTo(0.16, 2);
    expect(await page.getAttribute('.identify-found [data-name="x_icr_m"]', 'data-found')).toBe('false');
    const [before, after] = await page.locator('.identify-errors').evaluateAll((all) => all.map((each) => Number(/hand: ([\d.]+) cm/.exec(each.textContent)?.[1])));
    expect(after).toBeLessThan((before ?? NaN) / 2);
    expect(await findings(page, '#page-identify')).toEqual([]);
    await fits(page, '#page-identify');

    // One of the drives was straight up a board.
    await write(page, 'ahead', 'slope_deg', '10');
    await page.click('#identify-evaluate');
    await shows(page, '.identify-slope', /^A slope of 10.0° adds 0\.\d+ to/);

    await page.fill('#identify-name', 'end-loaded');
    expect(await page.isDisabled('#identify-save')).toBe(true);
    await page.fill('#identify-name', 'mine');
    await until(() => page.isEnabled('#identify-save'), 'it may be saved');
    await page.click('#identify-save');
    await message(page, /mine.toml is saved/);
    expect(await readFile(join(setting.pair.folder, 'library', 'robots', 'mine.toml'), 'utf8')).toContain('From identify on');
    await page.click('#identify-use');
    await message(page, /mine is in use until tp100d ends/);
    await until(() => bus.last('/state')?.robot === 'mine', 'the daemon uses it');
    const configured = (): Promise<string> => readFile(join(setting.pair.folder, 'tp100.toml'), 'utf8');
    expect(await configured()).not.toContain('robot = "mine"');
    await page.click('#identify-always');
    await message(page, /mine is in use, and from tp100.toml at every start/);
    expect(await configured()).toContain('robot = "mine"');
    bus.close();
  });
});

describe('a daemon that does not record', () => {
  const setting = new Setting();

  it('says what the drives need', async () => {
    const page = await setting.openTab('identify');
    await rest(page);
    await shows(page, '.identify-why', '--record DIR');
    for (const button of await page.locator('.identify-drive').all()) expect(await button.isDisabled()).toBe(true);
  });
});
