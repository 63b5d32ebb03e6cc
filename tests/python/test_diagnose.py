"""`soilctl diagnose`: the example campaigns, the files it writes, and what the model file does elsewhere."""

import csv
import json
import math
import random
import shutil

import pytest
from conftest import DATA

CAMPAIGNS = DATA / "campaigns"
NAMES = ["campaign_a", "campaign_b", "campaign_c"]


@pytest.fixture(scope="module")
def diagnosed(soilctl, tmp_path_factory):
    """Answers and folders of all example campaigns."""
    found = {}
    for name in NAMES:
        out = tmp_path_factory.mktemp(name)
        found[name] = (soilctl.json("diagnose", CAMPAIGNS / name, "--out", out), out)
    return found


def rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def save(path, found):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, found[0].keys())
        writer.writeheader()
        writer.writerows(found)


@pytest.mark.parametrize("name", NAMES)
def test_answer_follows_the_schema_and_is_consistent(diagnosed, validate, name):
    answer, _ = diagnosed[name]
    validate(answer)
    assert answer["schema"] == "soilctl.diagnose/1"
    named = [effect["id"] for effect in answer["effects"]]
    assert set(named) <= set(answer["equivalence_set"])
    assert answer["gap"]["after"] <= answer["gap"]["before"]


@pytest.mark.parametrize("name", NAMES)
def test_the_gap_is_given_by_column_and_condition(diagnosed, name):
    answer, out = diagnosed[name]
    found = rows(out / "gap.csv")
    assert [row["channel"] for row in found if not row["covariate"]] == [p["channel"] for p in answer["gap_by_channel"]]
    forces = answer["gap_by_channel"][0]
    assert forces["channel"] == "force_n" and forces["after"] < forces["before"] and forces["delta_elpd"] > 0
    strokes = {row["stroke_id"]: row for row in rows(CAMPAIGNS / name / "strokes.csv")}
    predicted = rows(out / "predictions.csv")
    # The gap at each tool angle, from the held-out forces: they scatter alike, so it shrinks as gap.csv says.
    levels = [row for row in found if row["channel"] == "force_n" and row["covariate"] == "alpha_deg"]
    for row in levels:
        inside = [p for p in predicted if float(row["from"]) <= float(strokes[p["stroke_id"]]["alpha_deg"]) <= float(row["to"])]
        assert len(inside) == int(row["readings"])
        size = [
            math.sqrt(sum(math.log(float(strokes[p["stroke_id"]]["force_n"]) / float(p[column])) ** 2 for p in inside))
            for column in ("heldout_before_n", "heldout_after_n")
        ]
        shrinks = float(row["normalised_rmse_after"]) / float(row["normalised_rmse_before"])
        assert math.isclose(size[1] / size[0], shrinks, rel_tol=0.1)


@pytest.mark.parametrize("name", NAMES)
def test_predictions_are_repeated_from_the_model_file(diagnosed, soilctl, name):
    answer, out = diagnosed[name]
    strokes = CAMPAIGNS / name / "strokes.csv"
    replay = soilctl.json("predict", "--strokes", strokes, "--model-file", answer["patch"])["strokes"]
    predicted = rows(out / "predictions.csv")
    squares = 0.0
    for again, first in zip(replay, predicted, strict=True):
        assert again["stroke_id"] == first["stroke_id"]
        assert math.isclose(again["force_n"], float(first["force_after_n"]), rel_tol=1e-12)
        squares += math.log(again["measured_n"] / again["force_n"]) ** 2
    assert math.isclose(math.sqrt(squares / len(replay)), answer["gap"]["after"], rel_tol=0.01)


