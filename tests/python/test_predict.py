"""`soilctl predict`: answers, exit codes, and Coulomb against an independent closed form."""

import itertools

import numpy as np
import pytest
import reference

MODELS = ["coulomb", "log-spiral", "log-spiral-thesis", "caquot", "chen", "thesis-ub", "thesis-lb", "table"]
WITH_ENDS = ["mckyes", "perumpral", "godwin-spoor", "blocks-3d"]
COEFFICIENTS = ["k_passive", "k_active", "k_net", "k_net_depth"]
BASE = ["--alpha", 80, "--phi", 40, "--delta", 20]
SIZE = ["--depth", 0.025, "--width", 0.127, "--density", 1600]


@pytest.mark.parametrize("model", MODELS + WITH_ENDS)
def test_answer_follows_the_schema(soilctl, validate, model):
    answer = soilctl.json("predict", "--model", model, *BASE, *SIZE)
    validate(answer)
    assert answer["schema"] == "soilctl.predict/1"
    assert answer["model"] == model
    assert answer["version"] in soilctl("--version", code=0).stdout
    assert answer["force_n"] > 0
    sine2 = np.sin(np.radians(80)) ** 2
    assert answer["k_net_depth"] == pytest.approx(answer["k_net"] / sine2, rel=1e-12)
    force = 0.5 * 1600 * reference.GRAVITY_M_S2 * 0.025**2 * 0.127 * answer["k_net_depth"]
    assert answer["force_n"] == pytest.approx(force, rel=1e-12)
    if answer["k_passive"] is not None:
        assert answer["k_net"] == pytest.approx(answer["k_passive"] - answer["k_active"], rel=1e-12)
    if model == "table":
        lower, upper = answer["k_net_lower"], answer["k_net_upper"]
        assert 0 < lower <= upper
        assert answer["k_net"] == pytest.approx(np.sqrt(lower * upper), rel=1e-12)


@pytest.mark.parametrize("left_out", ["--depth", "--width", "--density"])
def test_without_a_size_there_are_coefficients_but_no_force(soilctl, validate, left_out):
    at = SIZE.index(left_out)
    answer = soilctl.json("predict", "--model", "coulomb", *BASE, *SIZE[:at], *SIZE[at + 2 :])
    validate(answer)
    assert answer["force_n"] is None
    assert all(answer[key] > 0 for key in COEFFICIENTS)


def coulomb_grid():
    for alpha, phi, delta, beta in itertools.product([60, 75, 90, 100], [15, 28.5, 40], [0, 7.25, 15], [-4, 0, 6]):
        if np.isfinite(reference.coulomb_k_net_slant(alpha, phi, delta, beta)):
            yield alpha, phi, delta, beta


def test_coulomb_agrees_with_the_closed_form(soilctl):
    grid = list(coulomb_grid())
    assert len(grid) > 90
    for alpha, phi, delta, beta in grid:
        angles = ["--alpha", alpha, "--phi", phi, "--delta", delta, "--beta", beta]
        answer = soilctl.json("predict", "--model", "coulomb", *angles, *SIZE)
        passive, active = reference.coulomb_k_depth(alpha, phi, delta, beta)
        sine2 = np.sin(np.radians(alpha)) ** 2
        force = 0.5 * 1600 * reference.GRAVITY_M_S2 * 0.025**2 * 0.127 * (passive - active)
        expected = {
            "k_passive": passive * sine2,
            "k_active": active * sine2,
            "k_net": (passive - active) * sine2,
            "k_net_depth": passive - active,
            "force_n": force,
        }
        found = {key: answer[key] for key in expected}
        assert found == pytest.approx(expected, rel=1e-6), angles


def test_negative_values_work_as_separate_arguments(soilctl):
    falling = soilctl.json("predict", "--model", "coulomb", *BASE, "--beta", "-4")
    joined = soilctl.json("predict", "--model", "coulomb", *BASE, "--beta=-4")
    level = soilctl.json("predict", "--model", "coulomb", *BASE)
    assert falling == joined
    assert falling["k_net"] < level["k_net"]
    assert falling["k_net"] == pytest.approx(float(reference.coulomb_k_net_slant(80, 40, 20, -4)), rel=1e-6)


def test_unset_loads_are_zero_and_gravity_is_the_standard_one(soilctl):
    zeros = ["--beta", 0, "--cohesion", 0, "--adhesion", 0, "--surcharge", 0, "--gravity", 9.80665]
    assert soilctl.json("predict", "--model", "coulomb", *BASE, *SIZE) == soilctl.json(
        "predict", "--model", "coulomb", *BASE, *SIZE, *zeros
    )
    moon = soilctl.json("predict", "--model", "coulomb", *BASE, *SIZE, "--gravity", 1.62)["force_n"]
    earth = soilctl.json("predict", "--model", "coulomb", *BASE, *SIZE)["force_n"]
    assert moon == pytest.approx(earth * 1.62 / 9.80665, rel=1e-12)


