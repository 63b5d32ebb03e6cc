"""The pages of `bound`, `solve`, `certify`, `report`, `diagnose` and `process`: one frame, figures as files, the mechanism in motion."""

import csv
import io
import json
import re
import shutil

import numpy as np
import pytest
from PIL import Image

PLATE = ["--alpha", 90, "--phi", 30, "--delta", 15]
BUDGET = ["--max-elements", 1500, "--max-gap", 0.05]


@pytest.fixture(scope="module")
def bound(soilctl, tmp_path_factory):
    """The folder of a plate with page, figures and saved solution, and the answer."""
    folder = tmp_path_factory.mktemp("bound")
    files = ["--report", "plate.html", "--figures", "figures", "--save", "plate.json"]
    return folder, soilctl.json("bound", *PLATE, *BUDGET, *files, cwd=folder)


@pytest.fixture(scope="module")
def pages(soilctl, data, bound, stroke_log, tmp_path_factory):
    """A page of each verb, by the verb."""
    folder = tmp_path_factory.mktemp("pages")
    strokes = data / "soils" / "ticino_rained" / "strokes.csv"
    soilctl("report", strokes, "--delta", 23, "--density", 1600, "--out", folder / "report.html", "--figures", folder / "report", code=0)
    soilctl("solve", data / "problems" / "footing_clay.toml", *BUDGET, "--report", folder / "solve.html")
    soilctl("certify", bound[0] / "plate.json", "--report", folder / "certify.html", code=0)
    soilctl("process", stroke_log, "--report", folder / "process.html", "--figures", folder / "process", code=0)
    soilctl("diagnose", data / "campaigns" / "campaign_b", "--out", folder / "diagnosis", "--figures", folder / "diagnose", code=0)
    shutil.copy(folder / "diagnosis" / "report.html", folder / "diagnose.html")
    soilctl("bound", *PLATE, *BUDGET, "--plot", folder / "plot.html", "--plot-kind", "all")
    found = {file.stem: file for file in folder.glob("*.html")}
    return {**found, "bound": bound[0] / "plate.html"}


def test_pages_have_one_frame(pages, open_page):
    assert set(pages) == {"report", "solve", "certify", "process", "diagnose", "bound", "plot"}
    styles = set()
    for verb, file in pages.items():
        page = open_page(file)
        page.wait_for_timeout(300)
        assert page.requests == [] and page.problems == [], verb
        header = page.locator("header")
        assert header.locator("h1").count() == 1 and header.locator(".kind").inner_text().strip(), verb
        if verb != "plot":
            assert header.locator(".verdict .callout-title").inner_text().strip(), verb
        foot = page.locator("footer").inner_text()
        name = "bound" if verb == "plot" else verb
        assert re.search(r"soilctl \d+\.\d+", foot) and f"soilctl {name} " in foot, verb
        # Nothing of the machine, and not where the page went.
        assert "/tmp" not in foot and "--out" not in foot and ".html" not in foot, verb
        sections = page.locator("h2").all_inner_texts()
        links = page.locator("nav.contents a").all_inner_texts()
        assert links == (sections if len(sections) >= 3 else []), verb
        for place in page.locator("nav.contents a").all():
            assert page.locator(place.get_attribute("href")).count() == 1
        styles.add(page.locator("style").first.inner_text())
    assert len(styles) == 1


def test_every_figure_of_a_page_is_a_file_in_three_forms(pages, bound, open_page):
    folders = {verb: pages[verb].with_suffix("") for verb in ("report", "process", "diagnose")} | {"bound": bound[0] / "figures"}
    for verb, folder in folders.items():
        names = {form: sorted(file.stem for file in folder.glob(f"*.{form}")) for form in ("svg", "png", "csv")}
        assert names["svg"] == names["png"] == names["csv"], verb
        count = open_page(pages[verb]).locator("figure").count()
        # The log has one stroke, and `process` draws each stroke once.
        assert len(names["svg"]) == count and (count == 1 if verb == "process" else count > 1), verb
        for file in folder.iterdir():
            assert file.stat().st_size > 100, file


def test_the_verdict_holds_the_bounds(bound, open_page):
    answer = bound[1]
    title = open_page(bound[0] / "plate.html").locator(".verdict .callout-title").inner_text()
    low, high = map(float, re.findall(r"\d+\.\d+", title))
    # Rounded outwards, or they would not be proven any more.
    assert low <= answer["lower"] <= answer["upper"] <= high
    assert low == pytest.approx(answer["lower"], rel=1e-3) and high == pytest.approx(answer["upper"], rel=1e-3)


