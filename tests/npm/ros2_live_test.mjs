// The real daemon on ROS 2's topics, received by Fast DDS (ros2_peer), in a network of its own (in_network): what
// arrives is compared byte by byte with the bag of the same run, whose fields ros2_bag_test.mjs compares.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, readdirSync } from 'node:fs';
import { readdir, writeFile } from 'node:fs/promises';
import { cpus } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { readMcap } from './mcap_file.mjs';
import { load } from './packages.mjs';
import { inFolder, lineCourse, ordinary, program, start, until, withRobot } from './programs.mjs';
import { decode, nanoseconds } from './ros2.mjs';
import { Driver } from './ros2_driver.mjs';
import { Peer, ddsType, discovery, latched, ros2On, topics, withSecondHost } from './ros2_network.mjs';

const { parse } = load('@foxglove/rosmsg');
const { MessageReader } = load('@foxglove/rosmsg2-serialization');
const limits = { timeout: 120_000 };

async function bagOf(folder) {
  const [run] = await readdir(join(folder, 'runs'));
  execFileSync(program('tp100d'), ['export', join(folder, 'runs', run), '--ros2', join(folder, 'bag')]);
  return readMcap(join(folder, 'bag', 'bag_0.mcap'));
}

/** DDS pads a message to a multiple of four bytes. */
const same = (received, written) => received.length - written.length < 4
  && received.subarray(0, written.length).equals(written);

/** Expects every message of a bag on its topic, once and in order; the first ones may precede the meeting of both ends. */
function sameAsBag(listener, bag, all, t) {
  for (const [topic, [, qos]] of all) {
    const received = listener.messages(topic), sent = bag.get(topic).map(({ data }) => Buffer.from(data));
    assert.ok(received.length > 0, topic);
    t.diagnostic(`${topic}: ${received.length} of ${sent.length}`);
    if (latched.includes(topic)) {
      // Its stamp is the daemon's start; the bag's is that of its first step.
      assert.equal(received.length, 1, topic);
    } else if (qos[0] === 'B') {
      // Best effort: some messages may be lost, but none may be altered or repeated.
      let at = -1;
      for (const bytes of received) {
        at = sent.findIndex((each, i) => i > at && same(bytes, each));
        assert.ok(at >= 0, `${topic}: an unknown message`);
      }
    } else {
      const missed = sent.findIndex((each) => same(received[0], each));
      assert.ok(missed >= 0, `${topic}: an unknown message`);
      assert.equal(received.length, sent.length - missed, topic);
      received.forEach((bytes, i) => assert.ok(same(bytes, sent[missed + i]), `${topic} ${i}`));
    }
  }
}

test('another implementation receives every message of a run', limits, (t) => withRobot(async ({ folder, daemon }) => {
  const listener = await Peer.ofEverything(42);
  t.after(() => listener.end());
  const run = await daemon(ros2On, ['--course', await lineCourse(folder, 0.3), '--record', join(folder, 'runs')]);
  await run.exit;
  await listener.end();
  const { reader, topics: bag } = await bagOf(folder);
  sameAsBag(listener, bag, topics, t);

  // The announced writers must be those of the bag's channels.
  const writers = listener.found.filter(({ writer }) => writer);
  assert.deepEqual(writers.map(({ topic }) => topic).sort(), [discovery, ...[...topics.keys()].map((name) => `rt${name}`)].sort());
  for (const channel of reader.channelsById.values()) {
    // Marks come from nodes, and go only into bags.
    if (channel.topic === '/tp100/mark') continue;
    const [type, qos] = topics.get(channel.topic);
    const writer = writers.find(({ topic }) => topic === `rt${channel.topic}`);
    assert.equal(writer.type, ddsType(type));
    assert.equal(writer.qos, qos, channel.topic);
    assert.equal(writer.user_data, `typehash=${channel.metadata.get('topic_type_hash')};`);
  }

  // The graph of ROS 2: one node that owns all writers but the graph's.
  const [participant] = listener.found.filter((each) => each.participant);
  assert.equal(participant.user_data, 'enclave=/;');
  const line = '='.repeat(80);
  const entities = new MessageReader(parse(
    `Gid gid\nNodeEntitiesInfo[] node_entities_info_seq\n${line}\nMSG: rmw_dds_common/Gid\nuint8[16] data\n${line}\n`
    + 'MSG: rmw_dds_common/NodeEntitiesInfo\nstring node_namespace\nstring node_name\nGid[] reader_gid_seq\nGid[] writer_gid_seq\n',
    { ros2: true }));
  const graph = listener.found.filter(({ message }) => message === discovery);
  assert.equal(graph.length, 1);
  const info = entities.readMessage(Buffer.from(graph[0].cdr, 'hex'));
  const hex = ({ data }) => Buffer.from(data).toString('hex');
  assert.equal(hex(info.gid), participant.participant);
  assert.deepEqual(info.node_entities_info_seq.map((node) => [node.node_namespace, node.node_name]), [['/', 'tp100d']]);
  assert.deepEqual(info.node_entities_info_seq[0].writer_gid_seq.map(hex).sort(),
    writers.filter(({ topic }) => topic !== discovery).map(({ writer }) => writer).sort());
}));

