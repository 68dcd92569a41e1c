// ros2_bench.mjs SECONDS ROUNDS TRIALS [LOSS]: how soon ROS 2's topics arrive, what they cost, and how soon the robot is
// told to stop when its driver is lost, in each way or in that one, as JSON rows; 0 leaves a part out. Run it in_network.
import { execFileSync } from 'node:child_process';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { readMcap } from './mcap_file.mjs';
import { decode, nanoseconds } from './ros2.mjs';
import { loseDriver, losses, movedAfter } from './ros2_driver.mjs';
import { Peer, latched, percentile, program, topics, withRobot, withSecondHost } from './ros2_network.mjs';

const [seconds, rounds, trials] = process.argv.slice(2, 5).map(Number);
const ways = process.argv[5] ? [process.argv[5]] : Object.keys(losses);
if (ways.some((way) => !(way in losses))) throw new Error(`no way to lose a driver: ${ways}; there is: ${Object.keys(losses).join(', ')}`);
const print = (row) => console.log(JSON.stringify(row));
const on = '[ros2]\nenabled = true';

function printTimes(what, values, unit, counts = {}) {
  print({ what, unit, count: values.length, p50: percentile(values, 0.5), p99: percentile(values, 0.99), max: percentile(values, 1), ...counts });
}

/** A course that takes at least `duration` seconds. */
async function slowCourse(folder, duration) {
  const file = join(folder, 'slow.toml'), length = 0.05 * duration;
  await writeFile(file, `description = "slow"\nspeed_mps = 0.05\n[[segment]]\ntype = "line"\nlength_m = ${length}\n`
    + `[fence]\nmin_x_m = -1.0\nmax_x_m = ${length + 1}\nmin_y_m = -1.0\nmax_y_m = 1.0\n`);
  return file;
}

/** Every topic while the robot drives: what is lost, and the age of what arrives. */
const measureTopics = (pacing) => withRobot(async ({ folder, daemon }) => {
  const peer = await Peer.ofEverything('42quiet');
  const course = await slowCourse(folder, seconds + 5);
  const run = await daemon(on, ['--course', course, '--record', join(folder, 'runs'), '--duration', String(seconds + 5)],
    `pacing = "${pacing}"`);
  await run.exit;
  await peer.end();
  const [name] = await readdir(join(folder, 'runs'));
  execFileSync(program('tp100d'), ['export', join(folder, 'runs', name), '--ros2', join(folder, 'bag')], { stdio: 'ignore' });
  const { topics: bag } = await readMcap(join(folder, 'bag', 'bag_0.mcap'));
  const key = (bytes) => Buffer.from(bytes).subarray(0, 64).toString('hex');
  for (const topic of topics.keys()) {
    if (latched.includes(topic)) continue;
    // Its time in the bag is the step's.
    const sent = bag.get(topic), at = new Map(sent.map(({ data, logTime }, i) => [key(data), { logTime, i }]));
    const received = peer.found.filter(({ message }) => message === `rt${topic}`);
    if (received.length === 0) continue;
    const steps = received.map(({ cdr }) => at.get(key(Buffer.from(cdr, 'hex'))));
    const arrived = received.map(({ received_ns }) => BigInt(received_ns));
    // Before both ends have met nothing is sent.
    const lost = sent.length - steps[0].i - received.length;
    printTimes(`pacing ${pacing}: ${topic}, step to received`, steps.map(({ logTime }, i) => Number(arrived[i] - logTime) / 1e6), 'ms', { lost });
    if (topic !== '/odom') continue;
    const measured = received.map(({ cdr }) => nanoseconds(decode('nav_msgs/msg/Odometry', Buffer.from(cdr, 'hex')).header.stamp));
    printTimes(`pacing ${pacing}: /odom, measured to step (no DDS in it)`, steps.map(({ logTime }, i) => Number(logTime - measured[i]) / 1e6), 'ms');
    printTimes(`pacing ${pacing}: /odom, measured to received`, measured.map((stamp, i) => Number(arrived[i] - stamp) / 1e6), 'ms', { lost });
    printTimes(`pacing ${pacing}: /odom, sent to received`, received.map(({ sent_ns }, i) => Number(arrived[i] - BigInt(sent_ns)) / 1e6), 'ms');
  }
});

/** The loop's lateness and the daemon's processor time, with and without ROS 2, in turns. How far apart two runs without it
    are shows what the machine does by itself. Runs are short and many, so that a bad moment of the machine spoils few. */
async function measureLoop() {
  const names = ['without ROS 2', 'without ROS 2, once more', 'with ROS 2, nobody listens', 'with ROS 2 and a subscriber of every topic'];
  const late = names.map(() => []), cores = names.map(() => []);
  for (let round = 0; round < rounds; ++round) {
    for (const i of names.keys()) {
      await withRobot(async ({ folder, daemon }) => {
        const peer = i === 3 ? await Peer.ofEverything('42quiet') : undefined;
        const stats = join(folder, 'stats.json'), duration = 8;
        const run = await daemon(i < 2 ? '' : on, ['--duration', String(duration), '--stats', stats], '');
        await run.said(/state: syncing -> ready/);
        const ticks = async () => {
          const fields = (await readFile(`/proc/${run.child.pid}/stat`, 'utf8')).split(') ').at(-1).split(' ');
          return Number(fields[11]) + Number(fields[12]);
        };
        const before = await ticks(), began = Date.now();
        await new Promise((resolve) => { setTimeout(resolve, (duration - 3) * 1000); });
        cores[i].push((await ticks() - before) / 100 / ((Date.now() - began) / 1000));
        await run.exit;
        await peer?.end();
        late[i].push(JSON.parse(await readFile(stats, 'utf8')).loop.lateness_us);
      });
    }
  }
  for (const [i, name] of names.entries()) {
    const median = (values) => percentile(values, 0.5);
    print({ what: `lateness of the loop, ${name} (medians)`, unit: 'us', count: rounds, p50: median(late[i].map(({ p50 }) => p50)),
      p99: median(late[i].map(({ p99 }) => p99)), max: median(late[i].map(({ max }) => max)) });
    if (i > 0)
      printTimes(`p99 of the lateness, of that without, ${name}`, late[i].map(({ p99 }, round) => p99 / late[0][round].p99), '');
    printTimes(`processors of tp100d, ${name}`, cores[i], 'cores');
  }
}

/** Each way to lose a driver of another machine. */
const measureLosses = () => withSecondHost((under) => withRobot(async ({ folder, daemon }) => {
  for (const loss of ways) {
    const record = join(folder, loss);
    const run = await daemon(`${on}\ninterface = "eth0"\n[server]\ncommands = "all"`, ['--wait', '--record', record], '');
    const times = await loseDriver(run, loss, trials, { under });
    run.child.kill('SIGTERM');
    await run.exit;
    const moved = (await movedAfter(record, times)).filter((ms) => ms !== undefined);
    printTimes(`${loss}: told to move after the last message`, moved, 'ms', { lost: trials - moved.length });
  }
}));

if (seconds > 0) for (const pacing of ['host', 'robot']) await measureTopics(pacing);
if (rounds > 0) await measureLoop();
if (trials > 0) await measureLosses();
