"""`soilctl bound` and `solve`: what they write, read back by programs of others."""

import json
import math
import re
import signal
import subprocess
import time
from pathlib import Path

import meshio
import numpy as np
import pytest
from scipy.optimize import brentq

PLATE = ["--alpha", 90, "--phi", 30, "--delta", 15]
BUDGET = ["--max-elements", 1500, "--max-gap", 0.03]


@pytest.fixture(scope="module")
def solved(soilctl, tmp_path_factory):
    """The folder and the answer of a plate with all its files."""
    folder = tmp_path_factory.mktemp("plate")
    files = ["--vtu", "plate.vtu", "--mesh", "plate.msh", "--save", "plate.json", "--plot", "plate.svg"]
    answer = soilctl.json("bound", *PLATE, *BUDGET, *files, cwd=folder)
    return folder, answer


@pytest.fixture(scope="module")
def vtu(solved):
    return meshio.read(solved[0] / "plate.vtu")


def areas(mesh):
    """Areas of straight triangles, from their corners."""
    corners = mesh.points[mesh.cells[0].data[:, :3]]
    (x, y), (u, v) = ((corners[:, i, :2] - corners[:, 0, :2]).T for i in (1, 2))
    return 0.5 * (x * v - y * u)


def test_the_answer_follows_the_schema_and_names_its_files(solved, validate):
    validate(solved[1])
    assert solved[1]["results"]["files"] == ["plate.svg", "plate.vtu", "plate.msh"]
    assert all((solved[0] / name).stat().st_size > 0 for name in solved[1]["results"]["files"])


def test_triangles_fill_the_soil_that_the_mesh_stands_for(vtu, solved):
    statement = json.loads((solved[0] / "plate.json").read_text())["statement"]
    points = np.array(statement["points"])
    width, height = points.max(axis=0) - points.min(axis=0)
    assert [block.type for block in vtu.cells] == ["triangle6"]
    assert (areas(vtu) > 0).all()
    assert areas(vtu).sum() == pytest.approx(width * height, rel=1e-9)
    assert len(vtu.cells[0].data) == solved[1]["upper_elements"]


def test_the_weight_lifted_is_the_upper_bound(vtu, solved):
    # Sand without cohesion dissipates nothing, so the force at unit speed is the rate at which weight is lifted. A
    # quadratic function has its mean over a triangle in the middles of the edges.
    middles = vtu.cells[0].data[:, 3:]
    lifted = (areas(vtu) * vtu.point_data["velocity"][middles, 1].mean(axis=1)).sum()
    coefficient = 2 * lifted / math.sin(math.radians(90 + 15))
    assert coefficient == pytest.approx(solved[1]["upper"], rel=1e-6)
    assert np.abs(vtu.cell_data["dissipation"][0]).max() == 0


def test_the_soil_bears_the_stresses_and_they_are_in_principal_axes(vtu):
    stress = vtu.point_data["stress"].reshape(-1, 3, 3)
    assert (stress == stress.transpose(0, 2, 1)).all() and (stress[:, 2] == 0).all()
    least, most = np.linalg.eigvalsh(stress[:, :2, :2]).T
    assert vtu.point_data["principal_major"] == pytest.approx(-least, abs=1e-12)
    assert vtu.point_data["principal_minor"] == pytest.approx(-most, abs=1e-12)
    ratio = math.tan(math.radians(60)) ** 2
    assert (-least <= ratio * -most + 1e-9).all()
    # In equilibrium with the weight: what is deep is pressed.
    deep = vtu.points[:, 1] < -4
    assert (-least[deep] > 2).all()


@pytest.fixture(scope="module")
def ended(soilctl, tmp_path_factory):
    """Meshes in space, and the answer, of a plate five times as wide as deep."""
    folder = tmp_path_factory.mktemp("ended")
    budget = ["--max-elements", 1000, "--max-gap", 0.2, "--tetrahedra", 200]
    answer = soilctl.json("bound", *PLATE, *budget, "--width-ratio", 5, "--vtu", "plate.vtu", cwd=folder)
    return [meshio.read(folder / f"plate.{word}.vtu") for word in ("blocks", "end")], answer


