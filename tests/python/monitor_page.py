"""What the monitor's tests and its figures share: a browser with WebGL, a running monitor, and a projection of our own."""

import io
import json
import math
import re
import subprocess
import time
import tomllib
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
# Nothing takes so long, also on a busy machine.
LONG_S = 120
# WebGL in software, so that tests run anywhere.
CHROMIUM_ARGS = ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
                 "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
MARKER = (255, 0, 255)
# By which what is drawn may miss what was computed.
MOST_PX = 2.0

PLAN = """version = 1
design = "{design}"
soil = "ticino_rained"
model = "table"
controller = "controller.toml"
seed = 3

[[batches]]
strokes = [
{strokes}
]
"""
STROKE = "    {{ radius_m = 0.4318, base_deg = {base}, alpha_deg = {alpha}, depth_m = {depth}, delta_set_deg = 23.0 }},"
# Twice what the soil of these strokes bears at its peak, so that the fan is seen and never holds the stroke up.
SAFE_FORCE = ("angle_deg = [-20.0, 0.0, 10.0, 20.0, 30.0, 40.0]", "force_n = [13.0, 25.0, 31.0, 33.0, 29.0, 17.0]")


def write_plan(folder, strokes):
    """A plan of one batch, with a table of safe forces; strokes are (base angle, tool angle, depth)."""
    settings = (ROOT / "data" / "controller" / "default.toml").read_text(encoding="utf-8")
    for empty, filled in zip(["angle_deg = []", "force_n = []"], SAFE_FORCE, strict=True):
        assert empty in settings
        settings = settings.replace(empty, filled)
    (folder / "controller.toml").write_text(settings, encoding="utf-8")
    rows = [STROKE.format(base=base, alpha=alpha, depth=depth) for base, alpha, depth in strokes]
    path = folder / "plan.toml"
    path.write_text(PLAN.format(design="for the monitor", strokes="\n".join(rows)), encoding="utf-8")
    return path


class Served:
    """A running command that serves pages: what it says once it does is `answer`, with its `url`."""

    def __init__(self, binary, *words):
        words = [str(binary), *map(str, words), "--format", "json"]
        self.process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        text = ""
        while not text.endswith("\n}\n"):
            line = self.process.stdout.readline()
            assert line, f"it ended early: {self.process.communicate()}"
            text += line
        self.answer = json.loads(text)
        self.url = self.answer["url"]

    def end(self, code=0):
        """Ends it as Ctrl-C does; returns what it said on stderr."""
        if self.process.poll() is None:
            self.process.terminate()
        err = self.process.communicate(timeout=LONG_S)[1]
        assert self.process.returncode == code, err
        return err


class Monitor(Served):
    """A running `soilctl monitor`."""

    def __init__(self, binary, *options, listen="127.0.0.1:0"):
        super().__init__(binary, "monitor", *options, "--listen", listen)
        self.listen = self.answer["listen"]


def until(page, expression, arg=None):
    """Waits until an expression, or a function of `arg`, is true. Playwright's own way needs `eval`, which the page's policy forbids."""
    deadline = time.monotonic() + LONG_S
    while not page.evaluate(expression, arg):
        assert time.monotonic() < deadline, f"not within {LONG_S} s: {expression}"
        time.sleep(0.02)


def open_page(browser, url, **options):
    """A page in a context of its own; it carries `problems` and `requests` to elsewhere."""
    context = browser.new_context(**{"viewport": {"width": 1280, "height": 800}, **options})
    page = context.new_page()
    page.problems, page.requests = [], []
    page.on("console", lambda m: page.problems.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: page.problems.append(str(error)))
    own = re.match(r"http://([^/]+)/", url).group(1)
    page.on("request", lambda r: page.requests.append(r.url) if own not in r.url and not r.url.startswith("data:") else None)
    page.set_default_timeout(LONG_S * 1000)
    page.goto(url)
    until(page, "monitor.state && (monitor.scene.sand || monitor.names.length)")
    return page


