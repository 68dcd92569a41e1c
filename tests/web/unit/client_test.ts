import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Client, type ClientEvents } from '../../../daemon/web/foxglove/client.ts';
import { FakeSocket } from './fake_socket.ts';

let sockets: FakeSocket[];
let events: ClientEvents;
let client: Client;

const newest = (): FakeSocket => sockets.at(-1) ?? new FakeSocket();

function greet(socket: FakeSocket, offset = 0): void {
  socket.open();
  socket.json({ op: 'serverInfo', name: 'tp100d', sessionId: 's', capabilities: [], metadata: { commands: 'yes' } });
  socket.json({ op: 'advertise', channels: [{ id: 1 + offset, topic: '/state' }, { id: 2 + offset, topic: '/link' }] });
  socket.json({ op: 'advertiseServices', services: [{ id: 1 + offset, name: 'stop' }, { id: 2 + offset, name: 'start' }] });
}

function data(subscription: number, content: unknown): ArrayBuffer {
  const bytes = new TextEncoder().encode(JSON.stringify(content));
  const frame = new ArrayBuffer(13 + bytes.length);
  new DataView(frame).setUint8(0, 1);
  new DataView(frame).setUint32(1, subscription, true);
  new Uint8Array(frame, 13).set(bytes);
  return frame;
}

function response(call: number, content: unknown): ArrayBuffer {
  const bytes = new TextEncoder().encode('json' + JSON.stringify(content));
  const frame = new ArrayBuffer(13 + bytes.length);
  const view = new DataView(frame);
  view.setUint8(0, 3);
  view.setUint32(5, call, true);
  view.setUint32(9, 4, true);
  new Uint8Array(frame, 13).set(bytes);
  return frame;
}

beforeEach(() => {
  vi.useFakeTimers();
  sockets = [];
  events = { serverInfo: vi.fn(), ready: vi.fn(), closed: vi.fn(), status: vi.fn(), parameters: vi.fn() };
  client = new Client(
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

describe('Client', () => {
  it('subscribes by topic and hands messages to their listener', () => {
    const received = vi.fn();
    client.subscribe('/link', received);
    greet(newest());
    expect(newest().sent).toEqual(['{"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]}']);
    newest().say(data(1, { quality: 'good' }));
    newest().say(data(99, { quality: 'other' }));
    expect(received).toHaveBeenCalledOnce();
    expect(received).toHaveBeenCalledWith({ quality: 'good' }, 0);
  });

  it('subscribes anew, to the new ids, after a reconnection', () => {
    client.subscribe('/state', vi.fn());
    greet(newest());
    newest().die();
    vi.advanceTimersByTime(5000);
    greet(newest(), 10);
    expect(newest().sent.at(-1)).toContain('"channelId":11');
  });

  it('lets what is sent on ready go out before anything else', () => {
    client.subscribe('/state', vi.fn());
    events.ready = () => {
      void client.call('stop').catch(() => undefined);
    };
    greet(newest());
    expect(newest().sent.length).toBe(2);
    expect(newest().sent[0]).toBeInstanceOf(ArrayBuffer);
    expect(newest().sent[1]).toContain('subscribe');
  });

  it('matches answers with calls', async () => {
    greet(newest());
    const first = client.call('stop');
    const second = client.call('start');
    newest().json({ op: 'serviceCallFailure', serviceId: 2, callId: 2, message: 'no robot yet' });
    newest().say(response(1, { acknowledged: true }));
    await expect(first).resolves.toEqual({ acknowledged: true });
    await expect(second).rejects.toThrow('no robot yet');
  });

  it('fails calls that can have no answer', async () => {
    await expect(client.call('stop')).rejects.toThrow('not connected');
    greet(newest());
    await expect(client.call('dance')).rejects.toThrow('dance');
    const lost = client.call('stop');
    newest().die();
    await expect(lost).rejects.toThrow('connection lost');
  });

  it('survives garbage', () => {
    const received = vi.fn();
    client.subscribe('/state', received);
    greet(newest());
    const broken = data(1, {});
    new Uint8Array(broken).fill(0x7b, 13);
    for (const frame of ['', '{', '[1]', new ArrayBuffer(0), new ArrayBuffer(4), broken]) newest().say(frame);
    newest().say(data(1, 5));
    expect(received).toHaveBeenCalledOnce();
  });
});
