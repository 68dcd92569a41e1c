// Parameters as a person edits them: what a typed text means, how they are found, and what Save writes.
import { expect, it } from 'vitest';
import type { Parameter } from '../../../daemon/web/state/messages.ts';
import { grouped, limits, matches, ParameterEdits, plain, read, shown } from '../../../daemon/web/state/parameters.ts';

const parameter = (name: string, more: Partial<Parameter> = {}): Parameter => ({
  name, value: 0.06, default: 0.06, type: 'number', unit: 's', min: 0, max: 1, choices: [], meaning: 'Time ahead.', live: false, when: 'always', may_save: true, ...more,
});
const preview = parameter('control.preview_s', { live: true });
const rate = parameter('loop.rate_hz', { value: 200, default: 200, min: 50, max: 1000, unit: 'Hz', meaning: 'Steps per second' });
const law = parameter('control.law', { type: 'choice', value: 'stanley', choices: ['stanley', 'lqr'], unit: '', min: undefined, max: undefined });

it('a typed value is a number within the limits, or says which are allowed', () => {
  expect(read(preview, ' 0.5 ')).toEqual({ value: 0.5 });
  for (const text of ['', 'x', 'NaN', '1e999']) expect(read(preview, text)).toEqual({ why: 'a number from 0 to 1 s' });
  expect([read(preview, '0'), read(preview, '1')]).toEqual([{ value: 0 }, { value: 1 }]);
  for (const text of ['1.01', '-0.01']) expect(read(preview, text)).toEqual({ why: 'allowed is 0 to 1 s' });
  expect(read(parameter('a', { type: 'integer' }), '0.5')).toEqual({ why: 'a whole number from 0 to 1 s' });
  expect(read(parameter('a', { type: 'text' }), ' as it is ')).toEqual({ value: ' as it is ' });
  expect(limits(law)).toBe('stanley, lqr');
});

it('a value shows no binary fraction', () => {
  expect(plain(-0.0038700000000000006)).toBe(-0.00387);
  expect([shown(24.000000000000004), shown('')]).toEqual(['24', '""']);
});

it('the list is grouped by table in the order of the file, and searched by every word', () => {
  const list = [parameter('robot'), rate, preview, law, parameter('robot.model.slip')];
  expect(grouped(list).map(([table, of]) => [table, of.length])).toEqual([['run', 1], ['loop', 1], ['control', 2], ['robot.model', 1]]);
  expect(list.filter((each) => matches(each, 'LOOP steps')), 'every word').toEqual([rate]);
});

it('what Save writes are the edits and the live values, without what may not be saved', () => {
  const edits = new ParameterEdits();
  const list = [preview, rate, law, parameter('server.max_clients', { may_save: false })];
  edits.set(rate, 100);
  expect(edits.wanted(list)).toEqual({ 'control.preview_s': 0.06, 'loop.rate_hz': 100 });
  edits.set(rate, 200);
  expect(edits.names).toEqual([]);
  // A value in force is an edit where the file has another one.
  edits.compared({ file: 'f', may_restore: true, differences: [{ name: 'loop.rate_hz', before: '100.0', after: '200.0' }] });
  edits.set(rate, 200);
  expect(edits.get('loop.rate_hz')).toBe(200);
});
