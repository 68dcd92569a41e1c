import { describe, expect, it } from 'vitest';
import { facts, kindOf, nameOf, type CourseEntry } from '../../../daemon/web/state/setup.ts';

describe('a file that the user uploads', () => {
  it('is a robot by the tables that no course has, and otherwise a course, which may bring its robot', () => {
    expect(kindOf('[shape]\nlength_m = 0.2\n[emulated.body]\n')).toBe('robot');
    expect(kindOf('speed_mps = 0.1\n[[segment]]\ntype = "line"\n')).toBe('course');
    expect(kindOf('[[segment]]\ntype = "line"\n[model]\nslip_left = 0.1\n')).toBe('course');
    expect(kindOf('')).toBe('course');
  });

  it('gets a name that the daemon accepts', () => {
    expect(nameOf('my bend.toml')).toBe('my-bend');
    expect(nameOf('../.Über%2f.TOML')).toBe('ber-2f');
    expect(nameOf(`${'x'.repeat(99)}.toml`)).toHaveLength(64);
  });
});

it('a card says how long a course is and what lies on it', () => {
  const course = { name: '3', from: 'bundled', in_force: false, why_not: '', length_m: 4.057, duration_s: 42.4, ramps: [{}], blocks: [{}, {}], surfaces: [] } as unknown as CourseEntry;
  expect(facts(course).replaceAll(' \u00b7 ', ', ')).toBe('4.06 m, 42 s, 1 ramp, 2 blocks');
  expect(facts({ ...course, length_m: undefined } as unknown as CourseEntry)).toBe('');
});
