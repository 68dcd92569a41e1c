import { describe, expect, it } from 'vitest';
import { Bus } from './bus.ts';
import { again, alive, figure, goOn, picture, press, run, until } from './cockpit.ts';
import { Setting } from './setting.ts';

describe('a run', () => {
  const setting = new Setting({ each: true });

  it('is paused and resumed beside STOP, with the button and with the key', async () => {
    const page = await setting.open();
    await alive(page);
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
      await until(async () => aborted() || (await page.textContent('#pause'))?.trim() === 'Resume', 'the button says so');
      if (aborted()) return false;
      expect(await page.isVisible('#start')).toBe(false);
      expect(await page.getAttribute('#pause', 'title')).toMatch(/the run ends in \d+ s/);
      await picture(page, 'paused');
      const stood = await figure(page, 'x');
      await press(page, '#pause');
      await until(async () => aborted() || (await figure(page, 'x')) > stood + 0.1, 'it goes on', () => figure(page, 'x'));
      return !aborted();
    };
    try {
      await again(paused, 'runs');
      await page.click('#pause');
      await until(() => bus.last('/state')?.pause_left_s !== undefined, 'it is paused again');
      await page.keyboard.press('Escape');
      await until(aborted, 'STOP ends a pause as well');
      expect(bus.last('/state')?.pause_left_s).toBeUndefined();
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
  });
});
