// Courses on the page: chosen, uploaded, drawn, driven and deleted, and where the robot is placed.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { drawn, driveUntil, fits, kDesktop, picture, rest, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ records: true });

const kCourse = [
  'description = "a bend of mine"',
  'speed_mps = 0.18',
  '[[segment]]',
  'type = "line"',
  'length_m = 0.2',
  '[[segment]]',
  'type = "arc"',
  'radius_m = 0.3',
  'angle_deg = 90.0',
  '[[block]]',
  'x_m = -0.5',
  'y_m = 0.4',
  'height_m = 0.03',
  'depth_m = 0.1',
  'width_m = 0.3',
  '[fence]',
  'min_x_m = -1.0',
  'max_x_m = 1.0',
  'min_y_m = -1.0',
  'max_y_m = 1.0',
  '',
].join('\n');

interface Place {
  x: number;
  y: number;
}

const message = (page: Page): Promise<string> => page.textContent('.courses-message').then((text) => text ?? '');
const verdict = (page: Page): Promise<string> => page.textContent('.draw-verdict').then((text) => text ?? '');
const judged = (page: Page, part: string): Promise<boolean> => until(async () => (await verdict(page)).includes(part), part, () => verdict(page));
const fileText = (page: Page): Promise<string> => page.inputValue('.draw textarea');
const saved = (name: string): Promise<string> => readFile(join(setting.pair.folder, 'library', 'courses', `${name}.toml`), 'utf8');

/** The list of courses, with the robot at rest. */
async function openCourses(size?: Size): Promise<Page> {
  const page = await setting.openTab('courses', size);
  await page.waitForSelector('#course-1-curve');
  await rest(page);
  await until(async () => (await page.textContent('.courses-why')) === '', 'a change is possible');
  return page;
}

/** A file that the user picks. */
async function upload(page: Page, name: string, text: string): Promise<void> {
  const folder = join(setting.pair.folder, 'files');
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, name), text);
  await page.setInputFiles('.courses input[type=file]', join(folder, name));
}

/** The colour of the robot's body on the map. */
const kBody = '201,209,218';

/** The colour of the map at a point of the page. */
async function colour(page: Page, at: Place): Promise<string> {
  return page.evaluate(({ x, y }) => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
    const box = canvas?.getBoundingClientRect();
    if (canvas === null || box === undefined) return '';
    const scale = canvas.width / box.width;
    const data = canvas.getContext('2d')?.getImageData(scale * (x - box.left), scale * (y - box.top), 1, 1).data;
    return [...(data ?? [])].slice(0, 3).join();
  }, at);
}

async function drag(page: Page, from: Place, to: Place): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
}

