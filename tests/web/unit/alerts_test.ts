import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Alerts } from '../../../daemon/web/state/alerts.ts';
import { BatteryWatch } from '../../../daemon/web/state/battery.ts';
import { Store } from '../../../daemon/web/state/store.ts';
import type { Event, State } from '../../../daemon/web/state/messages.ts';

const kept = new Map<string, string>();
const storage = { getItem: (key: string) => kept.get(key) ?? null, setItem: (key: string, value: string) => void kept.set(key, value) };
const outlets = { notify: vi.fn(), beep: vi.fn() };
let now_ms = 0;
let store: Store;

const event = (t_s: number, level: Event['level'] = 'error'): Event => ({ t_s, level, kind: 'fault', text: 'tilt', cause: 'it leans', fix: 'set it down' });

beforeEach(() => {
  kept.clear();
  vi.clearAllMocks();
  now_ms = 0;
  store = new Store(() => 0);
  store.receive('/state', { t_s: 100, run: 'running' } as State);
});

const alerts = (): Alerts => new Alerts(outlets, storage, () => now_ms);

describe('alerts', () => {
  it('are off until they are chosen, and remembered', () => {
    alerts().received('/event', event(100), store);
    expect(outlets.notify).not.toHaveBeenCalled();
    expect(outlets.beep).not.toHaveBeenCalled();
    const chosen = alerts();
    chosen.sounds = true;
    expect(alerts().sounds).toBe(true);
    expect(alerts().notifies).toBe(false);
    chosen.notifies = true;
    chosen.sounds = false;
    expect(alerts().sounds).toBe(false);
    expect(alerts().notifies).toBe(true);
  });

  it('tell of a new fault once, with what to do, not what a new connection repeats, nor what is no fault', () => {
    const all = alerts();
    all.notifies = all.sounds = true;
    all.received('/event', event(40), store);
    all.received('/event', event(100, 'warning'), store);
    all.received('/event', event(100), new Store(() => 0));
    expect(outlets.notify).not.toHaveBeenCalled();
    all.received('/event', event(100.2), store);
    all.received('/event', event(100.3), store);
    expect(outlets.notify.mock.calls).toEqual([['tilt', 'it leans: set it down']]);
    expect(outlets.beep).toHaveBeenCalledOnce();
    now_ms = 5000;
    all.received('/event', event(105), store);
    expect(outlets.beep).toHaveBeenCalledTimes(2);
  });

  it('tell once that the battery is low', () => {
    const all = alerts();
    all.notifies = true;
    store.receive('/parameter', { parameters: [{ name: 'control.min_battery_v', value: 6.2 } as never] });
    for (let t_s = 101; t_s < 110; t_s++) {
      const state = { t_s, run: 'idle', battery_v: 6.4 } as State;
      store.receive('/state', state);
      all.received('/state', state, store);
      now_ms += 1000;
    }
    expect(outlets.notify.mock.calls).toEqual([['the battery is low', '6.40 V']]);
  });
});

describe('the battery', () => {
  it('is low when it stays near the limit, not when a motor starts', () => {
    const battery = new BatteryWatch();
    battery.take(0, 6.4, 6.2);
    battery.take(1, 6.4, 6.2);
    battery.take(1.5, 7, 6.2);
    battery.take(2.5, 6.4, 6.2);
    expect(battery.low).toBe(false);
    battery.take(4.6, 6.4, 6.2);
    expect(battery.low).toBe(true);
    battery.take(5, 6.55, 6.2);
    expect(battery.low, 'a little more is not enough').toBe(true);
    battery.take(6, 6.7, 6.2);
    expect(battery.low).toBe(false);
  });

  it('is not low where none is, or no limit is known', () => {
    const battery = new BatteryWatch();
    for (const [voltage_v, limit_v] of [[0.3, 6.2], [undefined, 6.2], [6.2, undefined], [6.2, 0]]) {
      for (let t_s = 0; t_s < 10; t_s++) battery.take(t_s, voltage_v, limit_v);
      expect(battery.low).toBe(false);
    }
  });
});