def test_blocks_in_space_lift_the_weight_that_is_the_upper_bound(ended):
    (mesh, _), answer = ended
    triangles = mesh.cells_dict["triangle"]
    # The volume inside closed facets, by Gauss; the other half of the plate lifts as much.
    volumes = np.linalg.det(mesh.points[triangles]) / 6
    lifted = 2 * abs((volumes * mesh.point_data["velocity"][triangles[:, 0], 2]).sum()) / 5
    assert 2 * lifted / math.sin(math.radians(90 + 15)) == pytest.approx(answer["upper"], rel=1e-6)


def test_the_stress_about_an_end_is_in_equilibrium_and_borne(ended):
    (_, mesh), answer = ended
    assert answer["lower_proof"] == "space"
    tetrahedra = mesh.cells_dict["tetra"]
    assert len(tetrahedra) == 4 * answer["end"]["tetrahedra"]
    corners = mesh.points[tetrahedra]
    ways = corners[:, 1:] - corners[:, :1]
    size = mesh.points.max(axis=0) - mesh.points.min(axis=0)
    assert np.abs(np.linalg.det(ways)).sum() / 6 == pytest.approx(size.prod(), rel=1e-9)
    stress = mesh.point_data["stress"].reshape(-1, 3, 3)
    assert stress == pytest.approx(stress.transpose(0, 2, 1), abs=1e-9)
    # Tension is positive: the divergence is the weight, 1 along z, in each tetrahedron.
    steps = stress[tetrahedra[:, 1:]] - stress[tetrahedra[:, :1]]
    gradients = np.linalg.solve(ways, steps.reshape(-1, 3, 9)).reshape(-1, 3, 3, 3)
    assert np.einsum("tjij->ti", gradients) == pytest.approx(np.tile([0, 0, 1.0], (len(ways), 1)), abs=1e-6)
    pressures = np.linalg.eigvalsh(-stress)
    assert (pressures[:, 2] <= 3 * pressures[:, 0] + 1e-9).all()
    assert mesh.point_data["principal_minor"] == pytest.approx(pressures[:, 0], abs=1e-9)
    assert mesh.point_data["principal_major"] == pytest.approx(pressures[:, 2], abs=1e-9)


def test_soil_data_are_those_of_the_problem(vtu):
    assert set(vtu.cell_data["region"][0]) == {0}
    assert set(vtu.cell_data["phi_deg"][0]) == {30.0}
    assert set(vtu.cell_data["unit_weight"][0]) == {1.0}
    assert (vtu.cell_data["shear_rate"][0] >= 0).all() and vtu.cell_data["shear_work"][0].max() > 0.1


def test_gmsh_files_hold_the_same_mesh_with_its_groups(vtu, solved):
    mesh = meshio.read(solved[0] / "plate.msh")
    triangles = mesh.cells_dict["triangle"]
    assert len(triangles) == solved[1]["upper_elements"]
    corners = mesh.points[triangles][:, :, :2]
    sides = corners[:, 1:] - corners[:, :1]
    area = 0.5 * np.linalg.det(sides)
    assert area == pytest.approx(areas(vtu), rel=1e-12)
    assert {"line 0", "region 0", "guides"} <= set(mesh.field_data)


def test_a_saved_solution_is_shown_as_it_was_solved(solved, soilctl, validate):
    folder = solved[0]
    proof = soilctl.json("certify", "plate.json", "--vtu", "again.vtu", "--mesh", "again.msh", cwd=folder)
    validate(proof)
    assert proof["certified"] and proof["files"] == ["again.vtu", "again.msh"]
    assert (folder / "again.vtu").read_bytes() == (folder / "plate.vtu").read_bytes()
    assert (folder / "again.msh").read_bytes() == (folder / "plate.msh").read_bytes()


