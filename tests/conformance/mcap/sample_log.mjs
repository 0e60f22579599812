// The messages of the samples, and a function that writes them in any layout that McapWriter offers.

import { McapWriter } from "@mcap/core";
import { compressChunk } from "./compression.mjs";
import { MemoryFile } from "./memory_file.mjs";

const text = new TextEncoder();
const noSchema = { name: "", encoding: "", data: "" };
export const channels = [
  { topic: "/empty", messageEncoding: "x-test", metadata: {}, schema: noSchema },
  {
    topic: "/count",
    messageEncoding: "json",
    metadata: { origin: "test", unit: "1" },
    schema: { name: "Count", encoding: "jsonschema", data: '{"type":"object"}' },
  },
  {
    topic: "/größe",
    messageEncoding: "cdr",
    metadata: {},
    schema: { name: "std_msgs/msg/String", encoding: "ros2msg", data: "string data\n" },
  },
];

const startTime = 1_700_000_000_123_456_789n;

/** Messages of all channels; the times step backwards now and then, as in some recordings. */
export const messages = Array.from({ length: 24 }, (_, index) => {
  const channel = index % channels.length;
  const logTime = startTime + BigInt(index % 5 === 4 ? index - 3 : index) * 1_000_000n;
  const content = ["", JSON.stringify({ count: index, padding: "x".repeat(index) }), "\0\x01\0\0text " + index][channel];
  return { channel, sequence: index, logTime, publishTime: logTime - 500n, data: text.encode(content) };
});

/** The bytes of a file; `layout` as for McapWriter, with a compression's name, and whether it has the other records. */
export async function writeSample({ compression = "none", attachment = true, metadata = true, ...layout }) {
  const file = new MemoryFile();
  const writer = new McapWriter({
    writable: file,
    chunkSize: 300,
    compressChunk: compressChunk[compression],
    ...layout,
  });
  await writer.start({ profile: "", library: "@mcap/core" });
  const ids = [];
  for (const { schema, ...channel } of channels) {
    const schemaId = schema.name ? await writer.registerSchema({ ...schema, data: text.encode(schema.data) }) : 0;
    ids.push(await writer.registerChannel({ ...channel, schemaId, metadata: new Map(Object.entries(channel.metadata)) }));
  }
  for (const [index, { channel, ...message }] of messages.entries()) {
    await writer.addMessage({ ...message, channelId: ids[channel] });
    if (index === 10 && attachment) {
      await writer.addAttachment({
        logTime: startTime,
        createTime: startTime,
        name: "note.txt",
        mediaType: "text/plain",
        data: text.encode("an attachment"),
      });
    }
    if (index === 10 && metadata) {
      await writer.addMetadata({ name: "notes", metadata: new Map([["key", "value"]]) });
    }
  }
  await writer.end();
  return file.bytes();
}
