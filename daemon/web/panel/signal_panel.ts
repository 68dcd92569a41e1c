// The Signals tab: any numeric fields of the channels as diagrams, live or of a recording.
import { hasWords } from '../state/format.ts';
import { csv, isSignalTopic, Signals, topicOf, unitOf, kSignalHistory_s } from '../state/signals.ts';
import type { Frame } from '../replay/recording.ts';
import type { Store } from '../state/store.ts';
import { button, h, saveText, setAttribute, setText } from './dom.ts';
import { SignalChart, type TimeRange } from './signal_chart.ts';

const kRemembered = 'tp100.signals';
const kMaxFields = 8;
const kListed = 80;
const kShortest_s = 1;
const kWindow_s = 60;
/** Rows kept per signal of a recording: enough for all that it has. */
const kRows = 20_000;

/** The daemon's messages of a topic from before this page was opened. */
export type Past = (topic: string) => Promise<readonly unknown[]>;

export class SignalPanel {
  readonly element = h('div', { class: 'signals', tabindex: '0' });
  private readonly search = h('input', { type: 'search', placeholder: 'search fields', 'aria-label': 'Search signals' });
  private readonly list = h('ul', { class: 'signal-list' });
  private readonly chosen = h('summary', {});
  private readonly chooser = h('details', { class: 'signal-chooser', open: '' }, this.chosen, this.search, this.list);
  private readonly pauseButton = tool('signals-pause', 'Pause', 'Pause or continue', () => { this.pause(); });
  private readonly charts_ = h('div', { class: 'signal-charts' });
  private readonly live = new Signals();
  private signals = this.live;
  private charts: SignalChart[] = [];
  private window_s = kWindow_s;
  private fixed: TimeRange | undefined;
  private now_s = NaN;
  private listed = '';
  private frames: readonly Frame[] | undefined;

  constructor(private readonly past: Past) {
    const tools = h(
      'div',
      { class: 'signal-tools' },
      tool('signals-out', '\u2212', 'Longer time', () => { this.scale(2); }),
      tool('signals-in', '+', 'Shorter time', () => { this.scale(0.5); }),
      this.pauseButton,
      tool('signals-csv', 'CSV', 'Save the shown values as a table', () => { this.saveTable(); }),
    );
    this.element.append(this.chooser, h('div', { class: 'signal-view' }, tools, this.charts_));
    this.search.addEventListener('input', () => { this.showList(); });
    const names = remembered();
    this.rebuild();
    for (const name of names) this.choose(name);
    // On a phone the diagrams need the space.
    if (this.live.names.length > 0 && innerWidth < 700) this.chooser.removeAttribute('open');
  }

  /** A live message. */
  receive(topic: string, message: unknown): void {
    this.live.receive(topic, message);
  }

  /** Whether a chosen signal needs this channel. */
  needs(topic: string): boolean {
    return this.live.names.some((name) => topicOf(name) === topic);
  }

  /** Shows a recording; undefined: the robot again. */
  look(frames: readonly Frame[] | undefined): void {
    if (frames === this.frames) return;
    const names = this.live.names;
    this.signals = this.live;
    this.fixed = undefined;
    if (frames !== undefined) {
      this.signals = new Signals(kRows, 0);
      for (const name of names) this.signals.choose(name);
      for (const { topic, message } of frames) this.signals.receive(topic, message);
      const span_s = (frames.at(-1)?.time_s ?? 0) - (frames[0]?.time_s ?? 0);
      this.window_s = Math.min(Math.max(span_s, kShortest_s), kSignalHistory_s);
    } else {
      this.window_s = kWindow_s;
    }
    this.frames = frames;
    this.rebuild();
  }

  show(store: Store): void {
    this.now_s = store.get('/estimate')?.t_s ?? NaN;
    this.showList();
    this.draw();
  }

  private get range(): TimeRange {
    if (this.fixed !== undefined) return this.fixed;
    const to_s = Number.isFinite(this.now_s) ? this.now_s : 0;
    const firsts = this.signals.names.map((name) => this.signals.of(name)?.first_s ?? NaN).filter(Number.isFinite);
    // If all signals began less than a window ago, the window begins with the first.
    const from_s = Math.max(to_s - this.window_s, Math.min(to_s, ...firsts));
    return { from_s, to_s: Math.max(to_s, from_s + this.window_s) };
  }

  private pause(): void {
    const { from_s, to_s } = this.range;
    // Later data is not shown.
    const end_s = this.now_s > from_s ? Math.min(to_s, this.now_s) : to_s;
    this.fixed = this.fixed === undefined ? { from_s, to_s: end_s } : undefined;
    this.draw();
  }

