import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Client } from '../../../daemon/web/foxglove/client.ts';
import { kSecondWay_ms, StopSender } from '../../../daemon/web/foxglove/stop_sender.ts';
import type { StopState } from '../../../daemon/web/state/messages.ts';
import { kPatience_ms, StopButton } from '../../../daemon/web/state/stop.ts';
import { FakeSocket } from './fake_socket.ts';

const kNone: StopState = { count: 0, latched: false, by: '', requested_t_s: null, status: 'none', acknowledged_ms: null };
const kLatched: StopState = { count: 1, latched: true, by: 'viewer 3', requested_t_s: 1, status: 'acknowledged', acknowledged_ms: 14.2 };

let stop: StopButton;
beforeEach(() => {
  stop = new StopButton();
});

describe('StopButton', () => {
  it('is ready at first, whatever is known', () => {
    expect(stop.view(0)).toEqual({ kind: 'ready' });
    stop.received(kNone);
    expect(stop.view(0)).toEqual({ kind: 'ready' });
  });

  it('goes from a press over the answer to stopped, with the time that the robot took', () => {
    stop.received(kNone);
    stop.press(1000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    expect(stop.unsent).toBe(false);
    expect(stop.view(1010).kind).toBe('pending');
    stop.answered(true, 14.2);
    expect(stop.view(1020)).toMatchObject({ kind: 'stopped', took_ms: 14.2 });
  });

  it('says not acknowledged after its patience is over, not before', () => {
    stop.press(1000);
    stop.sent();
    expect(stop.view(1000 + kPatience_ms - 1).kind).toBe('pending');
    expect(stop.view(1000 + kPatience_ms)).toMatchObject({ kind: 'not_acknowledged', waiting: false });
  });

  it('says that it waits for the link when it could not be sent', () => {
    stop.press(0);
    expect(stop.view(500)).toMatchObject({ kind: 'not_acknowledged', waiting: true });
  });

  it('is to be sent again after a lost connection, until the robot has acknowledged', () => {
    stop.press(0);
    stop.sent();
    stop.disconnected();
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(false, null);
    stop.disconnected();
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(true, 9);
    stop.disconnected();
    expect(stop.unsent).toBe(false);
  });

  it('takes no older acknowledgement for its own', () => {
    stop.received(kLatched);
    stop.press(1000);
    stop.sent();
    stop.received(kLatched);
    expect(stop.view(1300).kind).toBe('not_acknowledged');
    stop.answered(false, null);
    stop.received({ ...kLatched, count: 2, status: 'not_acknowledged', acknowledged_ms: null });
    expect(stop.view(1400).kind).toBe('not_acknowledged');
  });

  it('believes an acknowledgement that comes late', () => {
    stop.press(0);
    stop.sent();
    stop.answered(false, null);
    stop.received({ ...kLatched, acknowledged_ms: 3210 });
    expect(stop.view(3300)).toMatchObject({ kind: 'stopped', took_ms: 3210 });
  });

  it('shows what another viewer stopped', () => {
    stop.received(kLatched);
    expect(stop.view(0)).toEqual({ kind: 'stopped', took_ms: 14.2, by: 'viewer 3' });
    stop.received({ ...kLatched, status: 'pending', acknowledged_ms: null });
    expect(stop.view(0).kind).toBe('pending');
    stop.received({ ...kLatched, status: 'not_acknowledged', acknowledged_ms: null });
    expect(stop.view(0).kind).toBe('not_acknowledged');
  });

  it('stays latched until a start', () => {
    stop.received(kLatched);
    expect(stop.view(1e9).kind).toBe('stopped');
    stop.received({ ...kLatched, latched: false, status: 'none' });
    expect(stop.view(1e9).kind).toBe('ready');
  });

  it('takes another press while it is latched', () => {
    stop.received(kLatched);
    stop.press(5000);
    expect(stop.unsent).toBe(true);
    stop.sent();
    stop.answered(true, 8);
    expect(stop.view(5100)).toMatchObject({ kind: 'stopped', took_ms: 8 });
  });
});

describe('STOP over a connection that is slow or dead', () => {
  let sockets: FakeSocket[];
  let sender: StopSender;

  const make = (): FakeSocket => {
    const socket = new FakeSocket();
    sockets.push(socket);
    return socket;
  };
  const at = (index: number): FakeSocket => sockets[index] ?? new FakeSocket();
  const greet = (index: number, sessionId = 's'): void => {
    at(index).open();
    at(index).json({ op: 'serverInfo', name: 'tp100d', sessionId, capabilities: [], metadata: {} });
    at(index).json({ op: 'advertiseServices', services: [{ id: 1, name: 'stop' }] });
  };
  /** How often STOP was sent over each connection. */
  const stops = (): number[] => sockets.map(({ sent }) => sent.filter((frame) => typeof frame !== 'string').length);
  /** Answers the last STOP of a connection. */
  const answer = async (index: number, acknowledged = true): Promise<void> => {
    const request = at(index).sent.filter((frame) => frame instanceof ArrayBuffer).at(-1) ?? new ArrayBuffer(13);
    const json = new TextEncoder().encode(`json${JSON.stringify({ acknowledged, acknowledged_ms: 14.2 })}`);
    const frame = new DataView(new ArrayBuffer(13 + json.length));
    frame.setUint8(0, 3);
    frame.setUint32(5, new DataView(request).getUint32(5, true), true);
    frame.setUint32(9, 4, true);
    new Uint8Array(frame.buffer, 13).set(json);
    at(index).say(frame.buffer);
    await vi.advanceTimersByTimeAsync(0);
  };

  beforeEach(() => {
    vi.useFakeTimers();
    sockets = [];
    const client: Client = new Client(make, {
      serverInfo: () => undefined,
      ready: () => { sender.ready(); },
      closed: () => { sender.button.disconnected(); },
      status: () => undefined,
      parameters: () => undefined,
    }, () => Date.now());
    sender = new StopSender(client, make, ({ sessionId }) => sessionId === 's');
    greet(0);
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it('uses no other connection while the answer comes in time', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms - 1);
    await answer(0, false);
    vi.advanceTimersByTime(kSecondWay_ms);
    expect(stops()).toEqual([1]);
  });

  // Otherwise a robot would drive on for seconds after STOP, until the page notices that its connection is dead.
  it('goes over one more connection, and only one, when the answer takes longer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    greet(1);
    expect(stops()).toEqual([1, 1]);
    for (let i = 0; i < 5; i++) {
      sender.press(i);
      vi.advanceTimersByTime(kSecondWay_ms);
    }
    expect(stops()).toEqual([6, 6]);
    await answer(1);
    expect(sender.button.view(0)).not.toMatchObject({ kind: 'not_acknowledged' });
    expect(sender.button.unanswered).toBe(false);
    expect(at(1).closed).toBe(true);
    // The next press begins as the first one did.
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    expect(stops()).toEqual([7, 6, 0]);
  });

  it('is tried there again until one of the two has the answer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    at(1).die();
    await vi.advanceTimersByTimeAsync(1000);
    greet(2);
    expect(stops()).toEqual([1, 0, 1]);
    at(2).die();
    await vi.advanceTimersByTimeAsync(1000);
    await answer(0);
    expect(sockets.length).toBe(4);
    // Opened too late: another STOP could stop what was started in the meantime.
    greet(3);
    expect(stops()).toEqual([1, 0, 1, 0]);
    expect(at(3).closed).toBe(true);
  });

  it('is not tried there any more after the answer', async () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    await answer(0);
    at(1).die();
    await vi.advanceTimersByTimeAsync(2500);
    expect(sockets.length).toBe(2);
  });

  it('is not sent to another daemon that answers there', () => {
    sender.press(0);
    vi.advanceTimersByTime(kSecondWay_ms);
    greet(1, 'another');
    expect(stops()).toEqual([1, 0]);
    expect(at(1).closed).toBe(true);
  });
});
