// Common to the tests of a file: one browser, the programs, and the check that no page reports an error.
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, expect } from 'vitest';
import { alive, goTo, openBrowser, openPage, picture, type Size } from './cockpit.ts';
import { Pair } from './programs.ts';

export interface Wishes {
  /** Starts new programs for every test. */
  each?: boolean;
  /** Options for the browser. */
  flags?: string[];
  /** Records runs into the folder `runs` of the programs. */
  records?: boolean;
  /** Options for the daemon. */
  options?: string[];
  /** More of its configuration file. */
  configuration?: string;
}

/** The browsers of this file, by their options. */
const browsers = new Map<string, Promise<Browser>>();
afterAll(async () => {
  for (const browser of browsers.values()) await (await browser).close();
});

/** Is made once in a file or in a `describe`; programs start and end with it. All settings of a file share a browser. */
export class Setting {
  private browser: Browser | undefined;
  private pair_: Pair | undefined;
  private readonly others: Pair[] = [];
  private readonly complaints: string[] = [];
  /** Errors that the browser may report in a test that causes failures on purpose. */
  expected: RegExp | undefined;

  constructor({ each = false, flags = [], records = false, options = [], configuration = '' }: Wishes = {}) {
    const start = async (): Promise<void> => {
      this.pair_ = await Pair.start((folder) => [...(records ? ['--record', join(folder, 'runs')] : []), ...options], configuration);
    };
    const end = async (): Promise<void> => {
      await this.pair_?.end();
    };
    beforeAll(async () => {
      const key = flags.join(' ');
      if (!browsers.has(key)) browsers.set(key, openBrowser(flags));
      this.browser = await browsers.get(key);
      if (!each) await start();
    });
    if (each) beforeEach(start);
    afterEach(async ({ task }) => {
      const contexts = this.browser?.contexts() ?? [];
      if (task.result?.state === 'fail') {
        for (const pair of [this.pair_, ...this.others]) console.log(pair?.said);
        for (const [i, page] of contexts.flatMap((context) => context.pages()).entries()) await picture(page, `failed-${task.id}-${i}`).catch(() => undefined);
      }
      // An unused page would keep drawing and use a processor that the next page needs.
      for (const context of contexts) await context.close();
      for (const other of this.others.splice(0)) await other.end();
      if (each) await end();
      const unexpected = this.complaints.splice(0).filter((text) => this.expected?.test(text) !== true);
      this.expected = undefined;
      expect(unexpected, 'what pages complained about').toEqual([]);
    });
    if (!each) afterAll(end);
  }

  get pair(): Pair {
    if (this.pair_ === undefined) throw new Error('no programs: outside of a test');
    return this.pair_;
  }

  /** Another robot and its daemon, until the end of the test. */
  async another(configuration = '', listen?: string): Promise<Pair> {
    const pair = await Pair.start(() => [], configuration, listen);
    this.others.push(pair);
    return pair;
  }

  /** Opens another page, which is closed after the test. `smooth`: it draws as often as it would for a person. */
  async open(size?: Size, { smooth = false, url = this.pair.url } = {}): Promise<Page> {
    if (this.browser === undefined) throw new Error('no browser: outside of a test');
    return openPage(this.browser, url, this.complaints, size, smooth);
  }

  /** Opens another page, at one of its parts, once it shows the robot. */
  async openTab(tab: string, size?: Size): Promise<Page> {
    const page = await this.open(size);
    await alive(page);
    await goTo(page, tab);
    return page;
  }
}
