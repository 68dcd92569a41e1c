// ROS 2 messages with packages of other authors: message definitions and a reader and writer of CDR.
import { load } from './packages.mjs';

const { ros2jazzy } = load('@foxglove/rosmsg-msgs-common');
const { MessageReader, MessageWriter } = load('@foxglove/rosmsg2-serialization');
const readers = new Map(), writers = new Map();

/** The definition of `type` (package/Name), followed by those of all nested messages. */
export function definitionsOf(type) {
  const found = new Map();
  const collect = (name) => {
    if (found.has(name)) return;
    found.set(name, ros2jazzy[name]);
    for (const field of ros2jazzy[name].definitions) if (field.isComplex) collect(field.type);
  };
  collect(type);
  return [...found.values()];
}

/** Decodes a message of `type` (package/msg/Name). */
export function decode(type, bytes) {
  if (!readers.has(type)) readers.set(type, new MessageReader(definitionsOf(type.replace('/msg/', '/'))));
  return readers.get(type).readMessage(bytes);
}

/** Encodes a message of `type` (package/msg/Name); missing fields are zero. */
export function encode(type, message) {
  if (!writers.has(type)) writers.set(type, new MessageWriter(definitionsOf(type.replace('/msg/', '/'))));
  return writers.get(type).writeMessage(message);
}

/** A time of ROS in nanoseconds. */
export const nanoseconds = (time) => BigInt(time.sec) * 1_000_000_000n + BigInt(time.nanosec ?? time.nsec);

/** Roll, pitch and yaw of a quaternion. */
export function angles({ x, y, z, w }) {
  return {
    roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    pitch: Math.asin(2 * (w * y - z * x)),
    yaw: Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  };
}

/** The rotation of a pose. */
export function quaternion({ roll_rad: roll, pitch_rad: pitch, yaw_rad: yaw }) {
  const [cr, cp, cy] = [roll, pitch, yaw].map((angle) => Math.cos(angle / 2));
  const [sr, sp, sy] = [roll, pitch, yaw].map((angle) => Math.sin(angle / 2));
  return { x: sr * cp * cy - cr * sp * sy, y: cr * sp * cy + sr * cp * sy, z: cr * cp * sy - sr * sp * cy,
    w: cr * cp * cy + sr * sp * sy };
}

/** Marks a field that is compared elsewhere. */
export const elsewhere = Symbol('elsewhere');

/** The path of the first difference from the expected message, including extra or missing fields; numbers may differ by
 * `tolerance`. */
export function difference(actual, expected, tolerance) {
  if (expected === elsewhere || Object.is(actual, expected)) return undefined;
  if (typeof expected === 'number' && typeof actual === 'number' && Math.abs(actual - expected) <= tolerance) return undefined;
  if (typeof expected !== 'object' || typeof actual !== 'object') return `: ${actual}, expected ${expected}`;
  const names = Object.keys(expected), others = Object.keys(actual);
  if (names.length !== others.length || !names.every((name) => name in actual)) return `: fields ${others}, expected ${names}`;
  for (const name of names) {
    const found = difference(actual[name], expected[name], tolerance);
    if (found !== undefined) return `.${name}${found}`;
  }
  return undefined;
}