def test_what_a_model_file_knows_is_held_and_not_looked_for(diagnosed, soilctl, validate, tmp_path):
    first, first_out = diagnosed["campaign_a"]
    known = [effect["id"] for effect in first["effects"]]
    assert known
    answer = soilctl.json("diagnose", CAMPAIGNS / "campaign_a", "--model-file", first["patch"], "--out", tmp_path)
    validate(answer)
    assert (answer["status"], answer["effects"]) == ("none", [])
    assert answer["known_effects"] == known and answer["model_file"] == first["patch"]
    assert not set(known) & {of["id"] for of in answer["testability"]}
    assert math.isclose(answer["gap"]["before"], first["gap"]["after"], rel_tol=0.01)
    # The new file has what was known, to the digit, and forces that it repeats.
    files = [json.loads((out / "patch.json").read_text(encoding="utf-8")) for out in (first_out, tmp_path)]
    assert files[1]["effects"] == files[0]["effects"] and files[1]["model"] == files[0]["model"]
    for old, new in zip(rows(first_out / "predictions.csv"), rows(tmp_path / "predictions.csv"), strict=True):
        assert math.isclose(float(old["force_after_n"]), float(new["force_before_n"]), rel_tol=5e-3)
    assert ", ".join(known) in (tmp_path / "report.html").read_text(encoding="utf-8")
    both = soilctl("diagnose", CAMPAIGNS / "campaign_a", "--model", "chen", "--model-file", first["patch"])
    assert both.returncode == 2 and "--model-file" in both.stderr
    broken = tmp_path / "broken.json"
    broken.write_text(json.dumps({**files[0], "model": "no-such"}), encoding="utf-8")
    unknown = soilctl("diagnose", CAMPAIGNS / "campaign_a", "--model-file", broken)
    assert unknown.returncode == 2 and "no-such" in unknown.stderr


def test_taking_the_effect_out_leaves_the_plain_model(diagnosed, soilctl, tmp_path):
    answer, _ = diagnosed["campaign_a"]
    with open(answer["patch"], encoding="utf-8") as file:
        patch = json.load(file)
    patch["effects"] = []
    plain = tmp_path / "plain.json"
    plain.write_text(json.dumps(patch), encoding="utf-8")
    place = ["--alpha", 80, "--depth", 0.02, "--width", 0.127]
    soil = ["--phi", patch["soil"]["phi_deg"]["value"], "--delta", 20]
    density = ["--density", patch["soil"]["density_kg_m3"]["value"]]
    ours = soilctl.json("predict", "--model-file", plain, "--delta", 20, *place)
    theirs = soilctl.json("predict", "--model", patch["model"], "--ends", "none", *soil, *density, *place)
    assert math.isclose(ours["force_n"], theirs["force_n"], rel_tol=1e-9)


def test_estimate_takes_the_effects_out(diagnosed, soilctl, tmp_path):
    answer, _ = diagnosed["campaign_a"]
    strokes = tmp_path / "strokes.csv"
    strokes.write_bytes((DATA / "soils" / "ticino_rained" / "strokes.csv").read_bytes())
    options = ["--delta", 23, "--density", 1600]
    plain = soilctl.json("estimate", strokes, *options)
    patched = soilctl.json("estimate", strokes, *options, "--model-file", answer["patch"])
    assert plain["phi_deg"] != patched["phi_deg"]
    assert patched["ends"] == "finite"
    with open(answer["patch"], encoding="utf-8") as file:
        patch = json.load(file)
    sides_of = {"value": 0.5, "sd": 0.1, "unit": "1"}
    patch["effects"] = [{"id": "side_effects_3d", "parameters": {"kappa": sides_of}, "shape": 0.0, "log_bayes_factor": 5.0}]
    sides = tmp_path / "sides.json"
    sides.write_text(json.dumps(patch), encoding="utf-8")
    assert soilctl.json("estimate", strokes, *options, "--model-file", sides)["ends"] == "none"
    soilctl.refuses("estimate", strokes, *options, "--model-file", sides, "--ends", "finite", mentions=["count it again"])


