// The real programs: an emulated robot and daemons. They do not outlive the test, however it ends.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

export const program = (name) => join(process.env.TP100_BIN, name);

/** Like spawn; the program is killed when this one ends. */
export const start = (command, options, settings) => spawn('setpriv', ['--pdeathsig', 'KILL', command, ...options], settings);

export const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

/** Waits until the condition holds, and returns its value. */
export async function until(condition) {
  for (;;) {
    const found = condition();
    if (found) return found;
    // It does not keep a test alive whose programs have all ended.
    await new Promise((resolve) => { setTimeout(resolve, 20).unref(); });
  }
}

/** Calls `work` with the name of a folder that exists until then. */
export async function inFolder(work) {
  const folder = await mkdtemp(join(tmpdir(), 'tp100-npm-'));
  try {
    return await work(folder);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

/** A file in `folder` with a course that is a line of this length. */
export async function lineCourse(folder, length_m, speed_mps = 0.1) {
  const file = join(folder, 'line.toml');
  await writeFile(file, `description = "line"\nspeed_mps = ${speed_mps}\n[[segment]]\ntype = "line"\nlength_m = ${length_m}\n`
    + `[fence]\nmin_x_m = -1.0\nmax_x_m = ${length_m + 1}\nmin_y_m = -1.0\nmax_y_m = 1.0\n`);
  return file;
}

/** Settings of [loop] with which other programs can run at the same time. */
export const ordinary = 'priority = 0\nlock_memory = false\nspin_us = 0\nhold_cpu_latency = false';

/** An emulated robot with these options, for daemons that `work` starts. */
export const withRobot = (work, more = []) => inFolder(async (folder) => {
  const port = join(folder, 'port');
  const env = { ...process.env, ROS_DOMAIN_ID: '42' };
  const robot = start(program('tp100-sim'), ['robot', '--link', port, ...more], { stdio: ['ignore', 'pipe', 'inherit'], env });
  const running = [];
  try {
    await once(robot.stdout, 'data');
    await work({
      folder,
      /** A daemon with these lines of configuration and variables; `said(pattern)` waits for a line of its log. */
      async daemon(configuration, options, loop = ordinary, variables = {}) {
        const file = join(folder, `${running.length}.toml`);
        await writeFile(file, `[loop]\n${loop}\n${configuration}\n`);
        const listen = options.includes('--listen') ? [] : ['--listen', 'off'];
        const child = start(program('tp100d'), ['run', '--config', file, '--port', port, ...listen, ...options],
          { stdio: ['ignore', 'ignore', 'pipe'], env: { ...env, ...variables } });
        running.push(child);
        const lines = [];
        let ended = false;
        createInterface({ input: child.stderr }).on('line', (line) => {
          lines.push(line);
          // On a busy machine a run may be aborted; the daemon would then wait for another start.
          if (/state: running -> aborted/.test(line) && !options.includes('--stay')) child.kill('SIGTERM');
        }).on('close', () => { ended = true; });
        const exit = once(child, 'exit');
        const said = (pattern) => until(() => {
          const found = lines.some((line) => pattern.test(line));
          assert.ok(found || !ended, `tp100d ended without ${pattern}:\n${lines.join('\n')}`);
          return found;
        });
        return { child, exit, said, lines };
      },
    });
  } finally {
    for (const child of [...running, robot]) child.kill('SIGKILL');
  }
});
