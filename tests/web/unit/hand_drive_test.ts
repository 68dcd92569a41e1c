// What the page sends while a person drives by hand, and when it stops sending.
import { beforeEach, describe, expect, it } from 'vitest';
import { Driver } from '../../../daemon/web/drive/driver.ts';
import { Inputs } from '../../../daemon/web/drive/inputs.ts';
import type { State } from '../../../daemon/web/state/messages.ts';

describe('the driver', () => {
  let sent: { service: string; request: Record<string, unknown> }[];
  let answer: (service: string) => Promise<unknown>;
  let attended: boolean;
  let ended: string[];
  let driver: Driver;
  let inputs: Inputs;
  const state = (run: string): State => ({ run }) as State;
  const settled = async (): Promise<void> => {
    for (let i = 0; i < 3; i++) await Promise.resolve();
  };
  const last = (): Record<string, unknown> | undefined => sent.at(-1)?.request;

  beforeEach(() => {
    inputs = new Inputs(() => [], () => 1000);
    sent = [];
    ended = [];
    attended = true;
    answer = (service) => Promise.resolve(service === 'drive_take' ? { token: 't' } : { accepted: true });
    const call = (service: string, request: unknown): Promise<unknown> => {
      sent.push({ service, request: request as Record<string, unknown> });
      return answer(service);
    };
    driver = new Driver(
      call,
      (service, request) => call(service, { ...(request as object), stops: 0 }),
      inputs,
      () => attended,
      (why) => ended.push(why),
    );
    driver.limits = { speed_mps: 0.2, yaw_rate_radps: 1 };
  });

  // Otherwise the daemon could not tell how old an input is, or would count the person's first one as the path's delay.
  it('takes the lease by consent, and sends a standstill as soon as it has it, nothing before', async () => {
    inputs.key('KeyA', 'pressed');
    driver.tick();
    driver.leave();
    expect(sent, 'nothing before it has the lease').toEqual([]);
    const taken = driver.take();
    inputs.key('KeyW', 'pressed');
    await taken;
    expect(sent).toEqual([
      { service: 'drive_take', request: { stops: 0 } },
      { service: 'drive', request: { token: 't', speed_mps: 0, yaw_rate_radps: 0, input_ms: 1000 } },
    ]);
  });

  it('says why the lease or its path is refused, and does not drive', async () => {
    for (const refused of ['drive_take', 'drive']) {
      answer = (service) => (service === refused ? Promise.reject(new Error(`${refused} is refused`)) : Promise.resolve({ token: 't' }));
      await driver.take();
      await settled();
      expect(driver.drives).toBe(false);
      expect(ended.at(-1)).toBe(`${refused} is refused`);
    }
  });

  it('sends what is wanted within its share of the limits, with the time of the input', async () => {
    inputs.key('KeyW', 'pressed');
    await driver.take();
    driver.tick();
    expect(last(), 'a key that was held before does not drive').toMatchObject({ token: 't', speed_mps: 0, yaw_rate_radps: 0 });
    driver.share = 0.25;
    inputs.key('KeyS', 'pressed');
    inputs.key('KeyA', 'pressed');
    driver.tick();
    expect(last()).toEqual({ token: 't', speed_mps: -0.05, yaw_rate_radps: 0.25, input_ms: 1000 });
  });

  it('sends a standstill once when it is left, and nothing while nobody is there', async () => {
    await driver.take();
    inputs.key('KeyW', 'pressed');
    driver.tick();
    attended = false;
    driver.leave();
    expect(last()).toMatchObject({ speed_mps: 0, yaw_rate_radps: 0 });
    const count = sent.length;
    driver.tick();
    expect(sent.length).toBe(count);
  });

  it('stops sending when nothing is answered', async () => {
    await driver.take();
    answer = () => new Promise(() => undefined);
    for (let i = 0; i < 100; i++) driver.tick();
    expect(sent.length).toBeLessThan(10);
  });

  it('loses the lease with a refusal, the end of the drive or the connection, and says why', async () => {
    await driver.take();
    answer = () => Promise.reject(new Error('this token does not hold the lease; take it'));
    driver.tick();
    await settled();
    expect(driver.drives).toBe(false);
    expect(ended).toEqual(['this token does not hold the lease; take it']);

    answer = () => Promise.resolve({ token: 'u' });
    await driver.take();
    driver.received(state('idle'));
    expect(driver.drives).toBe(true);
    driver.received(state('arming'));
    driver.received(state('driving'));
    driver.received(state('aborted'));
    expect(driver.drives).toBe(false);

    await driver.take();
    driver.lose('gone');
    expect(ended.at(-1)).toBe('gone');
    expect(driver.drives).toBe(false);
  });
});
