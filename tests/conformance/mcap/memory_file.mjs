/** A file in memory, to be written by McapWriter. */
export class MemoryFile {
  #parts = [];
  #size = 0n;

  async write(bytes) {
    this.#parts.push(Buffer.from(bytes)); // a copy: the writer reuses its buffer
    this.#size += BigInt(bytes.byteLength);
  }
  position() {
    return this.#size;
  }
  bytes() {
    return Buffer.concat(this.#parts);
  }
}
