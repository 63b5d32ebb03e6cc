"""`soilctl monitor`: the page on a log, in a browser."""

import csv
import json
import math

import numpy as np
import pytest
from monitor_page import CHROMIUM_ARGS, MOST_PX, SAFE_FORCE, Monitor, camera, marker, off_by, open_page, picture, places, project, seek, serve, still, until, write_plan

# Taken by the fixture `browser`: this page needs WebGL.
__all__ = ["CHROMIUM_ARGS", "serve"]


@pytest.fixture(scope="module")
def log(stroke_log):
    return stroke_log


@pytest.fixture(scope="module")
def joints(soilctl, log, tmp_path_factory):
    """The joints of each tick in degrees, as the log has them."""
    table = tmp_path_factory.mktemp("joints") / "steps.csv"
    soilctl("log", "export", log, "--out", table, code=0)
    with table.open(encoding="utf-8", newline="") as file:
        reader = csv.reader(file)
        head = next(reader)
        tick = head.index("tick")
        places = [k for k, name in enumerate(head) if name.startswith("external_joints_rad")]
        assert len(places) == 5, head
        return {int(row[tick]): [math.degrees(float(row[k])) for k in places] for row in reader}


def stroke_of(soilctl, log):
    """Begin and end of the first stroke in s."""
    text = soilctl("log", "info", log, code=0).stdout
    words = next(line for line in text.splitlines() if line.startswith("stroke:"))
    keys = dict(pair.rsplit(" ", 1) for pair in words.removeprefix("stroke: ").split(", "))
    return float(keys["start_s"]), float(keys["end_s"])


def test_the_end_point_is_drawn_where_it_is(serve, log, joints):
    _, page = serve("--play", log)
    last_s = max(joints) * 0.002
    errors = {}
    for view in ["home", "side", "top"]:
        page.evaluate("view => monitor.scene.show(view)", view)
        for time_s in [1.0, 0.2 * last_s, 0.45 * last_s, 0.6 * last_s, 0.97 * last_s]:
            tick = seek(page, time_s)
            assert abs(tick * 0.002 - time_s) <= 0.033
            errors[view, time_s] = off_by(page, joints[tick])
    # Turned and zoomed by keys.
    page.locator("#scene").focus()
    for key in ["ArrowLeft", "ArrowLeft", "ArrowUp", "+"]:
        page.keyboard.press(key)
    still(page)
    errors["keys", 0] = off_by(page, joints[tick])
    assert max(errors.values()) <= MOST_PX, errors
    assert page.problems == [] and page.requests == []


def drawn_by(page, change, least=40):
    """Pixels that are gone after a change of what the page knows, as places in the canvas; the page knows it again afterwards."""
    before, corner = picture(page)
    page.evaluate("change => { const {state, safeForce} = monitor.scene; monitor.kept = {state, safeForce}; monitor.scene.update({...state, ...change.state}, change.safe ? safeForce : null); }", change)
    still(page)
    after, _ = picture(page)
    page.evaluate("monitor.scene.update(monitor.kept.state, monitor.kept.safeForce)")
    still(page)
    return places(np.abs(before - after).max(axis=2) > least, corner)


@pytest.fixture(scope="module")
def guarded_log(soilctl, tmp_path_factory):
    """A log of a stroke under a table of safe forces."""
    folder = tmp_path_factory.mktemp("guarded")
    soilctl("simulate", write_plan(folder, [(20.0, 80.0, 0.02)]), "--out", folder / "out", code=0)
    return next((folder / "out").glob("*.mcap"))


