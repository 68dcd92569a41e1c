// What the page reads of the daemon's channels (daemon/messages/CHANNELS.md). SI units, REP-103 frames. Unknown values are
// left out; recordings of older versions have null there.

/** A place on the floor and a direction. */
export interface FloorPose {
  x_m: number;
  y_m: number;
  yaw_rad: number;
}

export interface Pose extends FloorPose {
  z_m: number;
  roll_rad: number;
  pitch_rad: number;
}

/** An estimate's pose with its rates and standard deviations, which older recordings have of the fused pose only. */
export interface EstimatedPose extends Pose {
  vx_mps: number;
  yaw_rate_radps: number;
  sd_x_m?: number | null;
  sd_y_m?: number | null;
}

export interface Estimate {
  t_s: number;
  age_us?: number | null;
  steering: 'model' | 'odometry' | 'fused';
  model: EstimatedPose;
  odometry: EstimatedPose;
  fused: EstimatedPose & { camera_age_us?: number | null };
  truth?: Pose | null;
  tracks: {
    left_mps: number;
    right_mps: number;
    left_commanded_mps?: number | null;
    right_commanded_mps?: number | null;
  };
  cross_track_m: number;
  heading_error_rad: number;
  desired_yaw_rad: number;
  desired_speed_mps: number;
  at_fence?: boolean;
  progress_m: number;
}

export interface Slip {
  t_s: number;
  left: number;
  right: number;
  fused_left: number;
  fused_right: number;
}

export interface Distribution {
  p50: number;
  p99: number;
  p999: number;
  max: number;
}

export type Session = 'closed' | 'listening' | 'hello' | 'parameters' | 'syncing' | 'ready' | 'refused';

export interface Link {
  session: Session;
  quality: 'good' | 'poor' | 'lost';
  port: string;
  note?: string;
  /** Known once a board has sent something. */
  kind?: 'physical' | 'emulated' | 'simulated';
  firmware?: string | null;
  samples_hz: number;
  lost_hz: number;
  bad_hz: number;
  in_bytes_ps: number;
  out_bytes_ps: number;
  round_trip_us?: number | null;
  clock: { valid: boolean; drift_ppm: number; uncertainty_us: number };
  sample_age_us: Distribution;
  counters: Record<string, number>;
}

export interface Loop {
  rate_hz: number;
  pacing: string;
  cycles: number;
  overruns: number;
  missed: number;
  lateness_us: Distribution;
  work_us: Distribution;
  compute_us: Distribution;
  write_us: Distribution;
  sample_wire_us: Distribution;
  sample_wait_us: Distribution;
  histogram: { edges_us: number[]; lateness: number[] };
  privileges: Record<string, boolean>;
}

export type Run = 'idle' | 'arming' | 'running' | 'finished' | 'aborted' | 'driving';

/** A course is being driven, or is about to be. */
export const onCourse = (run: Run | undefined): boolean => run === 'arming' || run === 'running';

/** Why a viewer whom server.commands does not allow may not command. */
export const kNoRights = 'This daemon accepts only STOP from here (server.commands)';

/** Motion was requested: on a course or by hand. */
export const asksForMotion = (run: Run | undefined): boolean => onCourse(run) || run === 'driving';

export interface Fault {
  name: string;
  cause: string;
  fix: string;
}

export interface StopState {
  count: number;
  latched: boolean;
  by: string;
  status: 'none' | 'pending' | 'acknowledged' | 'not_acknowledged';
  acknowledged_ms?: number | null;
}