def test_what_has_no_name_is_a_term_of_the_model_file(soilctl, tmp_path, validate):
    """Every other stroke of a preparation meets stronger soil: nothing of the catalogue does that."""
    folder = tmp_path / "alternating"
    shutil.copytree(CAMPAIGNS / "campaign_c", folder)
    strokes = folder / "strokes.csv"
    found = rows(strokes)
    for row in found:
        row["force_n"] = float(row["force_n"]) * (1.3 if int(row["order"]) % 2 else 1)
    save(strokes, found)
    out = tmp_path / "out"
    answer = soilctl.json("diagnose", folder, "--out", out)
    validate(answer)
    assert answer["status"] == "unknown" and answer["equivalence_set"][0] == "unknown:order"
    (term,) = answer["empirical"]
    assert term["over"] == ["order"] and term["at"] == [[1, 2, 3, 4, 5, 6]]
    odd, even = term["ln_force"][::2], term["ln_force"][1::2]
    # What was put in is within three standard deviations of what is found; the hidden effect of the campaign is a part of the rest.
    assert abs(min(odd) - max(even) - math.log(1.3)) < 3 * math.hypot(max(term["sd"]), max(term["sd"]))
    assert answer["effects"] == [] and answer["nearest"]
    gap = answer["gap"]
    assert gap["heldout_after"] < 0.6 * gap["heldout_before"]
    patch = json.loads((out / "patch.json").read_text(encoding="utf-8"))
    assert patch["empirical"][0]["ln_force"] == term["ln_force"]
    assert "An empirical term" in (out / "report.html").read_text(encoding="utf-8")
    # The model file says the same of these strokes, and that it knows nothing of others.
    said = soilctl.json("predict", "--strokes", strokes, "--model-file", answer["patch"])
    squares = [math.log(stroke["ratio"]) ** 2 for stroke in said["strokes"]]
    assert math.isclose(math.sqrt(sum(squares) / len(squares)), gap["after"], rel_tol=0.02)
    assert not any("lie beyond" in note for note in said["notes"])
    alone = soilctl.json("predict", "--alpha", 80, "--depth", 0.02, "--width", 0.127, "--model-file", answer["patch"])
    assert any("1 of 1 strokes lie beyond" in note for note in alone["notes"])
    # Beside the term nothing of it is found again, and the next model file carries it on.
    again = soilctl.json("diagnose", folder, "--model-file", answer["patch"], "--out", tmp_path / "again")
    assert again["known_effects"] == ["a term over order"] and again["beyond_known"] is None
    assert "unknown:order" not in again["equivalence_set"]
    assert again["gap"]["before"] < 1.1 * gap["after"]
    carried = json.loads((tmp_path / "again" / "patch.json").read_text(encoding="utf-8"))
    assert carried["empirical"] == patch["empirical"]
    found[0]["order"] = 40
    save(strokes, found)
    region = soilctl.json("estimate", strokes, "--model-file", answer["patch"])
    assert any("1 of 48 strokes lie beyond" in warning for warning in region["warnings"])
    again = soilctl.json("diagnose", folder, "--model-file", answer["patch"], "--out", tmp_path / "beyond")
    assert "1 of 48 strokes lie beyond" in again["beyond_known"]


def test_the_next_experiment_has_the_columns_of_a_stroke_table(diagnosed):
    for answer, _ in diagnosed.values():
        following = answer["next_experiment"]
        assert 0 <= following["power"] <= 1
        design = rows(following["design_csv"])
        assert {"batch", "alpha_deg", "depth_m", "width_m"} <= set(design[0]) and "force_n" not in design[0]


def test_the_same_campaign_gives_the_same_files(diagnosed, soilctl, tmp_path):
    _, out = diagnosed["campaign_b"]
    soilctl("diagnose", CAMPAIGNS / "campaign_b", "--out", tmp_path, code=0)
    for name in ["patch.json", "predictions.csv", "gap.csv", "next_experiment.csv"]:
        assert (tmp_path / name).read_bytes() == (out / name).read_bytes()


def test_published_soils_are_not_firmly_named(soilctl, tmp_path):
    for soil in ["ticino_loose", "ticino_rained", "nevada_fine", "glass_beads"]:
        answer = soilctl.json("diagnose", DATA / "soils" / soil, "--out", tmp_path / soil)
        assert answer["status"] == "not_testable"
        assert answer["effects"] == []


def plain_campaign(soilctl, folder):
    """Forces from the model itself, scattered here: a generator that shares nothing with the program."""
    source = rows(CAMPAIGNS / "campaign_a" / "strokes.csv")
    keep = ["stroke_id", "batch", "order", "time_s", "alpha_deg", "depth_m", "width_m", "speed_mps", "delta_set_deg"]
    table = folder / "strokes.csv"
    plain = ["predict", "--model", "table", "--phi", 37, "--delta", "column", "--density", 1500, "--strokes"]
    forces = soilctl.json(*plain, CAMPAIGNS / "campaign_a" / "strokes.csv")["strokes"]
    chance = random.Random(4)
    with open(table, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [*keep, "force_n"])
        writer.writeheader()
        for row, force in zip(source, forces, strict=True):
            scattered = force["force_n"] * math.exp(chance.gauss(0, 0.06))
            writer.writerow({**{name: row[name] for name in keep}, "force_n": scattered})
    return rows(table)


def test_forces_without_an_effect_are_not_named(soilctl, tmp_path):
    plain_campaign(soilctl, tmp_path)
    answer = soilctl.json("diagnose", tmp_path, "--out", tmp_path / "out")
    assert answer["status"] in {"none", "ambiguous"}
    assert answer["traces"] == 0


