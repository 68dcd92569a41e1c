// A recording as a rosbag2 bag, read by packages of other authors: every field is compared with its channels.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import test from 'node:test';
import { readMcap } from './mcap_file.mjs';
import { load } from './packages.mjs';
import { inFolder, lineCourse, program } from './programs.mjs';
import { decode, definitionsOf, difference, elsewhere, quaternion } from './ros2.mjs';

const { parse } = load('@foxglove/rosmsg');
const { parse: parseYaml } = load('yaml');

const near = (actual, expected, what, tolerance = 1e-6) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, expected ${expected}`);
const wrapped = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

/** The variances of a covariance; what else it holds: tests/ros2/topics_test.cpp. */
function nearDeviations(covariance, { sd_x_m, sd_y_m, sd_yaw_rad }, what) {
  for (const [at, sd] of [[0, sd_x_m], [7, sd_y_m], [35, sd_yaw_rad]]) near(covariance[at], sd * sd, `${what} variance ${at}`, 1e-9);
}

/** The numeric keys of a robot's file, by section. */
async function robotFile(name) {
  const sections = {};
  let section = {};
  for (const line of (await readFile(new URL(`../../config/robots/${name}.toml`, import.meta.url), 'utf8')).split('\n')) {
    const [, title] = /^\[(.*)\]$/.exec(line) ?? [], [, key, value] = /^(\w+) = ([-\d.e]+)$/.exec(line) ?? [];
    if (title !== undefined) section = sections[title] = {};
    if (key !== undefined) section[key] = Number(value);
  }
  return sections;
}

/**
 * Records a course in virtual time, which ends with `status`, and calls `work` with its channels and with its bag. Without
 * a name of a course it is a short one.
 */
const bagOf = (options, work, { course, status = 0 } = {}) => inFolder(async (folder) => {
  const name = course ?? await lineCourse(folder, 0.05);
  const ended = spawnSync(program('tp100-sim'), ['course', name, ...options, '--record', join(folder, 'runs')],
    { encoding: 'utf8', stdio: ['ignore', 'ignore', 'pipe'] });
  assert.equal(ended.status, status, ended.stderr);
  const [run] = await readdir(join(folder, 'runs'));
  const bag = join(folder, 'bag');
  execFileSync(program('tp100d'), ['export', join(folder, 'runs', run), '--ros2', bag]);
  assert.deepEqual((await readdir(bag)).sort(), ['bag_0.mcap', 'metadata.yaml']);
  const recording = await readMcap(join(folder, 'runs', run, 'run.mcap'));
  const json = (topic) => recording.topics.get(topic).map(({ logTime, data }) =>
    ({ logTime, value: JSON.parse(new TextDecoder().decode(data)) }));
  let facts;
  for await (const { metadata } of recording.reader.readMetadata({ name: 'tp100' })) facts = Object.fromEntries(metadata);
  const { reader, topics } = await readMcap(join(bag, 'bag_0.mcap'));
  const types = new Map([...reader.channelsById.values()].map((channel) =>
    [channel.topic, reader.schemasById.get(channel.schemaId).name]));
  const messages = (topic) => topics.get(topic).map(({ logTime, data }) => ({ logTime, value: decode(types.get(topic), data) }));
  await work({ folder, reader, topics, types, json, facts, messages, metadata: await readFile(join(bag, 'metadata.yaml'), 'utf8') });
});

// As written by rosbag2: policies of rmw as numbers, and the largest duration for "none".
const wholeNumbers = { intAsBigInt: true };
const endless = { sec: 9223372036n, nsec: 854775807n };
const depths = new Map([['/tf', 100n], ['/imu/data', 5n], ['/clock', 1n]]);
const latched = ['/tf_static', '/path', '/robot_description'], bestEffort = ['/imu/data', '/clock'];
const qosOf = (topic) => ({
  history: 1n, depth: latched.includes(topic) ? 1n : depths.get(topic) ?? 10n, reliability: bestEffort.includes(topic) ? 2n : 1n,
  durability: latched.includes(topic) ? 1n : 2n, deadline: endless, lifespan: endless, liveliness: 1n,
  liveliness_lease_duration: endless, avoid_ros_namespace_conventions: false,
});

test('the bag is what rosbag2 reads', () => bagOf([], async ({ reader, topics, types, metadata }) => {
  assert.equal(reader.header.profile, 'ros2');
  assert.deepEqual([...types.keys()].sort(), ['/battery_state', '/clock', '/ground_truth', '/imu/data', '/joint_states', '/odom',
    '/path', '/pose/fused', '/robot_description', '/tf', '/tf_static', '/tp100/mark', '/tp100/state']);
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    assert.equal(channel.messageEncoding, 'cdr');
    assert.equal(schema.encoding, 'ros2msg');
    assert.match(schema.name, /^\w+\/msg\/\w+$/);
    assert.match(channel.metadata.get('topic_type_hash'), /^RIHS01_[0-9a-f]{64}$/);
    assert.deepEqual(parseYaml(channel.metadata.get('offered_qos_profiles'), wholeNumbers), [qosOf(channel.topic)], channel.topic);
    // The schema must equal the packages' own definitions, message by message.
    const ours = parse(new TextDecoder().decode(schema.data), { ros2: true });
    const fields = (definition) => definition.definitions.filter((field) => !field.isConstant)
      .map(({ name, type, isArray, arrayLength }) => [name, type, isArray ?? false, arrayLength]);
    const known = definitionsOf(schema.name.replace('/msg/', '/'));
    assert.deepEqual(fields(ours[0]), fields(known[0]), schema.name);
    for (const definition of known.slice(1))
      assert.deepEqual(fields(ours.find(({ name }) => name === definition.name)), fields(definition), definition.name);
  }
  const all = [...topics.values()].flat();
  const times = all.map(({ logTime }) => logTime).sort((a, b) => (a < b ? -1 : 1));
  const facts = { starting_time: { nanoseconds_since_epoch: times[0] }, duration: { nanoseconds: times.at(-1) - times[0] },
    message_count: BigInt(all.length) };
  const { rosbag2_bagfile_information: { topics_with_message_count: listed, ...rest } } = parseYaml(metadata, wholeNumbers);
  assert.deepEqual(rest, { version: 5n, storage_identifier: 'mcap', ...facts, compression_format: '', compression_mode: '',
    relative_file_paths: ['bag_0.mcap'], files: [{ path: 'bag_0.mcap', ...facts }] });
  assert.deepEqual(new Map(listed.map((topic) => [topic.topic_metadata.name, topic])), new Map([...reader.channelsById.values()].map(
    ({ topic: name, metadata: channel }) => [name, {
      topic_metadata: { name, type: types.get(name), serialization_format: 'cdr', offered_qos_profiles: channel.get('offered_qos_profiles') },
      message_count: BigInt(topics.get(name)?.length ?? 0),
    }])));
}));

const stampOf = (ns) => ({ sec: Number(ns / 1_000_000_000n), nsec: Number(ns % 1_000_000_000n) });
const nsOf = (seconds) => BigInt(Math.round(seconds * 1e9));
const poseOf = (pose) => ({ position: { x: pose.x_m, y: pose.y_m, z: pose.z_m }, orientation: quaternion(pose) });
const zeros = (count) => new Array(count).fill(0);
const vector = ([x, y, z]) => ({ x, y, z });

/** Expected log times and messages of every topic of the bag, made from the recording's own channels. */
function expectedBag(json, radius, perMetre) {
  const samples = new Map(json('/sample').map(({ logTime, value }) => [logTime, value]));
  const expected = new Map(['/odom', '/tf', '/pose/fused', '/imu/data', '/joint_states', '/battery_state', '/clock'].map((name) => [name, []]));
  let due = 0n;
  for (const { logTime, value: { odometry, fused, tracks } } of json('/estimate')) {
    const add = (topic, value) => expected.get(topic).push({ logTime, value });
    add('/clock', { clock: stampOf(logTime) });
    const sample = samples.get(logTime);
    if (sample === undefined) continue;
    const in_ = (frame_id) => ({ stamp: stampOf(nsOf(sample.t_s)), frame_id });
    const twist = { linear: vector([odometry.vx_mps, odometry.vy_mps, 0]), angular: vector([0, 0, odometry.yaw_rate_radps]) };
    add('/odom', { header: in_('odom'), child_frame_id: 'base_link', pose: { pose: poseOf(odometry), covariance: elsewhere },
      twist: { twist, covariance: elsewhere } });
    const turn = wrapped(fused.yaw_rad - odometry.yaw_rad), [c, s] = [Math.cos(turn), Math.sin(turn)];
    const frame = { x_m: fused.x_m - c * odometry.x_m + s * odometry.y_m, y_m: fused.y_m - s * odometry.x_m - c * odometry.y_m,
      z_m: fused.z_m - odometry.z_m, roll_rad: 0, pitch_rad: 0, yaw_rad: turn };
    const transform = (header, child_frame_id, { position: translation, orientation: rotation }) =>
      ({ header, child_frame_id, transform: { translation, rotation } });
    add('/tf', { transforms: [transform(in_('map'), 'odom', poseOf(frame)), transform(in_('odom'), 'base_link', poseOf(odometry))] });
    add('/pose/fused', { header: in_('map'), pose: { pose: poseOf(fused), covariance: elsewhere } });
    if (sample.imu_age === 0)
      add('/imu/data', { header: in_('imu_link'), orientation: { x: 0, y: 0, z: 0, w: 1 }, orientation_covariance: [-1, ...zeros(8)],
        angular_velocity: vector(sample.gyro_radps), angular_velocity_covariance: elsewhere,
        linear_acceleration: vector(sample.accel_mps2), linear_acceleration_covariance: elsewhere });
    add('/joint_states', { header: in_('base_link'), name: ['left_sprocket_joint', 'right_sprocket_joint'],
      position: [sample.left_counts, sample.right_counts].map((counts) => counts / perMetre / radius),
      velocity: [tracks.left_mps, tracks.right_mps].map((speed) => speed / radius), effort: [] });
    if (logTime < due) continue;
    due = logTime + 1_000_000_000n;
    add('/battery_state', { header: in_('base_link'), voltage: Math.fround(sample.battery_v), temperature: NaN, current: NaN,
      charge: NaN, capacity: NaN, design_capacity: NaN, percentage: NaN, power_supply_status: 0, power_supply_health: 0, power_supply_technology: 0,
      present: true, cell_voltage: [], cell_temperature: [], location: '', serial_number: '' });
  }
  const [{ logTime }] = json('/estimate'), header = { stamp: stampOf(logTime), frame_id: 'map' };
  const still = { x_m: 0, y_m: 0, z_m: 0, roll_rad: 0, pitch_rad: 0, yaw_rad: 0 };
  const { position: translation, orientation: rotation } = poseOf(still);
  const once = (value) => [{ logTime, value }];
  expected.set('/path', once({ header, poses: json('/path')[0].value.poses.map((pose) => ({ header, pose })) }));
  expected.set('/tf_static', once({ transforms: [
    { header: { ...header, frame_id: 'base_link' }, child_frame_id: 'imu_link', transform: { translation, rotation } }] }));
  // Virtual time begins at zero on both clocks.
  expected.set('/ground_truth', json('/truth').map(({ value }) =>
    ({ value: { header: { stamp: stampOf(BigInt(value.host_ns)), frame_id: 'map' }, pose: poseOf(value) } })));
  return expected;
}

const counters = ['bytes_in', 'bytes_out', 'frames_in', 'frames_out', 'samples', 'early', 'lost', 'duplicated', 'reordered',
  'crc_errors', 'cobs_errors', 'oversize', 'undersize', 'unknown_type', 'wrong_size', 'implausible', 'foreign_bytes', 'unwritten',
  'sync_replies', 'sync_rejected', 'reconnects', 'reboots', 'silences', 'unanswered', 'refused', 'unknown_board', 'robot_faults',
  'robot_corrupted', 'missed_edges'];
// Counters that increase on a good link with a robot without faults; all others stay zero.
const counting = ['bytes_in', 'bytes_out', 'frames_in', 'frames_out', 'samples', 'early', 'foreign_bytes', 'sync_replies'];
const preparing = { closed: 2, listening: 1, hello: 1, parameters: 1, syncing: 1 };

/** /tp100/state must be published at each change and once a second, with the current estimates, samples and events. */
function checkStates(states, json, facts) {
  const estimates = new Map(json('/estimate').map(({ logTime, value }) => [logTime, value]));
  const samples = json('/sample');
  const events = json('/event');
  const changes = events.filter(({ value }) => value.text.startsWith('state: ')).map(({ logTime, value }) => {
    const [, run] = /^state: \w+ -> (\w+)$/.exec(value.text);
    // The faults that end a run are reported with the change.
    const faults = events.filter((event) => event.logTime === logTime && event.value.level === 'error').map((event) => event.value);
    const [reason = ''] = faults.map(({ cause, fix }) => `: ${cause}; ${fix}`);
    return { logTime, run, faults: faults.map(({ text }) => text).join(' '), message: run + reason };
  });
  assert.deepEqual(changes.filter(({ logTime }) => !states.some((state) => state.logTime === logTime)), []);
  let before = { logTime: states[0].logTime, counted: counters.map(() => 0) };
  const seconds = Number(states.at(-1).logTime - states[0].logTime) / 1e9;
  assert.ok(states.length < 1.5 * seconds + 10, `${states.length} states in ${seconds} s`);
  for (const { logTime, value } of states) {
    assert.ok(logTime - before.logTime <= 1_010_000_000n, `nothing before ${logTime}`);
    const estimate = estimates.get(logTime), heard = samples.filter((sample) => sample.logTime <= logTime);
    const { run, faults, message } = changes.findLast((change) => change.logTime <= logTime)
      ?? { run: 'idle', faults: '', message: 'idle' };
    const [{ values: said }, { values: link, message: session }] = value.status;
    const numbers = ['progress_m', 'cross_track_m', 'heading_error_rad'];
    const entries = Object.entries({ run, faults, course: facts.course, setup: facts.setup, steering: estimate.steering })
      .concat(numbers.map((key) => [key, elsewhere])).map(([key, text]) => ({ key, value: text }));
    const counts = counters.map((key) => ({ key, value: elsewhere }));
    const newest = heard.length === 0 ? []
      : [{ key: 'robot_state', value: heard.at(-1).value.state }, { key: 'age_us', value: String(estimate.age_us) }];
    if (heard.length > 0) assert.equal(session, 'ready');
    else if (session !== 'ready') assert.ok(session in preparing, session);
    const hardware_id = facts.robot;
    assert.equal(difference(value, { header: { stamp: stampOf(logTime), frame_id: '' }, status: [
      { level: faults === '' ? 0 : 2, name: 'tp100d: run', message, hardware_id, values: entries },
      { level: preparing[session] ?? 0, name: 'tp100d: link', message: session, hardware_id, values: [...newest, ...counts] },
    ] }, 0), undefined, `/tp100/state at ${logTime}`);
    // The text has ten digits.
    numbers.forEach((key, i) => assert.equal(Number(said.at(i - 3).value), Number(estimate[key].toPrecision(10)), key));
    const counted = link.slice(-counters.length).map(({ value: text }) => Number(text));
    counted.forEach((count, i) => {
      assert.ok(Number.isInteger(count) && count >= before.counted[i], `${counters[i]} ${count}`);
      if (counters[i] === 'samples') assert.equal(count, heard.length);
      if (counters[i] === 'robot_faults') assert.equal(count, faults === '' ? 0 : 1);
      else if (!counting.includes(counters[i])) assert.equal(count, 0, counters[i]);
    });
    before = { logTime, counted };
  }
}

const runs = [
  { what: 'with a camera', options: ['--camera'] },
  { what: 'of another robot in another set-up that a fault ends', robot: 'large', status: 1,
    options: ['--robot', 'large', '--setup', 'terrain', '--fault', 'imu-frozen@6'] },
];
for (const { what, options, robot = 'end-loaded', status = 0 } of runs)
  test(`every field is the recording's own, ${what}`, () => bagOf(options, async ({ json, facts, messages, topics }) => {
    const { shape, drive } = await robotFile(robot);
    const expected = expectedBag(json, shape.wheel_radius_m, drive.counts_per_metre);
    const others = ['/robot_description', '/tp100/state'];
    assert.deepEqual([...expected.keys(), ...others].sort(), [...topics.keys()].sort());
    for (const [topic, list] of expected) {
      const found = messages(topic);
      assert.equal(found.length, list.length, topic);
      list.forEach(({ logTime, value }, i) => {
        if (logTime !== undefined) assert.equal(found[i].logTime, logTime, `${topic} ${i}`);
        assert.equal(difference(found[i].value, value, 1e-9), undefined, `${topic} ${i}`);
      });
    }
    assert.ok(expected.get('/odom').length > (status === 0 ? 8000 : 1000));
    checkStates(messages('/tp100/state'), json, facts);
    assert.equal(messages('/tp100/state').at(-1).value.status[0].level, status === 0 ? 0 : 2);

    const estimates = new Map(json('/estimate').map(({ logTime, value }) => [logTime, value]));
    const camera = options.includes('--camera');
    for (const { logTime, value } of messages('/odom')) {
      nearDeviations(value.pose.covariance, estimates.get(logTime).odometry, '/odom');
      for (const at of [0, 35]) assert.ok(value.twist.covariance[at] > 0);
    }
    for (const { logTime, value } of messages('/pose/fused'))
      nearDeviations(value.pose.covariance, estimates.get(logTime).fused, '/pose/fused');
    // Without a camera the odometry frame equals the map frame.
    const shift = Math.max(...messages('/tf').map(({ value }) => Math.hypot(value.transforms[0].transform.translation.x,
      value.transforms[0].transform.translation.y)));
    assert.ok(camera ? shift > 1e-4 : shift === 0, `shift ${shift}`);
  }, { course: '3', status }));

