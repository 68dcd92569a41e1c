// A stand-in for tp100d to work on the page without a build: the protocol and channels of
// daemon/messages/CHANNELS.md, a synthetic drive of course 3. `node dev/mock_server.mjs [PORT]`.
// SIGUSR1: the robot goes away or comes back. WATCH=1: it stops when nobody watches. DELAY_MS=1200: answers come late.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join } from 'node:path';
import { WebSocketServer } from 'ws';

const dist = new URL('../dist/', import.meta.url).pathname;
const port = Number(process.argv[2] ?? 8765);
const times = (count, p50) => ({ count, mean: 1.1 * p50, p50, p99: 3 * p50, p999: 5 * p50, max: 40 * p50 });
const kRate = 200;
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.woff2': 'font/woff2', '.txt': 'text/plain' };

const path = [];
{
  const add = (x, y, yaw, s) => path.push({ x_m: x, y_m: y, yaw_rad: yaw, s_m: s });
  for (let i = 0; i <= 70; i++) add(i * 0.02, 0, 0, i * 0.02);
  for (let i = 1; i <= 63; i++) {
    const a = (Math.PI * i) / 63;
    add(1.4 + 0.4 * Math.sin(a), -0.4 + 0.4 * Math.cos(a), -a, 1.4 + 0.4 * a);
  }
  for (let i = 1; i <= 70; i++) add(1.4 - i * 0.02, -0.8, -Math.PI, 1.4 + 0.4 * Math.PI + i * 0.02);
}
const length = path.at(-1).s_m;
const course = {
  name: '3', description: 'U turn, step and ramp', speed_mps: 0.1, length_m: length,
  start: { x_m: 0, y_m: 0, yaw_rad: 0 }, path, segments: [],
  ramps: [{ x_m: 0.7, y_m: -0.8, heading_rad: Math.PI, height_m: 0.08, up_rad: 0.4887, top_m: 0.2, down_rad: 0.4887, width_m: 0.4 }],
  blocks: [{ x_m: 1.2, y_m: -0.8, heading_rad: Math.PI, height_m: 0.037, depth_m: 0.1, width_m: 0.4 }],
  surfaces: [], disturbances: [], fence: { min_x_m: -0.05, max_x_m: 1.85, min_y_m: -0.9, max_y_m: 0.1 },
  robot: { name: 'end-loaded', length_m: 0.185, width_m: 0.2, height_m: 0.06, gauge_m: 0.155, axle_spacing_m: 0.133, wheel_radius_m: 0.026, shoe_width_m: 0.045 },
};

const at = (s) => {
  const i = Math.max(1, path.findIndex((p) => p.s_m >= s));
  const [a, b] = [path[i - 1], path[i === 0 ? path.length - 1 : i] ?? path.at(-1)];
  const u = Math.min(1, Math.max(0, (s - a.s_m) / (b.s_m - a.s_m || 1)));
  return { x: a.x_m + u * (b.x_m - a.x_m), y: a.y_m + u * (b.y_m - a.y_m), yaw: a.yaw_rad + u * (b.yaw_rad - a.yaw_rad) };
};
const ground = (x, y) => {
  if (Math.abs(y + 0.8) > 0.2) return 0;
  const half = 0.1 + 0.08 / Math.tan(0.4887);
  const ramp = Math.min((half - Math.abs(x - 0.7)) * Math.tan(0.4887), 0.08);
  return Math.max(0, ramp, Math.abs(x - 1.2) < 0.05 ? 0.037 : 0);
};

