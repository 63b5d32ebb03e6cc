"""`soilctl workbench`: the page in a browser, drawn on by pointer and keyboard."""

import json
import math
import os
import random
import signal
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import ezdxf
import pytest
from monitor_page import LONG_S, until
from workbench_page import Workbench, begin, click, open_page, save, serve, settled, solve

__all__ = ["serve"]

TEMPLATES = ["strip-footing", "strip-load", "slope", "wall-passive", "wall-active", "wall-smooth", "plate", "embankment", "anchor"]


def solved(soilctl, file, gap="0.1"):
    """The bounds of `soilctl solve`."""
    done = soilctl("solve", file, "--max-gap", gap, "--format", "json")
    assert done.returncode in (0, 3), done.stderr
    answer = json.loads(done.stdout)
    return [answer["lower"], answer["upper"]]


def test_all_templates_are_there(serve):
    _, page = serve()
    assert page.locator("[data-template]").evaluate_all("all => all.map(one => one.dataset.template)") == [*TEMPLATES, "empty"]


@pytest.mark.parametrize("template", TEMPLATES)
def test_a_template_is_solved_saved_and_solved_again(serve, soilctl, tmp_path, template):
    file = tmp_path / "new.toml"
    _, page = serve(file)
    begin(page, template)
    assert page.locator("#messages").text_content() == "The problem is understood."
    save(page)
    assert not page.evaluate("workbench.store.dirty")
    # Side by side.
    with ThreadPoolExecutor() as pool:
        outside = pool.submit(solved, soilctl, file)
        bounds = solve(page)
    assert bounds[0] < bounds[1]
    assert outside.result() == bounds
    # The mechanism is drawn: what moves is in another colour than what rests.
    assert page.evaluate("workbench.flow.field.triangles.length") > 50
    colours = page.evaluate("() => { const c = document.getElementById('flow'); const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; const all = new Set(); for (let k = 0; k < d.length; k += 400) if (d[k + 3] === 255) all.add(`${d[k]} ${d[k + 1]} ${d[k + 2]}`); return all.size; }")
    assert colours >= 4


def test_a_strip_load_is_drawn_from_nothing(serve, soilctl, tmp_path):
    file = tmp_path / "drawn.toml"
    _, page = serve(file)
    page.keyboard.press("Escape")
    page.locator("#begin-open").click()
    page.locator("[data-template=empty]").click()
    page.locator("#section").focus()
    # The ground by exact coordinates, which Enter adds; the first point again ends it.
    page.keyboard.press("r")
    for point in ["-8, -6", "8, -6", "8, 0", "-8, 0", "-8, -6"]:
        page.locator("#exact-point").fill(point)
        page.keyboard.press("Enter")
    assert settled(page)["region"][0]["polygon"] == [[-8, -6], [8, -6], [8, 0], [-8, 0]]
    page.locator("#fit").click()
    # The load by pointer, a little beside where it is to be: it snaps.
    page.keyboard.press("l")
    for x in [-1.05, 0.96]:
        click(page, x, 0.04)
    load = settled(page)["boundary"][0]
    assert load == {"kind": "load", "line": [[-1, 0], [1, 0]], "pressure_kpa": 10, "live": True}
    page.locator("[id='boundary.0.pressure_kpa']").fill("1")
    for key, value in [("phi_deg", "0"), ("cohesion_kpa", "10"), ("unit_weight_kn_m3", "18")]:
        page.locator(f"[id='soil.0.{key}']").fill(value)
    # The sides.
    page.locator("#add-sides").click()
    for side in ["left", "right"]:
        page.locator(f"[id='boundary.1.sides.{side}']").check()
    page.locator("[id='boundary.1.kind']").select_option("far")
    settled(page)
    assert page.locator("#messages").text_content() == "The problem is understood."
    bounds = solve(page)
    assert bounds[0] <= 10 * (2 + math.pi) <= bounds[1]
    # The mechanism moves when it is asked to, and the slider displaces it.
    amount = "Number(document.getElementById('flow').dataset.amount)"
    page.locator("#play").click()
    until(page, f"{amount} > 0.6")
    page.locator("#amount").fill("0.25")
    until(page, f"{amount} === 0.25")
    save(page)
    assert solved(soilctl, file) == bounds


