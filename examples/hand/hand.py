#!/usr/bin/env python3
"""A hand of one's own: `soilctl dig --socket live --device hand`, and then `python hand.py live hand`.

It leads the plate 500 times a second with the standard library alone, by the frames of docs/dig.md, and feels the soil's force. `Pen` is a
stand-in that goes down into the soil, towards the base, and up; put the position of your haptic device in its place, and its force output
where `feel` is called. Rules for a device: say where it is in every frame, let go when it is released, and take its own force off when no
frame has come for 20 ms: then the session is gone, or is too slow.
"""

import json
import math
import socket
import struct
import sys

HAND = struct.Struct("<4sHHII4d")  # magic, version, 0, flags, number, x, y, z in m, tool angle in rad
TOUCH = struct.Struct("<4sHHQII7d")  # magic, version, 0, tick, flags, number, x, y, z, tool angle, force along x, y, z in N
VERSION = 1
LEADS = 1  # flag of a hand frame
READY, LED, REACH, FORCE, TORQUE, REFUSED = (1 << bit for bit in range(6))  # flags of a touch frame
TICK_S = 0.002
MOST_N = 3.0  # what this device can show; ours shows nothing


class Pen:
    """A hand that goes a way of straight pieces: each a time in s, and how far outwards and up of where it began, in m."""

    def __init__(self, x, y, z, way):
        self.place, self.way = (x, y, z), way
        self.out = (x / math.hypot(x, y), y / math.hypot(x, y))

    def at(self, time_s):
        """Where it is, or none when it has let go."""
        begin = (0.0, 0.0, 0.0)
        for end in self.way:
            if time_s <= end[0]:
                share = (time_s - begin[0]) / (end[0] - begin[0])
                out, up = (a + share * (b - a) for a, b in zip(begin[1:], end[1:]))
                x, y, z = self.place
                return x + out * self.out[0], y + out * self.out[1], z + up
            begin = end
        return None


def receive(connection, count):
    """Exactly `count` bytes, or none when the session has ended."""
    parts = b""
    while len(parts) < count:
        part = connection.recv(count - len(parts))
        if not part:
            return None
        parts += part
    return parts


def touch(connection):
    """The next touch frame: tick, flags, number, place in m, tool angle in rad, force in N; none at the end."""
    frame = receive(connection, TOUCH.size)
    if frame is None:
        return None
    magic, version, _, tick, flags, number, *values = TOUCH.unpack(frame)
    if (magic, version) != (b"SCTO", VERSION):
        sys.exit(f"error: frame {magic} of version {version}, not SCTO of version {VERSION}")
    return tick, flags, number, values[:3], values[3], values[4:]


def command(path, *names):
    """Commands to the operators' socket, one after the other; each has its answer before the next."""
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.connect(path)
        lines = connection.makefile("rw", encoding="utf-8")
        for number, name in enumerate(names):
            lines.write(json.dumps({"type": "command", "id": number, "command": {"name": name}}) + "\n")
            lines.flush()
            for line in lines:
                answer = json.loads(line)
                if answer.get("id") == number and answer["type"] in ("ack", "error"):
                    break
            if answer["type"] == "error":
                sys.exit(f"error: {name}: {answer['message']}")


def lead(connection, way, feel):
    """Leads the plate along a way; `feel` gets each force. Returns the greatest force, and how many ticks the plate was led."""
    tick, _, _, (x, y, z), tool, _ = touch(connection)
    pen, first, number, greatest, led = Pen(x, y, z, way), tick, 0, 0.0, 0
    while True:
        place, number = pen.at((tick - first) * TICK_S), (number + 1) % 2**32
        flags, place = (LEADS, place) if place else (0, (0.0, 0.0, 0.0))
        connection.sendall(HAND.pack(b"SCHD", VERSION, 0, flags, number, *place, tool))
        felt = touch(connection)
        if felt is None or not flags:
            return greatest, led
        tick, state, _, _, _, force = felt
        led += bool(state & LED)
        greatest = max(greatest, math.hypot(*force))
        feel(force, state)


def show(force, state):
    """Where a device gets its force: never more than it can show, and none while the plate is not led."""
    share = min(1.0, MOST_N / max(math.hypot(*force), 1e-9)) if state & LED else 0.0
    return [share * part for part in force]


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: hand.py OPERATORS_SOCKET DEVICE_SOCKET")
    command(sys.argv[1], "enable", "bias")
    # Down to the soil and 25 mm into it, 60 mm towards the base, and out again; slower than the arm may (80 mm/s).
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.connect(sys.argv[2])
        down = -0.3302 - 0.025 - touch(connection)[3][2]
        way = [(10.0, 0.0, down), (10.5, 0.0, down), (15.0, -0.06, down), (17.0, -0.06, down + 0.06)]
        greatest, led = lead(connection, way, show)
    print(f"led for {led * TICK_S:.1f} s, greatest force {greatest:.1f} N")


if __name__ == "__main__":
    main()
