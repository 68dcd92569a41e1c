// Numeric fields of channels over time, by name: "/estimate.model.x_m".
import { Series } from './series.ts';

/** Channels with numeric fields; the daemon keeps a history of each. */
const kSignalTopics: readonly string[] = ['/estimate', '/sample', '/command', '/slip', '/link', '/loop', '/state'];

export const kSignalHistory_s = 300;
const kInterval_s = 0.0399; // 25 rows a second
/** Longer lists are not vectors and are left out. */
const kLongestList = 4;
const kDeepest = 4;

export const isSignalTopic = (topic: string): boolean => kSignalTopics.includes(topic);

export function topicOf(signal: string): string {
  return signal.slice(0, Math.max(signal.indexOf('.'), 0));
}

/** The names of a message's numeric fields except its time; true and false count as 1 and 0. */
export function fieldsOf(topic: string, message: unknown): string[] {
  const names: string[] = [];
  const visit = (name: string, value: unknown, depth: number): void => {
    if (typeof value === 'number' || typeof value === 'boolean') names.push(name);
    else if (typeof value !== 'object' || value === null || depth === kDeepest) return;
    else if (Array.isArray(value) && value.length > kLongestList) return;
    else for (const [key, inner] of Object.entries(value)) if (depth > 0 || key !== 't_s') visit(`${name}.${key}`, inner, depth + 1);
  };
  visit(topic, message, 0);
  return names;
}

/** The signal's value in a message; NaN if the message does not have it. */
export function valueOf(signal: string, message: unknown): number {
  let value: unknown = message;
  for (const key of signal.split('.').slice(1)) {
    if (typeof value !== 'object' || value === null || !Object.hasOwn(value, key)) return NaN;
    value = (value as Record<string, unknown>)[key];
  }
  if (typeof value === 'boolean') return Number(value);
  return typeof value === 'number' && Number.isFinite(value) ? value : NaN;
}

function timeOf(message: unknown): number {
  return valueOf('.t_s', message);
}

const kUnits: Partial<Record<string, string>> = {
  radps: 'rad/s', mps2: 'm/s²', mps: 'm/s', degc: '°C', rad: 'rad', hz: 'Hz', ppm: 'ppm', ps: 'B/s', ms: 'ms', us: 'µs', m: 'm', s: 's', v: 'V',
};

/** A signal's unit, by the suffix of its name as everywhere in the daemon; empty: none. */
export function unitOf(signal: string): string {
  const field = signal.split('.').filter((part) => !/^\d+$/.test(part)).at(-1) ?? '';
  // The unit may be in the name of the parent: round_trip_us, sample_age_us.p99.
  if (/_us\.(mean|p50|p99|p999|max)$/.test(signal)) return 'µs';
  return field.includes('_') ? (kUnits[field.slice(field.lastIndexOf('_') + 1)] ?? '') : '';
}

/** The chosen signals of one source. */
export class Signals {
  private readonly series = new Map<string, Series>();
  private readonly known = new Set<string>();
  private readonly seen: Record<string, number> = {};

  constructor(private readonly capacity = Math.ceil(kSignalHistory_s / kInterval_s), private readonly interval_s = kInterval_s) {}

  get names(): string[] {
    return [...this.series.keys()];
  }

  /** All fields that a message had so far, sorted. */
  get fields(): string[] {
    return [...this.known].sort();
  }

  of(signal: string): Series | undefined {
    return this.series.get(signal);
  }

  choose(signal: string): void {
    if (!this.series.has(signal)) this.series.set(signal, new Series(2, this.capacity, this.interval_s));
  }

  drop(signal: string): void {
    this.series.delete(signal);
  }

  receive(topic: string, message: unknown): void {
    if (!isSignalTopic(topic)) return;
    const t_s = timeOf(message);
    if (!Number.isFinite(t_s)) return;
    // Once a second, look for fields that only some messages have.
    if (!(Math.abs(t_s - (this.seen[topic] ?? -Infinity)) < 1)) {
      this.seen[topic] = t_s;
      for (const name of fieldsOf(topic, message)) this.known.add(name);
    }
    for (const [signal, series] of this.series) if (topicOf(signal) === topic) series.push([t_s, valueOf(signal, message)]);
  }

  /** Adds messages from before the first received one of the signal. */
  before(signal: string, messages: readonly unknown[]): void {
    this.series.get(signal)?.before(messages.map((message) => [timeOf(message), valueOf(signal, message)]));
  }
}

/** One row per time with microseconds, one column per signal; empty where a signal has no value at that time. */
export function csv(signals: readonly { name: string; times: Float64Array; values: Float64Array }[]): string {
  const rows = new Map<string, string[]>();
  signals.forEach(({ times, values }, column) => {
    times.forEach((t_s, i) => {
      const key = t_s.toFixed(6);
      const row = rows.get(key) ?? signals.map(() => '');
      const value = values[i] ?? NaN;
      if (Number.isFinite(value)) row[column] = String(value);
      rows.set(key, row);
    });
  });
  const sorted = [...rows].sort(([a], [b]) => Number(a) - Number(b));
  return [['t_s', ...signals.map(({ name }) => name)], ...sorted.map(([t_s, row]) => [t_s, ...row])].map((row) => row.join(',')).join('\n') + '\n';
}
