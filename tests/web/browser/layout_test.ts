// The page as a whole: its layout on every screen, its themes, the map and the scene, and everything without a mouse.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { alive, drag, colour, drawn, driveAway, driveUntil, findings, goOn, goTo, kDesktop, kParts, kPhone, kSize, picture, resize, rest, run, shows, tooWide, until } from './cockpit.ts';
import { Setting } from './setting.ts';

const kAll = Object.values(kParts).flat();

/** Pairs of the bar's parts that lie over each other, by what they say. */
function overlaps(): string[] {
  const parts = [...document.querySelectorAll('h1, .setting, .badge, .theme-switch, .views a, .chip, .controls button, .next-step, #stop')]
    .map((element) => ({ says: element.textContent, box: element.getBoundingClientRect() }))
    .filter(({ box }) => box.width > 0);
  return parts.flatMap((a, i) =>
    parts
      .slice(i + 1)
      .filter((b) => a.box.left < b.box.right - 0.5 && b.box.left < a.box.right - 0.5 && a.box.top < b.box.bottom - 0.5 && b.box.top < a.box.bottom - 0.5)
      .map((b) => `${a.says} / ${b.says}`),
  );
}

/** Waits for one more frame than was drawn, so that all elements have adapted to the size of the screen. */
const frame = (page: Page): Promise<unknown> =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

/** Words of the header that do not fit into their place. */
function clipped(): string[] {
  return [...document.querySelectorAll<HTMLElement>('.views a, .chip-value, .controls button, .controls button span, .stop-line, .number-value, .number-label, .key-item, .modes button')]
    .filter((element) => element.offsetParent !== null && element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).display !== 'inline')
    .map((element) => `${element.className}: ${element.textContent}`);
}

/** Both sides of every width at which the layout changes. On the first ones every part is looked at. */
const kWidths = [360, 768, 1024, 1440, 390, 621, 1001, 1241, 1401, 2560];
const kEveryPart = 4;
const kTablet = { width: 1024, height: 768 };

const theme = (page: Page): Promise<string | null> => page.getAttribute('html', 'data-theme');
const pressed = async (page: Page, id: string): Promise<boolean> => (await page.getAttribute(`#${id}`, 'aria-pressed')) === 'true';

/** The brightness of the map's corner, where nothing but floor and grid is, 0 to 255. */
async function floor(page: Page): Promise<number> {
  const box = await page.locator('.stage canvas').boundingBox();
  const [red = NaN, green = NaN, blue = NaN] = await colour(page, { x: (box?.x ?? NaN) + 1, y: (box?.y ?? NaN) + 1 });
  return (red + green + blue) / 3;
}

/** Presses the tab key until `id` has the focus. */
async function tabTo(page: Page, id: string): Promise<void> {
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    if ((await page.evaluate(() => document.activeElement?.id)) === id) return;
  }
  throw new Error(`tab never reaches ${id}`);
}

