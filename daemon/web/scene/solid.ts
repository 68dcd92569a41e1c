// Bodies made of prisms, with visible edges so that they are recognised without texture.
import {
  BoxGeometry,
  type BufferGeometry,
  EdgesGeometry,
  ExtrudeGeometry,
  LineBasicMaterial,
  Line,
  LineSegments,
  type Material,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
  Shape,
  Vector2,
} from 'three';
import type { Point2 } from './geometry.ts';

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
