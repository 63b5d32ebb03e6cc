"""Use cases as typed functions, tables in memory, and what is generated from the compiled module."""

import inspect
import json
import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import soilctl
from soilctl import _record, use_cases

ROOT = Path(__file__).parents[3]
DATA = ROOT / "data"
STROKES = DATA / "soils" / "ticino_rained" / "strokes.csv"
COMMAND = Path(sys.executable).with_name("soilctl")


def test_what_is_generated_is_up_to_date(monkeypatch):
    folder = ROOT / "crates" / "py" / "generate"
    monkeypatch.syspath_prepend(str(folder))
    files = runpy.run_path(str(folder / "__main__.py"))["files"]
    for path, text in files(soilctl._native).items():
        assert path.read_text(encoding="utf-8") == text, f"{path} is out of date: run crates/py/generate"


def test_every_use_case_teaches_its_arguments():
    for name, answer_id, request, answer in soilctl._native.use_case_schemas():
        function = getattr(use_cases, name.replace(" ", "_").replace("-", "_"))
        parameters = inspect.signature(function).parameters
        request, answer = json.loads(request), json.loads(answer)
        fields = request.get("properties", {})
        assert set(parameters) == {*fields, "progress"}
        told = inspect.getdoc(function)
        for key, about in fields.items():
            assert f"    {key}: " in told, f"{name}: {key}"
            default = about.get("default")
            if default is not None:
                given = parameters[key].default
                assert (list(given) if isinstance(given, tuple) else given) == default
        kind = inspect.get_annotations(function, eval_str=True)["return"]
        assert answer["properties"]["schema"]["const"] == answer_id
        assert {*answer["properties"], "exit_code"} <= set(kind.__dataclass_fields__) and inspect.getdoc(kind)


def test_answers_have_attributes_and_are_those_of_the_command():
    words = ["estimate", STROKES, "--delta", "23", "--density", "1600", "--model", "chen", "--next-strokes", "--format", "json"]
    done = subprocess.run([COMMAND, *words], capture_output=True, text=True, timeout=300, check=True)
    found = use_cases.estimate(STROKES, 23, density_kg_m3=1600, model="chen", next_strokes=True)
    told = json.loads(done.stdout)
    assert {key: value for key, value in found.to_dict().items() if value is not None and key != "exit_code"} == {
        key: value for key, value in told.items() if value is not None
    }
    assert found.exit_code == 0 == found["exit_code"] and found.consistent
    assert found.centre.phi_deg == found["centre"]["phi_deg"] == told["centre"]["phi_deg"]
    assert found.measurements[0].label == told["measurements"][0]["label"]
    assert isinstance(found.next_strokes[0], use_cases.EstimateNextStroke)
    assert set(found) == set(found.keys()) and {**found}["verdict"] == found.verdict and "none" not in found
    with pytest.raises(AttributeError):
        found.consistent = False
    assert "<table>" in found._repr_html_() and "EstimateAnswer(" in repr(found)


def test_words_that_python_keeps_are_attributes_with_a_line():
    told = {field: None for field in use_cases.ShearCarried.__dataclass_fields__ if field != "from_"} | {"from": "sigma_L"}
    found = _record.of_json(use_cases.ShearCarried, told)
    assert found.from_ == found["from"] == "sigma_L" and found.to_dict() == told


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: use_cases.estimate(STROKES, 23, density_tol=1.5), soilctl.InputError, "density_tol is 1.5"),
        (lambda: use_cases.estimate(STROKES, 23, density_tol=float("nan")), soilctl.InputError, "density_tol is nan"),
        (lambda: use_cases.estimate(STROKES, "row"), soilctl.InputError, "the word column"),
        (lambda: use_cases.estimate(STROKES, 23, model=object()), soilctl.InputTypeError, "model is of type object"),
        (lambda: use_cases.estimate(STROKES, 23, model=5), soilctl.InputTypeError, "string"),
        (lambda: use_cases.estimate("none.csv", 23), FileNotFoundError, "none.csv"),
        (lambda: use_cases.estimate([1.0], 23), soilctl.InputTypeError, "columns by name"),
        (lambda: use_cases.log_info("none.mcap"), FileNotFoundError, "none.mcap"),
        (lambda: soilctl._native.run_use_case("none", "{}"), soilctl.InputError, "no use case"),
        (lambda: soilctl._native.run_use_case("replay", '{"lgo": 1}'), soilctl.InputError, "lgo is unknown"),
    ],
)
def test_bad_requests_are_refused(call, error, words):
    with pytest.raises(error, match=words):
        call()


def test_a_log_is_exported_and_looked_into(tmp_path):
    with pytest.raises(soilctl.InputError, match=r"\.csv or \.parquet"):
        use_cases.log_export("log.mcap", tmp_path / "table.txt")