def still(page):
    """Waits until what was asked for is drawn, in full."""
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => setTimeout(done, 50)))")
    until(page, "!monitor.scene.waiting && monitor.scene.level === 0")
    page.evaluate("() => { monitor.scene.gl.finish(); return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))); }")


def seek(page, time_s):
    """Goes to a time of a log; returns the tick that is drawn then."""
    page.evaluate("time_s => { monitor.state = null; monitor.player.seek(time_s); }", time_s)
    until(page, "monitor.state && document.getElementById('scene').dataset.tick == monitor.state.tick")
    still(page)
    return int(page.evaluate("document.getElementById('scene').dataset.tick"))


def picture(page):
    """The canvas as it is seen, without what lies over it, and its upper left corner's part of a pixel."""
    cover = "hidden => { for (const id of ['readout', 'legend', 'rate']) document.getElementById(id).hidden = hidden; }"
    page.evaluate(cover, True)
    image = np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB")).astype(int)
    page.evaluate(cover, False)
    box = page.evaluate("(() => { const {x, y, width, height} = document.getElementById('scene').getBoundingClientRect(); return [x, y, width, height]; })()")
    left, top, width, height = map(round, box)
    return image[top:top + height, left:left + width], np.array([left - box[0], top - box[1]])


def places(found, corner):
    """The middles of the pixels that are true."""
    rows, columns = np.nonzero(found)
    return np.column_stack([columns, rows]) + 0.5 + corner


def marker(page):
    """Place of the end-point's marker in the canvas, from a screenshot: the middle of its pixels."""
    part, corner = picture(page)
    found = np.abs(part - MARKER).max(axis=2) < 12
    assert found.sum() >= 12, f"only {found.sum()} pixels of the marker"
    return places(found, corner).mean(axis=0)


def tip_m(joints_deg, arm_file=ROOT / "data" / "arm" / "thesis.toml"):
    """The end-point from the arm file's lengths: turns about z, then y, then z, as its comments say."""
    links = tomllib.loads(arm_file.read_text(encoding="utf-8"))["links"]

    def turn(axis, degrees):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) if axis == "z" else np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])

    place, attitude = np.zeros(3), np.eye(3)
    lengths = ["base_height_m", "upper_arm_m", "forearm_m", "twist_m", "hand_m"]
    for axis, angle, length in zip("zyyzy", joints_deg, lengths, strict=True):
        attitude = attitude @ turn(axis, angle)
        place = place + attitude @ np.array([0.0, 0.0, links[length]])
    return place


def project(point, camera):
    """A point in the canvas, in pixels from its upper left corner: a pinhole at `eye`."""
    eye, target, up = (np.array(camera[key], float) for key in ["eye", "target", "up"])
    ahead = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(ahead, up)
    right /= np.linalg.norm(right)
    above = np.cross(right, ahead)
    x, y, depth = (np.dot(point - eye, axis) for axis in [right, above, ahead])
    scale = camera["height"] / 2 / math.tan(math.radians(camera["fov_deg"]) / 2) / depth
    return np.array([camera["width"] / 2 + scale * x, camera["height"] / 2 - scale * y])


def camera(page):
    return json.loads(page.evaluate("document.getElementById('scene').dataset.camera"))


def off_by(page, joints_deg):
    return float(np.linalg.norm(marker(page) - project(tip_m(joints_deg), camera(page))))


@pytest.fixture
def serve(soilctl, browser):
    """Function that starts a monitor and opens its page; all ends with the test."""
    monitors, pages = [], []

    def begin(*options, path="", listen="127.0.0.1:0", **looks):
        monitor = Monitor(soilctl.binary, *options, listen=listen)
        monitors.append(monitor)
        page = open_page(browser, monitor.url + path, **looks)
        pages.append(page)
        return monitor, page

    yield begin
    for page in pages:
        page.context.close()
    for monitor in monitors:
        if monitor.process.poll() is None:
            monitor.end(code=3 if monitor.answer["damage"] else 0)
