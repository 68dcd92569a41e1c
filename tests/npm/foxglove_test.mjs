// Foxglove's own client on tp100d and an emulated robot.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import test from 'node:test';
import { load } from './packages.mjs';
import { withRobot } from './programs.mjs';

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
    this.waiting = new Set();
    const on = (name, take) => this.client.on(name, (event) => {
      take(event);
      for (const check of this.waiting) check();
    });
    on('serverInfo', (info) => { this.info = info; });
    on('advertise', (list) => list.forEach((each) => this.channels.set(each.topic, each)));
    on('advertiseServices', (list) => list.forEach((each) => this.services.set(each.name, each)));
    on('status', (status) => this.status.push(status));
    on('parameterValues', (values) => this.parameters.push(values));
    on('serviceCallResponse', (answer) => this.answers.push(answer));
    on('serviceCallFailure', (failure) => this.answers.push(failure));
    on('message', ({ subscriptionId, timestamp, data }) => {
      this.messages.get(subscriptionId)?.push({ timestamp, value: JSON.parse(text.decode(data)) });
    });
    this.error = new Promise((_, reject) => this.client.on('error', reject));
    this.error.catch(() => {});
  }
  until(condition) {
    const met = new Promise((resolve) => {
      const check = () => {
        const found = condition();
        if (!found) return;
        this.waiting.delete(check);
        resolve(found);
      };
      this.waiting.add(check);
      check();
    });
    return Promise.race([met, this.error]);
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
      assert.equal(viewer.info.name, 'tp100d');
      assert.equal(viewer.info.metadata.course, '3');
      const names = { '/tf': 'foxglove.FrameTransforms', '/pose/odometry': 'foxglove.PoseInFrame',
        '/path': 'foxglove.PosesInFrame', '/scene': 'foxglove.SceneUpdate', '/log': 'foxglove.Log',
        '/estimate': 'tp100.Estimate', '/sample': 'tp100.Sample', '/command': 'tp100.Command',
        '/slip': 'tp100.Slip', '/link': 'tp100.Link', '/loop': 'tp100.Loop', '/state': 'tp100.State' };
      for (const [topic, schema] of Object.entries(names)) {
        assert.equal(viewer.channels.get(topic)?.schemaName, schema, topic);
        assert.equal(viewer.channels.get(topic).encoding, 'json');
      }
      const scene = viewer.subscribe('/scene');
      await viewer.until(() => scene.length > 0);
      const ids = scene[0].value.entities.map((entity) => entity.id);
      for (const id of ['course/path', 'course/ramp/0', 'course/block/0', 'robot/body']) assert.ok(ids.includes(id), id);
    }, protocol);

  await viewed('it receives every pose of a moving robot, 200 a second', async (viewer) => {
    const poses = viewer.subscribe('/pose/odometry');
    const estimates = viewer.subscribe('/estimate');
    const states = viewer.subscribe('/state');
    await viewer.untilDriven(states, () => (poses.at(-1)?.value.pose.position.x ?? 0) > 0.1);
    assert.equal(poses[0].value.frame_id, 'world');
    // The test uses the time stamps, because a busy machine delays messages and may drop some of them.
    const gaps = poses.slice(1).map((each, i) => Number(each.timestamp - poses[i].timestamp));
    gaps.sort((a, b) => a - b);
    assert.ok(Math.abs(gaps[gaps.length >> 1] - 5e6) < 5e5, `median ${gaps[gaps.length >> 1]} ns`);
    const steps = estimates.map((each) => each.value.step);
    steps.slice(1).forEach((step, i) => assert.ok(step > steps[i]));
    // The pose of a step must equal the estimate of the same step.
    const match = estimates.find((each) => each.timestamp === poses.at(-10).timestamp);
    assert.equal(match.value.odometry.x_m, poses.at(-10).value.pose.position.x);
  });

  await viewed('it sets a parameter within its limits', async (viewer) => {
    const name = 'control.cross_track_gain_1ps';
    const list = viewer.subscribe('/parameter');
    const listed = await viewer.until(() => list.at(-1)?.value.parameters.find((p) => p.name === name));
    assert.deepEqual([listed.unit, listed.min, listed.max, listed.live], ['1/s', 0, 50, true]);
    const value = async (id) => {
      const answer = await viewer.until(() => viewer.parameters.find((each) => each.id === id));
      return answer.parameters[0].value;
    };
    viewer.client.setParameters([{ name, value: 4.5 }], 'good');
    assert.equal(await value('good'), 4.5);
    await viewer.until(() => list.at(-1).value.parameters.find((p) => p.name === name).value === 4.5);
    viewer.client.setParameters([{ name, value: 50.5 }], 'large');
    assert.equal(await value('large'), 4.5);
    assert.match(viewer.status.at(-1).message, /0 to 50 1\/s/);
  });

  await viewed('it calls stop, which the robot acknowledges, and then start', async (viewer) => {
    const states = viewer.subscribe('/state');
    const commands = viewer.subscribe('/command');
    await viewer.untilDriven(states, () => (commands.at(-1)?.value.speed_mps ?? 0) > 0.05);
    states.length = 0;
    const answer = await viewer.call('stop');
    assert.equal(answer.acknowledged, true);
    assert.ok(answer.acknowledged_ms > 0);
    const state = await viewer.until(() => states.find((each) => each.value.run === 'aborted'));
    assert.deepEqual(state.value.faults.map((fault) => fault.name), ['stop_requested']);
    const last = (await viewer.until(() => states.find((each) => each.value.stop.status === 'acknowledged'))).value;
    assert.equal(last.stop.acknowledged_ms, answer.acknowledged_ms);
    assert.equal(last.stop.latched, true);
    // Only a start ends the latched stop.
    await viewer.until(() => states.at(-1).value.can.start);
    assert.deepEqual(await viewer.call('start', consent(states.at(-1))), { accepted: true });
    await viewer.until(() => states.at(-1).value.run === 'running');
    assert.equal(states.at(-1).value.stop.latched, false);
  });
}));
