"""`soilctl excavate`: torques of a push against statics of one's own, sets of soils, a plan that `simulate` runs, and refusals."""

import csv

import numpy as np
import pytest

SMALL = ["--soil", "nevada_fine", "--depth", 0.022]


@pytest.fixture(scope="module")
def exact(soilctl):
    return soilctl.json("excavate", *SMALL)


def test_answer_follows_the_schema(exact, validate):
    validate(exact)
    assert exact["schema"] == "soilctl.excavate/1"
    assert exact["complete"] and exact["dug"] == []
    assert all(one["share"] <= exact["share"] for one in exact["passes"])


def test_forces_are_those_of_predict(soilctl, exact):
    """A force at an inclination fails soil as at that friction on the plate."""
    alpha, depth = exact["at"]
    for row in exact["forces"]:
        if row["bears_n"] is None:
            continue
        size = ["--depth", depth, "--width", 0.127, "--density", 1440]
        said = soilctl.json(
            "predict", "--model", "table", "--ends", "none", "--alpha", alpha, "--phi", 42.6, "--delta", row["inclination_deg"], *size
        )
        low = said["force_n"] * said["k_net_lower"] / said["k_net"]
        assert row["bears_n"] == pytest.approx(low, rel=1e-6)
        assert row["fails_n"] >= said["force_n"] * said["k_net_upper"] / said["k_net"] * (1 - 1e-9)
    kinds = {row["plate"] for row in exact["forces"]}
    assert kinds == {"sticks", "dives"}


def test_a_set_of_soils_is_wider_and_its_passes_less_deep(soilctl, exact):
    options = ["--phi", "40,45", "--delta", "25,29", "--density", "1350,1520", "--share", 0.55]
    many = soilctl.json("excavate", *SMALL, *options, code=3)
    one = soilctl.json("excavate", *SMALL, "--share", 0.55)
    assert one["passes"] and many["passes"]
    assert many["passes"][0]["depth_m"] <= one["passes"][0]["depth_m"]
    at = {row["alpha_deg"]: row for row in many["angles"]}
    scale = (many["at"][1] / exact["at"][1]) ** 2
    for row in exact["angles"]:
        if row["alpha_deg"] in at:
            other = at[row["alpha_deg"]]
            assert other["bears_n"] < scale * row["bears_n"] < scale * row["fails_n"] < other["fails_n"]


def test_torque_goes_with_the_force(exact):
    """The push of the least angle of the table, by statics of the arm in its plane: shoulder and elbow about their axes."""
    row = max(exact["angles"], key=lambda one: one["alpha_deg"])
    depth = exact["at"][1]
    alpha, delta, force = np.radians(row["alpha_deg"]), np.radians(27.0), row["fails_n"]
    # Upper arm 16 in, forearm 15 in, hand 5 in, shoulder 13 in above the table (data/arm/thesis.toml).
    tip = np.array([0.36, -0.3302 - depth])
    along = np.array([np.cos(alpha), np.sin(alpha)])
    point = tip + along * depth / np.sin(alpha) / 3
    below = alpha - np.pi / 2 + delta
    push = force * np.array([-np.cos(below), -np.sin(below)])
    arm = point - np.array([0.0, 0.3302])
    # A joint's angle bends the arm forwards and down: clockwise, so that torque is z fr - r fz.
    shoulder = abs(arm[1] * push[0] - arm[0] * push[1])
    # The heap that it pushes, by the mean force ahead over that at the begin; gravity, friction, sinking and a heavier end come on top.
    heap = row["work_kj_m3"] * 1e3 * 0.127 * depth / (force * np.cos(below))
    assert 1 < heap < 3
    assert 0.6 * shoulder / 16.5 < row["share"] < 3.0 * heap * shoulder / 16.5 + 0.2


def test_simulate_runs_the_plan(soilctl, tmp_path):
    out, logs, table, figure = (tmp_path / name for name in ("plan", "logs", "passes.csv", "forces.svg"))
    answer = soilctl.json("excavate", *SMALL, "--out", out, "--table", table, "--plot", figure)
    assert sorted(path.name for path in out.iterdir()) == ["controller.toml", "plan.toml"]
    done = soilctl.json("simulate", out / "plan.toml", "--out", logs)
    assert done["complete"] and done["strokes_done"] == len(answer["passes"])
    with open(table, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["depth_m"]) for row in rows] == [one["depth_m"] for one in answer["passes"]]
    assert figure.read_text(encoding="utf-8").startswith("<svg")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--soil", "clay"], ["ticino_rained"]),
        (["--soil", "mars_drift"], ["cohesion"]),
        (["--phi", "45,40"], ["phi_deg", "must be"]),
        (["--delta", "10,50"], ["delta_deg"]),
        (["--alpha", "40,100"], ["45 to 135"]),
        (["--share", "1.5"], ["share"]),
        (["--radius", "0.9"], ["cannot be reached"]),
        (["--phi", "1,2,3"], ["least and a greatest"]),
    ],
)
def test_refusals(soilctl, options, words):
    soilctl.refuses("excavate", *options, mentions=words)


def test_a_share_that_nothing_keeps_is_an_answer(soilctl):
    answer = soilctl.json("excavate", *SMALL, "--share", 0.1, code=3)
    assert answer["passes"] == [] and "No pass" in answer["verdict"]
