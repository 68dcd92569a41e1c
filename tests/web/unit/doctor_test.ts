// How the page watches the check of the tracks.
import { describe, expect, it } from 'vitest';
import { WheelsUp } from '../../../daemon/web/state/wheels_up.ts';

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
