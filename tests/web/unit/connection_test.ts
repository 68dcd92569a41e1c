import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Connection, kFirstRetry_ms, kLongestRetry_ms, kOpening_ms, kSilence_ms } from '../../../daemon/web/foxglove/connection.ts';
import { FakeSocket } from './fake_socket.ts';

let sockets: FakeSocket[];
let events: { opened: () => void; closed: (retry_ms: number) => void; text: (frame: string) => void; binary: (frame: ArrayBuffer) => void };
let connection: Connection;

const newest = (): FakeSocket => sockets.at(-1) ?? new FakeSocket();

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
  events = { opened: vi.fn(), closed: vi.fn(), text: vi.fn(), binary: vi.fn() };
  connection = new Connection(
    () => {
      sockets.push(new FakeSocket());
      return newest();
    },
    events,
    () => Date.now(),
  );
});

afterEach(() => {
  vi.useRealTimers();
});

describe('Connection', () => {
  it('opens at once and passes frames on', () => {
    newest().open();
    newest().say('hello');
    newest().say(new ArrayBuffer(3));
    expect(events.opened).toHaveBeenCalledOnce();
    expect(events.text).toHaveBeenCalledWith('hello');
    expect(events.binary).toHaveBeenCalledOnce();
  });

  it('sends only while it is open', () => {
    expect(connection.send('early')).toBe(false);
    newest().open();
    expect(connection.send('now')).toBe(true);
    newest().die();
    expect(connection.send('late')).toBe(false);
    expect(sockets[0]?.sent).toEqual(['now']);
  });

  it('waits longer after each failure, up to a limit, and starts anew after a success', () => {
    const waits: number[] = [];
    events.closed = vi.fn((retry_ms: number) => waits.push(retry_ms));
    for (let i = 0; i < 6; i++) {
      newest().die();
      vi.advanceTimersByTime(waits.at(-1) ?? 0);
    }
    expect(waits[0]).toBe(kFirstRetry_ms);
    expect(waits[1]).toBe(2 * kFirstRetry_ms);
    expect(waits.at(-1)).toBe(kLongestRetry_ms);
    newest().open();
    newest().die();
    expect(waits.at(-1)).toBe(kFirstRetry_ms);
  });

  it('gives up a socket that says nothing, and opens another', () => {
    newest().open();
    vi.advanceTimersByTime(kSilence_ms + 1000);
    expect(sockets[0]?.closed).toBe(true);
    expect(events.closed).toHaveBeenCalledOnce();
    expect(sockets.length).toBe(2);
  });

  it('is blocking with a socket that does not open, but not for ever', () => {
    vi.advanceTimersByTime(kOpening_ms - 1000);
    expect(sockets.length).toBe(1);
    vi.advanceTimersByTime(3000);
    expect(sockets[0]?.closed).toBe(true);
    expect(sockets.length).toBe(2);
  });

  it('does not take its own sleep for the silence of the daemon', () => {
    newest().open();
    for (let i = 0; i < 5; i++) {
      // The page was suspended: its watchdog runs late, and before the frames that have arrived in the meantime.
      vi.setSystemTime(Date.now() + 20 * kSilence_ms);
      vi.advanceTimersByTime(kSilence_ms / 2);
      newest().say('x');
    }
    expect(sockets.length).toBe(1);
  });

  it('keeps a socket that speaks now and then', () => {
    newest().open();
    for (let i = 0; i < 20; i++) {
      vi.advanceTimersByTime(kSilence_ms / 2);
      newest().say('x');
    }
    expect(sockets.length).toBe(1);
  });

  it('tries at once when asked to', () => {
    newest().die();
    connection.retryNow();
    expect(sockets.length).toBe(2);
    connection.retryNow();
    expect(sockets.length).toBe(2);
  });
});