const began = performance.now();
const unix0 = BigInt(Date.now()) * 1000000n;
const t = () => (performance.now() - began) / 1000;
let run = 'idle', runBegan = 0, runEnded = 0, s = 0, robot = true, recording = null, faults = [], step = 0, lastSample = 0;
let driver = '', pauseEnds = null, watched = 0;
const kPause_s = 120;
let stop = { count: 0, latched: false, by: '', requested_t_s: null, status: 'none', acknowledged_ms: null };
const lateness = new Array(14).fill(0);
const parameters = [
  ['control.cross_track_gain_1ps', 3.6, '1/s', 0, 50, 'Stanley: the approach angle is the arc tangent of this times the cross-track error divided by the speed.'],
  ['control.preview_s', 0.06, 's', 0, 1, 'Lag of loop and motors, by which the controller looks ahead on the path.'],
  ['control.max_approach_deg', 24, 'deg', 1, 80, 'Steepest approach to the path.'],
].map(([name, value, unit, min, max, meaning]) => ({ name, value, default: value, type: 'number', unit, min, max, choices: [], meaning, live: true, when: 'always' }));
parameters.push({ name: 'estimation.steering', value: 'odometry', default: 'odometry', type: 'choice', choices: ['model', 'odometry', 'fused'], unit: '', min: null, max: null, meaning: 'Pose that the controller uses.', live: true, when: 'not running' });
parameters.push({ name: 'link.baud', value: 500000, default: 500000, type: 'integer', unit: 'baud', min: 9600, max: 2000000, choices: [], meaning: 'Speed of the port.', live: false, when: 'always' });

const topics = ['/estimate', '/slip', '/link', '/loop', '/state', '/course', '/event', '/parameter', '/recording', '/client', '/path_history'];
const kept = new Map();
const events = [];
const clients = new Set();

function publish(topic, message) {
  const json = JSON.stringify(message);
  if (topic === '/event') events.push(json);
  else if (topic !== '/estimate') kept.set(topic, json);
  for (const client of clients) client.say(topic, json);
}
function event(kind, level, text, cause = '', fix = '') {
  publish('/event', { t_s: t(), kind, level, text, cause, fix });
}
function to(next) {
  if (next === run) return;
  event('run', next === 'aborted' ? 'error' : 'info', `state: ${run} -> ${next}`);
  run = next;
  if (run !== 'driving') driver = '';
  if (run !== 'running') pauseEnds = null;
  state();
}
const underWay = () => run === 'running' || run === 'driving';
function state() {
  const why = stop.latched ? '' : !robot ? 'no robot yet' : '';
  publish('/state', {
    t_s: t(), run, session: robot ? 'ready' : 'listening', robot_state: robot ? (run === 'running' ? 'running' : 'disarmed') : null, motors_on: robot && run === 'running',
    run_s: run === 'idle' ? null : (run === 'running' ? t() : runEnded) - runBegan, progress_m: s, length_m: length, course: '3',
    robot: 'end-loaded', setup: 'flat', steering: 'odometry', world: 'internal', battery_v: 7.92,
    ...(pauseEnds === null ? {} : { pause_left_s: pauseEnds - t() }), watch: Boolean(process.env.WATCH),
    can: { start: robot && !underWay(), drive: robot && !underWay(), pause: run === 'arming' || run === 'running', resume: pauseEnds !== null, hold: underWay(), stop: true, record: recording === null }, why_not_start: why, why_not_drive: driver === '' ? why : `${driver} drives`, confirm_start: true,
    ...(driver === '' ? {} : { driver: { by: driver, fresh: true } }),
    faults: faults.map((name) => ({ name, cause: name === 'link_lost' ? 'the link broke, or no sample arrived for 200 ms' : 'STOP was pressed', fix: 'check the cable; the daemon reconnects by itself, then start again', from: 'robot' })),
    stop,
  });
}

function pressStop(by) {
  const at_s = t();
  stop = { count: stop.count + 1, latched: true, by, requested_t_s: at_s, status: 'pending', acknowledged_ms: null };
  event('stop', 'warning', `STOP by ${by}`);
  if (underWay() || run === 'arming') { runEnded = t(); to('aborted'); }
  state();
  return new Promise((resolve) => {
    const acknowledge = () => {
      stop = { ...stop, status: 'acknowledged', acknowledged_ms: Math.round((t() - at_s) * 1e4) / 10 };
      faults = ['stop_requested'];
      event('acknowledge', 'info', `the robot stopped in ${stop.acknowledged_ms} ms`);
      state();
    };
    if (robot) setTimeout(() => { acknowledge(); resolve({ acknowledged: true, acknowledged_ms: stop.acknowledged_ms }); }, 13);
    else setTimeout(() => {
      stop = { ...stop, status: 'not_acknowledged' };
      state();
      resolve({ acknowledged: false, acknowledged_ms: null });
      const wait = setInterval(() => { if (robot) { clearInterval(wait); acknowledge(); } }, 20);
    }, 200);
  });
}

