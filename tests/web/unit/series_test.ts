// What the page keeps of the past: always bounded, and the whole of it.
import { describe, expect, it } from 'vitest';
import { Thinned } from '../../../daemon/web/replay/thinned.ts';
import { PathHistory } from '../../../daemon/web/state/path_history.ts';
import { Series } from '../../../daemon/web/state/series.ts';

describe('a series', () => {
  const column = (series: Series, index = 0, since = -Infinity): number[] => [...(series.since(since)[index] ?? [])];

  it('keeps the newest rows, in order, however many come', () => {
    const series = new Series(2, 100);
    for (let i = 0; i < 1234; i++) series.push([i, 10 * i]);
    expect(column(series)).toEqual(Array.from({ length: 100 }, (_, i) => 1134 + i));
    expect(column(series, 1)[99]).toBe(12330);
  });

  it('gives the rows since a time, and one before', () => {
    const series = new Series(1, 50);
    for (let i = 0; i < 20; i++) series.push([i]);
    expect(column(series, 0, 15)).toEqual([14, 15, 16, 17, 18, 19]);
    expect(column(series, 0, 100)).toEqual([19]);
    expect(column(series, 0, -5).length).toBe(20);
  });

  it('leaves out rows that follow too closely, and starts anew when time goes back', () => {
    const series = new Series(1, 50, 0.0199);
    for (let i = 0; i < 100; i++) series.push([i * 0.005]);
    expect(series.length).toBe(25);
    series.push([0.1]);
    expect(column(series)).toEqual([0.1]);
  });

  it('shows a missing value as a gap, and takes rows from before what is there', () => {
    const series = new Series(2, 4);
    series.before([[1, 10]]);
    expect(series.length).toBe(1);
    for (const t_s of [5, 6]) series.push([t_s, 10 * t_s]);
    series.before([[0, 0], [1, 0], [9, 0]]);
    expect(column(series, 1)).toEqual([0, 10, 50, 60]);
    series.push([7]);
    expect(column(series, 1)).toEqual([10, 50, 60, NaN]);
  });
});

describe('a path', () => {
  it('keeps points at least its spacing apart, and none that is not a place', () => {
    const path = new PathHistory(100, 0.01);
    for (let i = 0; i < 1000; i++) path.add(i * 0.001, 0, 0);
    path.add(NaN, 0, 0);
    path.add(0, Infinity, 0);
    expect([path.length, path.generation]).toEqual([100, 0]);
  });

  it('never holds more than its capacity, still covers the whole way, and is fine after it was cleared', () => {
    const path = new PathHistory(64, 0.01);
    for (let i = 0; i <= 5000; i++) path.add(i * 0.01, 0, 1);
    const points = path.coordinates;
    expect(points.length / 3).toBe(path.length);
    expect(path.length).toBeLessThanOrEqual(64);
    expect(points[0]).toBe(0);
    expect(points.at(-3)).toBeGreaterThan(48);
    expect(path.generation).toBeGreaterThan(0);
    for (let i = 3; i < points.length; i += 3) expect(points[i]).toBeGreaterThan(points[i - 3] ?? Infinity);
    path.clear();
    path.add(0, 0, 0);
    path.add(0.011, 0, 0);
    expect(path.length).toBe(2);
  });
});

describe('a thinned recording', () => {
  it('never holds more than its capacity, and covers everything', () => {
    const thinned = new Thinned<number>(100, 0.01);
    for (let i = 0; i < 100_000; i++) thinned.add(i * 0.01, i);
    expect(thinned.items.length).toBeLessThanOrEqual(100);
    expect(thinned.items.length).toBeGreaterThan(40);
    expect(thinned.items[0]?.item).toBe(0);
    expect(thinned.items.at(-1)?.item).toBeGreaterThan(97_000);
  });

  it('keeps a burst within bounds too', () => {
    const thinned = new Thinned<number>(10, 0);
    for (let i = 0; i < 1000; i++) thinned.add(5, i);
    expect(thinned.items.length).toBeLessThanOrEqual(10);
  });
});