export interface State {
  t_s: number;
  run: Run;
  session: Session;
  motors_on: boolean;
  run_s?: number | null;
  progress_m?: number | null;
  length_m?: number | null;
  course: string;
  robot: string;
  setup: string;
  battery_v?: number | null;
  /** The steering pose; not in recordings of older versions. */
  pose?: FloorPose;
  /** True: the daemon stops a run or a drive that nobody watches, by calls of `watch`. Not in older recordings. */
  watch?: boolean;
  /** While the run pauses: time until it ends. This and fields about driving by hand: not in older recordings. */
  pause_left_s?: number;
  can: { start: boolean; drive?: boolean; pause?: boolean; resume?: boolean; hold: boolean; record: boolean };
  /** Where the robot is estimated to be, if the last run ended before the end of its course. */
  continue_from?: FloorPose;
  why_not_start: string;
  why_not_drive?: string;
  driver?: { by: string; fresh: boolean; asked_by?: string };
  /** Not in recordings of older versions. */
  confirm_start?: boolean;
  faults: Fault[];
  stop: StopState;
}

export interface Place {
  x_m: number;
  y_m: number;
  heading_rad: number;
}

/** What rises from the floor, of any kind: its side view along its own x axis, from its near foot to its far one. */
export interface Obstacle extends Place {
  kind: string;
  width_m: number;
  profile: { along_m: number; height_m: number }[];
}

/** The rectangle that a piece takes up. */
export interface Footprint extends Place {
  length_m: number;
  width_m: number;
}

export interface PathPoint extends FloorPose {
  /** Height of the ground. */
  z_m: number;
  /** Distance along the path. */
  s_m: number;
}

/** A part of the path; of a turn on the spot, both distances are the same. */
export interface Segment {
  kind: string;
  from_m: number;
  to_m: number;
  begin: FloorPose;
  end: FloorPose;
}

export interface RobotShape {
  length_m: number;
  width_m: number;
  height_m: number;
  gauge_m: number;
  axle_spacing_m: number;
  wheel_radius_m: number;
  shoe_width_m: number;
}

/** A polygon on the floor. */
export interface Area {
  corners: { x_m: number; y_m: number }[];
}

export interface Course {
  name: string;
  description: string;
  length_m: number;
  path: PathPoint[];
  segments: Segment[];
  /** Missing in older recordings. */
  obstacles?: Obstacle[];
  surfaces: Footprint[];
  disturbances: { at_m: number }[];
  fence?: Area | null;
  /** Missing in older recordings. */
  keep_out?: Area[];
  robot: RobotShape;
}

export interface Event {
  t_s: number;
  kind: string;
  level: 'info' | 'warning' | 'error';
  text: string;
  cause: string;
  fix: string;
}

export interface Parameter {
  name: string;
  value: number | boolean | string;
  default: number | boolean | string;
  type: 'number' | 'integer' | 'boolean' | 'text' | 'choice';
  unit: string;
  min?: number | null;
  max?: number | null;
  choices: string[];
  meaning: string;
  live: boolean;
  when: 'always' | 'not running';
  /** Not in recordings of older versions. */
  may_save?: boolean;
}

export interface Recording {
  available: boolean;
  active: boolean;
  run: string;
  elapsed_s: number;
  bytes: number;
  warning: string;
}

export interface ClientList {
  clients: { id: number; address: string; sent: number; dropped: number }[];
  dropped_total: number;
  refused_total: number;
  closed_total: number;
}

/** `/path_history`: line strips of a SceneUpdate. */
export interface SceneUpdate {
  entities: { id: string; lines: { points: { x: number; y: number; z: number }[] }[] }[];
}

/** `/camera/image`, of Foxglove. */
export interface CompressedImage {
  timestamp: { sec: number; nsec: number };
  format: string;
  /** Base64. */
  data: string;
}

/** Messages that the page uses only as signals. */
export interface Figures {
  t_s: number;
}

/** The message type of each channel. */
export interface Channels {
  '/estimate': Estimate;
  '/slip': Slip;
  '/sample': Figures;
  '/command': Figures;
  '/link': Link;
  '/loop': Loop;
  '/state': State;
  '/course': Course;
  '/event': Event;
  '/parameter': { parameters: Parameter[] };
  '/recording': Recording;
  '/client': ClientList;
  '/path_history': SceneUpdate;
  '/camera/image': CompressedImage;
}

export type Topic = keyof Channels;
