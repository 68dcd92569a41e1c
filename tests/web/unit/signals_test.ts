// Signals of any channel: their names, units and values, what is kept of them, and the table that is saved.
import { describe, expect, it } from 'vitest';
import { csv, fieldsOf, Signals, topicOf, unitOf, valueOf } from '../../../daemon/web/state/signals.ts';

describe('fields of a message', () => {
  const message = { t_s: 3, model: { x_m: 1.5, deep: { er: { still: 1 } } }, gyro_radps: [0.1, 0.2, 0.3], on: true, name: 'x', none: null, path: [1, 2, 3, 4, 5] };

  it('are its numbers and truths, also in tables and short lists, but not its time', () => {
    expect(fieldsOf('/a', message)).toEqual(['/a.model.x_m', '/a.model.deep.er.still', '/a.gyro_radps.0', '/a.gyro_radps.1', '/a.gyro_radps.2', '/a.on']);
  });

  it('have values; what is not there is not a number', () => {
    expect([valueOf('/a.gyro_radps.2', message), valueOf('/a.on', message)]).toEqual([0.3, 1]);
    for (const name of ['/a.none', '/a.name', '/a.model', '/a.model.y_m', '/a.x.y', '/a.constructor.length', '/a']) expect(valueOf(name, message)).toBeNaN();
  });

  it('have the unit of their name', () => {
    const names = ['/sample.gyro_radps.2', '/loop.work_us.p99', '/loop.work_us.count', '/estimate.model.x_m', '/link.counters.lost'];
    expect(names.map(unitOf)).toEqual(['rad/s', 'µs', '', 'm', '']);
    expect(topicOf('/estimate.model.x_m')).toBe('/estimate');
  });
});

describe('chosen signals', () => {
  const slip = (t_s: number): object => ({ t_s, left: 10 * t_s });

  it('take what comes and what was before, in order, and nothing of other channels', () => {
    const signals = new Signals();
    signals.choose('/slip.left');
    for (const t_s of [10, 11]) signals.receive('/slip', slip(t_s));
    signals.receive('/event', slip(12));
    signals.receive('/slip', { left: 1 });
    signals.before('/slip.left', [slip(8), slip(9), slip(10), slip(12)]);
    expect(signals.fields).toEqual(['/slip.left']);
    expect(signals.of('/slip.left')?.since(0).map((column) => [...column])).toEqual([[8, 9, 10, 11], [80, 90, 100, 110]]);
    signals.drop('/slip.left');
    expect(signals.names).toEqual([]);
  });
});

it('a table of signals has a row for each time and gaps where there is no value', () => {
  const of = (...values: number[]): Float64Array => Float64Array.from(values);
  expect(csv([{ name: '/a.x', times: of(1, 2), values: of(0.5, NaN) }, { name: '/b.y', times: of(1.5, 2), values: of(7, 8) }])).toBe(
    't_s,/a.x,/b.y\n1.000000,0.5,\n1.500000,,7\n2.000000,,8\n',
  );
});