def test_free_play_is_found_in_the_traces_alone(soilctl, tmp_path, validate):
    strokes = plain_campaign(soilctl, tmp_path)
    instrument = {"joint_stiffness_n_per_m": 10000, "gap_sd": 0.0002}
    (tmp_path / "campaign.json").write_text(json.dumps({"instrument": instrument}), encoding="utf-8")
    chance = random.Random(5)
    with open(tmp_path / "traces.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["stroke_id", "t_s", "x_ext_m", "x_mtr_m", "force_n", "friction_angle_deg", "z_m"])
        for row in strokes:
            full, depth = float(row["force_n"]), float(row["depth_m"])
            for i in range(300):
                x = depth * 0.003 * max(i - 30, 0)
                force = full * min(1.0, math.sqrt(x / (0.2 * depth))) * (1 + chance.gauss(0, 0.01))
                motor = x + force / 10000 + (0.0008 if force > 0.05 * full else 0.0) + chance.gauss(0, 5e-5)
                angle = float(row["delta_set_deg"]) + chance.gauss(0, 1)
                writer.writerow([row["stroke_id"], 0.02 * i, x, motor, force, angle, -depth])
    answer = soilctl.json("diagnose", tmp_path, "--out", tmp_path / "out")
    validate(answer)
    assert answer["traces"] == len(strokes)
    backlash = {effect["id"]: effect for effect in answer["effects"]}["backlash"]
    gap = backlash["parameters"]["gap_m"]
    assert abs(gap["value"] - 0.0008) < 3 * gap["sd"] + 1e-4
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert "Displacement since the force began to rise" in page


def test_traces_that_cannot_be_meant_are_refused(soilctl, tmp_path):
    plain_campaign(soilctl, tmp_path)
    bad = tmp_path / "bad.csv"
    bad.write_text("stroke_id,t_s,x_ext_m,force_n\ns01,0,0,1\ns01,0,0,1\n", encoding="utf-8")
    soilctl.refuses("diagnose", tmp_path, "--traces", bad, mentions=["bad.csv", "line 3", "t_s"])
    soilctl.refuses("diagnose", tmp_path, "--logs", tmp_path, mentions=[".mcap", "--logs"])
    soilctl.refuses("diagnose", tmp_path, "--logs", tmp_path, "--no-resimulate", mentions=["--logs", "--no-resimulate"])


def test_logs_that_are_not_of_the_strokes_are_said_not_to_be_compared(soilctl, tmp_path):
    plain_campaign(soilctl, tmp_path)
    plain = soilctl.json("diagnose", tmp_path, "--out", tmp_path / "out")
    assert plain["resimulated"] == "no_logs" and plain["signals"] == []
    (tmp_path / "other.mcap").write_bytes(b"no log")
    beside = soilctl("diagnose", tmp_path, "--out", tmp_path / "out", code=0)
    assert "signals were not compared" in beside.stdout and "other.mcap" in beside.stdout
    answer = soilctl.json("diagnose", tmp_path, "--out", tmp_path / "out")
    assert answer["resimulated"] == "not_possible" and "other.mcap" in answer["not_resimulated_because"]
    soilctl.refuses("diagnose", tmp_path, "--logs", tmp_path, mentions=["other.mcap"])
    alone = soilctl.json("diagnose", tmp_path, "--no-resimulate", "--out", tmp_path / "out")
    assert alone["resimulated"] == "not_wanted" and alone["not_resimulated_because"] is None


def test_refuses_what_is_not_there(soilctl, tmp_path):
    soilctl.refuses("diagnose", tmp_path, mentions=["strokes.csv"])
    soilctl.refuses("diagnose", CAMPAIGNS / "campaign_a", "--model", "magic", mentions=["magic", "table"])


# Last, because this opens what is sealed.
@pytest.mark.parametrize("name", NAMES)
def test_what_was_sealed_is_what_was_found(diagnosed, name):
    answer, _ = diagnosed[name]
    with open(CAMPAIGNS / "sealed" / f"{name}.json", encoding="utf-8") as file:
        hidden = json.load(file)["hidden"]
    assert answer["status"] == "named"
    assert [effect["id"] for effect in answer["effects"]] == [effect["id"] for effect in hidden]
    amplitudes = [value for value in answer["effects"][0]["parameters"].items() if value[0] != "decay_m"]
    (_, amplitude), = amplitudes
    assert abs(amplitude["value"] - hidden[0]["size"]) <= 3 * amplitude["sd"]
