// A course file that is being drawn: what the map shows of it, the handles by which it is changed, and new pieces.
import type { Point2 } from '../scene/geometry.ts';
import type { Area, Course, Place, PathPoint, RobotShape } from '../state/messages.ts';
import type { CourseText, Piece, PieceTable, Value } from './course_text.ts';
import { along, arcTo, frames, kRad, lineTo, nearest, number, pointAt, points, startOf, type Frame } from './path.ts';

/** What can be added with a press on the map. */
export type Tool = 'line' | 'arc' | 'pivot' | 'ramp' | 'block' | 'surface' | 'disturbance' | 'keep_out';

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
export const kValues: Record<PieceTable, Record<string, Value>> = {
  segment: {},
  ramp: { x_m: 0, y_m: 0, heading_deg: 0, height_m: 0.05, up_deg: 15, top_m: 0.2, down_deg: 15, width_m: 0.4 },
  block: { x_m: 0, y_m: 0, heading_deg: 0, height_m: 0.02, depth_m: 0.1, width_m: 0.4 },
  surface: { name: 'other ground', x_m: 0, y_m: 0, heading_deg: 0, length_m: 0.3, width_m: 0.5, friction_factor: 1, slip_offset: 0 },
  disturbance: { at_m: 0, sideways_m: 0.03, yaw_deg: 0, duration_s: 0.3 },
  keep_out: {},
};

export function find(text: CourseText, { table, index }: Selected): Piece | undefined {
  if (table === 'start' || table === 'fence' || table === '') return text.one(table);
  return text.all(table as PieceTable)[index];
}

function place(piece: Piece): Place {
  return { x_m: number(piece, 'x_m'), y_m: number(piece, 'y_m'), heading_rad: number(piece, 'heading_deg') * kRad };
}

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

const area = (list: readonly Point2[] = []): Area => ({ corners: list.map(({ x, y }) => ({ x_m: x, y_m: y })) });

/** Some lengths of a piece. */
function lengths<K extends string>(piece: Piece, ...keys: readonly K[]): Record<K, number> {
  return Object.fromEntries(keys.map((key) => [key, number(piece, key)])) as Record<K, number>;
}

/** The draft as the map draws a course. */
export function draftCourse(text: CourseText, name: string, robot: RobotShape): Course {
  const path = pathOf(text);
  return {
    name,
    description: '',
    length_m: path.at(-1)?.s_m ?? 0,
    path,
    ramps: text.all('ramp').map((ramp) => ({
      ...place(ramp),
      ...lengths(ramp, 'height_m', 'top_m', 'width_m'),
      up_rad: number(ramp, 'up_deg', 15) * kRad,
      down_rad: number(ramp, 'down_deg', 15) * kRad,
    })),
    blocks: text.all('block').map((block) => ({ ...place(block), ...lengths(block, 'height_m', 'depth_m', 'width_m') })),
    surfaces: text.all('surface').map((surface) => ({ ...place(surface), ...lengths(surface, 'length_m', 'width_m') })),
    disturbances: [],
    fence: area(fenceCorners(text.one('fence'))),
    keep_out: text.all('keep_out').map((piece) => area(corners(piece))),
    robot,
  };
}

/** All handles of the draft, in the order of the file. */
export function handles(text: CourseText): Handle[] {
  return [...pathHandles(text), ...placedHandles(text), ...disturbanceHandles(text), ...cornerHandles(text)];
}

function pathHandles(text: CourseText): Handle[] {
  const piece = text.one('start');
  const start = startOf(piece);
  const segments = text.all('segment');
  const begins = frames(start, segments);
  const all = [
    handle('start', 'Start', piece, start, ({ x, y }) => text.with(piece, { x_m: x, y_m: y })),
    turn('start-turn', 'Direction of the start', piece, start, start.yaw_rad, (yaw_rad) => text.with(piece, { yaw_deg: yaw_rad / kRad })),
  ];
  segments.forEach((segment, i) => {
    const from = begins[i] ?? start;
    const id = `segment-${i}`;
    const label = `End of ${String(segment.values.type)} ${i + 1}`;
    if (segment.values.type === 'line') {
      all.push(handle(id, label, segment, along(from, segment), (to) => text.with(segment, { length_m: lineTo(from, to) })));
    } else if (segment.values.type === 'arc') {
      all.push(handle(id, label, segment, along(from, segment), (to) => text.with(segment, { ...arcTo(from, to) })));
    } else if (segment.values.type === 'pivot') {
      const drag = (yaw_rad: number): string => text.with(segment, { angle_deg: turned(yaw_rad - from.yaw_rad) });
      all.push(turn(id, label, segment, from, along(from, segment).yaw_rad, drag));
    }
  });
  return all;
}

