// The two real programs, connected by a pseudo-terminal, for the duration of a test.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

const bin = process.env.TP100_BIN;

/** Resolves with the first match of `pattern` in the lines of `stream`. */
function line(stream, pattern, who) {
  return new Promise((resolve, reject) => {
    const seen = [];
    const reader = createInterface({ input: stream });
    reader.on('line', (text) => {
      seen.push(text);
      const match = pattern.exec(text);
      if (match) resolve(match);
    });
    reader.on('close', () => reject(new Error(`${who} ended without ${pattern}:\n${seen.join('\n')}`)));
  });
}

/** Starts an emulated robot and tp100d. `url` is the page's address; `end()` stops both programs and removes all files. */
export async function startPair({ course = '1-straight', options = [] } = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'tp100-npm-'));
  // Scheduling is ordinary because other tests run on the machine at the same time.
  await writeFile(join(folder, 'tp100.toml'),
    '[loop]\npriority = 0\nlock_memory = false\nspin_us = 0\nhold_cpu_latency = false\n');
  const link = join(folder, 'robot');
  const robot = spawn(join(bin, 'tp100-sim'), ['robot', '--link', link], { stdio: 'ignore' });
  const daemon = spawn(join(bin, 'tp100d'),
    ['run', '--config', join(folder, 'tp100.toml'), '--port', link, '--wait', '--stay',
      '--listen', '127.0.0.1:0', ...(course ? ['--course', course] : []), ...options],
    { stdio: ['ignore', 'ignore', 'pipe'] });
  const [, url] = await line(daemon.stderr, /page: (\S+)/, 'tp100d');
  const stop = async (child) => {
    if (child.exitCode !== null || child.signalCode !== null) return;
    child.kill('SIGTERM');
    await once(child, 'exit');
  };
  return {
    url,
    robot,
    daemon,
    async end() {
      await stop(daemon);
      await stop(robot);
      await rm(folder, { recursive: true, force: true });
    },
  };
}