/** Refuses a motion to which the person consented before a STOP or too long ago. */
function consented({ stops, t_s }) {
  if (stops !== stop.count) throw new Error('STOP was pressed since; look, then ask again');
  if (!(t() - t_s <= 3)) throw new Error(`this request is ${(t() - t_s).toFixed(1)} s old; at most 3 s`);
}

const services = {
  start: (by, request) => {
    consented(request);
    if (!robot || underWay()) throw new Error('no robot yet');
    s = 0; faults = []; stop = { ...stop, latched: false, status: 'none' };
    runBegan = runEnded = t();
    to('arming');
    setTimeout(() => { runBegan = t(); to('running'); }, 120);
    return { accepted: true };
  },
  hold: () => { runEnded = t(); to('idle'); return { accepted: true }; },
  stop: (by) => pressStop(by),
  record_start: () => { recording = { began: t(), run: '20260102-030405-3' }; record(); state(); return { run: recording.run }; },
  record_stop: () => { const { run: name } = recording; recording = null; record(); state(); return { run: name, bytes: 123456 }; },
  pause: () => { if (run !== 'running') throw new Error('no run is under way'); pauseEnds ??= t() + kPause_s; state(); return { accepted: true }; },
  resume: (by, request) => {
    consented(request);
    if (pauseEnds === null) throw new Error('no run is paused');
    pauseEnds = null; state();
    return { accepted: true };
  },
  watch: () => { watched = t(); return {}; },
  // The mock robot is armed, but does not move.
  drive_take: (by, request) => {
    consented(request);
    if (driver !== '' && driver !== by) throw new Error(`${driver} drives`);
    driver = by; stop = { ...stop, latched: false, status: 'none' }; runBegan = t(); to('driving');
    return { token: 'mock' };
  },
  drive: () => { if (driver === '') throw new Error('this token does not hold the wheel; take it'); return { accepted: true }; },
  drive_release: () => { runEnded = t(); to('idle'); return { accepted: true }; },
};
function record() {
  publish('/recording', { available: true, active: recording !== null, run: recording?.run ?? '', file: '', elapsed_s: recording ? t() - recording.began : 0, bytes: 123456, dropped: 0, warning: '' });
}

