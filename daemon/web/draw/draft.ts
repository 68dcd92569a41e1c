// A course file that is being drawn: the handles by which it is changed, and new pieces. Where they lie on the path, the
// daemon tells: `drawn` is what it last answered about the file.
import type { Point2 } from '../scene/geometry.ts';
import type { Course, FloorPose, PathPoint } from '../state/messages.ts';
import type { CourseText, Piece, Value } from './course_text.ts';

export const kRad = Math.PI / 180;

/** Words for the types of segments that can be drawn. */
export const kSegmentTools = { line: 'Line', arc: 'Arc', pivot: 'Turn' };

/** By type of segment: the values with which one that begins at `from` ends at a point, or nearest to it. */
export const kEnds: Partial<Record<string, (from: FloorPose, to: Point2) => Record<string, Value>>> = {
  line: (from, to) => ({ length_m: Math.max(seen(from, to).ahead, 0.01) }),
  arc: (from, to) => {
    const { ahead, left } = seen(from, to);
    const far = Math.hypot(ahead, left);
    const radius_m = Math.min((far * far) / Math.max(2 * Math.abs(left), 1e-6), 100);
    const angle_deg = (2 * Math.atan2(Math.abs(left), ahead)) / kRad;
    return { radius_m: Math.max(radius_m, 0.01), angle_deg: (left < 0 ? -1 : 1) * Math.max(angle_deg, 0.1) };
  },
  pivot: (from, to) => {
    const { ahead, left } = seen(from, to);
    return { angle_deg: (left < 0 ? -1 : 1) * Math.max(Math.abs(Math.atan2(left, ahead)) / kRad, 1) };
  },
};

/** A point as seen from a pose. */
function seen(from: FloorPose, to: Point2): { ahead: number; left: number } {
  const [dx, dy] = [to.x - from.x_m, to.y - from.y_m];
  const [cos, sin] = [Math.cos(from.yaw_rad), Math.sin(from.yaw_rad)];
  return { ahead: cos * dx + sin * dy, left: -sin * dx + cos * dy };
}

/** The point of a path that is nearest to a point of the floor. */
export function nearest(path: readonly PathPoint[], to: Point2): PathPoint | undefined {
  let best: PathPoint | undefined;
  let least = Infinity;
  for (const point of path) {
    const distance = Math.hypot(point.x_m - to.x, point.y_m - to.y);
    if (distance < least) [best, least] = [point, distance];
  }
  return best;
}

/** The point of the path at a distance along it. */
export function pointAt(path: readonly PathPoint[], s_m: number): PathPoint | undefined {
  return path.find((point) => point.s_m >= s_m - 1e-9) ?? path.at(-1);
}

/** What can be added with a press on the map, with the words for it. */
export const kTools: Record<string, string> = {
  ...kSegmentTools,
  ramp: 'Ramp',
  block: 'Block',
  surface: 'Surface',
  disturbance: 'Disturbance',
  keep_out: 'Keep-out',
};

export interface Selected {
  table: string;
  index: number;
}

/** A point that can be dragged. */
export interface Handle {
  /** Stays the same while its point is dragged. */
  id: string;
  label: string;
  /** True: changes a direction; false: a position. */
  turns: boolean;
  at: Point2;
  piece: Selected;
  /** The text with this point moved to `to`. */
  drag(to: Point2): string;
}

const kTurn_m = 0.15;

export const kEmptyCourse = `description = "drawn on the page"
speed_mps = 0.1

[[segment]]
type = "line"
length_m = 0.6

[fence]
min_x_m = -0.3
max_x_m = 1.6
min_y_m = -0.8
max_y_m = 0.8
`;

/** Values of a new piece, and defaults of the keys that a piece may omit. */
export const kValues: Partial<Record<string, Record<string, Value>>> = {
  segment: {},
  ramp: { x_m: 0, y_m: 0, heading_deg: 0, height_m: 0.05, up_deg: 15, top_m: 0.2, down_deg: 15, width_m: 0.4 },
  block: { x_m: 0, y_m: 0, heading_deg: 0, height_m: 0.02, depth_m: 0.1, width_m: 0.4 },
  surface: { name: 'other ground', x_m: 0, y_m: 0, heading_deg: 0, length_m: 0.3, width_m: 0.5, friction_factor: 1, slip_offset: 0 },
  disturbance: { at_m: 0, sideways_m: 0.03, yaw_deg: 0, duration_s: 0.3 },
  keep_out: {},
};