def test_forces_and_leads_are_drawn_as_they_are(serve, soilctl, guarded_log):
    _, page = serve("--play", guarded_log)
    begin_s, end_s = stroke_of(soilctl, guarded_log)
    page.evaluate("monitor.scene.show('plate')")
    for share in [0.75, 0.9]:
        seek(page, begin_s + share * (end_s - begin_s))
        state = page.evaluate("monitor.state")
        assert state["trajectory"] == "stroke" and np.linalg.norm(state["force_rtz_n"]) > 3
        look, tip = camera(page), marker(page)
        x, y = state["plate"]["x_m"], state["plate"]["y_m"]
        out = np.array([x, y, 0]) / math.hypot(x, y)
        axes = np.array([out, [-out[1], out[0], 0], [0, 0, 1]])
        at = np.array([x, y, state["plate"]["z_m"]])
        lead = math.radians(state["lead_inclination_deg"])
        # 5 mm a newton, leads five times as long; the lead is wanted towards the base.
        ends = {
            "force": (at + 0.005 * np.array(state["force_rtz_n"]) @ axes, {"state": {"force_rtz_n": [0, 0, 0]}, "safe": True}),
            "lead": (at - 5 * state["lead_m"] * np.array([math.cos(lead), 0, math.sin(lead)]) @ axes, {"state": {"lead_m": None}, "safe": True}),
        }
        for name, (end, change) in ends.items():
            seen, wanted = drawn_by(page, change) - tip, project(end, look) - tip
            assert len(seen) > 60, name
            length = np.linalg.norm(wanted)
            along, across = seen @ wanted / length, seen @ [-wanted[1], wanted[0]] / length
            # From the disc to the end, and as far beyond it as the disc is wide.
            assert 0.9 * length < along.max() < 1.05 * length + 12, name
            assert along.min() > -2 and abs(np.median(across)) < 2 and np.abs(across).max() < 24, name
        # The fan of safe forces: what is seen of it lies within its outermost forces, and nearly fills them.
        angles, forces = (np.array(json.loads(words.split("=")[1])) for words in SAFE_FORCE)
        incline = np.radians(state["plate"]["tool_angle_deg"] - 90 + angles)
        rim = at + 0.005 * forces[:, None] * (np.column_stack([np.cos(incline), 0 * incline, np.sin(incline)]) @ axes)
        corners = np.array([project(point, look) for point in rim]) - tip
        fan = drawn_by(page, {"state": {}, "safe": False}, least=20) - tip
        around = np.vstack([[0, 0], corners])
        area = 0.5 * abs(np.sum(around[:, 0] * np.roll(around[:, 1], -1) - around[:, 1] * np.roll(around[:, 0], -1)))
        assert 0.7 * area < len(fan) < 1.1 * area
        assert (fan.min(axis=0) >= around.min(axis=0) - 4).all() and (fan.max(axis=0) <= around.max(axis=0) + 4).all()
    assert page.problems == []


def test_a_lost_view_comes_back_as_it_was(serve, log):
    _, page = serve("--play", log)
    seek(page, 1e9)
    before, _ = picture(page)
    page.evaluate("monitor.lose = monitor.scene.gl.getExtension('WEBGL_lose_context'); monitor.lose.loseContext()")
    page.locator("#no-webgl").wait_for(state="visible")
    page.evaluate("monitor.lose.restoreContext()")
    page.locator("#no-webgl").wait_for(state="hidden")
    still(page)
    after, _ = picture(page)
    assert np.mean(np.abs(before - after).max(axis=2) > 8) < 0.001
    # What was made for one scene is let go with it.
    count = page.evaluate("monitor.scene.meshes.length")
    page.evaluate("monitor.scene.describe(monitor.scene.description)")
    assert page.evaluate("monitor.scene.meshes.length") <= count


