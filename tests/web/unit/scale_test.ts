import { describe, expect, it } from 'vitest';
import { extent, niceRange, niceStep } from '../../../daemon/web/state/scale.ts';

describe('niceStep', () => {
  it('is one of a few round numbers, never below what was asked', () => {
    for (let value = 1e-4; value < 1e4; value *= 1.13) {
      const step = niceStep(value);
      const digits = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
      expect([1, 2, 2.5, 5].some((nice) => Math.abs(nice - digits) < 1e-6)).toBe(true);
      expect(step).toBeGreaterThanOrEqual(value * (1 - 1e-9));
      expect(step).toBeLessThanOrEqual(value * 2.5001);
    }
  });
});

describe('niceRange', () => {
  it('covers the data and never less than it is asked to', () => {
    for (const [low, high] of [[-3, 17], [0.1, 0.11], [-200, -190], [NaN, NaN], [Infinity, -Infinity]] as const) {
      const [from, to] = niceRange(low, high, [-5, 5]);
      expect(from).toBeLessThanOrEqual(Math.min(-5, Number.isFinite(low) ? low : -5));
      expect(to).toBeGreaterThanOrEqual(Math.max(5, Number.isFinite(high) ? high : 5));
    }
  });

  it('does not move with every sample', () => {
    const first = niceRange(-1, 9.1, [0, 5]);
    expect(niceRange(-1.01, 9.2, [0, 5])).toEqual(first);
  });
});

it('extent leaves gaps out', () => {
  expect(extent([new Float64Array([1, NaN, 5]), new Float64Array([NaN, -2])])).toEqual([-2, 5]);
  expect(extent([])).toEqual([Infinity, -Infinity]);
});
