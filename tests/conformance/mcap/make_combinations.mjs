// make_combinations.mjs DIR: writes the log of the samples into DIR in every combination of the parts that an MCAP file
// may have or lack.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { McapRecordBuilder, Opcode } from "@mcap/core";
import { writeSample } from "./sample_log.mjs";

/** Where messages lie: plainly in the file, or in chunks with or without their indexes. By the letters in the file's name. */
const containers = { plain: { useChunks: false, useMessageIndex: false, useChunkIndex: false } };
for (const compression of ["none", "lz4", "zstd"]) {
  const layout = { compression, useChunks: true };
  containers[compression] = { ...layout, useMessageIndex: false, useChunkIndex: false };
  containers[`${compression}-mx`] = { ...layout, useMessageIndex: true, useChunkIndex: false };
  containers[`${compression}-chx`] = { ...layout, useMessageIndex: false, useChunkIndex: true };
  containers[`${compression}-mx-chx`] = { ...layout, useMessageIndex: true, useChunkIndex: true };
}
/** What each part of a layout may be. */
const parts = [
  containers,
  { "": { useStatistics: false }, "-st": { useStatistics: true } },
  { "": { useSummaryOffsets: false }, "-sum": { useSummaryOffsets: true } },
  { "": { repeatSchemas: false }, "-rsh": { repeatSchemas: true } },
  { "": { repeatChannels: false }, "-rch": { repeatChannels: true } },
  {
    "": { attachment: false, useAttachmentIndex: false },
    "-at": { attachment: true, useAttachmentIndex: false },
    "-at-ax": { attachment: true, useAttachmentIndex: true },
  },
  {
    "": { metadata: false, useMetadataIndex: false },
    "-md": { metadata: true, useMetadataIndex: false },
    "-md-mdx": { metadata: true, useMetadataIndex: true },
  },
  { "": { extra: false }, "-pad": { extra: true } },
];

const combinations = parts.reduce(
  (before, part) =>
    before.flatMap(([name, layout]) =>
      Object.entries(part).map(([letters, more]) => [name + letters, { ...layout, ...more }]),
    ),
  [["", {}]],
);

/**
 * What the specification has readers ignore, but McapWriter has no option for: bytes behind a record's last field, and
 * records of a private type (opcodes from 0x80) between messages.
 */
let withExtra = false;
const firstPrivateOpcode = 0x80;

/** A record as metadata is written, but of a type of its own. */
function writePrivateRecord(builder) {
  const known = Opcode.METADATA;
  Opcode.METADATA = firstPrivateOpcode;
  builder.writeMetadata({ name: "another's", metadata: new Map() });
  Opcode.METADATA = known;
}

const prototype = McapRecordBuilder.prototype;
for (const name of Object.getOwnPropertyNames(prototype).filter((each) => each.startsWith("write"))) {
  const write = prototype[name];
  prototype[name] = function (record) {
    this.options = { padRecords: withExtra };
    const length = write.call(this, record);
    if (withExtra && name === "writeMessage" && record.sequence % 7 === 3) {
      writePrivateRecord(this);
    }
    return length;
  };
}

const [directory] = process.argv.slice(2);
for (const [name, { extra, ...layout }] of combinations) {
  withExtra = extra;
  writeFileSync(join(directory, `${name}.mcap`), await writeSample(layout));
}
console.log(`${combinations.length} combinations written`);
