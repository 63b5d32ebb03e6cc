#!/usr/bin/env python3
"""Makes an example: strokes at fourteen places of made-up ground, with the distance to the crack ahead of the plate.

Nobody measured these numbers. Two sands meet at a straight border, and both vary a little. Forces lie between the proven bounds of
`plate_bounds.csv`, with a part of what the ends of the plate add at most. The ground breaks where Chen and Liu's mechanism of least force
(1990, section 5.3; by brute force) meets the surface, for a sand that dilates less than its friction angle (Davis 1968), by
`psi = phi - 28 deg`. The output depends on nothing else, so that running it again gives the same bytes. Only the standard library is needed.

    python3 data/places/make.py [--out DIR]
"""

import argparse
import csv
import io
import json
import math
import random
from pathlib import Path

HERE = Path(__file__).resolve().parent
DATA = HERE.parent

WIDTH_M = 0.127
SLANT_M = 0.0254
GRAVITY_M_S2 = 9.80665
DELTA_DEG = 20.0
ANGLES_DEG = (70.0, 80.0, 90.0, 100.0)
REPEATS = 2
FORCE_SD_REL = 0.02
BREAK_SD_M = 0.003
PLACES = {
    "A1": (2, 3), "A2": (4, 14), "A3": (3, 24), "A4": (11, 8), "A5": (12, 19), "A6": (16, 2), "A7": (15, 26),
    "B1": (26, 5), "B2": (24, 15), "B3": (28, 25), "B4": (34, 10), "B5": (36, 20), "B6": (41, 3), "B7": (42, 26),
}

ONE = "A2"

UNITS = {
    "stroke_id": "name",
    "place": "name of the place",
    "place_x_m": "m, to the east",
    "place_y_m": "m, to the north",
    "alpha_deg": "degrees; tool angle from the horizontal",
    "depth_m": "m; vertical depth of the plate's lower edge below the surface",
    "width_m": "m",
    "force_n": "N; failure force",
    "force_sd_n": "N; standard deviation of one stroke",
    "delta_set_deg": "degrees; interface friction angle that the controller held",
    "break_distance_m": "m; along the surface from the plate's face to the crack",
    "break_distance_sd_m": "m; its standard deviation",
}


def soil_at(x_m, y_m):
    """Friction angle in degrees and density in kg/m3 of the ground."""
    wave = math.sin(0.15 * x_m + 0.1 * y_m)
    if x_m + 0.2 * y_m < 23.0:
        return 35.0 + 0.3 * wave, 1480.0 + 8.0 * wave
    return 39.5 + 0.3 * wave, 1590.0 + 8.0 * wave


class Bounds:
    """Coefficients of a plate from the table of proven bounds; their logarithms are interpolated."""

    def __init__(self, path=DATA / "plate_bounds.csv"):
        with open(path, newline="", encoding="utf-8") as file:
            self.rows = {}
            for row in csv.DictReader(file):
                key = tuple(float(row[name]) for name in ("alpha_deg", "phi_deg", "delta_deg"))
                self.rows[key] = [math.log(float(row[name])) for name in ("lower", "upper", "ends_upper", "ends_term")]
        self.axes = [sorted({key[d] for key in self.rows}) for d in range(3)]

    def _corners(self, axis, value):
        for low, high in zip(axis, axis[1:]):
            if low <= value <= high:
                part = (value - low) / (high - low)
                return [(low, 1.0 - part), (high, part)]
        raise ValueError(f"{value} is outside of the table")

    def force_n(self, alpha_deg, phi_deg, delta_deg, density_kg_m3, depth_m, *, ends=0.5, between=0.5, width_m=WIDTH_M):
        """Failure force in N: a place between the bounds, and a part of what ends add at most."""
        logs = [0.0] * 4
        phis, deltas = self._corners(self.axes[1], phi_deg), self._corners(self.axes[2], delta_deg)
        for alpha, of_alpha in self._corners(self.axes[0], alpha_deg):
            for phi, of_phi in phis:
                for delta, of_delta in deltas:
                    weight = of_alpha * of_phi * of_delta
                    if weight:
                        for i, log in enumerate(self.rows[alpha, phi, delta]):
                            logs[i] += weight * log
        low, high, wide, term = logs
        most = math.exp(wide) + math.exp(term) * depth_m / width_m - math.exp(high)
        slant_m = depth_m / math.sin(math.radians(alpha_deg))
        coefficient = math.exp(low + between * (high - low)) + ends * most
        return 0.5 * density_kg_m3 * GRAVITY_M_S2 * slant_m**2 * width_m * coefficient


