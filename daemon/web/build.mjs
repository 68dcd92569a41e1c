// Bundles the page into dist/, the folder that CMake embeds. The same sources and lock file give
// the same bytes. `node build.mjs OUT` writes elsewhere, to compare.
import { build } from 'esbuild';
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';

const here = import.meta.dirname ?? new URL('.', import.meta.url).pathname;
const out = process.argv[2] ?? join(here, 'dist');

await rm(out, { recursive: true, force: true });
await mkdir(out, { recursive: true });
const common = {
  absWorkingDir: here,
  outdir: out,
  bundle: true,
  minify: true,
  format: 'esm',
  target: ['chrome100', 'firefox100', 'safari15'],
  charset: 'utf8',
  legalComments: 'none',
  loader: { '.woff2': 'file' },
  assetNames: '[name]',
  logLevel: 'warning',
};
// The 3-D scene is loaded when it is shown.
await build({ ...common, entryPoints: { cockpit: 'page/main.ts' }, splitting: true, chunkNames: '[name]-[hash]' });
await build({ ...common, entryPoints: { robots: 'page/robots.ts' } });
await copyFile(join(here, 'page/favicon.svg'), join(out, 'favicon.svg'));
const frame = await readFile(join(here, 'page/frame.html'), 'utf8');
for (const [file, name, title] of [['index', 'cockpit', 'TP100'], ['robots', 'robots', 'Robots \u00b7 TP100']]) {
  await writeFile(join(out, `${file}.html`), frame.replaceAll('NAME', name).replace('TITLE', title));
}

const parts = ['three', 'uplot', 'fzstd', 'toml-eslint-parser', '@fontsource/b612'];
let licences = 'The cockpit page contains these works.\n';
for (const part of parts) {
  const folder = join(here, 'node_modules', part);
  const { name, version } = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8'));
  const text = (await readFile(join(folder, 'LICENSE'), 'utf8')).replaceAll('\r', '').trim();
  licences += `\n== ${name} ${version} ==\n\n${text}\n`;
}
await writeFile(join(out, 'licences.txt'), licences);
