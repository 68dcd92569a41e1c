// A run on the page: where the robot is drawn, pause, what ends it, and who may command it.
import { afterEach, describe, expect, it } from 'vitest';
import type { State } from '../../../daemon/web/state/messages.ts';
import { Bus } from './bus.ts';
import { again, alive, drawn, driveUntil, figure, goTo, hide, press, run, shows, until } from './cockpit.ts';
import { Setting } from './setting.ts';

let bus: Bus | undefined;
afterEach(() => {
  bus?.close();
});
const state = (): State | undefined => bus?.last('/state');

describe('the page of a robot that drives course 3', () => {
  const setting = new Setting();

  it('shows it where the bus says, from the first metre to the end', async () => {
    bus = new Bus(setting.pair.url, ['/estimate', '/course']);
    const received = (bus.received['/estimate'] ??= []);
    const page = await setting.open();
    /** Waits until a message is drawn that comes from now on: the page may be late, but not wrong or frozen. */
    const follows = async (): Promise<number[]> => {
      const from = received.length;
      return until(
        async () => {
          const at = await drawn(page);
          const said = received.slice(from).some((estimate) => {
            const pose = estimate[estimate.steering];
            return Math.hypot(...[pose.x_m, pose.y_m, pose.z_m, pose.yaw_rad].map((value, i) => value - (at?.[i] ?? NaN))) < 1e-6;
          });
          return said && at;
        },
        `the robot is drawn where the bus says, after message ${from}`,
        () => received.length,
      );
    };

    await driveUntil(page, 'running');
    const length_m = await until(() => bus?.last('/course')?.length_m, 'a course');
    expect(length_m).toBeCloseTo(4.057, 3);
    const places: number[][] = [];
    for (const [share, camera] of [[0.1, 'map'], [0.5, 'chase'], [0.9, 'map']] as const) {
      await driveUntil(page, () => (received.at(-1)?.progress_m ?? 0) > share * length_m);
      await page.click(`#camera-${camera}`);
      places.push(await follows());
      expect(await figure(page, 'x')).toBeGreaterThan(-0.1);
    }
    const ways = places.map(([x = 0, y = 0]) => Math.hypot(x - (places[0]?.[0] ?? 0), y - (places[0]?.[1] ?? 0)));
    expect(Math.max(...ways)).toBeGreaterThan(0.8);

    await driveUntil(page, 'finished');
    await until(async () => Math.abs((await figure(page, 'y')) - (bus?.last('/estimate')?.odometry.y_m ?? NaN)) < 0.005, 'the last figures');
    await shows(page, '.timeline-progress', /4\.0\d \/ 4\.06 m/);
  });

  it('pauses it by button and key, however often they are pressed, and continues by Start, confirmed', async () => {
    const [page, other] = [await setting.open(), await setting.open()];
    for (const each of [other, page]) await alive(each);
    await page.bringToFront();
    bus = new Bus(setting.pair.url, ['/state']);
    const aborted = (): boolean => state()?.run === 'aborted';
    const paused = (): boolean => state()?.pause_left_s !== undefined;
    const start = async (says: string): Promise<boolean> => aborted() || (await page.textContent('#start'))?.trim() === says;
    /** False: a busy machine has ended the run. */
    const pausedAndContinued = async (): Promise<boolean> => {
      await driveUntil(page, async () => (await run(page)) === 'running' && (await figure(page, 'x')) > 0.05);
      await page.keyboard.press('p');
      await until(() => aborted() || paused(), 'it is paused');
      await until(async () => aborted() || Math.abs(await figure(page, 'left')) < 0.003, 'it stands', () => figure(page, 'left'));
      await until(() => start('Resume'), 'Start resumes');
      const stood = await figure(page, 'x');
      // Frightened, a person presses again, and another person as well.
      await press(page, '#pause');
      await other.keyboard.press('p');
      await page.keyboard.press('r');
      await until(() => start('Press again'), 'it asks for confirmation');
      await page.waitForTimeout(500);
      if (aborted()) return false;
      expect(paused(), 'still paused').toBe(true);
      expect(Math.abs((await figure(page, 'x')) - stood), 'it has stood').toBeLessThan(0.01);
      await until(async () => {
        if (aborted() || !paused()) return true;
        // The confirmation holds for 3 s, which a busy machine may need.
        if (await page.isVisible('#start')) await press(page, '#start');
        return false;
      }, 'it is confirmed');
      await until(async () => aborted() || (await figure(page, 'x')) > stood + 0.1, 'it goes on', () => figure(page, 'x'));
      return !aborted();
    };
    await again(pausedAndContinued, 'runs');
    await page.click('#pause');
    await until(() => start('Resume'), 'it is paused again');
    // STOP of another page ends the pause, and what this page was about to do.
    await press(page, '#start');
    await other.keyboard.press('Escape');
    await until(aborted, 'STOP ends a pause as well');
    expect(paused()).toBe(false);
    await until(async () => (await page.textContent('#start'))?.trim() === 'Start' && (await page.isEnabled('#start')), 'it begins anew');
    await page.keyboard.press('r');
    await page.waitForTimeout(500);
    expect(state()?.run, 'one press is no start').toBe('aborted');
  });
});

