"""Checks whether files that ddtool writes are complete, by their formats only."""
import ast
import json
import math
import re
import struct
import zipfile


def _npy(content):
    if not content.startswith(b"\x93NUMPY"):
        return False
    length = struct.unpack_from("<H", content, 8)[0]
    header = ast.literal_eval(content[10:10 + length].decode())
    fields = header["descr"] if isinstance(header["descr"], list) else [("", header["descr"])]
    row = sum(int(re.search(r"\d+$", field[1]).group()) * math.prod(field[2] if len(field) > 2 else ()) for field in fields)
    return len(content) == 10 + length + row * math.prod(header["shape"])


def _pgm(content):
    header = re.match(rb"P5\s(?:#.*\n)*(\d+)\s+(\d+)\s+255\s", content)
    return bool(header) and len(content) - header.end() == int(header[1]) * int(header[2])


def _safetensors(content):
    length = struct.unpack_from("<Q", content)[0]
    tensors = json.loads(content[8:8 + length])
    return len(content) == 8 + length + max(entry["data_offsets"][1] for name, entry in tensors.items()
                                            if name != "__metadata__")


def _events(content):
    """Each TFRecord consists of the length, its checksum, the bytes, and their checksum."""
    at = 0
    while at + 8 <= len(content):
        at += 16 + struct.unpack_from("<Q", content, at)[0]
    return at == len(content)


_MCAP = b"\x89MCAP0\r\n"
_ENDINGS = {
    ".html": lambda content: content.rstrip().endswith(b"</html>"),
    ".png": lambda content: content.endswith(b"IEND\xaeB`\x82"),
    ".mcap": lambda content: content.startswith(_MCAP) and content.endswith(_MCAP),
    ".json": lambda content: json.loads(content) is not None,
    ".npy": _npy,
    ".pgm": _pgm,
    ".safetensors": _safetensors,
    ".ddtool": _events,  # events.out.tfevents.ddtool
}


def _whole(path):
    if path.suffix == ".pt":
        return zipfile.ZipFile(path).testzip() is None
    content = path.read_bytes()
    return _ENDINGS.get(path.suffix, lambda text: text.endswith(b"\n"))(content)


def not_whole(folder):
    """The names of the incomplete files in a folder. Files *.part, which a killed program leaves behind, do not count."""
    broken = []
    for path in sorted(path for path in folder.rglob("*") if path.is_file() and path.suffix != ".part"):
        try:
            whole = _whole(path)
        except (ValueError, KeyError, SyntaxError, struct.error, zipfile.BadZipFile):
            whole = False
        if not whole:
            broken.append(str(path.relative_to(folder)))
    return broken
