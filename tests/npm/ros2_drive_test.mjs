// The robot driven over ROS 2's topics by Fast DDS (ros2_peer), in a network of its own (in_network).
import assert from 'node:assert/strict';
import { join } from 'node:path';
import test from 'node:test';
import { pause, until, withRobot } from './programs.mjs';
import { Driver, loseDriver, losses, movedAfter, twist, twistStamped } from './ros2_driver.mjs';
import { Peer, ddsType, ros2On, withSecondHost } from './ros2_network.mjs';

const limits = { timeout: 120_000 };
const stays = ['--stay', '--wait'];

// A square and its diagonal, with turns to both sides.
const waypoints = [[0.3, 0], [0.3, 0.3], [0, 0.3], [0, 0], [0.3, 0.3], [0.3, 0]];

for (const type of [twist, twistStamped])
  test(`a node drives the robot through waypoints by ${type}`, limits, (t) => withRobot(async ({ daemon }) => {
    const run = await daemon(ros2On, stays);
    const driver = new Driver(run, { type });
    await driver.take();
    await until(() => driver.peer.messages('/ground_truth').length > 0);
    for (const [x, y] of waypoints) {
      const { x: seen_x, y: seen_y } = await driver.driveTo(x, y);
      const truth = driver.truth(), off_m = Math.hypot(truth.x - x, truth.y - y);
      t.diagnostic(`(${x}, ${y}): ${Math.hypot(seen_x - x, seen_y - y).toFixed(3)} m off by odometry, ${off_m.toFixed(3)} m in truth`);
      assert.ok(off_m < 0.05, `(${x}, ${y}): the robot is at (${truth.x}, ${truth.y})`);
    }
    await driver.peer.end();
  }, ['--ros2']));

test('the robot is told to stop within 250 ms of the last message of a driver that is lost, and brakes to a standstill', limits, (t) =>
  withSecondHost((under) => withRobot(async ({ folder, daemon }) => {
    const record = join(folder, 'runs');
    const run = await daemon(`${ros2On}\ninterface = "eth0"\n[server]\ncommands = "all"`, ['--wait', '--record', record]);
    const times = [];
    for (const loss of Object.keys(losses))
      times.push({ loss, ...await loseDriver(run, loss, { under }) });
    run.child.kill('SIGTERM');
    await run.exit;
    (await movedAfter(record, times)).forEach(({ told, moved }, i) => {
      const { loss } = times[i];
      assert.ok(told !== undefined && moved !== undefined, `${loss}: the robot was not driven before`);
      t.diagnostic(`${loss}: told to move for ${told.toFixed(0)} ms, moved for ${moved.toFixed(0)} ms`);
      assert.ok(told < 250, `${loss}: the robot was told to move for ${told} ms`);
      // Time to brake from 0.15 m/s at 0.6 m/s^2 and for the robot's loops to settle.
      assert.ok(moved < 1200, `${loss}: the robot moved for ${moved} ms`);
    });
  })));

test('no node of another machine drives unless server.commands says so', limits, () => withRobot(async ({ daemon }) => {
  const peer = new Peer(42, ['+rt/cmd_vel=geometry_msgs::msg::dds_::Twist_=RV', 'rt/odom=nav_msgs::msg::dds_::Odometry_=RV']);
  const never = await daemon(`${ros2On}\n[server]\ncommands = "none"`, stays);
  await never.said(/ROS 2 may not drive: server.commands is "none"/);
  await until(() => peer.messages('/odom').length > 200);
  assert.ok(!peer.found.some(({ matched, count }) => matched && count > 0));
  never.child.kill('SIGTERM');
  await never.exit;
  const here = await daemon(ros2On, stays);
  await here.said(/ROS 2 may drive/);
  await peer.matched('/cmd_vel', 'geometry_msgs/msg/Twist');
  await peer.end();
}));

test('a node places the robot, and what is no message is refused', limits, () => withRobot(async ({ daemon }) => {
  const pose = 'geometry_msgs/msg/PoseWithCovarianceStamped';
  const run = await daemon(ros2On, stays);
  const driver = new Driver(run);
  const peer = new Peer(42, [`+rt/initialpose=${ddsType(pose)}=RV`, `+rt/cmd_vel=${ddsType(twist)}=RV`]);
  await run.said(/state: syncing -> ready/);
  await peer.matched('/initialpose', pose);
  // Repeats until it is received: the daemon's reader may discover this writer only after the message.
  const heard = async (send, pattern) => {
    for (; !run.lines.some((line) => pattern.test(line)); await Promise.race([run.said(pattern), pause(2000)])) send();
  };
  const at = { header: { frame_id: 'map' }, pose: { pose: { position: { x: 0.5, y: -0.25 }, orientation: { z: Math.SQRT1_2, w: Math.SQRT1_2 } } } };
  await heard(() => peer.publish('/initialpose', pose, at), /placed at \(0\.500, -0\.250\) m, 90\.0 deg/);
  await until(() => driver.peer.messages('/odom').length > 0 && Math.abs(driver.place().x - 0.5) < 0.01
    && Math.abs(driver.place().yaw - Math.PI / 2) < 0.01);
  // Big-endian, too long, 64 KB, empty; NaN. Sent before another writer drives, when they would be ignored.
  const broken = ['00000000', `00010000${'00'.repeat(60)}`, `00010000${'ff'.repeat(65000)}`, '00', `00010000${'ff'.repeat(48)}`];
  await driver.take();
  await heard(() => broken.forEach((cdr) => peer.process.stdin.write(`rt/cmd_vel=geometry_msgs::msg::dds_::Twist_ ${cdr}\n`)),
    /\/cmd_vel refused: no geometry_msgs\/msg\/Twist in little-endian CDR/);
  await driver.driveTo(0.5, -0.15);
  await Promise.all([driver.peer.end(), peer.end()]);
}));
