// All data that the views draw, from the channels of one source: the live daemon or a recording.
// Its memory is bounded.
import { kNoRights, onCourse, type Channels, type Estimate, type Event, type Pose, type SceneUpdate, type Slip, type State, type Topic } from './messages.ts';
import { PathHistory, Series } from './series.ts';

/** The battery warns this far above the voltage below which the daemon aborts the run. */
const kMargin_v = 0.3;
/** The voltage must be low for this long, because a starting motor lowers it for a moment. */
const kLasting_s = 2;
const kBack_v = 0.1;

export class BatteryWatch {
  private since_s: number | undefined;
  low = false;
  limit_v = NaN;

  take(t_s: number, voltage_v: number | null | undefined, limit_v: number | undefined): void {
    this.limit_v = limit_v ?? NaN;
    const warn_v = this.limit_v + kMargin_v;
    const known = typeof voltage_v === 'number' && limit_v !== undefined && limit_v > 0;
    if (!known || voltage_v > warn_v + (this.low ? kBack_v : 0)) {
      this.since_s = undefined;
      this.low = false;
      return;
    }
    if (this.since_s === undefined || t_s < this.since_s) this.since_s = t_s;
    if (t_s - this.since_s >= kLasting_s) this.low = true;
  }
}

/** Estimates with a covariance, and all poses that are drawn. */
export const kUncertain = ['model', 'odometry', 'fused'] as const;
export const kEstimates = [...kUncertain, 'truth'] as const;
export type EstimateName = (typeof kEstimates)[number];

const deg = (value_rad: number | undefined): number => ((value_rad ?? NaN) * 180) / Math.PI;
const error_mm = ({ truth }: Estimate, pose: Pose): number => (truth ? 1000 * Math.hypot(pose.x_m - truth.x_m, pose.y_m - truth.y_m) : NaN);

/** A sample that is older tells nothing of now. */
const kStaleSample_us = 400_000;
/** Below this speed of both tracks, slip is a ratio of noise. */
const kStill_mps = 0.005;
const moving = ({ tracks }: Estimate): boolean => Math.max(Math.abs(tracks.left_mps), Math.abs(tracks.right_mps)) > kStill_mps;
const slip_percent = (estimate: Estimate, ratio: number | undefined): number => (moving(estimate) ? 100 * (ratio ?? NaN) : NaN);
/** Whether a pose of the camera has ever come: without one, `fused` is the odometry once more. */
const seen = ({ steering, fused }: Estimate): boolean => steering === 'fused' || typeof fused.camera_age_us === 'number';

/** Columns of `Store.series` by name, in the units that the plots show. */
const kColumns = {
  t_s: (estimate) => estimate.t_s,
  desired_yaw_deg: (estimate) => deg(estimate.desired_yaw_rad),
  model_yaw_deg: (estimate) => deg(estimate.model.yaw_rad),
  odometry_yaw_deg: (estimate) => deg(estimate.odometry.yaw_rad),
  fused_yaw_deg: (estimate) => (seen(estimate) ? deg(estimate.fused.yaw_rad) : NaN),
  truth_yaw_deg: (estimate) => deg(estimate.truth?.yaw_rad),
  cross_track_mm: (estimate) => 1000 * estimate.cross_track_m,
  heading_error_deg: (estimate) => deg(estimate.heading_error_rad),
  left_mps: ({ tracks }) => tracks.left_mps,
  right_mps: ({ tracks }) => tracks.right_mps,
  left_commanded_mps: ({ tracks }) => tracks.left_commanded_mps ?? NaN,
  right_commanded_mps: ({ tracks }) => tracks.right_commanded_mps ?? NaN,
  slip_left_percent: (estimate, slip) => slip_percent(estimate, slip?.left),
  slip_right_percent: (estimate, slip) => slip_percent(estimate, slip?.right),
  fused_slip_left_percent: (estimate, slip) => (seen(estimate) ? slip_percent(estimate, slip?.fused_left) : NaN),
  fused_slip_right_percent: (estimate, slip) => (seen(estimate) ? slip_percent(estimate, slip?.fused_right) : NaN),
  model_error_mm: (estimate) => error_mm(estimate, estimate.model),
  odometry_error_mm: (estimate) => error_mm(estimate, estimate.odometry),
  fused_error_mm: (estimate) => (seen(estimate) ? error_mm(estimate, estimate.fused) : NaN),
} satisfies Record<string, (estimate: Estimate, slip: Slip | undefined) => number>;
export type Column = keyof typeof kColumns;

/** While no fresh sample comes, the daemon repeats what it last knew: a gap. */
const row = (estimate: Estimate, slip: Slip | undefined): number[] =>
  Object.values(kColumns).map((of) => (of === kColumns.t_s || (estimate.age_us ?? Infinity) < kStaleSample_us ? of(estimate, slip) : NaN));

/** One of the columns that Series.since gives. */
export function column(columns: readonly Float64Array[], name: Column): Float64Array {
  return columns[Object.keys(kColumns).indexOf(name)] ?? new Float64Array();
}

export const kHistory_s = 120;
const kInterval_s = 0.0199; // 50 rows a second
export const kEvents = 300;
/** A pose that moves further between two messages belongs to another run, daemon or part of a recording. */
const kJump_m = 0.5;

export const kStaleState_ms = 1000;
/** Above this age a value is grey; without one, never. */
const kStale_ms: Partial<Record<Topic, number>> = {
  '/estimate': 600,
  '/slip': 1000,
  '/link': 2500,
  '/loop': 1500,
  '/state': kStaleState_ms,
  '/client': 3000,
  '/camera/image': 2500,
};

/** Messages of all stores. */
let received = 0;

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
  /** Number of the newest message by topic, counted over all stores, by which views detect other data. */
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
    this.received[topic] = ++received;
  }

  /** True if the data of `topic` is too old to be used. */
  stale(topic: Topic): boolean {
    const received_ms = this.received_ms[topic];
    if (received_ms === undefined || this.now() - received_ms > (kStale_ms[topic] ?? Infinity)) return true;
    if (topic !== '/estimate' && topic !== '/slip') return false;
    const age_us = this.latest['/estimate']?.age_us;
    return age_us === undefined || age_us > kStaleSample_us;
  }

  /** The steering pose. */
  get pose(): Pose | undefined {
    const estimate = this.latest['/estimate'];
    return estimate?.[estimate.steering];
  }

  /** Of each track; unknown at standstill. */
  get slip(): { left: number; right: number } {
    const estimate = this.latest['/estimate'];
    const slip = this.latest['/slip'];
    if (estimate === undefined || !moving(estimate)) return { left: NaN, right: NaN };
    return { left: slip?.left ?? NaN, right: slip?.right ?? NaN };
  }

  /** Whether the fused pose tells more than the odometry. */
  get usesCamera(): boolean {
    const estimate = this.latest['/estimate'];
    return estimate !== undefined && seen(estimate);
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

  /** Resets the store, but not the numbers of its messages. */
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

/** Why this page may change nothing now; empty: it may. */
export function whyNot(store: Store, connected: boolean, mayCommand: boolean): string {
  if (!connected || store.stale('/state')) return 'No connection to tp100d.';
  if (!mayCommand) return `${kNoRights}.`;
  const run = store.get('/state')?.run;
  if (run === 'driving') return 'The robot is driven by hand; release it first.';
  return onCourse(run) ? 'A run is under way; stop it first.' : '';
}
