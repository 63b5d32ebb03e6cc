"""How well strokes of bags with known truth are found and weighed: `python -m foreign.score SOILCTL COUNT [FIRST]`."""

import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from . import bags


@dataclass
class Found:
    """A stroke that was made, and the row that was found for it; `row` is None if there is none."""

    case: bags.Case
    truth: bags.Truth
    row: dict | None

    @property
    def error(self):
        return self.row["force_n"] / self.truth.force_n - 1

    @property
    def sds(self):
        """The error in stated standard deviations."""
        return (self.row["force_n"] - self.truth.force_n) / self.row["force_sd_n"]

    @property
    def is_right(self):
        """Drastic failures within 3 % or two standard deviations of the noise, gradual ones within 10 %."""
        if self.row is None:
            return False
        if self.truth.kind == "gradual":
            return abs(self.error) < 0.10
        return abs(self.error) < max(0.03, 2 * self.case.noise / self.truth.force_n)


def options(bag, path):
    return ["--urdf", path.with_suffix(".urdf"), "--plate-frame", bag.arm.plate, "--surface-z", bag.arm.surface_z,
            "--width", bag.case.width]


def process(soilctl, bag, path, *more):
    """Exit code, answer, and what was said."""
    command = [soilctl, "process", path, *options(bag, path), *more, "--format", "json", "--quiet"]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout) if done.stdout else None, done.stderr


def match(bag, answer):
    """Each stroke that was made with its row, and rows that belong to none."""
    shift = answer["logs"][0]["found"]["clock_origin_s"] - int(bag.case.wall_s)
    left, pairs = list(answer["strokes"]), []
    for truth in bag.truth:
        mine = [row for row in left if truth.start_s - 1 < row["failure_time_s"] + shift < truth.end_s + 0.5]
        pairs.append(Found(bag.case, truth, mine[0] if mine else None))
        left = [row for row in left if row is not pairs[-1].row]
    return pairs, left


def one(soilctl, seed):
    bag = bags.make(bags.any_case(seed))
    with tempfile.TemporaryDirectory() as folder:
        path = bags.write(bag, folder)
        code, answer, said = process(soilctl, bag, path)
    if answer is None:
        raise AssertionError(f"seed {seed}: exit {code}: {said}")
    return match(bag, answer)


def main():
    soilctl, count = sys.argv[1], int(sys.argv[2])
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    found, invented = [], 0
    with ThreadPoolExecutor(2) as pool:
        for seed, (pairs, left) in zip(range(first, first + count), pool.map(lambda s: one(soilctl, s), range(first, first + count))):
            found += pairs
            invented += len(left)
            for pair in pairs:
                if not pair.is_right:
                    what = "missing" if pair.row is None else f"error {100 * pair.error:+.1f} %"
                    print(f"seed {seed}: {pair.truth.kind} {pair.truth.force_n:.2f} N, noise {pair.case.noise:.2f} N: {what}")
    rows = [pair for pair in found if pair.row]
    print(f"{count} bags, {len(found)} strokes: {len(rows)} found, {invented} invented")
    for kind in ("drastic", "gradual"):
        of = [pair for pair in rows if pair.truth.kind == kind]
        print(f"{kind}: {np.mean([pair.is_right for pair in of]):.3f} right, median error "
              f"{100 * np.median([abs(pair.error) for pair in of]):.2f} %")
    sds = np.abs([pair.sds for pair in rows])
    print(f"within one stated sd {np.mean(sds < 1):.3f}, within two {np.mean(sds < 2):.3f}")
    ok = (len(rows) >= 0.98 * len(found) and invented == 0 and np.mean([p.is_right for p in rows]) >= 0.95
          and 0.60 <= np.mean(sds < 1) <= 0.80 and np.mean(sds < 2) >= 0.92)
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
