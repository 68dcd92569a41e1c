// Bodies made of prisms, with visible edges so that they are recognised without texture.
import {
  BufferAttribute,
  BufferGeometry,
  EdgesGeometry,
  LineBasicMaterial,
  Line,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
} from 'three';
import { prism, type Point2 } from './geometry.ts';

/** A prism's geometry with normals of its faces. */
export function prismGeometry(outline: readonly Point2[], width: number): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(prism(outline, width), 3));
  geometry.computeVertexNormals();
  return geometry;
}

export function solid(outline: readonly Point2[], width: number, colour: string, edge?: string): Mesh {
  const geometry = prismGeometry(outline, width);
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
  const mesh = solid(
    [
      { x: -length / 2, y: -height / 2 },
      { x: length / 2, y: -height / 2 },
      { x: length / 2, y: height / 2 },
      { x: -length / 2, y: height / 2 },
    ],
    width,
    colour,
  );
  mesh.position.set(x, y, z);
  return mesh;
}

/** Frees what `object` and its children hold on the graphics card. */
export function dispose(object: Object3D): void {
  object.traverse((child) => {
    if (!(child instanceof Mesh || child instanceof Line)) return;
    (child.geometry as BufferGeometry).dispose();
    const material = child.material as MeshLambertMaterial | MeshLambertMaterial[];
    for (const one of Array.isArray(material) ? material : [material]) {
      one.map?.dispose();
      one.dispose();
    }
  });
  object.clear();
}
