#!/usr/bin/env python3
"""Proven bounds on the force of a plate in two level layers without cohesion, by `soilctl solve`: what the model of layers of `profile` is held against.

    python3 data/profile/layers.py SOILCTL [--out FILE]

Each row is solved once; on two cores all of it takes half an hour. Bounds differ with the budget of time, and hold whatever it is.
"""

import argparse
import csv
import json
import math
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
COLUMNS = ["alpha_deg", "delta_deg", "phi_top_deg", "phi_bottom_deg", "weight_top_kn_m3", "weight_bottom_kn_m3", "step_over_depth", "lower_kn_m", "upper_kn_m"]


def problem(alpha_deg, delta_deg, top, bottom, step):
    """The plate is 1 m deep and moves horizontally; the problem ends in far sides."""
    back = 1.0 / math.tan(math.radians(alpha_deg))
    layers = [("top", *top, 0.0, step), ("bottom", *bottom, step, 3.0)]
    return {
        "objective": {"kind": "structure", "name": "plate", "direction": [1, 0]},
        "default_boundary": "free",
        "soil": [{"name": name, "phi_deg": phi, "cohesion_kpa": 0, "unit_weight_kn_m3": weight} for name, phi, weight, _, _ in layers],
        "region": [{"soil": name, "polygon": [[-6, -low], [12, -low], [12, -high], [-6, -high]]} for name, _, _, high, low in layers],
        "boundary": [{"kind": "far", "sides": ["left", "right", "bottom"]}],
        "plate": [{"name": "plate", "line": [[0, -1], [-back, 0]], "delta_deg": delta_deg, "adhesion_kpa": 0}],
    }


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("soilctl")
    arguments.add_argument("--out", type=Path, default=HERE / "layers.csv")
    given = arguments.parse_args()
    with open(HERE / "layers.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        of = {name: float(value) for name, value in row.items()}
        top, bottom = ((of[f"phi_{end}_deg"], of[f"weight_{end}_kn_m3"]) for end in ("top", "bottom"))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "layers.json"
            path.write_text(json.dumps(problem(of["alpha_deg"], of["delta_deg"], top, bottom, of["step_over_depth"])), encoding="utf-8")
            command = [given.soilctl, "solve", path, "--max-gap", "0.01", "--max-seconds", "60", "--format", "json"]
            answer = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        row["lower_kn_m"], row["upper_kn_m"] = (f"{answer[end]:.4f}" for end in ("lower", "upper"))
    with open(given.out, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