function estimate(t_s, s, moving, tracks, target, age_us) {
  const ref = at(s);
  const wobble = 0.004 * Math.sin(3 * s) + 0.002 * Math.sin(17 * s);
  const x = ref.x - wobble * Math.sin(ref.yaw), y = ref.y + wobble * Math.cos(ref.yaw);
  const d = 0.06;
  const front = ground(x + d * Math.cos(ref.yaw), y + d * Math.sin(ref.yaw)), rear = ground(x - d * Math.cos(ref.yaw), y - d * Math.sin(ref.yaw));
  const pitch = -Math.atan2(front - rear, 2 * d), z = Math.max((front + rear) / 2, 0);
  const pose = (dx, dy, dyaw, sd_m) => ({ x_m: x + dx, y_m: y + dy, z_m: z, roll_rad: 0, pitch_rad: pitch, yaw_rad: ref.yaw + dyaw, vx_mps: moving ? 0.1 : 0, vy_mps: 0, yaw_rate_radps: 0, sd_x_m: sd_m, sd_y_m: sd_m, sd_yaw_rad: 5 * sd_m });
  const message = {
    t_s, step, age_us, steering: 'odometry',
    model: pose(0.006 * s, -0.012 * s * s * 0.4, 0.012 * s, 0.005 + 0.01 * s), odometry: pose(0, 0, 0.004 * Math.sin(5 * s), 0.005 + 0.004 * s),
    fused: { ...pose(0.0015 * Math.sin(9 * s), 0.001, 0.002, 0.002), camera_age_us: null, camera_used: 0, camera_rejected: 0, nis: 0, nis_mean: 3, recoveries: 0 },
    truth: process.env.TRUTH ? { ...pose(-0.002, 0.003 * s, -0.004, 0), age_us: 0 } : null,
    reference: { x_m: ref.x, y_m: ref.y, yaw_rad: ref.yaw }, imu: { roll_rad: 0, pitch_rad: 0, slope: 'flat' }, pitch_source: 'virtual',
    tracks: { left_mps: tracks[0], right_mps: tracks[1], left_commanded_mps: moving ? target[0] : null, right_commanded_mps: moving ? target[1] : null },
    cross_track_m: wobble, heading_error_rad: 0.03 * Math.cos(17 * s) * (moving ? 1 : 0), desired_yaw_rad: ref.yaw, desired_speed_mps: moving ? 0.1 : 0, progress_m: s,
  };
  return { message, pitch };
}

/** A drive of the course as an MCAP file without chunks. */
function recordedRun() {
  const text = (value) => { const b = Buffer.from(value); const n = Buffer.alloc(4); n.writeUInt32LE(b.length); return Buffer.concat([n, b]); };
  const record = (op, ...parts) => { const body = Buffer.concat(parts); const head = Buffer.alloc(9); head[0] = op; head.writeBigUInt64LE(BigInt(body.length), 1); return Buffer.concat([head, body]); };
  const u = (value, size) => { const b = Buffer.alloc(8); b.writeBigUInt64LE(BigInt(Math.round(value))); return b.subarray(0, size); };
  const out = [Buffer.from([0x89, 0x4d, 0x43, 0x41, 0x50, 0x30, 13, 10]), record(1, text(''), text('mock'))];
  topics.forEach((topic, i) => out.push(record(4, u(i, 2), u(0, 2), text(topic), text('json'), u(0, 4))));
  const say = (t_s, topic, message) => out.push(record(5, u(topics.indexOf(topic), 2), u(0, 4), u((1767323045 + t_s) * 1e9, 8), u(0, 8), Buffer.from(JSON.stringify(message))));
  say(-1, '/course', course);
  say(0, '/event', { t_s: 0, kind: 'run', level: 'info', text: 'state: arming -> running', cause: '', fix: '' });
  for (let i = 0; 0.002 * i < length; i++) {
    const { message, pitch } = estimate(0.02 * i, 0.002 * i, true, [0.118, 0.118], [0.118, 0.118], 3100);
    say(0.02 * i, '/estimate', message);
    if (i % 5 === 0) say(0.02 * i, '/slip', { left: 0.16 - 0.1 * pitch, right: 0.16 - 0.15 * pitch, fused_left: 0.16, fused_right: 0.16 });
  }
  return Buffer.concat(out);
}

