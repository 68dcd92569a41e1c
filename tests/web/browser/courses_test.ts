// Courses on the page: chosen, uploaded, drawn and deleted, and where the robot is placed.
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { colour, drag, drawn, driveUntil, fits, rest, run, shows, until, type Place } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting();

const kCourse = `description = "a bend of mine"
speed_mps = 0.18
[[segment]]
type = "arc"
radius_m = 0.3
angle_deg = 90.0
[fence]
min_x_m = -1.0
max_x_m = 1.0
min_y_m = -1.0
max_y_m = 1.0
`;

const fileText = (page: Page): Promise<string> => page.inputValue('.draw textarea');
const saved = (name: string): Promise<string> => readFile(join(setting.pair.folder, 'library', 'courses', `${name}.toml`), 'utf8');

/** The list of courses, with the robot at rest. */
async function openCourses(): Promise<Page> {
  const page = await setting.openTab('courses');
  await page.waitForSelector('#course-1-curve');
  await rest(page);
  await shows(page, '.courses-why', /^$/);
  return page;
}

/** Opens a course in the editor. */
async function edit(page: Page, button: string, handle: string): Promise<void> {
  await page.click(button);
  await page.waitForSelector(`[data-handle="${handle}"]`);
}

/** A file that the user picks. */
async function upload(page: Page, name: string, text: string): Promise<void> {
  const folder = join(setting.pair.folder, 'files');
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, name), text);
  await page.setInputFiles('.courses input[type=file]', join(folder, name));
}

/** The colour of the robot's body on the map. */
const kBody = [201, 209, 218];

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
    await shows(page, '.courses-why', 'A run is under way');
    for (const button of await page.$$('.card-choose, #choose-robot')) expect(await button.isDisabled()).toBe(true);
    await rest(page);
    await shows(page, '.courses-why', /^$/);
    expect(await page.getAttribute('#course-3', 'aria-current')).toBe('true');
    expect(await page.textContent('#course-3 .card-facts')).toMatch(/^4\.06 m \u00b7 \d+ s \u00b7 1 ramp \u00b7 1 block$/);
    const bus = new Bus(setting.pair.url, ['/state', '/course']);
    const inForce = (what: 'course' | 'robot' | 'setup', name: string): Promise<boolean> =>
      until(() => bus.last('/state')?.[what] === name && bus.last('/state')?.session === 'ready', `${what} ${name}`, () => bus.last('/state'));
    await page.click('#course-1-curve .card-choose');
    await inForce('course', '1-curve');
    await until(() => bus.last('/course')?.name === '1-curve', 'it is published');
    await until(async () => (await page.getAttribute('#course-1-curve', 'aria-current')) === 'true', 'its card says so');
    await shows(page, '.timeline-name', '1-curve');

    await upload(page, 'my bend.toml', kCourse.replace('radius_m', 'radius'));
    await shows(page, '.courses-message', /^my-bend\.toml:\d+:\d+: .*radius/);
    await upload(page, 'my bend.toml', kCourse);
    await shows(page, '.courses-message', 'my-bend is saved.');
    await page.waitForSelector('#course-my-bend');
    expect(await saved('my-bend')).toBe(kCourse);
    await upload(page, 'my bend.toml', kCourse.replace('a bend of mine', 'another bend'));
    await page.click('#upload-replace');
    await shows(page, '#course-my-bend .card-about', 'another bend');
    await upload(page, '3.toml', kCourse);
    await shows(page, '.courses-message', 'not one of your own files');
    await fits(page, '.courses');

    await page.click('#course-my-bend .card-choose');
    await inForce('course', 'my-bend');
    for (const [what, name] of [['robot', 'worn'], ['setup', 'stand'], ['setup', 'flat']] as const) {
      await page.selectOption(`#choose-${what}`, name);
      await inForce(what, name);
    }
    expect(await page.isDisabled('#course-my-bend .card-delete')).toBe(true);
    await page.click('#course-2 .card-choose');
    await inForce('course', '2');
    await until(() => page.isEnabled('#course-my-bend .card-delete'), 'mine can be deleted');
    await page.click('#course-my-bend .card-delete');
    await page.click('#course-my-bend .card-delete');
    await page.waitForSelector('#course-my-bend', { state: 'detached' });
    expect(setting.pair.daemon.lines.filter((line) => line.includes('closed -> listening')), 'the link stayed').toHaveLength(1);
    bus.close();
  });

  it('place the robot at the start, and where it is drawn on the map', async () => {
    const page = await openCourses();
    await page.click('#place-map');
    const box = await page.locator('.placing').boundingBox();
    if (box === null) throw new Error('no map to draw on');
    const at = { x: box.x + 0.6 * box.width, y: box.y + 0.6 * box.height };
    expect(await colour(page, at)).not.toEqual(kBody);
    await drag(page, at, { x: at.x, y: at.y - 60 });
    await until(async () => Math.abs(((await drawn(page))?.[3] ?? 0) - Math.PI / 2) < 0.02, 'it points up, where it was dragged to');
    await until(async () => (await colour(page, at)).join() === kBody.join(), 'the robot is drawn where it was pressed');
    await until(() => page.isEnabled('#place-start'), 'the next change is possible');
    await page.click('#place-start');
    await until(async () => Math.hypot(...((await drawn(page)) ?? [9]).slice(0, 2)) < 0.005, 'it is at the start');
  });
});