test('who comes late receives what is latched', limits, (t) => withRobot(async ({ daemon }) => {
  // The configuration key overrides the environment's domain.
  const run = await daemon('[ros2]\nenabled = true\ndomain = 3', ['--course', '1-straight', '--stay', '--wait']);
  await run.said(/state: syncing -> ready/);
  const listener = await Peer.ofEverything(3);
  const strict = new Peer(3, ['rt/imu/data=sensor_msgs::msg::dds_::Imu_=RV', 'rt/odom=nav_msgs::msg::dds_::Odometry_=RT']);
  t.after(() => Promise.all([listener.end(), strict.end()]));
  await until(() => [...topics.keys()].every((topic) => listener.messages(topic).length > 0));
  for (const topic of latched) {
    assert.equal(listener.messages(topic).length, 1, topic);
    const value = decode(topics.get(topic)[0], listener.messages(topic)[0]);
    if (topic === '/path') assert.ok(value.poses.length > 50);
  }
  // Subscriptions with a QoS that is not offered are refused as DDS prescribes.
  await until(() => ['rt/imu/data', 'rt/odom'].every((topic) =>
    strict.found.some(({ incompatible }) => incompatible === topic)));
  assert.ok(!strict.found.some(({ message }) => message));
}));

test('threads of DDS have neither the scheduling nor the processor of the loop', limits, () => withRobot(async ({ daemon }) => {
  const run = await daemon(ros2On, ['--stay', '--wait'], ordinary.replace('priority = 0', 'priority = 1\ncpu = 0'));
  await run.said(/state: syncing -> ready/);
  const folder = `/proc/${run.child.pid}/task`;
  const threads = readdirSync(folder).map((id) => ({
    name: readFileSync(join(folder, id, 'comm'), 'utf8').trim(),
    // From the third field on; the name before may have spaces.
    policy: readFileSync(join(folder, id, 'stat'), 'utf8').split(') ').at(-1).split(' ')[38],
    processors: /Cpus_allowed_list:\s*(\S+)/.exec(readFileSync(join(folder, id, 'status'), 'utf8'))[1],
  }));
  const text = JSON.stringify(threads);
  assert.ok(threads.some(({ name }) => name === 'recv'), text);
  // The thread that carries out STOP is in real time, too.
  assert.ok(threads.filter(({ name, policy }) => policy === '1' && name !== 'sockets').length <= 1, text);
  if (cpus().length > 1) assert.equal(threads.filter(({ processors }) => processors === '0').length, 1, text);
}));

test('a course in virtual time is on the topics as it is in its bag, with /clock and the truth', limits, (t) => inFolder(async (folder) => {
  const simulated = new Map([...topics, ['/clock', ['rosgraph_msgs/msg/Clock', 'BV']], ['/ground_truth', ['geometry_msgs/msg/PoseStamped', 'RV']]]);
  const listener = new Peer(42, [...simulated].map(([name, [type, qos]]) => `rt${name}=${ddsType(type)}=${qos}`));
  t.after(() => listener.end());
  await until(() => listener.found.some(({ listening }) => listening));
  const simulation = start(program('tp100-sim'), ['course', await lineCourse(folder, 0.3), '--ros2', '--record', join(folder, 'runs')],
    { stdio: ['ignore', 'ignore', 'inherit'], env: { ...process.env, ROS_DOMAIN_ID: '42' } });
  assert.deepEqual(await once(simulation, 'exit'), [0, null]);
  await listener.end();
  sameAsBag(listener, (await bagOf(folder)).topics, simulated, t);
  const clock = listener.messages('/clock').map((bytes) => nanoseconds(decode('rosgraph_msgs/msg/Clock', bytes).clock));
  clock.forEach((at, i) => assert.ok(i === 0 || at > clock[i - 1]));
  // Virtual time must not run faster than real time.
  const times = listener.found.filter(({ message }) => message === 'rt/clock').map(({ received_ns }) => BigInt(received_ns));
  assert.ok(times.at(-1) - times[0] > (clock.at(-1) - clock[0]) * 9n / 10n);
}));