  private scale(factor: number): void {
    if (this.fixed === undefined) {
      this.window_s = Math.min(Math.max(this.window_s * factor, kShortest_s), kSignalHistory_s);
    } else {
      const { from_s, to_s } = this.fixed;
      const half_s = Math.min(Math.max(((to_s - from_s) * factor) / 2, kShortest_s / 20), kSignalHistory_s);
      const middle_s = (from_s + to_s) / 2;
      this.fixed = { from_s: middle_s - half_s, to_s: middle_s + half_s };
    }
    this.draw();
  }

  private choose(name: string): void {
    if (!isSignalTopic(topicOf(name)) || this.live.names.length >= kMaxFields) return;
    this.live.choose(name);
    if (this.signals !== this.live) {
      this.signals.choose(name);
      this.signals.before(name, (this.frames ?? []).filter(({ topic }) => topic === topicOf(name)).map(({ message }) => message));
    }
    this.past(topicOf(name)).then(
      (messages) => { this.live.before(name, messages); },
      () => undefined,
    );
    this.rebuild();
  }

  private drop(name: string): void {
    this.live.drop(name);
    this.signals.drop(name);
    this.rebuild();
  }

  /** Builds the diagrams of the chosen signals: one for each unit. */
  private rebuild(): void {
    const byUnit = new Map<string, string[]>();
    for (const name of this.live.names) {
      const unit = unitOf(name);
      byUnit.set(unit, [...(byUnit.get(unit) ?? []), name]);
    }
    for (const chart of this.charts) chart.destroy();
    this.charts = [...byUnit].map(([unit, names]) => new SignalChart(names, unit, (range) => {
      this.fixed = range;
      this.draw();
    }));
    this.charts_.replaceChildren(
      ...(this.charts.length === 0 ? [h('p', { class: 'empty' }, `Choose up to ${kMaxFields} fields; those of one unit share a diagram. Drag over a diagram to see a part of the time.`)] : this.charts.map((chart) => chart.element)),
    );
    localStorage.setItem(kRemembered, JSON.stringify(this.live.names));
    this.listed = '';
    this.showList();
    this.draw();
  }

  private draw(): void {
    setText(this.pauseButton, this.fixed === undefined ? 'Pause' : 'Continue');
    setAttribute(this.pauseButton, 'aria-pressed', String(this.fixed !== undefined));
    if (this.element.hidden) return;
    const range = this.range;
    for (const chart of this.charts) chart.show(this.signals, range, this.now_s);
  }

  private showList(): void {
    const chosen = this.live.names;
    const found = [...new Set([...this.live.fields, ...this.signals.fields, ...chosen])].sort().filter((name) => hasWords(name, this.search.value));
    const first = [...found.filter((name) => chosen.includes(name)), ...found.filter((name) => !chosen.includes(name))].slice(0, kListed);
    const key = `${first.join()} ${chosen.join()} ${found.length}`;
    if (key === this.listed) return;
    this.listed = key;
    setText(this.chosen, `Fields (${chosen.length} chosen)`);
    this.list.replaceChildren(...first.map((name) => this.item(name, chosen)), ...(found.length > first.length ? [h('li', { class: 'empty' }, `${found.length - first.length} more: search`)] : []));
  }

  private item(name: string, chosen: readonly string[]): HTMLElement {
    const check = h('input', { type: 'checkbox', 'aria-label': name });
    check.checked = chosen.includes(name);
    check.disabled = !check.checked && chosen.length >= kMaxFields;
    check.addEventListener('change', () => {
      if (check.checked) this.choose(name);
      else this.drop(name);
    });
    const unit = unitOf(name);
    return h('li', {}, h('label', {}, check, name, ...(unit === '' ? [] : [h('span', { class: 'plot-unit' }, unit)])));
  }

  private saveTable(): void {
    const { from_s, to_s } = this.range;
    const columns = this.live.names.map((name) => {
      const [times = new Float64Array(), values = new Float64Array()] = this.signals.of(name)?.since(-Infinity) ?? [];
      const inside = [...times.keys()].filter((i) => (times[i] ?? NaN) >= from_s && (times[i] ?? NaN) <= to_s);
      return { name, times: Float64Array.from(inside, (i) => times[i] ?? NaN), values: Float64Array.from(inside, (i) => values[i] ?? NaN) };
    });
    saveText('signals.csv', csv(columns));
  }
}

const tool = (id: string, text: string, title: string, press: () => void): HTMLButtonElement => button({ class: 'control', id, title }, text, press);

function remembered(): string[] {
  try {
    const names: unknown = JSON.parse(localStorage.getItem(kRemembered) ?? '[]');
    return Array.isArray(names) ? names.filter((name) => typeof name === 'string').slice(0, kMaxFields) : [];
  } catch {
    return [];
  }
}
