"""`soilctl convert`: drawings made and read by another author's library, and areas by a third one's."""

import io
import json
import tomllib

import ezdxf
import pytest
from conftest import DATA
from shapely.geometry import Polygon

# An embankment of sand on clay over rock, as an engineer's office has it: areas that nearly touch.
SECTION = {
    "sand": [[(0, 0), (14, 0), (6, 4), (0, 4)]],
    "stiff clay": [[(0, -6), (24, -6), (24, 0), (0, 0)]],
    "rock": [[(0, -9), (12, -9), (12, -6.0002), (0, -6.0001)], [(12.0003, -9), (24, -9), (24, -6), (12, -6)]],
}
WATER = [(0, -1), (24, -2)]
STRENGTHS = """name, phi_deg, cohesion_kpa, unit_weight_kn_m3
sand, 34, 1, 19
stiff clay, 0, 60, 18
rock, 40, 100, 22
"""
VERSIONS = ["R12", "R2000", "R2004", "R2010", "R2018"]
# R12 has no units, and metres are taken.
UNITS = {"m": (6, 1), "mm": (4, 1000), "cm": (5, 100), "ft": (2, 1 / 0.3048), "in": (1, 1 / 0.0254)}


def area(layer):
    return sum(Polygon(ring).area for ring in SECTION[layer])


def draw(path, version, unit="m", lines=False):
    """The section with ezdxf: closed polylines, or single lines in no order."""
    doc = ezdxf.new(version)
    code, scale = UNITS[unit]
    doc.header["$INSUNITS"] = code
    space = doc.modelspace()
    for layer, rings in SECTION.items():
        doc.layers.add(layer)
        for ring in rings:
            points = [(scale * x, scale * y) for x, y in ring]
            if lines:
                sides = list(zip(points, points[1:] + points[:1], strict=True))
                for i, (a, b) in enumerate(sides[::-1]):
                    space.add_line(*((a, b) if i % 2 else (b, a)), dxfattribs={"layer": layer})
            elif version == "R12":
                space.add_polyline2d(points, close=True, dxfattribs={"layer": layer})
            else:
                space.add_lwpolyline(points, close=True, dxfattribs={"layer": layer})
    water = [(scale * x, scale * y) for x, y in WATER[::-1]]
    space.add_polyline2d(water, dxfattribs={"layer": "Water table"})
    space.add_text("made ground", dxfattribs={"layer": "sand"}).set_placement((1, 1))
    doc.saveas(path)
    return path


@pytest.fixture
def strengths(tmp_path):
    path = tmp_path / "strengths.csv"
    path.write_text(STRENGTHS, encoding="utf-8")
    return path


@pytest.mark.parametrize("lines", [False, True], ids=["polylines", "lines"])
@pytest.mark.parametrize(("version", "unit"), [*zip(VERSIONS, UNITS, strict=True)])
def test_a_section_drawn_by_others_is_the_problem(soilctl, validate, strengths, tmp_path, version, unit, lines):
    drawing = draw(tmp_path / "section.dxf", version, unit, lines)
    out = tmp_path / "section.toml"
    found = soilctl.json("convert", drawing, "--out", out, "--soils", strengths)
    validate(found)
    assert found["unit"] == unit and found["has_water"] and found["is_complete"]
    assert {soil["name"]: soil["areas"] for soil in found["soils"]} == {"sand": 1, "stiff clay": 1, "rock": 2}
    for soil in found["soils"]:
        assert soil["area_m2"] == pytest.approx(area(soil["name"]), abs=0.02)
    assert [it["what"] for it in found["left_out"]] == ["TEXT"]
    problem = tomllib.loads(out.read_text(encoding="utf-8"))
    assert problem["water"]["table"][0] == pytest.approx(WATER[0])
    # What nearly touched does: the checker of problems sees one outline, without slivers.
    checked = soilctl.json("solve", out, "--check")
    assert checked["schema"].startswith("soilctl.solve-check/")


def test_without_strengths_they_are_asked_for_and_nothing_is_written_over(soilctl, tmp_path):
    drawing = draw(tmp_path / "section.dxf", "R2010")
    out = tmp_path / "section.toml"
    found = soilctl.json("convert", drawing, "--out", out, code=3)
    assert not found["is_complete"]
    assert any("sand, stiff clay, rock" in note for note in found["notes"])
    written = out.read_bytes()
    soilctl.refuses("convert", drawing, "--out", out, mentions=["--replace"])
    assert out.read_bytes() == written
    soilctl("convert", drawing, "--out", out, "--replace", code=3)
    # Soil without strength is never solved as if it had some.
    soilctl.refuses("solve", out, "--max-seconds", 5)


