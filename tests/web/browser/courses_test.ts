import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { alive, drawn, goOn, picture, run, until, type Size } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ each: true });

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

const kScreens: Size[] = [
  { width: 1440, height: 900 },
  { width: 768, height: 1024 },
  { width: 390, height: 844 },
];

const message = (page: Page): Promise<string> => page.textContent('.courses-message').then((text) => text ?? '');

/** The colour of the robot's body on the map. */
const kBody = '201,209,218';

/** The colour of the map at a point of the page. */
async function colour(page: Page, at: { x: number; y: number }): Promise<string> {
  return page.evaluate(({ x, y }) => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
    const box = canvas?.getBoundingClientRect();
    if (canvas === null || box === undefined) return '';
    const scale = canvas.width / box.width;
    const data = canvas.getContext('2d')?.getImageData(scale * (x - box.left), scale * (y - box.top), 1, 1).data;
    return [...(data ?? [])].slice(0, 3).join();
  }, at);
}

async function openCourses(size?: Size): Promise<Page> {
  const page = await setting.open(size);
  await alive(page);
  await page.click('#tab-courses');
  await page.waitForSelector('#course-1-curve');
  return page;
}

/** Ends a run that has begun by itself, and waits until the robot is at rest. */
async function stopped(page: Page): Promise<void> {
  // A busy machine may have ended it already.
  await until(async () => ['running', 'aborted'].includes(await run(page)), 'the run has begun by itself');
  await page.click('#stop');
  await until(async () => (await run(page)) === 'aborted', 'it is stopped');
  await until(async () => (await page.textContent('.courses-why')) === '', 'a change is possible');
}

/** A file that the user picks. */
async function upload(page: Page, name: string, text: string): Promise<void> {
  const folder = join(setting.pair.folder, 'files');
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, name), text);
  await page.setInputFiles('.courses input[type=file]', join(folder, name));
}

/** The outline of a card must be drawn, not only be there. */
async function outlines(page: Page): Promise<number[]> {
  return page.$$eval('.card-outline polyline', (lines) => lines.map((line) => (line as SVGPolylineElement).getTotalLength()));
}

