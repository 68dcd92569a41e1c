// Functions that use and read the page in a real browser as a person does.
import { existsSync } from 'node:fs';
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import axe from 'axe-core';
import { chromium, errors, type Browser, type Locator, type Page } from 'playwright-core';
import { expect } from 'vitest';
import { bin } from './programs.ts';

const kChromium = process.env.TP100_CHROMIUM ?? '/usr/bin/chromium-headless-shell';
/** The version is pinned, so that every run draws with the same software. */
const kFlags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--disable-dev-shm-usage',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
/** Limits of waiting: the time without any change, and the total time, after which a condition counts as failed. */
const kStill_ms = 60_000;
const kLimit_ms = 120_000;

/** Without a graphics card, a browser uses all cores that it gets; drawing must not delay the robot. */
export async function openBrowser(flags: string[] = []): Promise<Browser> {
  if (!existsSync(kChromium)) throw new Error(`${kChromium} is missing; scripts/setup installs it`);
  const executablePath = fileURLToPath(new URL('nice_chromium', import.meta.url));
  return chromium.launch({ executablePath, args: [...kFlags, ...flags], timeout: kStill_ms });
}

export interface Size {
  width: number;
  height: number;
}

export interface Place {
  x: number;
  y: number;
}

/** The smallest size with the layout of a large screen, because the processor draws every pixel. */
export const kSize: Size = { width: 1024, height: 600 };
export const kDesktop: Size = { width: 1440, height: 900 };
export const kPhone: Size = { width: 390, height: 844 };
const kScreens: Size[] = [kDesktop, { width: 768, height: 1024 }, kPhone];

/** Frames of a page in a test that does not look at how often it draws: without a graphics card each one costs a processor. */
const kFrame_ms = 125;

