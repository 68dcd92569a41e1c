// The page's end of the connection to a daemon.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Client, type ClientEvents } from '../../../daemon/web/foxglove/client.ts';
import * as codec from '../../../daemon/web/foxglove/codec.ts';
import { Connection, kFirstRetry_ms, kLongestRetry_ms, kOpening_ms, kSilence_ms } from '../../../daemon/web/foxglove/connection.ts';
import { answer, FakeDaemon, message } from './fake_daemon.ts';

describe('a frame', () => {
  it('in binary carries subscription and payload, and is ignored when it is cut short, lies about a length or is of another kind', () => {
    const whole = message(7, { x: 1 });
    const parsed = codec.parseBinary(whole);
    expect(parsed).toMatchObject({ op: 'message', id: 7 });
    expect(new TextDecoder().decode(parsed?.payload)).toBe('{"x":1}');
    for (let length = 0; length < 13; length++) expect(codec.parseBinary(whole.slice(0, length))).toBeUndefined();
    const lies = new DataView(answer(1, {}));
    lies.setUint32(9, 0xffffffff, true);
    expect(codec.parseBinary(lies.buffer)).toBeUndefined();
    expect(codec.parseBinary(new Uint8Array(20).fill(200).buffer)).toBeUndefined();
  });

  it('of a service call has the layout that servers expect', () => {
    const bytes = new Uint8Array(codec.callService(5, 9, { a: 1 }));
    expect([...bytes.subarray(0, 13)]).toEqual([2, 5, 0, 0, 0, 9, 0, 0, 0, 4, 0, 0, 0]);
    expect(new TextDecoder().decode(bytes.subarray(13))).toBe('json{"a":1}');
  });
});

let daemon: FakeDaemon;
beforeEach(() => {
  vi.useFakeTimers();
  daemon = new FakeDaemon();
});
afterEach(() => {
  vi.useRealTimers();
});

describe('a connection', () => {
  const events = { closed: vi.fn<(retry_ms: number) => void>(), text: vi.fn(), binary: vi.fn() };
  let connection: Connection;
  beforeEach(() => {
    vi.clearAllMocks();
    connection = new Connection(daemon.make, events, () => Date.now());
  });

  it('waits longer after each failure, up to a limit, and starts anew after a success or when it is asked to', () => {
    const waits_ms = (): number[] => events.closed.mock.calls.map(([retry_ms]) => retry_ms);
    for (let i = 0; i < 6; i++) {
      daemon.newest.die();
      vi.advanceTimersByTime(waits_ms().at(-1) ?? NaN);
    }
    expect(waits_ms()).toEqual([1, 2, 4, 8, 16, 32].map((times) => Math.min(times * kFirstRetry_ms, kLongestRetry_ms)));
    daemon.newest.open();
    daemon.newest.die();
    expect(waits_ms().at(-1)).toBe(kFirstRetry_ms);
    const count = daemon.sockets.length;
    connection.retryNow();
    connection.retryNow();
    expect(daemon.sockets.length).toBe(count + 1);
  });

  it('gives up a socket that says nothing or does not open, and opens another', () => {
    vi.advanceTimersByTime(kOpening_ms - 1000);
    expect(daemon.sockets.length).toBe(1);
    vi.advanceTimersByTime(3000);
    expect(daemon.at(0).closed).toBe(true);
    daemon.newest.open();
    for (let i = 0; i < 20; i++) {
      vi.advanceTimersByTime(kSilence_ms / 2);
      daemon.newest.say('x');
    }
    expect(daemon.sockets.length, 'one that speaks now and then is kept').toBe(2);
    vi.advanceTimersByTime(kSilence_ms + 1000);
    expect(daemon.at(1).closed).toBe(true);
    expect(daemon.sockets.length).toBe(3);
  });

  it('does not take its own sleep for the silence of the daemon', () => {
    daemon.newest.open();
    for (let i = 0; i < 5; i++) {
      // The page was suspended: its watchdog runs late, and before the frames that have arrived in the meantime.
      vi.setSystemTime(Date.now() + 20 * kSilence_ms);
      vi.advanceTimersByTime(kSilence_ms / 2);
      daemon.newest.say('x');
    }
    expect(daemon.sockets.length).toBe(1);
  });
});

describe('a client', () => {
  let events: ClientEvents;
  let client: Client;
  beforeEach(() => {
    events = { serverInfo: vi.fn(), ready: vi.fn(), closed: vi.fn() };
    client = new Client(daemon.make, events, () => Date.now());
  });

  it('leaves out what is malformed, and channels without a usable id', async () => {
    const told = vi.fn();
    events.serverInfo = told;
    client.subscribe('/b', vi.fn());
    for (const frame of ['', '{', '[]', 'null', '7', '{"op":5}', '{"op":"unheard"}', '{"op":"advertise","channels":7}', '{"op":"serverInfo","metadata":[]}']) daemon.newest.say(frame);
    expect(told).toHaveBeenCalledWith({ sessionId: '', metadata: {} });
    daemon.newest.json({ op: 'advertise', channels: [{ id: -1, topic: '/b' }, { topic: '/b' }, 7, null, { id: 1.5, topic: '/b' }, { id: 1 }] });
    daemon.newest.greet();
    expect(daemon.newest.sent).toEqual([]);
    const called = client.call('stop');
    daemon.newest.json({ op: 'serviceCallFailure', callId: '1' });
    daemon.newest.say(answer(1, {}));
    await expect(called).resolves.toEqual({});
  });

  it('subscribes by topic, hands messages to their listener, and subscribes anew after a reconnection', () => {
    const received = vi.fn();
    client.subscribe('/link', received);
    daemon.newest.greet();
    expect(daemon.newest.sent).toEqual(['{"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]}']);
    daemon.newest.say(message(1, { quality: 'good' }));
    daemon.newest.say(message(99, { quality: 'other' }));
    expect(received.mock.calls).toEqual([[{ quality: 'good' }]]);
    daemon.newest.die();
    vi.advanceTimersByTime(5000);
    daemon.newest.greet('s', 11);
    expect(daemon.newest.sent.at(-1)).toContain('"channelId":12');
  });

  // Otherwise a STOP that waited for the connection would wait for the subscriptions, too.
  it('lets what is sent on ready go out before anything else', () => {
    client.subscribe('/state', vi.fn());
    events.ready = () => {
      void client.call('stop').catch(() => undefined);
    };
    daemon.newest.greet();
    expect(daemon.newest.sent.length).toBe(2);
    expect(daemon.newest.sent[0]).toBeInstanceOf(ArrayBuffer);
    expect(daemon.newest.sent[1]).toContain('subscribe');
  });

  it('matches answers with calls, and fails calls that can have no answer', async () => {
    await expect(client.call('stop')).rejects.toThrow('not connected');
    daemon.newest.greet();
    const [first, second] = [client.call('stop'), client.call('start')];
    daemon.newest.json({ op: 'serviceCallFailure', serviceId: 2, callId: 2, message: 'no robot yet' });
    daemon.newest.say(answer(1, { acknowledged: true }));
    await expect(first).resolves.toEqual({ acknowledged: true });
    await expect(second).rejects.toThrow('no robot yet');
    await expect(client.call('dance')).rejects.toThrow('dance');
    const lost = client.call('stop');
    daemon.newest.die();
    await expect(lost).rejects.toThrow('connection lost');
  });
});