test("every robot's description is a tree from base_link with the sizes of its file", async () => {
  const folder = new URL('../../config/robots/', import.meta.url);
  for (const robot of (await readdir(folder)).map((name) => name.replace('.toml', '')))
    await bagOf(['--robot', robot], async ({ folder: at, messages }) => {
      const [{ value: { data: urdf } }] = messages('/robot_description');
      await writeFile(join(at, 'robot.urdf'), urdf);
      // ROS's own reader.
      assert.equal(execFileSync('check_urdf', [join(at, 'robot.urdf')], { encoding: 'utf8' }), `robot name is: ${robot}\n`
        + '---------- Successfully Parsed XML ---------------\nroot Link: base_link has 3 child(ren)\n'
        + '    child(1):  imu_link\n    child(2):  left_sprocket\n    child(3):  right_sprocket\n');
      const { shape, 'emulated.body': { shoe_width_m: shoe } } = await robotFile(robot);
      const numbers = (text) => text.split(' ').map(Number);
      const [base] = /<link name="base_link">[^]*?<\/link>/.exec(urdf);
      for (const kind of ['visual', 'collision']) {
        const boxes = [...base.matchAll(new RegExp(`<${kind}><origin xyz="([^"]+)" rpy="0 0 0"/><geometry><box size="([^"]+)"/>`, 'g'))]
          .map(([, origin, size]) => ({ origin: numbers(origin), size: numbers(size) }));
        assert.equal(boxes.length, 3);
        const end = (axis, sign) => sign * Math.max(...boxes.map(({ origin, size }) => sign * origin[axis] + size[axis] / 2));
        [shape.length_m / 2, (shape.gauge_m + shoe) / 2].forEach((half, axis) => [1, -1].forEach((sign) =>
          near(end(axis, sign), sign * half, `${robot} ${kind} ${'xy'[axis]}`)));
        near(end(2, 1), shape.height_m, `${robot} ${kind} height`);
        near(end(2, -1), 0, `${robot} ${kind} ground`);
      }
      for (const [side, sign] of [['left', 1], ['right', -1]]) {
        const [, origin, axis] = new RegExp(`<joint name="${side}_sprocket_joint" type="continuous">[^]*?<origin xyz="([^"]+)" rpy="0 0 0"/>`
          + '[^]*?<axis xyz="([^"]+)"/>').exec(urdf);
        [shape.axle_spacing_m / 2, sign * shape.gauge_m / 2, shape.wheel_radius_m].forEach((place, i) =>
          near(numbers(origin)[i], place, `${robot} ${side} sprocket ${i}`));
        assert.equal(axis, '0 1 0');
      }
    });
});
