// The ROS 2 network of a test: other participants (ros2_peer, which is Fast DDS), the emulated robot with daemons, and
// a second host. Programs that are started here do not outlive the test, however it ends.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { encode } from './ros2.mjs';

export const program = (name) => join(process.env.TP100_BIN, name);

/** Configuration that switches ROS 2 on; TP100_ROS2: another line of that section. */
export const ros2On = ['[ros2]', 'enabled = true', process.env.TP100_ROS2 ?? ''].join('\n');

/** Like spawn; the program is killed when this one ends. */
export const start = (command, options, settings) => spawn('setpriv', ['--pdeathsig', 'KILL', command, ...options], settings);

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
    this.waiting = new Set();
    this.command = [...under, program('ros2_peer'), String(domain), ...wanted];
    this.start();
  }
  start() {
    const [command, ...options] = this.command;
    this.process = start(command, options, { stdio: ['pipe', 'pipe', 'inherit'] });
    this.process.stdin.on('error', () => {});
    createInterface({ input: this.process.stdout }).on('line', (line) => {
      this.found.push(JSON.parse(line));
      for (const check of this.waiting) check();
    });
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
    await listener.until(() => listener.found.some(({ listening }) => listening));
    return listener;
  }
  until(condition) {
    return new Promise((resolve) => {
      const check = () => {
        if (!condition()) return;
        this.waiting.delete(check);
        resolve();
      };
      this.waiting.add(check);
      check();
    });
  }
  /** Publishes a message of `type`, package/msg/Name, on a topic that was named with a plus. */
  publish(topic, type, message) {
    this.process.stdin.write(`rt${topic}=${ddsType(type)} ${Buffer.from(encode(type, message)).toString('hex')}\n`);
  }
  /** Waits until the topic has a subscriber. */
  matched(topic, type) {
    return this.until(() => this.found.some(({ matched, count }) => matched === `rt${topic}=${ddsType(type)}` && count > 0));
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

/** Settings of [loop] with which other programs can run at the same time. */
export const ordinary = 'priority = 0\nlock_memory = false\nspin_us = 0\nhold_cpu_latency = false';

/** An emulated robot with these options, for daemons that `work` starts. */
export async function withRobot(work, more = []) {
  const folder = await mkdtemp(join(tmpdir(), 'tp100-npm-'));
  const port = join(folder, 'port');
  const env = { ...process.env, ROS_DOMAIN_ID: '42' };
  const robot = start(program('tp100-sim'), ['robot', '--link', port, ...more], { stdio: ['ignore', 'pipe', 'inherit'], env });
  const running = [];
  try {
    await once(robot.stdout, 'data');
    await work({
      folder,
      /** A daemon with these lines of configuration and variables; `said(pattern)` waits for a line of its log. */
      async daemon(ros2, options, loop = ordinary, variables = {}) {
        const file = join(folder, `${running.length}.toml`);
        await writeFile(file, `[loop]\n${loop}\n${ros2}\n`);
        const child = start(program('tp100d'), ['run', '--config', file, '--port', port, '--listen', 'off', ...options],
          { stdio: ['ignore', 'ignore', 'pipe'], env: { ...env, ...variables } });
        running.push(child);
        const lines = [], waiting = new Set();
        createInterface({ input: child.stderr }).on('line', (line) => {
          lines.push(line);
          // On a busy machine a run may be aborted; the daemon would then wait for another start.
          if (/state: running -> aborted/.test(line) && !options.includes('--stay')) child.kill('SIGTERM');
          for (const check of waiting) check();
        });
        const exit = once(child, 'exit');
        const said = (pattern) => Promise.race([
          new Promise((resolve) => {
            const check = () => { if (lines.some((line) => pattern.test(line))) resolve(); };
            waiting.add(check);
            check();
          }),
          exit.then(() => assert.match(lines.join('\n'), pattern)),
        ]);
        return { child, exit, said, lines };
      },
    });
  } finally {
    for (const child of [...running, robot]) child.kill('SIGKILL');
    await rm(folder, { recursive: true, force: true });
  }
}

/** The value below which this share of the values lies. */
export const percentile = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];

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

