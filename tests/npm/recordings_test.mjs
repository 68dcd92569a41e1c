// Another implementation of the format must accept every recording, read as a stream and through its index, with every
// CRC checked.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import test from 'node:test';
import { decompressHandlers, readMcap } from './mcap_file.mjs';
import { load } from './packages.mjs';
import { inFolder, lineCourse, program, withRobot } from './programs.mjs';

const { McapStreamReader } = load('@mcap/core');

/** The only run that was recorded into `folder`. */
async function recorded(folder) {
  const runs = await readdir(folder);
  assert.equal(runs.length, 1, `runs: ${runs}`);
  return join(folder, runs[0], 'run.mcap');
}

/** Counts messages by topic and events by text, and checks every record. */
function readAsStream(bytes) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  reader.append(bytes);
  const schemas = new Map(), channels = new Map(), counts = new Map();
  const seen = { attachments: [], metadata: [], footer: false, events: new Map(), steps: [] };
  for (let record; (record = reader.nextRecord()) !== undefined;) {
    if (record.type === 'Schema') schemas.set(record.id, record);
    if (record.type === 'Channel') {
      assert.ok(schemas.has(record.schemaId), `${record.topic} has a schema`);
      channels.set(record.id, record);
    }
    if (record.type === 'Attachment') seen.attachments.push(record.name);
    if (record.type === 'Metadata') seen.metadata.push(record.metadata);
    if (record.type === 'Footer') seen.footer = true;
    if (record.type !== 'Message') continue;
    const channel = channels.get(record.channelId);
    counts.set(channel.topic, (counts.get(channel.topic) ?? 0) + 1);
    if (channel.topic === '/step') seen.steps.push(record.logTime);
    if (channel.messageEncoding === 'json') {
      const value = JSON.parse(new TextDecoder().decode(record.data));
      checkAgainst(JSON.parse(new TextDecoder().decode(schemas.get(channel.schemaId).data)), value, channel.topic);
      if (channel.topic === '/event') seen.events.set(value.text, record.logTime);
    }
  }
  assert.ok(reader.done(), 'read to the end');
  assert.ok(seen.footer);
  return { counts, channels, ...seen };
}

/** Expects that every value has the type that the schema gives; null means "not known". */
function checkAgainst(schema, value, where) {
  if (value === null) return;
  const type = Array.isArray(value) ? 'array'
    : Number.isInteger(value) && schema.type === 'integer' ? 'integer' : typeof value;
  assert.equal(type, schema.type, where);
  if (type === 'array') value.forEach((entry) => checkAgainst(schema.items, entry, `${where}[]`));
  if (type !== 'object') return;
  for (const [name, entry] of Object.entries(value)) {
    if (Object.keys(schema.properties).length === 0) continue;
    // The type of a parameter's value depends on the parameter, so the schema does not give it.
    if (where === '/parameter.parameters[]' && ['value', 'default'].includes(name)) continue;
    assert.ok(schema.properties[name], `${where}.${name} is in the schema`);
    checkAgainst(schema.properties[name], entry, `${where}.${name}`);
  }
}

async function check(file) {
  const streamed = readAsStream(await readFile(file));
  const { reader, topics } = await readMcap(file);
  const attachments = [], metadata = [];
  for await (const entry of reader.readAttachments({ validateCrcs: true })) attachments.push(entry.name);
  for await (const entry of reader.readMetadata()) metadata.push(entry.metadata);
  assert.deepEqual(streamed.counts, new Map([...topics].map(([topic, messages]) => [topic, messages.length])));
  for (const messages of topics.values())
    messages.forEach(({ logTime }, i) => assert.ok(i === 0 || logTime >= messages[i - 1].logTime));
  assert.deepEqual([streamed.attachments, streamed.metadata], [attachments, metadata]);
  const { messageCount, channelMessageCounts } = reader.statistics;
  assert.equal(Number(messageCount), [...streamed.counts.values()].reduce((sum, count) => sum + count, 0));
  for (const [id, count] of channelMessageCounts)
    assert.equal(Number(count), streamed.counts.get(streamed.channels.get(id).topic) ?? 0);
  return streamed;
}

test('a course in virtual time', () => inFolder(async (folder) => {
  execFileSync(program('tp100-sim'), ['course', '1-straight', '--record', folder, '--json']);
  const { counts, attachments, metadata } = await check(await recorded(folder));
  for (const topic of ['/step', '/estimate', '/sample', '/command', '/truth', '/tf', '/scene'])
    assert.ok(counts.get(topic) > 0, topic);
  assert.equal(counts.get('/step'), counts.get('/estimate'));
  assert.deepEqual(attachments, ['tp100.toml', 'robot.toml', 'course.toml']);
  assert.equal(metadata[0].get('course'), '1-straight');
  assert.equal(metadata[0].get('seed'), '1');
}));

test('a live run', () => withRobot(async ({ folder, daemon }) => {
  const run = await daemon('', ['--course', await lineCourse(folder, 0.3), '--duration', '30', '--record', join(folder, 'runs')]);
  // On a busy machine commands may arrive too late; then the run is aborted, and the recording says so.
  const [status] = await run.exit;
  const end = status === 0 && !run.lines.some((line) => line.includes('running -> aborted')) ? 'finished' : 'aborted';
  const { counts, events, steps } = await check(await recorded(join(folder, 'runs')));
  assert.ok(counts.get('/step') > 100);
  for (const change of ['idle -> arming', 'arming -> running', `running -> ${end}`]) {
    const at = events.get(`state: ${change}`);
    assert.ok(at >= steps[0] && at <= steps.at(-1), change);
  }
  for (const topic of ['/event', '/log', '/state', '/link', '/loop', '/parameter']) assert.ok(counts.get(topic) > 0, topic);
  assert.equal(counts.get('/event'), counts.get('/log'));
}));