def test_a_page_shows_all_figures_and_they_can_be_zoomed(solved, soilctl, open_page):
    folder = solved[0]
    soilctl("certify", "plate.json", "--plot", "all.html", "--plot-kind", "all", cwd=folder, code=0)
    page = open_page(folder / "all.html")
    page.wait_for_selector(".js-plotly-plot .main-svg")
    assert page.locator(".js-plotly-plot").count() == 4
    x_range = "document.querySelector('.js-plotly-plot')._fullLayout.xaxis.range"
    before = page.evaluate(x_range)
    page.evaluate("document.querySelector('.js-plotly-plot').querySelector('[data-title=\"Zoom in\"]').click()")
    page.wait_for_function(f"({x_range})[1] < {before[1]}")
    assert page.problems == [] and page.requests == []


def test_solve_writes_in_the_coordinates_of_its_file(soilctl, validate, tmp_path, data):
    wall = data / "problems" / "wall_passive.toml"
    budget = ["--max-elements", 1000, "--max-gap", 0.5]
    answer = soilctl.json("solve", wall, *budget, "--vtu", tmp_path / "wall.vtu")
    validate(answer)
    mesh = meshio.read(tmp_path / "wall.vtu")
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    assert (low[:2] == pytest.approx([0, -3], abs=1e-9)) and (high[:2] == pytest.approx([24, 0], abs=1e-9))
    assert mesh.cell_data["unit_weight"][0] == pytest.approx(18)
    [ground] = answer["results"]["moving_ground"]
    assert ground["from"] == pytest.approx([0, 0], abs=1e-9) and 4 < ground["to"][0] < 20
    [face] = answer["results"]["contacts"]
    assert face["face"] == "front" and face["length"] == pytest.approx(3)
    # The wall is pushed level: the pressure's resultant is the force.
    assert face["normal_force"] == pytest.approx(answer["lower"], rel=1e-9)


def test_a_run_stays_in_the_memory_it_was_given(soilctl, tmp_path):
    limit_mb = 200
    arguments = ["bound", *PLATE, "--max-gap", 1e-4, "--max-memory", limit_mb, "--format", "json"]
    peak_kb = 0
    with (tmp_path / "answer.json").open("w") as answer:
        run = subprocess.Popen([soilctl.binary, *map(str, arguments)], stdout=answer, stderr=subprocess.DEVNULL)
        # What the system reports after the end would include this interpreter, whose memory the child begins with.
        while run.poll() is None:
            found = re.search(r"VmHWM:\s+(\d+) kB", Path(f"/proc/{run.pid}/status").read_text())
            peak_kb = int(found[1]) if found else peak_kb
            time.sleep(0.005)
    assert run.returncode == 3
    assert 50e6 < peak_kb * 1024 < limit_mb * 1e6
    ended = json.loads((tmp_path / "answer.json").read_text())
    assert ended["ended"] == "memory" and ended["certified"]


