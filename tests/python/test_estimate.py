"""`soilctl estimate`: regions against an independent count, inconsistent data, and bad input."""

import math

import numpy as np
import pytest
import reference
import shapely

WIDTH_M = 0.127
ALPHAS_DEG = [60.0, 75.0, 90.0, 100.0]
TRUTH = {"phi_deg": 36.0, "density_kg_m3": 1600.0, "delta_deg": 20.0}
DELTA_TOL_DEG = 1.0
SD_REL = 0.05
# Larger than any region below, which is checked.
PHI_BOX_DEG = (26.0, 48.0)
DENSITY_BOX_KG_M3 = (500.0, 5000.0)


class Campaign:
    """Strokes made by Coulomb's formula from a known soil, with a little scatter, and the intervals they allow."""

    def __init__(self, folder):
        self.alpha_deg = np.array(ALPHAS_DEG)
        self.depth_m = 0.0254 * np.sin(np.radians(self.alpha_deg))
        true = reference.coulomb_force_n(
            self.alpha_deg, TRUTH["phi_deg"], TRUTH["delta_deg"], TRUTH["density_kg_m3"], self.depth_m, WIDTH_M
        )
        self.force_n = true * np.array([1.02, 0.99, 1.01, 0.98])
        self.sd_n = SD_REL * true
        self.file = write_strokes(
            folder / "strokes.csv",
            [
                {"alpha_deg": a, "depth_m": d, "width_m": WIDTH_M, "force_n": f, "force_sd_n": s}
                for a, d, f, s in zip(self.alpha_deg, self.depth_m, self.force_n, self.sd_n, strict=True)
            ],
        )

    def density_interval(self, phi_deg, delta_deg, sigma=1.0):
        """Densities at which every stroke's interval holds the predicted force; empty if low > high.

        The force is proportional to the density, so each stroke allows an interval.
        """
        shape = np.broadcast_shapes(np.shape(phi_deg), np.shape(delta_deg))
        low, high = np.zeros(shape), np.full(shape, np.inf)
        for a, d, f, s in zip(self.alpha_deg, self.depth_m, self.force_n, self.sd_n, strict=True):
            unit = reference.coulomb_force_n(a, phi_deg, delta_deg, 1.0, d, WIDTH_M)
            low = np.fmax(low, (f - sigma * s) / unit)
            high = np.fmin(high, (f + sigma * s) / unit)
            missing = np.isnan(unit)
            low, high = np.where(missing, np.inf, low), np.where(missing, -np.inf, high)
        return low, high

    def consistent(self, phi_deg, density_kg_m3, delta_deg, sigma=1.0):
        """By definition: every measured interval holds the predicted force."""
        inside = np.full(np.shape(phi_deg), True)
        for a, d, f, s in zip(self.alpha_deg, self.depth_m, self.force_n, self.sd_n, strict=True):
            force = reference.coulomb_force_n(a, phi_deg, delta_deg, density_kg_m3, d, WIDTH_M)
            inside &= np.abs(force - f) <= sigma * s
        return inside

    def area(self, density=DENSITY_BOX_KG_M3, n_phi=1500, n_density=3000, n_delta=161):
        """Area of the union over delta, by counting the cells of a grid."""
        phi = midpoints(*PHI_BOX_DEG, n_phi)
        delta = TRUTH["delta_deg"] + np.linspace(-DELTA_TOL_DEG, DELTA_TOL_DEG, n_delta)
        low, high = self.density_interval(phi[:, None], delta[None, :])
        step = (density[1] - density[0]) / n_density
        # First cell whose middle is inside, and the first after it whose middle is not.
        first = np.clip(np.ceil((low - density[0]) / step - 0.5), 0, n_density)
        last = np.clip(np.floor((high - density[0]) / step - 0.5) + 1, 0, n_density)
        rows, _ = np.nonzero(first < last)
        first, last = first[first < last].astype(int), last[first < last].astype(int)
        change = np.zeros((n_phi, n_density + 1), dtype=int)
        np.add.at(change, (rows, first), 1)
        np.add.at(change, (rows, last), -1)
        cells = np.count_nonzero(np.cumsum(change, axis=1)[:, :-1] > 0)
        return cells * step * (PHI_BOX_DEG[1] - PHI_BOX_DEG[0]) / n_phi