def test_a_button_changes_the_colours(bound, open_page):
    page = open_page(bound[0] / "plate.html", color_scheme="light", reduced_motion="reduce")
    paper = "getComputedStyle(document.body).backgroundColor"
    plot = "document.querySelector('.js-plotly-plot')._fullLayout.paper_bgcolor"
    page.wait_for_selector(".js-plotly-plot .main-svg", state="attached")
    light = page.evaluate(paper), page.evaluate(plot)
    page.get_by_role("button", name="Dark colours").press("Enter")
    page.wait_for_timeout(500)
    dark = page.evaluate(paper), page.evaluate(plot)
    assert light != dark and page.evaluate("document.documentElement.dataset.theme") == "dark"
    page.get_by_role("button", name="Light colours").click()
    page.wait_for_timeout(500)
    assert (page.evaluate(paper), page.evaluate(plot)) == light
    assert page.problems == []


def moved(page):
    return float(page.locator("canvas").get_attribute("data-moved"))


def pixels(page):
    return np.array(Image.open(io.BytesIO(page.locator(".stage").screenshot())).convert("RGB")).astype(int)


def test_the_mechanism_stands_still_for_whoever_wants_less_motion(bound, open_page):
    page = open_page(bound[0] / "plate.html", reduced_motion="reduce")
    page.locator("figure.moving").scroll_into_view_if_needed()
    before = pixels(page)
    page.wait_for_timeout(700)
    assert moved(page) == 1 and (pixels(page) == before).all()
    # Asked for, it moves.
    page.get_by_role("button", name="Play").press("Enter")
    page.wait_for_timeout(700)
    assert moved(page) < 1
    page.get_by_role("button", name="Pause").press("Enter")


def test_the_mechanism_plays_and_obeys_the_keyboard(bound, open_page):
    page = open_page(bound[0] / "plate.html", reduced_motion="no-preference")
    page.locator("figure.moving").scroll_into_view_if_needed()
    # It begins once it is in view. The page's policy forbids scripts that are handed to it as text.
    for _ in range(100):
        if moved(page) < 1:
            break
        page.wait_for_timeout(100)
    assert moved(page) < 1
    button = page.get_by_role("button", name="Pause")
    button.focus()
    page.keyboard.press("Space")
    page.wait_for_timeout(200)
    stopped = moved(page)
    page.wait_for_timeout(400)
    assert moved(page) == stopped
    slider = page.get_by_role("slider", name="Moved")
    slider.focus()
    page.keyboard.press("Home")
    rest = pixels(page)
    assert moved(page) == 0 and slider.get_attribute("aria-valuetext") == "0 %"
    page.keyboard.press("ArrowRight")
    assert moved(page) == pytest.approx(0.01)
    page.keyboard.press("End")
    assert moved(page) == 1 and (np.abs(pixels(page) - rest).sum(axis=2) > 60).mean() > 0.02
    assert page.problems == []


def test_without_scripts_there_is_a_still(bound, open_page):
    page = open_page(bound[0] / "plate.html", java_script_enabled=False)
    figure = page.locator("figure.moving")
    assert figure.locator(".static svg").is_visible()
    assert not figure.locator(".motion").is_visible()


def test_pages_of_solutions_begin_with_the_problem(pages, open_page):
    """Upright plate in soil that goes on, and a footing on clay: what is given is drawn and named before what was found."""
    for verb in ("bound", "solve", "certify"):
        page = open_page(pages[verb])
        first = page.locator("figure").first
        drawn = first.locator(".static svg").text_content()
        assert page.locator("h2").first.inner_text().endswith("The problem"), verb
        for words in ("rigid structure", "free surface", "far base and side: the ground goes on", "whose force is bounded", "φ"):
            assert words in drawn, (verb, words)
    assert "clay: φ 0°, c 20 kPa + 2 kPa/m below y = 0 m, 16 kN/m³" in open_page(pages["solve"]).locator("figure").first.text_content()


