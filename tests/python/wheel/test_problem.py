"""The builder of problem files: whatever a file can say, and nothing else."""

import json
import keyword
import tomllib
from pathlib import Path

import numpy as np
import pytest
import soilctl
from soilctl import use_cases
from soilctl.problem import Problem

ROOT = Path(__file__).parents[3]
FILES = sorted((ROOT / "data/problems").glob("*.toml"))
SINGLE = ("title", "default_boundary", "surcharge_kpa", "surcharge_action")


def arguments(entry):
    return {key + "_" if keyword.iskeyword(key) else key: value for key, value in entry.items()}


def built(file):
    """A problem with the entries of a file."""
    problem = Problem(**{key: value for key, value in file.items() if key in SINGLE})
    for key, entries in file.items():
        if key in (*SINGLE, "schema"):
            continue
        if key == "objective":
            rest = arguments(entries)
            name = f"objective_{rest.pop('kind').replace('-', '_')}"
            problem = getattr(problem, name)(**rest)
        else:
            for entry in entries if isinstance(entries, list) else [entries]:
                problem = getattr(problem, key)(**arguments(entry))
    return problem


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_shipped_problem_can_be_built(path, tmp_path):
    file = tomllib.loads(path.read_text(encoding="utf-8"))
    problem = built(file)
    assert set(problem) == set(file) - {"schema"}
    written = tmp_path / "built.json"
    problem.write(written)
    from_python, from_file = use_cases.solve_check(written), use_cases.solve_check(path)
    assert from_python.to_dict() == from_file.to_dict()


def cut(cohesion_kpa, outline):
    return (
        Problem("cut in clay", default_boundary="fixed")
        .soil("clay", phi_deg=0, unit_weight_kn_m3=18, cohesion_kpa=cohesion_kpa)
        .region("clay", outline)
        .boundary("free", line=outline[[1, 0, 5, 4]] if isinstance(outline, np.ndarray) else [outline[i] for i in (1, 0, 5, 4)])
        .objective_strength_reduction()
    )


def test_a_cut_is_solved_as_it_is():
    outline = np.array([[0.0, 3.0], [-9.0, 3.0], [-9.0, -4.0], [6.0, -4.0], [6.0, 0.0], [0.0, 0.0]])
    problem = cut(np.float64(20.0), outline)
    bracket = soilctl.solve(problem, max_gap=0.05)
    # Martin (2011): 3.7764 to 3.7776 is what a cut's weight over its cohesion may be.
    assert bracket.lower <= 3.777 * 20 / 54 * 1.001 and bracket.upper >= 3.777 * 20 / 54 * 0.999
    # Numbers of numpy and of Python are the same file, and what is changed later changes nothing.
    assert problem == cut(20.0, outline.tolist())
    outline[0, 0] = 1.0
    problem["soil"].append({})
    assert problem == cut(20.0, [[0.0, 3.0], [-9.0, 3.0], [-9.0, -4.0], [6.0, -4.0], [6.0, 0.0], [0.0, 0.0]])


def test_a_problem_is_never_changed():
    ground = Problem("ground").soil("sand", phi_deg=30, unit_weight_kn_m3=18)
    dry, wet = ground, ground.water([[0, 1], [5, 1]]).soil("clay", phi_deg=0, unit_weight_kn_m3=20)
    assert "water" not in dry and len(dry["soil"]) == 1 and len(wet["soil"]) == 2
    assert repr(wet) == "<Problem 'ground': 2 soil>" and repr(Problem()) == "<Problem: empty>"
    assert json.loads(wet.to_json()) == dict(wet)


def test_what_no_file_may_say_is_refused(tmp_path):
    with pytest.raises(TypeError, match="friction"):
        Problem().soil("sand", friction=30)
    with pytest.raises(TypeError, match="unit_weight_kn_m3"):
        Problem().soil("sand", phi_deg=30)
    with pytest.raises(soilctl.InputError, match="json"):
        Problem().write(tmp_path / "problem.toml")
    with pytest.raises(soilctl.InputError, match="objective"):
        soilctl.solve(Problem().soil("sand", phi_deg=30, unit_weight_kn_m3=18))