/** The middle of a point of the drawing, once the drawing is framed and no longer moves. */
async function middle(page: Page, handle: string): Promise<Place> {
  let last: Place | undefined;
  return until(async () => {
    await page.waitForTimeout(200);
    const box = await page.locator(`[data-handle="${handle}"] .knob-dot`).boundingBox();
    const now = box === null ? undefined : { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    const rests = now !== undefined && now.x === last?.x && now.y === last.y;
    last = now;
    return rests && now;
  }, `point ${handle} rests`);
}

async function dragPoint(page: Page, handle: string, dx: number): Promise<void> {
  const at = await middle(page, handle);
  await drag(page, at, { x: at.x + dx, y: at.y });
}

describe('the courses', () => {
  it('are chosen, uploaded, replaced and deleted while the daemon and the page stay', async () => {
    const page = await setting.openTab('courses');
    await driveUntil(page, 'running');
    await until(async () => (await page.textContent('.courses-why'))?.includes('A run is under way'), 'the reason');
    for (const button of await page.$$('.card-choose')) expect(await button.isDisabled()).toBe(true);
    expect(await page.isDisabled('#choose-robot')).toBe(true);
    await rest(page);
    await until(async () => (await page.textContent('.courses-why')) === '', 'a change is possible');
    expect(await page.getAttribute('#course-3', 'aria-current')).toBe('true');
    // The outline of a card must be drawn, not only be there.
    const outlines = await page.$$eval('.card-outline polyline', (lines) => lines.map((line) => (line as SVGPolylineElement).getTotalLength()));
    expect(Math.max(...outlines)).toBeGreaterThan(3);
    expect(await page.textContent('#course-3 .card-facts')).toMatch(/^4\.06 m \u00b7 \d+ s \u00b7 1 ramp \u00b7 1 block$/);

    const bus = new Bus(setting.pair.url, ['/state', '/course']);
    const state = (): unknown => bus.last('/state');
    await page.click('#course-1-curve .card-choose');
    await until(() => bus.last('/state')?.course === '1-curve', 'the course is in force', state);
    await until(() => bus.last('/course')?.name === '1-curve', 'it is published');
    await until(async () => (await page.getAttribute('#course-1-curve', 'aria-current')) === 'true', 'its card says so');
    expect(await page.textContent('.timeline-name')).toContain('1-curve');
    expect(bus.last('/state')?.session).toBe('ready');
    expect(setting.pair.daemon.lines.filter((line) => line.includes('closed -> listening'))).toHaveLength(1);

    await upload(page, 'my bend.toml', kCourse.replace('radius_m', 'radius'));
    await until(async () => (await message(page)).includes('my-bend.toml:'), 'an error with its place');
    expect(await message(page)).toMatch(/^my-bend\.toml:\d+:\d+: .*radius/);
    const visible = await page.$eval('.courses-message', (each) => {
      const { left, top } = each.getBoundingClientRect();
      return document.elementFromPoint(left + 4, top + 10) === each;
    });
    expect(visible, 'however far the list is scrolled').toBe(true);
    await upload(page, 'my bend.toml', kCourse);
    await until(async () => (await message(page)) === 'my-bend is saved.', 'it is saved');
    await page.waitForSelector('#course-my-bend');
    expect(await saved('my-bend')).toBe(kCourse);
    await upload(page, 'my bend.toml', kCourse.replace('a bend of mine', 'another bend'));
    await page.click('#upload-replace');
    await until(async () => (await page.textContent('#course-my-bend .card-about')) === 'another bend', 'it is replaced');
    await upload(page, '3.toml', kCourse);
    await until(async () => (await message(page)).includes('not one of your own files'), 'no other file is replaced');
    const dropped = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], 'dropped.toml'));
      return transfer;
    }, kCourse);
    await until(() => page.isEnabled('#upload'), 'a file may be dropped');
    await page.dispatchEvent('.courses', 'drop', { dataTransfer: dropped });
    await page.waitForSelector('#course-dropped');
    await fits(page, '.courses', 'courses');

    await page.click('#course-my-bend .card-choose');
    await until(() => bus.last('/state')?.course === 'my-bend', 'my course is in force');
    for (const [what, name] of [['robot', 'worn'], ['setup', 'stand'], ['robot', 'end-loaded'], ['setup', 'flat']] as const) {
      await page.selectOption(`#choose-${what}`, name);
      await until(() => bus.last('/state')?.[what] === name && bus.last('/state')?.session === 'ready', `${what} ${name}`, state);
    }
    expect(await page.isDisabled('#course-my-bend .card-delete')).toBe(true);
    await page.click('#course-2 .card-choose');
    await until(() => bus.last('/state')?.course === '2', 'another course');
    await until(() => page.isEnabled('#course-my-bend .card-delete'), 'mine can be deleted');
    await page.click('#course-my-bend .card-delete');
    await page.click('#course-my-bend .card-delete');
    await page.waitForSelector('#course-my-bend', { state: 'detached' });
    expect(setting.pair.daemon.lines.some((line) => line.includes('error') && !line.includes('stop_requested'))).toBe(false);
    bus.close();
  });

  it('place the robot at the start, and where it is drawn on the map', async () => {
    setting.expected = /willReadFrequently/;
    const page = await openCourses();
    await page.click('#place-map');
    expect(await page.getAttribute('#place-map', 'aria-pressed')).toBe('true');
    const box = await page.locator('.placing').boundingBox();
    if (box === null) throw new Error('no map to draw on');
    const at = { x: box.x + 0.6 * box.width, y: box.y + 0.6 * box.height };
    expect(await colour(page, at)).not.toBe(kBody);
    await drag(page, at, { x: at.x, y: at.y - 60 });
    await until(async () => Math.abs(((await drawn(page))?.[3] ?? 0) - Math.PI / 2) < 0.02, 'it points up, where it was dragged to');
    expect(await page.isVisible('.placing')).toBe(false);
    await until(async () => (await colour(page, at)) === kBody, 'the robot is drawn where it was pressed');
    await until(() => page.isEnabled('#place-start'), 'the next change is possible');
    await page.click('#place-start');
    await until(async () => Math.hypot(...((await drawn(page)) ?? [9]).slice(0, 2)) < 0.005, 'it is at the start');
  });
});

