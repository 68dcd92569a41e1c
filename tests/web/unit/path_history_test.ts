import { describe, expect, it } from 'vitest';
import { PathHistory } from '../../../daemon/web/state/path_history.ts';

describe('PathHistory', () => {
  it('keeps points at least its spacing apart', () => {
    const path_history = new PathHistory(100, 0.01);
    for (let i = 0; i < 1000; i++) path_history.add(i * 0.001, 0, 0);
    expect(path_history.length).toBe(100);
    expect(path_history.generation).toBe(0);
  });

  it('never holds more than its capacity, and still covers the whole way', () => {
    const path_history = new PathHistory(64, 0.01);
    for (let i = 0; i <= 5000; i++) path_history.add(i * 0.01, 0, 1);
    const points = path_history.coordinates;
    expect(points.length / 3).toBe(path_history.length);
    expect(path_history.length).toBeLessThanOrEqual(64);
    expect(points[0]).toBe(0);
    expect(points.at(-3)).toBeGreaterThan(48);
    expect(path_history.generation).toBeGreaterThan(0);
    for (let i = 3; i < points.length; i += 3) expect(points[i]).toBeGreaterThan(points[i - 3] ?? Infinity);
  });

  it('takes no point that is not a place', () => {
    const path_history = new PathHistory();
    path_history.add(NaN, 0, 0);
    path_history.add(0, Infinity, 0);
    expect(path_history.length).toBe(0);
  });

  it('is fine again after it was cleared', () => {
    const path_history = new PathHistory(8, 0.01);
    for (let i = 0; i < 100; i++) path_history.add(i, 0, 0);
    path_history.clear();
    path_history.add(0, 0, 0);
    path_history.add(0.011, 0, 0);
    expect(path_history.length).toBe(2);
  });
});
