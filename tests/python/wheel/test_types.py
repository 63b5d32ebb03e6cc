"""Types, stubs, documentation and import time of the installed package."""

import inspect
import subprocess
import sys
from pathlib import Path

import soilctl

SOURCES = Path(__file__).parents[3] / "crates" / "py"
SETTINGS = SOURCES / "pyproject.toml"


def run(*words, cwd):
    done = subprocess.run([sys.executable, *words], cwd=cwd, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_stubs_are_what_is_there(tmp_path):
    # They show the arguments for arrays, and are typed for tables as well.
    (tmp_path / "allowed").write_text(r"soilctl(\._strokes)?\.(predict|estimate)" + "\n")
    words = ["--mypy-config-file", str(SETTINGS), "--allowlist", "allowed"]
    run("-m", "mypy.stubtest", "soilctl", *words, cwd=tmp_path)


def test_the_package_is_typed(tmp_path):
    run("-m", "mypy", "--config-file", str(SETTINGS), "--cache-dir", str(tmp_path), cwd=SOURCES)


def test_all_that_is_public_is_documented():
    for name in soilctl.__all__:
        thing = getattr(soilctl, name)
        if inspect.isclass(thing) or callable(thing):
            assert inspect.getdoc(thing), name
            if inspect.isclass(thing) and thing.__module__.startswith("soilctl"):
                members = [m for m in vars(thing) if not m.startswith("_")]
                missing = [m for m in members if not inspect.getdoc(getattr(thing, m))]
                assert not missing, f"{name}: {missing}"


def test_signatures_show_their_numbers():
    for function in (soilctl.bound, soilctl.estimate, soilctl.Plant, soilctl.solve, soilctl.predict):
        shown = str(inspect.signature(function))
        assert "Ellipsis" not in shown and "..." not in shown, shown
    assert inspect.signature(soilctl.bound).parameters["gravity_m_s2"].default == 9.80665
    assert inspect.signature(soilctl.estimate).parameters["gravity_m_s2"].default == 9.80665
    assert inspect.signature(soilctl.Plant).parameters["surface_z_m"].default == -0.3302


def test_the_import_is_light(tmp_path, record_property):
    script = "import time; t = time.perf_counter(); import soilctl, sys; print(time.perf_counter() - t, *sys.modules)"
    seconds, *modules = run("-c", script, cwd=tmp_path).split()
    heavy = {"matplotlib", "pandas", "gymnasium", "distributed", "meshio", "pyvista", "tqdm", "xarray"} & set(modules)
    assert not heavy, "optional parts are imported when they are used"
    # Told, not asserted: the machine may be busy.
    record_property("import_seconds", float(seconds))
    print(f"import soilctl: {seconds} s")