let tracks = [0, 0];
function tick() {
  const now = t();
  if (pauseEnds !== null && now > pauseEnds) { runEnded = t(); to('idle'); }
  if (process.env.WATCH && underWay() && now - Math.max(watched, runBegan) > 2) void pressStop('nobody watches');
  for (; step / kRate < now; step++) {
    const moving = run === 'running' && robot && pauseEnds === null;
    if (robot) lastSample = now;
    if (moving) s = Math.min(s + 0.1 / kRate, length);
    if (run === 'running' && s >= length) { runEnded = t(); to('finished'); }
    const late = Math.exp(2.2 + 0.7 * (Math.random() + Math.random() + Math.random() - 1.5) * 2);
    const edges = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000];
    const bin = edges.findIndex((e) => late < e);
    lateness[bin < 0 ? 13 : bin]++;
    const turning = s > 1.4 && s < 2.65 && moving ? 0.25 : 0;
    const target = moving ? [0.118 + turning * 0.08, 0.118 - turning * 0.08] : [0, 0];
    tracks = tracks.map((v, i) => v + (target[i] - v) * 0.05 + (moving ? (Math.random() - 0.5) * 0.002 : 0));
    const { message, pitch } = estimate(step / kRate, s, moving, tracks, target, Math.round((now - lastSample) * 1e6) + 3100);
    publish('/estimate', message);
    if (step % 10 === 0) publish('/slip', { t_s: now, left: 0.16 + Math.abs(pitch) * 0.13, right: 0.16 + Math.abs(pitch) * 0.2, fused_left: 0.158 + 0.003 * Math.sin(now), fused_right: 0.17 + 0.003 * Math.cos(now), gyro_bias_radps: 0.01, fused_gyro_bias_radps: 0.01, slope_rad: -pitch });
    if (step % 40 === 0) {
      state();
      publish('/link', { t_s: now, session: robot ? 'ready' : 'listening', quality: robot ? 'good' : 'lost', port: '/tmp/tp100', kind: process.env.PHYSICAL ? 'physical' : 'emulated', firmware: '0.1.0', samples_hz: robot ? 200 : 0, lost_hz: 0, bad_hz: 0, in_bytes_ps: 9010, out_bytes_ps: 7610, round_trip_us: 620, clock: { valid: true, drift_ppm: 41.2, uncertainty_us: 310 }, sample_age_us: { count: 1, mean: 3100, p50: 3000, p99: 4100, p999: 5200, max: 9000 }, counters: { bytes_in: step * 45, bytes_out: step * 38, frames_in: step, samples: step, lost: 2, crc_errors: 0, reconnects: 0, reboots: 0 } });
    }
    if (step % 100 === 0) {
      publish('/loop', { t_s: now, rate_hz: kRate, pacing: 'host', cycles: step, overruns: 0, missed: 0, frame_timeouts: 0, lateness_us: times(step, 8), work_us: times(step, 21), compute_us: times(step, 9), write_us: times(step, 8), sample_wire_us: times(step, 4100), sample_wait_us: times(step, 1), sample_age_us: times(step, 4200), histogram: { edges_us: edges, lateness: [...lateness] }, privileges: { 'SCHED_FIFO 80': true, 'memory locked': true, 'cpu_dma_latency 0': false }, lost_records: 0 });
    }
    if (step % 200 === 0) {
      publish('/client', { clients: [...clients].map((c) => ({ id: c.id, address: '127.0.0.1', agent: '', subscriptions: c.subscriptions.size, sent: c.sent, dropped: 0, queued: 0, connected_s: 1 })), dropped_total: 0, refused_total: 0, closed_total: 0, queue_limit: 512 });
      if (recording) record();
    }
  }
}