def test_sheets_and_heads_are_drawn_and_their_flow_is_shown(serve, soilctl, tmp_path):
    file = tmp_path / "dam.toml"
    _, page = serve(file)
    page.locator("[data-template=empty]").click()
    page.locator("#section").focus()

    def draw(key, points):
        page.keyboard.press(key)
        for point in points:
            page.locator("#exact-point").fill(point)
            page.keyboard.press("Enter")
        page.locator("#section").focus()

    draw("r", ["0, 0", "24, 0", "14, 5", "10, 5", "0, 0"])
    draw("k", ["12, 1", "20, 1"])
    draw("h", ["0, 0", "10, 5"])
    # A head may have more points than two: Enter on the last one again ends it.
    page.locator("#exact-point").fill("10, 5")
    page.keyboard.press("Enter")
    page.locator("#objective\\.kind").select_option("strength-reduction")
    page.locator("#add-sides").click()
    problem = settled(page)
    assert problem["member"] == [{"name": "sheet", "line": [[12, 1], [20, 1]], "tensile_kn_per_m": 50}]
    assert problem["head"] == [{"line": [[0, 0], [10, 5]], "head_m": 5}]
    page.locator("[data-entry='head.0'] button").click()
    page.locator("[id='head.0.head_m']").fill("4")
    page.locator("[data-entry='member.0'] button").click()
    page.locator("[id='member.0.attached.start']").check()
    settled(page)
    assert "attached" in page.locator("#messages").text_content()
    page.locator("[id='member.0.attached.start']").uncheck()
    assert settled(page)["head"][0]["head_m"] == 4
    assert page.locator("#messages").text_content() == "The problem is understood."
    understood = page.evaluate("workbench.state.understood")
    highest = max(y for piece in understood["free_surface"] for _, y in piece)
    assert len(understood["free_surface"]) > 20 and 3.5 < highest < 4.1
    assert page.locator("#section .member").count() == 1
    assert page.locator("#section .water .table").count() > 1
    assert solve(page)[0] > 1
    save(page)
    assert soilctl.json("solve", file, "--check")["seepage"]["triangles"] > 50


def test_keys_alone_draw_and_move(serve):
    _, page = serve()
    page.keyboard.press("Escape")
    page.locator("[data-template=empty]").evaluate("one => one.click()")
    page.evaluate("() => { workbench.view.size(800, 500); workbench.view.fit([[-10, -8], [10, 2]]); }")
    step = page.evaluate("workbench.view.step()")
    page.locator("#section").focus()
    page.keyboard.press("r")
    for keys in [[], ["ArrowRight"] * 4, ["ArrowUp"] * 4, ["ArrowLeft"] * 4]:
        for key in keys:
            page.keyboard.press(key)
        page.keyboard.press("Enter")
    page.keyboard.press("Enter")
    (a, b, c, d) = settled(page)["region"][0]["polygon"]
    assert (b[0] - a[0], c[1] - b[1], d[0]) == pytest.approx((4 * step, 4 * step, a[0]))
    # The third point, one step to the right, and a further one after it.
    for key in [".", ".", ".", "ArrowRight", "i"]:
        page.keyboard.press(key)
    polygon = settled(page)["region"][0]["polygon"]
    assert len(polygon) == 5 and polygon[2][0] == pytest.approx(c[0] + step)
    page.keyboard.press("Delete")
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert settled(page)["region"][0]["polygon"] == [a, b, c, d]


