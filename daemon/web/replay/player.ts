// Plays a recorded run into a store, from any moment forward at any speed.
import type { Channels, Event, Topic } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import type { Frame } from './recording.ts';

/** The year 2001. Virtual time begins at zero, so that earlier times are not Unix times. */
const kPlausible_unix_s = 1e9;

export class Player {
  readonly begin_s: number;
  readonly end_s: number;
  playing = false;
  speed = 1;
  /** Moments that people marked, while it was recorded or afterwards. */
  readonly marks: { position_s: number; text: string }[];
  private next = 0;
  private at_s: number;

  /** `frames` in order of time; not empty. */
  constructor(
    readonly frames: readonly Frame[],
    readonly store: Store,
  ) {
    // Messages before the first pose (course, path) belong to the beginning.
    this.begin_s = frames.find((frame) => frame.topic === '/estimate')?.time_s ?? 0;
    this.end_s = frames.at(-1)?.time_s ?? 0;
    this.at_s = this.begin_s;
    const events = frames.filter(({ topic, message }) => topic === '/event' && (message as Event).kind === 'mark');
    this.marks = events.map(({ time_s, message }) => ({ position_s: time_s - this.begin_s, text: (message as Event).text }));
    this.show(0);
  }

  get duration_s(): number {
    return this.end_s - this.begin_s;
  }

  /** Time since the beginning of the run. */
  get position_s(): number {
    return this.at_s - this.begin_s;
  }

  /** Time of the messages at the beginning of the run. */
  private get began_t_s(): number {
    const first = this.frames.find((frame) => frame.topic === '/estimate');
    return (first?.message as { t_s?: number } | undefined)?.t_s ?? 0;
  }

  /** The time of the messages now. */
  get t_s(): number {
    return this.began_t_s + this.position_s;
  }

  mark(t_s: number, text: string): void {
    this.marks.push({ position_s: t_s - this.began_t_s, text });
  }

  /** Unix time of t_s = 0; undefined if the recording's time is virtual. */
  get began_unix_s(): number | undefined {
    const began_s = this.begin_s - this.began_t_s;
    return began_s > kPlausible_unix_s ? began_s : undefined;
  }

  /** Shows the moment `position_s` after the beginning of the run. */
  show(position_s: number): void {
    const to_s = Math.min(Math.max(this.begin_s + position_s, this.begin_s), this.end_s);
    if (to_s < this.at_s) {
      this.next = 0;
      this.store.clear();
    }
    this.at_s = to_s;
    for (let frame = this.frames[this.next]; frame !== undefined && frame.time_s <= to_s; frame = this.frames[++this.next]) {
      this.store.receive(frame.topic, frame.message as Channels[Topic]);
    }
  }

  tick(dt_s: number): void {
    if (!this.playing) return;
    if (this.at_s >= this.end_s) {
      this.playing = false;
      return;
    }
    this.show(this.position_s + dt_s * this.speed);
  }

  toggle(): void {
    if (!this.playing && this.at_s >= this.end_s) this.show(0);
    this.playing = !this.playing;
  }
}