let nextClient = 1;
const http = createServer(async (request, response) => {
  const name = new URL(request.url, 'http://x').pathname.slice(1) || 'index.html';
  if (request.url === '/api/runs') {
    const file = (kind, n, size) => ({ name: n, bytes: size, url: `/runs/20260102-030405-3/${n}`, kind });
    response.setHeader('Content-Type', 'application/json');
    response.end(JSON.stringify({ directory: 'runs', bytes: 12_345_678, free_bytes: 20e9, quota_bytes: 1e9, making: '', runs: [{ name: '', note: '', tags: '', keep: false, note_error: '', run: '20260102-030405-3', modified_unix_s: 1767323045, bytes: 12_345_678, active: false, files: [file('recording', 'run.mcap', 12_000_000), file('report', 'report.html', 640_000), file('metrics', 'metrics.json', 2100)] }] }));
    return;
  }
  if (request.url.endsWith('run.mcap')) {
    response.end(recordedRun());
    return;
  }
  try {
    if (name.includes('/')) throw new Error('not found');
    response.setHeader('Content-Type', kTypes[extname(name)] ?? 'application/octet-stream');
    response.end(await readFile(join(dist, name)));
  } catch {
    response.statusCode = 404;
    response.end('not found');
  }
});
new WebSocketServer({ server: http, handleProtocols: (offers) => [...offers].find((o) => o.startsWith('foxglove.')) ?? false }).on('connection', (socket) => {
  const client = { id: nextClient++, sent: 0, subscriptions: new Map(), send(id, json) {
    const head = Buffer.alloc(13);
    head.writeUInt8(1, 0); head.writeUInt32LE(id, 1); head.writeBigUInt64LE(unix0 + BigInt(Math.round(t() * 1e9)), 5);
    socket.send(Buffer.concat([head, Buffer.from(json)])); client.sent++;
  }, say(topic, json) { const id = client.subscriptions.get(topic); if (id !== undefined) client.send(id, json); } };
  clients.add(client);
  socket.on('close', () => clients.delete(client));
  socket.send(JSON.stringify({ op: 'serverInfo', name: 'tp100d', capabilities: ['parameters', 'parametersSubscribe', 'services'], supportedEncodings: ['json'], sessionId: String(unix0), metadata: { version: '0.1.0', course: '3', robot: 'end-loaded', setup: 'flat', commands: 'yes' } }));
  socket.send(JSON.stringify({ op: 'advertise', channels: topics.map((topic, id) => ({ id: id + 1, topic, encoding: 'json', schemaName: 'x', schema: '{}' })) }));
  socket.send(JSON.stringify({ op: 'advertiseServices', services: Object.keys(services).map((name, i) => ({ id: i + 1, name, type: name })) }));
  socket.on('message', async (data, binary) => {
    if (!binary) {
      const message = JSON.parse(data.toString());
      if (message.op === 'subscribe') for (const { id, channelId } of message.subscriptions) {
        const topic = topics[channelId - 1];
        client.subscriptions.set(topic, id);
        if (topic === '/event') for (const json of events.slice(-100)) client.send(id, json);
        else if (kept.has(topic)) client.send(id, kept.get(topic));
      }
      if (message.op === 'unsubscribe') for (const [topic, id] of client.subscriptions) if (message.subscriptionIds.includes(id)) client.subscriptions.delete(topic);
      if (message.op === 'setParameters') {
        for (const { name, value } of message.parameters) { const p = parameters.find((one) => one.name === name); if (p?.live) p.value = value; }
        publish('/parameter', { parameters });
      }
      return;
    }
    const service = data.readUInt32LE(1), call = data.readUInt32LE(5);
    try {
      const request = JSON.parse(data.subarray(13 + data.readUInt32LE(9)).toString() || '{}');
      await new Promise((resolve) => setTimeout(resolve, Number(process.env.DELAY_MS ?? 0)));
      const result = await Object.values(services)[service - 1](`viewer ${client.id}`, request);
      const head = Buffer.alloc(13 + 4);
      head.writeUInt8(3, 0); head.writeUInt32LE(service, 1); head.writeUInt32LE(call, 5); head.writeUInt32LE(4, 9); head.write('json', 13);
      socket.send(Buffer.concat([head, Buffer.from(JSON.stringify(result))]));
    } catch (error) {
      socket.send(JSON.stringify({ op: 'serviceCallFailure', serviceId: service, callId: call, message: error.message }));
    }
  });
});
process.on('SIGUSR1', () => { robot = !robot; event('session', robot ? 'info' : 'error', robot ? 'state: listening -> ready' : 'state: ready -> listening'); if (!robot) { faults = ['link_lost']; if (run === 'running') { runEnded = t(); to('aborted'); } } else faults = faults.filter((f) => f !== 'link_lost'); state(); });

publish('/course', course);
publish('/parameter', { parameters });
publish('/path_history', { deletions: [], entities: [] });
record();
event('daemon', 'info', 'tp100d mock, course 3, robot end-loaded');
event('session', 'info', 'state: syncing -> ready');
setInterval(tick, 5);
http.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${http.address().port}/`));
