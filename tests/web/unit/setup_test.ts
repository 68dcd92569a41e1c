// Files that a user uploads.
import { expect, it } from 'vitest';
import { kindOf, nameOf } from '../../../daemon/web/state/setup.ts';

it('a file is a robot by the tables that no course has, and gets a name that the daemon accepts', () => {
  expect(kindOf('[shape]\nlength_m = 0.2\n[emulated.body]\n')).toBe('robot');
  // A course may bring its robot.
  for (const course of ['speed_mps = 0.1\n[[segment]]\ntype = "line"\n', '[[segment]]\ntype = "line"\n[model]\nslip_left = 0.1\n', '']) expect(kindOf(course)).toBe('course');
  expect(['my bend.toml', '../.Über%2f.TOML'].map(nameOf)).toEqual(['my-bend', 'ber-2f']);
  expect(nameOf(`${'x'.repeat(99)}.toml`)).toHaveLength(64);
});
