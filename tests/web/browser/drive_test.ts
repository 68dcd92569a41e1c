// A run on the page: where the robot is drawn, pause, what ends it, and who may command it.
import type { Page } from 'playwright-core';
import { afterEach, describe, expect, it } from 'vitest';
import type { Estimate } from '../../../daemon/web/state/messages.ts';
import { Bus } from './bus.ts';
import { again, alive, drawn, driveUntil, figure, goOn, picture, press, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

let bus: Bus | undefined;
afterEach(() => {
  bus?.close();
});

/** The index, from `from` on, of the published message whose pose is drawn. */
function said(received: Estimate[], from: number, at: number[]): number | undefined {
  const [x = NaN, y = NaN, z = NaN, yaw = NaN] = at;
  for (let i = received.length - 1; i >= from; i--) {
    const estimate = received[i];
    const pose = estimate?.[estimate.steering];
    if (pose && Math.hypot(pose.x_m - x, pose.y_m - y, pose.z_m - z, pose.yaw_rad - yaw) < 1e-6) return i;
  }
  return undefined;
}

describe('the page of a robot that drives course 3', () => {
  const setting = new Setting();

  it('shows it where the bus says, from the first metre to the end', async () => {
    bus = new Bus(setting.pair.url, ['/estimate', '/course']);
    const received = (bus.received['/estimate'] ??= []);
    const progress_m = (): number => received.at(-1)?.progress_m ?? 0;
    const page = await setting.open();
    /** Waits until a message is drawn that is not older than `from`: the page may be late, but not wrong or frozen. */
    const follows = (from: number): Promise<number[]> =>
      until(
        async () => {
          const at = await drawn(page);
          return at !== undefined && said(received, from, at) !== undefined && at;
        },
        `the robot is drawn where the bus says, after message ${from}`,
        () => received.length,
      );

    await driveUntil(page, 'running');
    await until(async () => /^\d+:\d\d left$/.test((await page.textContent('.timeline-left')) ?? ''), 'the time left');
    const length_m = await until(() => bus?.last('/course')?.length_m, 'a course');
    expect(length_m).toBeCloseTo(4.057, 3);
    const places: number[][] = [];
    for (const share of [0.1, 0.3, 0.5, 0.7, 0.9]) {
      await until(
        async () => {
          if (progress_m() > share * length_m) return true;
          await goOn(page);
          return false;
        },
        `${share} of the way`,
        progress_m,
      );
      places.push(await follows(received.length));
      expect(await figure(page, 'x')).toBeGreaterThan(-0.1);
      if (share !== 0.7) continue;
      // Another camera must show the robot, too.
      await page.click('#camera-chase');
      await follows(received.length);
      await page.click('#camera-map');
    }
    const ways = places.map(([x = 0, y = 0]) => Math.hypot(x - (places[0]?.[0] ?? 0), y - (places[0]?.[1] ?? 0)));
    expect(Math.max(...ways)).toBeGreaterThan(0.8);

    await until(
      async () => {
        const state = await run(page);
        if (state === 'aborted') await goOn(page);
        return state === 'finished';
      },
      'the run is finished',
      progress_m,
    );
    await until(async () => Math.abs((await figure(page, 'y')) - (bus?.last('/estimate')?.odometry.y_m ?? NaN)) < 0.005, 'the last figures');
    await until(async () => /4\.0\d \/ 4\.06 m/.test((await page.textContent('.timeline-progress')) ?? ''), 'the whole way');
    await picture(page, 'finished');
  });

  it('pauses it by button and key, however often they are pressed, and continues by Start, confirmed', async () => {
    const page = await setting.open();
    await alive(page);
    const other = await setting.open();
    await alive(other);
    await page.bringToFront();
    const text = async (button: string): Promise<string | undefined> => (await page.textContent(button))?.trim();
    bus = new Bus(setting.pair.url, ['/state']);
    const aborted = (): boolean => bus?.last('/state')?.run === 'aborted';
    const pause_left_s = (): unknown => bus?.last('/state')?.pause_left_s;
    /** False: a busy machine has ended the run. */
    const paused = async (): Promise<boolean> => {
      await until(
        async () => {
          if ((await run(page)) === 'running' && (await figure(page, 'x')) > 0.05) return true;
          await goOn(page);
          return false;
        },
        'it drives',
        () => page.textContent('#number-x'),
      );
      await page.keyboard.press('p');
      await until(() => aborted() || pause_left_s() !== undefined, 'it is paused');
      await until(async () => aborted() || Math.abs(await figure(page, 'left')) < 0.003, 'it stands', () => figure(page, 'left'));
      await until(async () => aborted() || (await text('#pause')) === 'Paused', 'the button says so');
      await until(async () => aborted() || (await text('#start')) === 'Continue', 'Start continues');
      expect(await page.getAttribute('#pause', 'title')).toMatch(aborted() ? /./ : /the run ends in \d+ s/);
      const stood = await figure(page, 'x');
      // Frightened, a person presses again, and another person as well.
      await press(page, '#pause');
      await page.keyboard.press('p');
      await other.keyboard.press('p');
      await page.keyboard.press('r');
      await until(async () => aborted() || (await text('#start')) === 'Press again', 'it asks for confirmation');
      await page.waitForTimeout(500);
      if (aborted()) return false;
      expect(pause_left_s(), 'still paused').toBeDefined();
      expect(Math.abs((await figure(page, 'x')) - stood), 'it has stood').toBeLessThan(0.01);
      await until(async () => {
        if (aborted() || pause_left_s() === undefined) return true;
        // The confirmation holds for 3 s, which a busy machine may need.
        if (await page.isVisible('#start')) await press(page, '#start');
        return false;
      }, 'it is confirmed');
      await until(async () => aborted() || (await figure(page, 'x')) > stood + 0.1, 'it goes on', () => figure(page, 'x'));
      return !aborted();
    };
    await again(paused, 'runs');
    await page.click('#pause');
    await until(() => pause_left_s() !== undefined, 'it is paused again');
    // STOP of another page ends the pause, and what this page was about to do.
    await until(async () => aborted() || (await text('#start')) === 'Continue', 'Start continues');
    await press(page, '#start');
    await other.keyboard.press('Escape');
    await until(aborted, 'STOP ends a pause as well');
    expect(pause_left_s()).toBeUndefined();
    await until(async () => (await text('#start')) === 'Start' && (await page.isEnabled('#start')), 'it begins anew');
    await page.keyboard.press('r');
    await page.waitForTimeout(500);
    expect(bus.last('/state')?.run, 'one press is no start').toBe('aborted');
  });
});

describe('a daemon that stops a robot that nobody watches', () => {
  const setting = new Setting({ configuration: '[server]\nstop_unwatched = true\n' });

  it('stops it when the page is hidden, not before', async () => {
    const page = await setting.open();
    await alive(page);
    bus = new Bus(setting.pair.url, ['/state']);
    const stops = (): number => bus?.last('/state')?.stop.count ?? NaN;
    const title = async (): Promise<string> => (await page.getAttribute('#chip-run', 'title')) ?? '';
    /** False: a busy machine has ended the run, or kept the page from saying that it is watched. */
    const watched = async (): Promise<boolean> => {
      await driveUntil(page, 'running');
      const before = stops();
      await until(async () => (await title()).includes('nobody watches') || (await run(page)) !== 'running', 'it says so');
      await page.waitForTimeout(4000);
      return stops() === before && (await run(page)) === 'running';
    };
    await again(watched, 'runs');
    const before = stops();
    await page.evaluate(() => {
      Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    });
    await until(() => bus?.last('/state')?.run === 'aborted', 'it is stopped');
    expect(stops()).toBe(before + 1);
  });
});

interface Told {
  told?: string[];
}

/** Stands in for the browser's notifications and speakers. */
async function listenTo(page: Page): Promise<void> {
  await page.evaluate(() => {
    const told: string[] = ((window as Told).told = []);
    class Said {
      static permission = 'granted';
      static requestPermission = (): Promise<string> => Promise.resolve('granted');
      readonly when_ms = performance.now();
      constructor(title: string) {
        told.push(title);
      }
    }
    Object.assign(window, { Notification: Said });
    const calls = AudioContext.prototype as unknown as Record<string, (...values: unknown[]) => unknown>;
    const real = calls.createOscillator;
    calls.createOscillator = function (this: AudioContext, ...values: unknown[]): unknown {
      told.push('tone');
      return real?.apply(this, values);
    };
  });
}

describe('what goes wrong', () => {
  // The battery of the emulated robot is below this.
  const setting = new Setting({ configuration: '[control]\nmin_battery_v = 7.95\n' });

  it('is told by figure, notice, notification and sound: a low battery, then a robot that is lost', async () => {
    const page = await setting.open();
    await alive(page);
    for (const choice of ['#alert-notify', '#alert-sound']) expect(await page.isChecked(choice)).toBe(false);
    await page.check('#alert-sound');
    await page.reload();
    await alive(page);
    await until(() => page.isChecked('#alert-sound'), 'it is remembered');
    await listenTo(page);
    await page.check('#alert-notify');
    await driveUntil(page, 'running');
    await until(async () => (await page.locator('.number.low #number-battery').count()) === 1, 'the figure of the battery');
    const rows = page.locator('#notice-list li');
    await until(async () => ((await page.textContent('#notice-list')) ?? '').includes('The battery is low') || page.isVisible('#notice-more'), 'the notice, or a fault above it');

    await setting.pair.robot.end('SIGKILL');
    await until(() => page.evaluate(() => (window as Told).told?.some((text) => text.startsWith('TP100: ')) === true && (window as Told).told?.includes('tone') === true), 'it is told');
    await until(async () => ((await rows.first().textContent()) ?? '').startsWith(`No robot on ${setting.pair.folder}/robot`), 'the port is named');
    expect(await rows.count()).toBe(1);
    await until(() => page.isVisible('#notice-more'), 'there is more');
    await page.click('#notice-more');
    await until(async () => (await rows.count()) > 1, 'the fault that ended the run');
    await picture(page, 'notices');
    const [notice, stage] = await Promise.all(['.notice', '.stage canvas'].map((selector) => page.locator(selector).boundingBox()));
    expect(notice?.y, 'the view is not covered').toBeGreaterThanOrEqual((stage?.y ?? NaN) + (stage?.height ?? NaN) - 1);
    await page.click('#notice-close');
    await until(async () => (await page.getAttribute('.notice', 'data-level')) === 'none', 'it is closed');
  });
});

describe('a viewer without rights', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('sees everything, can command nothing, and is told why', async () => {
    const page = await setting.openTab('courses');
    await page.waitForSelector('#course-1-curve');
    await until(async () => (await page.textContent('.courses-why'))?.includes('server.commands'), 'the reason');
    for (const button of await page.$$('.card-choose')) expect(await button.isDisabled()).toBe(true);
    await page.click('#tab-parameters');
    await until(() => page.isVisible('[data-name="loop.rate_hz"]'), 'the list');
    await until(() => page.isDisabled('#parameters-save'), 'Save is off');
    await page.click('#tab-doctor');
    await until(async () => (await page.getAttribute('#doctor-examine', 'title'))?.includes('server.commands'), 'the reason');
    for (const button of ['#place-start', '#doctor-examine', '#pause', '#start']) expect(await page.isDisabled(button), button).toBe(true);
  });
});
