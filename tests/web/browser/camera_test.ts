// The overhead camera's image beside the run, live and in its recording.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, it } from 'vitest';
import { clock } from '../../../daemon/web/state/format.ts';
import { driveUntil, goTo, rest, shows, until } from './cockpit.ts';
import { Program, freePort } from './programs.ts';
import { Setting } from './setting.ts';

// A camera that anybody can check: image i is of one grey, kGrey * i, and is taken i / kFps after the first.
const kFps = 4;
const kImages = 200;
const kGrey = 12;
const kGreys = 20;

const port = await freePort();
const setting = new Setting({ records: true, options: ['--camera', `udp:${String(port)}`] });
let camera: Program | undefined;
afterAll(async () => {
  await camera?.end();
});

beforeAll(() => {
  const images = join(setting.pair.folder, 'images');
  mkdirSync(images);
  const head = Buffer.from('P5 160 120 255\n');
  for (let i = 0; i < kImages; i++) writeFileSync(join(images, `${String(i)}.pgm`), Buffer.concat([head, Buffer.alloc(160 * 120, kGrey * (i % kGreys))]));
});

interface Shown {
  /** Number of the image, modulo kGreys. */
  number: number;
  /** When it was taken, in the time of the run. */
  at_s: number;
}

/** The image on the page, once there is one. */
function imageShown(page: Page): Promise<Shown> {
  return until(
    () =>
      page.evaluate((grey) => {
        const image = document.querySelector<HTMLImageElement>('.camera-image img');
        if (image === null || !image.complete || image.naturalWidth === 0) return undefined;
        const canvas = document.createElement('canvas');
        canvas.width = canvas.height = 1;
        const context = canvas.getContext('2d');
        context?.drawImage(image, 0, 0, 1, 1);
        const number = Math.round((context?.getImageData(0, 0, 1, 1).data[0] ?? NaN) / grey);
        return { number, at_s: Number(document.querySelector('.camera-image')?.getAttribute('data-t_s')) };
      }, kGrey),
    'an image',
  );
}

it("a camera's image is beside the run, live and in the recording, in step", async () => {
  const page = await setting.open();
  await until(async () => (await page.getAttribute('#chip-link', 'data-state')) !== '', 'the page');
  expect(await page.isVisible('.camera-image')).toBe(false);
  camera = new Program('tp100-camera', [join(setting.pair.folder, 'images'), '--images-only', '--fps', String(kFps), '--send', `udp:${String(port)}`]);
  const first = await imageShown(page);
  /** Expects the image that was taken at its time. */
  const inStep = async (): Promise<number> => {
    const { number, at_s } = await imageShown(page);
    expect((first.number + Math.round((at_s - first.at_s) * kFps)) % kGreys).toBe(number);
    return at_s;
  };
  await until(async () => (await inStep()) > first.at_s, 'another image');
  for (const state of ['hidden', 'visible'] as const) {
    await page.click('#camera-image-toggle');
    await page.waitForSelector('.camera-image img', { state });
    expect((await page.locator('.stage canvas').boundingBox())?.width, 'the course stays').toBeGreaterThan(200);
  }

  await driveUntil(page, async () => parseFloat((await page.textContent('.timeline-progress')) ?? '') > 1.5);
  await rest(page);
  await camera.end();
  // The recording ends a second after the run.
  await goTo(page, 'runs');
  const replay = page.locator('tr', { hasText: '-3' }).getByText('replay').first();
  await until(() => replay.isVisible(), 'the recording');
  await until(async () => (await page.locator('tr.active').count()) === 0, 'its end');
  await replay.click();
  await until(async () => Number(await page.getAttribute('#scrub', 'max')) > 5, 'all of the recording');

  // At any moment, the newest image that was taken before it.
  const middle_s = Math.floor(Number(await page.getAttribute('#scrub', 'max')) / 2);
  const ages_s: number[] = [];
  for (const position_s of [middle_s, middle_s + 1, middle_s - 1.5, middle_s + 0.5]) {
    await page.fill('#scrub', String(position_s));
    await shows(page, '.transport-time', new RegExp(`^${clock(position_s)} /`));
    await inStep();
    ages_s.push(parseFloat(await shows(page, '.camera-age', / s ago$/)));
  }
  // A busy machine leaves images out, but not before each of these moments.
  expect(Math.min(...ages_s)).toBeLessThanOrEqual(1 / kFps + 0.1);
});