def test_a_damaged_log_is_played_and_said(soilctl, browser, log, tmp_path):
    torn = tmp_path / "torn.mcap"
    whole = log.read_bytes()
    torn.write_bytes(whole[: 2 * len(whole) // 3])
    monitor = Monitor(soilctl.binary, "--play", torn)
    page = open_page(browser, monitor.url)
    assert monitor.answer["damage"] and page.locator("#link").inner_text() == "log, damaged"
    assert page.locator("#damage li").all_inner_texts() == monitor.answer["damage"]
    page.context.close()
    assert "damaged: " in monitor.end(code=3)


def test_ticks_are_round_and_at_least_two(serve, log):
    _, page = serve("--play", log)
    for low, high, wanted in [(0, 7, 3), (-0.4, 1.9, 2), (-361, -330, 4), (0, 1e-3, 2), (97.4, 103.1, 1), (-20, 60, 2), (106.87, 136.87, 4.5)]:
        ticks = page.evaluate("([low, high, wanted]) => ticks(low, high, wanted)", [low, high, wanted])
        steps = np.diff(ticks)
        assert 2 <= len(ticks) <= 3 * wanted + 3 and low <= ticks[0] and ticks[-1] <= high
        assert np.allclose(steps, steps[0]) and float(f"{steps[0]:.0e}") == pytest.approx(steps[0])


def test_labels_of_a_chart_have_their_room(serve, log):
    _, page = serve("--play", log)
    for height in [46, 52, 64, 110]:
        for low, high in [(-361, -330), (-422, 395), (-340.4, -329.7), (0, 1.7), (-4, 71), (19, 47.2), (0, 40), (-20, 60), (-55.1, -44.9), (97.4, 103.1)]:
            shown = page.evaluate("([low, high, height]) => labels(low, high, height)", [low, high, height])
            places = np.array([place for _, place in shown])
            assert len(shown) >= 2 and (-np.diff(places) >= 12).all() and places.min() >= 9 and places.max() <= height, (low, high, height)
            # At its line, or as much below as the upper edge demands.
            lines = np.array([height - (level - low) / (high - low) * height for level, _ in shown])
            assert np.allclose(places, np.maximum(9, lines - 2))


# Curves of so many seconds at a spacing in s, without the seconds from 12 to 20.

CURVES = """spacing => {
  const time_s = Array.from({length: Math.round(30 / spacing)}, (_, k) => k * spacing).filter(time => time <= 12 || time >= 20);
  const of = value => time_s.map(() => value);
  monitor.charts.clear();
  monitor.charts.window_s = 30;
  monitor.charts.add({time_s, force_n: of(5), friction_angle_deg: of(20), friction_setpoint_deg: of(null), z_m: of(-.3), displacement_m: of(.0103), machine: of('stroke')});
  monitor.charts.draw();
}"""
# Of each hundredth of a chart's time, whether there is something of a colour in it.

INK = """([kind, name]) => {
  const canvas = document.querySelector(`[data-chart=${kind}]`), pen = canvas.getContext('2d'), {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
  pen.fillStyle = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const wanted = [1, 3, 5].map(at => parseInt(pen.fillStyle.slice(at, at + 2), 16)), found = Array(100).fill(false);
  for (let k = 0; k < data.length; k += 4)
    if (data[k + 3] > 100 && wanted.every((part, n) => Math.abs(part - data[k + n]) < 12)) found[Math.floor(k / 4 % canvas.width / canvas.width * 100)] = true;
  return found;
}"""


@pytest.mark.parametrize("spacing", [0.032, 0.064, 1.0])
def test_curves_and_bars_break_where_nothing_is_known(serve, log, spacing):
    _, page = serve("--play", log)
    page.evaluate(CURVES, spacing)
    last_s = 30 - spacing
    for kind, colour in [("force", "accent"), ("z", "accent"), ("displacement", "accent"), ("machine", "second")]:
        ink = page.evaluate(INK, [kind, colour])
        # Thinned curves are whole but there. Labels lie over the first seconds.
        for part, found in enumerate(ink):
            time = last_s - 30 + 0.3 * (part + 0.5)
            if abs(time - 12) > 0.5 and abs(time - 20) > 0.5 and time > 5:
                assert found == (not 12 < time < 20), (kind, time)
    # The pointer over what is not known finds no number.
    box = page.locator("[data-chart=force]").bounding_box()
    value = "document.querySelector('[data-chart=force]').parentElement.querySelector('b').textContent"
    for time, words in [(16, "–"), (25, "5.0 N"), (6, "5.0 N")]:
        page.mouse.move(box["x"] + box["width"] * (time - last_s + 30) / 30, box["y"] + 20)
        until(page, f"words => {value} === words", arg=words)
    assert page.problems == []


def test_the_plate_is_outlined_where_sand_hides_it(serve, soilctl, log):
    _, page = serve("--play", log)
    begin_s, end_s = stroke_of(soilctl, log)
    page.evaluate("monitor.scene.show('plate')")

    def outline():
        before, corner = picture(page)
        page.evaluate("monitor.scene.kept = monitor.scene.edges; monitor.scene.edges = []; monitor.scene.redraw()")
        still(page)
        after, _ = picture(page)
        page.evaluate("monitor.scene.edges = monitor.scene.kept; monitor.scene.redraw()")
        still(page)
        return places(np.abs(before - after).max(axis=2) > 30, corner)

    seek(page, 0.5 * (begin_s + end_s))
    state, width = page.evaluate("[monitor.state, monitor.scene.description.plate.width_m]")
    plate = state["plate"]
    at, across = np.array([plate["x_m"], plate["y_m"], plate["z_m"]]), np.array([-plate["y_m"], plate["x_m"], 0]) / math.hypot(plate["x_m"], plate["y_m"])
    ends = [project(at + side * 0.5 * width * across, camera(page)) for side in [-1, 1]]
    seen = outline()
    # All along the lower edge, but where the signs lie over it, and nowhere far from the plate.
    for share in np.linspace(0.05, 0.95, 13):
        place = ends[0] + share * (ends[1] - ends[0])
        assert 0.4 < share < 0.6 or np.linalg.norm(seen - place, axis=1).min() < 4, share
    length = np.linalg.norm(ends[1] - ends[0])
    assert np.linalg.norm(seen - 0.5 * (ends[0] + ends[1]), axis=1).max() < 1.2 * length
    # In the air there is nothing to outline.
    seek(page, 0.5)
    assert len(outline()) == 0
    assert page.problems == []


def test_a_log_says_what_the_soil_bears_safely(serve, soilctl, guarded_log):
    _, page = serve("--play", guarded_log)
    begin_s, end_s = stroke_of(soilctl, guarded_log)
    angles, forces = (json.loads(words.split("=")[1]) for words in SAFE_FORCE)
    for share in [0.2, 0.6, 0.9]:
        seek(page, begin_s + share * (end_s - begin_s))
        state = page.evaluate("monitor.state")
        wanted = np.interp(state["friction_angle_deg"], angles, forces)
        assert state["safe_force_n"] == pytest.approx(wanted, rel=1e-9)
        assert page.locator("#legend [data-key=safe] b").inner_text() == f"{wanted:.1f} N"
    seek(page, 0.5)
    assert page.evaluate("monitor.state.safe_force_n") is None and page.locator("#legend [data-key=safe] b").inner_text() == ""


def test_the_soil_has_a_furrow_and_a_heap_after_the_stroke(serve, soilctl, log):
    _, page = serve("--play", log)
    heights = "Array.from(monitor.scene.soil.heights)"
    seek(page, 0.5)
    assert max(map(abs, page.evaluate(heights))) == 0
    seek(page, stroke_of(soilctl, log)[1])
    stroke = np.array(page.evaluate(heights))
    assert stroke.min() < -0.005 and stroke.max() > 0.002
    # What is told is rounded to 0.01 mm a cell.
    assert abs(stroke.sum()) <= 0.5e-5 * np.count_nonzero(stroke)
    seek(page, 1e9)
    rest = np.array(page.evaluate(heights)).reshape(page.evaluate("monitor.scene.soil.rows"), -1)
    steepest = max(np.abs(np.diff(rest, axis=axis)).max() for axis in [0, 1]) / 0.005
    assert steepest <= math.tan(math.radians(43.4)) + 0.05
    # Back again it is level again.
    seek(page, 0.5)
    assert max(map(abs, page.evaluate(heights))) == 0
    # And whoever goes to the end at once sees what one sees who plays.
    _, other = serve("--play", log)
    seek(other, 1e9)
    assert np.array_equal(np.array(other.evaluate(heights)), rest.ravel())


def test_playing_scrubbing_and_keys(serve, log, joints):
    _, page = serve("--play", log)
    last_s = max(joints) * 0.002
    picture = "document.querySelector('[data-chart=force]').toDataURL()"
    before, frames = page.evaluate(picture), page.evaluate("Number(document.getElementById('scene').dataset.frames)")
    page.keyboard.press("+")
    page.keyboard.press(" ")
    until(page, "monitor.player.state.playing && monitor.state.time_s > 2")
    assert page.locator("#play").inner_text() == "Pause"
    assert page.evaluate(picture) != before
    assert page.evaluate("Number(document.getElementById('scene').dataset.frames)") > frames
    page.keyboard.press(" ")
    until(page, "!monitor.player.state.playing")
    # A click into the track lands on its time: a pixel is some tens of milliseconds.
    box = page.locator("#scrub").bounding_box()
    for share in [0.25, 0.5, 0.75]:
        page.mouse.click(box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        wanted = share * last_s
        until(page, "wanted => Math.abs(monitor.player.state.time_s - wanted) < 1 && monitor.player.settled", arg=wanted)
        still(page)
        shown = page.evaluate("[monitor.player.state.time_s, monitor.state.time_s, Number(document.getElementById('scene').dataset.tick) * .002]")
        assert abs(shown[0] - wanted) <= 3 * last_s / box["width"] + 0.01
        assert 0 <= shown[0] - shown[1] < 0.0321 and shown[1] == pytest.approx(shown[2])
        curve = page.evaluate("monitor.charts.time.at(-1)")
        assert curve == pytest.approx(shown[1])
    here = shown[1]
    page.locator("#scene").focus()
    for key, step in [(".", 0.032), (".", 0.064), (",", 0.032)]:
        page.keyboard.press(key)
        until(page, "wanted => Math.abs(monitor.state.time_s - wanted) < 1e-6", arg=here + step)
    page.keyboard.press("Home")
    until(page, "monitor.state.time_s === monitor.player.log.from_s")
    page.keyboard.press("?")
    assert page.locator("#help").is_visible()
    page.keyboard.press("Escape")
    page.locator("#events li[data-seek]").nth(3).click()
    until(page, "monitor.player.state.time_s > 0 && monitor.player.settled")
    # From event to event, and from state to state in the track.
    times = page.evaluate("monitor.panel.entries.map(entry => entry.time_s)")
    page.locator("#events ol").focus()
    marked = page.evaluate("monitor.panel.current")
    page.keyboard.press("ArrowDown")
    until(page, "wanted => Math.abs(monitor.player.state.time_s - wanted) < 1e-6 && monitor.player.settled", arg=times[marked + 1])
    here = page.evaluate("monitor.state.time_s")
    page.locator("#scrub").focus()
    page.keyboard.press("ArrowRight")
    until(page, "wanted => Math.abs(monitor.state.time_s - wanted) < 1e-6", arg=here + 0.032)
    page.keyboard.press("Shift+L")
    until(page, "wanted => Math.abs(monitor.player.state.time_s - wanted) < 0.05", arg=here + 5)
    assert page.problems == []


def burst(page, *keys):
    """Keys one after the other, before any answer can come."""
    page.evaluate("keys => { for (const key of keys) document.activeElement.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true})); }", keys)


def test_quick_keys_all_count(serve, log):
    _, page = serve("--play", log)
    begin_s = page.evaluate("monitor.player.log.from_s")
    shown = "[monitor.player.state.time_s, monitor.player.state.playing, monitor.player.state.speed]"

    def settled(*wanted):
        # At once, and when the monitor has answered.
        assert page.evaluate(shown) == pytest.approx(wanted)
        until(page, "monitor.player.settled")
        assert page.evaluate(shown) == pytest.approx(wanted)

    burst(page, "l", "l", "l", "l")
    settled(begin_s + 20, False, 1)
    assert abs(page.evaluate("monitor.state.time_s") - 20) < 0.033
    burst(page, "j", "l", "j", "j")
    settled(begin_s + 10, False, 1)
    burst(page, "+", "+", "+", "+", "-")
    settled(begin_s + 10, False, 10)
    burst(page, " ", " ", "-", "-", "-", " ", " ")
    until(page, "monitor.player.settled")
    time_s, playing, speed = page.evaluate(shown)
    assert not playing and speed == 1 and abs(time_s - 10) < 1
    burst(page, " ", " ", " ")
    until(page, "monitor.player.settled && monitor.player.state.playing")
    burst(page, " ")
    # From event to event, too.
    times = page.evaluate("monitor.panel.entries.map(entry => entry.time_s)")
    burst(page, "Home")
    page.locator("#events ol").focus()
    burst(page, "ArrowDown", "ArrowDown", "ArrowDown", "ArrowUp")
    until(page, "monitor.player.settled")
    wanted = sorted({time for time in times if time > begin_s + 1e-6})[1]
    assert page.evaluate(shown)[0] == pytest.approx(wanted)
    assert page.problems == []


def test_a_reload_keeps_looks_and_place(serve, log):
    monitor, page = serve("--play", log)
    seek(page, 9.0)
    assert page.evaluate("document.documentElement.dataset.theme") is None
    page.keyboard.press("d")
    burst(page, "+")
    page.reload()
    until(page, "monitor.state && monitor.player.settled && Math.abs(monitor.state.time_s - 9) < .04")
    assert page.evaluate("[document.documentElement.dataset.theme, monitor.player.state.speed, monitor.scene.look]") == ["dark", 2, "dark"]
    # Whoever comes anew begins at the beginning.
    page.goto(monitor.url + "?again")
    until(page, "monitor.state")
    assert page.evaluate("monitor.player.state.time_s") < 0.1
    # Where the browser keeps nothing, all the rest goes on.
    page.add_init_script("for (const name of ['localStorage', 'sessionStorage']) Object.defineProperty(window, name, {get() { throw new DOMException('blocked', 'SecurityError'); }});")
    page.reload()
    until(page, "monitor.state && monitor.player.log")
    page.keyboard.press("d")
    assert page.evaluate("document.documentElement.dataset.theme") == "dark"
    assert page.problems == []


def test_at_rest_nothing_is_counted_and_charts_have_names(serve, log):
    _, page = serve("--play", log)
    until(page, "document.getElementById('rate').textContent === ''")
    page.keyboard.press(" ")
    until(page, "/^[1-9]\\d* frames.s$/.test(document.getElementById('rate').textContent)")
    page.keyboard.press(" ")
    until(page, "document.getElementById('rate').textContent === ''")
    for canvas in page.locator("canvas").all():
        assert canvas.get_attribute("role") == "img" and canvas.get_attribute("aria-label")
    # What was lost, of a live session.
    lost = "dropped => { monitor.panel.show({...monitor.state, dropped}, true); return document.getElementById('lost').textContent; }"
    assert page.evaluate(lost, {"log_steps": 0, "states": 12, "events": 0, "messages": 3}) == "lost: 12 states, 3 messages"
    assert page.evaluate(lost, {"log_steps": 0, "states": 0, "events": 0, "messages": 0}) == ""


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_narrow_screen(serve, log, scheme):
    _, page = serve("--play", log, viewport={"width": 390, "height": 844}, color_scheme=scheme)
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    dark = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(20, 23, 26)"
    assert dark == (scheme == "dark")
    for name in ["#scene", "#play", "#scrub"]:
        box = page.locator(name).bounding_box()
        assert box["width"] > 20 and box["x"] >= 0 and box["x"] + box["width"] <= 390, name
    # Whatever takes the focus shows it.
    for _ in range(6):
        page.keyboard.press("Tab")
        style = page.evaluate("(() => { const style = getComputedStyle(document.activeElement); return [style.outlineStyle, style.outlineWidth]; })()")
        assert style == ["solid", "2px"]
    assert page.problems == []


def test_a_lost_monitor_is_said_and_found_again(serve, soilctl, log):
    monitor, page = serve("--play", log)
    seek(page, 5.0)
    monitor.end()
    page.locator("#banner").wait_for(state="visible")
    assert "reconnecting" in page.locator("#banner").inner_text()
    again = Monitor(soilctl.binary, "--play", log, listen=monitor.listen)
    try:
        page.locator("#banner").wait_for(state="hidden")
        # And it is where it was.
        until(page, "Math.abs(monitor.state.time_s - 5) < .04")
        # That the address was refused meanwhile is all that the browser has to say.
        assert all("ERR_CONNECTION_REFUSED" in problem or "WebSocket" in problem for problem in page.problems), page.problems
    finally:
        page.context.close()
        again.end()


def test_wrong_usage(soilctl, tmp_path):
    soilctl.refuses("monitor", mentions=["--connect"])
    soilctl.refuses("monitor", "--play", tmp_path / "none.mcap", mentions=["none.mcap"])
    soilctl.refuses("monitor", "--connect", tmp_path / "none", mentions=["none"])
    soilctl.refuses("monitor", "--play", "x.mcap", "--commands", mentions=["--commands"])
    soilctl.refuses("monitor", "--play", "x.mcap", "--listen", "nowhere", mentions=["--listen"])


def test_the_answer_has_its_schema(soilctl, log, validate):
    monitor = Monitor(soilctl.binary, "--play", log)
    monitor.end()
    validate(monitor.answer)
