// The robot driven over ROS 2's topics by Fast DDS (ros2_peer), in a network of its own (in_network).
import assert from 'node:assert/strict';
import test from 'node:test';
import { angles, decode } from './ros2.mjs';
import { Peer, ddsType, withRobot } from './ros2_network.mjs';

const limits = { timeout: 120_000 };
const odometry = 'nav_msgs/msg/Odometry', twist = 'geometry_msgs/msg/Twist', bool = 'std_msgs/msg/Bool';
const wanted = [`rt/odom=${ddsType(odometry)}=RV`, `+rt/cmd_vel=${ddsType(twist)}=RV`, `+rt/tp100/drive=${ddsType(bool)}=RV`];

const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

/** Where the robot is, by the newest /odom. */
function place(peer) {
  const { pose } = decode(odometry, peer.messages('/odom').at(-1)).pose;
  return { ...pose.position, yaw: angles(pose.orientation).yaw };
}

test('a node drives the robot through waypoints', limits, (t) => withRobot(async ({ daemon }) => {
  const peer = new Peer(42, wanted);
  try {
    const run = await daemon('[ros2]\nenabled = true', ['--stay', '--wait'], 'priority = 0');
    await run.said(/state: syncing -> ready/);
    await Promise.all([peer.matched('/cmd_vel', twist), peer.matched('/tp100/drive', bool)]);
    await pause(3000);
    peer.publish('/tp100/drive', bool, { data: true });
    await run.said(/ROS 2 \/cmd_vel takes the wheel/);
    for (const [x, y] of [[0.3, 0], [0.3, 0.2], [0, 0.2]]) {
      for (;;) {
        const at = place(peer);
        const away = Math.hypot(x - at.x, y - at.y);
        if (away < 0.03) break;
        const off = Math.atan2(y - at.y, x - at.x) - at.yaw;
        const turn = Math.atan2(Math.sin(off), Math.cos(off));
        peer.publish('/cmd_vel', twist, {
          linear: { x: Math.abs(turn) < 0.3 ? 0.1 : 0 }, angular: { z: Math.max(-0.8, Math.min(0.8, 2 * turn)) },
        });
        await pause(25);
      }
      t.diagnostic(`reached ${JSON.stringify(place(peer))}`);
    }
  } finally {
    await peer.end();
  }
}));
