// All data that the views draw, from the channels of one source: the live daemon or a recording.
// Its memory is bounded.
import type { Channels, Estimate, Event, Pose, SceneUpdate, Slip, State, Topic } from './messages.ts';
import { BatteryWatch } from './battery.ts';
import { Series } from './series.ts';
import { PathHistory } from './path_history.ts';

/** Estimates with a covariance, and all poses that are drawn. */
export const kUncertain = ['model', 'odometry', 'fused'] as const;
export const kEstimates = [...kUncertain, 'truth'] as const;
export type EstimateName = (typeof kEstimates)[number];

/** Columns of `Store.series`, in the units that the plots show. */
export const kColumns = {
  t_s: 0,
  desired_yaw_deg: 1,
  model_yaw_deg: 2,
  odometry_yaw_deg: 3,
  fused_yaw_deg: 4,
  truth_yaw_deg: 5,
  cross_track_mm: 6,
  heading_error_deg: 7,
  left_mps: 8,
  right_mps: 9,
  left_commanded_mps: 10,
  right_commanded_mps: 11,
  slip_left_percent: 12,
  slip_right_percent: 13,
  fused_slip_left_percent: 14,
  fused_slip_right_percent: 15,
  model_error_mm: 16,
  odometry_error_mm: 17,
  fused_error_mm: 18,
} as const;
export type Column = keyof typeof kColumns;

export const kHistory_s = 120;
const kInterval_s = 0.0199; // 50 rows a second
export const kEvents = 300;
/** A pose that moves further between two messages belongs to another run, daemon or part of a recording. */
const kJump_m = 0.5;

/** Above this age a value is grey. */
export const kStale_ms: Record<Topic, number> = {
  '/estimate': 400,
  '/slip': 600,
  '/sample': 400,
  '/command': 400,
  '/link': 1000,
  '/loop': 1500,
  '/state': 1000,
  '/course': Infinity,
  '/event': Infinity,
  '/parameter': Infinity,
  '/recording': Infinity,
  '/client': 3000,
  '/path_history': Infinity,
  '/camera/image': 2500,
};
const kStaleSample_us = 400_000;

export class Store {
  readonly series = new Series(Object.keys(kColumns).length, Math.ceil(kHistory_s / kInterval_s), kInterval_s);
  readonly path_histories: Record<EstimateName, PathHistory> = {
    model: new PathHistory(),
    odometry: new PathHistory(),
    fused: new PathHistory(),
    truth: new PathHistory(),
  };
  readonly events: Event[] = [];
  readonly battery = new BatteryWatch();
  /** Distance of each track. */
  leftTrack_m = 0;
  rightTrack_m = 0;
  /** Number of messages received so far, by topic, by which views detect new data. */
  readonly received: Record<string, number> = {};

  private readonly latest: { [T in Topic]?: Channels[T] } = {};
  private readonly received_ms: Record<string, number> = {};

  constructor(private readonly now: () => number = () => performance.now()) {}

  get<T extends Topic>(topic: T): Channels[T] | undefined {
    return this.latest[topic];
  }

  receive<T extends Topic>(topic: T, message: Channels[T]): void {
    if (topic === '/estimate') this.estimate(message as Estimate);
    else if (topic === '/event') this.event(message as Event);
    else if (topic === '/state') this.state(message as State);
    else if (topic === '/path_history') this.history(message as SceneUpdate);
    this.latest[topic] = message as never;
    this.received_ms[topic] = this.now();
    this.received[topic] = (this.received[topic] ?? 0) + 1;
  }

  /** True if the data of `topic` is too old to be used. */
  stale(topic: Topic): boolean {
    const received_ms = this.received_ms[topic];
    if (received_ms === undefined || this.now() - received_ms > kStale_ms[topic]) return true;
    if (topic !== '/estimate' && topic !== '/slip') return false;
    const age_us = this.latest['/estimate']?.age_us;
    return age_us === undefined || age_us === null || age_us > kStaleSample_us;
  }

  /** The steering pose. */
  get pose(): Pose | undefined {
    const estimate = this.latest['/estimate'];
    return estimate?.[estimate.steering];
  }

