// The tests must use the package versions that package.json requires.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import test from 'node:test';
import { load } from './packages.mjs';

test('every package loads in the version that package.json asks for', async () => {
  const wanted = JSON.parse(await readFile(new URL('package.json', import.meta.url), 'utf8'));
  for (const [name, version] of Object.entries(wanted.dependencies)) {
    assert.ok(load(name), name);
    const installed = JSON.parse(
      await readFile(`${process.env.TP100_NPM}/node_modules/${name}/package.json`, 'utf8'));
    assert.equal(installed.version, version);
  }
});
