// Floor, arena, obstacles and the planned path of a course.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  RingGeometry,
} from 'three';
import type { Course, Place } from '../state/messages.ts';
import { bounds, cornersOf, drape } from './geometry.ts';
import { colour } from './palette.ts';
import { dispose, Ribbon, solid } from './solid.ts';

const kMargin_m = 1.2;
const kPathWidth_m = 0.006;
const kDashPoints = 5;

export class CourseModel {
  readonly group = new Group();
  private path: Ribbon | undefined;

  set(course: Course | undefined): void {
    this.path?.dispose();
    this.path = undefined;
    dispose(this.group);
    this.floor(course);
    if (course === undefined) return;
    for (const surface of course.surfaces) {
      const patch = new Mesh(
        new PlaneGeometry(surface.length_m, surface.width_m),
        new MeshLambertMaterial({ color: colour('surface'), polygonOffset: true, polygonOffsetFactor: -1 }),
      );
      patch.receiveShadow = true;
      lay(patch, surface);
      patch.position.z = 0.0006;
      this.group.add(patch);
    }
    for (const obstacle of course.obstacles ?? []) {
      // Counter-clockwise.
      const profile = obstacle.profile.map(({ along_m, height_m }) => ({ x: along_m, y: height_m })).reverse();
      const body = solid(profile, obstacle.width_m, colour('obstacle'), colour('obstacle-edge'));
      lay(body, obstacle);
      this.group.add(body);
    }
    for (const area of [course.fence, ...(course.keep_out ?? [])]) {
      const corners = cornersOf(area).flatMap(({ x, y }) => [x, y, 0.001]);
      if (corners.length > 0) this.group.add(new LineLoop(lineGeometry(corners), new LineBasicMaterial({ color: colour('fence') })));
    }
    if (course.path.length > 1) {
      const points = drape(course.path);
      this.path = new Ribbon(points.length / 3, colour('path'), kPathWidth_m, 0.0015);
      this.path.set(points, kDashPoints);
      this.group.add(this.path.mesh, ring(course.path[0], 0.014, 0.02), ring(course.path.at(-1), 0.02, 0.03));
    }
  }

  private floor(course: Course | undefined): void {
    const box = bounds(course);
    const step = 0.1;
    const down = (value: number): number => Math.floor((value - kMargin_m) / step) * step;
    const up = (value: number): number => Math.ceil((value + kMargin_m) / step) * step;
    const [x0, x1, y0, y1] = [down(box.min_x), up(box.max_x), down(box.min_y), up(box.max_y)];
    const plane = new Mesh(
      new PlaneGeometry(40, 40),
      new MeshLambertMaterial({ color: colour('floor'), polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
    );
    plane.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0);
    plane.receiveShadow = true;
    const fine: number[] = [];
    const bold: number[] = [];
    const lines = (from: number, to: number, line: (at: number) => number[]): void => {
      for (let i = Math.round(from / step); i <= Math.round(to / step); i++) {
        (i % 5 === 0 ? bold : fine).push(...line(i * step));
      }
    };
    // In short pieces: some drivers drop a line whose end is behind the camera.
    const pieces = (from: number, to: number, piece: (a: number, b: number) => number[]): number[] => {
      const all: number[] = [];
      for (let i = Math.round(from / step); i < Math.round(to / step); i += 5) all.push(...piece(i * step, Math.min((i + 5) * step, to)));
      return all;
    };
    lines(x0, x1, (x) => pieces(y0, y1, (a, b) => [x, a, 0, x, b, 0]));
    lines(y0, y1, (y) => pieces(x0, x1, (a, b) => [a, y, 0, b, y, 0]));
    this.group.add(
      plane,
      new LineSegments(lineGeometry(fine), new LineBasicMaterial({ color: colour('grid') })),
      new LineSegments(lineGeometry(bold), new LineBasicMaterial({ color: colour('grid-bold') })),
    );
  }
}

function lay(mesh: Mesh, place: Place): void {
  mesh.position.set(place.x_m, place.y_m, 0);
  mesh.rotation.z = place.heading_rad;
}

function lineGeometry(coordinates: number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(coordinates), 3));
  return geometry;
}

function ring(at: { x_m: number; y_m: number } | undefined, inner: number, outer: number): Mesh {
  const mesh = new Mesh(
    new RingGeometry(inner, outer, 32),
    new MeshBasicMaterial({ color: colour('path'), side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -2 }),
  );
  mesh.position.set(at?.x_m ?? 0, at?.y_m ?? 0, 0.001);
  return mesh;
}