  /** Adds the daemon's messages from before this page was opened. */
  before(estimates: readonly Estimate[], slips: readonly Slip[]): void {
    let next = 0;
    this.series.before(
      estimates.map((estimate) => {
        while ((slips[next + 1]?.t_s ?? Infinity) <= estimate.t_s) next++;
        return row(estimate, slips[next]);
      }),
    );
  }

  /** Resets the store, but not the message counts, so that every view updates. */
  clear(): void {
    this.series.clear();
    this.clearTrails();
    this.events.length = 0;
    this.leftTrack_m = this.rightTrack_m = 0;
    for (const topic of Object.keys(this.latest) as Topic[]) Reflect.deleteProperty(this.latest, topic);
  }

  clearTrails(): void {
    for (const name of kEstimates) this.path_histories[name].clear();
  }

  private estimate(next: Estimate): void {
    const last = this.latest['/estimate'];
    if (last !== undefined) {
      const dt_s = next.t_s - last.t_s;
      if (dt_s > 0 && dt_s < 1) {
        this.leftTrack_m += next.tracks.left_mps * dt_s;
        this.rightTrack_m += next.tracks.right_mps * dt_s;
      }
      const jump_m = Math.hypot(next.model.x_m - last.model.x_m, next.model.y_m - last.model.y_m);
      if (jump_m > kJump_m || dt_s < 0) this.clearTrails();
    }
    for (const name of kEstimates) {
      const pose = next[name];
      if (pose) this.path_histories[name].add(pose.x_m, pose.y_m, pose.z_m);
    }
    this.series.push(row(next, this.latest['/slip']));
  }

  private event(event: Event): void {
    // The daemon repeats the kept events on each connection.
    const known = this.events.some((other) => other.t_s === event.t_s && other.text === event.text);
    if (known) return;
    this.events.push(event);
    if (this.events.length > kEvents) this.events.shift();
  }

  private state(next: State): void {
    const began = next.run === 'running' && this.latest['/state']?.run === 'arming';
    if (began) this.clearTrails();
    const limit = this.latest['/parameter']?.parameters.find(({ name }) => name === 'control.min_battery_v')?.value;
    this.battery.take(next.t_s, next.battery_v, typeof limit === 'number' ? limit : undefined);
  }

  /** The path driven before this viewer connected. */
  private history(update: SceneUpdate): void {
    for (const name of ['model', 'odometry', 'fused'] as const) {
      const path_history = this.path_histories[name];
      if (path_history.length > 10) continue;
      const strips = update.entities.filter((entity) => entity.id.startsWith(`path_history/${name}/`));
      if (strips.length === 0) continue;
      path_history.clear();
      for (const strip of strips) {
        for (const line of strip.lines) for (const { x, y, z } of line.points) path_history.add(x, y, z);
      }
    }
  }
}

function row(estimate: Estimate, slip: Slip | undefined): number[] {
  const { model, odometry, fused, truth, tracks } = estimate;
  const deg = (value_rad: number | undefined): number => ((value_rad ?? NaN) * 180) / Math.PI;
  const error_mm = (pose: Pose): number =>
    truth ? 1000 * Math.hypot(pose.x_m - truth.x_m, pose.y_m - truth.y_m) : NaN;
  return [
    estimate.t_s,
    deg(estimate.desired_yaw_rad),
    deg(model.yaw_rad),
    deg(odometry.yaw_rad),
    deg(fused.yaw_rad),
    deg(truth?.yaw_rad),
    1000 * estimate.cross_track_m,
    deg(estimate.heading_error_rad),
    tracks.left_mps,
    tracks.right_mps,
    tracks.left_commanded_mps ?? NaN,
    tracks.right_commanded_mps ?? NaN,
    100 * (slip?.left ?? NaN),
    100 * (slip?.right ?? NaN),
    100 * (slip?.fused_left ?? NaN),
    100 * (slip?.fused_right ?? NaN),
    error_mm(model),
    error_mm(odometry),
    error_mm(fused),
  ];
}
