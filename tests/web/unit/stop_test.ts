// STOP as the page shows it and sends it, whatever becomes of the connection.
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Client } from '../../../daemon/web/foxglove/client.ts';
import { kSecondWay_ms, StopSender } from '../../../daemon/web/foxglove/stop_sender.ts';
import type { StopState } from '../../../daemon/web/state/messages.ts';
import { kPatience_ms, StopButton } from '../../../daemon/web/state/stop.ts';
import { answer, FakeDaemon } from './fake_daemon.ts';

const kNone: StopState = { count: 0, latched: false, by: '', status: 'none' };
const kLatched: StopState = { count: 1, latched: true, by: 'viewer 3', status: 'acknowledged', acknowledged_ms: 14.2 };

let stop: StopButton;
beforeEach(() => {
  stop = new StopButton();
});

describe('the STOP button', () => {
  it('is ready whatever is known, and goes from a press over the answer to stopped, with the time that the robot took', () => {
    expect(stop.view(0)).toEqual({ kind: 'ready' });
    stop.received(kNone);
    expect(stop.view(0)).toEqual({ kind: 'ready' });
    stop.press(1000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    expect(stop.unsent).toBe(false);
    expect(stop.view(1010).kind).toBe('pending');
    stop.answered(true, 14.2);
    expect(stop.view(1020)).toMatchObject({ kind: 'stopped', took_ms: 14.2 });
  });

  it('says not acknowledged after its patience is over, not before, and whether it waits for the link', () => {
    stop.press(1000);
    expect(stop.view(1500)).toMatchObject({ kind: 'not_acknowledged', waiting: true });
    stop.sent();
    expect(stop.view(1000 + kPatience_ms - 1).kind).toBe('pending');
    expect(stop.view(1000 + kPatience_ms)).toMatchObject({ kind: 'not_acknowledged', waiting: false });
  });

  it('is to be sent again after a lost connection, until the robot has acknowledged', () => {
    stop.press(0);
    for (const acknowledged of [undefined, false, true]) {
      stop.sent();
      if (acknowledged !== undefined) stop.answered(acknowledged, acknowledged ? 9 : null);
      stop.disconnected();
      expect(stop.unsent).toBe(acknowledged !== true);
    }
  });

  it('takes no older acknowledgement for its own, but believes one that comes late', () => {
    stop.received(kLatched);
    stop.press(1000);
    stop.sent();
    stop.received(kLatched);
    expect(stop.view(1300).kind).toBe('not_acknowledged');
    stop.answered(false, null);
    stop.received({ ...kLatched, count: 2, status: 'not_acknowledged', acknowledged_ms: undefined });
    expect(stop.view(1400).kind).toBe('not_acknowledged');
    stop.received({ ...kLatched, count: 2, acknowledged_ms: 3210 });
    expect(stop.view(3300)).toMatchObject({ kind: 'stopped', took_ms: 3210 });
  });

  it('shows what another viewer stopped, latched until a start, and takes another press meanwhile', () => {
    for (const status of ['pending', 'not_acknowledged'] as const) {
      stop.received({ ...kLatched, status, acknowledged_ms: undefined });
      expect(stop.view(0).kind).toBe(status);
    }
    stop.received(kLatched);
    expect(stop.view(1e9)).toEqual({ kind: 'stopped', took_ms: 14.2, by: 'viewer 3' });
    stop.received({ ...kLatched, acknowledged_ms: undefined });
    expect(stop.view(1e9), 'a time that is no longer told').toMatchObject({ took_ms: 14.2 });
    stop.press(5000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(true, 8);
    expect(stop.view(5100)).toMatchObject({ kind: 'stopped', took_ms: 8 });
    stop.received({ ...kLatched, count: 2, latched: false, status: 'none' });
    expect(stop.view(1e9).kind).toBe('ready');
  });
});

describe('STOP over a connection that is slow or dead', () => {
  let daemon: FakeDaemon;
  let sender: StopSender;
  /** How often STOP was sent over each connection. */
  const stops = (): number[] => daemon.sockets.map(({ calls }) => calls.length);
  /** Answers the last STOP of a connection. */
  const answered = async (index: number, acknowledged = true): Promise<void> => {
    const request = daemon.at(index).calls.at(-1) ?? new ArrayBuffer(13);
    daemon.at(index).say(answer(new DataView(request).getUint32(5, true), { acknowledged, acknowledged_ms: 14.2 }));
    await vi.advanceTimersByTimeAsync(0);
  };

  beforeEach(() => {
    vi.useFakeTimers();
    daemon = new FakeDaemon();
    const client: Client = new Client(daemon.make, {
      serverInfo: () => undefined,
      ready: () => { sender.ready(); },
      closed: () => { sender.button.disconnected(); },
    }, () => Date.now());
    sender = new StopSender(client, daemon.make, ({ sessionId }) => sessionId === 's');
    daemon.newest.greet();
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('uses no other connection while the answer comes in time', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms - 1);
    await answered(0, false);
    vi.advanceTimersByTime(kSecondWay_ms);
    expect(stops()).toEqual([1]);
  });

  // Otherwise a robot would drive on for seconds after STOP, until the page notices that its connection is dead.
  it('goes over one more connection, and only one, when the answer takes longer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    daemon.at(1).greet();
    expect(stops()).toEqual([1, 1]);
    for (let i = 0; i < 5; i++) {
      sender.press(i);
      vi.advanceTimersByTime(kSecondWay_ms);
    }
    expect(stops()).toEqual([6, 6]);
    await answered(1);
    expect(sender.button.view(0)).not.toMatchObject({ kind: 'not_acknowledged' });
    expect(sender.button.unanswered).toBe(false);
    expect(daemon.at(1).closed).toBe(true);
    // The next press begins as the first one did.
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    expect(stops()).toEqual([7, 6, 0]);
  });

  it('is tried there again until one of the two has the answer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    daemon.at(1).die();
    await vi.advanceTimersByTimeAsync(1000);
    daemon.at(2).greet();
    expect(stops()).toEqual([1, 0, 1]);
    daemon.at(2).die();
    await vi.advanceTimersByTimeAsync(1000);
    await answered(0);
    expect(daemon.sockets.length).toBe(4);
    // Opened too late: another STOP could stop what was started in the meantime.
    daemon.at(3).greet();
    expect(stops()).toEqual([1, 0, 1, 0]);
    expect(daemon.at(3).closed).toBe(true);
  });

  it('is not tried there any more after the answer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    await answered(0);
    daemon.at(1).die();
    await vi.advanceTimersByTimeAsync(2500);
    expect(daemon.sockets.length).toBe(2);
  });

  it('is not sent to another daemon that answers there', () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    daemon.at(1).greet('another');
    expect(stops()).toEqual([1, 0]);
    expect(daemon.at(1).closed).toBe(true);
  });
});