function placedHandles(text: CourseText): Handle[] {
  return (['ramp', 'block', 'surface'] as const).flatMap((table) =>
    text.all(table).flatMap((piece) => {
      const { x_m: x, y_m: y, heading_rad } = place(piece);
      const id = `${table}-${piece.index}`;
      const label = `${table} ${piece.index + 1}`;
      return [
        handle(id, label, piece, { x, y }, (to) => text.with(piece, { x_m: to.x, y_m: to.y })),
        turn(`${id}-turn`, `Direction of ${label}`, piece, { x, y }, heading_rad, (to) => text.with(piece, { heading_deg: to / kRad })),
      ];
    }),
  );
}

function disturbanceHandles(text: CourseText): Handle[] {
  const path = pathOf(text);
  return text.all('disturbance').flatMap((piece) => {
    const at = pointAt(path, number(piece, 'at_m'));
    if (at === undefined) return [];
    const drag = (to: Point2): string => text.with(piece, { at_m: nearest(path, to)?.s_m ?? 0 });
    return [handle(`disturbance-${piece.index}`, `disturbance ${piece.index + 1}`, piece, { x: at.x_m, y: at.y_m }, drag)];
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

function turn(id: string, label: string, piece: Piece, centre: Point2, yaw_rad: number, drag: (yaw_rad: number) => string): Handle {
  const at = { x: centre.x + kTurn_m * Math.cos(yaw_rad), y: centre.y + kTurn_m * Math.sin(yaw_rad) };
  return { ...handle(id, label, piece, at, (to) => drag(Math.atan2(to.y - centre.y, to.x - centre.x))), turns: true };
}

/** The angle of a turn in degrees, to the nearer side; at least one degree. */
function turned(angle_rad: number): number {
  const angle = angle_rad - 2 * Math.PI * Math.round(angle_rad / (2 * Math.PI));
  return Math.max(Math.abs(angle / kRad), 1) * (angle < 0 ? -1 : 1);
}

export function pathOf(text: CourseText): PathPoint[] {
  return points(startOf(text.one('start')), text.all('segment'));
}

/** A point a little beyond the end of the path, for pieces that are added without a press on the map. */
export function beyond(text: CourseText): Point2 {
  const end = endOf(text);
  return { x: end.x + 0.3 * Math.cos(end.yaw_rad), y: end.y + 0.3 * Math.sin(end.yaw_rad) };
}

function endOf(text: CourseText): Frame {
  const start = startOf(text.one('start'));
  return frames(start, text.all('segment')).at(-1) ?? start;
}

/** The text with a new piece at a point, and that piece. */
export function added(text: CourseText, tool: Tool, at: Point2): { text: string; piece: Selected } {
  const from = endOf(text);
  const put = (table: PieceTable, values: Record<string, Value>, index = text.all(table).length): { text: string; piece: Selected } => ({
    text: text.added(table, values, index),
    piece: { table, index },
  });
  if (tool === 'line') return put('segment', { type: 'line', length_m: lineTo(from, at) });
  if (tool === 'arc') return put('segment', { type: 'arc', ...arcTo(from, at) });
  if (tool === 'pivot') return put('segment', { type: 'pivot', angle_deg: turned(Math.atan2(at.y - from.y, at.x - from.x) - from.yaw_rad) });
  if (tool === 'keep_out') return put(tool, { corners_m: [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u = 0, v = 0]) => [at.x + 0.1 * u, at.y + 0.1 * v]) });
  const on = nearest(pathOf(text), at);
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