def test_undo_of_200_random_edits_returns_to_the_start(serve, tmp_path):
    file = tmp_path / "cut.toml"
    text = (Path(__file__).resolve().parents[2] / "data" / "problems" / "cut_cases.toml").read_text(encoding="utf-8")
    file.write_text(text, encoding="utf-8")
    _, page = serve(file)
    start = settled(page)
    draw = random.Random(29)

    kinds = ["move", "insert", "remove", "add", "field", "mirror", "copy"]
    edits = 0
    while edits < 200:
        # One by pointer, whatever is there, and some by what the fields and keys call.
        x, y = page.evaluate("p => workbench.view.px(p)", [draw.uniform(0, 24), draw.uniform(-4, 4)])
        box = page.locator("#section").bounding_box()
        page.mouse.move(box["x"] + x, box["y"] + y)
        page.mouse.down()
        page.mouse.move(box["x"] + x + 30, box["y"] + y - 20, steps=2)
        page.mouse.up()
        edits = page.evaluate("""some => {
            const {store, editor, model} = workbench;
            for (const [kind, number] of some) {
                const all = model.shapes(store.problem), pick = all[Math.floor(number * all.length)];
                const at = pick && Math.floor(number * 1000) % pick.points.length;
                store.rest();
                if (kind === 'add' || !pick) store.change(draft => model.add(draft, ['region', 'line', 'load', 'structure', 'plate', 'edge', 'water'][Math.floor(number * 7)], [[number * 9, 1], [number * 9 + 1, 2], [number * 5, 3]]));
                else if (kind === 'move') store.change(draft => model.movePoint(draft, pick, at, [number * 20, number * 5 - 2]));
                else if (kind === 'insert') store.change(draft => model.insertPoint(draft, pick, at, [number, -number]));
                else if (kind === 'remove') store.change(draft => model.removePoint(draft, pick, at));
                else if (kind === 'field') store.change(draft => { draft.soil[0].phi_deg = 20 + 10 * number; draft.title = `edit ${number}`; });
                else if (kind === 'mirror') store.change(draft => model.mirror(draft));
                else if (kind === 'copy') { editor.choose(pick); store.change(draft => model.duplicate(draft, pick)); }
            }
            return store.past.length;
        }""", [[draw.choice(kinds), draw.random()] for _ in range(9)])
    last = settled(page)
    assert last != start and last["case"] == start["case"]
    page.locator("#section").focus()
    for _ in range(20):
        page.keyboard.press("Control+z")
    assert page.evaluate("workbench.store.past.length") == edits - 20
    page.evaluate("for (let k = workbench.store.past.length; k; k--) document.getElementById('section').dispatchEvent(new KeyboardEvent('keydown', {key: 'z', ctrlKey: true, bubbles: true}))")
    assert settled(page) == start
    assert page.locator("#undo").is_disabled() and not page.evaluate("workbench.store.dirty")
    page.evaluate("while (workbench.store.redo()) ;")
    assert settled(page) == last


def test_what_is_wrong_is_said_at_its_place(serve):
    _, page = serve()
    begin(page, "strip-load")

    def wrong(path):
        settled(page)
        field = page.locator(f"[data-path='{path}']")
        assert "bad" in field.get_attribute("class"), path
        words = field.locator(".wrong").text_content()
        assert words and words in page.locator("#messages").text_content()
        return words

    # A value, at its field.
    page.locator("[id='soil.0.phi_deg']").fill("95")
    assert "phi_deg is 95" in wrong("soil.0.phi_deg")
    page.locator("[id='soil.0.phi_deg']").fill("30")
    # A note likewise.
    page.locator("[id='soil.0.unit_weight_kn_m3']").fill("1800")
    settled(page)
    assert "kg/m3" in page.locator("[data-path='soil.0.unit_weight_kn_m3'] .wrong").text_content()
    page.locator("[id='soil.0.unit_weight_kn_m3']").fill("18")
    # What is no number stays in its field, and is not in the document.
    page.locator("[id='soil.0.unit_weight_kn_m3']").fill("18x")
    assert page.locator("[id='soil.0.unit_weight_kn_m3']").get_attribute("aria-invalid") == "true"
    assert settled(page)["soil"][0]["unit_weight_kn_m3"] == 18
    page.locator("[id='soil.0.unit_weight_kn_m3']").fill("18,5")
    assert settled(page)["soil"][0]["unit_weight_kn_m3"] == 18.5
    # Outline without a condition, at the key that would say it.
    page.locator("[id='problem.default_boundary']").select_option("")
    assert "no boundary condition" in wrong("problem.default_boundary")
    page.locator("[id='problem.default_boundary']").select_option("free")
    # A line that is not on the outline, and regions that overlap: in the drawing, and in the list.
    page.evaluate("workbench.store.change(draft => { draft.boundary[1].line = [[-1, -3], [1, -3]]; })")
    settled(page)
    assert page.locator("#section .fault.bad").count() == 1
    assert "bad" in page.locator("[data-entry='boundary.1']").get_attribute("class")
    page.locator("#messages button").click()
    assert page.locator("#chosen h3").text_content() == "load, 2 points"
    page.keyboard.press("Control+z")
    page.evaluate("workbench.store.change(draft => { draft.region.push({soil: 'clay', polygon: [[0, -1], [30, -1], [30, 1]]}); })")
    settled(page)
    mark = page.evaluate("(() => { const {cx, cy} = document.querySelector('#section .flag.bad circle'); return workbench.view.m([cx.baseVal.value, cy.baseVal.value]); })()")
    said = page.locator("#messages li.bad span").text_content()
    assert "overlap at (" in said
    place = [float(x) for x in said.split("overlap at (")[1].split(")")[0].split(",")]
    assert mark == pytest.approx(place, abs=1e-3)


