// The functions that McapWriter and the readers of @mcap/core need to compress and decompress chunks.

import decompressLz4 from "@foxglove/wasm-lz4";
import zstd from "@foxglove/wasm-zstd";
import lz4 from "lz4js";

await decompressLz4.isLoaded;
await zstd.isLoaded;

export const compressChunk = {
  none: undefined,
  lz4: (records) => ({ compression: "lz4", compressedData: lz4.compress(records) }),
  zstd: (records) => ({ compression: "zstd", compressedData: zstd.compress(records) }),
};

export const decompressHandlers = {
  lz4: (records, size) => decompressLz4(records, Number(size)),
  zstd: (records, size) => zstd.decompress(records, Number(size)),
};
