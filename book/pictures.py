"""Makes the pictures of docs/images that show pages: the monitor during a stroke, the same log in Rerun's viewer, the page of a plate, the
workbench with a solved footing, the plate's bench, a plate that is dragged through sand, and the same in a headset.

    cargo xtask pictures
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "python"))

from bench_page import READY, estimated, rested  # noqa: E402
from dig_page import READY as DIG_READY  # noqa: E402
from dig_page import Dig, drag, plate, rest, spot, take  # noqa: E402
from monitor_page import CHROMIUM_ARGS, Monitor, open_page, seek, still, write_plan  # noqa: E402
from playwright.sync_api import sync_playwright  # noqa: E402
from rerun_page import Viewer  # noqa: E402
from workbench_page import Workbench, begin, solve  # noqa: E402
from workbench_page import open_page as open_workbench  # noqa: E402
from xr_page import WithHeadset, dig_down, enter, grip, put, room, save, turn  # noqa: E402

IMAGES = ROOT / "docs" / "images"
# Where the monitor's picture is taken: share of the way through the last stroke.
SHARE = 0.85


def monitor(binary, browser, folder, path):
    """A stroke, seen from the side."""
    plan = write_plan(folder, [(-24.0, 80.0, 0.025), (24.0, 90.0, 0.025), (0.0, 80.0, 0.03)])
    subprocess.run([binary, "simulate", plan, "--out", folder / "out", "--quiet"], check=True, stdout=subprocess.DEVNULL)
    running = Monitor(binary, "--play", folder / "out" / "batch_000.mcap")
    page = open_page(browser, running.url, color_scheme="light")
    stroke = page.evaluate("monitor.player.log.strokes.at(-1)")
    seek(page, stroke["start_s"] + SHARE * (stroke["end_s"] - stroke["start_s"]))
    page.evaluate("monitor.scene.turn(-10, 2); monitor.scene.zoom(.82); document.getElementById('rate').hidden = true")
    still(page)
    page.screenshot(path=path)
    page.context.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def viewer(binary, browser, folder, path):
    """The log of `monitor` in Rerun's viewer."""
    recording = folder / "show.rrd"
    subprocess.run([binary, "view", folder / "out" / "batch_000.mcap", "--no-open", "--out", recording, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    running = Viewer(recording, folder)
    shown = browser.new_page(viewport={"width": 1400, "height": 900})
    shown.goto(running.url)
    # All is drawn on a canvas, which does not tell when it is done.
    shown.wait_for_timeout(40_000)
    shown.screenshot(path=path)
    shown.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def page(binary, browser, folder, path):
    """The page of a plate: verdict and mechanism."""
    plate = ["--alpha", "90", "--phi", "30", "--delta", "15", "--max-gap", "0.02"]
    subprocess.run([binary, "bound", *plate, "--report", folder / "plate.html", "--quiet"], check=True, stdout=subprocess.DEVNULL)
    context = browser.new_context(viewport={"width": 1000, "height": 1090}, color_scheme="light", reduced_motion="reduce")
    shown = context.new_page()
    shown.goto((folder / "plate.html").as_uri())
    shown.wait_for_selector("figure.moving.live canvas[data-moved]")
    shown.screenshot(path=path)
    context.close()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def workbench(binary, browser, folder, path):
    """A footing on sand, solved, displaced by half."""
    running = Workbench(binary, folder / "footing.toml")
    shown = open_workbench(browser, running.url, color_scheme="light", viewport={"width": 1280, "height": 760})
    begin(shown, "strip-footing")
    solve(shown, "0.03")
    shown.evaluate("workbench.view.fit([[-9, -6], [9, 3]])")
    shown.wait_for_timeout(300)
    shown.screenshot(path=path)
    shown.context.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def bench(binary, browser, _, path):
    """A plate in dense sand, and what four published strokes say."""
    running = Workbench(binary)
    shown = open_workbench(browser, running.url.replace("#", "plate.html#"), ready=READY, color_scheme="light", viewport={"width": 1400, "height": 900})
    shown.locator("#example").click()
    rested(shown)
    estimated(shown, with_next=True)
    shown.evaluate("document.querySelector('header').style.position = 'static'")
    shown.wait_for_timeout(300)
    shown.screenshot(path=path, full_page=True)
    shown.context.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def dig(binary, browser, folder, path):
    """A plate that was dragged through loose sand, pushing."""
    running = Dig(binary, folder)
    shown = open_workbench(browser, running.url, ready=DIG_READY, color_scheme="light", viewport={"width": 1280, "height": 800})
    take(shown)
    surface = shown.evaluate("dig.scene.sandbox.surface_z_m")
    shown.mouse.move(*spot(shown, *plate(shown)))
    shown.mouse.down()
    for place, speed in [((0.47, surface + 0.03), 0.07), ((0.47, surface - 0.035), 0.03), ((0.36, surface - 0.035), 0.03)]:
        drag(shown, place, speed)
    rest(shown, 0.3)
    shown.evaluate("document.getElementById('log').textContent = 'being written: dig.mcap'")
    shown.screenshot(path=path)
    shown.mouse.up()
    shown.context.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def headset(binary, browser, folder, path):
    """The same as both eyes see it, with a hand that pushes."""
    running = Dig(binary, folder)
    shown = open_workbench(WithHeadset(browser, "window.HEADSET_PX = 640;"), running.url, ready=DIG_READY, color_scheme="light")
    take(shown)
    enter(shown)
    hand = shown.evaluate("headset.add('right')")
    shown.evaluate("head => { headset.head = head; }", [[0.16, 1.55, -0.16], turn([1, -0.05, 0], -37)])
    edge = shown.evaluate("[dig.state.plate.x_m, dig.state.plate.y_m, dig.state.plate.z_m]")
    put(shown, hand, room(shown, edge) + [0.14, 0.14, 0.06], turn([1, 0, 0.5], 50))
    grip(shown, hand)
    dig_down(shown, hand)
    save(shown, path)
    shown.context.close()
    running.end()
    print(f"{path}: {Path(path).stat().st_size} bytes")


def main():
    binary = Path(os.environ["SOILCTL"]).resolve()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=CHROMIUM_ARGS)
        monitor(binary, browser, Path(folder), IMAGES / "monitor.png")
        viewer(binary, browser, Path(folder), IMAGES / "rerun.png")
        page(binary, browser, Path(folder), IMAGES / "page.png")
        workbench(binary, browser, Path(folder), IMAGES / "workbench.png")
        bench(binary, browser, Path(folder), IMAGES / "bench.png")
        dig(binary, browser, Path(folder), IMAGES / "dig.png")
        (Path(folder) / "headset").mkdir()
        headset(binary, browser, Path(folder) / "headset", IMAGES / "dig_headset.png")
        browser.close()


if __name__ == "__main__":
    main()
