// The packages under test, from the folder into which `install` put them.
import { createRequire } from 'node:module';
import { join } from 'node:path';

/** Loads a package by name. */
export const load = createRequire(join(process.env.TP100_NPM, 'packages.cjs'));
