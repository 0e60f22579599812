// read_back.mjs DIR: reads every MCAP file in DIR, which ddtool wrote, with both readers of @mcap/core, decodes the
// messages by the schemas in the file, and compares them with DIR/expected.json.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { decompressHandlers } from "./compression.mjs";

function readableOf(bytes) {
  return {
    size: async () => BigInt(bytes.byteLength),
    read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)),
  };
}

/** In the order of the file, every chunk's CRC checked. */
function readStream(bytes) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(bytes);
  const schemas = new Map();
  const channels = new Map();
  const messages = [];
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Schema") {
      schemas.set(record.id, record);
    } else if (record.type === "Channel") {
      channels.set(record.id, record);
    } else if (record.type === "Message") {
      const channel = channels.get(record.channelId);
      messages.push(describe(record, channel, schemas.get(channel.schemaId)));
    }
  }
  assert(reader.done(), "the file has no proper end");
  return messages;
}

/** In the order of time, found by the indexes of the summary. */
async function readIndexed(bytes) {
  const reader = await McapIndexedReader.Initialize({ readable: readableOf(bytes), decompressHandlers });
  const messages = [];
  for await (const record of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(record.channelId);
    messages.push(describe(record, channel, reader.schemasById.get(channel.schemaId)));
  }
  assert.equal(Number(reader.statistics.messageCount), messages.length);
  assert.equal(reader.statistics.chunkCount, reader.chunkIndexes.length);
  assert.equal(reader.statistics.channelCount, reader.channelsById.size);
  assert.equal(reader.statistics.schemaCount, reader.schemasById.size);
  return messages;
}

/** As in expected.json. */
function describe(message, channel, schema) {
  const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
  const decoded = new MessageReader(definitions).readMessage(message.data);
  return {
    topic: channel.topic,
    type: schema.name,
    sequence: message.sequence,
    logTime: Number(message.logTime),
    message: plain(decoded),
  };
}

/** Typed arrays as arrays, so that they compare with JSON. */
function plain(value) {
  return JSON.parse(JSON.stringify(value, (_, part) => (ArrayBuffer.isView(part) ? Array.from(part) : part)));
}

const byTime = (messages) => [...messages].sort((a, b) => a.logTime - b.logTime);

const [directory] = process.argv.slice(2);
const expected = JSON.parse(readFileSync(join(directory, "expected.json"), "utf8"));
const files = readdirSync(directory).filter((name) => name.endsWith(".mcap"));
assert(files.length > 0, "no files to read");
for (const file of files) {
  const bytes = readFileSync(join(directory, file));
  assert.deepEqual(readStream(bytes), expected, file);
  assert.deepEqual(await readIndexed(bytes), byTime(expected), file);
  console.log(`${file}: ${expected.length} messages as expected, streamed and by index`);
}
