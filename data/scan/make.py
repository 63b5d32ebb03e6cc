"""Makes `before.asc` and `after.asc` beside it: made-up scans of the ground around a stroke of `data/places/one_place.csv`, as ESRI ASCII grids.

    python make.py            (from any folder; with numpy)

The stroke is that with the tool angle of 90 deg at place A2. The ground breaks where Chen and Liu's mechanism says for the sand there, which dilates by its friction angle less 28 deg.
"""

import importlib.util
import math
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
CELL_M, COLUMNS, ROWS, LOW = 0.004, 75, 60, (10.0, 5.0)
PLATE, HEADING_DEG, WIDTH_M, DEPTH_M = (10.12, 5.11), 20.0, 0.127, 0.0254
NOISE_M, PUSHED_M, SWELLING, STEP_M = 0.0004, 0.015, 1.1, 0.002
UP_M, TILT = 0.0021, (0.006, -0.003)


def crack_m():
    spec = importlib.util.spec_from_file_location("make_places", HERE.parent / "places" / "make.py")
    places = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(places)
    phi_deg, _ = places.soil_at(4, 14)
    return places.break_distance_m(90.0, places.reduced_deg(phi_deg, phi_deg - 28.0), 20.0, DEPTH_M)


def main():
    edge, random = crack_m(), np.random.default_rng(20)
    x, y = np.meshgrid(*(low + CELL_M * (np.arange(n) + 0.5) for low, n in zip(LOW, (COLUMNS, ROWS))))
    ground = 0.3 + 0.002 * np.sin(45 * x) * np.cos(38 * y)
    c, s = math.cos(math.radians(HEADING_DEG)), math.sin(math.radians(HEADING_DEG))
    ahead, left = c * (x - PLATE[0]) + s * (y - PLATE[1]), c * (y - PLATE[1]) - s * (x - PLATE[0])
    wide = np.abs(left) < WIDTH_M / 2
    # The heap has the furrow's volume times the swelling: a slope on a block.
    slope = 2.0 * (SWELLING * DEPTH_M * PUSHED_M / edge - STEP_M)
    heap = np.where(wide & (ahead >= 0) & (ahead < edge), STEP_M + slope * (1 - ahead / edge), 0.0)
    furrow = np.where(wide & (ahead < 0) & (ahead > -PUSHED_M), DEPTH_M, 0.0)
    after = ground + heap - furrow + UP_M + TILT[0] * (x - PLATE[0]) + TILT[1] * (y - PLATE[1])
    # The arm hides some of the ground behind the plate.
    hidden = (ahead > -0.1) & (ahead < -0.04) & (np.abs(left + 0.03) < 0.012)
    for name, heights in (("before", ground), ("after", np.where(hidden, np.nan, after))):
        heights = heights + random.normal(0.0, NOISE_M, x.shape)
        header = f"ncols {COLUMNS}\nnrows {ROWS}\nxllcorner {LOW[0]}\nyllcorner {LOW[1]}\ncellsize {CELL_M}\nNODATA_value -9999\n"
        rows = ["".join("-9999 " if np.isnan(z) else f"{z:.4f} " for z in row).rstrip() for row in heights[::-1]]
        (HERE / f"{name}.asc").write_text(header + "\n".join(rows) + "\n", encoding="ascii")
    print(f"the ground breaks {1e3 * edge:.1f} mm ahead of the plate")


if __name__ == "__main__":
    main()
