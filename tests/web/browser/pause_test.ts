import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { again, alive, driveUntil, figure, goOn, picture, press, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

describe('a run', () => {
  const setting = new Setting({ each: true });

  it('is paused by its button and key, however often they are pressed, and continues by Start, confirmed', async () => {
    const page = await setting.open();
    await alive(page);
    const other = await setting.open();
    await alive(other);
    await page.bringToFront();
    const text = async (button: string): Promise<string | undefined> => (await page.textContent(button))?.trim();
    const bus = new Bus(setting.pair.url, ['/state']);
    const aborted = (): boolean => bus.last('/state')?.run === 'aborted';
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
      await until(() => aborted() || bus.last('/state')?.pause_left_s !== undefined, 'it is paused');
      await until(async () => aborted() || Math.abs(await figure(page, 'left')) < 0.003, 'it stands', () => figure(page, 'left'));
      await until(async () => aborted() || (await text('#pause')) === 'Paused', 'the button says so');
      await until(async () => aborted() || (await text('#start')) === 'Continue', 'Start continues');
      expect(await page.getAttribute('#pause', 'title')).toMatch(aborted() ? /./ : /the run ends in \d+ s/);
      await picture(page, 'paused');
      const stood = await figure(page, 'x');
      // Frightened, a person presses again, and another person as well.
      await press(page, '#pause');
      await page.keyboard.press('p');
      await other.keyboard.press('p');
      await page.keyboard.press('r');
      await until(async () => aborted() || (await text('#start')) === 'Press again', 'it asks for confirmation');
      await page.waitForTimeout(500);
      if (aborted()) return false;
      expect(bus.last('/state')?.pause_left_s, 'still paused').toBeDefined();
      expect(Math.abs((await figure(page, 'x')) - stood), 'it has stood').toBeLessThan(0.01);
      await until(async () => {
        if (aborted() || bus.last('/state')?.pause_left_s === undefined) return true;
        // The confirmation holds for 3 s, which a busy machine may need.
        if (await page.isVisible('#start')) await press(page, '#start');
        return false;
      }, 'it is confirmed');
      await until(async () => aborted() || (await figure(page, 'x')) > stood + 0.1, 'it goes on', () => figure(page, 'x'));
      return !aborted();
    };
    try {
      await again(paused, 'runs');
      await page.click('#pause');
      await until(() => bus.last('/state')?.pause_left_s !== undefined, 'it is paused again');
      // STOP of another page ends the pause, and what this page was about to do.
      await until(async () => aborted() || (await text('#start')) === 'Continue', 'Start continues');
      await press(page, '#start');
      await other.keyboard.press('Escape');
      await until(aborted, 'STOP ends a pause as well');
      expect(bus.last('/state')?.pause_left_s).toBeUndefined();
      await until(async () => (await text('#start')) === 'Start' && (await page.isEnabled('#start')), 'it begins anew');
      await page.keyboard.press('r');
      await page.waitForTimeout(500);
      expect(bus.last('/state')?.run, 'one press is no start').toBe('aborted');
    } finally {
      bus.close();
    }
  });
});

describe('a daemon that stops a robot that nobody watches', () => {
  const setting = new Setting({ each: true, configuration: '[server]\nstop_unwatched = true\n' });

  it('stops it when the page is hidden, not before', async () => {
    const page = await setting.open();
    await alive(page);
    const bus = new Bus(setting.pair.url, ['/state']);
    const stops = (): number => bus.last('/state')?.stop.count ?? NaN;
    const title = async (): Promise<string> => (await page.getAttribute('#chip-run', 'title')) ?? '';
    /** False: a busy machine has ended the run, or kept the page from saying that it is watched. */
    const watched = async (): Promise<boolean> => {
      await driveUntil(page, 'running');
      const before = stops();
      await until(async () => (await title()).includes('nobody watches') || (await run(page)) !== 'running', 'it says so');
      await page.waitForTimeout(4000);
      return stops() === before && (await run(page)) === 'running';
    };
    try {
      await again(watched, 'runs');
      const before = stops();
      await page.evaluate(() => {
        Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
        document.dispatchEvent(new Event('visibilitychange'));
      });
      await until(() => bus.last('/state')?.run === 'aborted', 'it is stopped');
      expect(stops()).toBe(before + 1);
    } finally {
      bus.close();
    }
  });
});

describe('a viewer without rights', () => {
  const setting = new Setting({ configuration: '[server]\ncommands = "none"\n' });

  it('cannot pause a run', async () => {
    const page = await setting.open();
    await alive(page);
    expect(await page.isDisabled('#pause')).toBe(true);
    expect(await page.isDisabled('#start')).toBe(true);
  });
});