@pytest.mark.parametrize(
    ("arguments", "mentions"),
    [
        (["--model", "newton", *BASE], ["newton", "coulomb"]),
        (["--model", "coulomb", "--phi", 40, "--delta", 20], ["--alpha"]),
        (["--model", "coulomb", "--alpha", "x", "--phi", 40, "--delta", 20], ["--alpha", "x"]),
        (["--model", "coulomb", "--alpha", "nan", "--phi", 40, "--delta", 20], ["--alpha"]),
        (["--model", "coulomb", "--alpha", 200, "--phi", 40, "--delta", 20], ["200"]),
        (["--model", "coulomb", "--alpha", 80, "--phi", 95, "--delta", 20], ["95"]),
        (["--model", "coulomb", "--alpha", 80, "--phi", 40, "--delta", -3], ["-3"]),
        (["--model", "coulomb", *BASE, "--depth", -0.01, "--width", 0.1, "--density", 1600], ["-0.01"]),
        (["--model", "coulomb", *BASE, "--depth", 0.01, "--width", 0, "--density", 1600], ["0"]),
        (["--model", "coulomb", *BASE, "--depth", 0.01, "--width", 0.1, "--density", "-5"], ["-5"]),
        # q = 1: Coulomb's wedge is unbounded, there is no finite force.
        (["--model", "coulomb", "--alpha", 100, "--phi", 50, "--delta", 30], ["100"]),
        # Not on the thesis's grid.
        (["--model", "thesis-ub", "--alpha", 50, "--phi", 40, "--delta", 20], ["50"]),
        (["--no-such-option", 1], ["--no-such-option"]),
    ],
)
def test_wrong_usage_and_bad_values_are_refused(soilctl, arguments, mentions):
    soilctl.refuses("predict", *arguments, mentions=mentions)


def test_text_is_the_default_and_json_stdout_is_one_document(soilctl):
    text = soilctl("predict", "--model", "coulomb", *BASE, *SIZE, code=0)
    assert text.stdout.strip() and not text.stdout.lstrip().startswith("{")
    assert "\x1b[" not in text.stdout + text.stderr
    quiet = soilctl("predict", "--model", "coulomb", *BASE, "--format", "json", "--quiet", code=0)
    assert quiet.stderr == ""


def test_same_question_same_bytes(soilctl):
    runs = {soilctl("predict", "--model", "chen", *BASE, *SIZE, "--format", "json", code=0).stdout for _ in range(3)}
    assert len(runs) == 1


def test_predictions_for_a_stroke_table(soilctl, validate, data):
    file = data / "soils" / "ticino_rained" / "strokes.csv"
    soil = ["--phi", 40, "--delta", 23, "--density", 1600]
    answer = soilctl.json("predict", "--model", "coulomb", *soil, "--strokes", file)
    validate(answer)
    assert [stroke["alpha_deg"] for stroke in answer["strokes"]] == [70, 80, 90, 100]
    for stroke in answer["strokes"]:
        size = stroke["depth_m"], 0.127
        force = float(reference.coulomb_force_n(stroke["alpha_deg"], 40, 23, 1600, *size))
        assert stroke["force_n"] == pytest.approx(force, rel=1e-6)


def rankine_in_layers_n(depth_m, phi_ref_deg, slope_deg, reference_pa, density, width_m):
    """A smooth upright plate: stresses of Rankine ahead and behind, each layer with the friction of its own slip planes."""
    z = (np.arange(4000) + 0.5) * depth_m / 4000
    vertical = density * reference.GRAVITY_M_S2 * z

    def pressure(side):
        sine = np.full_like(z, 0.6)
        for _ in range(80):
            stress = vertical * (1 + side * sine)
            sine = np.sin(np.radians(phi_ref_deg - slope_deg * np.log10(stress / reference_pa)))
        return vertical * (1 + side * sine) / (1 - side * sine)

    return width_m * np.sum(pressure(1) - pressure(-1)) * depth_m / 4000


@pytest.mark.parametrize("depth_m", [0.01, 0.04, 0.15])
def test_a_law_of_stress_holds_the_force_of_layers_with_their_own_friction(soilctl, validate, depth_m):
    for phi, slope, stress in [(40, 5, 1000), (34, 3, 200), (38, 7, 5000)]:
        plate = ["--alpha", 90, "--delta", 0, "--depth", depth_m, "--width", 0.127, "--density", 1500]
        law = ["--friction-law", f"{slope}:{slope}", "--reference-stress", stress]
        answer = soilctl.json("predict", "--phi", phi, *plate, *law)
        validate(answer)
        low, high = answer["friction_law"]["force_n"]
        assert low <= rankine_in_layers_n(depth_m, phi, slope, stress, 1500, 0.127) <= high
        assert low <= answer["force_n"] <= high
        wider = soilctl.json("predict", "--phi", phi, *plate, "--friction-law", f"1:{slope}", "--reference-stress", stress)
        assert wider["friction_law"]["force_n"][0] <= low and wider["friction_law"]["force_n"][1] >= high


def test_a_law_without_slope_is_one_friction_angle(soilctl):
    plain = soilctl.json("predict", *BASE, *SIZE)
    law = soilctl.json("predict", *BASE, *SIZE, "--friction-law", "0:0", "--reference-stress", 1000)
    assert law["friction_law"]["force_n"] == [plain["force_n"]] * 2
    assert law["friction_law"]["phi_deg"] == [40, 40]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (SIZE[:4], "--density"),
        ([*SIZE, "--cohesion", 100], "for its weight alone"),
    ],
)
def test_a_law_of_stress_that_cannot_be_applied_is_refused(soilctl, options, words):
    found = soilctl("predict", *BASE, *options, "--friction-law", "3:6", "--reference-stress", 1000, code=2)
    assert words in found.stderr
