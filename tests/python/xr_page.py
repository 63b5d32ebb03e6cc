"""What the tests of the view in a headset and its picture share: a headset that is made up, its picture, and its geometry."""

import base64
import io
import math
from pathlib import Path

import numpy as np
from dig_page import plate
from monitor_page import until
from PIL import Image

DEVICE = Path(__file__).parent / "xr_device.js"
# Tangents of the fields of view of `xr_device.js`: left, right, down, up; and how far the eyes are apart, in m.
FIELDS = [(-1.05, 0.9, -1.0, 0.95), (-0.9, 1.05, -1.0, 0.95)]
EYES_M = 0.064
STRAIGHT = [0, 0, 0, 1]


class WithHeadset:
    """A browser whose pages have the headset; `script` runs before it."""

    def __init__(self, browser, script="", device=True):
        self.browser = browser
        self.script = script + (DEVICE.read_text(encoding="utf-8") if device else "")

    def new_context(self, **options):
        context = self.browser.new_context(**options)
        context.add_init_script(script=self.script)
        return context


def enter(page, button="vr"):
    until(page, f"!document.getElementById('{button}').hidden")
    page.locator(f"#{button}").click()
    until(page, "dig.visit?.hands && headset.frames > 1")


def frames(page, count=2):
    """Waits for pictures that show what was changed."""
    until(page, f"headset.frames >= {page.evaluate('headset.frames') + count}")


def eyes(page):
    """What both eyes see: red, green, blue and opacity, rows from above."""
    both = np.frombuffer(base64.b64decode(page.evaluate("headset.picture()")), np.uint8)
    size = page.evaluate("window.HEADSET_PX ?? 120")
    both = both.reshape(size, 2 * size, 4)[::-1].astype(int)
    return both[:, :size], both[:, size:]


def save(page, path, colours=256):
    """Both eyes side by side."""
    picture = Image.fromarray(np.hstack(eyes(page))[..., :3].astype(np.uint8))
    held = io.BytesIO()
    picture.quantize(colours, dither=Image.Dither.NONE).save(held, "PNG", optimize=True)
    Path(path).write_bytes(held.getvalue())


def turn(axis, degrees):
    """A quaternion."""
    half = math.radians(degrees) / 2
    return [*(math.sin(half) * np.asarray(axis) / np.linalg.norm(axis)).tolist(), math.cos(half)]


def turned(quaternion, vector):
    """A vector turned by a quaternion, by its matrix."""
    x, y, z, w = quaternion
    matrix = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
              [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
              [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return np.array(matrix) @ vector


def in_room(page, direction):
    """A direction of the base frame in the room: z is up here, y there; then turned about the vertical."""
    angle = page.evaluate("dig.visit.place.turned")
    x, y, z = direction
    return np.array([x * math.cos(angle) - y * math.sin(angle), z, -x * math.sin(angle) - y * math.cos(angle)])


def room(page, point):
    """A point of the base frame in the room."""
    at, middle, scale = page.evaluate("[dig.visit.place.at, dig.visit.place.middle, dig.visit.place.scale]")
    return np.array(at) + scale * in_room(page, np.array(point) - middle)


def project(page, point, eye):
    """Where a point of the room is in the picture of an eye (0 left, 1 right), in pixels from its upper left corner."""
    (head, attitude), size = page.evaluate("headset.head"), page.evaluate("window.HEADSET_PX ?? 120")
    offset = turned(attitude, [(eye - 0.5) * EYES_M, 0, 0])
    x, y, z = turned([*(-np.array(attitude[:3])), attitude[3]], np.array(point) - head - offset)
    left, right, down, up = FIELDS[eye]
    return np.array([(x / -z - left) / (right - left), (up - y / -z) / (up - down)]) * size


def press(page, source):
    page.evaluate("k => headset.act('selectstart', k)", source)


def release(page, source):
    page.evaluate("k => headset.act('selectend', k)", source)


def put(page, source, place, attitude=STRAIGHT):
    page.evaluate("([k, at]) => { headset.session.inputSources[k].at = at; }", [source, [list(map(float, place)), list(attitude)]])


def place_of(page, source):
    return np.array(page.evaluate("k => headset.session.inputSources[k].at[0]", source))


def grip(page, source):
    """Takes hold of the plate."""
    press(page, source)
    until(page, "Boolean(dig.visit.grip.from)")


def rest(page):
    """Waits until the plate has stopped."""
    page.evaluate("() => { window.before = null; }")
    until(page, "(() => { const {x_m, y_m, z_m} = dig.state.plate, [x, y, z, t] = window.before ?? [0, 0, 0, 0]; if (dig.state.time_s < t + .4) return false;"
                " const still = Math.hypot(x_m - x, y_m - y, z_m - z) < 5e-4; window.before = [x_m, y_m, z_m, dig.state.time_s]; return still; })()")


def lead(page, source, way, speed_m_s=0.05):
    """Moves a hand by a way in the base frame at a speed of the session, and waits until the plate has stopped."""
    from_place, seconds = place_of(page, source), np.linalg.norm(way) / speed_m_s
    begin, share = page.evaluate("dig.state.time_s"), 0.0
    while share < 1.0:
        share = min(1.0, (page.evaluate("dig.state.time_s") - begin) / seconds)
        put(page, source, from_place + share * page.evaluate("dig.visit.place.scale") * in_room(page, way))
        page.wait_for_timeout(30)
    # The page sees a hand when it draws, which a slow machine does seldom.
    frames(page, 3)
    rest(page)


def dig_down(page, source):
    """Into the sand by 35 mm, and on towards the base; the soil pushes back at the end."""
    surface = page.evaluate("dig.scene.sandbox.surface_z_m")
    radius, z = plate(page)
    lead(page, source, [0.46 - radius, 0, surface + 0.02 - z])
    lead(page, source, [0, 0, -0.055], 0.03)
    lead(page, source, [-0.07, 0, 0], 0.02)
