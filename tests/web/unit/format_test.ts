import { describe, expect, it } from 'vitest';
import * as format from '../../../daemon/web/state/format.ts';

describe('fixed', () => {
  it('has a true minus sign and never minus zero', () => {
    expect(format.fixed(-1.25, 1)).toBe('\u22121.3');
    expect(format.fixed(-0.001, 2)).toBe('0.00');
    expect(format.fixed(-0, 0)).toBe('0');
  });

  it.each([null, undefined, NaN, Infinity])('shows %s as a dash', (value) => {
    expect(format.fixed(value, 2)).toBe('\u2013');
  });
});

it('turns units', () => {
  expect(format.degrees(Math.PI / 2, 1)).toBe('90.0');
  expect(format.millimetres(0.0123, 1)).toBe('12.3');
  expect(format.percent(0.1188, 1)).toBe('11.9');
  expect(format.degrees(null, 1)).toBe('\u2013');
});

it('prints durations in fitting units', () => {
  expect(format.duration(7)).toBe('7 µs');
  expect(format.duration(1234)).toBe('1.2 ms');
  expect(format.duration(56_789)).toBe('57 ms');
  expect(format.duration(3_400_000)).toBe('3.4 s');
});

it('prints clocks', () => {
  expect(format.clock(0)).toBe('0:00.0');
  expect(format.clock(62.34)).toBe('1:02.3');
  expect(format.clock(59.999)).toBe('0:59.9');
  expect(format.clock(3723)).toBe('1:02:03');
  expect(format.clock(-1)).toBe('\u2013');
});

it('prints sizes and counts', () => {
  expect(format.bytes(12)).toBe('12 B');
  expect(format.bytes(12_345)).toBe('12.3 kB');
  expect(format.bytes(123_456_789)).toBe('123 MB');
  expect(format.count(1234567)).toBe('1\u2009234\u2009567');
  expect(format.count(12)).toBe('12');
});
