// The robot started over ROS 2's topics by Fast DDS (ros2_peer), in a network of its own (in_network). What else is
// refused: tests/ros2/inputs_test.cpp, tests/live/ros2_requests_test.cpp.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import test from 'node:test';
import { pause, program, until, withRobot } from './programs.mjs';
import { angles, decode } from './ros2.mjs';
import { Peer, ddsType, ros2On } from './ros2_network.mjs';

const limits = { timeout: 240_000 };
const pose = 'geometry_msgs/msg/PoseStamped', string = 'std_msgs/msg/String', empty = 'std_msgs/msg/Empty';
const diagnostics = 'diagnostic_msgs/msg/DiagnosticArray', fused = 'geometry_msgs/msg/PoseWithCovarianceStamped';
const silenceMs = 2100;
const unheardMs = 3000;
// What a busy machine may answer instead: then the request is sent again.
const busy = /refused: |is repeated|state: (arming|running) -> (aborted|idle)/;

/** A node that starts the robot, and the daemon's log about it. */
class Starter {
  constructor(run) {
    this.run = run;
    this.asked = new Map();
    this.peer = new Peer(42, [`+rt/goal_pose=${ddsType(pose)}=RV`, `+rt/tp100/course=${ddsType(string)}=RV`,
      `+rt/tp100/stop=${ddsType(empty)}=RV`, `rt/tp100/state=${ddsType(diagnostics)}=RV`, `rt/pose/fused=${ddsType(fused)}=RV`,
      `rt/ground_truth=${ddsType(pose)}=RV`]);
  }
  /**
   * Sends a request, once it does not count as a repetition, until the log has that line. Repeats it if a busy machine
   * ends the run or its start, or if nothing is logged: the daemon's reader may discover this writer too late.
   */
  async ask(topic, type, message, answer) {
    await this.peer.matched(topic, type);
    for (let line = ''; !answer.test(line);) {
      for (const next = (this.asked.get(topic) ?? 0) + silenceMs; Date.now() < next;) await pause(25);
      const before = this.run.lines.length;
      this.peer.publish(topic, type, message);
      this.asked.set(topic, Date.now());
      line = await this.said(new RegExp(`${answer.source}|${busy.source}`), before, unheardMs);
    }
  }
  /** The first matching line; empty if after `unheard` ms there is no line about a request or a state either. */
  async said(pattern, from, unheard = Infinity) {
    for (const asked = Date.now();;) {
      const lines = this.run.lines.slice(from), line = lines.find((each) => pattern.test(each));
      if (line !== undefined) return line;
      if (Date.now() - asked > unheard && !lines.some((each) => /ROS 2|STOP|state:|course /.test(each))) return '';
      await pause(25);
    }
  }
  goal(x, y, yaw, answer) {
    return this.ask('/goal_pose', pose, { header: { frame_id: 'map' },
      pose: { position: { x, y }, orientation: { z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) } } }, answer);
  }
  course(data, answer) {
    return this.ask('/tp100/course', string, { data }, answer);
  }
  stop() {
    return this.ask('/tp100/stop', empty, {}, /\/tp100\/stop: STOP|-> aborted/);
  }
  /** The answer in the newest /tp100/state. */
  answer() {
    const newest = this.peer.messages('/tp100/state').at(-1);
    return newest && decode(diagnostics, newest).status.find(({ name }) => name === 'tp100d: answer');
  }
}

test('a node sends the robot to a goal, and then on a course by its name, and is told why a request is refused', limits, (t) => withRobot(async ({ folder, daemon }) => {
  const records = join(folder, 'runs');
  const run = await daemon(ros2On, ['--stay', '--wait', '--course', '1-straight', '--record', records]);
  const starter = new Starter(run);
  // The first run begins by itself.
  await run.said(/state: arming -> running/);
  await starter.stop();
  await run.said(/state: running -> aborted/);

  await starter.course('1-shrap', /\/tp100\/course refused: 1-shrap: no such course; did you mean '1-sharp'/);
  await until(() => starter.answer()?.message.includes("did you mean '1-sharp'"));
  assert.equal(starter.answer().level, 1);
  // A writer of another type is not matched at all.
  const other = new Peer(42, ['+rt/goal_pose=geometry_msgs::msg::dds_::Pose_=RV', `+rt/tp100/stop=${ddsType(empty)}=RV`]);
  await other.matched('/tp100/stop', empty);
  assert.ok(!other.found.some(({ matched, count }) => matched?.startsWith('rt/goal_pose') && count > 0));
  await other.end();

  const [x, y, yaw] = [0.5, 0.3, 2.0];
  await starter.goal(x, y, yaw, /state: running -> finished/);
  assert.ok(run.lines.some((line) => /course goal, robot/.test(line)));
  for (const [topic, type] of [['/pose/fused', fused], ['/ground_truth', pose]]) {
    const message = decode(type, starter.peer.messages(topic).at(-1));
    const at = message.pose.pose ?? message.pose;
    const off = { m: Math.hypot(at.position.x - x, at.position.y - y), rad: Math.abs(angles(at.orientation).yaw - yaw) };
    t.diagnostic(`${topic}: ${(off.m * 1000).toFixed(1)} mm, ${(off.rad * 180 / Math.PI).toFixed(2)} deg from the goal`);
    assert.ok(off.m < 0.05 && off.rad < 0.1, `${topic}: ${JSON.stringify(at)}`);
  }
  const from = run.lines.length;
  await starter.course('1-curve/start', /state: arming -> running/);
  await starter.stop();
  await starter.said(/state: running -> aborted/, from);
  assert.ok(run.lines.some((line) => /course 1-curve, robot/.test(line)));
  await starter.peer.end();
  run.child.kill('SIGTERM');
  await run.exit;
  // Every recording must replay bit for bit, with any course.
  for (const record of await readdir(records))
    execFileSync(program('tp100d'), ['replay', join(records, record), '--out', join(folder, 'again')], { stdio: 'ignore' });
}, ['--ros2']));

test('where nothing else is taken from nodes, a STOP is', limits, () => withRobot(async ({ daemon }) => {
  const run = await daemon(`${ros2On}\n[server]\ncommands = "none"`, ['--stay', '--wait', '--course', '1-straight']);
  const starter = new Starter(run);
  await run.said(/state: arming -> running/);
  await starter.stop();
  await run.said(/state: running -> aborted/);
  assert.ok(!starter.peer.found.some(({ matched, count }) => matched?.startsWith('rt/goal_pose') && count > 0));
  await starter.peer.end();
}));
