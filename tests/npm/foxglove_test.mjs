// Foxglove's own client on tp100d and an emulated robot.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import test from 'node:test';
import { load } from './packages.mjs';
import { until, withRobot } from './programs.mjs';

const { FoxgloveClient } = load('@foxglove/ws-protocol');
const { WebSocket } = load('ws');
const text = new TextDecoder();

/** The client and what it has received. */
class Viewer {
  constructor(url, protocol) {
    this.socket = new WebSocket(url.replace('http', 'ws'), [protocol]);
    this.client = new FoxgloveClient({ ws: this.socket });
    this.channels = new Map();
    this.services = new Map();
    this.messages = new Map();
    this.status = [];
    this.parameters = [];
    this.answers = [];
    this.client.on('serverInfo', (info) => { this.info = info; });
    this.client.on('advertise', (list) => list.forEach((each) => this.channels.set(each.topic, each)));
    this.client.on('advertiseServices', (list) => list.forEach((each) => this.services.set(each.name, each)));
    this.client.on('status', (status) => this.status.push(status));
    this.client.on('parameterValues', (values) => this.parameters.push(values));
    this.client.on('serviceCallResponse', ({ data }) => this.answers.push(JSON.parse(text.decode(data))));
    this.client.on('message', ({ subscriptionId, timestamp, data }) => {
      this.messages.get(subscriptionId)?.push({ timestamp, value: JSON.parse(text.decode(data)) });
    });
    this.client.on('error', (error) => { throw error; });
  }
  subscribe(topic) {
    const list = [];
    this.messages.set(this.client.subscribe(this.channels.get(topic).id), list);
    return list;
  }
}

test("Foxglove's client works with tp100d", { timeout: 240_000 }, (t) => withRobot(async ({ daemon }) => {
  const { said, lines } = await daemon('', ['--wait', '--stay', '--course', '3', '--listen', '127.0.0.1:0']);
  await said(/page: /);
  const [, url] = lines.map((line) => /page: (\S+)/.exec(line)).find(Boolean);

  /** A test with a viewer of its own. */
  const viewed = (name, work, protocol = 'foxglove.sdk.v1') => t.test(name, async () => {
    const viewer = new Viewer(url, protocol);
    await until(() => viewer.info && viewer.channels.size > 0 && viewer.services.size > 0);
    await work(viewer);
    viewer.client.close();
    await once(viewer.socket, 'close');
  });

  for (const protocol of ['foxglove.websocket.v1', 'foxglove.sdk.v1'])
    await viewed(`it lists the channels over ${protocol}`, async (viewer) => {
      assert.equal(viewer.socket.protocol, protocol);
      assert.equal(viewer.info.metadata.course, '3');
      const names = { '/tf': 'foxglove.FrameTransforms', '/pose/odometry': 'foxglove.PoseInFrame', '/path': 'foxglove.PosesInFrame',
        '/scene': 'foxglove.SceneUpdate', '/log': 'foxglove.Log', '/estimate': 'tp100.Estimate', '/state': 'tp100.State' };
      for (const [topic, schema] of Object.entries(names)) {
        assert.equal(viewer.channels.get(topic)?.schemaName, schema, topic);
        assert.equal(viewer.channels.get(topic).encoding, 'json');
      }
      const scene = viewer.subscribe('/scene');
      await until(() => scene.length > 0);
      const ids = scene[0].value.entities.map((entity) => entity.id);
      for (const id of ['course/path', 'course/ramp/0', 'course/block/0', 'robot/body']) assert.ok(ids.includes(id), id);
    }, protocol);

  await viewed('it receives every pose, 200 a second, and stops the robot', async (viewer) => {
    const [poses, estimates, states] = ['/pose/odometry', '/estimate', '/state'].map((topic) => viewer.subscribe(topic));
    await until(() => poses.length > 400);
    assert.equal(poses[0].value.frame_id, 'world');
    // The test uses the time stamps, because a busy machine delays messages and may drop some of them.
    const gaps = poses.slice(1).map((each, i) => Number(each.timestamp - poses[i].timestamp)).sort((a, b) => a - b);
    assert.ok(Math.abs(gaps[gaps.length >> 1] - 5e6) < 5e5, `median ${gaps[gaps.length >> 1]} ns`);
    // The pose of a step must equal the estimate of the same step.
    const match = estimates.find((each) => each.timestamp === poses.at(-10).timestamp);
    assert.equal(match.value.odometry.x_m, poses.at(-10).value.pose.position.x);

    viewer.client.sendServiceCallRequest({ serviceId: viewer.services.get('stop').id, callId: 1, encoding: 'json', data: new DataView(new TextEncoder().encode('{}').buffer) });
    const answer = await until(() => viewer.answers[0]);
    assert.equal(answer.acknowledged, true);
    const { value: { stop } } = await until(() => states.find((each) => each.value.stop.status === 'acknowledged'));
    assert.equal(stop.acknowledged_ms, answer.acknowledged_ms);
    assert.equal(stop.latched, true);
  });

  await viewed('it sets a parameter within its limits', async (viewer) => {
    const name = 'control.cross_track_gain_1ps';
    const set = async (value, id) => {
      viewer.client.setParameters([{ name, value }], id);
      return (await until(() => viewer.parameters.find((each) => each.id === id))).parameters[0].value;
    };
    assert.equal(await set(4.5, 'good'), 4.5);
    assert.equal(await set(50.5, 'large'), 4.5);
    assert.match(viewer.status.at(-1).message, /0 to 50 1\/s/);
  });
}));