describe('a course of one’s own', () => {
  it('is drawn with points, checked by the daemon, saved and put in force', async () => {
    const page = await openCourses();
    await edit(page, '#draw-new', 'segment-0');
    await shows(page, '.draw-verdict', /^0\.60 m, about \d+ s$/);
    await dragPoint(page, 'segment-0', -20);
    await page.click('#draw-arc');
    const end = await middle(page, 'segment-0');
    await page.mouse.click(end.x + 60, end.y - 60);
    await page.waitForSelector('[data-handle="segment-1"]');
    await shows(page, '.draw-verdict', 'm, about');
    const text = await fileText(page);
    expect(text).toMatch(/type = "arc"\nradius_m = 0\.\d+\nangle_deg = \d+/);
    const length = Number(/length_m = ([\d.]+)/.exec(text)?.[1]);
    expect(length).toBeLessThan(0.59);
    expect(length).toBeGreaterThan(0.1);

    await page.fill('.draw input[name=course-name]', 'my-arc');
    await page.fill('.draw input[name=speed_mps]', '0.2');
    await page.press('.draw input[name=speed_mps]', 'Tab');
    await page.click('#draw-use');
    await shows(page, '.timeline-name', 'my-arc');
    expect(await page.isVisible('.draw-stage')).toBe(false);
    expect(await saved('my-arc')).toContain('speed_mps = 0.2\n');
  });

  it('keeps the comments of an opened file, and its errors are named with their line', async () => {
    const page = await openCourses();
    await edit(page, '#course-3 .card-edit', 'ramp-0');
    const before = await fileText(page);
    await dragPoint(page, 'ramp-0', 30);
    const after = await fileText(page);
    const changed = after.split('\n').filter((line, i) => line !== before.split('\n')[i]);
    expect(changed).toHaveLength(1);
    expect(changed[0]).toMatch(/^x_m = [\d.]+ +# the paper's$/);
    await page.click('#draw-undo');
    expect(await fileText(page)).toBe(before);
    await page.click('#draw-redo');
    expect(await fileText(page)).toBe(after);

    await page.click('.draw summary');
    await page.fill('.draw textarea', after.replace('radius_m = 0.4', 'radius = 0.4'));
    await shows(page, '.draw-verdict', /^line \d+, column \d+: .*radius/);
    await page.fill('.draw textarea', after);
    await dragPoint(page, 'segment-0', 300);
    await shows(page, '.draw-verdict', 'leaves the fence');
    await fits(page, '.draw');
  });

  it('is drawn with the keyboard alone, and so are the corners of its fence', async () => {
    const page = await openCourses();
    const press = async (element: string, ...keys: string[]): Promise<void> => {
      await page.focus(element);
      for (const key of keys) await page.keyboard.press(key);
    };
    await press('#draw-new', 'Enter');
    await press('[data-handle="segment-0"]', 'Shift+ArrowRight', 'ArrowRight');
    expect(await fileText(page)).toContain('length_m = 0.71\n');
    await until(async () => (await page.inputValue('.draw input[name=length_m]')) === '0.71', 'the field follows');
    await press('#draw-block', 'Enter');
    await page.waitForSelector('[data-handle="block-0"]');
    expect(await fileText(page)).toMatch(/\[\[block\]\]\nx_m = 1\.01\n/);
    await press('[data-handle="block-0"]', 'Delete');
    await page.waitForSelector('[data-handle="block-0"]', { state: 'detached' });
    await press('#draw-undo', 'Control+z');
    await page.waitForSelector('[data-handle="block-0"]');
    await page.focus('[data-handle="fence-0-1"]');
    await page.click('#draw-corner');
    await page.waitForSelector('[data-handle="fence-0-4"]');
    expect(await fileText(page)).toMatch(/\[fence\]\ncorners_m = \[\[-0\.3, -0\.8\], \[1\.6, -0\.8\], \[1\.6, 0\.0\], \[1\.6, 0\.8\], \[-0\.3, 0\.8\]\]\n/);
    await press('[data-handle="fence-0-4"]', 'Delete');
    await page.waitForSelector('[data-handle="fence-0-4"]', { state: 'detached' });
    expect(await run(page), 'no key has moved the robot').not.toBe('running');
  });
});
