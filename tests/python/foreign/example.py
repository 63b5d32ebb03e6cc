"""The recording in `data/other_arm`: `python -m foreign.example FOLDER` writes it anew.

An arm of seven joints pulls a plate 100 mm wide and 30 mm deep through sand, three times at each of three tool angles. The forces follow the
thesis's numerical limit analysis (`data/appendix_c.csv`, the middle of its two bounds), which this project has not computed."""

import csv
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from . import bags

PHI_DEG, DELTA_DEG, DENSITY = 35.0, 20.0, 1500.0
DEPTH, WIDTH = 0.03, 0.1
ALPHAS = (70.0, 80.0, 90.0)
REPEATS = 3
#: Soil is never the same twice.
SCATTER = 0.02
#: Steps of the sensor and of the encoders: powers of two, so that the recording is small.
STEP_N, STEP_NM, STEP_RAD = 2.0**-8, 2.0**-13, 2.0**-19
TABLE = Path(__file__).resolve().parents[3] / "data" / "appendix_c.csv"


def force_n(alpha_deg):
    """Failure force of the table, for a slant length of depth / sin(alpha)."""
    with open(TABLE, newline="") as file:
        wanted = (alpha_deg, PHI_DEG, DELTA_DEG)
        row = next(row for row in csv.DictReader(file) if tuple(float(row[k]) for k in ("alpha_deg", "phi_deg", "delta_deg")) == wanted)
    coefficient = (float(row["num_lb"]) + float(row["num_ub"])) / 2
    slant = DEPTH / np.sin(np.radians(alpha_deg))
    return 0.5 * coefficient * DENSITY * bags.GRAVITY * slant**2 * WIDTH


def make():
    rng = np.random.default_rng(2001)
    alphas = rng.permutation(np.repeat(ALPHAS, REPEATS))
    plan = tuple(("drastic", float(force_n(a) * (1 + SCATTER * rng.normal())), float(a)) for a in alphas)
    case = bags.Case(seed=2001, strokes=len(plan), plan=plan, delta=(DELTA_DEG, DELTA_DEG), noise=0.05, wrench_hz=100.0, joint_hz=50.0,
                     depth=(DEPTH, DEPTH), width=WIDTH, drift=0.001, container="bag")
    bag = bags.make(case)
    step = np.array([STEP_N] * 3 + [STEP_NM] * 3)
    return replace(bag, wrench=np.round(bag.wrench / step) * step, joints=np.round(bag.joints / STEP_RAD) * STEP_RAD)


def write(bag, folder):
    """The folder that `ros2 bag record -s mcap --compression-mode message` would leave, written by rosbags."""
    from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    types = {"/arm/joint_states": bags.JOINTS, "/ft/wrench_raw": bags.WRENCH}
    writer = Writer(folder / "bag", version=9, storage_plugin=StoragePlugin.MCAP)
    writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
    with writer:
        connections = {topic: writer.add_connection(topic, name, typestore=store) for topic, name in types.items()}
        for topic, time, data in bags.stream(bag):
            writer.write(connections[topic], int(time), data)
    (folder / "arm.urdf").write_text(bag.arm.urdf())


if __name__ == "__main__":
    write(make(), Path(sys.argv[1]))
