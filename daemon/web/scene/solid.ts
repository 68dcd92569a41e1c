// Bodies made of prisms, with visible edges so that they are recognised without texture; and driven paths as ribbons.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EdgesGeometry,
  ExtrudeGeometry,
  LineBasicMaterial,
  Line,
  LineSegments,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  Shape,
  Vector2,
} from 'three';
import { ribbon, type Point2 } from './geometry.ts';
import type { PathHistory } from '../state/series.ts';

/** An x-z outline, counter-clockwise, extruded along y over +-width/2. */
export function prismGeometry(outline: readonly Point2[], width: number): BufferGeometry {
  const shape = new Shape(outline.map(({ x, y }) => new Vector2(x, y)));
  const geometry = new ExtrudeGeometry(shape, { depth: width, bevelEnabled: false });
  return geometry.translate(0, 0, -width / 2).rotateX(Math.PI / 2);
}

export function solid(outline: readonly Point2[], width: number, colour: string, edge?: string): Mesh {
  return body(prismGeometry(outline, width), colour, edge);
}

export function body(geometry: BufferGeometry, colour: string, edge?: string): Mesh {
  const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: colour }));
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  if (edge !== undefined) {
    mesh.add(new LineSegments(new EdgesGeometry(geometry, 20), new LineBasicMaterial({ color: edge })));
  }
  return mesh;
}

/** A box, given by its middle and its size. */
export function box(
  [x, y, z]: readonly [number, number, number],
  [length, width, height]: readonly [number, number, number],
  colour: string,
): Mesh {
  const mesh = body(new BoxGeometry(length, width, height), colour);
  mesh.position.set(x, y, z);
  return mesh;
}

/** Frees what `object` and its children hold on the graphics card. */
export function dispose(object: Object3D): void {
  object.traverse((child) => {
    if (!(child instanceof Mesh || child instanceof Line)) return;
    (child.geometry as BufferGeometry).dispose();
    (child.material as Material).dispose();
  });
  object.clear();
}

export class Ribbon {
  readonly mesh: Mesh<BufferGeometry, MeshBasicMaterial>;
  private readonly vertices: Float32Array;
  private readonly attribute: BufferAttribute;
  private readonly indices: Uint32Array;
  private shown = 0;
  private generation = -1;

  constructor(
    private readonly capacity: number,
    colour: string,
    private readonly width_m: number,
    private readonly lift_m: number,
  ) {
    this.vertices = new Float32Array(6 * capacity);
    this.attribute = new BufferAttribute(this.vertices, 3);
    this.indices = new Uint32Array(6 * capacity);
    for (let i = 0; i + 1 < capacity; i++) this.indices.set(quad(i), 6 * i);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', this.attribute);
    geometry.setIndex(new BufferAttribute(this.indices, 1));
    geometry.setDrawRange(0, 0);
    const material = new MeshBasicMaterial({
      color: colour,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: -2,
      polygonOffsetUnits: -4,
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  /** Draws new points of the history; true if there were any. */
  follow(path_history: PathHistory): boolean {
    if (path_history.generation === this.generation && path_history.length === this.shown) return false;
    const from = path_history.generation === this.generation ? Math.max(this.shown - 1, 0) : 0;
    this.generation = path_history.generation;
    this.show(path_history.coordinates, from);
    return true;
  }

  /** Sets all points at once; `dash` > 0 leaves out every other stretch of that many points. */
  set(points: Float32Array, dash = 0): void {
    const count = Math.min(points.length / 3, this.capacity);
    for (let i = 0; i + 1 < this.capacity; i++) {
      const gap = dash > 0 && Math.floor(i / dash) % 2 === 1;
      this.indices.set(gap ? [0, 0, 0, 0, 0, 0] : quad(i), 6 * i);
    }
    const index = this.mesh.geometry.getIndex();
    if (index !== null) index.needsUpdate = true;
    this.show(points.subarray(0, 3 * count), 0);
  }

  /** Call before following another path_history. */
  reset(): void {
    this.generation = -1;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private show(points: Float32Array, from: number): void {
    const count = points.length / 3;
    ribbon(points, from, count, this.width_m, this.lift_m, this.vertices);
    this.attribute.clearUpdateRanges();
    if (count > from) this.attribute.addUpdateRange(6 * from, 6 * (count - from));
    this.attribute.needsUpdate = true;
    this.mesh.geometry.setDrawRange(0, 6 * Math.max(count - 1, 0));
    this.shown = count;
  }
}

const quad = (i: number): number[] => [2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 1, 2 * i + 3, 2 * i + 2];
