// Opens a report in a browser without a network: the replay must draw, without requests and without errors.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';

const program = (name) => join(process.env.TP100_BIN, name);
const chromium = process.env.TP100_CHROMIUM ?? '/usr/bin/chromium-headless-shell';

test('the report of an emulated run', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'tp100-npm-'));
  try {
    execFileSync(program('tp100-sim'), ['course', '1-straight', '--record', folder, '--json']);
    const run = join(folder, '1-straight-end-loaded-1');
    execFileSync(program('tp100d'), ['report', run]);
    const metrics = JSON.parse(await readFile(join(run, 'metrics.json'), 'utf8'));
    assert.equal(metrics.completed, true);

    const shown = spawnSync(chromium, ['--headless', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage',
      '--disable-background-networking', '--no-first-run', `--user-data-dir=${join(folder, 'browser')}`, '--enable-logging=stderr',
      '--virtual-time-budget=2000', '--dump-dom', `file://${join(run, 'report.html')}`], { encoding: 'utf8', timeout: 60000 });
    assert.equal(shown.status, 0, shown.stderr);
    assert.doesNotMatch(shown.stderr, /CONSOLE/);
    // The replay begins at the end of the run, as its clock shows.
    const clock = /<output>([0-9.]+) s<\/output>/.exec(shown.stdout);
    assert.ok(clock, 'the clock of the replay is set');
    assert.ok(Math.abs(Number(clock[1]) - metrics.duration_s) < 0.2, `${clock[1]} s of ${metrics.duration_s} s`);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
});
