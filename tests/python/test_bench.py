"""The plate's bench of `soilctl workbench`, in a browser."""

import csv
import io
from pathlib import Path

import pytest
from bench_page import READY, estimated, force, rested
from monitor_page import until
from workbench_page import serve

__all__ = ["serve"]

ROOT = Path(__file__).resolve().parents[2]
STROKES = ROOT / "data" / "soils" / "ticino_rained" / "strokes.csv"


@pytest.fixture
def bench(serve):
    """Function that opens the bench."""
    return lambda **looks: serve(path="plate.html", ready=READY, **looks)[1]


def predicted(soilctl, model, ends, *words):
    given = ["--alpha", 75, "--depth", 0.05, "--width", 0.127, "--phi", 40, "--delta", 20, "--density", 1450]
    return soilctl.json("predict", "--model", model, "--ends", ends, *given, *words)


def test_sliders_tell_what_predict_tells(bench, soilctl):
    page = bench()
    # By keyboard, five degrees less.
    page.locator("[id='slide.alpha_deg']").focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    shown = rested(page)
    assert page.locator("[id='field.alpha_deg']").input_value() == "75"
    for model, ends in [("chen", "none"), ("coulomb", "none"), ("blocks-3d", "finite"), ("mckyes", "finite")]:
        assert force(page, model, ends) == pytest.approx([predicted(soilctl, model, ends)["force_n"]] * 2, rel=1e-9)
    for ends in ["none", "finite"]:
        answer = predicted(soilctl, "table", ends)
        low, high = force(page, "table", ends)
        assert high / low == pytest.approx(answer["k_net_upper"] / answer["k_net_lower"], rel=1e-9)
        assert (low * high) ** 0.5 == pytest.approx(answer["force_n"], rel=1e-9)
    assert "A node of the table, proven" in page.locator("#bracket").text_content()
    # What the soil bears in other directions is what plates with that friction need.
    for angle in [0, 10, 30]:
        points = {point[0]: point[1:] for point in shown["borne"][1]["points"]}
        found = soilctl.json("predict", "--model", "chen", "--alpha", 75, "--depth", 0.05, "--width", 0.127, "--phi", 40, "--delta", angle, "--density", 1450)
        assert points[angle] == pytest.approx([found["force_n"]] * 2, rel=1e-9)
    # Between its nodes the table has a margin, which is told.
    page.locator("[id='field.phi_deg']").fill("41.3")
    rested(page)
    assert "interpolation may be wrong by, at most" in page.locator("#bracket").text_content()
    page.locator("[id='field.phi_deg']").fill("40")
    # All slip lines are drawn, from the plate's edge to the ground.
    assert page.locator("#ground .surface").count() >= 4
    # Typed: cohesion, which the table does not have. It says so at its place, and the others go on.
    page.locator("#further summary").click()
    page.locator("[id='field.cohesion_pa']").fill("0,2")
    rested(page)
    refused = page.locator("[data-model='table finite']")
    assert "cohesion" in refused.text_content() and "No proven bracket" in page.locator("#bracket").text_content()
    assert force(page, "chen", "none")[0] == pytest.approx(predicted(soilctl, "chen", "none", "--cohesion", 200)["force_n"], rel=1e-9)
    # What no plate has is refused, and what was typed before is there after a reload.
    page.locator("[id='field.width_m']").fill("0")
    until(page, "document.getElementById('bracket').textContent.includes('above 0 m')")
    page.locator("[id='field.width_m']").fill("100")
    page.reload()
    until(page, READY)
    rested(page)
    assert page.evaluate("[bench.values.width_m, bench.values.cohesion_pa, bench.values.alpha_deg]") == [0.1, 200, 75]


