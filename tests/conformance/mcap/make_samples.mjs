// make_samples.mjs DIR: writes small MCAP files with @mcap/core into DIR, one for each way to lay out a file, and
// expected.json with what is in them. The same bytes each time.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { McapWriter } from "@mcap/core";
import { compressChunk } from "./compression.mjs";
import { MemoryFile } from "./memory_file.mjs";
import { ros2Messages, writeRos2Sample } from "./ros2_sample.mjs";

const bare = {
  useStatistics: false,
  useSummaryOffsets: false,
  repeatSchemas: false,
  repeatChannels: false,
  useAttachmentIndex: false,
  useMetadataIndex: false,
  useMessageIndex: false,
  useChunkIndex: false,
};

const layouts = {
  chunked_none: {},
  chunked_lz4: { compression: "lz4" },
  chunked_zstd: { compression: "zstd" },
  chunked_none_bare: bare,
  chunked_lz4_bare: { compression: "lz4", ...bare },
  chunked_zstd_bare: { compression: "zstd", ...bare },
  one_chunk_lz4: { compression: "lz4", chunkSize: 1 << 20 },
  one_chunk_zstd: { compression: "zstd", chunkSize: 1 << 20 },
  unchunked: { useChunks: false },
  unchunked_bare: { useChunks: false, ...bare },
  no_statistics: { compression: "zstd", useStatistics: false },
  no_summary_offsets: { compression: "zstd", useSummaryOffsets: false },
  no_repeated_schemas: { compression: "zstd", repeatSchemas: false },
  no_repeated_channels: { compression: "zstd", repeatChannels: false },
  no_message_index: { compression: "zstd", useMessageIndex: false },
  no_chunk_index: { compression: "zstd", useChunkIndex: false },
  no_attachment_index: { compression: "zstd", useAttachmentIndex: false, useMetadataIndex: false },
};

const text = new TextEncoder();
const noSchema = { name: "", encoding: "", data: "" };
const channels = [
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
const messages = Array.from({ length: 24 }, (_, index) => {
  const channel = index % channels.length;
  const logTime = startTime + BigInt(index % 5 === 4 ? index - 3 : index) * 1_000_000n;
  const content = ["", JSON.stringify({ count: index, padding: "x".repeat(index) }), "\0\x01\0\0text " + index][channel];
  return { channel, sequence: index, logTime, publishTime: logTime - 500n, data: text.encode(content) };
});

async function writeSample({ compression = "none", ...layout }) {
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
    if (index === 10) {
      await writer.addAttachment({
        logTime: startTime,
        createTime: startTime,
        name: "note.txt",
        mediaType: "text/plain",
        data: text.encode("an attachment"),
      });
      await writer.addMetadata({ name: "notes", metadata: new Map([["key", "value"]]) });
    }
  }
  await writer.end();
  return file.bytes();
}

const [directory] = process.argv.slice(2);
for (const [name, layout] of Object.entries(layouts)) {
  writeFileSync(join(directory, `${name}.mcap`), await writeSample(layout));
}
writeFileSync(join(directory, "ros2.mcap"), await writeRos2Sample());

const expected = {
  samples: Object.keys(layouts).map((name) => `${name}.mcap`),
  channels,
  messages: messages.map((message) => ({
    topic: channels[message.channel].topic,
    sequence: message.sequence,
    logTime: `${message.logTime}`,
    publishTime: `${message.publishTime}`,
    data: Buffer.from(message.data).toString("hex"),
  })),
};
writeFileSync(join(directory, "expected.json"), JSON.stringify(expected, undefined, 1) + "\n");
writeFileSync(join(directory, "ros2_expected.json"), JSON.stringify(ros2Messages, undefined, 1) + "\n");
