// What the page keeps of the past: always bounded, and the whole of it.
import { describe, expect, it } from 'vitest';
import { Thinned } from '../../../daemon/web/replay/recording.ts';
import { PathHistory, Series } from '../../../daemon/web/state/series.ts';

describe('a series', () => {
  const column = (series: Series, index = 0, since = -Infinity): number[] => [...(series.since(since)[index] ?? [])];

  it('keeps the newest rows, in order, however many come', () => {
    const series = new Series(2, 100);
    for (let i = 0; i < 1234; i++) series.push([i, 10 * i]);
    expect(column(series)).toEqual(Array.from({ length: 100 }, (_, i) => 1134 + i));
    expect(column(series, 1)[99]).toBe(12330);
    expect(column(series, 0, 1230), 'and one before').toEqual([1229, 1230, 1231, 1232, 1233]);
    expect(column(series, 0, 5000)).toEqual([1233]);
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
    for (const t_s of [5, 6]) series.push([t_s, 10 * t_s]);
    series.before([[0, 0], [1, 0], [9, 0]]);
    expect(column(series, 1)).toEqual([0, 0, 50, 60]);
    series.push([7]);
    expect(column(series, 1)).toEqual([0, 50, 60, NaN]);
  });
});

it('a path keeps points at least its spacing apart, never more than its capacity, and still covers the whole way', () => {
  const path = new PathHistory(64, 0.01);
  for (let i = 0; i < 640; i++) path.add(i * 0.001, 0, 0);
  path.add(NaN, 0, 0);
  path.add(0, Infinity, 0);
  expect([path.length, path.generation]).toEqual([64, 0]);
  for (let i = 64; i <= 5000; i++) path.add(i * 0.01, 0, 1);
  const points = path.coordinates;
  expect(points.length / 3).toBe(path.length);
  expect(path.length).toBeLessThanOrEqual(64);
  expect(points[0]).toBe(0);
  expect(points.at(-3)).toBeGreaterThan(48);
  expect(path.generation).toBeGreaterThan(0);
  for (let i = 3; i < points.length; i += 3) expect(points[i]).toBeGreaterThan(points[i - 3] ?? Infinity);
  path.clear();
  for (const x_m of [0, 0.011]) path.add(x_m, 0, 0);
  expect(path.length, 'the first spacing again').toBe(2);
});

it('a thinned recording never holds more than its capacity, also of a burst, and covers everything', () => {
  const thinned = new Thinned(100, 0.01);
  for (let i = 0; i < 100_000; i++) thinned.add({ time_s: i * 0.01 });
  expect(thinned.items.length).toBeLessThanOrEqual(100);
  expect(thinned.items.length).toBeGreaterThan(40);
  expect(thinned.items[0]?.time_s).toBe(0);
  expect(thinned.items.at(-1)?.time_s).toBeGreaterThan(970);
  const burst = new Thinned(10, 0);
  for (let i = 0; i < 1000; i++) burst.add({ time_s: 5 });
  expect(burst.items.length).toBeLessThanOrEqual(10);
});
