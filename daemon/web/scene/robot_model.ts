// The robot to scale, with moving tracks.
import {
  BoxGeometry,
  BufferGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Matrix4,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
} from 'three';
import type { EstimatedPose, Pose, RobotShape } from '../state/messages.ts';
import { onStadium, stadium, stadiumLength } from './geometry.ts';
import { body, box, prismGeometry, solid } from './solid.ts';

const kRingPoints = 48;
const kRingLift_m = 0.004;

const kCleat_m = 0.012;

export class RobotModel {
  readonly group = new Group();
  private readonly cleats: [InstancedMesh, InstancedMesh];

  constructor(private readonly shape: RobotShape) {
    const { axle_spacing_m: spacing, wheel_radius_m: radius, shoe_width_m: track, gauge_m: gauge } = shape;
    const outline = stadium(spacing, radius - 0.002);
    const left = this.track(gauge / 2, outline);
    const right = this.track(-gauge / 2, outline);
    this.cleats = [left, right];

    const inner = gauge - track;
    const deck = shape.height_m - 0.012;
    this.group.add(
      box([0, 0, (0.016 + deck) / 2], [spacing + radius * 0.9, inner - 0.006, deck - 0.016], '#2b333d'),
      box([0, 0, deck], [spacing + radius * 1.2, inner + 0.01, 0.003], '#c9d1da'),
      box([-0.02, 0, deck + 0.004], [0.075, 0.05, 0.003], '#0f7f86'), // the Mega
      box([-0.054, 0.012, deck + 0.008], [0.014, 0.012, 0.01], '#aab3bd'), // its USB plug
      box([spacing / 2 + radius * 0.62, 0, deck - 0.008], [0.006, inner * 0.7, 0.006], '#fff3c4'), // lamps: the front
    );
    this.group.rotation.order = 'ZYX';
  }

  /** Sets the pose and the distance of each track. */
  set(pose: Pose, left_m: number, right_m: number): void {
    place(this.group, pose);
    this.run(this.cleats[0], left_m);
    this.run(this.cleats[1], right_m);
  }

  private track(y: number, outline: { x: number; y: number }[]): InstancedMesh {
    const { axle_spacing_m: spacing, wheel_radius_m: radius, shoe_width_m: width } = this.shape;
    const track = solid(outline, width, '#1b2026');
    track.position.y = y;
    this.group.add(track);
    for (const x of [-spacing / 2, spacing / 2]) {
      const wheel = body(new CylinderGeometry(radius - 0.007, radius - 0.007, width + 0.002, 20), '#8b96a3');
      wheel.position.set(x, y, radius);
      this.group.add(wheel);
    }
    const count = Math.round(stadiumLength(spacing, radius) / kCleat_m);
    const cleats = new InstancedMesh(
      new BoxGeometry(kCleat_m * 0.5, width + 0.001, 0.0035),
      new MeshLambertMaterial({ color: '#4a545f' }),
      count,
    );
    cleats.position.y = y;
    cleats.castShadow = true;
    cleats.frustumCulled = false;
    this.group.add(cleats);
    return cleats;
  }

  private run(cleats: InstancedMesh, travelled_m: number): void {
    const { axle_spacing_m: spacing, wheel_radius_m: radius } = this.shape;
    const length = stadiumLength(spacing, radius);
    for (let i = 0; i < cleats.count; i++) {
      // The lower run moves backwards as the robot moves forwards.
      const at = onStadium(spacing, radius - 0.002, (i * length) / cleats.count - travelled_m);
      turn.setFromAxisAngle(kSideways, Math.PI / 2 - at.outward_rad);
      matrix.compose(point.set(at.x, 0, at.y + 0.0005), turn, kOne);
      cleats.setMatrixAt(i, matrix);
    }
    cleats.instanceMatrix.needsUpdate = true;
  }
}

/** Two standard deviations of an estimated position along x and along y; their correlation is not shown. */
export class UncertaintyRing {
  readonly line: LineLoop;

  constructor(colour: string) {
    const circle = Array.from({ length: kRingPoints }, (_, i) => {
      const angle = (2 * Math.PI * i) / kRingPoints;
      return new Vector3(Math.cos(angle), Math.sin(angle), 0);
    });
    this.line = new LineLoop(new BufferGeometry().setFromPoints(circle), new LineBasicMaterial({ color: colour }));
  }

  /** Hidden if the recording has no standard deviations. */
  set({ x_m, y_m, z_m, sd_x_m, sd_y_m }: EstimatedPose): void {
    const known = typeof sd_x_m === 'number' && typeof sd_y_m === 'number';
    this.line.visible = known;
    if (!known) return;
    this.line.position.set(x_m, y_m, z_m + kRingLift_m);
    this.line.scale.set(2 * sd_x_m, 2 * sd_y_m, 1);
  }
}

/** The outline of a robot, for a pose other than the steering pose. */
export class GhostModel {
  readonly group = new Group();

  constructor(shape: RobotShape, colour: string) {
    const outline = stadium(shape.axle_spacing_m, shape.wheel_radius_m, 6);
    const geometry = prismGeometry(outline, shape.shoe_width_m);
    const edges = new EdgesGeometry(geometry, 40);
    geometry.dispose();
    for (const side of [-1, 1]) {
      const lines = new LineSegments(edges, new LineBasicMaterial({ color: colour, transparent: true, opacity: 0.9 }));
      lines.position.y = (side * shape.gauge_m) / 2;
      this.group.add(lines);
    }
    this.group.rotation.order = 'ZYX';
  }

  set(pose: Pose): void {
    place(this.group, pose);
  }
}

function place(group: Group, pose: Pose): void {
  group.position.set(pose.x_m, pose.y_m, pose.z_m);
  group.rotation.set(pose.roll_rad, pose.pitch_rad, pose.yaw_rad, 'ZYX');
}

const kSideways = new Vector3(0, 1, 0);
const kOne = new Vector3(1, 1, 1);
const point = new Vector3();
const turn = new Quaternion();
const matrix = new Matrix4();
