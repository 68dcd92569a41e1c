import { mkdtempSync, rmSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, it } from 'vitest';
import { alive, goOn, picture, run, until, type Size } from './cockpit.ts';
import { Bus } from './bus.ts';
import { Setting } from './setting.ts';

const recordings = mkdtempSync(join(tmpdir(), 'tp100-draw-'));
afterAll(() => {
  rmSync(recordings, { recursive: true, force: true });
});
const setting = new Setting({ each: true, options: ['--record', recordings] });

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

const verdict = (page: Page): Promise<string> => page.textContent('.draw-verdict').then((text) => text ?? '');

async function openCourses(size?: Size): Promise<Page> {
  const page = await setting.open(size);
  await alive(page);
  await page.click('#tab-courses');
  await page.waitForSelector('#course-1-curve');
  return page;
}

/** Ends a run that has begun by itself. */
async function stopped(page: Page): Promise<void> {
  // A busy machine may have ended it already.
  await until(async () => ['running', 'aborted', 'finished'].includes(await run(page)), 'the run has begun by itself');
  await page.click('#stop');
  await until(async () => (await page.textContent('.courses-why')) === '', 'a change is possible');
}

async function middle(page: Page, handle: string): Promise<{ x: number; y: number }> {
  const box = await page.locator(`[data-handle="${handle}"] .knob-dot`).boundingBox();
  if (box === null) throw new Error(`no point ${handle}`);
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

async function drag(page: Page, handle: string, dx: number, dy: number): Promise<void> {
  const at = await middle(page, handle);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + dx, at.y + dy, { steps: 5 });
  await page.mouse.up();
}

async function fileText(page: Page): Promise<string> {
  return page.inputValue('.draw textarea');
}

const saved = (name: string): Promise<string> => readFile(join(setting.pair.folder, 'library', 'courses', `${name}.toml`), 'utf8');

