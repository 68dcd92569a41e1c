// Recordings as the page reads them while they arrive, also corrupted ones.
import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { McapScanner } from '../../../daemon/web/replay/mcap.ts';
import { random } from './random.ts';

/** One run, with and without compression. */
const [plain, packed] = ['plain', 'packed'].map((name) => new Uint8Array(readFileSync(new URL(`../../fuzz/seeds/recordings/${name}.mcap`, import.meta.url)))) as [Uint8Array, Uint8Array];

function read(file: Uint8Array, pieces = file.length): string[] {
  const received: string[] = [];
  const scanner = new McapScanner(({ topic, time_s, data }) => received.push(`${topic} ${time_s.toFixed(3)} ${new TextDecoder().decode(data)}`));
  for (let at = 0; at < file.length; at += pieces) scanner.push(file.subarray(at, at + pieces));
  return received;
}

const content = read(plain);

/** The file with other bytes from the first occurrence of a text on. */
function changed(file: Uint8Array, from: string, to: string): Uint8Array {
  const at = Buffer.from(file).indexOf(from);
  const copy = file.slice();
  copy.set(new TextEncoder().encode(to), at);
  return copy;
}

it.each([1, 17, 4096, 1e6])('a recording that arrives %i bytes at a time is read whole, compressed or not', (pieces) => {
  expect(content).toHaveLength(41);
  expect(JSON.parse(content.find((message) => message.startsWith('/estimate '))?.split(' ').slice(2).join(' ') ?? '')).toMatchObject({ steering: 'odometry' });
  for (const file of [plain, packed]) expect(read(file, pieces)).toEqual(content);
});

it('what there is of a file without an end is read', () => {
  for (let length = 8; length < plain.length; length += 499) {
    const received = read(plain.subarray(0, length));
    expect(received).toEqual(content.slice(0, received.length));
  }
});

it('what is no recording, or corrupted, is refused by an error and nothing else', () => {
  expect(() => read(new TextEncoder().encode('<!doctype html>'))).toThrow('not an MCAP');
  expect(() => read(new Uint8Array([...plain.subarray(0, 8), 6, 0, 0, 0, 0, 0, 0, 0, 16]))).toThrow('corrupted');
  expect(() => read(changed(packed, 'zstd', 'lz4x'))).toThrow('lz4x');
  const next = random(1);
  for (let round = 0; round < 300; round++) {
    const broken = (round % 2 === 0 ? plain : packed).slice();
    for (let i = 0; i < 4; i++) broken[8 + Math.floor(next() * (i < 2 ? 300 : broken.length - 8))] = Math.floor(next() * 256);
    try {
      read(broken, 5000);
    } catch (error) {
      expect(error).toBeInstanceOf(Error);
    }
  }
});
