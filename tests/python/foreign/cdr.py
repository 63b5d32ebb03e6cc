"""Messages as CDR bytes, all of a topic at a time: the layout of one message is worked out once, then numpy fills in numbers."""

import struct

import numpy as np


class Layout:
    """Bytes of a message whose texts and lengths are fixed, and the places of its numbers."""

    def __init__(self):
        self.bytes = bytearray(b"\x00\x01\x00\x00")

    def align(self, to):
        while (len(self.bytes) - 4) % to:
            self.bytes.append(0)

    def whole(self, value):
        self.align(4)
        self.bytes += struct.pack("<I", value)

    def string(self, text):
        self.whole(len(text) + 1)
        self.bytes += text.encode() + b"\0"

    def stamp(self):
        self.align(4)
        self.stamp_at = len(self.bytes)
        self.bytes += bytes(8)

    def doubles(self, count):
        """Room for numbers; where they begin."""
        self.align(8)
        at = len(self.bytes)
        self.bytes += bytes(8 * count)
        return at

    def fill(self, stamps_ns, *columns):
        """One message a row: stamps, and arrays (n, k) at their places."""
        n = len(stamps_ns)
        rows = np.tile(np.frombuffer(bytes(self.bytes), np.uint8), (n, 1))
        pairs = np.stack([stamps_ns // 10**9, stamps_ns % 10**9], 1).astype("<u4")
        if hasattr(self, "stamp_at"):
            rows[:, self.stamp_at : self.stamp_at + 8] = pairs.view(np.uint8)
        for at, values in columns:
            raw = np.ascontiguousarray(values, "<f8").view(np.uint8)
            rows[:, at : at + raw.shape[1]] = raw
        return [row.tobytes() for row in rows]


def joint_states(stamps_ns, names, positions):
    layout = Layout()
    layout.stamp()
    layout.string("")
    layout.whole(len(names))
    for name in names:
        layout.string(name)
    layout.whole(len(names))
    at = layout.doubles(len(names))
    layout.whole(0)
    layout.whole(0)
    return layout.fill(stamps_ns, (at, positions))


def wrenches(stamps_ns, frame, wrench):
    layout = Layout()
    layout.stamp()
    layout.string(frame)
    at = layout.doubles(6)
    return layout.fill(stamps_ns, (at, wrench))


def text(content):
    layout = Layout()
    layout.string(content)
    return bytes(layout.bytes)
