// Common to the tests of a file: one browser, the programs, and the check that no page reports an error.
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import { openBrowser, openPage, type Size } from './cockpit.ts';
import { Pair } from './programs.ts';

export interface Wishes {
  /** Starts new programs for every test. */
  each?: boolean;
  /** Options for the browser. */
  flags?: string[];
  /** Pages draw as often as they would for a person. */
  smooth?: boolean;
  /** Options for the daemon. */
  options?: string[];
  /** More of its configuration file. */
  configuration?: string;
}

/** The page of all robots lists daemons of other tests, too, and these end meanwhile. */
export const kOthersEnd = /WebSocket connection to .* failed/;

/** Is made once in a file or in a `describe`; browser and programs start and end with it. */
export class Setting {
  private browser: Browser | undefined;
  private pair_: Pair | undefined;
  private readonly complaints: string[] = [];
  private readonly smooth: boolean;
  /** Errors that the browser may report in a test that causes failures on purpose. */
  expected: RegExp | undefined;

  constructor({ each = false, flags = [], smooth = false, options = [], configuration = '' }: Wishes = {}) {
    this.smooth = smooth;
    const start = async (): Promise<void> => {
      this.pair_ = await Pair.start(options, undefined, configuration);
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
      // An unused page would keep drawing and use a processor that the next page needs.
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

  /** Opens another page, which is closed after the test. */
  async open(size?: Size): Promise<Page> {
    if (this.browser === undefined) throw new Error('no browser: outside of a test');
    return openPage(this.browser, this.pair.url, this.complaints, size, this.smooth);
  }
}
