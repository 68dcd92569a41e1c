// The two real programs, connected by a pseudo-terminal, for the duration of a test.
import { spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

/** The folder of the programs. */
export const bin = process.env.TP100_BIN ?? '';
/**
 * Course 3 at a high speed: on a busy machine the kernel sometimes holds back bytes of a pseudo-terminal for longer than the
 * command time-out of the robot. A short run is more likely to fall between two such delays.
 */
const kSpeed_mps = 0.18;
const kCourse3 = new URL('../../../config/courses/3.toml', import.meta.url);

/** One of our programs and its output. */
export class Program {
  readonly lines: string[] = [];
  private readonly child: ChildProcess;
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
      createInterface({ input: stream }).on('line', (line) => this.lines.push(line));
    }
    this.child.on('close', () => {
      this.gone = true;
    });
  }

  /** The first match in its output, from line `from` on. */
  async line(pattern: RegExp, from = 0): Promise<RegExpExecArray> {
    for (;;) {
      const gone = this.gone;
      for (const line of this.lines.slice(from)) {
        const match = pattern.exec(line);
        if (match !== null) return match;
      }
      if (gone) throw new Error(`${this.name} ended without ${String(pattern)}:\n${this.lines.join('\n')}`);
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  }

  get pid(): number {
    return this.child.pid ?? 0;
  }

  freeze(): void {
    this.child.kill('SIGSTOP');
  }

  thaw(): void {
    this.child.kill('SIGCONT');
  }

  async end(signal: NodeJS.Signals = 'SIGTERM'): Promise<void> {
    if (this.gone) return;
    const exited = once(this.child, 'close');
    this.child.kill('SIGCONT');
    this.child.kill(signal);
    await exited;
  }
}

/** A port that is free at present. */
export async function freePort(): Promise<number> {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const address = server.address();
  server.close();
  await once(server, 'close');
  return typeof address === 'object' && address !== null ? address.port : 0;
}

/** An emulated robot and the daemon that controls it. */
export class Pair {
  url = '';
  private constructor(
    readonly folder: string,
    readonly robot: Program,
    public daemon: Program,
  ) {}

  /** `options`: of the daemon, by the folder of the pair; `configuration`: more of its configuration file. */
  static async start(options: (folder: string) => string[], configuration = '', listen = '127.0.0.1:0'): Promise<Pair> {
    const folder = await mkdtemp(join(tmpdir(), 'tp100-web-'));
    // Scheduling is real-time where allowed, as for users: a browser that draws without a graphics card leaves no
    // processor free. The other settings only matter for measurements of latency.
    await writeFile(join(folder, 'tp100.toml'), `library = "${folder}/library"\n[loop]\nlock_memory = false\nspin_us = 0\nhold_cpu_latency = false\n${configuration}`);
    const course = (await readFile(kCourse3, 'utf8')).replace(/^speed_mps = .*$/m, `speed_mps = ${kSpeed_mps}`);
    await writeFile(join(folder, '3.toml'), course);
    const robot = new Program('tp100-sim', ['robot', '--link', join(folder, 'robot'), '--course', join(folder, '3.toml')]);
    await robot.line(/linked from/);
    const pair = new Pair(folder, robot, Pair.daemon(folder, options(folder), listen));
    await pair.ready();
    return pair;
  }

  /** Starts another daemon with the address of one that has ended. */
  async restart(): Promise<void> {
    const { host } = new URL(this.url);
    this.daemon = Pair.daemon(this.folder, [], host);
    await this.ready();
  }

  async end(): Promise<void> {
    await this.daemon.end();
    await this.robot.end();
    await rm(this.folder, { recursive: true, force: true });
  }

  /** The output of both programs, to find the reason of a failure. */
  get said(): string {
    return ['tp100d:', ...this.daemon.lines, 'tp100-sim:', ...this.robot.lines].join('\n');
  }

  private static daemon(folder: string, options: string[], listen: string): Program {
    const config = join(folder, 'tp100.toml');
    const fixed = ['--config', config, '--port', join(folder, 'robot'), '--wait', '--stay', '--listen', listen];
    return new Program('tp100d', ['run', ...fixed, '--course', join(folder, '3.toml'), ...options]);
  }

  private async ready(): Promise<void> {
    this.url = (await this.daemon.line(/page: (\S+)/))[1] ?? '';
  }
}