describe('a daemon that stops a robot that nobody watches', () => {
  const setting = new Setting({ configuration: '[server]\nstop_unwatched = true\n' });

  it('stops it when the page is hidden, not before', async () => {
    const page = await setting.open();
    await alive(page);
    bus = new Bus(setting.pair.url, ['/state']);
    const stops = (): number => state()?.stop.count ?? NaN;
    /** False: a busy machine has ended the run, or kept the page from saying that it is watched. */
    const watched = async (): Promise<boolean> => {
      await driveUntil(page, 'running');
      const before = stops();
      await page.waitForTimeout(4000);
      return stops() === before && (await run(page)) === 'running';
    };
    await again(watched, 'runs');
    const before = stops();
    await hide(page);
    await until(() => state()?.run === 'aborted', 'it is stopped');
    expect(stops()).toBe(before + 1);
  });
});

describe('what goes wrong', () => {
  // The battery of the emulated robot is below this.
  const setting = new Setting({ configuration: '[control]\nmin_battery_v = 7.95\n' });

  it('is told by figure and notice: a low battery, then a robot that is lost', async () => {
    const page = await setting.open();
    await alive(page);
    await driveUntil(page, 'running');
    await until(async () => (await page.locator('.number-row.low #number-battery').count()) === 1, 'the figure of the battery');

    await setting.pair.robot.end('SIGKILL');
    const rows = page.locator('#notice-list li');
    await until(async () => ((await rows.first().textContent()) ?? '').startsWith(`No robot on ${setting.pair.folder}/robot`), 'the port is named');
    await page.click('#notice-more');
    await until(async () => (await rows.count()) > 1, 'the fault that ended the run');
    const [notice, stage] = await Promise.all(['.notice', '.stage canvas'].map((selector) => page.locator(selector).boundingBox()));
    expect((notice?.y ?? NaN) + (notice?.height ?? NaN), 'the view is not covered').toBeLessThanOrEqual((stage?.y ?? NaN) + 1);
    await page.click('#notice-close');
    await until(async () => (await page.getAttribute('.notice', 'data-level')) === 'none', 'it is closed');
  });
});

describe('a viewer without rights', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('can command nothing, and is told why', async () => {
    const page = await setting.openTab('courses');
    await page.waitForSelector('#course-1-curve');
    await shows(page, '.courses-why', 'server.commands');
    await goTo(page, 'parameters');
    await until(() => page.isDisabled('#parameters-save'), 'Save is off');
    await goTo(page, 'doctor');
    await until(async () => (await page.getAttribute('#doctor-examine', 'title'))?.includes('server.commands'), 'the reason');
    for (const button of ['#course-1-curve .card-choose', '#place-start', '#doctor-examine', '#pause', '#start']) expect(await page.isDisabled(button), button).toBe(true);
  });
});
