// Reads an MCAP file as it arrives (https://mcap.dev/spec): sequentially, chunks plain or zstd,
// without the index, so that truncated recordings can be read too.
import { decompress } from 'fzstd';

export interface McapMessage {
  topic: string;
  time_s: number;
  data: Uint8Array;
}

const kMagic = [0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 0x0d, 0x0a];
const kOp = { header: 1, footer: 2, schema: 3, channel: 4, message: 5, chunk: 6, dataEnd: 0x0f };
const kRecordHead = 9;
/** Far longer than any record that the daemon writes; a longer one is corrupted. */
const kLongest = 64 * 1024 * 1024;

export class McapScanner {
  private buffer = new Uint8Array(1 << 16);
  private begin = 0;
  private end = 0;
  private begun = false;
  private readonly topics = new Map<number, string>();
  /** True once the part with messages has ended. */
  ended = false;

  constructor(private readonly received: (message: McapMessage) => void) {}

  /** Takes the next bytes of the file. Throws if it is not an MCAP file, or corrupted. */
  push(bytes: Uint8Array): void {
    if (this.ended) return;
    this.append(bytes);
    if (!this.begun) {
      if (this.end - this.begin < kMagic.length) return;
      if (kMagic.some((byte, i) => this.buffer[this.begin + i] !== byte)) throw new Error('not an MCAP file');
      this.begin += kMagic.length;
      this.begun = true;
    }
    while (this.end - this.begin >= kRecordHead) {
      const view = new DataView(this.buffer.buffer, this.begin, this.end - this.begin);
      const length = Number(view.getBigUint64(1, true));
      if (length > kLongest) throw new Error('the recording is corrupted: a record of impossible length');
      if (view.byteLength < kRecordHead + length) break;
      const body = this.buffer.subarray(this.begin + kRecordHead, this.begin + kRecordHead + length);
      this.begin += kRecordHead + length;
      const op = view.getUint8(0);
      if (op === kOp.dataEnd || op === kOp.footer) {
        this.ended = true;
        break;
      }
      this.record(op, body);
    }
  }

  private append(bytes: Uint8Array): void {
    const kept = this.end - this.begin;
    if (this.end + bytes.length > this.buffer.length) {
      const size = Math.max(this.buffer.length, kept + bytes.length);
      const target = size > this.buffer.length ? new Uint8Array(2 * size) : this.buffer;
      target.set(this.buffer.subarray(this.begin, this.end));
      this.buffer = target;
      this.begin = 0;
      this.end = kept;
    }
    this.buffer.set(bytes, this.end);
    this.end += bytes.length;
  }

  private record(op: number, body: Uint8Array): void {
    const view = new DataView(body.buffer, body.byteOffset, body.byteLength);
    if (op === kOp.channel && body.length >= 8) {
      this.topics.set(view.getUint16(0, true), text(body, view, 4).text);
    } else if (op === kOp.message && body.length >= 22) {
      const topic = this.topics.get(view.getUint16(0, true));
      const time_s = Number(view.getBigUint64(6, true)) * 1e-9;
      if (topic !== undefined) this.received({ topic, time_s, data: body.subarray(22) });
    } else if (op === kOp.chunk && body.length >= 32) {
      this.chunk(body, view);
    }
  }

  private chunk(body: Uint8Array, view: DataView): void {
    const size = Number(view.getBigUint64(16, true));
    if (size > kLongest) throw new Error('the recording is corrupted: a chunk of impossible length');
    const compression = text(body, view, 28);
    const records = body.subarray(compression.next + 8);
    let plain = records;
    if (compression.text === 'zstd') plain = decompress(records, new Uint8Array(size));
    else if (compression.text !== '') throw new Error(`chunks compressed with "${compression.text}" cannot be read here`);
    let at = 0;
    while (plain.length - at >= kRecordHead) {
      const head = new DataView(plain.buffer, plain.byteOffset + at);
      const length = Number(head.getBigUint64(1, true));
      if (length > plain.length - at - kRecordHead) throw new Error('the recording is corrupted: a chunk ends too early');
      this.record(head.getUint8(0), plain.subarray(at + kRecordHead, at + kRecordHead + length));
      at += kRecordHead + length;
    }
  }
}

const decoder = new TextDecoder();

/** A string with its u32 length in front. */
function text(body: Uint8Array, view: DataView, at: number): { text: string; next: number } {
  const length = view.getUint32(at, true);
  if (length > body.length - at - 4) throw new Error('the recording is corrupted: a text ends too early');
  return { text: decoder.decode(body.subarray(at + 4, at + 4 + length)), next: at + 4 + length };
}
