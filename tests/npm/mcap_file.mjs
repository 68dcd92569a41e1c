// Bags and recordings as @mcap/core reads them.
import { readFile } from 'node:fs/promises';
import { load } from './packages.mjs';

const { McapIndexedReader } = load('@mcap/core');
const { decompress } = load('fzstd');
export const decompressHandlers = { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) };

/** The reader of a file, and its messages (`logTime`, `data`) by topic in the order of time; every CRC is checked. */
export async function readMcap(file) {
  const bytes = await readFile(file);
  const reader = await McapIndexedReader.Initialize({
    readable: {
      size: async () => BigInt(bytes.length),
      read: async (offset, length) => new Uint8Array(bytes.buffer, bytes.byteOffset + Number(offset), Number(length)),
    },
    decompressHandlers,
  });
  const topics = new Map();
  for await (const { channelId, logTime, data } of reader.readMessages({ validateCrcs: true })) {
    const { topic } = reader.channelsById.get(channelId);
    if (!topics.has(topic)) topics.set(topic, []);
    topics.get(topic).push({ logTime, data });
  }
  return { reader, topics };
}
