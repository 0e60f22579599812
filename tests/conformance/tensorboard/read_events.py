#!/usr/bin/env python3
"""Reads a TensorBoard event file without any code of ddtool and compares it with metrics.csv: read_events.py FOLDER

TFRecord framing: https://www.tensorflow.org/tutorials/load_data/tfrecord; protobuf's wire format:
https://protobuf.dev/programming-guides/encoding; field numbers: tensorflow/core/util/event.proto, summary.proto.
"""

import csv
import pathlib
import struct
import sys

COLUMN_OF_TAG = {
    "loss/train": "train_loss",
    "loss/validation": "validation_loss",
    "accuracy/train": "train_accuracy",
    "accuracy/validation": "validation_accuracy",
    "validation/f1": "validation_f1",
    "validation/auc": "validation_auc",
    "schedule/learning_rate": "learning_rate",
}


def crc32c_table():
    table = []
    for byte in range(256):
        for _ in range(8):
            byte = byte >> 1 ^ (0x82F63B78 if byte & 1 else 0)
        table.append(byte)
    return table


TABLE = crc32c_table()


def masked_crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = TABLE[(crc ^ byte) & 0xFF] ^ crc >> 8
    crc ^= 0xFFFFFFFF
    return ((crc >> 15 | crc << 17) + 0xA282EAD8) & 0xFFFFFFFF


def records(data):
    """The contents of the TFRecords. Their checksums are checked."""
    at = 0
    while at < len(data):
        length, length_crc = struct.unpack_from("<QI", data, at)
        assert length_crc == masked_crc32c(data[at : at + 8]), f"length's CRC at {at}"
        content = data[at + 12 : at + 12 + length]
        (content_crc,) = struct.unpack_from("<I", data, at + 12 + length)
        assert content_crc == masked_crc32c(content), f"content's CRC at {at}"
        yield content
        at += 12 + length + 4


def varint(data, at):
    value = shift = 0
    while True:
        value |= (data[at] & 0x7F) << shift
        shift += 7
        at += 1
        if data[at - 1] < 0x80:
            return value, at


def fields(data):
    """(number, value) of each field of a protobuf message."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        kind = key & 7
        if kind == 0:
            value, at = varint(data, at)
        elif kind == 1:
            (value,), at = struct.unpack_from("<d", data, at), at + 8
        elif kind == 2:
            length, at = varint(data, at)
            value, at = data[at : at + length], at + length
        elif kind == 5:
            (value,), at = struct.unpack_from("<f", data, at), at + 4
        else:
            raise AssertionError(f"wire type {kind}")
        yield key >> 3, value


def scalars(summary):
    for number, value in fields(summary):
        assert number == 1, f"field {number} of a summary"
        entry = dict(fields(value))
        yield entry[1].decode(), entry[2]


def as_float32(number):
    return struct.unpack("<f", struct.pack("<f", number))[0]


def main(folder):
    rows = list(csv.DictReader((folder / "metrics.csv").open()))
    assert len(rows) == 5
    (file,) = folder.glob("*tfevents*")
    first, *events = [dict(fields(record)) for record in records(file.read_bytes())]
    assert first[3] == b"brain.Event:2"
    assert len(events) == len(rows), f"{len(events)} events"
    for row, event in zip(rows, events):
        assert event[2] == int(row["epoch"])
        assert event[1] == float(row["wall_time_s"])
        expected = {tag: as_float32(float(row[column])) for tag, column in COLUMN_OF_TAG.items()}
        assert dict(scalars(event[5])) == expected, f"epoch {row['epoch']}"


if __name__ == "__main__":
    assert masked_crc32c(b"123456789") == ((0xE3069283 >> 15 | 0xE3069283 << 17) + 0xA282EAD8) & 0xFFFFFFFF
    main(pathlib.Path(sys.argv[1]))
