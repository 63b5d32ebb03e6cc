#!/usr/bin/env python3
"""Makes an example: strokes at five depths in a loose cover on dense sand.

Nobody measured these numbers. A force is that of a wedge through both layers, which moves as one body, so that its slip line leaves the velocity at the friction angle
of each layer (a kinematic upper bound; in one soil it is Coulomb's wedge), passive minus active, of the velocity that needs least. The output depends
on nothing else, so that running it again gives the same bytes. Only the standard library is needed.

    python3 data/profile/make.py [--out DIR]
"""

import argparse
import csv
import io
import json
import math
import random
from pathlib import Path

HERE = Path(__file__).resolve().parent

WIDTH_M = 0.127
GRAVITY_M_S2 = 9.80665
DELTA_DEG = 20.0
ANGLES_DEG = (50.0, 65.0, 80.0)
DEPTHS_M = (0.02, 0.03, 0.045, 0.06, 0.08)
REPEATS = 2
FORCE_SD_REL = 0.02
DEPTH_SD_M = 0.0003
STEP_M = 0.03

UNITS = {
    "stroke_id": "name",
    "batch": "the ground, one for all",
    "alpha_deg": "degrees; tool angle from the horizontal",
    "depth_m": "m; vertical depth of the plate's lower edge below the surface",
    "depth_sd_m": "m; its standard deviation",
    "width_m": "m",
    "force_n": "N; failure force",
    "force_sd_n": "N; standard deviation of one stroke",
    "delta_set_deg": "degrees; interface friction angle that the controller held",
}


def loose_on_dense(depth_m):
    """Friction angle in degrees and density in kg/m3."""
    return (33.0, 1450.0) if depth_m < STEP_M else (40.0, 1650.0)


def wedge(soil_at, alpha_deg, depth_m, velocity, sign, slices=60):
    """Force over width and gravity of a wedge that moves along an inclination in radians; passive with sign 1, active with -1; None if there is none."""
    plate = math.radians(alpha_deg if sign > 0 else 180.0 - alpha_deg)
    delta = math.radians(DELTA_DEG)
    step = depth_m / slices
    ahead, mass = 0.0, 0.0
    for i in reversed(range(slices)):
        depth = (i + 0.5) * step
        phi_deg, density = soil_at(depth)
        rise = velocity - sign * math.radians(phi_deg)
        if not 0.02 < rise < math.pi - plate - 1e-3:
            return None
        run = step / math.tan(rise)
        width = ahead + 0.5 * run + (depth_m - depth) / math.tan(plate)
        if width <= 0.0:
            return None
        mass += density * width * step
        ahead += run
    normal, along = (math.sin(plate), math.cos(plate)), (-math.cos(plate), math.sin(plate))
    push = [n * math.cos(delta) - sign * t * math.sin(delta) for n, t in zip(normal, along)]
    power = sign * (push[0] * math.cos(velocity) + push[1] * math.sin(velocity))
    if sign * power <= 1e-6:
        return None
    return mass * sign * math.sin(velocity) / power


def force_n(soil_at, alpha_deg, depth_m):
    """Passive minus active force in N: the least passive and the greatest active one."""

    def best(sign):
        def value(velocity):
            found = wedge(soil_at, alpha_deg, depth_m, velocity, sign)
            return math.inf if found is None else sign * found

        grid = [math.radians(0.5 * i) for i in range(2, 358)]
        middle = min(grid, key=value)
        low, high = middle - math.radians(0.5), middle + math.radians(0.5)
        for _ in range(40):
            a, b = low + 0.382 * (high - low), low + 0.618 * (high - low)
            low, high = (low, b) if value(a) < value(b) else (a, high)
        return sign * min(value(0.5 * (low + high)), value(middle))

    return GRAVITY_M_S2 * WIDTH_M * (best(1) - best(-1))


def strokes(soil_at, seed, *, angles=ANGLES_DEG, depths=DEPTHS_M, noise=FORCE_SD_REL, repeats=REPEATS):
    """Strokes with random errors of force and depth."""
    dice = random.Random(seed)
    for alpha_deg in angles:
        for depth_m in depths:
            true_n = force_n(soil_at, alpha_deg, depth_m)
            for repeat in range(repeats):
                read_n = true_n * (1.0 + dice.gauss(0.0, noise)) * (1.0 + 2.0 * dice.gauss(0.0, DEPTH_SD_M) / depth_m)
                yield {
                    "stroke_id": f"a{alpha_deg:.0f}-d{1e3 * depth_m:.0f}-{repeat + 1}",
                    "batch": "field",
                    "alpha_deg": f"{alpha_deg:g}",
                    "depth_m": f"{depth_m:g}",
                    "depth_sd_m": f"{DEPTH_SD_M:g}",
                    "width_m": f"{WIDTH_M:g}",
                    "force_n": f"{read_n:.4f}",
                    "force_sd_n": f"{max(noise, 1e-3) * true_n:.4f}",
                    "delta_set_deg": f"{DELTA_DEG:g}",
                }


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--out", type=Path, default=HERE)
    out = arguments.parse_args().out
    text = io.StringIO()
    writer = csv.DictWriter(text, UNITS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(strokes(loose_on_dense, 11))
    (out / "step.csv").write_text(text.getvalue(), encoding="utf-8")
    provenance = {
        "title": "Strokes at five depths in a loose cover on dense sand, made up",
        "source": "made by data/profile/make.py; nobody measured these numbers",
        "units": UNITS,
        "normalisation": None,
        "status": "made up",
        "exceptions": [],
        "notes": [
            "Ground: down to 30 mm a sand of 33 deg and 1450 kg/m3, below one of 40 deg and 1650 kg/m3.",
            "Forces by wedges through both layers in plane strain, with 2 % of noise and depths that are off by 0.3 mm.",
            "`layers.csv` is of another origin: bounds proven by `soilctl solve` for a plate 1 m deep in two layers (`layers.py`), in kN per metre of width along its horizontal way.",
        ],
    }
    (out / "provenance.json").write_text(json.dumps(provenance, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