describe('a course', () => {
  it('is drawn with points, checked by the daemon, saved, chosen, driven and reported', async () => {
    const page = await openCourses();
    await stopped(page);
    const began_ms = performance.now();
    await page.click('#draw-new');
    await page.waitForSelector('[data-handle="segment-0"]');
    await until(async () => /^0\.60 m, about \d+ s$/.test(await verdict(page)), 'its length and time', () => verdict(page));

    await drag(page, 'segment-0', -20, 0);
    await page.click('#draw-arc');
    const end = await middle(page, 'segment-0');
    await page.mouse.click(end.x + 60, end.y - 60);
    await page.waitForSelector('[data-handle="segment-1"]');
    await until(async () => /m, about \d+ s$/.test(await verdict(page)), 'it is right', () => verdict(page));
    await picture(page, 'draw-arc');
    const text = await fileText(page);
    expect(text).toMatch(/type = "arc"\nradius_m = 0\.\d+\nangle_deg = \d+/);
    const length = Number(/length_m = ([\d.]+)/.exec(text)?.[1]);
    expect(length).toBeLessThan(0.59);
    expect(length).toBeGreaterThan(0.1);

    await page.fill('.draw input[name=course-name]', 'my-bend');
    await page.fill('.draw input[name=speed_mps]', '0.2');
    await page.press('.draw input[name=speed_mps]', 'Tab');
    await page.click('#draw-use');
    const bus = new Bus(setting.pair.url, ['/state']);
    try {
      await until(() => bus.last('/state')?.course === 'my-bend', 'it is in force', () => verdict(page));
      expect(await page.isVisible('.draw-stage')).toBe(false);
      expect(await saved('my-bend')).toContain('speed_mps = 0.2\n');
      await until(
        async () => {
          if ((await run(page)) === 'finished') return true;
          await goOn(page);
          return false;
        },
        'it is driven to its end',
        () => page.textContent('#number-x'),
      );
      const driven_ms = performance.now();
      // The newest of that name: a busy machine may have stopped one before.
      await page.click('#tab-runs');
      const make = page.locator('.runs tr[data-run*="-my-bend"] .run-make').first();
      await until(async () => (await make.count()) === 1 && (await make.isEnabled()), 'its run is recorded');
      const [report] = await Promise.all([page.context().waitForEvent('page', { timeout: 120_000 }), make.click()]);
      await until(() => report.isVisible('h1'), 'its report');
      const seconds = (since_ms: number): string => ((performance.now() - since_ms) / 1000).toFixed(1);
      console.log(`a course of one's own is drawn, driven and its report open after ${seconds(began_ms)} s, ${seconds(driven_ms)} s of them for the report`);
    } finally {
      bus.close();
    }
  });

  it('keeps the comments of an opened file, and its errors are named with their line', async () => {
    const page = await openCourses();
    await stopped(page);
    await page.click('#course-3 .card-edit');
    await page.waitForSelector('[data-handle="ramp-0"]');
    const before = await fileText(page);
    await drag(page, 'ramp-0', 30, 0);
    const after = await fileText(page);
    const changed = before.split('\n').flatMap((line, i) => (line === after.split('\n')[i] ? [] : [`${line} -> ${after.split('\n')[i] ?? ''}`]));
    expect(changed).toHaveLength(1);
    expect(changed[0]).toMatch(/^x_m = 0\.7 +# the paper's -> x_m = [\d.]+ +# the paper's$/);
    await page.click('#draw-undo');
    expect(await fileText(page)).toBe(before);
    await page.click('#draw-redo');
    expect(await fileText(page)).toBe(after);

    await page.click('.draw summary');
    await page.fill('.draw textarea', after.replace('radius_m = 0.4', 'radius = 0.4'));
    await until(async () => (await verdict(page)).includes('radius'), 'the error', () => verdict(page));
    expect(await verdict(page)).toMatch(/^line \d+, column \d+: .*radius/);
    await picture(page, 'draw-error');
    await page.fill('.draw textarea', after);

    // Out of the fence.
    await drag(page, 'segment-0', 300, 0);
    await until(async () => (await verdict(page)).includes('leaves the fence'), 'the fence is checked', () => verdict(page));
  });

  it('is drawn with the keyboard alone', async () => {
    const page = await openCourses();
    await stopped(page);
    await page.focus('#draw-new');
    await page.keyboard.press('Enter');
    await page.focus('[data-handle="segment-0"]');
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowRight');
    expect(await fileText(page)).toContain('length_m = 0.71\n');
    await until(async () => (await page.inputValue('.draw input[name=length_m]')) === '0.71', 'the field follows');
    await page.focus('#draw-block');
    await page.keyboard.press('Enter');
    await page.waitForSelector('[data-handle="block-0"]');
    expect(await fileText(page)).toMatch(/\[\[block\]\]\nx_m = 1\.01\n/);
    await page.focus('[data-handle="block-0"]');
    await page.keyboard.press('Delete');
    await page.waitForSelector('[data-handle="block-0"]', { state: 'detached' });
    await page.keyboard.press('Control+z');
    await page.focus('#draw-undo');
    await page.keyboard.press('Control+z');
    await page.waitForSelector('[data-handle="block-0"]');
    expect(await run(page), 'no key has moved the robot').not.toBe('running');
  });

  it('has a fence with corners and areas to keep out of, which the check and the map know', async () => {
    const page = await openCourses();
    await stopped(page);
    await page.click('#draw-new');
    await page.focus('[data-handle="fence-0-1"]');
    await page.click('#draw-corner');
    await page.waitForSelector('[data-handle="fence-0-4"]');
    expect(await fileText(page)).toMatch(/\[fence\]\ncorners_m = \[\[-0\.3, -0\.8\], \[1\.6, -0\.8\], \[1\.6, 0\.0\], \[1\.6, 0\.8\], \[-0\.3, 0\.8\]\]\n/);
    await page.click('#draw-keep_out');
    const on = await middle(page, 'segment-0');
    await page.mouse.click(on.x - 30, on.y);
    await page.waitForSelector('[data-handle="keep_out-0-3"]');
    await until(async () => (await verdict(page)).includes('leaves the fence'), 'the path is in it', () => verdict(page));
    await picture(page, 'draw-keep-out');
    await page.click('#draw-delete');
    await page.click('#draw-undo');
    await page.click('#draw-undo');
    await until(async () => (await verdict(page)).includes('m, about'), 'without it the course is right', () => verdict(page));
  });

  it('is drawn on every screen, with a finger too', async () => {
    const page = await openCourses(kScreens[0]);
    await stopped(page);
    await page.click('#course-3 .card-edit');
    await page.waitForSelector('[data-handle="ramp-0"]');
    for (const size of kScreens) {
      await page.setViewportSize(size);
      await until(() => page.evaluate(([w]) => document.documentElement.clientWidth === w, [size.width]), 'the page has its size');
      const wide = await page.$$eval('.draw, .draw *', (all) =>
        all.filter((each) => each.scrollWidth > each.clientWidth + 1 && getComputedStyle(each).overflowX === 'visible' && each.clientWidth > 0).map((each) => each.outerHTML.slice(0, 80)),
      );
      expect(wide, String(size.width)).toEqual([]);
      await page.locator('.draw-stage').scrollIntoViewIfNeeded();
      const touched = await page.evaluate(() => {
        const knob = document.querySelector('[data-handle="block-0"]');
        const box = knob?.querySelector('.knob-dot')?.getBoundingClientRect();
        if (box === undefined) return false;
        const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
        return document.elementFromPoint(x + 12, y)?.closest('.knob') !== null;
      });
      expect(touched, `a finger meets a point at ${size.width}`).toBe(true);
      await picture(page, `draw-${size.width}`);
    }
  });
});