def test_unsaved_work_survives_a_reload_and_text_keeps_its_comments(serve, tmp_path):
    file = tmp_path / "slope.toml"
    text = (Path(__file__).resolve().parents[2] / "data" / "problems" / "slope.toml").read_text(encoding="utf-8")
    file.write_text(text, encoding="utf-8")
    _, page = serve(file)
    settled(page)
    # Only the text is edited: its comments stay.
    page.locator("#tab-text").click()
    assert page.locator("#toml").input_value() == text
    page.locator("#toml").fill(text.replace("phi_deg = 25", "phi_deg = 26"))
    # At once, before the page has read what was typed.
    save(page)
    assert page.evaluate("workbench.store.problem.soil[0].phi_deg") == 26
    assert file.read_text(encoding="utf-8") == text.replace("phi_deg = 25", "phi_deg = 26")
    # They come back with an undo of what was done in the drawing.
    page.locator("#tab-problem").click()
    page.locator("[id='soil.0.cohesion_kpa']").fill("14")
    settled(page)
    page.locator("#undo").click()
    settled(page)
    page.locator("#tab-text").click()
    assert page.locator("#toml").input_value() == text.replace("phi_deg = 25", "phi_deg = 26")
    # What is wrong with a text is said where it is typed, and the document stays.
    page.locator("#toml").fill("[[soil]\nname = 3")
    until(page, "!document.getElementById('toml-wrong').hidden")
    assert "line 1" in page.locator("#toml-wrong").text_content()
    page.locator("#tab-problem").click()
    page.locator("[id='soil.0.cohesion_kpa']").fill("33")
    assert page.locator("#dirty").is_visible()
    page.reload()
    until(page, "window.workbench?.state.greeted")
    assert settled(page)["soil"][0]["cohesion_kpa"] == 33
    assert "unsaved work" in page.locator("#told").text_content()
    page.locator("#undo").click()
    assert settled(page)["soil"][0]["cohesion_kpa"] == 12
    # What another program wrote meanwhile is not written over unasked.
    file.write_text(text, encoding="utf-8")
    page.keyboard.press("Control+s")
    until(page, "document.getElementById('told').textContent.includes('another program')")
    assert file.read_text(encoding="utf-8") == text
    page.locator("#told button").click()
    until(page, "document.getElementById('told').textContent.endsWith('was saved')")
    assert "phi_deg = 26" in file.read_text(encoding="utf-8")


def test_a_file_that_is_no_problem_is_shown_and_kept(serve, tmp_path):
    file = tmp_path / "draft.toml"
    text = 'title = "half a file"\n[[soil]]\nname = "sand"\n'
    file.write_text(text, encoding="utf-8")
    _, page = serve(file)
    settled(page)
    assert page.locator("#toml").input_value() == text
    assert "unit_weight_kn_m3" in page.locator("#toml-wrong").text_content()
    page.keyboard.press("Control+s")
    until(page, "document.getElementById('told').textContent.includes('no problem file yet')")
    assert file.read_text(encoding="utf-8") == text
    # Mended where it stands, it is a problem.
    page.locator("#toml").fill(text + 'phi_deg = 30\nunit_weight_kn_m3 = 18\n[objective]\nkind = "load"\n')
    until(page, "workbench.store.problem.title === 'half a file'")
    page.keyboard.press("Control+s")
    until(page, "document.getElementById('told').textContent.includes('save again')")
    page.locator("#told button").click()
    until(page, "document.getElementById('told').textContent.endsWith('was saved')")
    assert "phi_deg = 30" in file.read_text(encoding="utf-8")


