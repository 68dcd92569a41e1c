import { describe, expect, it } from 'vitest';
import { csv, fieldsOf, search, Signals, topicOf, unitOf, valueOf } from '../../../daemon/web/state/signals.ts';

const message = { t_s: 3, model: { x_m: 1.5, deep: { er: { still: 1 } } }, gyro_radps: [0.1, 0.2, 0.3], on: true, name: 'x', none: null, path: [1, 2, 3, 4, 5] };

describe('fields of a message', () => {
  it('are its numbers and truths, also in tables and short lists, but not its time', () => {
    expect(fieldsOf('/a', message)).toEqual(['/a.model.x_m', '/a.model.deep.er.still', '/a.gyro_radps.0', '/a.gyro_radps.1', '/a.gyro_radps.2', '/a.on']);
  });

  it('have values; what is not there is not a number', () => {
    expect(valueOf('/a.gyro_radps.2', message)).toBe(0.3);
    expect(valueOf('/a.on', message)).toBe(1);
    for (const name of ['/a.none', '/a.name', '/a.model', '/a.model.y_m', '/a.x.y', '/a.constructor.length', '/a']) expect(valueOf(name, message)).toBeNaN();
  });

  it('have the unit of their name', () => {
    expect(unitOf('/sample.gyro_radps.2')).toBe('rad/s');
    expect(unitOf('/loop.work_us.p99')).toBe('µs');
    expect(unitOf('/loop.work_us.count')).toBe('');
    expect(unitOf('/estimate.model.x_m')).toBe('m');
    expect(unitOf('/link.counters.lost')).toBe('');
    expect(topicOf('/estimate.model.x_m')).toBe('/estimate');
  });

  it('are found by words', () => {
    expect(search(['/a.model.x_m', '/a.fused.x_m', '/b.y_m'], 'X_m fused')).toEqual(['/a.fused.x_m']);
    expect(search(['/a', '/b'], '')).toEqual(['/a', '/b']);
  });
});

describe('chosen signals', () => {
  const slip = (t_s: number): object => ({ t_s, left: 10 * t_s });

  it('take what comes, and nothing of other channels', () => {
    const signals = new Signals();
    signals.choose('/slip.left');
    for (const t_s of [1, 2, 3]) signals.receive('/slip', slip(t_s));
    signals.receive('/event', slip(4));
    signals.receive('/slip', { left: 1 });
    expect(signals.fields).toEqual(['/slip.left']);
    expect([...(signals.of('/slip.left')?.since(0)[1] ?? [])]).toEqual([10, 20, 30]);
    signals.drop('/slip.left');
    expect(signals.names).toEqual([]);
  });

  it('get what was before, and stay in order', () => {
    const signals = new Signals();
    signals.choose('/slip.left');
    for (const t_s of [10, 11]) signals.receive('/slip', slip(t_s));
    signals.before('/slip.left', [slip(8), slip(9), slip(10), slip(12)]);
    expect([...(signals.of('/slip.left')?.since(0)[0] ?? [])]).toEqual([8, 9, 10, 11]);
    signals.before('/slip.right', [slip(8)]);
  });

  it('are bounded', () => {
    const signals = new Signals(100, 0);
    signals.choose('/slip.left');
    for (let t_s = 0; t_s < 1000; t_s++) signals.receive('/slip', slip(t_s));
    expect(signals.of('/slip.left')?.length).toBe(100);
  });
});

describe('a table of signals', () => {
  it('has a row for each time and gaps where there is no value', () => {
    const of = (...values: number[]): Float64Array => Float64Array.from(values);
    expect(csv([{ name: '/a.x', times: of(1, 2), values: of(0.5, NaN) }, { name: '/b.y', times: of(1.5, 2), values: of(7, 8) }])).toBe(
      't_s,/a.x,/b.y\n1.000000,0.5,\n1.500000,,7\n2.000000,,8\n',
    );
  });
});
