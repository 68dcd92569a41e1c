import { describe, expect, it } from 'vitest';
import * as codec from '../../../daemon/web/foxglove/codec.ts';

function message(subscription: number, time_ns: bigint, payload: string): ArrayBuffer {
  const bytes = new TextEncoder().encode(payload);
  const frame = new ArrayBuffer(13 + bytes.length);
  const view = new DataView(frame);
  view.setUint8(0, 1);
  view.setUint32(1, subscription, true);
  view.setBigUint64(5, time_ns, true);
  new Uint8Array(frame, 13).set(bytes);
  return frame;
}

describe('text frames', () => {
  it('names channels and services', () => {
    const channels = [{ id: 3, topic: '/state', encoding: 'json', schemaName: 'tp100.State', schema: '{}' }];
    expect(codec.parseText(JSON.stringify({ op: 'advertise', channels }))).toEqual({
      op: 'advertise',
      channels: [{ id: 3, topic: '/state', encoding: 'json', schemaName: 'tp100.State' }],
    });
    expect(codec.parseText('{"op":"advertiseServices","services":[{"id":1,"name":"stop","type":"x"}]}')).toEqual({
      op: 'advertiseServices',
      services: [{ id: 1, name: 'stop' }],
    });
  });

  it.each(['', '{', '[]', 'null', '7', '{"op":5}', '{"op":"unheard"}', '{"op":"serviceCallFailure","callId":"1"}'])(
    'ignores %j',
    (frame) => {
      expect(codec.parseText(frame)).toBeUndefined();
    },
  );

  it('leaves out what has no usable id', () => {
    const frame = '{"op":"advertise","channels":[{"id":-1,"topic":"/a"},{"topic":"/b"},7,null,{"id":1.5},{"id":2,"topic":"/c"}]}';
    expect(codec.parseText(frame)).toMatchObject({ channels: [{ id: 2, topic: '/c' }] });
  });
});

describe('binary frames', () => {
  it('carry subscription, time and payload', () => {
    const parsed = codec.parseBinary(message(7, 1_700_000_000_123_456_789n, '{"x":1}'));
    expect(parsed?.op).toBe('message');
    if (parsed?.op !== 'message') return;
    expect(parsed.subscriptionId).toBe(7);
    expect(parsed.time_s).toBeCloseTo(1_700_000_000.123456, 5);
    expect(new TextDecoder().decode(parsed.payload)).toBe('{"x":1}');
  });

  it('that are cut short are ignored', () => {
    const whole = message(7, 1n, '');
    for (let length = 0; length < whole.byteLength; length++) {
      expect(codec.parseBinary(whole.slice(0, length))).toBeUndefined();
    }
    expect(codec.parseBinary(whole)).toBeDefined();
  });

  it('whose inner length is a lie are ignored', () => {
    const frame = new ArrayBuffer(13);
    const view = new DataView(frame);
    view.setUint8(0, 3);
    view.setUint32(9, 0xffffffff, true);
    expect(codec.parseBinary(frame)).toBeUndefined();
  });

  it('of another kind are ignored', () => {
    expect(codec.parseBinary(new Uint8Array([200, 0, 0]).buffer)).toBeUndefined();
  });
});

describe('a service call', () => {
  it('has the layout that servers expect', () => {
    const bytes = new Uint8Array(codec.callService(5, 9, { a: 1 }));
    expect([...bytes.subarray(0, 13)]).toEqual([2, 5, 0, 0, 0, 9, 0, 0, 0, 4, 0, 0, 0]);
    expect(new TextDecoder().decode(bytes.subarray(13))).toBe('json{"a":1}');
  });
});