def test_files_go_in_and_out(serve, soilctl, tmp_path):
    _, page = serve()
    page.keyboard.press("Escape")
    page.locator("#file").set_input_files(Path(__file__).resolve().parents[2] / "data" / "problems" / "plate_layers.toml")
    until(page, "document.getElementById('told').textContent.includes('was opened')")
    problem = settled(page)
    assert problem["plate"][0]["in_soil"] == [{"soil": "wet sand", "delta_deg": 18}]
    with page.expect_download() as got:
        page.keyboard.press("Control+s")
    target = tmp_path / got.value.suggested_filename
    got.value.save_as(target)
    assert target.name == "curved_plate_in_two_layers.toml"
    soilctl("solve", target, "--check", code=0)
    with page.expect_download() as got:
        page.locator("#picture").click()
    picture = tmp_path / "picture.svg"
    got.value.save_as(picture)
    words = picture.read_text(encoding="utf-8")
    assert words.startswith("<?xml") and "pattern" in words and "blade" in words and "handle" not in words


def test_drawings_go_in_and_out(serve, tmp_path):
    doc = ezdxf.new("R2010", units=4)
    space = doc.modelspace()
    corners = {"clay": [(0, -6), (24, -6), (24, 0), (0, 0)], "Löß": [(0, 0), (14, 0), (6, 4), (0, 4)]}
    for layer, points in corners.items():
        space.add_lwpolyline([(1000 * x, 1000 * y) for x, y in points], close=True, dxfattribs={"layer": layer})
    space.add_circle((3000, 8000), 500, dxfattribs={"layer": "water"})
    doc.saveas(tmp_path / "in.dxf")
    _, page = serve()
    page.keyboard.press("Escape")
    page.locator("#file").set_input_files(tmp_path / "in.dxf")
    until(page, "document.getElementById('told').textContent.includes('was opened')")
    told = page.locator("#told").text_content()
    assert "put strength" in told and "on layer water" in told
    problem = settled(page)
    assert {region["soil"]: len(region["polygon"]) for region in problem["region"]} == {"clay": 5, "Löß": 4}
    with page.expect_download() as got:
        page.locator("#dxf").click()
    got.value.save_as(tmp_path / "out.dxf")
    back = ezdxf.readfile(tmp_path / "out.dxf")
    assert not back.audit().errors
    areas = [line.get_points("xy") for line in back.modelspace().query("LWPOLYLINE") if line.closed]
    assert {(float(x), float(y)) for x, y in areas[0]} == {(float(x), float(y)) for x, y in [*corners["clay"], (14, 0)]}
    # What is no drawing is refused, and the page keeps what it has.
    (tmp_path / "bad.dxf").write_text("no\ndrawing", encoding="utf-8")
    page.locator("#file").set_input_files(tmp_path / "bad.dxf")
    until(page, "document.getElementById('told').dataset.tone === 'bad'")
    assert len(settled(page)["region"]) == 2


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_phone_has_it_all(serve, scheme):
    _, page = serve(viewport={"width": 360, "height": 740}, color_scheme=scheme, has_touch=True, is_mobile=True, device_scale_factor=2)
    page.locator("[data-template=strip-load]").tap()
    settled(page)
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    # A point is added and the shape ended by touch.
    page.locator("[data-tool=water]").tap()
    for x in [-10, 10]:
        px = page.evaluate("p => workbench.view.px(p)", [x, -4])
        page.locator("#section").tap(position={"x": px[0], "y": px[1]})
    page.locator("#done").tap()
    assert len(settled(page)["water"]["table"]) == 2
    solve(page)
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    # Every button and field has a name.
    nameless = page.evaluate("[...document.querySelectorAll('button, input, select, textarea')].filter(one => !one.hidden && !one.textContent.trim() && !one.title && !one.ariaLabel && !one.labels?.length).map(one => one.outerHTML)")
    assert [one for one in nameless if 'type="file"' not in one] == []


