// A recorded run, loaded as far as a viewer needs it; its memory is bounded.
import type { Topic } from '../state/messages.ts';
import { McapScanner } from './mcap.ts';
import { Thinned } from './thinned.ts';

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

export class Recording {
  private readonly topics = new Map<string, Thinned<unknown>>();
  private readonly decoder = new TextDecoder();
  private readonly scanner: McapScanner;

  constructor() {
    for (const [topic, [capacity, interval_s]] of Object.entries(kKept)) {
      this.topics.set(topic, new Thinned(capacity, interval_s));
    }
    this.scanner = new McapScanner(
      ({ topic, time_s, data }) => {
        try {
          this.topics.get(topic)?.add(time_s, JSON.parse(this.decoder.decode(data)));
        } catch {
          // One invalid JSON message does not invalidate the rest.
        }
      },
      (topic, time_s) => this.topics.get(topic)?.wants(time_s) === true,
    );
  }

  /** Takes the next bytes of the file. Throws if it is not a recording. */
  push(bytes: Uint8Array): void {
    this.scanner.push(bytes);
  }

  /** All frames so far, in order of time. */
  frames(): Frame[] {
    const frames: Frame[] = [];
    for (const [topic, kept] of this.topics) {
      for (const { time_s, item } of kept.items) frames.push({ time_s, topic: topic as Topic, message: item });
    }
    return frames.sort((a, b) => a.time_s - b.time_s);
  }
}

/** Fetches a recording; `progress` from 0 to 1. Data from before an error is used if possible. */
export async function loadRecording(url: string, progress: (share: number) => void, signal: AbortSignal): Promise<Frame[]> {
  const response = await fetch(url, { signal });
  if (!response.ok || response.body === null) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  const size = Number(response.headers.get('Content-Length') ?? NaN);
  const reader = response.body.getReader();
  const recording = new Recording();
  let received = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    received += value.length;
    recording.push(value);
    if (size > 0) progress(received / size);
  }
  const frames = recording.frames();
  if (!frames.some((frame) => frame.topic === '/estimate')) throw new Error('the recording holds no poses');
  return frames;
}
