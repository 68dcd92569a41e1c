import { describe, expect, it } from 'vitest';
import { Trail } from '../../../daemon/web/state/trail.ts';

describe('Trail', () => {
  it('keeps points at least its spacing apart', () => {
    const trail = new Trail(100, 0.01);
    for (let i = 0; i < 1000; i++) trail.add(i * 0.001, 0, 0);
    expect(trail.length).toBe(100);
    expect(trail.generation).toBe(0);
  });

  it('never holds more than its capacity, and still covers the whole way', () => {
    const trail = new Trail(64, 0.01);
    for (let i = 0; i <= 5000; i++) trail.add(i * 0.01, 0, 1);
    const points = trail.coordinates;
    expect(points.length / 3).toBe(trail.length);
    expect(trail.length).toBeLessThanOrEqual(64);
    expect(points[0]).toBe(0);
    expect(points.at(-3)).toBeGreaterThan(48);
    expect(trail.generation).toBeGreaterThan(0);
    for (let i = 3; i < points.length; i += 3) expect(points[i]).toBeGreaterThan(points[i - 3] ?? Infinity);
  });

  it('takes no point that is not a place', () => {
    const trail = new Trail();
    trail.add(NaN, 0, 0);
    trail.add(0, Infinity, 0);
    expect(trail.length).toBe(0);
  });

  it('is fine again after it was cleared', () => {
    const trail = new Trail(8, 0.01);
    for (let i = 0; i < 100; i++) trail.add(i, 0, 0);
    trail.clear();
    trail.add(0, 0, 0);
    trail.add(0.011, 0, 0);
    expect(trail.length).toBe(2);
  });
});
