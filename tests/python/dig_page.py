"""What the tests of `soilctl dig` and its picture share: a running one, and a pointer that drags by the clock of the session."""

import time

from monitor_page import LONG_S, Served, until

READY = "window.dig?.authorized && dig.state && dig.soil?.columns > 0"
SECTION = "document.getElementById('section').getBoundingClientRect()"


class Dig(Served):
    """A running `soilctl dig`."""

    def __init__(self, binary, folder):
        self.folder = folder
        super().__init__(binary, "dig", "--soil", "ticino_loose", "--log", folder / "dig.mcap", "--socket", folder / "live", "--device", folder / "hand",
                         "--listen", "127.0.0.1:0")


def take(page):
    page.locator("#take").click()
    until(page, "dig.state.mode === 'ready' && document.getElementById('told').textContent.includes('yours')")
    # It is brought from where it is parked.
    until(page, "!dig.hand.grips() && dig.state.plate.z_m < dig.scene.sandbox.surface_z_m + .1")
    page.wait_for_timeout(100)


def spot(page, radius, z):
    """Where a radius and height are in the window, in px."""
    return page.evaluate(f"([r, z]) => {{ const [x, y] = dig.section.to(r, z), box = {SECTION}; return [box.x + x, box.y + y]; }}", [radius, z])


def plate(page):
    """Radius and height of the edge in m."""
    return page.evaluate("[Math.hypot(dig.state.plate.x_m, dig.state.plate.y_m), dig.state.plate.z_m]")


def drag(page, to, speed_m_s):
    """Moves the pointer, which is down, to a radius and height, by the clock of the session; a slow machine takes longer."""
    [r0, z0], [r1, z1] = page.evaluate("[dig.hand.target.radius, dig.hand.target.z]"), to
    seconds = ((r1 - r0) ** 2 + (z1 - z0) ** 2) ** 0.5 / speed_m_s
    begin = page.evaluate("dig.state.time_s")
    deadline = time.monotonic() + LONG_S
    while True:
        share = min(1.0, (page.evaluate("dig.state.time_s") - begin) / seconds)
        page.mouse.move(*spot(page, r0 + share * (r1 - r0), z0 + share * (z1 - z0)))
        if share == 1.0:
            return
        assert time.monotonic() < deadline
        time.sleep(0.03)


def rest(page, seconds):
    begin = page.evaluate("dig.state.time_s")
    until(page, f"dig.state.time_s > {begin + seconds}")
