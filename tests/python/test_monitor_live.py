"""`soilctl monitor` on a live session, in a browser."""

import subprocess
import time

import pytest
from monitor_page import CHROMIUM_ARGS, LONG_S, MOST_PX, ROOT, off_by, open_page, serve, still, until
from test_live import Operator, wait_for

# Taken by the fixture `browser`: this page needs WebGL.
__all__ = ["CHROMIUM_ARGS", "serve"]


class Run:
    """A live session in real time."""

    def __init__(self, binary, folder, name):
        self.socket = folder / "live"
        plan = ROOT / "data" / "plans" / "table_6_2.toml"
        words = [str(binary), "run", str(plan), "--socket", str(self.socket), "--log", str(folder / f"{name}.mcap"), "--real-time", "--quiet"]
        self.process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_for(self.socket, self.process)

    def end(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait(timeout=LONG_S)


@pytest.fixture
def run(soilctl, tmp_path):
    """Function that starts a session; whatever is left is ended."""
    runs = []

    def begin(name="run"):
        runs.append(Run(soilctl.binary, tmp_path, name))
        return runs[-1]

    yield begin
    for session in runs:
        session.end()


def first_word_is_on_top(page):
    """Whether nothing lies over the beginning of the banner."""
    return page.evaluate("""(() => { const banner = document.getElementById('banner'), range = document.createRange();
      range.setStart(banner.firstChild, 0);
      range.setEnd(banner.firstChild, 7);
      const {x, y, width, height} = range.getBoundingClientRect();
      return [.1, .5, .9].every(share => document.elementFromPoint(x + share * width, y + height / 2) === banner); })()""")


def test_a_live_session(serve, run):
    session = run()
    _, page = serve("--connect", session.socket)
    assert page.locator("#link").inner_text() == "live, real time"
    assert page.locator("#player").is_hidden() and page.locator("#commands").is_hidden()
    operator = Operator(session.socket)
    operator.ask(name="enable")
    picture = "document.querySelector('[data-chart=z]').toDataURL()"
    for target in [[10, 40, 90, 0, 30], [-15, 50, 80, 10, 40]]:
        before = page.evaluate(picture)
        operator.ask(name="move_joints", joints_deg=target)
        operator.wait_event("trajectory_ended/joint_move/completed")
        # The page may be some states behind.
        seen = {}
        until_s = time.monotonic() + 3

        def note(state, seen=seen, until_s=until_s):
            seen[state["tick"]] = state["joints_deg"]
            return time.monotonic() > until_s

        operator.wait_state(note)
        # The picture of one state, for as long as the screenshot takes.
        page.evaluate("monitor.scene.update = () => {}")
        still(page)
        page.evaluate("monitor.scene.draw(0)")
        still(page)
        tick = page.evaluate("Number(document.getElementById('scene').dataset.tick)")
        if tick not in seen:
            operator.wait_state(lambda state, seen=seen, tick=tick: seen.update({state["tick"]: state["joints_deg"]}) or state["tick"] >= tick)
        assert off_by(page, seen[tick]) <= MOST_PX
        page.evaluate("delete monitor.scene.update")
        assert page.evaluate(picture) != before
    assert "joint move" in page.locator("#events").inner_text()
    # The session ends, and another one begins.
    session.end()
    until(page, "document.getElementById('banner').textContent.includes('Session lost, reconnecting')")
    assert first_word_is_on_top(page)
    run("next")
    page.locator("#banner").wait_for(state="hidden")
    until(page, "monitor.state && monitor.state.time_s < 60")
    assert page.problems == [] and page.requests == []


def test_commands_from_the_page(serve, run, browser):
    session = run()
    monitor, page = serve("--connect", session.socket, "--commands")
    assert monitor.answer["commands"] and "#token=" in monitor.url
    page.locator("#commands").wait_for(state="visible")
    # The token is out of the address.
    assert "token" not in page.url
    page.get_by_role("button", name="enable", exact=True).click()
    until(page, "document.getElementById('answer').textContent.includes('done in tick')")
    until(page, "monitor.state.mode === 'ready'")
    page.locator("#text").fill("plan_index 60000")
    page.keyboard.press("Enter")
    until(page, "document.getElementById('answer').textContent.includes('refused')")
    page.locator("#stop").click()
    until(page, "monitor.state.mode === 'fault'")
    # A fault that has no number.
    until(page, "document.getElementById('readout').textContent.endsWith('emergency stop')")
    assert page.locator("#events li", has_text="fault · emergency stop").last.locator("b").inner_text() == ""
    stranger = open_page(browser, monitor.url.split("#")[0])
    stranger.evaluate("monitor.commands.line('reset')")
    until(stranger, "monitor.state")
    assert stranger.locator("#commands").is_hidden()
    assert stranger.locator("#stop").is_hidden()
    # The address with the token, opened in the tab that shows the page: only its end changes.
    stranger.evaluate("window.same = true")
    stranger.goto(monitor.url)
    stranger.locator("#commands").wait_for(state="visible")
    assert stranger.evaluate("window.same") and "token" not in stranger.url and stranger.locator("#locked").is_hidden()
    stranger.context.close()
    assert page.problems == []
    assert "commands need the token" in monitor.end()


def test_the_stop_is_at_hand(serve, run):
    session = run()
    _, page = serve("--connect", session.socket, "--commands", viewport={"width": 390, "height": 844})
    page.locator("#stop").wait_for(state="visible")
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    for end in [0, 1]:
        # It stays in sight.
        page.evaluate("end => scrollTo(0, end * document.documentElement.scrollHeight)", end)
        box = page.locator("#stop").bounding_box()
        assert box["x"] >= 0 and box["x"] + box["width"] <= 390 and box["y"] >= 0 and box["y"] + box["height"] <= 844
        assert page.evaluate("([x, y]) => document.elementFromPoint(x, y).id", [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]) == "stop"
    page.get_by_role("button", name="enable", exact=True).click()
    until(page, "monitor.state.mode === 'ready'")
    # By its key, also while a command is typed.
    page.locator("#text").fill("res")
    page.keyboard.press(".")
    page.keyboard.press("Control+.")
    until(page, "monitor.state.mode === 'fault'")
    assert page.locator("#text").input_value() == "res."
    assert page.problems == []
