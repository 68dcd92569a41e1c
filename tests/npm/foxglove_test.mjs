// Foxglove's own client on tp100d and an emulated robot.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import test from 'node:test';
import { load } from './packages.mjs';
import { until, withRobot } from './programs.mjs';

const { FoxgloveClient } = load('@foxglove/ws-protocol');
const { WebSocket } = load('ws');
const text = new TextDecoder();

/** Of a person who has seen this message of /state. */
const consent = ({ value }) => ({ stops: value.stop.count, t_s: value.t_s });

/** The client and what it has received; `until` waits for a condition on it. */
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
    this.calls = 0;
    this.client.on('serverInfo', (info) => { this.info = info; });
    this.client.on('advertise', (list) => list.forEach((each) => this.channels.set(each.topic, each)));
    this.client.on('advertiseServices', (list) => list.forEach((each) => this.services.set(each.name, each)));
    this.client.on('status', (status) => this.status.push(status));
    this.client.on('parameterValues', (values) => this.parameters.push(values));
    this.client.on('serviceCallResponse', (answer) => this.answers.push(answer));
    this.client.on('serviceCallFailure', (failure) => this.answers.push(failure));
    this.client.on('message', ({ subscriptionId, timestamp, data }) => {
      this.messages.get(subscriptionId)?.push({ timestamp, value: JSON.parse(text.decode(data)) });
    });
    this.client.on('error', (error) => { this.failed = error; });
  }
  until(condition) {
    return until(() => {
      if (this.failed) throw this.failed;
      return condition();
    });
  }
  async open() {
    await this.until(() => this.info && this.channels.size > 0 && this.services.size > 0);
    return this;
  }
  subscribe(topic) {
    const list = [];
    this.messages.set(this.client.subscribe(this.channels.get(topic).id), list);
    return list;
  }
  /** Same as until, for a moving robot. If the robot stands or had to stop because the machine was busy, it is started. */
  untilDriven(states, condition) {
    let seen;
    return this.until(() => {
      const found = condition();
      if (!found && states.at(-1) !== seen) {
        seen = states.at(-1);
        if (seen.value.can.start) this.call('start', consent(seen));
      }
      return found;
    });
  }
  async call(name, request = {}) {
    const callId = ++this.calls;
    this.client.sendServiceCallRequest({
      serviceId: this.services.get(name).id, callId, encoding: 'json',
      data: new DataView(new TextEncoder().encode(JSON.stringify(request)).buffer),
    });
    const answer = await this.until(() => this.answers.find((each) => each.callId === callId));
    return answer.data ? JSON.parse(text.decode(answer.data)) : answer;
  }
  async close() {
    if (this.socket.readyState === WebSocket.CLOSED) return;
    this.client.close();
    await once(this.socket, 'close');
  }
}

test("Foxglove's client works with tp100d", { timeout: 240_000 }, (t) => withRobot(async ({ daemon }) => {
  const { said, lines } = await daemon('', ['--wait', '--stay', '--course', '3', '--listen', '127.0.0.1:0']);
  await said(/page: /);
  const [, url] = lines.map((line) => /page: (\S+)/.exec(line)).find(Boolean);

  /** A test with a viewer of its own. */
  const viewed = (name, work, protocol = 'foxglove.sdk.v1') => t.test(name, async () => {
    const viewer = await new Viewer(url, protocol).open();
    await work(viewer);
    await viewer.close();
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
      await viewer.until(() => scene.length > 0);
      const ids = scene[0].value.entities.map((entity) => entity.id);
      for (const id of ['course/path', 'course/ramp/0', 'course/block/0', 'robot/body']) assert.ok(ids.includes(id), id);
    }, protocol);

  await viewed('it receives every pose of a moving robot, 200 a second, and stops and starts it', async (viewer) => {
    const [poses, estimates, states] = ['/pose/odometry', '/estimate', '/state'].map((topic) => viewer.subscribe(topic));
    await viewer.untilDriven(states, () => (poses.at(-1)?.value.pose.position.x ?? 0) > 0.1);
    assert.equal(poses[0].value.frame_id, 'world');
    // The test uses the time stamps, because a busy machine delays messages and may drop some of them.
    const gaps = poses.slice(1).map((each, i) => Number(each.timestamp - poses[i].timestamp)).sort((a, b) => a - b);
    assert.ok(Math.abs(gaps[gaps.length >> 1] - 5e6) < 5e5, `median ${gaps[gaps.length >> 1]} ns`);
    // The pose of a step must equal the estimate of the same step.
    const match = estimates.find((each) => each.timestamp === poses.at(-10).timestamp);
    assert.equal(match.value.odometry.x_m, poses.at(-10).value.pose.position.x);

    states.length = 0;
    const answer = await viewer.call('stop');
    assert.equal(answer.acknowledged, true);
    const state = await viewer.until(() => states.find((each) => each.value.run === 'aborted'));
    assert.deepEqual(state.value.faults.map((fault) => fault.name), ['stop_requested']);
    const last = (await viewer.until(() => states.find((each) => each.value.stop.status === 'acknowledged'))).value;
    assert.equal(last.stop.acknowledged_ms, answer.acknowledged_ms);
    // Only a start ends the latched stop.
    assert.equal(last.stop.latched, true);
    await viewer.until(() => states.at(-1).value.can.start);
    assert.deepEqual(await viewer.call('start', consent(states.at(-1))), { accepted: true });
    await viewer.until(() => states.at(-1).value.run === 'running');
    assert.equal(states.at(-1).value.stop.latched, false);
  });

  await viewed('it sets a parameter within its limits', async (viewer) => {
    const name = 'control.cross_track_gain_1ps';
    const set = async (value, id) => {
      viewer.client.setParameters([{ name, value }], id);
      return (await viewer.until(() => viewer.parameters.find((each) => each.id === id))).parameters[0].value;
    };
    assert.equal(await set(4.5, 'good'), 4.5);
    assert.equal(await set(50.5, 'large'), 4.5);
    assert.match(viewer.status.at(-1).message, /0 to 50 1\/s/);
  });
}));
