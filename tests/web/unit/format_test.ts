// Figures as the page shows them: numbers with their units, and axes.
import { expect, it } from 'vitest';
import * as format from '../../../daemon/web/state/format.ts';
import { extent, niceRange } from '../../../daemon/web/state/series.ts';

it('figures have a true minus sign, never minus zero, a dash for what is not known, and the unit that fits', () => {
  expect([-1.25, -0.001, null, NaN, Infinity].map((value) => format.fixed(value, 1))).toEqual(['\u22121.3', '0.0', '\u2013', '\u2013', '\u2013']);
  expect([format.degrees(Math.PI / 2, 1), format.millimetres(0.0123, 1), format.percent(0.1188, 1)]).toEqual(['90.0', '12.3', '11.9']);
  expect([7, 1234, 56_789, 3_400_000].map(format.duration)).toEqual(['7 µs', '1.2 ms', '57 ms', '3.4 s']);
  expect([-1, 62.34, 59.999, 3723].map(format.clock)).toEqual(['\u2013', '1:02.3', '0:59.9', '1:02:03']);
  expect([12, 12_345, 123_456_789].map(format.bytes)).toEqual(['12 B', '12.3 kB', '123 MB']);
  expect(format.count(1234567)).toBe('1\u2009234\u2009567');
});

it('an axis covers the data closely and never less than it is asked to, and does not move with every sample', () => {
  for (let value = 1e-4; value < 1e4; value *= 1.13) {
    const [from, to] = niceRange(0, value, [0, 0]);
    expect(from).toBeCloseTo(0, 9);
    expect(to / value).toBeGreaterThanOrEqual(1 - 1e-6);
    expect(to / value).toBeLessThan(1.65);
    expect(Number(to.toPrecision(3)), 'an end at a round number').toBeCloseTo(to, 9);
  }
  for (const [low, high] of [[-3, 17], [0.1, 0.11], [-200, -190], [NaN, NaN], [Infinity, -Infinity]] as const) {
    const [from, to] = niceRange(low, high, [-5, 5]);
    expect(from).toBeLessThanOrEqual(Math.min(-5, Number.isFinite(low) ? low : -5));
    expect(to).toBeGreaterThanOrEqual(Math.max(5, Number.isFinite(high) ? high : 5));
  }
  expect(niceRange(-1.01, 9.2, [0, 5])).toEqual(niceRange(-1, 9.1, [0, 5]));
  expect(extent([new Float64Array([1, NaN, 5]), new Float64Array([NaN, -2])]), 'gaps are left out').toEqual([-2, 5]);
});
