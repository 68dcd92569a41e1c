// One diagram at a time, chosen from a list; the choice is remembered.
import type { Store } from '../state/store.ts';
import { h } from './dom.ts';
import { Plot, type PlotOptions } from './plot.ts';

const kRemembered = 'tp100.plot';
const kPlan = { colour: 'path' as const, dash: [5, 4], width: 1.2 };

const kPlots: PlotOptions[] = [
  {
    id: 'error',
    title: 'Tracking error',
    unit: 'mm, °',
    decimals: 1,
    soft: [-4, 4],
    curves: [
      { label: 'cross-track', column: 'cross_track_mm', colour: 'text' },
      { label: 'heading °', column: 'heading_error_deg', colour: 'value' },
    ],
  },
  {
    id: 'speed',
    title: 'Track speed',
    unit: 'm/s',
    decimals: 3,
    soft: [-0.05, 0.15],
    curves: [
      { label: 'wanted left', column: 'left_commanded_mps', colour: 'left', dash: [3, 3], width: 1, quiet: true },
      { label: 'wanted right', column: 'right_commanded_mps', colour: 'right', dash: [3, 3], width: 1, quiet: true },
      { label: 'left', column: 'left_mps', colour: 'left' },
      { label: 'right', column: 'right_mps', colour: 'right' },
    ],
  },
  {
    id: 'yaw',
    title: 'Yaw',
    unit: '°',
    decimals: 1,
    soft: [-10, 10],
    curves: [
      { label: 'truth', column: 'truth_yaw_deg', colour: 'truth', quiet: true },
      { label: 'model', column: 'model_yaw_deg', colour: 'model' },
      { label: 'odometry', column: 'odometry_yaw_deg', colour: 'odometry' },
      { label: 'fused', column: 'fused_yaw_deg', colour: 'fused' },
      { label: 'plan', column: 'desired_yaw_deg', ...kPlan, nameOnly: true },
    ],
  },
  {
    id: 'slip',
    title: 'Slip',
    unit: '%',
    decimals: 1,
    soft: [0, 20],
    curves: [
      { label: 'fused left', column: 'fused_slip_left_percent', colour: 'left', dash: [3, 3], width: 1, quiet: true },
      { label: 'fused right', column: 'fused_slip_right_percent', colour: 'right', dash: [3, 3], width: 1, quiet: true },
      { label: 'left', column: 'slip_left_percent', colour: 'left' },
      { label: 'right', column: 'slip_right_percent', colour: 'right' },
    ],
  },
  {
    id: 'truth',
    title: 'Error to truth',
    unit: 'mm',
    decimals: 1,
    soft: [0, 10],
    curves: [
      { label: 'model', column: 'model_error_mm', colour: 'model' },
      { label: 'odometry', column: 'odometry_error_mm', colour: 'odometry' },
      { label: 'fused', column: 'fused_error_mm', colour: 'fused' },
    ],
  },
];

export class Plots {
  readonly element = h('div', { class: 'plots' });
  /** Length of the shown time window. */
  window_s = 60;
  private readonly choice = h('select', { id: 'choose-plot', 'aria-label': 'Diagram' });
  private plot: Plot;

  constructor() {
    for (const { id, title } of kPlots) this.choice.append(h('option', { value: id }, title));
    this.choice.value = localStorage.getItem(kRemembered) ?? '';
    if (this.choice.selectedIndex < 0) this.choice.selectedIndex = 0;
    this.plot = this.make();
    this.choice.addEventListener('change', () => {
      localStorage.setItem(kRemembered, this.choice.value);
      this.plot.destroy();
      this.plot = this.make();
    });
    new ResizeObserver(() => { this.plot.resize(); }).observe(this.element);
  }

  show(store: Store): void {
    const truth = this.choice.querySelector('[value=truth]');
    if (truth instanceof HTMLOptionElement && this.choice.value !== 'truth') truth.hidden = !store.get('/estimate')?.truth;
    this.plot.resize();
    this.plot.show(store, this.window_s);
  }

  private make(): Plot {
    const options = kPlots[this.choice.selectedIndex] ?? kPlots[0];
    if (options === undefined) throw new Error('no diagram');
    const plot = new Plot(options, this.choice);
    this.element.replaceChildren(plot.element);
    return plot;
  }
}
