// make_samples.mjs DIR: writes small MCAP files with @mcap/core into DIR, one for each layout of a file, and
// expected.json with their content. The bytes are the same each time.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { ros2Messages, writeRos2Sample } from "./ros2_sample.mjs";
import { channels, messages, writeSample } from "./sample_log.mjs";

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
