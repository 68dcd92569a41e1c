// Files that a user uploads, and what a course's card says.
import { expect, it } from 'vitest';
import { facts, kindOf, nameOf, type CourseEntry } from '../../../daemon/web/state/setup.ts';

it('a file is a robot by the tables that no course has, and gets a name that the daemon accepts', () => {
  expect(kindOf('[shape]\nlength_m = 0.2\n[emulated.body]\n')).toBe('robot');
  // A course may bring its robot.
  for (const course of ['speed_mps = 0.1\n[[segment]]\ntype = "line"\n', '[[segment]]\ntype = "line"\n[model]\nslip_left = 0.1\n', '']) expect(kindOf(course)).toBe('course');
  expect(['my bend.toml', '../.Über%2f.TOML'].map(nameOf)).toEqual(['my-bend', 'ber-2f']);
  expect(nameOf(`${'x'.repeat(99)}.toml`)).toHaveLength(64);
});

it('a card says how long a course is and what lies on it', () => {
  const course = { name: '3', from: 'bundled', in_force: false, why_not: '', length_m: 4.057, duration_s: 42.4, ramps: [{}], blocks: [{}, {}], surfaces: [] } as unknown as CourseEntry;
  expect(facts(course).replaceAll(' \u00b7 ', ', ')).toBe('4.06 m, 42 s, 1 ramp, 2 blocks');
});