def test_strokes_are_estimated_as_they_are_typed_and_dragged(bench, soilctl):
    page = bench()
    page.locator("#example").click()
    shown = estimated(page)
    answer = soilctl.json("estimate", STROKES)
    for key in ["phi_deg", "density_kg_m3", "region"]:
        assert shown["answer"][key] == answer[key]
    ends = page.locator("#intervals dd").evaluate_all("all => all.map(one => [one.dataset.low, one.dataset.high].map(Number))")
    assert ends == [answer["phi_deg"], answer["density_kg_m3"]]
    assert page.locator("#bands .band").count() == 4 and page.locator("#rows tr").count() == 4
    # One band is dragged upwards by pointer: its force grows as its density does, and nothing else in the text changes. The models that
    # search have answered before: with them the page above the picture grows by a line.
    rested(page)
    number = page.locator("#bands .number").nth(1).bounding_box()
    x, y = number["x"] + number["width"] / 2, number["y"] + number["height"] / 2
    top = page.locator("#bands").bounding_box()["y"]
    densities = page.evaluate("all => all.map(y => bench.strokes.bands.rho(y))", [y - top, y - 24 - top])
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 12, steps=2)
    # A page that moves under the pointer pulls no further.
    page.evaluate("document.querySelector('main').style.paddingTop = '40px'")
    page.mouse.move(x, y - 24, steps=2)
    page.mouse.up()
    moved = estimated(page)
    rows = list(csv.DictReader(io.StringIO(page.locator("#csv").input_value())))
    first = list(csv.DictReader(io.StringIO(STROKES.read_text(encoding="utf-8"))))
    ratios = [float(now["force_n"]) / float(then["force_n"]) for now, then in zip(rows, first, strict=True)]
    changed = [k for k, ratio in enumerate(ratios) if ratio != 1]
    assert len(changed) == 1 and ratios[changed[0]] == pytest.approx(densities[1] / densities[0], rel=1e-3)
    assert moved["answer"]["measurements"][changed[0]]["force_n"] == pytest.approx(float(rows[changed[0]]["force_n"]))
    # One drag is one step back.
    page.locator("#undo").click()
    assert page.locator("#csv").input_value() == STROKES.read_text(encoding="utf-8")
    # The slider of a row does the same by keyboard, up to strokes that no soil explains; it says which.
    page.locator("[data-row='0'] input").focus()
    page.keyboard.press("End")
    until(page, "bench.strokes.csvOf === bench.strokes.table.csv && !bench.strokes.shown.answer.consistent")
    assert page.locator("#verdict").get_attribute("class") == "verdict bad"
    assert page.locator("#rows tr.bad").count() >= 1
    # What is typed wrong is told with its line, and the text stays.
    text = STROKES.read_text(encoding="utf-8")
    page.locator("#csv").fill(text.replace("5.738205883686045", "x"))
    until(page, "!document.getElementById('csv-wrong').hidden")
    assert "line 3" in page.locator("#csv-wrong").text_content()
    page.locator("#csv").fill(text)
    assert estimated(page)["answer"]["consistent"] and page.locator("#csv-wrong").is_hidden()
    # Which stroke next, shown as a plate in the soil of least misfit.
    shown = estimated(page, with_next=True)
    best = page.evaluate("bench.strokes.candidates[0]")
    picked = page.locator(".candidate.best")
    assert float(picked.get_attribute("data-alpha")) == best["alpha_deg"]
    picked.focus()
    page.keyboard.press("Enter")
    rested(page)
    found = page.evaluate("[bench.values.alpha_deg, bench.values.depth_m, bench.values.phi_deg]")
    assert found[:2] == [best["alpha_deg"], best["depth_m"]]
    assert found[2] == pytest.approx(shown["answer"]["best_estimate"]["phi_deg"], rel=1e-3)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_phone_has_all_of_the_bench(bench, scheme):
    page = bench(viewport={"width": 360, "height": 740}, color_scheme=scheme, has_touch=True, is_mobile=True, device_scale_factor=2)
    page.locator("#example").tap()
    estimated(page)
    page.locator("#as-at-first").tap()
    rested(page)
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    nameless = page.evaluate("[...document.querySelectorAll('button, input, select, textarea')].filter(one => !one.hidden && !one.textContent.trim() && !one.title && !one.ariaLabel && !one.labels?.length).map(one => one.outerHTML)")
    assert [one for one in nameless if 'type="file"' not in one] == []
    # Both pages lead to each other.
    with page.expect_navigation():
        page.locator("a.button[href='./']").tap()
    until(page, "window.workbench?.state.greeted")