export function find(text: CourseText, { table, index }: Selected): Piece | undefined {
  if (table === 'start' || table === 'fence' || table === '') return text.one(table);
  return text.all(table)[index];
}

function number(piece: Piece, key: string, otherwise = 0): number {
  const value = piece.values[key];
  return typeof value === 'number' && Number.isFinite(value) ? value : otherwise;
}

/** Its place and direction; a piece of terrain has a heading, the start a yaw. */
const poseOf = (piece: Piece, direction = 'heading_deg'): FloorPose => ({
  x_m: number(piece, 'x_m'),
  y_m: number(piece, 'y_m'),
  yaw_rad: number(piece, direction) * kRad,
});

/** Corners as written; undefined if there are none that can be drawn. */
export function corners(piece: Piece): Point2[] | undefined {
  const list = piece.values.corners_m;
  if (!Array.isArray(list)) return undefined;
  const all = list.map((each) => (Array.isArray(each) ? { x: Number(each[0]), y: Number(each[1]) } : { x: NaN, y: NaN }));
  return all.length > 0 && all.every(({ x, y }) => Number.isFinite(x + y)) ? all : undefined;
}

const pairs = (all: readonly Point2[]): Value => all.map(({ x, y }) => [x, y]);

/** The corners of the fence, which may be a polygon or a rectangle. */
export function fenceCorners(fence: Piece): Point2[] | undefined {
  const drawn = corners(fence);
  if (drawn !== undefined) return drawn;
  const [left, right, low, high] = ['min_x_m', 'max_x_m', 'min_y_m', 'max_y_m'].map((key) => number(fence, key, NaN)) as [number, number, number, number];
  if (!Number.isFinite(left + right + low + high)) return undefined;
  return [
    { x: left, y: low },
    { x: right, y: low },
    { x: right, y: high },
    { x: left, y: high },
  ];
}

/** All handles of the draft, in the order of the file; those of segments that the daemon has not drawn yet are missing. */
export function handles(text: CourseText, drawn: Course): Handle[] {
  return [...pathHandles(text, drawn), ...placedHandles(text), ...disturbanceHandles(text, drawn), ...cornerHandles(text)];
}

function pathHandles(text: CourseText, drawn: Course): Handle[] {
  const start = text.one('start');
  const all = movable('start', 'Start', 'Direction of the start', start, 'yaw_deg', text);
  text.all('segment').forEach((segment, i) => {
    const lies = drawn.segments[i];
    const type = String(segment.values.type);
    const ends = kEnds[type];
    if (lies === undefined || ends === undefined) return;
    const id = `segment-${i}`;
    const label = `End of ${type} ${i + 1}`;
    const drag = (to: Point2): string => text.with(segment, ends(lies.begin, to));
    const turns = lies.from_m === lies.to_m;
    all.push({ ...handle(id, label, segment, turns ? ahead(lies.end) : pointOf(lies.end), drag), turns });
  });
  return all;
}

/** The handles of a piece with a place and a direction. */
function movable(id: string, label: string, turnLabel: string, piece: Piece, direction: string, text: CourseText): Handle[] {
  const pose = poseOf(piece, direction);
  const turn = (to: Point2): string => text.with(piece, { [direction]: Math.atan2(to.y - pose.y_m, to.x - pose.x_m) / kRad });
  return [
    handle(id, label, piece, pointOf(pose), (to) => text.with(piece, { x_m: to.x, y_m: to.y })),
    { ...handle(`${id}-turn`, turnLabel, piece, ahead(pose), turn), turns: true },
  ];
}

function placedHandles(text: CourseText): Handle[] {
  const tables = Object.keys(kValues).filter((table) => kValues[table]?.x_m !== undefined);
  return tables.flatMap((table) => text.all(table)).flatMap((piece) => {
    const label = `${piece.table} ${piece.index + 1}`;
    return movable(`${piece.table}-${piece.index}`, label, `Direction of ${label}`, piece, 'heading_deg', text);
  });
}

function disturbanceHandles(text: CourseText, { path }: Course): Handle[] {
  return text.all('disturbance').flatMap((piece) => {
    const on = pointAt(path, number(piece, 'at_m'));
    if (on === undefined) return [];
    const drag = (to: Point2): string => text.with(piece, { at_m: nearest(path, to)?.s_m ?? 0 });
    return [handle(`disturbance-${piece.index}`, `disturbance ${piece.index + 1}`, piece, pointOf(on), drag)];
  });
}

