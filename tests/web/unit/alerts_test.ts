// Faults and a low battery, told by notification and sound while nobody looks at the page.
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
    alerts().sounds = true;
    expect([alerts().sounds, alerts().notifies]).toEqual([true, false]);
    const chosen = alerts();
    chosen.notifies = true;
    chosen.sounds = false;
    expect([alerts().sounds, alerts().notifies]).toEqual([false, true]);
  });

  it('tell of a new fault once, with what to do, not what a new connection repeats, nor what is no fault', () => {
    const all = alerts();
    all.notifies = all.sounds = true;
    all.received('/event', event(40), store);
    all.received('/event', event(100, 'warning'), store);
    all.received('/event', event(100), new Store(() => 0));
    expect(outlets.notify).not.toHaveBeenCalled();
    for (const t_s of [100.2, 100.3]) all.received('/event', event(t_s), store);
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
      store.receive('/state', { t_s, run: 'idle', battery_v: 6.4 } as State);
      all.received('/state', undefined, store);
      now_ms += 1000;
    }
    expect(outlets.notify.mock.calls).toEqual([['the battery is low', '6.40 V']]);
  });
});

it('the battery is low when it stays near the limit, not when a motor starts', () => {
  const battery = new BatteryWatch();
  const looks: [t_s: number, voltage_v: number, low: boolean, why: string][] = [
    [0, 6.4, false, 'near the limit'],
    [1.5, 7, false, 'the motor runs'],
    [2.5, 6.4, false, 'near the limit again'],
    [4.6, 6.4, true, 'it stayed there for 2 s'],
    [5, 6.55, true, 'a little more is not enough'],
    [6, 6.7, false, 'it is charged'],
    [7, 0.3, false, 'no battery'],
    [10, 0.3, false, 'no battery for long'],
  ];
  for (const [t_s, voltage_v, low, why] of looks) {
    battery.take(t_s, voltage_v, 6.2);
    expect(battery.low, why).toBe(low);
  }
  for (const limit_v of [undefined, 0]) for (const t_s of [20, 30]) battery.take(t_s, 6.2, limit_v);
  expect(battery.low, 'no limit is known').toBe(false);
});