def test_the_structure_moves_along_its_velocity_and_soil_as_the_bound_says(bound):
    # The plate is pushed to the right, as is said in the problem; the figure's end shows it there, at full height.
    # The first figure is the problem.
    with (bound[0] / "figures" / "figure-2.csv").open() as file:
        rows = list(csv.DictReader(file))
    layers = {}
    for row in rows:
        layers.setdefault(row["layer"], []).append((float(row["x"]), float(row["y"])))
    plate = np.array(layers[max(layers, key=int)])
    assert np.ptp(plate[:, 1]) == pytest.approx(1, abs=1e-6) and np.ptp(plate[:, 0]) == pytest.approx(0, abs=1e-6)
    assert plate[0, 0] > 0.01
    # Nothing that reaches the ground before the plate is drawn further than the ground moves.
    ahead = [s for s in bound[1]["results"]["moving_ground"] if s["to"][0] > 0.5][0]["to"][0]
    outline = np.array(layers[sorted(layers, key=int)[-2]])
    lifted = outline[outline[:, 1] > 0.005]
    assert len(lifted) and lifted[:, 0].min() > -0.1 and lifted[:, 0].max() < ahead + 0.15


def test_every_figure_is_there_in_three_forms(bound, open_page, soilctl, data, tmp_path):
    folder, answer = bound
    count = open_page(folder / "plate.html").locator("figure").count()
    names = {f"figure-{n}.{form}" for n in range(1, count + 1) for form in ("svg", "png", "csv")}
    assert {file.name for file in (folder / "figures").iterdir()} == names and count == 6
    assert {f"figures/{name}" for name in names} <= set(answer["results"]["files"])
    strokes = data / "soils" / "ticino_rained" / "strokes.csv"
    soilctl("report", strokes, "--delta", 23, "--density", 1600, "--out", tmp_path / "r.html", "--figures", tmp_path / "f", code=0)
    count = open_page(tmp_path / "r.html").locator("figure").count()
    assert len(list((tmp_path / "f").iterdir())) == 3 * count > 0
    for file in (tmp_path / "f").glob("*.png"):
        with Image.open(file) as image:
            assert min(image.size) >= 300


@pytest.mark.parametrize("form", ["SVG", "PNG"])
def test_a_page_saves_its_figures(bound, open_page, form, tmp_path):
    page = open_page(bound[0] / "plate.html", accept_downloads=True)
    with page.expect_download() as download:
        page.get_by_role("link", name=f"Figure 2 ({form})").click()
    file = tmp_path / download.value.suggested_filename
    download.value.save_as(file)
    if form == "SVG":
        assert file.name == "figure-2.svg" and file.read_text().lstrip().startswith("<svg")
    else:
        with Image.open(file) as image:
            assert np.ptp(np.array(image.convert("L"))) > 200
    assert page.problems == []


@pytest.mark.parametrize("verb", ["bound", "report", "process", "diagnose"])
def test_prints_are_whole_and_light(pages, verb, open_page):
    page = open_page(pages[verb], color_scheme="dark")
    page.wait_for_selector(".js-plotly-plot .main-svg", state="attached")
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert all(still.is_visible() for still in page.locator(".static svg").all())
    for hidden in ("nav.contents", ".theme", ".controls", ".save"):
        assert page.locator(hidden).count() == 0 or not page.locator(hidden).first.is_visible(), hidden
    # Nothing is cut off at the edge of a sheet.
    assert page.evaluate("document.documentElement.scrollWidth <= document.documentElement.clientWidth")


def test_the_same_command_gives_the_same_page(bound, soilctl):
    folder = bound[0]
    shutil.copy(folder / "plate.html", folder / "first.html")
    soilctl.json("bound", *PLATE, *BUDGET, "--report", "second.html", "--threads", 2, cwd=folder)
    assert (folder / "second.html").read_bytes() == (folder / "first.html").read_bytes()


def test_data_of_a_plot_without_a_page(soilctl, data, tmp_path):
    strokes = data / "soils" / "ticino_rained" / "strokes.csv"
    soilctl("estimate", strokes, "--delta", 23, "--density", 1600, "--plot", tmp_path / "region.csv", code=0)
    with (tmp_path / "region.csv").open() as file:
        assert {row["kind"] for row in csv.DictReader(file)} >= {"polygons"}
    answer = soilctl.json("bound", *PLATE, *BUDGET, "--figures", tmp_path / "only")
    assert len(answer["results"]["files"]) == 18 and json.dumps(answer)