@pytest.mark.parametrize("verb", ["bound", "solve"])
@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_run_with_the_best_bounds_so_far(soilctl, data, which, verb):
    problem = PLATE if verb == "bound" else [data / "problems" / "wall_passive.toml"]
    words = [verb, *problem, "--max-gap", 1e-9, "--max-elements", 1_000_000, "--max-work", 10**12, "--format", "json"]
    run = subprocess.Popen(
        [soilctl.binary, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    time.sleep(6.0)
    run.send_signal(which)
    out, notes = run.communicate(timeout=120)
    # On a slow machine there may be no bounds yet; then it is said.
    assert run.returncode in (2, 3), notes
    if run.returncode == 3:
        answer = json.loads(out)
        assert (answer["ended"], answer["stopped_by"]) == ("stopped", "user")
        assert answer["certified"] and 0 < answer["lower"] < answer["upper"]


def test_the_users_clock_is_told(soilctl, validate):
    seconds = 2
    while (run := soilctl("bound", *PLATE, "--max-gap", 1e-9, "--max-seconds", seconds, "--format", "json")).returncode == 2:
        seconds *= 2
    answer = json.loads(run.stdout)
    validate(answer)
    assert run.returncode == 3
    assert (answer["ended"], answer["stopped_by"]) == ("time", "seconds")
    text = soilctl("bound", *PLATE, "--max-gap", 1e-9, "--max-seconds", seconds).stdout
    assert "ended by the time allowed" in text


def test_a_case_that_falls_by_itself_ends_no_other(soilctl, tmp_path):
    """An upright cut of 4 m stands with 3.83 c / (weight height) (Taylor 1937): not with 2 kPa, and with 30 kPa it bears a load besides."""
    file = tmp_path / "cut.toml"
    file.write_text(
        """
default_boundary = "free"
objective = {kind = "load"}
[[soil]]
name = "clay"
phi_deg = 0
cohesion_kpa = 30
unit_weight_kn_m3 = 18
[[region]]
soil = "clay"
polygon = [[-6, -4], [14, -4], [14, 4], [0, 4], [0, 0], [-6, 0]]
[[boundary]]
kind = "fixed"
sides = ["left", "right", "bottom"]
[[boundary]]
kind = "load"
line = [[1, 4], [5, 4]]
pressure_kpa = 10
live = true
[[case]]
name = "weak"
set = {"soil.clay.cohesion_kpa" = 2}
[[case]]
name = "strong"
"""
    )
    answer = soilctl.json("solve", file, "--max-gap", 0.1, code=3)
    weak, strong = answer["cases"]
    assert weak["lower"] is None and "fails under its own weight" in weak["problem"]
    assert strong["problem"] is None and 0 < strong["lower"] <= strong["upper"]


def test_friction_that_falls_with_stress_is_that_of_rankine_at_each_depth(soilctl, validate, tmp_path):
    """Smooth and upright: each depth has the pressures whose circle touches the curve of strength, passive ahead and active behind."""
    unit_weight, depth = 1600 * 9.80665, 0.0254
    angles = np.linspace(0.0, math.pi, 300)[1:-1]

    def spare(least, greatest):
        middle, radius = (least + greatest) / 2, (greatest - least) / 2
        normal = middle + radius * np.cos(angles)
        return np.min(normal * np.tan(np.radians(np.minimum(55.0, 38.0 - 4.0 * np.log10(normal / 1000)))) - radius * np.sin(angles))

    depths = (np.arange(60) + 0.5) / 60 * depth
    passive = [brentq(lambda most, v=unit_weight * z: spare(v, most), 1.01 * unit_weight * z, 12 * unit_weight * z) for z in depths]
    active = [brentq(lambda least, v=unit_weight * z: spare(least, v), unit_weight * z / 12, 0.99 * unit_weight * z) for z in depths]
    exact = 2 * (np.mean(passive) - np.mean(active)) * depth / (unit_weight * depth**2)
    words = ["bound", "--alpha", 90, "--phi", 38, "--delta", 0, "--density", 1600, "--depth", depth, "--friction-law", 4, "--reference-stress", 1000]
    answer = soilctl.json(*words, "--max-gap", 0.08, "--save", tmp_path / "law.json")
    validate(answer)
    assert answer["lower"] <= exact <= answer["upper"] <= 1.09 * answer["lower"]
    assert "and no more than these lines of friction and cohesion bear" in soilctl("certify", tmp_path / "law.json", code=0).stdout
    for more, said in [(["--width", 0.1], "is for plane strain"), (["--cohesion", 10], "cohesion in soil whose friction falls"), (["--phi", 80], "phi")]:
        assert said in soilctl(*words, *more, code=2).stderr
