"""The program for Windows under wine, against the one of this system: the same answers, the same proofs, the same bytes.

`cargo xtask windows` builds both and runs this. `SOILCTL` is the program of this system, `SOILCTL_WINDOWS` the other one.
"""

import json
import os
import re
import subprocess
import urllib.request
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "data"
WINE = "/usr/lib/wine/wine64"
HERE = [os.environ["SOILCTL"]]
THERE = [WINE, os.environ["SOILCTL_WINDOWS"]]
TIMEOUT_S = 600


def done(program, *words, code=0):
    """What a program prints; wine shows the root of this system's files as that of its own drive, so paths are the same."""
    ended = subprocess.run(
        [*program, *map(str, words)], cwd=ROOT, capture_output=True, stdin=subprocess.DEVNULL, timeout=TIMEOUT_S, check=False
    )
    assert ended.returncode == code, f"{words}: {ended.returncode}\n{ended.stderr.decode(errors='replace')[-2000:]}"
    return ended.stdout.decode()


def both(*words, code=0):
    """The JSON answers of both."""
    return [json.loads(done(program, *words, "--format", "json", code=code)) for program in (HERE, THERE)]


def digits(value):
    """An answer without what depends on the machine's speed and on how it writes the names of its files."""
    if isinstance(value, dict):
        return {key: digits(one) for key, one in value.items() if not key.endswith("seconds") and key != "elapsed_s"}
    if isinstance(value, list):
        return [digits(one) for one in value]
    return value.replace("\\", "/") if isinstance(value, str) else value


def same(*words, code=0):
    here, there = both(*words, code=code)
    assert digits(here) == digits(there), words


def close(*words, relative, code=0, loose=None):
    """Where sines and logarithms are those of the system, last digits differ, and iterations carry them on.

    `loose` names a key whose numbers only have to be within 1e-4.
    """

    def compare(here, there, where):
        assert type(here) is type(there), where
        if isinstance(here, dict):
            assert here.keys() == there.keys(), where
            for key in here:
                compare(here[key], there[key], f"{where}.{key}")
        elif isinstance(here, list):
            assert len(here) == len(there), where
            for number, pair in enumerate(zip(here, there, strict=True)):
                compare(*pair, f"{where}[{number}]")
        elif isinstance(here, float):
            within = 1e-4 if loose and where.endswith(f".{loose}") else relative
            assert here == pytest.approx(there, rel=within, abs=within), where
        else:
            assert here == there, where

    compare(*map(digits, both(*words, code=code)), str(words))


def test_version_and_help():
    assert done(THERE, "--version") == done(HERE, "--version")
    assert "predict" in done(THERE, "--help")
    assert "processors" in done(THERE, "doctor")


@pytest.mark.parametrize("model", ["coulomb", "log-spiral", "caquot", "chen", "table"])
def test_predict(model):
    same("predict", "--model", model, "--alpha", 80, "--phi", 40, "--delta", 25, "--density", 1600, "--depth", 0.025, "--width", 0.127)


def test_estimate():
    strokes = DATA / "soils/ticino_rained/strokes.csv"
    same("estimate", strokes, "--model", "thesis-ub", "--delta", 23, "--density", 1600)
    close("estimate", strokes, "--delta", 23, relative=1e-9)


def test_a_proof_made_on_one_system_proves_on_the_other(tmp_path):
    for number, maker in enumerate((HERE, THERE)):
        saved = tmp_path / f"plate{number}.json"
        done(maker, "bound", "--alpha", 90, "--phi", 30, "--delta", 15, "--max-gap", 0.02, "--save", saved)
        same("certify", saved)


def test_bound_and_solve():
    close("bound", "--alpha", 90, "--phi", 30, "--delta", 15, "--max-gap", 0.05, relative=1e-6)
    # Meshes follow from solutions: a last digit may turn an edge, and proofs of other fields are other numbers.
    here, there = both("solve", DATA / "problems/footing_clay.toml", "--max-gap", 0.1)
    assert [here["lower"], here["upper"]] == pytest.approx([there["lower"], there["upper"]], rel=1e-4)


def test_diagnose_a_shipped_campaign(tmp_path):
    close("diagnose", DATA / "campaigns/campaign_a", "--out", tmp_path, relative=1e-8)


# As docs/own-robot.md has it.
OTHER_ARM = ["--plate-frame", "blade_edge", "--surface-z", 0.08, "--width", 0.1]


def test_process_the_bag_of_another_arm():
    # Where two lines meet, and where a search for it ends, hangs on last digits of the pose.
    loose = "two_lines_force_n"
    close("process", DATA / "other_arm/bag", "--urdf", DATA / "other_arm/arm.urdf", *OTHER_ARM, relative=1e-9, loose=loose)


PLAN = """version = 1
design = "one stroke"
soil = "ticino_loose"
model = "table"
seed = 1

[[batches]]
strokes = [{ radius_m = 0.4318, base_deg = -25.0, alpha_deg = 90.0, depth_m = 0.0254, delta_set_deg = 23.0 }]
"""


def test_a_simulated_stroke_is_the_same_log(tmp_path):
    plan = tmp_path / "plan.toml"
    plan.write_text(PLAN)
    logs = []
    for name, program in (("here", HERE), ("there", THERE)):
        done(program, "simulate", plan, "--out", tmp_path / name, "--quiet")
        logs.append((tmp_path / name / "batch_000.mcap").read_bytes())
    assert logs[0] == logs[1]
    # Each replays what the other wrote, bit for bit.
    same("replay", tmp_path / "here/batch_000.mcap")


def test_the_monitor_answers(tmp_path):
    plan = tmp_path / "plan.toml"
    plan.write_text(PLAN)
    done(HERE, "simulate", plan, "--out", tmp_path / "log", "--quiet")
    words = [*THERE, "monitor", "--play", tmp_path / "log/batch_000.mcap", "--listen", "127.0.0.1:0"]
    with subprocess.Popen(list(map(str, words)), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as monitor:
        try:
            address = re.search(r"http://\S+", monitor.stdout.readline()).group()
            with urllib.request.urlopen(address, timeout=30) as page:
                assert page.status == 200 and b"<html" in page.read()
        finally:
            monitor.kill()