/** Opens a page; its console errors are added to `complaints`. `smooth`: it draws as often as it would for a person. */
export async function openPage(browser: Browser, url: string, complaints: string[], size: Size = kSize, smooth = false): Promise<Page> {
  const page = await browser.newPage({ viewport: size, colorScheme: 'dark' });
  if (!smooth) {
    await page.addInitScript((frame_ms) => {
      window.requestAnimationFrame = (draw) =>
        window.setTimeout(() => {
          draw(performance.now());
        }, frame_ms);
      window.cancelAnimationFrame = (handle) => {
        window.clearTimeout(handle);
      };
    }, kFrame_ms);
  }
  page.setDefaultTimeout(kStill_ms);
  page.on('console', (message) => {
    // Browser and driver warn that reading pictures back, as the tests do, is slow.
    const ours = message.type() === 'error' || (message.type() === 'warning' && !/GL Driver Message|willReadFrequently/.test(message.text()));
    if (ours) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(url);
  return page;
}

/** The state of the run as the page shows it. */
export async function run(page: Page): Promise<string> {
  return (await page.getAttribute('#chip-run', 'data-run')) ?? '';
}

/** The views, and the tabs or parts of each that the tests name. */
export const kParts: Record<string, string[]> = {
  drive: ['events'],
  plan: ['courses'],
  analyse: ['runs', 'signals'],
  setup: ['doctor', 'identify', 'parameters', 'link', 'keys'],
};

/** Shows a part of the page: its view, and its tab if it is one. */
export async function goTo(page: Page, part: string): Promise<void> {
  const view = Object.keys(kParts).find((each) => kParts[each]?.includes(part)) ?? '';
  await page.click(`#view-${view}`);
  const tab = page.locator(`#tab-${part}`);
  if ((await tab.count()) > 0) await tab.click();
}

/** The number that a figure of the page shows; NaN for a dash. */
export async function figure(page: Page, id: string): Promise<number> {
  const text = (await page.textContent(`#number-${id}`)) ?? '';
  return Number(text.replace('\u2212', '-').replace('\u2013', 'NaN'));
}

/** The pose at which the robot was last drawn: x, y, z in metres, yaw in radians; undefined if it was not drawn. */
export async function drawn(page: Page): Promise<number[] | undefined> {
  const text = await page.locator('.stage canvas').getAttribute('data-robot');
  return text === null || text === '' ? undefined : text.split(' ').map(Number);
}

/** Red, green and blue of the map at a point of the page, 0 to 255; empty if no map is there. */
export function colour(page: Page, at: Place): Promise<number[]> {
  return page.evaluate(({ x, y }) => {
    const canvas = document.querySelector<HTMLCanvasElement>('.stage canvas');
    const box = canvas?.getBoundingClientRect();
    if (canvas === null || box === undefined) return [];
    const scale = canvas.width / box.width;
    const data = canvas.getContext('2d')?.getImageData(scale * (x - box.left), scale * (y - box.top), 1, 1).data;
    return [...(data ?? [])].slice(0, 3);
  }, at);
}

/** Whether no run is under way. */
export async function rests(page: Page): Promise<boolean> {
  return ['aborted', 'idle', 'finished'].includes(await run(page));
}

/** Presses STOP, because an emulated robot starts by itself, and waits for the end of the run. */
export async function rest(page: Page): Promise<void> {
  await page.keyboard.press('Escape');
  await until(() => rests(page), 'no run is under way');
}

/** Waits until the page shows figures and the robot. */
export async function alive(page: Page): Promise<void> {
  await until(async () => Number.isFinite(await figure(page, 'x')), 'figures');
  await until(() => drawn(page), 'a robot');
}

/** Presses a button that may go before it is pressed, because the state changes meanwhile: then it is not pressed. */
export async function press(page: Page, button: string): Promise<void> {
  try {
    await page.click(button, { timeout: 2000 });
  } catch (error: unknown) {
    if (!(error instanceof errors.TimeoutError)) throw error;
  }
}

/**
 * Starts the robot if it is at standstill, at its end or because a busy machine stopped it. The first press asks for
 * confirmation, or where the robot stands; the next call confirms, or says at the start.
 */
export async function goOn(page: Page): Promise<void> {
  const before = await page.evaluate(() => location.hash);
  if (await page.isVisible('#start-placed')) await press(page, '#start-placed');
  else if ((await rests(page)) && (await page.isEnabled('#start'))) await press(page, '#start');
  // A start shows the view Drive; the test stays where it is.
  await page.evaluate((hash) => { if (location.hash !== hash) location.hash = hash; }, before);
}

/** Drives until the run is in a state or a condition is met; starts it again as often as necessary. */
export async function driveUntil(page: Page, wanted: string | (() => boolean | Promise<boolean>)): Promise<void> {
  await until(
    async () => {
      if (typeof wanted === 'string' ? (await run(page)) === wanted : await wanted()) return true;
      await goOn(page);
      return false;
    },
    `the run is ${String(wanted)}`,
    () => page.textContent('#number-x'),
  );
}

/** Drives so far from the course's start that a start asks where the robot stands. */
export async function driveAway(page: Page): Promise<void> {
  await driveUntil(page, async () => (await run(page)) === 'running' && Number.parseFloat((await page.textContent('#number-x')) ?? '') > 0.05);
}

/** Tries anew what a busy machine has ended: `attempt` then returns false. */
export async function again(attempt: () => Promise<boolean>, what: string): Promise<void> {
  let ended = 0;
  while (!(await attempt())) expect(++ended, `${what} that a busy machine has ended`).toBeLessThan(4);
}

export async function resize(page: Page, size: Size): Promise<void> {
  await page.setViewportSize(size);
  await until(() => page.evaluate(([w]) => document.documentElement.clientWidth === w, [size.width]), 'the page has its size');
}

/**
 * What is too wide: elements that extend beyond the side of the page, unless a parent element scrolls or hides them, and
 * elements of `part`, if it is given, whose content is wider than they are.
 */
export function tooWide(part: string): string[] {
  const width = document.documentElement.clientWidth;
  const out: string[] = [];
  const note = (element: Element): number => out.push(element.outerHTML.slice(0, 80));
  if (document.documentElement.scrollWidth > width) out.push(`page is ${document.documentElement.scrollWidth} wide`);
  for (const element of document.querySelectorAll('body *')) {
    const box = element.getBoundingClientRect();
    if (box.width === 0 || (box.left >= -0.5 && box.right <= width + 0.5)) continue;
    let around = element.parentElement;
    while (around !== null && getComputedStyle(around).overflowX === 'visible') around = around.parentElement;
    if (around === null || around === document.body) note(element);
  }
  if (part === '') return out;
  for (const element of document.querySelectorAll(`${part}, ${part} *`)) {
    // A cell grows with its content, but for the place to press around a checkbox.
    const shows = element.matches(part) || (element.tagName !== 'TD' && getComputedStyle(element).overflowX === 'visible');
    if (shows && element.clientWidth > 0 && element.scrollWidth > element.clientWidth + 1) note(element);
  }
  return out;
}

/** Expects that the page and `part` of it fit into a desktop's, a tablet's and a phone's screen. */
export async function fits(page: Page, part: string): Promise<void> {
  const before = page.viewportSize() ?? kSize;
  for (const size of kScreens) {
    await resize(page, size);
    await page.locator(part).scrollIntoViewIfNeeded();
    expect(await page.evaluate(tooWide, part), `${part} at ${size.width}`).toEqual([]);
  }
  await resize(page, before);
}

/** What axe finds that keeps somebody from reading a part of the page, or all of it: serious findings. */
export async function findings(page: Page, within?: string): Promise<string[]> {
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe.source);
  return page.evaluate(async (part) => {
    // Nothing is kept of what passes: most of the time of a long page would go there.
    const { violations } = await (window as unknown as { axe: typeof axe }).axe.run(part ?? document, { resultTypes: ['violations'], preload: false });
    return violations
      .filter(({ impact }) => impact === 'serious' || impact === 'critical')
      .map(({ id, nodes }) => `${id}: ${nodes[0]?.html ?? ''}`);
  }, within);
}

/** Saves a picture for people, beside the test's results. */
export async function picture(page: Page, name: string): Promise<void> {
  const folder = join(bin, '..', 'web');
  await mkdir(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** Waits until `check` returns a result; gives up when `moves`, whose result changes on the way there, no longer changes. */
export async function until<T>(
  check: () => Promise<T | undefined | false> | T | undefined | false,
  what: string,
  moves: () => unknown = () => undefined,
): Promise<T> {
  const end_ms = performance.now() + kLimit_ms;
  let still_ms = performance.now() + kStill_ms;
  let last: unknown;
  for (;;) {
    const found = await check();
    if (found !== undefined && found !== false) return found;
    const now = await moves();
    const now_ms = performance.now();
    if (now !== last) still_ms = now_ms + kStill_ms;
    last = now;
    if (now_ms > Math.min(end_ms, still_ms)) throw new Error(`waited in vain: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** Waits until the first such element shows a text, which is returned; gives up when its text no longer changes. */
export function shows(where: Page | Locator, selector: string, text: string | RegExp): Promise<string> {
  const now = async (): Promise<string> => (await where.locator(selector).first().textContent()) ?? '';
  return until(
    async () => {
      const shown = await now();
      return (typeof text === 'string' ? shown.includes(text) : text.test(shown)) && shown;
    },
    `${selector} shows ${String(text)}`,
    now,
  );
}

/** Hides the page, as if another tab or window lay over it. */
export async function hide(page: Page): Promise<void> {
  await page.evaluate(() => {
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
}

/** Presses the mouse at one place of the page and releases it at another one. */
export async function drag(page: Page, from: Place, to: Place): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
}