def test_what_is_no_area_is_told(soilctl, strengths, tmp_path):
    doc = ezdxf.new("R2013")
    space = doc.modelspace()
    space.add_lwpolyline([(0, 0), (10, 0), (10, -5), (0, -5)], close=True, dxfattribs={"layer": "sand"})
    space.add_line((0, 3), (4, 3), dxfattribs={"layer": "sand"})
    space.add_spline([(0, 0, 0), (1, 2, 0), (3, 3, 0)], dxfattribs={"layer": "rock"})
    hatch = space.add_hatch(dxfattribs={"layer": "sand"})
    hatch.paths.add_polyline_path([(0, 0), (1, 0), (1, 1)], is_closed=True)
    doc.blocks.new("tree").add_line((0, 0), (1, 1))
    space.add_blockref("tree", (3, 0))
    doc.layout("Layout1").add_line((0, 0), (1, 1), dxfattribs={"layer": "sand"})
    doc.saveas(tmp_path / "a.dxf")
    found = soilctl.json("convert", tmp_path / "a.dxf", "--out", tmp_path / "a.json", "--soils", strengths, code=3)
    kinds = {(it["layer"], it["what"]) for it in found["left_out"]}
    assert {("sand", "line"), ("rock", "SPLINE"), ("sand", "HATCH"), ("0", "INSERT")} <= kinds
    assert [soil["name"] for soil in found["soils"]] == ["sand"]
    assert any("stiff clay" in note for note in found["notes"])


def test_arcs_become_chords_of_the_same_area(soilctl, tmp_path):
    doc = ezdxf.new("R2000", units=6)
    # A circle of 4 m from two bulges of 1, and a stadium of two lines and two arcs.
    space = doc.modelspace()
    space.add_lwpolyline([(-4, 0, 1), (4, 0, 1)], format="xyb", close=True, dxfattribs={"layer": "disc"})
    layer = {"layer": "stadium"}
    space.add_line((10, 1), (20, 1), dxfattribs=layer)
    space.add_arc((20, 0), 1, 270, 90, dxfattribs=layer)
    space.add_line((10, -1), (20, -1), dxfattribs=layer)
    space.add_arc((10, 0), 1, 90, 270, dxfattribs=layer)
    doc.saveas(tmp_path / "arcs.dxf")
    options = ["--out", tmp_path / "arcs.json", "--chord", 0.001]
    found = soilctl.json("convert", tmp_path / "arcs.dxf", *options, code=3)
    sizes = {soil["name"]: soil["area_m2"] for soil in found["soils"]}
    assert sizes == pytest.approx({"disc": 50.265, "stadium": 20 + 3.1416}, rel=1e-3)
    assert any("chords" in note for note in found["notes"])


@pytest.mark.parametrize("name", ["embankment", "slope", "reinforced_cut", "wall_active"])
def test_problems_become_drawings_that_others_read(soilctl, tmp_path, name):
    problem = DATA / "problems" / f"{name}.toml"
    described = tomllib.loads(problem.read_text(encoding="utf-8"))
    out = tmp_path / "it.dxf"
    soilctl.json("convert", problem, "--out", out)
    doc = ezdxf.readfile(out)
    assert not doc.audit().errors
    assert doc.header["$INSUNITS"] == 6
    lines = list(doc.modelspace().query("LWPOLYLINE"))
    regions = [(line.dxf.layer, [(x, y) for x, y in line.get_points("xy")]) for line in lines if line.closed]
    wanted = [(region["soil"], [tuple(map(float, p)) for p in region["polygon"]]) for region in described["region"]]
    assert regions[: len(wanted)] == wanted
    # Written by ezdxf again, it is the same section.
    again = io.StringIO()
    doc.write(again)
    (tmp_path / "again.dxf").write_text(again.getvalue(), encoding="utf-8")
    bodies = ",".join(f"structure {body['name']}" for body in described.get("structure", []))
    soilctl("convert", tmp_path / "again.dxf", "--out", tmp_path / "again.json", f"--leave-out={bodies}", code=3)
    back = json.loads((tmp_path / "again.json").read_text(encoding="utf-8"))
    sizes = [sum(Polygon(r["polygon"]).area for r in it["region"]) for it in (described, back)]
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-12)