def midpoints(low, high, n):
    return low + (np.arange(n) + 0.5) * (high - low) / n


def write_strokes(path, rows):
    """A stroke table with the keys of the first row as its header."""
    lines = [",".join(rows[0]), *(",".join(repr(float(value)) for value in row.values()) for row in rows)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path


def union_of(answer):
    """`region`: a list of polygons, each an outer ring followed by its holes."""
    return shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in answer["region"]])


def section_of(section):
    """`polygons` of a section: rings; a point is inside if it is inside an odd number of them."""
    shape = shapely.Polygon()
    for ring in section["polygons"]:
        shape = shape.symmetric_difference(shapely.Polygon(ring))
    return shape


def options(**more):
    given = {"model": "coulomb", "delta": TRUTH["delta_deg"], "delta-tol": DELTA_TOL_DEG, "sigma": 1, **more}
    return [word for key, value in given.items() for word in (f"--{key}", value)]


@pytest.fixture(scope="module")
def campaign(tmp_path_factory):
    return Campaign(tmp_path_factory.mktemp("estimate"))


@pytest.fixture(scope="module")
def free(soilctl, campaign):
    """The answer without knowledge of the density."""
    return soilctl.json("estimate", campaign.file, *options())


@pytest.fixture(scope="module")
def known(soilctl, campaign):
    """The answer with a known density."""
    return soilctl.json("estimate", campaign.file, *options(density=1600, **{"density-tol": 0.04}))


def test_answers_follow_the_schema(validate, free, known):
    for answer in (free, known):
        validate(answer)
        assert answer["schema"] == "soilctl.estimate/1"
        assert answer["consistent"] is True


