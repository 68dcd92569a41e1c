// ros2_bench.mjs SECONDS ROUNDS TRIALS [LOSS]: delay of ROS 2 topics, their cost to the loop, and the times until the
// robot is commanded to stop and stands after each kind of loss of the driver (or only LOSS), as JSON rows; 0 leaves a
// part out. Run it in_network.
import { execFileSync } from 'node:child_process';
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { readMcap } from './mcap_file.mjs';
import { lineCourse, program, withRobot } from './programs.mjs';
import { decode, nanoseconds } from './ros2.mjs';
import { loseDriver, losses, movedAfter } from './ros2_driver.mjs';
import { Peer, latched, percentile, ros2On, topics, withSecondHost } from './ros2_network.mjs';

const [seconds, rounds, trials] = process.argv.slice(2, 5).map(Number);
const ways = process.argv[5] ? [process.argv[5]] : Object.keys(losses);
if (ways.some((way) => !(way in losses))) throw new Error(`no way to lose a driver: ${ways}; there is: ${Object.keys(losses).join(', ')}`);
const print = (row) => console.log(JSON.stringify(row));

function printTimes(what, values, unit, counts = {}) {
  print({ what, unit, count: values.length, p50: percentile(values, 0.5), p99: percentile(values, 0.99), max: percentile(values, 1), ...counts });
}

/** Measures every topic while the robot drives: lost messages, and the age of those that arrive. */
const measureTopics = (pacing) => withRobot(async ({ folder, daemon }) => {
  const peer = await Peer.ofEverything('42quiet');
  const course = await lineCourse(folder, 0.05 * (seconds + 5), 0.05);
  const run = await daemon(ros2On, ['--course', course, '--record', join(folder, 'runs'), '--duration', String(seconds + 5)],
    `pacing = "${pacing}"`);
  await run.exit;
  await peer.end();
  const [name] = await readdir(join(folder, 'runs'));
  execFileSync(program('tp100d'), ['export', join(folder, 'runs', name), '--ros2', join(folder, 'bag')], { stdio: 'ignore' });
  const { topics: bag } = await readMcap(join(folder, 'bag', 'bag_0.mcap'));
  const key = (bytes) => Buffer.from(bytes).subarray(0, 64).toString('hex');
  for (const topic of topics.keys()) {
    if (latched.includes(topic)) continue;
    // A message's time in the bag is that of its step.
    const sent = bag.get(topic), at = new Map(sent.map(({ data, logTime }, i) => [key(data), { logTime, i }]));
    const received = peer.found.filter(({ message }) => message === `rt${topic}`);
    if (received.length === 0) continue;
    const steps = received.map(({ cdr }) => at.get(key(Buffer.from(cdr, 'hex'))));
    const arrived = received.map(({ received_ns }) => BigInt(received_ns));
    // Messages before the discovery of the subscriber are not counted as lost.
    const lost = sent.length - steps[0].i - received.length;
    printTimes(`pacing ${pacing}: ${topic}, step to received`, steps.map(({ logTime }, i) => Number(arrived[i] - logTime) / 1e6), 'ms', { lost });
    if (topic !== '/odom') continue;
    const measured = received.map(({ cdr }) => nanoseconds(decode('nav_msgs/msg/Odometry', Buffer.from(cdr, 'hex')).header.stamp));
    printTimes(`pacing ${pacing}: /odom, measured to step (no DDS in it)`, steps.map(({ logTime }, i) => Number(logTime - measured[i]) / 1e6), 'ms');
    printTimes(`pacing ${pacing}: /odom, measured to received`, measured.map((stamp, i) => Number(arrived[i] - stamp) / 1e6), 'ms', { lost });
    printTimes(`pacing ${pacing}: /odom, sent to received`, received.map(({ sent_ns }, i) => Number(arrived[i] - BigInt(sent_ns)) / 1e6), 'ms');
  }
});

const median = (values) => percentile(values, 0.5);

/** The loop's lateness in one short run. */
async function latenessOf({ ros2, subscriber }) {
  let out;
  await withRobot(async ({ folder, daemon }) => {
    const peer = subscriber ? await Peer.ofEverything('42quiet') : undefined;
    const stats = join(folder, 'stats.json');
    const run = await daemon(ros2 ? ros2On : '', ['--duration', '7', '--stats', stats], '');
    await run.exit;
    await peer?.end();
    out = JSON.parse(await readFile(stats, 'utf8')).loop.lateness_us;
  });
  return out;
}

/** The ratio of two medians over the same rounds, and its 95 % interval (bootstrap over rounds). */
function ratioOf(values, without) {
  const ratio = (rounds) => median(rounds.map((i) => values[i])) / median(rounds.map((i) => without[i]));
  const drawn = Array.from({ length: 4000 }, () => ratio(values.map(() => Math.floor(Math.random() * values.length))));
  return { p50: ratio([...values.keys()]), low: percentile(drawn, 0.025), high: percentile(drawn, 0.975) };
}

/** The loop's lateness with and without ROS 2 in alternating runs. Two runs without ROS 2 show the noise of the machine: a
    ratio within their interval is not an effect of ROS 2. There are many short runs, and each round begins with another
    one, so that a disturbance of the machine affects few. */
async function measureLoop() {
  const candidates = [{ name: 'without ROS 2' }, { name: 'without ROS 2, once more' }, { name: 'with ROS 2, nobody listens', ros2: true },
    { name: 'with ROS 2 and a subscriber of every topic', ros2: true, subscriber: true }];
  const found = candidates.map(() => []);
  for (let round = 0; round < rounds; ++round)
    for (const i of candidates.keys()) {
      const at = (round + i) % candidates.length;
      found[at].push(await latenessOf(candidates[at]));
    }
  const p99 = (i) => found[i].map((run) => run.p99);
  for (const [i, { name }] of candidates.entries()) {
    const of = (key) => median(found[i].map((run) => run[key]));
    print({ what: `lateness, ${name} (medians of the rounds)`, unit: 'us', count: rounds, p50: of('p50'), p99: of('p99'), max: of('max') });
    if (i > 0) print({ what: '  p99 in relation to that without ROS 2', count: rounds, ...ratioOf(p99(i), p99(0)) });
  }
}

/** Measures each kind of loss of a driver on another machine. */
const measureLosses = () => withSecondHost((under) => withRobot(async ({ folder, daemon }) => {
  for (const loss of ways) {
    const record = join(folder, loss);
    const run = await daemon(`${ros2On}\ninterface = "eth0"\n[server]\ncommands = "all"`, ['--wait', '--record', record], '');
    const times = await loseDriver(run, loss, trials, { under });
    run.child.kill('SIGTERM');
    await run.exit;
    const after = (await movedAfter(record, times)).filter(({ told, moved }) => told !== undefined && moved !== undefined);
    for (const what of ['told', 'moved'])
      printTimes(`${loss}: ${what === 'told' ? 'told to move' : 'moved, by the encoders,'} after the last message`,
        after.map((each) => each[what]), 'ms', { lost: trials - after.length });
  }
}));

if (seconds > 0) for (const pacing of ['host', 'robot']) await measureTopics(pacing);
if (rounds > 0) await measureLoop();
if (trials > 0) await measureLosses();
