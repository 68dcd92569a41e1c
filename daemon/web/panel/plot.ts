// One diagram over time, with its legend and the values under the cursor in the head line.
import uPlot from 'uplot';
import { fixed } from '../state/format.ts';
import { extent, niceRange } from '../state/series.ts';
import { column, type Column, type Store } from '../state/store.ts';
import { colour, type Colour } from '../scene/palette.ts';
import { h, setClass, setText } from './dom.ts';

export interface Curve {
  label: string;
  column: Column;
  colour: Colour;
  dash?: number[];
  width?: number;
  /** `quiet`: not in the head line at all; `nameOnly`: there without a figure. */
  quiet?: boolean;
  nameOnly?: boolean;
}

export interface PlotOptions {
  id: string;
  title: string;
  unit: string;
  decimals: number;
  soft: [number, number];
  curves: Curve[];
}

const kAxis_px = 44;
const kTimes_px = 20;
/** How axes are drawn. Colours as functions, called at every drawing, because the theme may change. */
export const kAxis: uPlot.Axis = { stroke: () => colour('dim'), font: '11px B612, sans-serif', grid: { stroke: () => colour('axis-grid'), width: 1 }, ticks: { show: false } };

/** A curve in the head line of its diagram. */
export function keyOf(label: string, name: Colour, values: HTMLElement[], dash?: number[]): HTMLElement {
  const swatch = h('i', { class: dash ? 'swatch dashed' : 'swatch' });
  swatch.style.color = `var(--${name})`;
  return h('span', { class: 'plot-curve' }, swatch, label, ...values);
}

export class Plot {
  readonly element: HTMLElement;
  private readonly canvas = h('div', { class: 'plot-canvas' });
  private readonly values: HTMLElement[] = [];
  private readonly keys: (HTMLElement | undefined)[] = [];
  private readonly plot: uPlot;
  private end_s = 1;
  private from_s = 0;
  private range: [number, number];

  /** `head`: before the legend; it names the diagram. */
  constructor(private readonly options: PlotOptions, head: HTMLElement) {
    this.range = niceRange(NaN, NaN, options.soft);
    const key = h('div', { class: 'plot-key' });
    for (const curve of options.curves) {
      const value = h('span', { class: 'plot-value' });
      this.values.push(value);
      const named = curve.quiet === true ? undefined : keyOf(curve.label, curve.colour, curve.nameOnly === true ? [] : [value], curve.dash);
      this.keys.push(named);
      if (named !== undefined) key.append(named);
    }
    this.element = h(
      'section',
      { class: 'plot', id: `plot-${options.id}`, 'aria-label': `${options.title}, ${options.unit}` },
      h('header', {}, head, h('span', { class: 'plot-unit' }, options.unit), key),
      this.canvas,
    );
    this.plot = new uPlot(this.uplotOptions(), options.curves.reduce<number[][]>((all) => [...all, []], [[]]) as uPlot.AlignedData, this.canvas);
  }

  resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0 && (width !== this.plot.width || height !== this.plot.height)) {
      this.plot.setSize({ width, height });
    }
  }

  destroy(): void {
    this.plot.destroy();
  }

  /** Draws the `window_s` before the newest row. */
  show(store: Store, window_s: number): void {
    setClass(this.element, 'stale', store.stale('/estimate'));
    if (store.series.length === 0) return;
    this.end_s = store.series.last_s;
    this.from_s = Math.max(this.end_s - window_s, 0);
    this.end_s = Math.max(this.end_s, this.from_s + window_s);
    const columns = store.series.since(this.from_s);
    const curves = this.options.curves.map((curve) => column(columns, curve.column));
    // Not the one that the diagram finds: a gap, NaN, would make it unknown.
    this.range = niceRange(...extent(curves), this.options.soft);
    this.plot.setData([column(columns, 't_s'), ...curves]);
    this.figures();
    for (const [i, curve] of this.options.curves.entries()) this.keys[i]?.toggleAttribute('hidden', curve.colour === 'fused' && !store.usesCamera);
  }

  /** The values of the newest row, or of the one under the cursor. */
  private figures(): void {
    const data = this.plot.data as unknown as Float64Array[];
    const index = this.plot.cursor.idx ?? (data[0]?.length ?? 0) - 1;
    this.values.forEach((element, i) => {
      setText(element, fixed(data[i + 1]?.[index], this.options.decimals));
    });
  }

  private uplotOptions(): uPlot.Options {
    return {
      width: 300,
      height: 100,
      legend: { show: false },
      padding: [6, 10, 0, 0],
      cursor: { y: false, points: { size: 5 }, drag: { x: false, y: false } },
      scales: {
        x: { time: false, range: () => [this.from_s, this.end_s] },
        y: { range: () => this.range },
      },
      axes: [
        {
          ...kAxis,
          size: kTimes_px,
          gap: 4,
          space: 48,
          values: (_, splits) => splits.map((t_s) => fixed(t_s, 0)),
        },
        {
          ...kAxis,
          size: kAxis_px,
          gap: 6,
          space: 22,
          values: (_, splits) => splits.map((value) => fixed(value, tickDecimals(splits))),
        },
      ],
      series: [
        {},
        ...this.options.curves.map((curve) => ({
          stroke: () => colour(curve.colour),
          width: curve.width ?? 1.5,
          ...(curve.dash ? { dash: curve.dash } : {}),
          points: { show: false },
        })),
      ],
      hooks: { setCursor: [() => { this.figures(); }] },
    };
  }
}

/** Digits needed to distinguish the ticks. */
export function tickDecimals(splits: readonly number[], most = 3): number {
  const step = Math.abs((splits[1] ?? 1) - (splits[0] ?? 0));
  return Math.max(0, Math.min(most, Math.ceil(-Math.log10(step) - 1e-9) + (/[^0]5/.test(step.toPrecision(2)) ? 1 : 0)));
}
