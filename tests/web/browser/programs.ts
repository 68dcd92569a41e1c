// The two real programs, joined by a pseudo-terminal, and a browser, for as long as a test needs them.
import { spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';
import { chromium, type Browser, type Page } from 'playwright-core';

const bin = process.env.TP100_BIN ?? '';
const kChromium = process.env.TP100_CHROMIUM ?? '/usr/bin/chromium';
/** Pinned, so that every run draws with the same software. */
const kFlags = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** One of our programs with what it said. */
export class Program {
  readonly lines: string[] = [];
  private readonly child: ChildProcess;
  private readonly waiting = new Set<() => void>();
  private gone = false;

  constructor(
    private readonly name: string,
    args: string[],
  ) {
    const path = join(bin, name);
    if (!existsSync(path)) throw new Error(`${path} is missing: build it, or name the folder of the programs in TP100_BIN`);
    this.child = spawn(path, args, { stdio: ['ignore', 'pipe', 'pipe'] });
    for (const stream of [this.child.stdout, this.child.stderr]) {
      if (stream === null) continue;
      createInterface({ input: stream }).on('line', (line) => {
        this.lines.push(line);
        for (const check of this.waiting) check();
      });
    }
    this.child.on('exit', () => {
      this.gone = true;
      for (const check of this.waiting) check();
    });
  }

  /** The first match in what it says, from line `from` on. */
  line(pattern: RegExp, from = 0): Promise<RegExpExecArray> {
    return new Promise((resolve, reject) => {
      const check = (): void => {
        for (const line of this.lines.slice(from)) {
          const match = pattern.exec(line);
          if (match === null) continue;
          this.waiting.delete(check);
          resolve(match);
          return;
        }
        if (!this.gone) return;
        this.waiting.delete(check);
        reject(new Error(`${this.name} ended without ${String(pattern)}:\n${this.lines.join('\n')}`));
      };
      this.waiting.add(check);
      check();
    });
  }

  freeze(): void {
    this.child.kill('SIGSTOP');
  }

  thaw(): void {
    this.child.kill('SIGCONT');
  }

  async end(signal: NodeJS.Signals = 'SIGTERM'): Promise<void> {
    if (this.gone) return;
    const exited = once(this.child, 'exit');
    this.child.kill('SIGCONT');
    this.child.kill(signal);
    await exited;
  }
}

/** A port that nobody uses now. */
export async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const address = server.address();
  server.close();
  await once(server, 'close');
  return typeof address === 'object' && address !== null ? address.port : 0;
}

/** An emulated robot and the daemon that drives it. */
export class Pair {
  url = '';
  private constructor(
    readonly folder: string,
    readonly robot: Program,
    public daemon: Program,
  ) {}

  static async start(options: string[] = [], listen = '127.0.0.1:0'): Promise<Pair> {
    const folder = await mkdtemp(join(tmpdir(), 'tp100-web-'));
    // Ordinary scheduling, because the tests of a whole machine run at once; and a stalled process is
    // no reason here to end a run.
    await writeFile(join(folder, 'tp100.toml'), '[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\nhold_cpu_latency = false\n');
    const robot = new Program('tp100-sim', ['robot', '--link', join(folder, 'robot'), '--course', '3']);
    await robot.line(/linked from/);
    const pair = new Pair(folder, robot, Pair.daemon(folder, options, listen));
    await pair.ready();
    return pair;
  }

  /** Another daemon at the place of one that has ended. */
  async restart(options: string[] = []): Promise<void> {
    const { host } = new URL(this.url);
    this.daemon = Pair.daemon(this.folder, options, host);
    await this.ready();
  }

  async end(): Promise<void> {
    await this.daemon.end();
    await this.robot.end();
    await rm(this.folder, { recursive: true, force: true });
  }

  private static daemon(folder: string, options: string[], listen: string): Program {
    const config = join(folder, 'tp100.toml');
    const fixed = ['--config', config, '--port', join(folder, 'robot'), '--wait', '--stay', '--listen', listen];
    return new Program('tp100d', ['run', ...fixed, '--course', '3', ...options]);
  }

  private async ready(): Promise<void> {
    this.url = (await this.daemon.line(/page: (\S+)/))[1] ?? '';
  }
}

/** Without a graphics card a browser takes every core it gets; the robot must not starve for pictures. */
export async function openBrowser(flags: string[] = []): Promise<Browser> {
  if (!existsSync(kChromium)) throw new Error(`${kChromium} is missing; scripts/setup installs it`);
  return chromium.launch({ executablePath: fileURLToPath(new URL('nice_chromium', import.meta.url)), args: [...kFlags, ...flags] });
}

/** The state of the run, as the page says it. */
export async function run(page: Page): Promise<string> {
  return (await page.textContent('#chip-run .chip-value')) ?? '';
}

/**
 * Waits until the run is `wanted`. On a machine that is too busy for the robot, which then stops by itself,
 * starts again.
 */
export async function driveUntil(page: Page, wanted: string, limit_ms = 60_000): Promise<void> {
  await until(
    async () => {
      const state = await run(page);
      if (state === wanted) return true;
      if (['aborted', 'idle', 'finished'].includes(state) && (await page.isEnabled('#start'))) await page.click('#start');
      return false;
    },
    `the run is ${wanted}`,
    limit_ms,
  );
}

/** A page with everything that it complained about. */
export async function openPage(browser: Browser, url: string, size = { width: 1280, height: 800 }): Promise<{ page: Page; complaints: string[] }> {
  const page = await browser.newPage({ viewport: size });
  const complaints: string[] = [];
  page.on('console', (message) => {
    // Drivers tell the tests, which read pictures back, that this is slow.
    const ours = message.type() === 'error' || (message.type() === 'warning' && !message.text().includes('GL Driver Message'));
    if (ours) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  await page.goto(url);
  return { page, complaints };
}

/** A picture for people, beside the test's results. */
export async function picture(page: Page, name: string): Promise<void> {
  const folder = join(bin, '..', 'web');
  await mkdir(folder, { recursive: true });
  await page.screenshot({ path: join(folder, `${name}.png`) });
}

/** The number that a figure of the page shows; NaN for a dash. */
export async function figure(page: Page, id: string): Promise<number> {
  const text = (await page.textContent(`#number-${id}`)) ?? '';
  return Number(text.replace('\u2212', '-').replace('\u2013', 'NaN'));
}

/** Waits, for as long as the test may take, until `check` gives something. */
export async function until<T>(check: () => Promise<T | undefined | false> | T | undefined | false, what: string, limit_ms = 60_000): Promise<T> {
  const end_ms = performance.now() + limit_ms;
  for (;;) {
    const found = await check();
    if (found !== undefined && found !== false) return found;
    if (performance.now() > end_ms) throw new Error(`waited in vain: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
}