describe('the page', () => {
  const setting = new Setting();

  it('fits into every screen with STOP in sight', async () => {
    const page = await setting.open({ width: 360, height: 640 });
    await alive(page);
    for (const [i, width] of kWidths.entries()) {
      const height = width < 500 ? 640 : 600;
      await resize(page, { width, height });
      await frame(page);
      for (const part of kAll.slice(0, i < kEveryPart ? kAll.length : 1)) {
        await goTo(page, part);
        const where = `${part} at ${width}`;
        expect(await page.evaluate(tooWide, ''), where).toEqual([]);
        const stop = await page.locator('#stop').boundingBox();
        if (stop === null) throw new Error('no STOP');
        expect(Math.min(stop.x, stop.y, width - stop.x - stop.width, height - stop.y - stop.height), where).toBeGreaterThanOrEqual(0);
        expect(stop.width * stop.height, where).toBeGreaterThan(180 * 44);
        const middle = [stop.x + stop.width / 2, stop.y + stop.height / 2] as const;
        expect(await page.evaluate(([x, y]) => document.elementFromPoint(x, y)?.closest('#stop') !== null, middle), `nothing lies over STOP with ${where}`).toBe(true);
      }
      // The header is fullest during a run, which a busy machine may have ended meanwhile.
      await goTo(page, 'events');
      await driveUntil(page, 'running');
      expect(await page.evaluate(overlaps), String(width)).toEqual([]);
      expect(await page.evaluate(clipped), String(width)).toEqual([]);
    }
    // The picture of README.md.
    await resize(page, kDesktop);
    await page.click('#camera-free');
    await alive(page);
    await until(async () => {
      await goOn(page);
      const fresh = await page.evaluate(() => document.querySelector('.viewport.stale, .number-row.stale, .notice:not([data-level=none])') === null);
      return fresh && (await run(page)) === 'running' && (await drawn(page)) !== undefined;
    }, 'a robot that drives, and nothing that is old');
    await picture(page, 'layout-1440');
  });

  it.each(
    (['dark', 'light'] as const).flatMap((scheme) => [kDesktop, kTablet, kPhone].map((size) => ({ scheme, size, width: size.width }))),
  )('can be read by everybody in the $scheme at a width of $width, in every view', async ({ scheme, size }) => {
    const page = await setting.open(size);
    await page.emulateMedia({ colorScheme: scheme });
    await alive(page);
    await until(async () => (await theme(page)) === scheme, 'the theme that the system prefers');
    expect(await page.evaluate(() => getComputedStyle(document.body).backgroundColor)).toBe(scheme === 'dark' ? 'rgb(10, 14, 19)' : 'rgb(255, 255, 255)');
    // A page that draws no moving robot is examined sooner.
    await rest(page);
    const found: string[] = [];
    for (const part of kAll) {
      await goTo(page, part);
      await frame(page);
      if (part === 'link') await until(async () => (await page.locator('.bars:not([aria-label])').count()) === 0, 'all figures');
      found.push(...(await findings(page)).map((each) => `${part}: ${each}`));
      await picture(page, `view-${part}-${size.width}-${scheme}`);
    }
    expect([...new Set(found)]).toEqual([]);
  });

  it('can be read by everybody when all of it is old', async () => {
    setting.expected = /WebSocket|ERR_CONNECTION|Failed to load/;
    const page = await setting.open();
    await alive(page);
    setting.pair.daemon.freeze();
    await until(async () => (await page.getAttribute('.viewport', 'class'))?.includes('stale'), 'it is shown as old');
    expect(await findings(page)).toEqual([]);
    setting.pair.daemon.thaw();
    await alive(page);
  });

  it('is light or dark as it was told last, and draws the map so', async () => {
    const page = await setting.open(kSize);
    await alive(page);
    const before = (await theme(page)) === 'light' ? 'light' : 'dark';
    const other = before === 'light' ? 'dark' : 'light';
    const bright = (which: string): Promise<boolean> => until(async () => (await floor(page)) > 128 === (which === 'light'), `the map is ${which}`);
    await bright(before);
    await page.click('.theme-switch');
    expect(await theme(page)).toBe(other);
    await bright(other);
    await page.reload();
    await alive(page);
    expect(await theme(page)).toBe(other);
    // What the system prefers is followed again.
    await page.click('.theme-switch');
    expect(await theme(page)).toBe(before);
    await page.emulateMedia({ colorScheme: other });
    await until(async () => (await theme(page)) === other, 'the system changes');
  });

  it('keeps the sizes that its panels were given', async () => {
    const page = await setting.open();
    const size = (): Promise<number[]> => page.evaluate(() => ['.side', '.plots'].map((part) => document.querySelector(part)?.getBoundingClientRect()).map((box, i) => Math.round((i === 0 ? box?.width : box?.height) ?? 0)));
    await page.focus('.handle.plot-height');
    await page.keyboard.press('ArrowDown');
    const [wide = 0, high = 0] = await size();
    await page.keyboard.press('ArrowDown');
    await page.focus('.handle.side-width');
    await page.keyboard.press('ArrowLeft');
    expect(await size()).toEqual([wide + 20, high + 20]);
    const box = await page.locator('.handle.side-width').boundingBox();
    await drag(page, { x: (box?.x ?? 0) + 4, y: 300 }, { x: (box?.x ?? 0) - 26, y: 300 });
    const dragged = await size();
    expect(dragged[0]).toBeGreaterThan(wide + 40);
    await page.reload();
    expect(await size()).toEqual(dragged);
    await page.dblclick('.handle.side-width', { position: { x: 4, y: 200 } });
    expect(await size()).toEqual([wide, high + 20]);
  });

  it('is used without a mouse and told in words, on a screen 360 px wide', async () => {
    const page = await setting.open({ width: 360, height: 640 });
    await alive(page);
    for (const [key, view] of [['2', 'plan'], ['4', 'setup'], ['3', 'analyse'], ['1', 'drive']] as const) {
      await page.keyboard.press(key);
      expect(await page.getAttribute(`#view-${view}`, 'aria-current'), `${key} is ${view}`).toBe('page');
      expect(new URL(page.url()).hash).toMatch(new RegExp(`^#${view}`));
    }
    for (const camera of ['chase', 'top', 'free', 'map']) {
      await page.keyboard.press('c');
      await until(() => pressed(page, `camera-${camera}`), camera);
    }
    for (const id of ['stop', 'camera-map', 'show-model']) await tabTo(page, id);
    expect(await pressed(page, 'show-model')).toBe(true);
    await page.keyboard.press('Enter');
    expect(await pressed(page, 'show-model')).toBe(false);

    // Tabs are one stop of the tab key; the arrow keys change between them.
    await page.keyboard.press('4');
    await tabTo(page, 'tab-doctor');
    for (let i = 0; i < 2; i++) await page.keyboard.press('ArrowRight');
    expect(await page.getAttribute('#tab-parameters', 'aria-selected')).toBe('true');
    expect(await page.isVisible('#page-parameters')).toBe(true);
    // The address leads to where the page is.
    expect(new URL(page.url()).hash).toBe('#setup/parameters');
    await page.reload();
    expect(await page.isVisible('#page-parameters')).toBe(true);
    await page.goBack();
    expect(await page.getAttribute('#view-drive', 'aria-current')).toBe('page');
    await alive(page);

    await driveUntil(page, 'running');
    await shows(page, '#scene-words', /^Course 3, robot end-loaded, running\. It is at x /);
    await driveAway(page);
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
    await shows(page, '.stop-line', /^robot stopped/);
    await shows(page, '#scene-words', 'STOP is in force. Fault: ');
  });
});

describe('without WebGL', () => {
  const setting = new Setting({ flags: ['--disable-3d-apis'] });

  it('the course is a map, and the robot moves on it', async () => {
    const page = await setting.open();
    expect(await pressed(page, 'camera-map')).toBe(true);
    expect(await page.isDisabled('#camera-chase')).toBe(true);
    const first = await until(() => drawn(page), 'a robot');
    await until(async () => {
      await goOn(page);
      return (await drawn(page))?.join() !== first.join();
    }, 'it moves');
    // Two standard deviations of each estimated position: some millimetres to centimetres.
    for (const name of ['model', 'odometry']) {
      const ring = ((await page.getAttribute('.stage canvas', `data-${name}-uncertainty`)) ?? '').split(' ').map(Number);
      expect(ring.length === 2 && ring.every((m) => m > 1e-4 && m < 0.5), `${name} ${ring.join()}`).toBe(true);
    }
  });
});
