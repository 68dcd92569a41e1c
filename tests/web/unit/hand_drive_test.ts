import { beforeEach, describe, expect, it } from 'vitest';
import { Driver } from '../../../daemon/web/drive/driver.ts';
import { Inputs, travel, type Pad } from '../../../daemon/web/drive/inputs.ts';
import type { State } from '../../../daemon/web/state/messages.ts';

let now_ms = 1000;
let pads: (Pad | null)[] = [];
let inputs: Inputs;

beforeEach(() => {
  now_ms = 1000;
  pads = [];
  inputs = new Inputs(
    () => pads,
    () => now_ms,
  );
});

describe('the inputs', () => {
  it('are nothing, and given now, while no control is held', () => {
    expect(inputs.wish()).toEqual({ forward: 0, left: 0, source: 'none', at_ms: 1000 });
  });

  it('follow keys by their place, as long as they are held', () => {
    expect(inputs.key('KeyW', true)).toBe(true);
    inputs.key('ArrowLeft', true);
    now_ms = 9000;
    expect(inputs.wish()).toEqual({ forward: 1, left: 1, source: 'keys', at_ms: 9000 });
    inputs.key('KeyS', true);
    inputs.key('ArrowUp', true);
    expect(inputs.wish().forward).toBe(1);
    inputs.key('KeyW', false);
    inputs.key('ArrowUp', false);
    expect(inputs.wish().forward).toBe(-1);
    expect(inputs.key('KeyQ', true)).toBe(false);
    inputs.clear();
    expect(inputs.wish().source).toBe('none');
  });

  it('prefer the stick that is held', () => {
    inputs.key('KeyW', true);
    inputs.touch({ forward: -2, left: 0.5 });
    expect(inputs.wish()).toMatchObject({ forward: -1, left: 0.5, source: 'stick' });
    inputs.touch(undefined);
    expect(inputs.wish().source).toBe('keys');
  });

  it('have a dead zone, and full speed before the stop of a gamepad', () => {
    expect(travel(0.1)).toBe(0);
    expect(travel(-0.12)).toBe(0);
    expect(travel(0.51)).toBeCloseTo(0.5, 6);
    expect(travel(-0.9)).toBe(-1);
    expect(travel(1)).toBe(1);
    expect(travel(NaN)).toBe(0);
  });
});

describe('a gamepad', () => {
  const at = (y: number, timestamp = 0, connected = true): void => {
    pads = [null, { connected, timestamp, axes: [0, y] }];
  };

  it('drives while its values change, and counts from when they did', () => {
    at(0);
    inputs.wish();
    at(-0.9);
    expect(inputs.wish()).toMatchObject({ forward: 1, source: 'gamepad', at_ms: 1000 });
    now_ms += 100;
    expect(inputs.wish()).toMatchObject({ forward: 1, at_ms: 1000 });
    at(-0.9, 1);
    expect(inputs.wish()).toMatchObject({ forward: 1, at_ms: 1100 });
  });

  it('is ignored when its values stand still for 150 ms, until they move again', () => {
    at(0);
    inputs.wish();
    at(-0.8);
    inputs.wish();
    now_ms += 151;
    expect(inputs.wish()).toMatchObject({ forward: 0, left: 0 });
    expect(inputs.frozen).toBe(true);
    at(-0.81);
    expect(inputs.wish().forward).toBeGreaterThan(0.8);
    expect(inputs.frozen).toBe(false);
  });

  it('that was deflected before anyone looked has to move first', () => {
    at(-0.9);
    expect(inputs.wish()).toMatchObject({ forward: 0 });
    expect(inputs.frozen).toBe(true);
  });

  it('is nothing when it is gone', () => {
    at(0);
    inputs.wish();
    at(-0.9);
    expect(inputs.wish().forward).toBe(1);
    at(-0.9, 0, false);
    expect(inputs.wish()).toMatchObject({ forward: 0, source: 'none' });
    pads = [];
    expect(inputs.wish()).toMatchObject({ forward: 0, source: 'none' });
  });

  it('has to move again after the page was left', () => {
    at(0);
    inputs.wish();
    at(-0.9);
    expect(inputs.wish().forward).toBe(1);
    inputs.clear();
    expect(inputs.wish().forward).toBe(0);
  });
});

describe('the driver', () => {
  interface Sent {
    service: string;
    request: Record<string, unknown>;
  }
  let sent: Sent[];
  let answer: (service: string) => Promise<unknown>;
  let attended: boolean;
  let ended: string[];
  let driver: Driver;
  const state = (run: string): State => ({ run }) as State;
  const last = (): Record<string, unknown> | undefined => sent.at(-1)?.request;

  beforeEach(() => {
    sent = [];
    ended = [];
    attended = true;
    answer = (service) => Promise.resolve(service === 'drive_take' ? { token: 't' } : { accepted: true });
    driver = new Driver(
      (service, request) => {
        sent.push({ service, request: request as Record<string, unknown> });
        return answer(service);
      },
      inputs,
      () => attended,
      (why) => ended.push(why),
    );
    driver.limits = { speed_mps: 0.2, yaw_rate_radps: 1 };
  });

  it('sends nothing before it has taken the wheel', () => {
    inputs.key('KeyW', true);
    driver.tick();
    driver.leave();
    expect(sent).toEqual([]);
  });

  it('does not drive by a key that was held when it took the wheel', async () => {
    inputs.key('KeyW', true);
    await driver.take();
    driver.tick();
    expect(last()).toMatchObject({ token: 't', speed_mps: 0, yaw_rate_radps: 0 });
  });

  it('sends what is wanted within its share of the limits, with the time of the input', async () => {
    await driver.take();
    driver.share = 0.25;
    inputs.key('KeyS', true);
    inputs.key('KeyA', true);
    driver.tick();
    expect(last()).toEqual({ token: 't', speed_mps: -0.05, yaw_rate_radps: 0.25, input_ms: 1000 });
  });

  it('sends a standstill once when it is left, and nothing while nobody is there', async () => {
    await driver.take();
    inputs.key('KeyW', true);
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

  it('loses the wheel with a refusal, the end of the drive or the connection, and says why', async () => {
    await driver.take();
    answer = () => Promise.reject(new Error('this token does not hold the wheel; take it'));
    driver.tick();
    await Promise.resolve();
    await Promise.resolve();
    expect(driver.drives).toBe(false);
    expect(ended).toEqual(['this token does not hold the wheel; take it']);

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

  it('says why it was refused, and does not drive', async () => {
    answer = () => Promise.reject(new Error('viewer 1 drives'));
    await driver.take();
    expect(driver.drives).toBe(false);
    expect(ended).toEqual(['viewer 1 drives']);
  });

  it('releases its own token', async () => {
    await driver.take();
    driver.release();
    expect(sent.at(-1)).toEqual({ service: 'drive_release', request: { token: 't' } });
    driver.tick();
    expect(sent.at(-1)?.service).toBe('drive_release');
    expect(ended).toEqual(['']);
  });
});
