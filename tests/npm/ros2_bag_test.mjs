// A recording as a bag of rosbag2, read by other authors' packages: every field against the recording's own channels.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { readMcap } from './mcap_file.mjs';
import { load } from './packages.mjs';
import { angles, decode, definitionsOf, nanoseconds, planarVariances } from './ros2.mjs';

const { parse } = load('@foxglove/rosmsg');
const program = (name) => join(process.env.TP100_BIN, name);

const near = (actual, expected, what, tolerance = 1e-6) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, expected ${expected}`);
const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

function nearPose({ position, orientation }, pose, what) {
  near(position.x, pose.x_m, `${what} x`);
  near(position.y, pose.y_m, `${what} y`);
  near(position.z, pose.z_m, `${what} z`);
  const { roll, pitch, yaw } = angles(orientation);
  near(roll, pose.roll_rad, `${what} roll`);
  near(pitch, pose.pitch_rad, `${what} pitch`);
  near(wrapped(yaw - pose.yaw_rad), 0, `${what} yaw`);
}

function nearDeviations(covariance, { sd_x_m: x, sd_y_m: y, sd_yaw_rad: yaw }, what) {
  const expected = [x * x, y * y, yaw * yaw];
  planarVariances(covariance).forEach((value, i) => near(value, expected[i], `${what} variance ${i}`, 1e-9));
}

/** Records a course in virtual time and calls `work` with its channels and with its bag. */
async function bagOf(options, work) {
  const folder = await mkdtemp(join(tmpdir(), 'tp100-npm-'));
  try {
    execFileSync(program('tp100-sim'), ['course', '3', ...options, '--record', join(folder, 'runs'), '--json']);
    const [run] = await readdir(join(folder, 'runs'));
    const bag = join(folder, 'bag');
    execFileSync(program('tp100d'), ['export', join(folder, 'runs', run), '--ros2', bag]);
    assert.deepEqual((await readdir(bag)).sort(), ['bag_0.mcap', 'metadata.yaml']);
    const recording = (await readMcap(join(folder, 'runs', run, 'run.mcap'))).topics;
    const json = (topic) => recording.get(topic).map(({ logTime, data }) =>
      ({ logTime, value: JSON.parse(new TextDecoder().decode(data)) }));
    const { reader, topics } = await readMcap(join(bag, 'bag_0.mcap'));
    const types = new Map([...reader.channelsById.values()].map((channel) =>
      [channel.topic, reader.schemasById.get(channel.schemaId).name]));
    const messages = (topic) => topics.get(topic).map(({ logTime, data }) =>
      ({ logTime, value: decode(types.get(topic), data) }));
    await work({ reader, topics, types, json, messages, metadata: await readFile(join(bag, 'metadata.yaml'), 'utf8') });
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

test('the bag is what rosbag2 reads', () => bagOf([], async ({ reader, topics, types, metadata }) => {
  assert.equal(reader.header.profile, 'ros2');
  assert.deepEqual([...types.keys()].sort(), ['/battery_state', '/clock', '/ground_truth', '/imu/data', '/joint_states', '/odom',
    '/path', '/pose/fused', '/robot_description', '/tf', '/tf_static', '/tp100/state']);
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    assert.equal(channel.messageEncoding, 'cdr');
    assert.equal(schema.encoding, 'ros2msg');
    assert.match(schema.name, /^\w+\/msg\/\w+$/);
    assert.match(channel.metadata.get('topic_type_hash'), /^RIHS01_[0-9a-f]{64}$/);
    const latched = ['/tf_static', '/path', '/robot_description'].includes(channel.topic);
    const lossy = ['/imu/data', '/clock'].includes(channel.topic);
    assert.match(channel.metadata.get('offered_qos_profiles'), new RegExp(
      `^- history: 1\n  depth: \\d+\n  reliability: ${lossy ? 2 : 1}\n  durability: ${latched ? 1 : 2}\n`), channel.topic);
    // The schema says what the packages' own definition says, message by message.
    const ours = parse(new TextDecoder().decode(schema.data), { ros2: true });
    const fields = (definition) => definition.definitions.filter((field) => !field.isConstant)
      .map(({ name, type, isArray, arrayLength }) => [name, type, isArray ?? false, arrayLength]);
    const known = definitionsOf(schema.name.replace('/msg/', '/'));
    assert.deepEqual(fields(ours[0]), fields(known[0]), schema.name);
    for (const definition of known.slice(1))
      assert.deepEqual(fields(ours.find(({ name }) => name === definition.name)), fields(definition), definition.name);
  }
  const entry = /name: (\S+)\n {8}type: (\S+)\n[^]*?message_count: (\d+)/g;
  const listed = [...metadata.matchAll(entry)].map(([, name, type, count]) => [name, type, Number(count)]);
  assert.deepEqual(listed.sort(), [...types].map(([name, type]) => [name, type, topics.get(name).length]).sort());
  const all = [...topics.values()].flat();
  const times = all.map(({ logTime }) => logTime).sort((a, b) => (a < b ? -1 : 1));
  assert.ok(metadata.includes(`nanoseconds_since_epoch: ${times[0]}\n`));
  assert.ok(metadata.includes(`  nanoseconds: ${times.at(-1) - times[0]}\n`));
  assert.ok(metadata.includes(`  message_count: ${all.length}\n`));
  assert.match(metadata, /storage_identifier: mcap\n[^]*relative_file_paths:\n {4}- "bag_0.mcap"\n/);
}));

for (const camera of [false, true])
  test(`every field is the recording's own, ${camera ? 'with' : 'without'} a camera`, () => bagOf(
    camera ? ['--camera'] : [], async ({ json, messages }) => {
      const estimates = new Map(json('/estimate').map(({ logTime, value }) => [logTime, value]));
      const samples = new Map(json('/sample').map(({ value }) => [Math.round(value.t_s * 1e6), value]));
      const sampleAt = (stamp) => samples.get(Math.round(Number(nanoseconds(stamp)) / 1e3));
      const [course] = json('/course').map(({ value }) => value);
      const radius = course.robot.wheel_radius_m;

      // Every sample is in every message that follows from one, and nothing else is.
      for (const topic of ['/odom', '/tf', '/pose/fused', '/joint_states', '/imu/data']) {
        const stamps = messages(topic).map(({ value }) => sampleAt((value.transforms?.[0] ?? value).header.stamp));
        assert.ok(!stamps.includes(undefined), topic);
        assert.equal(new Set(stamps).size, stamps.length, topic);
        assert.ok(stamps.length > 4000 && stamps.length >= samples.size - 1, `${topic}: ${stamps.length} of ${samples.size}`);
      }

      let spread = 0, correlated = 0, turning = 0;
      for (const { logTime, value } of messages('/odom')) {
        const { odometry, fused } = estimates.get(logTime);
        assert.deepEqual([value.header.frame_id, value.child_frame_id], ['odom', 'base_link']);
        nearPose(value.pose.pose, odometry, '/odom');
        near(value.twist.twist.linear.x, odometry.vx_mps, 'vx');
        near(value.twist.twist.linear.y, odometry.vy_mps, 'vy');
        near(value.twist.twist.angular.z, odometry.yaw_rate_radps, 'yaw rate');
        // Without a camera it is the fused estimate's. With one, only that knows where it is all the time.
        if (!camera) nearDeviations(value.pose.covariance, fused, '/odom');
        const [x, y, yaw] = planarVariances(value.pose.covariance);
        spread = Math.max(spread, Math.sqrt(x + y) / Math.hypot(fused.sd_x_m, fused.sd_y_m));
        correlated = Math.max(correlated, Math.abs(value.pose.covariance[11]) / Math.sqrt(y * yaw));
        const [forward, , rate] = planarVariances(value.twist.covariance);
        assert.ok(forward > 0 && rate > 0);
        if (rate < 1e6) turning = Math.max(turning, Math.sqrt(rate));
      }
      assert.ok(camera ? spread > 3 : spread < 1.001, `odometry's place against the fused one's: ${spread}`);
      assert.ok(correlated > 0.5 && correlated <= 1, `correlation of y and yaw: ${correlated}`);
      assert.ok(turning < 0.1, `yaw rate: ${turning}`);

      let shift = 0;
      for (const { logTime, value } of messages('/tf')) {
        const { odometry, fused } = estimates.get(logTime);
        const [first, second] = value.transforms;
        assert.deepEqual([first.header.frame_id, first.child_frame_id], ['map', 'odom']);
        assert.deepEqual([second.header.frame_id, second.child_frame_id], ['odom', 'base_link']);
        const { translation: t, rotation } = first.transform, { translation: p } = second.transform;
        nearPose({ position: p, orientation: second.transform.rotation }, odometry, '/tf odom');
        const { roll, pitch, yaw } = angles(rotation);
        near(roll, 0, 'map roll');
        near(pitch, 0, 'map pitch');
        near(t.x + Math.cos(yaw) * p.x - Math.sin(yaw) * p.y, fused.x_m, '/tf x in map');
        near(t.y + Math.sin(yaw) * p.x + Math.cos(yaw) * p.y, fused.y_m, '/tf y in map');
        near(t.z + p.z, fused.z_m, '/tf z in map');
        near(wrapped(yaw + odometry.yaw_rad - fused.yaw_rad), 0, '/tf yaw in map');
        shift = Math.max(shift, Math.hypot(t.x, t.y), Math.abs(yaw));
      }
      // Without a camera the odometry's frame is the map's.
      assert.ok(camera ? shift > 1e-4 : shift === 0, `shift ${shift}`);

      for (const { logTime, value } of messages('/pose/fused')) {
        const { fused } = estimates.get(logTime);
        assert.equal(value.header.frame_id, 'map');
        nearPose(value.pose.pose, fused, '/pose/fused');
        nearDeviations(value.pose.covariance, fused, '/pose/fused');
      }

      for (const { value } of messages('/imu/data')) {
        const sample = sampleAt(value.header.stamp);
        assert.equal(sample.imu_age, 0);
        assert.equal(value.header.frame_id, 'imu_link');
        assert.equal(value.orientation_covariance[0], -1);
        for (const covariance of [value.angular_velocity_covariance, value.linear_acceleration_covariance])
          covariance.forEach((variance, i) => assert.equal(variance > 0, i % 4 === 0));
        const of = ({ x, y, z }) => [x, y, z];
        of(value.angular_velocity).forEach((rate, i) => near(rate, sample.gyro_radps[i], 'gyro'));
        of(value.linear_acceleration).forEach((force, i) => near(force, sample.accel_mps2[i], 'accelerometer'));
      }

      const perRadian = 11140 * radius;
      for (const { logTime, value } of messages('/joint_states')) {
        const sample = sampleAt(value.header.stamp), { tracks } = estimates.get(logTime);
        assert.deepEqual(value.name, ['left_sprocket_joint', 'right_sprocket_joint']);
        near(value.position[0] * perRadian, sample.left_counts, 'left', 1e-3);
        near(value.position[1] * perRadian, sample.right_counts, 'right', 1e-3);
        near(value.velocity[0] * radius, tracks.left_mps, 'left speed');
        near(value.velocity[1] * radius, tracks.right_mps, 'right speed');
      }

      const batteries = messages('/battery_state');
      assert.ok(batteries.length > 10);
      for (const { value } of batteries) {
        near(value.voltage, sampleAt(value.header.stamp).battery_v, 'battery', 1e-4);
        assert.ok(Number.isNaN(value.percentage));
        assert.equal(value.present, true);
      }

      const [{ value: path }] = messages('/path');
      assert.equal(path.header.frame_id, 'map');
      assert.equal(path.poses.length, course.path.length);
      path.poses.forEach(({ pose }, i) => nearPose(pose,
        { ...course.path[i], z_m: 0, roll_rad: 0, pitch_rad: 0 }, `/path ${i}`));

      // The state says every change of the run that the recording's events say.
      const runs = [];
      for (const { value } of messages('/tp100/state')) {
        assert.deepEqual(value.status.map(({ name }) => name), ['tp100d: run', 'tp100d: link']);
        const run = value.status[0].values.find(({ key }) => key === 'run').value;
        if (run !== runs.at(-1)) runs.push(run);
        for (const status of value.status) assert.ok(status.level <= 2);
      }
      const changes = json('/event').map(({ value }) => /^state: (\w+) -> (\w+)$/.exec(value.text)).filter(
        (match) => match && ['arming', 'running', 'finished'].includes(match[2])).map((match) => match[2]);
      assert.deepEqual(runs.filter((run) => run !== 'idle'), changes);

      const truth = new Map(json('/truth').map(({ value }) => [value.host_ns, value]));
      assert.equal(messages('/ground_truth').length, truth.size);
      for (const { value } of messages('/ground_truth')) {
        // Virtual time begins at zero on both clocks.
        nearPose(value.pose, truth.get(Number(nanoseconds(value.header.stamp))), '/ground_truth');
        assert.equal(value.header.frame_id, 'map');
      }
      for (const { logTime, value } of messages('/clock')) assert.equal(nanoseconds(value.clock), logTime);
      const [{ value: fixed }] = messages('/tf_static');
      assert.deepEqual(fixed.transforms.map(({ header, child_frame_id: child }) => [header.frame_id, child]),
        [['base_link', 'imu_link']]);
      assert.match(messages('/robot_description')[0].value.data, /^<\?xml[^]*<robot name="end-loaded">[^]*<\/robot>\n$/);
    }));