@pytest.mark.parametrize(("name", "density"), [("free", DENSITY_BOX_KG_M3), ("known", (1536.0, 1664.0))])
def test_region_holds_every_consistent_point(request, campaign, name, density):
    answer = request.getfixturevalue(name)
    region = union_of(answer)
    assert region.is_valid and region.area > 0
    random = np.random.default_rng(20010901)
    n = 20_000
    # Half of the points in the whole box, half near the region, which most of the first half misses.
    near_phi = np.add(answer["phi_deg"], [-0.5, 0.5])
    near_rho = np.clip(np.multiply(answer["density_kg_m3"], [0.97, 1.03]), *density)
    phi = np.concatenate([random.uniform(*PHI_BOX_DEG, n // 2), random.uniform(*near_phi, n // 2)])
    rho = np.concatenate([random.uniform(*density, n // 2), random.uniform(*near_rho, n // 2)])
    delta = TRUTH["delta_deg"] + random.uniform(-DELTA_TOL_DEG, DELTA_TOL_DEG, n)
    inside = campaign.consistent(phi, rho, delta)
    assert np.count_nonzero(inside) > 500
    held = shapely.intersects_xy(region, phi[inside], rho[inside])
    lost = np.column_stack([phi, rho, delta])[inside][~held]
    assert len(lost) == 0, lost[:5]


@pytest.mark.parametrize(("name", "density"), [("free", DENSITY_BOX_KG_M3), ("known", (1536.0, 1664.0))])
def test_area_of_the_region_agrees_with_a_grid_count(request, campaign, name, density):
    answer = request.getfixturevalue(name)
    assert PHI_BOX_DEG[0] < answer["phi_deg"][0] and answer["phi_deg"][1] < PHI_BOX_DEG[1]
    assert DENSITY_BOX_KG_M3[0] < answer["density_kg_m3"][0]
    assert answer["density_kg_m3"][1] < DENSITY_BOX_KG_M3[1]
    assert union_of(answer).area == pytest.approx(campaign.area(density), rel=0.005)


@pytest.mark.parametrize("name", ["free", "known"])
def test_ranges_are_the_extent_of_the_region_and_hold_the_truth(request, name):
    answer = request.getfixturevalue(name)
    phi_low, rho_low, phi_high, rho_high = union_of(answer).bounds
    assert answer["phi_deg"] == pytest.approx([phi_low, phi_high], abs=0.01)
    assert answer["density_kg_m3"] == pytest.approx([rho_low, rho_high], rel=1e-3)
    assert answer["phi_deg"][0] < TRUTH["phi_deg"] < answer["phi_deg"][1]
    assert answer["density_kg_m3"][0] < TRUTH["density_kg_m3"] < answer["density_kg_m3"][1]


def test_known_density_cuts_the_region(free, known):
    box = shapely.box(0.0, 1600 * 0.96, 90.0, 1600 * 1.04)
    cut = union_of(free).intersection(box)
    assert union_of(known).symmetric_difference(cut).area < 0.005 * cut.area


def test_sections_lie_in_the_union_and_hold_their_own_points(campaign, free):
    union = union_of(free).buffer(1e-3)
    random = np.random.default_rng(7)
    deltas = [section["delta_deg"] for section in free["regions"]]
    assert deltas == sorted(deltas)
    tolerance = DELTA_TOL_DEG + 1e-9
    assert all(abs(delta - TRUTH["delta_deg"]) <= tolerance for delta in deltas)
    checked = 0
    for section in free["regions"]:
        shape = section_of(section)
        # Both are enclosures: a section at an end of the interval sticks out by its own slack.
        assert shape.difference(union).area < 0.003 * shape.area
        if shape.is_empty:
            continue
        phi = random.uniform(*np.add(free["phi_deg"], [-0.5, 0.5]), 20_000)
        rho = random.uniform(*free["density_kg_m3"], phi.size)
        inside = campaign.consistent(phi, rho, section["delta_deg"])
        assert np.all(shapely.intersects_xy(shape.buffer(1e-6), phi[inside], rho[inside]))
        checked += np.count_nonzero(inside)
    assert checked > 200


def test_wider_bands_give_a_larger_region(soilctl, campaign, free):
    wide = soilctl.json("estimate", campaign.file, *options(sigma=2))
    assert union_of(wide).area > union_of(free).area
    assert union_of(wide).buffer(1e-3).covers(union_of(free))


def test_columns_are_used_only_on_request(soilctl, data):
    file = data / "soils" / "ticino_rained" / "strokes.csv"
    by_number = soilctl.json("estimate", file, "--model", "chen", "--delta", 23, "--density", 1600)
    by_column = soilctl.json("estimate", file, "--model", "chen", "--delta", "column", "--density", "column")
    for key in ("phi_deg", "density_kg_m3", "region"):
        assert by_number[key] == by_column[key]
    unknown = soilctl.json("estimate", file, "--model", "chen", "--delta", 23)
    assert unknown["density_kg_m3"][0] < by_number["density_kg_m3"][0]


@pytest.mark.parametrize(
    ("model", "printed", "tolerance"),
    [
        ("thesis-ub", [41.4, 43.8], 0.3),
        ("thesis-lb", [43.6, 46.1], 0.3),
        ("chen", [40.8, 43.2], 0.4),
        ("caquot", [41.2, 43.6], 0.5),
    ],
)
def test_rained_ticino_reproduces_the_thesis(soilctl, validate, data, model, printed, tolerance):
    file = data / "soils" / "ticino_rained" / "strokes.csv"
    answer = soilctl.json("estimate", file, "--model", model, "--delta", 23, "--density", 1600)
    validate(answer)
    assert answer["phi_deg"] == pytest.approx(printed, abs=tolerance)


def assert_negative(answer, validate):
    validate(answer)
    assert answer["consistent"] is False
    assert answer["phi_deg"] is None and answer["density_kg_m3"] is None
    assert answer["regions"] == [] and answer["region"] == []
    # The volume of nothing is 0, not -0.
    assert math.copysign(1.0, answer["volume_deg2_kg_m3"]) == 1.0


def test_loose_ticino_has_no_intersection_under_chen(soilctl, validate, data):
    file = data / "soils" / "ticino_loose" / "strokes.csv"
    answer = soilctl.json("estimate", file, "--model", "chen", "--delta", 23, "--density", 1430, code=1)
    assert_negative(answer, validate)


def test_contradicting_strokes_are_a_negative_answer(soilctl, validate, tmp_path):
    row = {"alpha_deg": 80, "depth_m": 0.025, "width_m": 0.127, "force_n": 5.0, "force_sd_n": 0.1}
    file = write_strokes(tmp_path / "strokes.csv", [row, {**row, "force_n": 10.0}])
    assert_negative(soilctl.json("estimate", file, *options(), code=1), validate)


GOOD = "alpha_deg,depth_m,width_m,force_n,force_sd_n\n70,0.0239,0.127,3.8,0.3\n"


def test_one_stroke_with_its_deviation_is_enough(soilctl, validate, tmp_path):
    file = tmp_path / "strokes.csv"
    file.write_text(GOOD, encoding="utf-8")
    answer = soilctl.json("estimate", file, *options())
    validate(answer)
    assert answer["consistent"] is True


def test_rows_without_deviation_are_grouped(soilctl, tmp_path):
    file = tmp_path / "strokes.csv"
    rows = [{"alpha_deg": 80, "depth_m": 0.025, "width_m": 0.127, "force_n": force} for force in (4.8, 5.0, 5.4)]
    grouped = soilctl.json("estimate", write_strokes(file, rows), *options())
    mean, sd = np.mean([4.8, 5.0, 5.4]), np.std([4.8, 5.0, 5.4], ddof=1)
    single = soilctl.json("estimate", write_strokes(file, [{**rows[0], "force_n": mean, "force_sd_n": sd}]), *options())
    assert grouped["phi_deg"] == pytest.approx(single["phi_deg"], abs=1e-6)
    assert grouped["density_kg_m3"] == pytest.approx(single["density_kg_m3"], rel=1e-6)


# Third line of the file each time; the second is good.
BAD_CELLS = [
    ("80,0.025,0.127,abc,0.3", ["force_n", "abc"]),
    ("80,0.025,0.127,nan,0.3", ["force_n", "nan"]),
    ("80,0.025,0.127,inf,0.3", ["force_n", "inf"]),
    ("80,0.025,0.127,,0.3", ["force_n"]),
    ("190,0.025,0.127,5,0.3", ["alpha_deg", "190"]),
    ("0,0.025,0.127,5,0.3", ["alpha_deg"]),
    ("80,0.025,0.127,-5,0.3", ["force_n", "-5"]),
    ("80,0.025,0.127,5,0", ["force_sd_n"]),
    ("80,0.025,0.127,5,-0.1", ["force_sd_n", "-0.1"]),
    ("80,-0.025,0.127,5,0.3", ["depth_m", "-0.025"]),
    ("80,0.025,0,5,0.3", ["width_m"]),
]


@pytest.mark.parametrize(("line", "mentions"), BAD_CELLS)
def test_bad_cells_are_refused_with_line_and_column(soilctl, tmp_path, line, mentions):
    file = tmp_path / "strokes.csv"
    file.write_text(GOOD + line + "\n", encoding="utf-8")
    soilctl.refuses("estimate", file, *options(), mentions=["strokes.csv", "line 3", *mentions])


def test_a_row_of_the_wrong_length_is_refused_with_its_line(soilctl, tmp_path):
    file = tmp_path / "strokes.csv"
    file.write_text(GOOD + "80,0.025,0.127,5\n", encoding="utf-8")
    soilctl.refuses("estimate", file, *options(), mentions=["strokes.csv", "line 3"])


@pytest.mark.parametrize("column", ["alpha_deg", "depth_m", "width_m", "force_n"])
def test_a_missing_column_is_refused_with_its_name(soilctl, tmp_path, column):
    file = tmp_path / "strokes.csv"
    row = {"alpha_deg": 80, "depth_m": 0.025, "width_m": 0.127, "force_n": 5.0, "force_sd_n": 0.3}
    del row[column]
    soilctl.refuses("estimate", write_strokes(file, [row]), *options(), mentions=["strokes.csv", column])


def test_one_stroke_without_deviation_is_refused(soilctl, tmp_path):
    row = {"alpha_deg": 80, "depth_m": 0.025, "width_m": 0.127, "force_n": 5.0}
    file = write_strokes(tmp_path / "strokes.csv", [row])
    soilctl.refuses("estimate", file, *options(), mentions=["strokes.csv", "line 2", "force_sd_n"])


def test_a_file_that_is_not_utf8_is_refused_with_its_line(soilctl, tmp_path):
    file = tmp_path / "strokes.csv"
    head, row = GOOD.encode().split(b"\n")[:2]
    file.write_bytes(b"design," + head + b"\nplain," + row + b"\nd\xe9sign," + row + b"\n")
    soilctl.refuses("estimate", file, *options(), mentions=["strokes.csv", "line 3", "UTF-8"])


@pytest.mark.parametrize("content", [b"", b"alpha_deg,depth_m,width_m,force_n\n", b"\x00\x01\x02", b"PAR1"])
def test_files_without_strokes_are_refused(soilctl, tmp_path, content):
    file = tmp_path / "strokes.csv"
    file.write_bytes(content)
    soilctl.refuses("estimate", file, *options(), mentions=["strokes.csv"])


def test_a_missing_file_is_refused_with_its_name(soilctl, tmp_path):
    soilctl.refuses("estimate", tmp_path / "none.csv", *options(), mentions=["none.csv"])


@pytest.mark.parametrize(
    "option",
    [
        ("--delta", -1),
        ("--delta", "x"),
        ("--delta-tol", -1),
        ("--sigma", 0),
        ("--sigma", -1),
        ("--density", -5),
        ("--density-tol", -0.1),
    ],
)
def test_bad_options_are_refused(soilctl, campaign, option):
    given = dict(zip(*[iter(options(density=1600))] * 2, strict=True))
    given[option[0]] = option[1]
    soilctl.refuses("estimate", campaign.file, *[w for pair in given.items() for w in pair], mentions=[str(option[1])])


def test_same_question_same_bytes(soilctl, campaign):
    runs = {soilctl("estimate", campaign.file, *options(), "--format", "json", code=0).stdout for _ in range(2)}
    assert len(runs) == 1


def test_plates_with_ends_leave_more_soils(soilctl, validate, data):
    """The force of a plate with ends is above that of plane strain, so weaker soils explain it too."""
    file = data / "soils" / "ticino_rained" / "strokes.csv"
    asked = ("estimate", file, "--delta", "23", "--density", "1600")
    ranges = {}
    for ends in ("none", "finite"):
        answer = soilctl.json(*asked, "--ends", ends)
        validate(answer)
        assert answer["ends"] == ends and answer["consistent"]
        ranges[ends] = answer["phi_deg"]
    assert ranges["finite"][0] < ranges["none"][0] - 2.0
    assert abs(ranges["finite"][1] - ranges["none"][1]) < 0.5
    usual = soilctl.json(*asked)
    assert usual["phi_deg"] == ranges["finite"] and usual["plane_strain"]["phi_deg"] == ranges["none"]
    assert usual["end_factor"] == [0, 1] and min(usual["width_ratio"]) > 4.9
    assert soilctl.json(*asked, "--end-tol", "1")["end_factor"] is None
    closed = soilctl.json(*asked, "--model", "chen")
    assert any("is of plane strain" in warning for warning in closed["warnings"])
    assert not any("is of plane strain" in warning for warning in soilctl.json(*asked, "--model", "chen", "--ends", "none")["warnings"])
    soilctl.refuses(*asked, "--model", "chen", "--ends", "finite", mentions=["chen is for plane strain"])


def test_strokes_of_several_depths_are_brought_together_with_their_ends(soilctl, tmp_path):
    """Ends add the more, the deeper a plate of one width is: forces without noise must not seem to scatter for it."""
    rows = ["alpha_deg,depth_m,width_m,delta_set_deg,force_n,force_sd_n,depth_sd_m"]
    for alpha in (75, 90):
        for depth in (0.021, 0.024, 0.027):
            asked = ("predict", "--model", "table", "--alpha", alpha, "--phi", 40, "--delta", 20)
            ended = soilctl.json(*asked, "--depth", depth, "--width", 0.05)
            plane = soilctl.json(*asked, "--ends", "none")
            coefficient = plane["k_net"] + 0.5 * (ended["k_net_upper"] - plane["k_net_upper"])
            slant = depth / math.sin(math.radians(alpha))
            force = 0.5 * 1500 * 9.80665 * slant**2 * 0.05 * coefficient
            rows.append(f"{alpha},{depth},0.05,20,{force!r},{0.02 * force!r},0.0001")
    file = tmp_path / "strokes.csv"
    file.write_text("\n".join(rows) + "\n", encoding="utf-8")
    scatter = {}
    for ends in ("finite", "none"):
        answer = soilctl.json("estimate", file, "--ends", ends)
        scatter[ends] = [one["pooled"]["scatter"] for one in answer["measurements"]]
    assert len(scatter["finite"]) == 2 and max(scatter["finite"]) < 0.01 < min(scatter["none"])
