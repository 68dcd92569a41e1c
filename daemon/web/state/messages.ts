// The messages of the daemon's channels (daemon/messages/CHANNELS.md) as the page names them. SI units, REP-103 frames.
// Unknown values are left out.

import type { Channels as Schemas } from './channels.ts';

/** Fields that recordings of older versions lack. */
type Since<T, K extends keyof T> = Omit<T, K> & { [P in K]?: T[P] | undefined };

export type Estimate = Since<Schemas['/estimate'], 'at_fence'>;
export type EstimatedPose = Since<Estimate['model'], 'sd_x_m' | 'sd_y_m' | 'sd_yaw_rad'>;
export type Pose = Estimate['world'];
export type Slip = Schemas['/slip'];

export type Link = Schemas['/link'];
export type Session = Link['session'];
export type Distribution = Link['sample_age_us'];
export type Loop = Schemas['/loop'];

export type State = Since<Schemas['/state'], 'watch' | 'confirm_start' | 'why_not_drive' | 'largest_m'>;
export type Run = State['run'];
export type StopState = State['stop'];

export type Course = Since<Schemas['/course'], 'obstacles' | 'keep_out'>;
/** A point of the path: a pose on the ground, and the distance along the path. */
export type PathPoint = Course['path'][number];
/** A place on the floor and a direction. */
export type FloorPose = Course['start'];
/** A part of the path; of a turn on the spot, both distances are the same. */
export type Segment = Course['segments'][number];
/** What rises from the floor, of any kind: its side view along its own x axis, from its near foot to its far one. */
export type Obstacle = NonNullable<Course['obstacles']>[number];
export type Place = Pick<Obstacle, 'x_m' | 'y_m' | 'heading_rad'>;
/** The rectangle that a piece takes up. */
export type Footprint = Place & { length_m: number; width_m: number };
/** A polygon on the floor. */
export type Area = NonNullable<Course['keep_out']>[number];
export type RobotShape = Omit<Course['robot'], 'name'>;

export type Event = Schemas['/event'];
export type Recording = Schemas['/recording'];
/** A parameter; its values, whose type depends on the parameter, are not in the schema. */
export type Parameter = Since<Schemas['/parameter']['parameters'][number], 'may_save'> & Record<'value' | 'default', number | boolean | string>;
type Scene = Schemas['/path_history']['entities'][number];
/** Line strips. */
export interface SceneUpdate {
  entities: (Pick<Scene, 'id'> & { lines: Pick<Scene['lines'][number], 'points'>[] })[];
}

/** The message type of each channel. */
export interface Channels extends Omit<Schemas, '/estimate' | '/state' | '/course' | '/parameter' | '/path_history'> {
  '/estimate': Estimate;
  '/state': State;
  '/course': Course;
  '/parameter': { parameters: Parameter[] };
  '/path_history': SceneUpdate;
}

export type Topic = keyof Channels;

/** A course is being driven, or is about to be. */
export const onCourse = (run: Run | undefined): boolean => run === 'arming' || run === 'running';

/** Motion was requested: on a course or by hand. */
export const asksForMotion = (run: Run | undefined): boolean => onCourse(run) || run === 'driving';

/** Why a viewer whom server.commands does not allow may not command. */
export const kNoRights = 'This daemon accepts only STOP from here (server.commands)';
