import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { clock } from '../../../daemon/web/state/format.ts';
import { driveUntil, goOn, kPhone, kSize, picture, resize, rest, rests, until } from './cockpit.ts';
import { Program, freePort } from './programs.ts';
import { Setting } from './setting.ts';

// A camera that anybody can check: image i is of one grey, kGrey * i, and is taken i / kFps after the first.
const kFps = 4;
const kImages = 200;
const kGrey = 12;
const kGreys = 20;

const port = await freePort();
const setting = new Setting({ records: true, options: ['--camera', `udp:${String(port)}`] });
const images = (): string => join(setting.pair.folder, 'images');
let camera: Program | undefined;

beforeAll(() => {
  mkdirSync(images());
  const head = Buffer.from('P5 160 120 255\n');
  for (let i = 0; i < kImages; i++) {
    const grey = kGrey * (i % kGreys);
    writeFileSync(join(images(), `${String(i)}.pgm`), Buffer.concat([head, Buffer.alloc(160 * 120, grey)]));
  }
});
afterAll(async () => {
  await camera?.end();
});

/** The number of the image on the page, modulo kGreys; undefined: none. */
function imageShown(page: Page): Promise<number | undefined> {
  return page.evaluate((grey) => {
    const image = document.querySelector<HTMLImageElement>('.camera-image img');
    if (image === null || !image.complete || image.naturalWidth === 0) return undefined;
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 1;
    const context = canvas.getContext('2d');
    context?.drawImage(image, 0, 0, 1, 1);
    return Math.round((context?.getImageData(0, 0, 1, 1).data[0] ?? NaN) / grey);
  }, kGrey);
}

/** When the image on the page was taken, in the time of the run. */
async function taken_s(page: Page): Promise<number> {
  return Number(await page.getAttribute('.camera-image', 'data-t_s'));
}

/** Waits for an image that was taken at another time; returns both. */
async function next(page: Page, not_s: number): Promise<{ number: number; at_s: number }> {
  const at_s = await until(async () => {
    const now_s = await taken_s(page);
    return now_s !== not_s && now_s;
  }, 'another image');
  const number = await until(() => imageShown(page), 'the image');
  return (await taken_s(page)) === at_s ? { number, at_s } : next(page, not_s);
}

describe("a camera's image", () => {
  it('is beside the run, live and in the recording, in step', async () => {
    const page = await setting.open();
    await until(async () => (await page.getAttribute('#chip-link', 'data-state')) !== '', 'the page');
    expect(await page.isVisible('.camera-image')).toBe(false);
    camera = new Program('tp100-camera', [images(), '--images-only', '--fps', String(kFps), '--send', `udp:${String(port)}`]);

    const first = await next(page, NaN);
    const later = await next(page, first.at_s);
    const passed = Math.round((later.at_s - first.at_s) * kFps);
    expect((first.number + passed) % kGreys).toBe(later.number);
    await page.click('#camera-image-toggle');
    await page.waitForSelector('.camera-image img', { state: 'hidden' });
    await page.click('#camera-image-toggle');
    await page.waitForSelector('.camera-image img', { state: 'visible' });

    await driveUntil(page, 'running');
    // On a phone, too, inside the view and beside nothing that is pressed.
    await resize(page, kPhone);
    const inside = await page.evaluate(() => {
      const box = (selector: string): DOMRect | undefined => document.querySelector(selector)?.getBoundingClientRect();
      const [image, view, modes] = [box('.camera-image'), box('.viewport'), box('.modes')];
      if (image === undefined || view === undefined || modes === undefined) return 'something is missing';
      const apart = image.right <= modes.left || modes.right <= image.left || image.bottom <= modes.top || modes.bottom <= image.top;
      return image.left >= view.left && image.right <= view.right && image.top >= view.top && image.bottom <= view.bottom && apart;
    });
    await picture(page, 'camera-phone');
    expect(inside).toBe(true);
    await resize(page, kSize);
    const progress = (): Promise<string | null> => page.textContent('.timeline-progress');
    await until(
      async () => {
        if (parseFloat((await progress()) ?? '') > 1.5) return true;
        await goOn(page);
        return false;
      },
      'enough of a run',
      progress,
    );
    await rest(page);
    await camera.end();
    // The recording ends a second after the run.
    await page.click('#tab-runs');
    await until(async () => await page.locator('tr', { hasText: '-3' }).getByText('replay').first().isVisible(), 'the recording');
    await until(async () => (await page.locator('tr.active').count()) === 0, 'its end');
    await page.locator('tr', { hasText: '-3' }).getByText('replay').first().click();
    await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 5, 'all of the recording');

    // At any moment, the newest image that was taken before it, by the same count as live.
    const moment = async (position_s: number): Promise<number> => {
      await page.fill('#scrub', String(position_s));
      await until(async () => ((await page.textContent('.transport-time')) ?? '').startsWith(`${clock(position_s)} /`), 'the moment');
      return taken_s(page);
    };
    const middle_s = Math.floor(Number(await page.getAttribute('#scrub', 'max')) / 2);
    for (const position_s of [middle_s, middle_s + 1, middle_s - 1.5, middle_s + 0.5]) {
      const at_s = await moment(position_s);
      const number = await until(() => imageShown(page), 'the image');
      const since_first = Math.round((at_s - first.at_s) * kFps);
      expect((first.number + since_first) % kGreys).toBe(number);
      const age = await until(async () => /([\d.]+) s ago/.exec((await page.textContent('.camera-age')) ?? '')?.[1], 'its age');
      if (Number(age) <= 1 / kFps + 0.1) continue;
      // A busy machine leaves images out: then the next one was taken after this moment.
      let tenths = Math.round(10 * position_s);
      const next_s = await until(async () => {
        const now_s = await moment(++tenths / 10);
        return now_s !== at_s && now_s;
      }, 'the next image');
      expect(next_s).toBeGreaterThanOrEqual(at_s + Number(age) - 0.1);
    }
    await page.click('#live');
    await until(() => rests(page), 'the robot itself');
  });
});
