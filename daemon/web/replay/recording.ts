// A recorded run, loaded as far as a viewer needs it; its memory is bounded.
import type { Topic } from '../state/messages.ts';
import { McapScanner } from './mcap.ts';

/** Limits per topic: most messages, and the least interval between them. */
const kKept: Partial<Record<Topic, [capacity: number, interval_s: number]>> = {
  '/course': [4, 0],
  '/estimate': [20_000, 0.0199],
  '/slip': [8_000, 0.049],
  '/sample': [15_000, 0.0399],
  '/command': [15_000, 0.0399],
  '/state': [8_000, 0],
  '/event': [2_000, 0],
  '/link': [2_000, 0.19],
  '/loop': [2_000, 0.49],
  // Up to 80 kB each, usually 20 kB.
  '/camera/image': [800, 0],
};

export interface Frame {
  time_s: number;
  topic: Topic;
  message: unknown;
}

/** Fetches a recording; `progress` from 0 to 1. */
export async function loadRecording(url: string, progress: (share: number) => void, signal: AbortSignal): Promise<Frame[]> {
  const response = await fetch(url, { signal });
  if (!response.ok || response.body === null) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  const kept = new Map(Object.entries(kKept).map(([topic, [capacity, interval_s]]) => [topic, new Thinned<Frame>(capacity, interval_s)]));
  const decoder = new TextDecoder();
  const scanner = new McapScanner(({ topic, time_s, data }) => {
    const thinned = kept.get(topic);
    if (thinned?.wants(time_s) !== true) return;
    try {
      thinned.add({ time_s, topic: topic as Topic, message: JSON.parse(decoder.decode(data)) });
    } catch {
      // One invalid JSON message does not invalidate the rest.
    }
  });
  const size = Number(response.headers.get('Content-Length') ?? NaN);
  const reader = response.body.getReader();
  let received = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    received += value.length;
    scanner.push(value);
    if (size > 0) progress(received / size);
  }
  const frames = [...kept.values()].flatMap(({ items }) => items).sort((a, b) => a.time_s - b.time_s);
  if (!frames.some((frame) => frame.topic === '/estimate')) throw new Error('the recording holds no poses');
  return frames;
}

export class Thinned<T extends { readonly time_s: number }> {
  readonly items: T[] = [];

  constructor(
    private readonly capacity: number,
    private interval_s: number,
  ) {}

  /** Whether an item of this time would be accepted. */
  wants(time_s: number): boolean {
    const last = this.items.at(-1);
    return last === undefined || time_s - last.time_s >= this.interval_s;
  }

  add(item: T): void {
    if (!this.wants(item.time_s)) return;
    if (this.items.length === this.capacity) {
      for (let i = 0; 2 * i < this.capacity; i++) {
        const kept = this.items[2 * i];
        if (kept !== undefined) this.items[i] = kept;
      }
      this.items.length = Math.ceil(this.capacity / 2);
      const span_s = (this.items.at(-1)?.time_s ?? 0) - (this.items[0]?.time_s ?? 0);
      this.interval_s = Math.max(2 * this.interval_s, span_s / this.items.length);
      if (!this.wants(item.time_s)) return;
    }
    this.items.push(item);
  }
}
