import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { alive, driveUntil, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();

const pressed = async (page: Page, id: string): Promise<boolean> => (await page.getAttribute(`#${id}`, 'aria-pressed')) === 'true';

/** Presses the tab key until `id` has the focus. */
async function tabTo(page: Page, id: string): Promise<void> {
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    if ((await page.evaluate(() => document.activeElement?.id)) === id) return;
  }
  throw new Error(`tab never reaches ${id}`);
}

describe('without a mouse', () => {
  it('has a name for everything that can be pressed, and all of it can be reached by keyboard', async () => {
    const page = await setting.open();
    await alive(page);
    const nameless = await page.evaluate(() =>
      [...document.querySelectorAll('button, input, select, [tabindex]')]
        .filter((element) => {
          const labels = element instanceof HTMLInputElement ? [...(element.labels ?? [])] : [];
          const names = [element.getAttribute('aria-label'), element.getAttribute('aria-labelledby'), ...[element, ...labels].map(({ textContent }) => textContent)];
          return names.join('').trim() === '';
        })
        .map((element) => element.outerHTML.slice(0, 80)),
    );
    expect(nameless).toEqual([]);
    const reached = new Set<string>();
    for (let i = 0; i < 40; i++) {
      await page.keyboard.press('Tab');
      reached.add(await page.evaluate(() => document.activeElement?.id ?? ''));
    }
    for (const id of ['stop', 'camera-chase', 'camera-map', 'show-model', 'tab-events']) expect(reached).toContain(id);
  });

  it('starts, looks around, sets a parameter, holds and stops, on a screen 360 px wide', async () => {
    const page = await setting.open({ width: 360, height: 640 });
    const bus = new Bus(setting.pair.url, ['/parameter']);
    await alive(page);

    for (const [key, camera] of [['1', 'chase'], ['2', 'top'], ['4', 'map'], ['3', 'free'], ['c', 'map'], ['c', 'chase']] as const) {
      await page.keyboard.press(key);
      expect(await pressed(page, `camera-${camera}`), `${key} is ${camera}`).toBe(true);
    }
    await tabTo(page, 'show-model');
    expect(await pressed(page, 'show-model')).toBe(true);
    await page.keyboard.press('Enter');
    expect(await pressed(page, 'show-model')).toBe(false);

    // Tabs are one stop of the tab key; the arrow keys change between them.
    await tabTo(page, 'tab-events');
    for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowRight');
    expect(await page.getAttribute('#tab-parameters', 'aria-selected')).toBe('true');
    expect(await page.isVisible('#page-parameters')).toBe(true);
    const name = 'control.cross_track_gain_1ps';
    const gain = (): unknown => bus.last('/parameter')?.parameters.find((parameter) => parameter.name === name)?.value;
    await until(() => gain() === 3.6, 'the default');
    await page.focus(`input[aria-label="${name}"]`);
    await page.keyboard.press('Control+a');
    await page.keyboard.type('4.5');
    await page.keyboard.press('Enter');
    await until(() => gain() === 4.5, 'the daemon has it');
    bus.close();

    await driveUntil(page, 'running');
    await page.keyboard.press('h');
    await until(async () => (await run(page)) === 'idle', 'it holds');
    await until(() => page.isEnabled('#start'), 'it may start again');
    // After a run that ended before the end of its course, a start asks where the robot stands, also by key.
    await page.keyboard.press('r');
    // A question that was closed keeps its text: this one is open when it has the focus.
    await page.waitForFunction(
      () => document.activeElement?.id === 'start-cancel' && document.querySelector('#question-text')?.textContent.includes('along the course') === true,
    );
    // A sample that comes late disables it for a moment.
    await until(() => page.isEnabled('#start-placed'), 'it may start from there');
    await page.keyboard.press('Tab');
    expect(await page.evaluate(() => document.activeElement?.id)).toBe('start-placed');
    await page.keyboard.press('Enter');
    await until(async () => ['arming', 'running'].includes(await run(page)), 'it starts');
    await page.keyboard.press('Escape');
    await until(async () => (await page.textContent('.stop-line'))?.startsWith('robot stopped') === true, 'it stops');
    await until(async () => !['arming', 'running'].includes(await run(page)), 'the run is over');
  });
});
