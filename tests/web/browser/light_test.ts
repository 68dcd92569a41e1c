import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, driveUntil, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const setting = new Setting({ smooth: true });

interface Counted {
  images?: number;
  drew?: boolean;
}

/** From now on counts the frames of the page in which the view of the course was drawn. */
async function countImages(page: Page): Promise<void> {
  await page.evaluate(() => {
    const counted = window as Counted;
    counted.images = 0;
    const note = (prototype: object, method: string): void => {
      const calls = prototype as Record<string, (...values: unknown[]) => unknown>;
      const real = calls[method];
      calls[method] = function (this: unknown, ...values: unknown[]): unknown {
        counted.drew = true;
        return real?.apply(this, values);
      };
    };
    // A map copies its ground, a scene draws triangles; diagrams do neither.
    note(CanvasRenderingContext2D.prototype, 'drawImage');
    note(WebGL2RenderingContext.prototype, 'drawElements');
    note(WebGL2RenderingContext.prototype, 'drawArrays');
    const frame = (): void => {
      if (counted.drew === true) counted.images = (counted.images ?? 0) + 1;
      counted.drew = false;
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
}

/** Images and time of the page during `during_ms`. */
async function images(page: Page, during_ms: number): Promise<{ count: number; took_s: number }> {
  return page.evaluate(
    (wait_ms) =>
      new Promise<{ count: number; took_s: number }>((resolve) => {
        const before = (window as Counted).images ?? 0;
        const began_ms = performance.now();
        setTimeout(() => {
          resolve({ count: ((window as Counted).images ?? 0) - before, took_s: (performance.now() - began_ms) / 1000 });
        }, wait_ms);
      }),
    during_ms,
  );
}

describe('a page without a graphics card', () => {
  it('shows the map first, and the scene to whoever asks for it', async () => {
    const page = await setting.open();
    await alive(page);
    expect(await page.getAttribute('#camera-map', 'aria-pressed')).toBe('true');
    await page.click('#camera-free');
    expect(await page.getAttribute('#camera-free', 'aria-pressed')).toBe('true');
    await alive(page);
  });

  it('says when it was first painted', async () => {
    const painted_ms: number[] = [];
    for (let i = 0; i < 5; i++) {
      const page = await setting.open();
      painted_ms.push(await until(() => page.evaluate(() => performance.getEntriesByName('first-contentful-paint')[0]?.startTime), 'a first image'));
      await page.close();
    }
    console.log(`first paint after ${painted_ms.map((ms) => ms.toFixed(0)).join(', ')} ms`);
  });

  for (const view of ['map', 'free']) {
    it(`draws the ${view} view 30 times a second at most, and not at all while nothing moves`, async () => {
      const page = await setting.open();
      await alive(page);
      await page.click(`#camera-${view}`);
      await countImages(page);
      await driveUntil(page, 'running');
      await until(async () => (await images(page, 200)).count > 0, 'an image of the moving robot');
      const { count, took_s } = await images(page, 2000);
      console.log(`${view}: ${(count / took_s).toFixed(1)} images a second`);
      expect(count).toBeLessThanOrEqual(30 * took_s + 2);
      await page.keyboard.press('h');
      await until(async () => !['arming', 'running'].includes(await run(page)), 'it holds');
      await until(async () => (await images(page, 1500)).count === 0, 'no more images', () => page.evaluate(() => (window as Counted).images));
    });
  }
});
