import { describe, expect, it } from 'vitest';
import { Series } from '../../../daemon/web/state/series.ts';

describe('Series', () => {
  it('keeps the newest rows, in order, however many come', () => {
    const series = new Series(2, 100);
    for (let i = 0; i < 1234; i++) series.push([i, 10 * i]);
    expect(series.length).toBe(100);
    const [times, values] = series.since(-Infinity);
    expect(Array.from(times ?? [])).toEqual(Array.from({ length: 100 }, (_, i) => 1134 + i));
    expect(values?.[99]).toBe(12330);
  });

  it('gives the rows since a time, and one before', () => {
    const series = new Series(1, 50);
    for (let i = 0; i < 20; i++) series.push([i]);
    expect(Array.from(series.since(15)[0] ?? [])).toEqual([14, 15, 16, 17, 18, 19]);
    expect(series.since(100)[0]?.length).toBe(1);
    expect(series.since(-5)[0]?.length).toBe(20);
  });

  it('leaves out rows that follow too closely', () => {
    const series = new Series(1, 50, 0.0199);
    for (let i = 0; i < 100; i++) series.push([i * 0.005]);
    expect(series.length).toBe(25);
  });

  it('starts anew when time goes back', () => {
    const series = new Series(1, 50);
    series.push([5]);
    series.push([6]);
    series.push([1]);
    expect(Array.from(series.since(0)[0] ?? [])).toEqual([1]);
  });

  it('shows a missing value as a gap', () => {
    const series = new Series(2, 5);
    series.push([1]);
    expect(series.since(0)[1]?.[0]).toBeNaN();
  });

  it('takes rows from before what is there, and leaves out later ones', () => {
    const series = new Series(2, 4);
    for (const t_s of [5, 6]) series.push([t_s, 10 * t_s]);
    series.before([[1, 10], [3, 30], [5, 0], [9, 0]]);
    expect([...(series.since(-Infinity)[1] ?? [])]).toEqual([10, 30, 50, 60]);
    const empty = new Series(2, 4);
    empty.before([[1, 10]]);
    expect(empty.length).toBe(1);
  });
});