def test_it_ends_at_ctrl_c_and_says_what_it_cannot(soilctl, browser, tmp_path):
    workbench = Workbench(soilctl.binary)
    page = open_page(browser, workbench.url)
    os.kill(workbench.process.pid, signal.SIGINT)
    # A second signal would end it at once.
    workbench.process.wait(LONG_S)
    assert "pages: 1" in workbench.end()
    until(page, "document.getElementById('link').dataset.state === 'lost'")
    # The problem is still there.
    assert page.evaluate("workbench.store.problem.soil.length") == 1
    page.context.close()
    soilctl.refuses("workbench", tmp_path / "a.txt", mentions=[".toml or .json"])
    soilctl.refuses("workbench", tmp_path / "missing" / "a.toml", mentions=["folder"])
    other = Workbench(soilctl.binary)
    port = other.answer["listen"].rsplit(":", 1)[1]
    soilctl.refuses("workbench", "--port", port, mentions=[f"127.0.0.1:{port}", "another address"])
    other.end()


def test_a_certificate_is_kept_and_proven_anew(serve, soilctl, tmp_path):
    _, page = serve()
    begin(page, "strip-load")
    bounds = solve(page)
    with page.expect_download() as kept:
        page.locator("#certificate").click()
    file = tmp_path / "certificate.json"
    kept.value.save_as(file)
    found = json.loads(soilctl("certify", file, "--format", "json", code=0).stdout)
    assert found["certified"]
    page.locator("#file").set_input_files(file)
    until(page, "document.getElementById('certified').childElementCount")
    proven = {one.get_attribute("data-side"): float(one.get_attribute("data-proven")) for one in page.locator("#certified li").all()}
    assert proven == {side: found[side]["proven"] for side in ["lower", "upper"]}
    # A claim that its field does not reach is not believed.
    solution = json.loads(file.read_text(encoding="utf-8"))
    solution["upper"]["claimed"] *= 0.5
    file.write_text(json.dumps(solution), encoding="utf-8")
    page.locator("#file").set_input_files(file)
    until(page, "document.getElementById('told').dataset.tone === 'bad'")
    assert page.locator("#certified li[data-side=upper]").get_attribute("class") == "bad"
    with page.expect_download() as report:
        page.locator("#report").click()
    report.value.save_as(tmp_path / "report.html")
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "Checked by, date" in text and "<script" in text and "plotly" not in text
    assert bounds[0] < bounds[1]


def test_sliders_solve_again_and_a_drag_is_one_step_back(serve):
    _, page = serve()
    begin(page, "strip-load")
    before = solve(page)
    slider = page.locator("[id='whatif.cohesion_kpa']")
    steps = page.evaluate("workbench.store.past.length")
    slider.focus()
    for _ in range(8):
        page.keyboard.press("ArrowRight")
    until(page, "workbench.solver.state === 'solved' && !workbench.solver.isTrying && workbench.solver.problem === workbench.store.problem")
    # Soil without friction bears in proportion to its cohesion.
    clay = page.evaluate("workbench.store.problem.soil[0]")
    after = page.evaluate("[workbench.solver.answer.lower, workbench.solver.answer.upper]")
    assert clay["cohesion_kpa"] == 44
    for now, then in zip(after, before, strict=True):
        assert math.isclose(now, then * 1.1, rel_tol=1e-4)
    assert page.evaluate("workbench.store.past.length") == steps + 1
    page.locator("#undo").click()
    assert settled(page)["soil"][0]["cohesion_kpa"] == 40


