#!/usr/bin/env python3
"""A driver of one's own: `python driver.py SOCKET`, and then `soilctl run PLAN --driver SOCKET --socket live`.

It speaks the frames of docs/live.md with the standard library alone. `Arm` is a stand-in of five rotors with friction; put
the bus of your arm in its place. Rules for a real arm: switch the amplifiers off when a frame says so, when no frame has come
for 10 ms, and when the connection ends.
"""

import math
import os
import random
import socket
import struct
import sys

DRIVE = struct.Struct("<4sHHQII5d")  # magic, version, 0, tick, flags, 0, torques
READINGS = struct.Struct("<4sHHQ5I5i5iI6d5d5d")
VERSION = 1
TICK_S = 0.002
MOTOR_COUNTS = [289520.0, 289520.0, 144760.0, 144760.0, 289520.0]  # one turn, as in the controller's settings
EXTERNAL_COUNTS = 3600.0
AMPERES_PER_NM = [0.5, 0.5, 0.5, 0.5, 0.8]


class Arm:
    """Five rotors."""

    def __init__(self):
        self.angle = [0.0] * 5
        self.speed = [0.0] * 5
        self.noise = random.Random(1)

    def exchange(self, torques, enabled):
        """Lets the motors act for a tick, then reads the sensors."""
        torques = torques if enabled else [0.0] * 5
        for i, torque in enumerate(torques):
            self.speed[i] += (torque - 4.0 * self.speed[i]) / 0.5 * TICK_S
            self.angle[i] += self.speed[i] * TICK_S
        turns = [angle / math.tau for angle in self.angle]
        return {
            "motor": [round(turn * counts) for turn, counts in zip(turns, MOTOR_COUNTS)],
            "external": [round(turn * EXTERNAL_COUNTS) for turn in turns],
            "wrench": [self.noise.gauss(0.0, 0.01) for _ in range(6)],  # N, N m; a real sensor is never without noise
            "current": [torque * per for torque, per in zip(torques, AMPERES_PER_NM)],
            "voltage": [48.0] * 5,
        }


def receive(connection, count):
    """Exactly `count` bytes, or none when the session has ended."""
    parts = b""
    while len(parts) < count:
        part = connection.recv(count - len(parts))
        if not part:
            return None
        parts += part
    return parts


def serve(connection, arm):
    """One session to its end."""
    while frame := receive(connection, DRIVE.size):
        magic, version, _, tick, flags, _, *torques = DRIVE.unpack(frame)
        if (magic, version) != (b"SCDR", VERSION):
            sys.exit(f"error: frame {magic} of version {version}, not SCDR of version {VERSION}")
        seen = arm.exchange(torques, bool(flags & 1))
        # Flags (bit 0: force sensor overloaded), then a sequence number each for motor encoders, external encoders, force
        # sensor and amplifiers; each changes with every fresh reading, and only then.
        fresh = tick % 2**32
        connection.sendall(
            READINGS.pack(
                b"SCRE", VERSION, 0, tick, 0, fresh, fresh, fresh, fresh,
                *seen["motor"], *seen["external"], 0, *seen["wrench"], *seen["current"], *seen["voltage"],
            )
        )


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: driver.py SOCKET")
    path, arm = sys.argv[1], Arm()
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as listener:
        listener.bind(path)
        try:
            listener.listen(1)
            connection, _ = listener.accept()
            with connection:
                serve(connection, arm)
        finally:
            arm.exchange([0.0] * 5, False)
            os.unlink(path)


if __name__ == "__main__":
    main()
