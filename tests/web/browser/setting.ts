// What the tests of a file have in common: one browser, the programs, and that no page complains.
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import { openBrowser, openPage, type Size } from './cockpit.ts';
import { Pair } from './programs.ts';

export interface Wishes {
  /** New programs for every test. */
  each?: boolean;
  /** For the browser. */
  flags?: string[];
  /** For the daemon. */
  options?: string[];
}

/** To be made once in a file or in a `describe`: everything begins and ends with it. */
export class Setting {
  private browser: Browser | undefined;
  private pair_: Pair | undefined;
  private readonly complaints: string[] = [];
  /** What a test that breaks something on purpose lets the browser complain about. */
  expected: RegExp | undefined;

  constructor({ each = false, flags = [], options = [] }: Wishes = {}) {
    const start = async (): Promise<void> => {
      this.pair_ = await Pair.start(options);
    };
    const end = async (): Promise<void> => {
      await this.pair_?.end();
    };
    beforeAll(async () => {
      this.browser = await openBrowser(flags);
      if (!each) await start();
    });
    if (each) beforeEach(start);
    afterEach(async ({ task }) => {
      if (task.result?.state === 'fail') console.log(this.pair_?.said);
      // A page that nobody looks at any more draws on, with a processor that the next one needs.
      for (const context of this.browser?.contexts() ?? []) await context.close();
      if (each) await end();
      const unexpected = this.complaints.splice(0).filter((text) => this.expected?.test(text) !== true);
      this.expected = undefined;
      expect(unexpected, 'what pages complained about').toEqual([]);
    });
    afterAll(async () => {
      await this.browser?.close();
      if (!each) await end();
    });
  }

  get pair(): Pair {
    if (this.pair_ === undefined) throw new Error('no programs: outside of a test');
    return this.pair_;
  }

  /** Another page; it ends with the test. */
  async open(size?: Size): Promise<Page> {
    if (this.browser === undefined) throw new Error('no browser: outside of a test');
    return openPage(this.browser, this.pair.url, this.complaints, size);
  }
}