function cornerHandles(text: CourseText): Handle[] {
  const fence = text.one('fence');
  const all: Handle[] = [];
  const polygon = (piece: Piece, list: Point2[], what: string): void => {
    list.forEach((at, i) => {
      const drag = (to: Point2): string => text.with(piece, { corners_m: pairs(list.map((each, k) => (k === i ? to : each))) });
      all.push(handle(`${piece.table}-${piece.index}-${i}`, `Corner ${i + 1} of ${what}`, piece, at, drag));
    });
  };
  const drawn = corners(fence);
  if (drawn !== undefined) polygon(fence, drawn, 'the fence');
  else {
    const keys = [['min_x_m', 'min_y_m'], ['max_x_m', 'min_y_m'], ['max_x_m', 'max_y_m'], ['min_x_m', 'max_y_m']] as const;
    (fenceCorners(fence) ?? []).forEach((at, i) => {
      const [x, y] = keys[i] ?? keys[0];
      all.push(handle(`fence-0-${i}`, `Corner ${i + 1} of the fence`, fence, at, (to) => text.with(fence, { [x]: to.x, [y]: to.y })));
    });
  }
  for (const area of text.all('keep_out')) polygon(area, corners(area) ?? [], `keep-out area ${area.index + 1}`);
  return all;
}

function handle(id: string, label: string, piece: Piece, { x, y }: Point2, drag: (to: Point2) => string): Handle {
  return { id, label, turns: false, at: { x, y }, piece: { table: piece.table, index: piece.index }, drag };
}

const pointOf = ({ x_m, y_m }: FloorPose): Point2 => ({ x: x_m, y: y_m });

/** Where the handle of a direction lies. */
const ahead = ({ x_m, y_m, yaw_rad }: FloorPose, far_m = kTurn_m): Point2 => ({ x: x_m + far_m * Math.cos(yaw_rad), y: y_m + far_m * Math.sin(yaw_rad) });

/** A point a little beyond the end of the path, for pieces that are added without a press on the map. */
export const beyond = (text: CourseText, drawn: Course): Point2 => ahead(endOf(text, drawn), 0.3);

function endOf(text: CourseText, drawn: Course): FloorPose {
  const end = text.all('segment').length === 0 ? undefined : drawn.segments.at(-1)?.end;
  return end ?? poseOf(text.one('start'), 'yaw_deg');
}

/** The text with a new piece at a point, and that piece. */
export function added(text: CourseText, drawn: Course, tool: string, at: Point2): { text: string; piece: Selected } {
  const put = (table: string, values: Record<string, Value>, index = text.all(table).length): { text: string; piece: Selected } => ({
    text: text.added(table, values, index),
    piece: { table, index },
  });
  const ends = kEnds[tool];
  if (ends !== undefined) return put('segment', { type: tool, ...ends(endOf(text, drawn), at) });
  if (tool === 'keep_out') return put(tool, { corners_m: [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u = 0, v = 0]) => [at.x + 0.1 * u, at.y + 0.1 * v]) });
  const on = nearest(drawn.path, at);
  if (tool === 'disturbance') {
    const at_m = on?.s_m ?? 0;
    // Disturbances are listed in the order of the path.
    return put(tool, { ...kValues[tool], at_m }, text.all(tool).filter((each) => number(each, 'at_m') <= at_m).length);
  }
  // In driving direction.
  return put(tool, { ...kValues[tool], x_m: at.x, y_m: at.y, heading_deg: ((on?.yaw_rad ?? 0) / kRad) % 360 });
}

/** The text with one more corner, in the middle of the edge after corner `index`. A rectangle becomes a polygon. */
export function withCorner(text: CourseText, piece: Piece, index: number): string {
  const list = piece.table === 'fence' ? fenceCorners(piece) : corners(piece);
  const [a, b] = [list?.[index], list?.[(index + 1) % (list.length || 1)]];
  if (list === undefined || a === undefined || b === undefined) return text.text;
  const middle = { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  return withCorners(text, piece, [...list.slice(0, index + 1), middle, ...list.slice(index + 1)]);
}

/** The text without one corner; at least three remain. */
export function withoutCorner(text: CourseText, piece: Piece, index: number): string {
  const list = corners(piece);
  return list === undefined || list.length <= 3 ? text.text : withCorners(text, piece, list.filter((_, i) => i !== index));
}

function withCorners(text: CourseText, piece: Piece, list: readonly Point2[]): string {
  const drawn = { corners_m: pairs(list) };
  return corners(piece) === undefined ? text.replaced(piece, ['min_x_m', 'max_x_m', 'min_y_m', 'max_y_m'], drawn) : text.with(piece, drawn);
}
