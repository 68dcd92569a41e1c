import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, driveUntil, picture, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

const rows = (page: Page): Promise<number> => page.locator('.event:visible').count();

interface Told {
  told?: string[];
}

/** Stands in for the browser's notifications and speakers. */
async function listenTo(page: Page): Promise<void> {
  await page.evaluate(() => {
    const told: string[] = ((window as Told).told = []);
    class Said {
      static permission = 'granted';
      static requestPermission = (): Promise<string> => Promise.resolve('granted');
      readonly when_ms = performance.now();
      constructor(title: string) {
        told.push(title);
      }
    }
    Object.assign(window, { Notification: Said });
    const calls = AudioContext.prototype as unknown as Record<string, (...values: unknown[]) => unknown>;
    const real = calls.createOscillator;
    calls.createOscillator = function (this: AudioContext, ...values: unknown[]): unknown {
      told.push('tone');
      return real?.apply(this, values);
    };
  });
}

describe('events', () => {
  const setting = new Setting({ each: true });

  for (const size of kScreens) {
    it(`have the wall clock, and are filtered by level and words at ${size.width} x ${size.height}`, async () => {
      const page = await setting.open(size);
      await alive(page);
      await page.click('#tab-events');
      await page.keyboard.press('Escape');
      await until(async () => (await page.locator('.event[data-kind="stop"]').count()) > 0, 'STOP is an event');
      const time = (await page.locator('.event[data-kind="stop"] time').first().textContent()) ?? '';
      expect(time).toMatch(/^\d\d:\d\d:\d\d$/);
      const age_s = (Date.now() - new Date(`${new Date().toDateString()} ${time}`).getTime()) / 1000;
      expect(Math.abs(age_s), 'now, or around midnight').toSatisfy((s: number) => s < 100 || s > 86_300);
      const all = await rows(page);
      await page.selectOption('select[aria-label="Level of events"]', '1');
      await until(async () => (await rows(page)) < all, 'only warnings and errors');
      expect(await page.locator('.event[data-level="info"]:visible').count()).toBe(0);
      await page.fill('input[aria-label="Search events"]', 'stop viewer');
      await until(async () => (await rows(page)) > 0 && (await page.locator('.event:visible').allTextContents()).every((text) => text.includes('STOP')), 'what was searched');
      await picture(page, `events-${size.width}`);
      await page.fill('input[aria-label="Search events"]', 'zzz');
      await until(() => page.isVisible('text=No event matches.'), 'nothing is found');
    });
  }

  it('of faults are told by notification and sound, if that is chosen, also after a reload', async () => {
    const page = await setting.open();
    await alive(page);
    expect(await page.isChecked('#alert-notify')).toBe(false);
    expect(await page.isChecked('#alert-sound')).toBe(false);
    await page.check('#alert-sound');
    await page.reload();
    await alive(page);
    await until(() => page.isChecked('#alert-sound'), 'it is remembered');
    await listenTo(page);
    await page.check('#alert-notify');
    await driveUntil(page, 'running');
    await setting.pair.robot.end('SIGKILL');
    await until(() => page.evaluate(() => (window as Told).told?.some((text) => text.startsWith('TP100: ')) === true && (window as Told).told?.includes('tone') === true), 'it is told');
  });
});

describe('a run', () => {
  const setting = new Setting({ configuration: '[control]\nmin_battery_v = 7.95\n' });

  it('has a time that is left, and a battery that warns before it is too low', async () => {
    const page = await setting.open();
    await driveUntil(page, 'running');
    await until(async () => /^\d+:\d\d left$/.test((await page.textContent('.timeline-left')) ?? ''), 'the time left', () => page.textContent('.timeline-left'));
    await until(async () => (await page.locator('.number.low #number-battery').count()) === 1, 'its figure');
    await until(async () => ((await page.textContent('#notice-list')) ?? '').includes('The battery is low') || page.isVisible('#notice-more'), 'the notice, or a fault above it');
    await picture(page, 'battery');
  });
});