describe('a course of one’s own', () => {
  it('is drawn with points, checked by the daemon, saved, chosen, driven and reported', async () => {
    const page = await openCourses();
    await page.click('#draw-new');
    await page.waitForSelector('[data-handle="segment-0"]');
    await until(async () => /^0\.60 m, about \d+ s$/.test(await verdict(page)), 'its length and time', () => verdict(page));
    await dragPoint(page, 'segment-0', -20);
    await page.click('#draw-arc');
    const end = await middle(page, 'segment-0');
    await page.mouse.click(end.x + 60, end.y - 60);
    await page.waitForSelector('[data-handle="segment-1"]');
    await judged(page, 'm, about');
    await picture(page, 'draw-arc');
    const text = await fileText(page);
    expect(text).toMatch(/type = "arc"\nradius_m = 0\.\d+\nangle_deg = \d+/);
    const length = Number(/length_m = ([\d.]+)/.exec(text)?.[1]);
    expect(length).toBeLessThan(0.59);
    expect(length).toBeGreaterThan(0.1);

    await page.fill('.draw input[name=course-name]', 'my-arc');
    await page.fill('.draw input[name=speed_mps]', '0.2');
    await page.press('.draw input[name=speed_mps]', 'Tab');
    await page.click('#draw-use');
    await until(async () => (await page.textContent('.timeline-name'))?.includes('my-arc'), 'it is in force', () => verdict(page));
    expect(await page.isVisible('.draw-stage')).toBe(false);
    expect(await saved('my-arc')).toContain('speed_mps = 0.2\n');
    await driveUntil(page, 'finished');
    // The newest of that name: a busy machine may have stopped one before.
    await page.click('#tab-runs');
    const make = page.locator('.runs tr[data-run*="-my-arc"] .run-make').first();
    await until(async () => (await make.count()) === 1 && (await make.isEnabled()), 'its run is recorded');
    const [report] = await Promise.all([page.context().waitForEvent('page', { timeout: 120_000 }), make.click()]);
    await until(() => report.isVisible('h1'), 'its report');
  });

  it('keeps the comments of an opened file, and its errors are named with their line', async () => {
    const page = await openCourses();
    await page.click('#course-3 .card-edit');
    await page.waitForSelector('[data-handle="ramp-0"]');
    const before = await fileText(page);
    await dragPoint(page, 'ramp-0', 30);
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
    await judged(page, 'radius');
    expect(await verdict(page)).toMatch(/^line \d+, column \d+: .*radius/);
    await page.fill('.draw textarea', after);
    // Out of the fence.
    await dragPoint(page, 'segment-0', 300);
    await judged(page, 'leaves the fence');
  });

  it('is drawn with the keyboard alone', async () => {
    const page = await openCourses();
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
    await page.focus('#draw-undo');
    await page.keyboard.press('Control+z');
    await page.waitForSelector('[data-handle="block-0"]');
    expect(await run(page), 'no key has moved the robot').not.toBe('running');
  });

  it('has a fence with corners and areas to keep out of, which the check knows', async () => {
    const page = await openCourses();
    await page.click('#draw-new');
    await page.focus('[data-handle="fence-0-1"]');
    await page.click('#draw-corner');
    await page.waitForSelector('[data-handle="fence-0-4"]');
    expect(await fileText(page)).toMatch(/\[fence\]\ncorners_m = \[\[-0\.3, -0\.8\], \[1\.6, -0\.8\], \[1\.6, 0\.0\], \[1\.6, 0\.8\], \[-0\.3, 0\.8\]\]\n/);
    await page.click('#draw-keep_out');
    const on = await middle(page, 'segment-0');
    await page.mouse.click(on.x - 30, on.y);
    await page.waitForSelector('[data-handle="keep_out-0-3"]');
    await judged(page, 'leaves the fence');
    await page.click('#draw-delete');
    await page.click('#draw-undo');
    await page.click('#draw-undo');
    await judged(page, 'm, about');
  });

  it('is drawn on every screen, with a finger too', async () => {
    const page = await openCourses(kDesktop);
    await page.click('#course-3 .card-edit');
    await page.waitForSelector('[data-handle="ramp-0"]');
    await fits(page, '.draw', 'draw', async () => {
      await page.locator('.draw-stage').scrollIntoViewIfNeeded();
      const touched = await page.evaluate(() => {
        const box = document.querySelector('[data-handle="block-0"] .knob-dot')?.getBoundingClientRect();
        if (box === undefined) return false;
        const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
        return document.elementFromPoint(x + 12, y)?.closest('.knob') !== null;
      });
      expect(touched, 'a finger meets a point').toBe(true);
    });
  });
});
