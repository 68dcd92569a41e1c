// The ROS 2 network of a test: other participants (ros2_peer, which is Fast DDS) and a second host.
import { execFileSync } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { program, start, until } from './programs.mjs';
import { encode } from './ros2.mjs';

/** Configuration that switches ROS 2 on; TP100_ROS2: another line of that section. */
export const ros2On = ['[ros2]', 'enabled = true', process.env.TP100_ROS2 ?? ''].join('\n');

// Topic: type, and quality of service: reliable or best effort, transient local or volatile.
export const topics = new Map([
  ['/odom', ['nav_msgs/msg/Odometry', 'RV']],
  ['/tf', ['tf2_msgs/msg/TFMessage', 'RV']],
  ['/tf_static', ['tf2_msgs/msg/TFMessage', 'RT']],
  ['/pose/fused', ['geometry_msgs/msg/PoseWithCovarianceStamped', 'RV']],
  ['/imu/data', ['sensor_msgs/msg/Imu', 'BV']],
  ['/joint_states', ['sensor_msgs/msg/JointState', 'RV']],
  ['/battery_state', ['sensor_msgs/msg/BatteryState', 'RV']],
  ['/path', ['nav_msgs/msg/Path', 'RT']],
  ['/tp100/state', ['diagnostic_msgs/msg/DiagnosticArray', 'RV']],
  ['/robot_description', ['std_msgs/msg/String', 'RT']],
]);
export const latched = ['/tf_static', '/path', '/robot_description'];
export const discovery = 'ros_discovery_info';
const entitiesType = 'rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_';
export const ddsType = (type) => `${type.replace('/msg/', '::msg::dds_::')}_`;

/** A Fast DDS participant and what it has found and received. */
export class Peer {
  /** `under`: prefix of its command. */
  constructor(domain, wanted, under = []) {
    this.found = [];
    this.command = [...under, program('ros2_peer'), String(domain), ...wanted];
    this.start();
  }
  start() {
    const [command, ...options] = this.command;
    this.process = start(command, options, { stdio: ['pipe', 'pipe', 'inherit'] });
    this.process.stdin.on('error', () => {});
    createInterface({ input: this.process.stdout }).on('line', (line) => this.found.push(JSON.parse(line)));
    // Fast DDS 2.9.1 may send to a newly discovered participant before it has opened a channel to it, and then aborts
    // (https://github.com/eProsima/Fast-DDS/pull/3169).
    this.process.once('exit', (code, signal) => {
      if (signal !== 'SIGABRT') return;
      this.found = this.found.filter(({ matched }) => matched === undefined);
      this.start();
    });
  }
  /** Subscribes to all topics with the offered quality of service. */
  static async ofEverything(domain) {
    const listener = new Peer(domain, [...[...topics].map(([name, [type, qos]]) => `rt${name}=${ddsType(type)}=${qos}`),
      `${discovery}=${entitiesType}=RT`]);
    await until(() => listener.found.some(({ listening }) => listening));
    return listener;
  }
  /** Publishes a message of `type`, package/msg/Name, on a topic that was named with a plus. */
  publish(topic, type, message) {
    this.process.stdin.write(`rt${topic}=${ddsType(type)} ${Buffer.from(encode(type, message)).toString('hex')}\n`);
  }
  /** Waits until the topic has a subscriber. */
  matched(topic, type) {
    return until(() => this.found.some(({ matched, count }) => matched === `rt${topic}=${ddsType(type)}` && count > 0));
  }
  kill() {
    this.process.kill('SIGKILL');
  }
  /** Messages of a topic of ROS, as bytes. */
  messages(topic) {
    return this.found.filter(({ message }) => message === `rt${topic}`).map(({ cdr }) => Buffer.from(cdr, 'hex'));
  }
  async end() {
    this.process.stdin.end();
    if (this.process.exitCode === null && this.process.signalCode === null) await once(this.process, 'exit');
  }
}

/** Calls `work` with a command that runs another one on a second host, at the other end of the network eth0. */
export async function withSecondHost(work) {
  const ip = (...options) => execFileSync('ip', options);
  const host = start('unshare', ['--net', 'cat'], { stdio: ['pipe', 'pipe', 'inherit'] });
  try {
    // It echoes once it is in its own network.
    host.stdin.write('there\n');
    await once(host.stdout, 'data');
    const under = ['nsenter', '--target', String(host.pid), '--net'];
    ip('link', 'add', 'eth0', 'type', 'veth', 'peer', 'name', 'eth0', 'netns', String(host.pid));
    ip('address', 'add', '10.0.0.1/24', 'dev', 'eth0');
    ip('link', 'set', 'eth0', 'up');
    for (const options of ['link set lo up', 'address add 10.0.0.2/24 dev eth0', 'link set eth0 up', 'route add default dev eth0'])
      execFileSync(under[0], [...under.slice(1), 'ip', ...options.split(' ')]);
    await work(under);
  } finally {
    host.stdin.end();
    await once(host, 'exit');
  }
}
