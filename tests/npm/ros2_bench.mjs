// ros2_bench.mjs SECONDS ROUNDS TRIALS [LOSS]: delay of ROS 2 topics, their cost to the loop, and the times until the
// robot is commanded to stop and stands after each kind of loss of the driver (or only LOSS), as JSON rows; 0 leaves a
// part out. Run it in_network.
import { execFileSync } from 'node:child_process';
import { readFile, readdir } from 'node:fs/promises';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { readMcap } from './mcap_file.mjs';
import { lineCourse, pause, program, withRobot } from './programs.mjs';
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
  const peer = await Peer.ofEverything('42timed');
  const course = await lineCourse(folder, 0.05 * (seconds + 5), 0.05);
  const run = await daemon(ros2On, ['--course', course, '--record', join(folder, 'runs'), '--duration', String(seconds + 5)],
    `pacing = "${pacing}"`);
  await run.exit;
  await peer.end();
  const [name] = await readdir(join(folder, 'runs'));
  execFileSync(program('tp100d'), ['export', join(folder, 'runs', name), '--ros2', join(folder, 'bag')], { stdio: 'ignore' });
  const { topics: bag } = await readMcap(join(folder, 'bag', 'bag_0.mcap'));
  const { woken_late_ns: late } = peer.found.find((each) => each.woken_late_ns);
  printTimes(`pacing ${pacing}: a thread that only sleeps wakes late by (no DDS in it)`, late.map((ns) => ns / 1e6), 'ms');
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

/** A daemon's threads: name, whether it is the loop, last processor, how often and how long it ran and waited for a
    processor [s]. */
async function threadsOf(pid) {
  const out = [];
  for (const thread of await readdir(`/proc/${pid}/task`)) {
    const read = async (name) => (await readFile(`/proc/${pid}/task/${thread}/${name}`, 'utf8')).trim();
    const [name, stat, sched] = await Promise.all(['comm', 'stat', 'schedstat'].map(read)).catch(() => []);
    if (sched === undefined) continue; // it has just ended
    // Fields 39 and 41 of proc(5), counted from the name's end: processor and policy, of which 1 is SCHED_FIFO.
    const fields = stat.split(') ').at(-1).split(' ');
    const [ran, waited, times] = sched.split(' ').map(Number);
    out.push({ thread, name, loop: fields[38] === '1', cpu: fields[36], ran_s: ran / 1e9, waited_s: waited / 1e9, times });
  }
  return out;
}
const speaksDds = ({ name }) => /^(ros2|gc|tev|(dq|recv|xmit).*)$/.test(name);
const total = (threads, key) => threads.reduce((sum, thread) => sum + thread[key], 0);

/** Processor time that the host of a virtual machine gave to others [s]. */
const stolen_s = async () => Number((await readFile('/proc/stat', 'utf8')).split('\n')[0].split(/\s+/)[8]) / 100;

/** One short run: figures of the loop's lateness, and its threads' processor times. */
async function loopRun({ ros2, subscriber, dds_cpu }) {
  let out;
  await withRobot(async ({ folder, daemon }) => {
    const peer = subscriber ? await Peer.ofEverything('42quiet') : undefined;
    const stats = join(folder, 'stats.json'), duration = 7;
    const run = await daemon(ros2 ? ros2On : '', ['--duration', String(duration), '--stats', stats], dds_cpu === undefined ? '' : 'cpu = 0');
    await run.said(/state: syncing -> ready/);
    const before = await threadsOf(run.child.pid), stolenBefore = await stolen_s(), began = Date.now();
    if (dds_cpu !== undefined)
      for (const { thread } of before.filter(speaksDds)) execFileSync('taskset', ['-pc', dds_cpu, thread]);
    const together = [];
    let after = before;
    while (Date.now() - began < (duration - 3) * 1000) {
      await pause(100);
      after = await threadsOf(run.child.pid);
      together.push(after.find(({ loop }) => loop)?.cpu === after.find(({ name }) => name === 'ros2')?.cpu);
    }
    const took_s = (Date.now() - began) / 1000, stolen = (await stolen_s() - stolenBefore) / took_s;
    const spent = (of, key) => total(after.filter(of), key) - total(before.filter(of), key);
    const isLoop = ({ loop }) => loop;
    await run.exit;
    await peer?.end();
    out = { ...JSON.parse(await readFile(stats, 'utf8')).loop.lateness_us, cores: spent(() => true, 'ran_s') / took_s, stolen,
      loop_cores: spent(isLoop, 'ran_s') / took_s, dds_cores: spent(speaksDds, 'ran_s') / took_s,
      waited_us: 1e6 * spent(isLoop, 'waited_s') / spent(isLoop, 'times'), together: together.filter(Boolean).length / together.length };
  });
  return out;
}

/** The ratio of two medians over the same rounds, and its 95 % interval (bootstrap over rounds). */
function ratioOf(values, without) {
  const ratio = (rounds) => median(rounds.map((i) => values[i])) / median(rounds.map((i) => without[i]));
  const drawn = Array.from({ length: 4000 }, () => ratio(values.map(() => Math.floor(Math.random() * values.length))));
  return { p50: ratio([...values.keys()]), low: percentile(drawn, 0.025), high: percentile(drawn, 0.975) };
}

/** The loop's lateness with and without ROS 2 in alternating runs, and its sources. Two runs without ROS 2 show the
    noise of the machine: a ratio within their interval is not an effect of ROS 2. There are many short runs, and each
    round begins with another one, so that a disturbance of the machine affects few. */
async function measureLoop() {
  const candidates = [{ name: 'without ROS 2' }, { name: 'without ROS 2, once more' }, { name: 'with ROS 2, nobody listens', ros2: true },
    { name: 'with ROS 2 and a subscriber of every topic', ros2: true, subscriber: true }];
  if (cpus().length > 1) {
    const pinned = { ros2: true, subscriber: true };
    candidates.push({ name: 'the same, loop and ROS 2 on processor 0', ...pinned, dds_cpu: '0' },
      { name: 'the same, loop on processor 0, ROS 2 on 1', ...pinned, dds_cpu: '1' });
  }
  const found = candidates.map(() => []);
  for (let round = 0; round < rounds; ++round)
    for (const i of candidates.keys()) {
      const at = (round + i) % candidates.length;
      found[at].push(await loopRun(candidates[at]));
    }
  const p99 = (i) => found[i].map((run) => run.p99);
  for (const [i, { name, ros2 }] of candidates.entries()) {
    const of = (key) => found[i].map((run) => run[key]);
    print({ what: `lateness, ${name} (medians of the rounds)`, unit: 'us', count: rounds,
      p50: median(of('p50')), p99: median(of('p99')), max: median(of('max')) });
    if (i > 0) print({ what: '  p99 in relation to that without ROS 2', count: rounds, ...ratioOf(p99(i), p99(0)) });
    printTimes('  loop: woken, but waiting for its processor, mean of a wake-up', of('waited_us'), 'us');
    printTimes('  processors of tp100d', of('cores'), 'cores');
    printTimes('  of these, the loop', of('loop_cores'), 'cores');
    if (ros2) printTimes('  of these, ROS 2 (ros2 and the threads of Cyclone DDS)', of('dds_cores'), 'cores');
    if (ros2) printTimes('  share of looks at which ros2 was last on the loop\'s processor', of('together'), '');
    printTimes('  processors that the host of this machine took', of('stolen'), 'cores');
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
