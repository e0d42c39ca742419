#!/usr/bin/env python3
"""apple_local.py FILE: makes a program for macOS, linked by zig, use its own copy of each weak symbol, and signs it again (ad hoc).

zig makes the loader take weak symbols, hidden ones, too, from any library of the process that has them. So numbers of locale's
facets would come from the system's C++ library, and the facets from zig's. Each place has its own copy's address already: without
the request it stays. `unsigned` lists the pages whose hash differs from the signature's.
"""

import hashlib
import pathlib
import struct
import sys

DYLD_INFO, CODE_SIGNATURE = 0x80000022, 0x1D
CODE_DIRECTORY, SHA256 = 0xFADE0C02, 2
WEAK_DEFINES, BINDS_TO_WEAK = 0x8000, 0x10000
FLAGS = 24  # where the header has them


def commands(data: bytes) -> "dict[int, int]":
    """Return where the file's load commands are, by kind."""
    magic, count = struct.unpack_from("<I12xI", data)
    if magic != 0xFEEDFACF:
        sys.exit("apple_local.py: this is no 64-bit file for macOS")
    found, place = {}, 32
    for _ in range(count):
        kind, size = struct.unpack_from("<II", data, place)
        found[kind] = place
        place += size
    return found


def pages(data: bytes) -> "list[tuple[int, bytes]]":
    """Return where the signature has each page's hash, and the page."""
    (signature,) = struct.unpack_from("<I", data, commands(data)[CODE_SIGNATURE] + 8)
    (count,) = struct.unpack_from(">I", data, signature + 8)
    found = []
    for index in range(count):
        (offset,) = struct.unpack_from(">I", data, signature + 12 + 8 * index + 4)
        directory = signature + offset
        magic, hashes, slots, limit, _, kind, _, shift = struct.unpack_from(">I12xI8xIIBBBB", data, directory)
        if magic == CODE_DIRECTORY:
            assert kind == SHA256, "zig signs with SHA-256"
            found += [(directory + hashes + 32 * slot, data[slot << shift:min((slot + 1) << shift, limit)]) for slot in range(slots)]
    return found


def unsigned(data: bytes) -> "list[int]":
    return [place for place, page in pages(data) if data[place:place + 32] != hashlib.sha256(page).digest()]


def is_local(data: bytes) -> bool:
    """Return whether the file takes no weak symbol of others, and offers none."""
    (flags,), (weak,) = struct.unpack_from("<I", data, FLAGS), struct.unpack_from("<I", data, commands(data)[DYLD_INFO] + 28)
    return not flags & (WEAK_DEFINES | BINDS_TO_WEAK) and weak == 0


def make_local(data: bytearray) -> None:
    (flags,) = struct.unpack_from("<I", data, FLAGS)
    struct.pack_into("<I", data, FLAGS, flags & ~(WEAK_DEFINES | BINDS_TO_WEAK))
    struct.pack_into("<II", data, commands(data)[DYLD_INFO] + 24, 0, 0)
    for place, page in pages(bytes(data)):
        data[place:place + 32] = hashlib.sha256(page).digest()


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    content = bytearray(path.read_bytes())
    make_local(content)
    path.write_bytes(content)