def test_two_variants_stand_side_by_side(serve):
    _, page = serve()
    begin(page, "strip-load")
    before = solve(page)
    page.locator("#keep-a").click()
    assert page.locator("#section-a .region").count() == 1 and page.locator("#view-a").is_visible()
    kept = page.evaluate("workbench.store.problem")
    page.locator("#tab-problem").click()
    cohesion = kept["soil"][0]["cohesion_kpa"]
    page.locator("[id='soil.0.cohesion_kpa']").fill(str(2 * cohesion))
    settled(page)
    page.locator("#tab-result").click()
    assert "not solved" in page.locator("#ratio-a").text_content()
    now = solve(page)
    rows = {name: [float(cell.get_attribute("data-value")) for cell in page.locator(f"[data-variant='{name}'] td").all()] for name in ["A", "now"]}
    assert rows == {"A": before, "now": now}
    # Soil without friction bears in proportion to its cohesion.
    words = page.locator("#ratio-a").text_content()
    low, high = (float(word) for word in [words.split()[2], words.split()[4]])
    assert low <= 2 <= high and high / low < 1.3
    assert f"cohesion_kpa: {cohesion} → {2 * cohesion}" in page.locator("#variant").text_content()
    page.locator("#back-to-a").click()
    assert settled(page) == kept
    page.locator("#forget-a").click()
    assert page.locator("#view-a").is_hidden()


def test_curved_strength_has_fields(serve, soilctl, tmp_path):
    file = tmp_path / "curved.toml"
    _, page = serve(file)
    begin(page, "slope")
    page.locator("#panel-problem summary").first.click()
    page.locator("[id='soil.0.strength.kind']").select_option("power")
    soil = settled(page)["soil"][0]
    assert soil["strength"]["kind"] == "power" and "phi_deg" not in soil
    page.locator("[id='soil.0.strength.exponent']").fill("2")
    settled(page)
    assert "exponent" in page.locator("[data-path='soil.0.strength.exponent'] .wrong").text_content()
    page.locator("[id='soil.0.strength.exponent']").fill("0.7")
    settled(page)
    page.locator("[id='soil.0.strength.kind']").select_option("points")
    assert len(settled(page)["soil"][0]["strength"]["points_kpa"]) == 3
    # A strength that falls is refused; then there is one point more.
    page.locator("[id='soil.0.strength.points_kpa.1.1']").fill("0")
    settled(page)
    assert "must grow" in page.locator("#messages").text_content()
    page.locator("[id='soil.0.strength.points_kpa.1.1']").fill("30")
    page.locator("[aria-label='Insert a point after point 3']").click()
    page.locator("[id='soil.0.strength.points_kpa.3.1']").fill("110")
    points = settled(page)["soil"][0]["strength"]["points_kpa"]
    assert len(points) == 4 and points[3] == [350, 110]
    page.locator("[id='soil.0.strength.kind']").select_option("hoek-brown")
    assert settled(page)["soil"][0]["strength"] == {"kind": "hoek-brown", "ucs_mpa": 10, "gsi": 40, "mi": 10}
    save(page)
    soilctl("solve", file, "--check", code=0)
    page.locator("[id='soil.0.strength.kind']").select_option("friction-law")
    page.locator("[id='soil.0.strength.slope_deg_per_decade']").fill("6")
    law = settled(page)["soil"][0]["strength"]
    assert (law["kind"], law["slope_deg_per_decade"]) == ("friction-law", 6) and "greatest_phi_deg" not in law
    page.locator("[id='soil.0.strength.greatest_phi_deg']").fill("10")
    settled(page)
    assert "strength.greatest_phi_deg" in page.locator("#messages").text_content()
    page.locator("[id='soil.0.strength.greatest_phi_deg']").fill("50")
    # Clay by the direction of the stress is no curve: it keeps a cohesion, without friction.
    page.locator("[id='soil.0.strength.kind']").select_option("anisotropic")
    page.locator("[id='soil.0.anisotropy.passive']").fill("0.5")
    soil = settled(page)["soil"][0]
    assert soil["anisotropy"] == {"passive": 0.5, "shear": 0.8} and soil["phi_deg"] == 0 and "strength" not in soil
    assert page.evaluate("workbench.state.errors.length") == 0, page.locator("#messages").text_content()
    page.locator("[id='soil.0.strength.kind']").select_option("")
    assert not settled(page)["soil"][0].keys() & {"strength", "anisotropy"}