describe('the courses', () => {
  it('are chosen, uploaded, driven and deleted while the daemon and the page stay', async () => {
    const page = await openCourses();
    await until(async () => (await page.textContent('.courses-why'))?.includes('A run is under way'), 'the reason');
    for (const button of await page.$$('.card-choose')) expect(await button.isDisabled()).toBe(true);
    expect(await page.isDisabled('#choose-robot')).toBe(true);
    await stopped(page);
    expect(await page.getAttribute('#course-3', 'aria-current')).toBe('true');
    expect(Math.min(...(await outlines(page)))).toBeGreaterThanOrEqual(0);
    expect(Math.max(...(await outlines(page)))).toBeGreaterThan(3);
    expect(await page.textContent('#course-3 .card-facts')).toMatch(/^4\.06 m \u00b7 \d+ s \u00b7 1 ramp \u00b7 1 block$/);

    const bus = new Bus(setting.pair.url, ['/state', '/course']);
    try {
      await page.click('#course-1-curve .card-choose');
      await until(() => bus.last('/state')?.course === '1-curve', 'the course is in force');
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
      await picture(page, 'courses-error');
      await upload(page, 'my bend.toml', kCourse);
      await until(async () => (await message(page)) === 'my-bend is saved.', 'it is saved');
      await page.waitForSelector('#course-my-bend');
      expect(await readFile(join(setting.pair.folder, 'library', 'courses', 'my-bend.toml'), 'utf8')).toBe(kCourse);

      await upload(page, 'my bend.toml', kCourse.replace('a bend of mine', 'another bend'));
      await page.click('#upload-replace');
      await until(async () => (await page.textContent('#course-my-bend .card-about')) === 'another bend', 'it is replaced');
      await upload(page, '3.toml', kCourse);
      await until(async () => (await message(page)).includes('not one of your own files'), 'no other file is replaced');

      await page.click('#course-my-bend .card-choose');
      await until(() => bus.last('/state')?.course === 'my-bend', 'my course is in force');
      await until(
        async () => {
          if ((await run(page)) === 'finished') return true;
          await goOn(page);
          return false;
        },
        'it is driven to its end',
        () => page.textContent('#number-x'),
      );
      await page.selectOption('#choose-robot', 'worn');
      await until(() => bus.last('/state')?.robot === 'worn' && bus.last('/state')?.session === 'ready', 'another robot');
      await page.selectOption('#choose-setup', 'stand');
      await until(() => bus.last('/state')?.setup === 'stand' && bus.last('/state')?.session === 'ready', 'another set-up');
      expect(await page.isDisabled('#course-my-bend .card-delete')).toBe(true);
      await page.click('#course-2 .card-choose');
      await until(() => bus.last('/state')?.course === '2', 'another course');
      await until(() => page.isEnabled('#course-my-bend .card-delete'), 'mine can be deleted');
      await page.click('#course-my-bend .card-delete');
      await page.click('#course-my-bend .card-delete');
      await page.waitForSelector('#course-my-bend', { state: 'detached' });
      expect(setting.pair.daemon.lines.some((line) => line.includes('error') && !line.includes('stop_requested'))).toBe(false);
    } finally {
      bus.close();
    }
  });

  it('are taken from a file that is dropped on them', async () => {
    const page = await openCourses();
    await stopped(page);
    const data = await page.evaluateHandle((text) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([text], 'dropped.toml'));
      return transfer;
    }, kCourse);
    await page.dispatchEvent('.courses', 'drop', { dataTransfer: data });
    await page.waitForSelector('#course-dropped');
  });

  it('place the robot at the start, and where it is drawn on the map', async () => {
    setting.expected = /willReadFrequently/;
    const page = await openCourses();
    await stopped(page);
    await page.click('#place-map');
    expect(await page.getAttribute('#place-map', 'aria-pressed')).toBe('true');
    const box = await page.locator('.placing').boundingBox();
    if (box === null) throw new Error('no map to draw on');
    const at = { x: box.x + 0.6 * box.width, y: box.y + 0.6 * box.height };
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    await page.mouse.move(at.x, at.y - 60, { steps: 4 });
    await picture(page, 'placing');
    expect(await colour(page, at)).not.toBe(kBody);
    await page.mouse.up();
    await until(async () => Math.abs(((await drawn(page))?.[3] ?? 0) - Math.PI / 2) < 0.02, 'it points up, where it was dragged to');
    expect(await page.isVisible('.placing')).toBe(false);
    await until(async () => (await colour(page, at)) === kBody, 'the robot is drawn where it was pressed');
    await until(() => page.isEnabled('#place-start'), 'the next change is possible');
    await page.click('#place-start');
    await until(async () => Math.hypot(...((await drawn(page)) ?? [9]).slice(0, 2)) < 0.005, 'it is at the start');
  });

  it('fit into every screen', async () => {
    const page = await openCourses(kScreens[0]);
    await stopped(page);
    for (const size of kScreens) {
      await page.setViewportSize(size);
      await until(() => page.evaluate(([w]) => document.documentElement.clientWidth === w, [size.width]), 'the page has its size');
      await page.locator('#tab-courses').scrollIntoViewIfNeeded();
      const wide = await page.$$eval('.courses, .courses *', (all) =>
        all.filter((each) => each.scrollWidth > each.clientWidth + 1 && getComputedStyle(each).overflowX === 'visible' && each.clientWidth > 0).map((each) => each.outerHTML.slice(0, 80)),
      );
      expect(wide, String(size.width)).toEqual([]);
      expect(await page.$eval('.courses', (each) => each.scrollWidth <= each.clientWidth + 1), String(size.width)).toBe(true);
      await picture(page, `courses-${size.width}`);
    }
  });
});

describe('a viewer without rights', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('sees the courses and is told why it cannot choose one', async () => {
    const page = await setting.open();
    await alive(page);
    await page.click('#tab-courses');
    await page.waitForSelector('#course-1-curve');
    await until(async () => (await page.textContent('.courses-why'))?.includes('server.commands'), 'the reason');
    for (const button of await page.$$('.card-choose')) expect(await button.isDisabled()).toBe(true);
    expect(await page.isDisabled('#place-start')).toBe(true);
  });
});