class Columns:
    """As polars has them: columns and no index."""

    def __init__(self, columns):
        self.of = columns

    @property
    def columns(self):
        return list(self.of)

    def __getitem__(self, name):
        return self.of[name]


def frame(pandas):
    found = pandas.read_csv(STROKES)
    found.index = [f"row {i}" for i in range(len(found))]
    return found


def test_strokes_in_memory_are_predicted():
    pandas = pytest.importorskip("pandas")
    strokes = frame(pandas)
    options = {"model": "table", "friction_angle_deg": 41.0, "interface_friction_deg": 23.0, "density_kg_m3": 1600.0}
    found = soilctl.predict(strokes, **options)
    assert isinstance(found, pandas.DataFrame) and list(found.index) == list(strokes.index)
    plates = {"depth_m": strokes.depth_m, "width_m": strokes.width_m, "tool_angle_deg": strokes.alpha_deg}
    arrays = soilctl.predict(**plates, **options)
    np.testing.assert_array_equal(found.k_net, arrays.coefficient)
    np.testing.assert_allclose(found.force_n, arrays.force_n, rtol=1e-12)
    np.testing.assert_array_equal(found.measured_n, strokes.force_n)
    named = {name: strokes[name].to_numpy() for name in strokes}
    for table in (named, Columns(named)):
        again = soilctl.predict(table, **options)
        np.testing.assert_array_equal(again["force_n"], found.force_n)
        assert type(again) is type(table)
    # What a table has is taken from there.
    table = {**{name: named[name] for name in ("alpha_deg", "depth_m", "width_m", "force_n")}, "delta_set_deg": np.full(len(strokes), 23.0)}
    again = soilctl.predict(table, model="table", friction_angle_deg=41.0)
    np.testing.assert_array_equal(again["k_net"], found.k_net)
    assert np.isnan(again["force_n"]).all()
    with pytest.raises(soilctl.InputError, match="friction|phi"):
        soilctl.predict(table)
    with pytest.raises(soilctl.InputError, match=r"the table, line 2.*width_m"):
        soilctl.predict({**table, "width_m": np.full(len(strokes), np.nan)}, friction_angle_deg=41.0)
    with pytest.raises(TypeError, match="tool_angle_deg"):
        soilctl.predict(table, tool_angle_deg=5)


def test_strokes_in_memory_are_estimated_as_from_their_file():
    pandas = pytest.importorskip("pandas")
    options = {"delta_deg": 23, "density_kg_m3": 1600, "model": "chen"}
    found, file = soilctl.estimate(frame(pandas), **options), use_cases.estimate(STROKES, **options)
    # Beside the file there may be a campaign.json, which a table in memory has not; strokes that are made tell nothing of it.
    assert isinstance(found, use_cases.EstimateAnswer) and found.region == file.region
    assert [m.label for m in found.measurements] == [m.label for m in file.measurements]
    arrays = soilctl.estimate(
        tool_angle_deg=[70, 90], depth_m=0.02, width_m=0.1, force_n=[4.0, 8.0], force_error_n=0.5, interface_friction_deg=(22, 24), model="chen"
    )
    assert isinstance(arrays, soilctl.Estimate)


def test_strokes_in_memory_are_diagnosed(tmp_path):
    pandas = pytest.importorskip("pandas")
    strokes = pandas.read_csv(DATA / "campaigns" / "campaign_a" / "strokes.csv").set_index("stroke_id", drop=False)
    found = soilctl.diagnose(strokes, out=tmp_path / "out")
    assert found["strokes"] == len(strokes) and (tmp_path / "out" / "patch.json").exists()
    assert list(found["predictions"].index) == list(strokes.index)
    assert found.patch == str(tmp_path / "out" / "patch.json")
    # Without a folder nothing is left behind, so no file is named.
    alone = soilctl.diagnose(strokes)
    assert (alone.patch, alone.report, alone.status) == (None, None, found.status)
    assert (found["predictions"].force_after_n > 0).all()
    again = soilctl.predict(strokes, model_file=tmp_path / "out" / "patch.json")
    np.testing.assert_allclose(again.force_n, found["predictions"].force_after_n, rtol=1e-12)
    with pytest.raises(soilctl.InputTypeError, match="columns by name"):
        soilctl.diagnose([1.0])


def test_variables_with_axes_have_units_and_names():
    xarray = pytest.importorskip("soilctl.xarray")
    found = xarray.predict(
        "table", tool_angle_deg=[70.0, 80.0], friction_angle_deg=[32.0, 40.0], interface_friction_deg=20.0, density_kg_m3=1600.0,
        depth_m=0.02, width_m=0.1,
    )
    units = {name: variable.attrs["units"] for name, variable in found.variables.items()}
    assert units["force_upper_n"] == "N" and units["coefficient"] == "1" and units["tool_angle_deg"] == "deg"
    assert all(variable.attrs["long_name"] for variable in found.variables.values())
    assert found["coefficient"].attrs["long_name"] == "net coefficient per slant length"
