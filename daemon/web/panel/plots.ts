// The column of diagrams.
import type { Store } from '../state/store.ts';
import { h, setClass } from './dom.ts';
import { Plot } from './plot.ts';

const kPlan = { colour: 'path' as const, dash: [5, 4], width: 1.2 };

export class Plots {
  readonly element = h('div', { class: 'plots' });
  /** Length of the shown time window. */
  window_s = 60;
  private readonly plots: Plot[];
  private readonly truth: Plot;

  constructor() {
    this.truth = new Plot({
      id: 'truth',
      title: 'Error to truth',
      unit: 'mm',
      decimals: 1,
      soft: [0, 10],
      curves: [
        { label: 'model', column: 'model_error_mm', colour: 'model' },
        { label: 'odom', column: 'odometry_error_mm', colour: 'odometry' },
        { label: 'fused', column: 'fused_error_mm', colour: 'fused' },
      ],
    });
    this.truth.element.hidden = true;
    this.plots = [
      new Plot({
        id: 'yaw',
        title: 'Yaw',
        unit: '°',
        decimals: 1,
        soft: [-10, 10],
        curves: [
          { label: 'truth', column: 'truth_yaw_deg', colour: 'truth', quiet: true },
          { label: 'model', column: 'model_yaw_deg', colour: 'model' },
          { label: 'odom', column: 'odometry_yaw_deg', colour: 'odometry' },
          { label: 'fused', column: 'fused_yaw_deg', colour: 'fused' },
          { label: 'plan', column: 'desired_yaw_deg', ...kPlan, nameOnly: true },
        ],
      }),
      new Plot({
        id: 'error',
        title: 'Tracking error',
        unit: 'mm, °',
        decimals: 1,
        soft: [-4, 4],
        curves: [
          { label: 'cross-track', column: 'cross_track_mm', colour: 'text' },
          { label: 'heading °', column: 'heading_error_deg', colour: 'value' },
        ],
      }),
      this.truth,
      new Plot({
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
      }),
      new Plot({
        id: 'slip',
        title: 'Slip',
        unit: '%',
        decimals: 1,
        soft: [0, 20],
        times: true,
        curves: [
          { label: 'fused left', column: 'fused_slip_left_percent', colour: 'left', dash: [3, 3], width: 1, quiet: true },
          { label: 'fused right', column: 'fused_slip_right_percent', colour: 'right', dash: [3, 3], width: 1, quiet: true },
          { label: 'left', column: 'slip_left_percent', colour: 'left' },
          { label: 'right', column: 'slip_right_percent', colour: 'right' },
        ],
      }),
    ];
    this.element.append(...this.plots.map((plot) => plot.element));
    const resized = new ResizeObserver(() => {
      for (const plot of this.plots) plot.resize();
    });
    resized.observe(this.element);
  }

  show(store: Store): void {
    if (store.get('/estimate')?.truth) this.truth.element.hidden = false;
    setClass(this.element, 'with-truth', !this.truth.element.hidden);
    for (const plot of this.plots) {
      if (!plot.element.hidden) {
        plot.resize();
        plot.show(store, this.window_s);
      }
    }
  }
}
