// A diagram of signals with the same unit. Dragging selects a time range.
import uPlot from 'uplot';
import { colour, type Colour } from '../scene/palette.ts';
import { fixed } from '../state/format.ts';
import { extent, niceRange } from '../state/series.ts';
import type { Signals } from '../state/signals.ts';
import { h, setText } from './dom.ts';
import { kAxis, keyOf, tickDecimals } from './plot.ts';

export interface TimeRange {
  from_s: number;
  to_s: number;
}

const kColours: readonly Colour[] = ['odometry', 'warn', 'fused', 'bad', 'value', 'run-5', 'run-2', 'run-3'];
const kHeight_px = 170;

export class SignalChart {
  readonly element: HTMLElement;
  private readonly canvas = h('div', { class: 'plot-canvas' });
  private readonly values: HTMLElement[] = [];
  private readonly plot: uPlot;
  private range: TimeRange = { from_s: 0, to_s: 1 };
  private now_s = NaN;
  private y: [number, number] = [0, 1];

  constructor(
    readonly names: readonly string[],
    readonly unit: string,
    private readonly zoom: (range: TimeRange) => void,
  ) {
    const key = h('div', { class: 'plot-key' });
    names.forEach((name, i) => {
      const value = h('span', { class: 'plot-value' });
      this.values.push(value);
      key.append(keyOf(name, colourOf(i), [value]));
    });
    this.element = h('section', { class: 'plot signal-chart', 'aria-label': `${names.join(', ')} ${unit}` }, h('header', {}, key, h('span', { class: 'plot-unit' }, unit)), this.canvas);
    this.plot = new uPlot(this.options(), [[], ...names.map(() => [])], this.canvas);
  }

  /** `now_s`: current time of the robot or position in the recording. */
  show(signals: Signals, range: TimeRange, now_s: number): void {
    this.range = range;
    this.now_s = now_s;
    const tables: uPlot.AlignedData[] = [];
    const visible: Float64Array[] = [];
    for (const name of this.names) {
      const [times = new Float64Array(), values = new Float64Array()] = signals.of(name)?.since(range.from_s) ?? [];
      let end = times.length;
      while (end > 1 && (times[end - 2] ?? 0) > range.to_s) end--;
      tables.push([times.subarray(0, end), values.subarray(0, end)]);
      visible.push(values.subarray(0, end));
    }
    const [low, high] = extent(visible);
    const flat = high > low ? 0 : Math.max(Math.abs(low) * 0.01, 1e-6);
    this.y = niceRange(low - flat, high + flat, [low - flat, high + flat]);
    const { clientWidth } = this.canvas;
    if (clientWidth > 0 && clientWidth !== this.plot.width) this.plot.setSize({ width: clientWidth, height: kHeight_px });
    this.plot.setData(uPlot.join(tables));
    this.figures();
  }

  destroy(): void {
    this.plot.destroy();
    this.element.remove();
  }

  private figures(): void {
    const at = this.plot.cursor.idx;
    this.names.forEach((_, i) => {
      const column = this.plot.data[i + 1] ?? [];
      let index = at ?? column.length - 1;
      // Signals have values at different times: take the last one before.
      while (index > 0 && (column[index] === undefined || column[index] === null)) index--;
      const value = column[index] ?? NaN;
      const element = this.values[i];
      if (element !== undefined) setText(element, Number.isFinite(value) ? fixed(value, decimals(this.y)) : fixed(null, 0));
    });
  }

  private options(): uPlot.Options {
    return {
      width: 300,
      height: kHeight_px,
      legend: { show: false },
      padding: [6, 10, 0, 0],
      cursor: { y: false, points: { size: 5 }, drag: { x: true, y: false, setScale: false }, sync: { key: 'signals', setSeries: false } },
      scales: {
        x: { time: false, range: () => [this.range.from_s, this.range.to_s] },
        y: { range: () => this.y },
      },
      axes: [
        { ...kAxis, size: 20, gap: 4, space: 60, values: (_, splits) => splits.map((t_s) => `${fixed(t_s, splits.length > 1 && (splits[1] ?? 0) - (splits[0] ?? 0) < 1 ? 2 : 0)} s`) },
        { ...kAxis, size: 58, gap: 6, space: 24, values: (_, splits) => splits.map((value) => fixed(value, tickDecimals(splits, 7))) },
      ],
      series: [{}, ...this.names.map((_, i) => ({ stroke: () => colour(colourOf(i)), width: 1.5, points: { show: false }, spanGaps: true }))],
      hooks: {
        setCursor: [() => { this.figures(); }],
        setSelect: [
          (plot) => {
            if (plot.select.width < 4) return;
            const from_s = plot.posToVal(plot.select.left, 'x');
            const to_s = plot.posToVal(plot.select.left + plot.select.width, 'x');
            plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
            this.zoom({ from_s, to_s });
          },
        ],
        draw: [(plot) => { this.drawNow(plot); }],
      },
    };
  }

  private drawNow(plot: uPlot): void {
    if (!(this.now_s > this.range.from_s && this.now_s < this.range.to_s)) return;
    const x = plot.valToPos(this.now_s, 'x', true);
    plot.ctx.fillStyle = colour('dim');
    plot.ctx.fillRect(Math.round(x), plot.bbox.top, 1, plot.bbox.height);
  }
}

function colourOf(index: number): Colour {
  return kColours[index % kColours.length] ?? 'text';
}

function decimals([low, high]: [number, number]): number {
  return Math.max(0, Math.min(6, 3 - Math.ceil(Math.log10(high - low || 1))));
}
