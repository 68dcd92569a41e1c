// Lateness of the loop's cycles: one bar per class, heights logarithmic.
import { count, duration } from '../state/format.ts';
import type { Store } from '../state/store.ts';
import { h, setAttribute, setClass, setText } from './dom.ts';

export class Histogram {
  readonly element: HTMLElement;
  private readonly bars = h('div', { class: 'bars', role: 'img' });
  private readonly labels = h('div', { class: 'bar-labels', 'aria-hidden': 'true' });
  private readonly figures: Record<'p50' | 'p99.9' | 'max', HTMLElement>;
  private edges = '';
  private shown = -1;

  constructor() {
    const figure = (): HTMLElement => h('span', { class: 'plot-value wide' });
    this.figures = { p50: figure(), 'p99.9': figure(), max: figure() };
    const key = h('div', { class: 'plot-key' });
    for (const [name, value] of Object.entries(this.figures)) key.append(h('span', { class: 'plot-curve' }, name, value));
    this.element = h(
      'section',
      { class: 'plot histogram', id: 'plot-lateness', 'aria-label': 'Lateness of the loop' },
      h('header', {}, h('h2', {}, 'Loop lateness', h('span', { class: 'plot-unit' }, 'cycles, log')), key),
      this.bars,
      this.labels,
    );
  }

  show(store: Store): void {
    const loop = store.get('/loop');
    setClass(this.element, 'stale', store.stale('/loop'));
    const received = store.received['/loop'] ?? 0;
    if (received === this.shown) return;
    this.shown = received;
    if (loop === undefined) {
      this.clear();
      return;
    }
    const { edges_us: edges, lateness } = loop.histogram;
    this.build(edges);
    const most = Math.log10(Math.max(10, ...lateness) + 1);
    lateness.forEach((cycles, i) => {
      const bar = this.bars.children[i] as HTMLElement | undefined;
      if (bar === undefined) return;
      bar.style.transform = `scaleY(${(cycles === 0 ? 0 : Math.max(0.02, Math.log10(cycles + 1) / most)).toFixed(3)})`;
      const from = i === 0 ? 'below ' : `${duration(edges[i - 1])} to `;
      setAttribute(bar, 'title', `${i === edges.length ? 'over ' + duration(edges.at(-1)) : from + duration(edges[i])}: ${count(cycles)}`);
    });
    setText(this.figures.p50, duration(loop.lateness_us.p50));
    setText(this.figures['p99.9'], duration(loop.lateness_us.p999));
    setText(this.figures.max, duration(loop.lateness_us.max));
    const summary = `median ${duration(loop.lateness_us.p50)}, worst ${duration(loop.lateness_us.max)} of ${count(loop.cycles)} cycles`;
    setAttribute(this.bars, 'aria-label', summary);
  }

  private clear(): void {
    this.edges = '';
    this.bars.replaceChildren();
    this.labels.replaceChildren();
    for (const figure of Object.values(this.figures)) setText(figure, '');
  }

  private build(edges: readonly number[]): void {
    const key = edges.join();
    if (key === this.edges) return;
    this.edges = key;
    this.bars.replaceChildren(...[...edges, 0].map(() => h('i')));
    this.labels.replaceChildren(
      ...[...edges, 0].map((edge, i) => {
        const decade = i < edges.length && Number.isInteger(Math.log10(edge));
        return h('span', {}, ...(decade ? [h('b', {}, duration(edge))] : []));
      }),
    );
  }
}
