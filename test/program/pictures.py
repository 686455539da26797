# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""Writes and reads small pictures and videos with the standard library alone.

A picture is a list of rows of grey values, 0 to 255.
"""

import struct
import zlib


def black(width, height):
    return [bytearray(width) for _ in range(height)]


def horizontal(picture, y):
    picture[y] = bytearray(b"\xff" * len(picture[y]))
    return picture


def vertical(picture, x):
    for row in picture:
        row[x] = 255
    return picture


def step(width, height, column):
    """Dark left of a column, bright from it on: a vertical edge at column - 0.5."""
    return [bytearray(40 if x < column else 210 for x in range(width)) for _ in range(height)]


def write_pgm(path, picture):
    head = b"P5 %d %d 255\n" % (len(picture[0]), len(picture))
    path.write_bytes(head + b"".join(picture))


def write_png(path, picture, bits=8):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", len(picture[0]), len(picture), bits, 0, 0, 0, 0)
    rows = (row if bits == 8 else b"".join(bytes((v, v)) for v in row) for row in picture)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data)
                     + chunk(b"IEND", b""))


def write_y4m(path, pictures, frames_per_second=25):
    """YUV4MPEG2: a header line, and before each uncompressed frame the word FRAME."""
    width, height = len(pictures[0][0]), len(pictures[0])
    head = b"YUV4MPEG2 W%d H%d F%d:1 Ip A1:1 C420jpeg\n" % (width, height, frames_per_second)
    colorless = b"\x80" * (2 * ((width + 1) // 2) * ((height + 1) // 2))
    path.write_bytes(head + b"".join(b"FRAME\n" + b"".join(p) + colorless for p in pictures))


def read_png(path):
    """Returns (width, height, channels, rows); 8 bits a channel, not interlaced."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", body[:10])
            assert bits == 8
            channels = {0: 1, 2: 3, 6: 4}[color]
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    return width, height, channels, _unfilter(zlib.decompress(packed), height, channels)


def _unfilter(raw, height, channels):
    stride = len(raw) // height
    rows, above = [], bytearray(stride - 1)
    for y in range(height):
        kind, row = raw[y * stride], bytearray(raw[y * stride + 1:(y + 1) * stride])
        for i in range(len(row)):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            row[i] = (row[i] + _predict(kind, left, above[i], corner)) & 255
        rows.append(row)
        above = row
    return rows


def _predict(kind, left, up, corner):
    if kind == 4:  # Paeth: the neighbour nearest to left + up - corner
        estimate = left + up - corner
        return min((left, up, corner), key=lambda value: abs(estimate - value))
    return (0, left, up, (left + up) // 2)[kind]