@pytest.mark.parametrize("ending", ["dxf", "geojson", "csv"])
def test_every_format_goes_there_and_back(soilctl, strengths, tmp_path, ending):
    drawing = draw(tmp_path / "section.dxf", "R2018")
    first = tmp_path / "first.toml"
    soilctl("convert", drawing, "--out", first, "--soils", strengths, code=0)
    between = tmp_path / f"between.{ending}"
    soilctl("convert", first, "--out", between, code=0)
    second = tmp_path / "second.toml"
    soilctl("convert", between, "--out", second, "--soils", strengths, code=0)
    one, other = (tomllib.loads(path.read_text(encoding="utf-8")) for path in (first, second))
    del one["title"], other["title"]
    assert one == other
    text = between.read_bytes()
    soilctl("convert", first, "--out", between, "--replace", code=0)
    assert between.read_bytes() == text


def test_what_is_neither_is_refused(soilctl, tmp_path):
    (tmp_path / "a.dxf").write_bytes(b"AC1032\0\0\0")
    (tmp_path / "b.dxf").write_text("no\ndrawing\n", encoding="utf-8")
    (tmp_path / "c.csv").write_text("layer,x,y\nsand,0,0\n", encoding="utf-8")
    for name, words in [("a.dxf", "DWG"), ("b.dxf", "line 1"), ("c.csv", "x_m"), ("d.dxf", "d.dxf")]:
        soilctl.refuses("convert", tmp_path / name, "--out", tmp_path / "out.toml", mentions=[words])
    soilctl.refuses("convert", tmp_path / "a.dxf", "--out", tmp_path / "out.svg", mentions=[".geojson"])
    assert not (tmp_path / "out.toml").exists()


def test_boreholes_become_a_section(soilctl, tmp_path):
    """A file in the format AGS 4 as others write it; areas by shapely."""
    rows = {
        "LOCA": ["LOCA_ID,LOCA_NATE,LOCA_NATN,LOCA_GL", ",m,m,m", "ID,2DP,2DP,2DP", "A/1,523160.00,178500.00,5.10", "A/2,523190.00,178540.00,6.80"],
        "GEOL": [
            "LOCA_ID,GEOL_TOP,GEOL_BASE,GEOL_DESC,GEOL_GEOL",
            ",m,m,,",
            "ID,2DP,2DP,X,PA",
            "A/1,0.00,1.20,soft clay,AL",
            "A/1,1.20,9.00,stiff clay,LC",
            "A/2,0.00,2.20,soft clay,AL",
            "A/2,2.20,3.00,gravel,RTD",
            "A/2,3.00,9.00,clay,LC",
        ],
    }
    text = ""
    for name, (heading, unit, kind, *data) in rows.items():
        lines = [("GROUP", name), *zip(["HEADING", "UNIT", "TYPE"], [heading, unit, kind]), *(("DATA", row) for row in data)]
        text += "".join(f'"{first}",' + ",".join(f'"{cell}"' for cell in rest.split(",")) + "\r\n" for first, rest in lines) + "\r\n"
    (tmp_path / "site.ags").write_text(text, newline="")
    strengths = "name,phi_deg,cohesion_kpa,unit_weight_kn_m3\nAL,0,20,17\nLC,0,60,19\nRTD,35,1,19\n"
    (tmp_path / "strengths.csv").write_text(strengths)
    out = tmp_path / "site.toml"
    answer = soilctl.json("convert", tmp_path / "site.ags", "--out", out, "--soils", tmp_path / "strengths.csv")
    areas = {soil["name"]: soil["area_m2"] for soil in answer["soils"]}
    gravel = Polygon([(0, 3.9), (50, 4.6), (50, 3.8)]).area
    soft = Polygon([(0, 5.1), (50, 6.8), (50, 4.6), (0, 3.9)]).area
    whole = Polygon([(0, 5.1), (50, 6.8), (50, -2.2), (0, -3.9)]).area
    assert areas == pytest.approx({"AL": soft, "RTD": gravel, "LC": whole - soft - gravel})
    assert any("A/1, A/2" in note for note in answer["notes"])
    assert soilctl.json("solve", out, "--check")
    assert "no hole" in soilctl("convert", tmp_path / "site.ags", "--out", tmp_path / "b.toml", "--holes", "A/9", code=2).stderr