/** Calls `work` with a loopback interface as on most machines, without multicast. */
async function withoutMulticast(work) {
  const ip = (options) => execFileSync('ip', options.split(' '));
  ip('link set lo multicast off');
  ip('route del 224.0.0.0/4 dev lo');
  try {
    await work();
  } finally {
    ip('link set lo multicast on');
    ip('route add 224.0.0.0/4 dev lo');
  }
}

const withoutCourse = new Map([...topics].filter(([name]) => name !== '/path'));
for (const [announced, domain] of [['at 127.0.0.1', '42>127.0.0.1'], ['by multicast alone', '42@127.0.0.1']])
  test(`without multicast on lo both ends meet if the other one is announced ${announced}`, limits, (t) =>
    withoutMulticast(() => withRobot(async ({ daemon }) => {
      const run = await daemon(ros2On, ['--stay', '--wait']);
      const listener = new Peer(domain, [...withoutCourse].map(([name, [type, qos]]) => `rt${name}=${ddsType(type)}=${qos}`));
      const driver = new Driver(run, { domain });
      try {
        await until(() => [...withoutCourse.keys()].every((topic) => listener.messages(topic).length > 0));
        await driver.take();
        await until(() => driver.peer.messages('/odom').length > 0);
        const begin = driver.place();
        await driver.driveTo(begin.x + 0.1, begin.y);
        t.diagnostic(`drove from ${begin.x.toFixed(3)} to ${driver.place().x.toFixed(3)} m`);
      } finally {
        await Promise.all([listener.end(), driver.peer.end()]);
      }
    })));

/** Those of these ports of 10.0.0.1 that are closed to another host; `under`: prefix of commands on that host. */
const closedPorts = (under, ports) => JSON.parse(execFileSync(under[0], [...under.slice(1), process.execPath, '-e', `
  const { createSocket } = require('node:dgram');
  const closed = [];
  for (const port of ${JSON.stringify(ports)}) {
    const socket = createSocket('udp4');
    socket.on('error', () => closed.push(port));
    socket.connect(port, '10.0.0.1', () => socket.send('x'));
    setTimeout(() => socket.close(), 300);
  }
  setTimeout(() => console.log(JSON.stringify(closed)), 500);`]));

test('another host sees what is published on its network, and nothing of this machine alone', limits, () =>
  withSecondHost((under) => withRobot(async ({ daemon }) => {
    // Ports of domain 42: two of discovery, and the first participant's own.
    const ports = [17900, 17901, 17910, 17911];
    const odometry = ['rt/odom=nav_msgs::msg::dds_::Odometry_=RV'];
    const there = new Peer(42, odometry, under), here = new Peer('42@127.0.0.1', odometry);
    try {
      const local = await daemon(ros2On, ['--stay', '--wait']);
      await until(() => here.messages('/odom').length > 400);
      assert.ok(!there.found.some(({ participant }) => participant));
      assert.deepEqual(closedPorts(under, ports), ports);
      local.child.kill('SIGTERM');
      await local.exit;
      const open = await daemon('[ros2]\nenabled = true\ninterface = "eth0"', ['--stay', '--wait']);
      await until(() => there.messages('/odom').length > 400);
      assert.deepEqual(closedPorts(under, ports.slice(0, 2)), []);
      open.child.kill('SIGTERM');
      await open.exit;
      // Each step once, in order.
      const stamps = there.messages('/odom').map((bytes) => nanoseconds(decode('nav_msgs/msg/Odometry', bytes).header.stamp));
      stamps.forEach((stamp, i) => assert.ok(i === 0 || stamp > stamps[i - 1]));
    } finally {
      await Promise.all([there.end(), here.end()]);
    }
  })));

test('interface = "" leaves Cyclone DDS to CYCLONEDDS_URI: peers that it lists are found without multicast', limits, () =>
  withSecondHost((under) => withRobot(async ({ folder, daemon }) => {
    const file = join(folder, 'cyclone.xml');
    await writeFile(file, '<CycloneDDS><Domain id="any">'
      + '<General><Interfaces><NetworkInterface name="eth0"/></Interfaces><AllowMulticast>false</AllowMulticast></General>'
      + '<Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer address="10.0.0.2"/></Peers></Discovery>'
      + '</Domain></CycloneDDS>');
    const there = new Peer(42, ['rt/odom=nav_msgs::msg::dds_::Odometry_=RV'], under);
    try {
      await daemon('[ros2]\nenabled = true\ninterface = ""', ['--stay', '--wait'], ordinary, { CYCLONEDDS_URI: `file://${file}` });
      await until(() => there.messages('/odom').length > 100);
      // The port of domain 42 for discovery by multicast.
      assert.deepEqual(closedPorts(under, [17900]), [17900]);
    } finally {
      await there.end();
    }
  })));
