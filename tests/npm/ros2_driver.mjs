// A ROS 2 node that drives the robot, kinds of its loss, and how long the robot is told to move and moves after it.
import { execFileSync } from 'node:child_process';
import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { readMcap } from './mcap_file.mjs';
import { pause } from './programs.mjs';
import { angles, decode } from './ros2.mjs';
import { Peer, ddsType } from './ros2_network.mjs';

const odometry = 'nav_msgs/msg/Odometry', bool = 'std_msgs/msg/Bool', truth = 'geometry_msgs/msg/PoseStamped';
export const twist = 'geometry_msgs/msg/Twist', twistStamped = 'geometry_msgs/msg/TwistStamped';
const periodMs = 25;

export class Driver {
  /** `under`: prefix of its command. */
  constructor(run, { domain = 42, type = twist, under = [] } = {}) {
    this.run = run;
    this.type = type;
    this.peer = new Peer(domain, [`rt/odom=${ddsType(odometry)}=RV`, `rt/ground_truth=${ddsType(truth)}=RV`,
      `+rt/cmd_vel=${ddsType(type)}=RV`, `+rt/tp100/drive=${ddsType(bool)}=RV`], under);
  }
  /** Takes the lease as soon as the daemon permits it. */
  async take() {
    this.ended = this.drivesEnded();
    await Promise.all([this.peer.matched('/cmd_vel', this.type), this.peer.matched('/tp100/drive', bool)]);
    const taken = () => this.run.lines.filter((line) => /ROS 2 \/cmd_vel takes the lease/.test(line)).length;
    // A refusal is logged at once. Do not ask again too soon, because that would release the lease.
    for (const before = taken(), askMs = 2000; taken() === before;) {
      this.peer.publish('/tp100/drive', bool, { data: false });
      this.peer.publish('/tp100/drive', bool, { data: true });
      const refused = () => this.run.lines.filter((line) => /\/tp100\/drive refused/.test(line)).length;
      const refusedBefore = refused();
      for (const end = Date.now() + askMs; Date.now() < end && taken() === before && refused() === refusedBefore;) await pause(25);
    }
  }
  drivesEnded() {
    return this.run.lines.filter((line) => /state: driving -> /.test(line)).length;
  }
  /** Sends one velocity; `stamp_ms`: its time stamp. */
  drive(speed_mps, rate_radps, stamp_ms = Date.now()) {
    const velocity = { linear: { x: speed_mps }, angular: { z: rate_radps } };
    const stamp = { sec: Math.floor(stamp_ms / 1000), nanosec: Math.round(stamp_ms % 1000 * 1e6) };
    this.peer.publish('/cmd_vel', this.type, this.type === twist ? velocity : { header: { stamp, frame_id: 'base_link' }, twist: velocity });
  }
  /** Drives at a constant velocity; returns the time of the last message. */
  async driveFor(ms, speed_mps, rate_radps) {
    let last = 0;
    for (const end = Date.now() + ms; Date.now() < end;) {
      last = Date.now();
      this.drive(speed_mps, rate_radps);
      await pause(periodMs);
    }
    return last;
  }
  /** The robot's pose by the newest /odom. */
  place() {
    const { pose } = decode(odometry, this.peer.messages('/odom').at(-1)).pose;
    return { ...pose.position, yaw: angles(pose.orientation).yaw };
  }
  /** The robot's true position by the newest /ground_truth of an emulator that publishes it. */
  truth() {
    return decode(truth, this.peer.messages('/ground_truth').at(-1)).pose.position;
  }
  /** Drives to within 3 cm of a point; drives again if a pause of the machine ended the drive. */
  async driveTo(x, y) {
    for (;;) {
      if (this.drivesEnded() > this.ended) await this.take();
      const at = this.place();
      if (Math.hypot(x - at.x, y - at.y) < 0.03) return at;
      const off = Math.atan2(y - at.y, x - at.x) - at.yaw;
      const turn = Math.atan2(Math.sin(off), Math.cos(off));
      this.drive(Math.abs(turn) < 0.3 ? 0.1 : 0, Math.max(-0.8, Math.min(0.8, 2 * turn)));
      await pause(periodMs);
    }
  }
}

/** Long enough for the robot to stop, and too short to be disarmed for silence. */
const lossMs = 1500;

/** Kinds of loss of the driver, each for lossMs in real time; then the driver is ended. If it returns earlier, the
 * end of its loss is returned. */
export const losses = {
  'silence': () => pause(lossMs),
  'writer killed': async (driver) => {
    driver.peer.kill();
    await pause(lossMs);
  },
  'writer frozen': async (driver) => {
    driver.peer.process.kill('SIGSTOP');
    await pause(lossMs);
    driver.peer.kill();
  },
  // Messages continue, with an unchanged stamp.
  'frozen stamp': async (driver, last) => {
    for (const end = Date.now() + lossMs; Date.now() < end; await pause(periodMs)) driver.drive(0.1, 0.3, last);
  },
  // The other end of the network keeps sending.
  'link cut': async (driver) => {
    execFileSync('ip', ['link', 'set', 'eth0', 'down']);
    const end = await driver.driveFor(lossMs, 0.1, 0.3);
    execFileSync('ip', ['link', 'set', 'eth0', 'up']);
    // A participant that starts before the other end has noticed would not use the link.
    await pause(1000);
    return end;
  },
};

/** Loses a driver; returns the time of its last fresh message, and begin and end of the loss [ms]. */
export async function loseDriver(run, loss, settings) {
  const driver = new Driver(run, { ...settings, type: loss === 'frozen stamp' ? twistStamped : twist });
  await driver.take();
  const begin = Date.now();
  let last = await driver.driveFor(400 + Math.random() * 300, 0.05 + Math.random() * 0.1, Math.random() - 0.5);
  const end = await losses[loss](driver, last) ?? Date.now();
  // A driver that still runs knows when it sent the last message.
  if (loss === 'silence') last = Math.max(...driver.peer.found.map(({ written_ns }) => (written_ns ?? 0) / 1e6));
  driver.peer.kill();
  return { begin, last, end };
}

/** For each of these times: milliseconds after `last` until which the recording's commands request motion (`told`) and
 * its encoders count (`moved`); undefined if they did not before. */
export async function movedAfter(folder, times) {
  const [run] = await readdir(folder);
  const { topics } = await readMcap(join(folder, run, 'run.mcap'));
  const all = (topic) => topics.get(topic).map(({ data, logTime }) =>
    ({ at: Number(logTime) / 1e6, ...JSON.parse(Buffer.from(data).toString()) }));
  const told = all('/command').filter(({ speed_mps, yaw_rate_radps }) => speed_mps !== 0 || yaw_rate_radps !== 0).map(({ at }) => at);
  const moved = all('/sample').filter(({ left_counts, right_counts }, i, samples) =>
    i > 0 && (left_counts !== samples[i - 1].left_counts || right_counts !== samples[i - 1].right_counts))
    .map(({ at, age_us }) => at - age_us / 1e3);
  const after = (moving, { begin, last, end }) => moving.some((at) => at > begin && at <= last)
    ? Math.max(0, ...moving.filter((at) => at > last && at < end).map((at) => at - last)) : undefined;
  return times.map((time) => ({ told: after(told, time), moved: after(moved, time) }));
}
