// Recordings as the page reads them while they arrive, also corrupted ones.
import { describe, expect, it } from 'vitest';
import { McapScanner, type McapMessage } from '../../../daemon/web/replay/mcap.ts';
import { random } from './random.ts';

const encoder = new TextEncoder();

function bytes(...parts: (number[] | Uint8Array)[]): Uint8Array {
  return new Uint8Array(parts.flatMap((part) => [...part]));
}
function number(value: number | bigint, size: 2 | 4 | 8): number[] {
  const view = new DataView(new ArrayBuffer(8));
  view.setBigUint64(0, BigInt(value), true);
  return [...new Uint8Array(view.buffer, 0, size)];
}
const text = (value: string): number[] => [...number(encoder.encode(value).length, 4), ...encoder.encode(value)];
const record = (op: number, body: Uint8Array): Uint8Array => bytes([op], number(body.length, 8), body);
const channel = (id: number, topic: string): Uint8Array =>
  record(4, bytes(number(id, 2), number(1, 2), text(topic), text('json'), number(0, 4)));
const message = (id: number, time_ns: bigint, content: string): Uint8Array =>
  record(5, bytes(number(id, 2), number(0, 4), number(time_ns, 8), number(time_ns, 8), encoder.encode(content)));
const chunk = (records: Uint8Array, compression = ''): Uint8Array =>
  record(6, bytes(number(0, 8), number(9, 8), number(records.length, 8), number(0, 4), text(compression), number(records.length, 8), records));

const kMagic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const kFile = bytes(
  kMagic,
  record(1, bytes(text(''), text('test'))),
  channel(7, '/estimate'),
  chunk(bytes(channel(8, '/slip'), message(7, 1_500_000_000n, '{"a":1}'), message(8, 1_600_000_000n, '{"b":2}'))),
  message(7, 2_000_000_000n, '{"a":3}'),
  record(0x0f, bytes(number(0, 4))),
  record(2, bytes(number(0, 8), number(0, 8), number(0, 4))),
  kMagic,
);

function read(file: Uint8Array, pieces: number): string[] {
  const received: string[] = [];
  const scanner = new McapScanner(({ topic, time_s, data }: McapMessage) => {
    received.push(`${topic} ${time_s.toFixed(1)} ${new TextDecoder().decode(data)}`);
  });
  for (let at = 0; at < file.length; at += pieces) scanner.push(file.subarray(at, at + pieces));
  return received;
}

const kContent = ['/estimate 1.5 {"a":1}', '/slip 1.6 {"b":2}', '/estimate 2.0 {"a":3}'];

describe('McapScanner', () => {
  it.each([kFile.length, 1, 3, 17, 64])('reads messages in and outside of chunks from a file that arrives %i bytes at a time', (pieces) => {
    expect(read(kFile, pieces)).toEqual(kContent);
  });

  it('reads what there is of a file without an end', () => {
    for (let length = 8; length < kFile.length; length++) {
      const received = read(kFile.subarray(0, length), length);
      expect(received).toEqual(kContent.slice(0, received.length));
    }
  });

  it('copies only what is wanted', () => {
    const received: string[] = [];
    const scanner = new McapScanner(
      ({ topic }) => received.push(topic),
      (topic, time_s) => topic === '/estimate' && time_s > 1.7,
    );
    scanner.push(kFile);
    expect(received).toEqual(['/estimate']);
    expect(scanner.ended).toBe(true);
  });

  it('refuses what is no recording, or corrupted', () => {
    expect(() => read(encoder.encode('<!doctype html>'), 100)).toThrow('not an MCAP');
    expect(() => read(bytes(kMagic, [6], number(1n << 60n, 8)), 100)).toThrow('corrupted');
    expect(() => read(bytes(kMagic, chunk(new Uint8Array([5, 255, 255, 0, 0, 0, 0, 0, 0]))), 1000)).toThrow('corrupted');
    expect(() => read(bytes(kMagic, chunk(new Uint8Array(0), 'lz4')), 1000)).toThrow('lz4');
  });

  it('never throws anything but an error of its own, whatever is in the file', () => {
    const next = random(1);
    for (let round = 0; round < 300; round++) {
      const broken = kFile.slice();
      for (let i = 0; i < 4; i++) broken[8 + Math.floor(next() * (broken.length - 8))] = Math.floor(next() * 256);
      try {
        read(broken, 50);
      } catch (error) {
        expect(error).toBeInstanceOf(Error);
      }
    }
  });
});