def reduced_deg(phi_deg, psi_deg):
    """Friction angle of Davis's associated soil in place of one that dilates by psi."""
    phi, psi = math.radians(phi_deg), math.radians(psi_deg)
    return math.degrees(math.atan(math.tan(phi) * math.cos(psi) * math.cos(phi) / (1.0 - math.sin(psi) * math.sin(phi))))


def break_distance_m(alpha_deg, phi_deg, delta_deg, depth_m):
    """Where Chen and Liu's mechanism of least force meets level ground: both of its angles by brute force."""
    alpha, phi, delta = (math.radians(x) for x in (alpha_deg, phi_deg, min(delta_deg, phi_deg)))
    tangent = math.tan(phi)
    least, reach = math.inf, math.nan

    def tried(rho, psi):
        nonlocal least, reach
        x = alpha - rho - psi
        power, toe = math.cos(rho + delta), math.cos(x + phi)
        if power <= 1e-9 or toe <= 1e-9 or x <= 0.0 or psi < 0.0:
            return
        r0, b = math.cos(rho - phi) / math.cos(phi), 3.0 * tangent
        growth = math.exp(b * psi)
        dip = alpha - rho
        spiral = (growth * (b * math.cos(x) - math.sin(x)) - (b * math.cos(dip) - math.sin(dip))) / (b * b + 1.0)
        last = growth * math.cos(phi) * math.sin(x) * math.cos(x) / toe
        weight = r0 * (math.sin(rho) * math.cos(dip) + r0 * (spiral + last)) / power
        if weight < least:
            least, reach = weight, r0 * math.exp(tangent * psi) * math.cos(phi) / toe

    for step in (0.01, 0.0005):
        rho_at, psi_at = (0.75, 0.75) if step == 0.01 else best
        reach_of = 80 if step == 0.01 else 40
        best, known = (rho_at, psi_at), math.inf
        for i in range(-reach_of, reach_of + 1):
            for j in range(-reach_of, reach_of + 1):
                rho, psi = rho_at + i * step, psi_at + j * step
                tried(rho, max(psi, 0.0))
                if least < known:
                    known, best = least, (rho, psi)
    return reach * depth_m / math.sin(alpha)


def rows():
    """Strokes, as a table has them."""
    generator = random.Random(20_261_128)
    bounds = Bounds()
    for name, (x_m, y_m) in PLACES.items():
        phi_deg, density = soil_at(x_m, y_m)
        for alpha_deg in ANGLES_DEG:
            depth_m = SLANT_M * math.sin(math.radians(alpha_deg))
            crack_m = break_distance_m(alpha_deg, reduced_deg(phi_deg, phi_deg - 28.0), DELTA_DEG, depth_m)
            for repeat in range(1, REPEATS + 1):
                force_n = bounds.force_n(alpha_deg, phi_deg, DELTA_DEG, density, depth_m)
                force_n *= 1.0 + generator.gauss(0.0, FORCE_SD_REL)
                distance_m = crack_m + generator.gauss(0.0, BREAK_SD_M)
                yield {
                    "stroke_id": f"{name}-{alpha_deg:.0f}-{repeat}",
                    "place": name,
                    "place_x_m": x_m,
                    "place_y_m": y_m,
                    "alpha_deg": alpha_deg,
                    "depth_m": f"{depth_m:.5f}",
                    "width_m": WIDTH_M,
                    "force_n": f"{force_n:.3f}",
                    "force_sd_n": f"{FORCE_SD_REL * force_n:.3f}",
                    "delta_set_deg": DELTA_DEG,
                    "break_distance_m": f"{distance_m:.4f}",
                    "break_distance_sd_m": BREAK_SD_M,
                }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=HERE)
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    text = io.StringIO()
    writer = csv.DictWriter(text, UNITS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows())
    (out / "strokes.csv").write_text(text.getvalue(), encoding="utf-8")
    # One of the places alone.
    lines = text.getvalue().splitlines(keepends=True)
    (out / "one_place.csv").write_text("".join(line for line in lines if line.split(",")[1] in ("place", ONE)), encoding="utf-8")
    about = {
        "title": "Strokes at fourteen places of made-up ground",
        "source": "made by data/places/make.py; nobody measured these numbers",
        "units": UNITS,
        "normalisation": None,
        "status": "made up",
        "exceptions": [],
        "notes": [
            "Ground: where x + 0.2 y < 23 m a sand of about 35 deg and 1480 kg/m3, beyond one of about 39.5 deg and 1590 kg/m3.",
            "Forces by data/plate_bounds.csv, half of what ends add at most, with 2 % of noise.",
            "`one_place.csv` has the strokes of place A2 alone.",
            "Cracks by Chen and Liu's mechanism for a sand that dilates by phi - 28 deg (Davis 1968), with 3 mm of noise.",
        ],
    }
    (out / "provenance.json").write_text(json.dumps(about, indent=2) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
