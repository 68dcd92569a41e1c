// What the page makes of findings, and how it watches the check of the tracks.
import { describe, expect, it } from 'vitest';
import { verdict, WheelsUp, type Severity } from '../../../daemon/web/state/doctor.ts';

// A robot that the page calls ready despite an error does not drive, and one that it calls not ready is searched for a fault that it has not.
it.each([[0, 0, 0], [0, 3, 1], [1, 0, 2], [2, 1, 0]])('%i errors, %i warnings and %i notes are counted, and only an error keeps a robot from driving', (errors, warnings, notes) => {
  const some = (n: number, severity: Severity): { severity: Severity; name: string; seen: string; fix: string }[] =>
    Array.from({ length: n }, () => ({ severity, name: 'disk', seen: '', fix: '' }));
  const findings = [...some(4, 'ok'), ...some(notes, 'note'), ...some(warnings, 'warning'), ...some(errors, 'error')];
  const counts = `: ${errors} error${errors === 1 ? '' : 's'}, ${warnings} warning${warnings === 1 ? '' : 's'}, ${notes} note${notes === 1 ? '' : 's'}.`;
  expect(verdict(findings)).toBe((errors === 0 ? 'Ready to drive' : 'Not ready to drive') + counts);
  expect(verdict(findings, 'The tracks')).toBe(`The tracks are ${errors === 0 ? '' : 'not '}as they should be${counts}`);
});

describe('the check of the tracks', () => {
  const check = (answers: unknown[]): { calls: [string, unknown][]; progress: unknown[]; failed: string[]; seen: { yes: boolean }; up: WheelsUp } => {
    const calls: [string, unknown][] = [];
    const progress: unknown[] = [];
    const failed: string[] = [];
    const seen = { yes: true };
    const call = (name: string, request: unknown): Promise<unknown> => {
      calls.push([name, request]);
      const answer = answers.shift();
      return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
    };
    const up = new WheelsUp(call, call, () => seen.yes, () => 7, (each) => progress.push(each), (why) => failed.push(why));
    return { calls, progress, failed, seen, up };
  };

  it('is begun once, and watched until its result, only while somebody sees the page', async () => {
    const result = { errors: 0, findings: [] };
    const { calls, progress, seen, up } = check([{ token: 't' }, { step: 'left' }, { step: 'right' }, { step: 'end', result }]);
    await up.tick();
    const first = up.begin();
    expect(up.on).toBe(true);
    await up.begin();
    await first;
    await up.begin();
    await up.tick();
    seen.yes = false;
    await up.tick();
    seen.yes = true;
    up.answer(2, 'b');
    for (let i = 0; i < 3; i++) await up.tick();
    const watched = { token: 't', input_ms: 7 };
    expect(calls).toEqual([
      ['wheels_up_begin', { tracks: 'free' }],
      ['wheels_up_watch', watched],
      ['wheels_up_watch', { ...watched, question: 2, answer: 'b' }],
      ['wheels_up_watch', watched],
    ]);
    expect(up.on).toBe(false);
    expect(progress).toEqual([{ step: 'left' }, { step: 'right' }, { step: 'end', result }]);
  });

  it('ends with the reason of a refusal', async () => {
    const { failed, up } = check([new Error('no robot yet')]);
    await up.begin();
    expect([up.on, failed]).toEqual([false, ['no robot yet']]);
  });
});