def test_a_section_line_tells_stresses(serve):
    _, page = serve()
    begin(page, "strip-load")
    page.evaluate("workbench.store.change(draft => { for (const one of draft.boundary) if (one.kind === 'far') one.kind = 'smooth'; })")
    settled(page)
    solve(page)
    problem = page.evaluate("workbench.store.problem")
    xs, ys = zip(*problem["region"][0]["polygon"], strict=True)
    page.locator("#section").focus()
    page.keyboard.press("c")
    depth = 0.5 * (min(ys) + max(ys))
    for x in [min(xs), max(xs)]:
        page.locator("#exact-point").fill(f"{x}, {depth}")
        page.keyboard.press("Enter")
    until(page, "!document.getElementById('probe').hidden")
    # A level line carries the weight above it and the load: smooth sides take nothing of either.
    load = next(one for one in problem["boundary"] if one["kind"] == "load")
    wide = abs(load["line"][1][0] - load["line"][0][0]) * load["pressure_kpa"]
    lower = page.evaluate("workbench.solver.answer.lower")
    weight = problem["soil"][0]["unit_weight_kn_m3"] * (max(ys) - depth) * (max(xs) - min(xs)) + lower * wide
    normal = float(page.locator("[data-normal]").get_attribute("data-normal"))
    assert abs(normal / weight - 1) < 0.01
    assert settled(page) == problem and page.locator("#section .probe").count() == 1
    # It is read by keyboard, and goes when it is closed.
    page.locator("#probe-at").focus()
    before = page.locator("#probe-place").text_content()
    page.keyboard.press("End")
    assert page.locator("#probe-place").text_content() != before
    page.locator("#probe-off").click()
    until(page, "document.querySelectorAll('#section .probe').length === 0")


def test_feet_and_pounds_are_shown_and_si_is_kept(serve, soilctl, tmp_path):
    """What is typed in feet and pounds is the same problem in SI, by factors of NIST SP 811; turning units there and back changes no bit."""
    pcf, psf, foot = 0.157087464, 0.04788025898, 0.3048
    file = tmp_path / "feet.toml"
    _, page = serve(file)
    begin(page, "strip-load")
    before = settled(page)
    page.locator("#units").click()
    assert settled(page) == before and not page.evaluate("workbench.store.past.length > 1")
    assert "psf" in page.locator("[data-path='soil.0.cohesion_kpa']").text_content() and page.locator("#exact-unit").text_content() == "ft"
    assert page.locator("#step").text_content().endswith(" ft")
    page.locator("[id='soil.0.unit_weight_kn_m3']").fill("120")
    page.locator("[id='soil.0.cohesion_kpa']").fill("400")
    load = next(k for k, one in enumerate(before["boundary"]) if one["kind"] == "load")
    page.locator(f"[data-entry='boundary.{load}'] button").click()
    page.locator(f"[id='boundary.{load}.pressure_kpa']").fill("2000")
    cell = page.locator(f"[id='boundary.{load}.line.1.x']")
    cell.fill("6.5")
    after = settled(page)
    soil, boundary = after["soil"][0], after["boundary"][load]
    assert soil["unit_weight_kn_m3"] == pytest.approx(120 * pcf, rel=1e-8)
    assert soil["cohesion_kpa"] == pytest.approx(400 * psf, rel=1e-8)
    assert boundary["pressure_kpa"] == pytest.approx(2000 * psf, rel=1e-8)
    assert boundary["line"][1][0] == pytest.approx(6.5 * foot, rel=1e-11)
    assert "2000 psf" in page.locator("#section").text_content() and "120 pcf" in page.locator("#section").text_content()
    save(page)
    solved_load = solve(page)
    assert solved(soilctl, file) == solved_load
    page.locator("#tab-problem").click()
    page.locator("#units").click()
    assert settled(page) == after and "kPa" in page.locator("[data-path='soil.0.cohesion_kpa']").text_content()
    assert float(page.locator("[id='soil.0.cohesion_kpa']").input_value()) == soil["cohesion_kpa"]
    # A force is told in pounds over feet, and kept in kN/m for whoever reads the page.
    page.locator("#begin-open").click()
    begin(page, "strip-footing")
    bounds = solve(page)
    page.locator("#units").click()
    told = page.locator("#bounds").text_content()
    assert all(f"{force / (4.4482216152605e-3 / foot):.0f} lb/ft" in told for force in bounds), told
