"""The view of `soilctl dig` in a headset, which is made up: what both eyes see, who holds the plate, and who lets it go."""

import math

import numpy as np
import pytest
from dig_page import READY, Dig, plate, take
from monitor_page import CHROMIUM_ARGS, until  # noqa: F401
from workbench_page import open_page
from xr_page import WithHeadset, dig_down, enter, eyes, frames, grip, in_room, lead, place_of, press, project, put, release, rest, room, turn, turned

# By which the edge may be beside the hand in free air, as docs/dig.md says.
PLAY_M = 0.02
NO_TOKEN = "window.dig?.state && dig.soil?.columns > 0"


@pytest.fixture
def dig(soilctl, tmp_path):
    running = Dig(soilctl.binary, tmp_path)
    yield running
    running.end()


@pytest.fixture
def pages(browser):
    """Function that opens the page with the headset; consoles stay empty, and nobody else is asked for anything."""
    opened = []

    def begin(url, ready=READY, script="", device=True, **options):
        opened.append(open_page(WithHeadset(browser, script, device), url, ready, **options))
        return opened[-1]

    yield begin
    for page in opened:
        assert page.problems == [] and page.requests == []
        page.context.close()


def shown(page):
    return [page.locator(f"#{name}").is_visible() for name in ["vr", "ar"]]


def add(page, handedness="right", kind="controller"):
    return page.evaluate("([hand, kind]) => headset.add(hand, kind)", [handedness, kind])


def said(page):
    return page.locator("#told").inner_text()


def begin(page):
    """In the headset with the plate taken and a hand 1 m behind the head, where no eye sees it."""
    take(page)
    enter(page)
    hand = add(page)
    put(page, hand, [0.2, 1.2, 1.0])
    rest(page)
    return hand


def test_buttons_are_there_only_where_a_headset_is(dig, pages):
    # The browser of the tests has WebXR and no headset; others have not even that.
    plain = pages(dig.url, device=False)
    assert plain.evaluate("isSecureContext && 'xr' in navigator") is True
    without = pages(dig.url, device=False, script="Object.defineProperty(Navigator.prototype, 'xr', {value: undefined});")
    take(without)
    for page in [plain, without]:
        assert shown(page) == [False, False] and page.locator("#headset").is_hidden()
        assert page.evaluate("performance.getEntriesByType('resource').some(({name}) => /visit|painter/.test(name))") is False
    # They come and go, also where there is little room.
    page = pages(dig.url, viewport={"width": 360, "height": 740})
    until(page, "!document.getElementById('vr').hidden")
    assert shown(page) == [True, False]
    for modes, wanted in [(["immersive-ar"], [False, True]), (["immersive-vr", "immersive-ar"], [True, True]), ([], [False, False])]:
        page.evaluate("modes => { headset.modes = modes; navigator.xr.dispatchEvent(new Event('devicechange')); }", modes)
        until(page, "([vr, ar]) => document.getElementById('vr').hidden !== vr && document.getElementById('ar').hidden !== ar", wanted)
        assert shown(page) == wanted and page.evaluate("document.documentElement.scrollWidth <= 360")


def orange(eye):
    """Pixels of the hand's target, in any light, with nothing before them."""
    red, green, blue = (eye[..., k] for k in range(3))
    return (red > 120) & (blue < 12) & (abs(green / np.maximum(red, 1) - 0.42 / 0.91) < 0.05)


@pytest.mark.long
def test_both_eyes_see_the_plate_where_it_is(dig, pages):
    page = pages(dig.url, script="window.HEADSET_PX = 640;", color_scheme="light")
    hand = begin(page)
    # The sand is half a metre below the eyes, ahead of them.
    assert np.allclose(page.evaluate("dig.visit.place.at"), [0, 1.1, -0.7], atol=1e-6)
    for head in [[[0, 1.6, 0], turn([1, 0, 0], -30)], [[0.25, 1.5, -0.1], turn([0.8, 0.6, 0.1], -35)]]:
        # The target stands ahead of the plate, which is told nothing of it.
        page.evaluate("head => { Object.assign(headset, {head}); dig.hand.blocked = Infinity; }", head)
        grip(page, hand)
        put(page, hand, place_of(page, hand) + in_room(page, [0.06, -0.06, 0]))
        frames(page, 3)
        views = eyes(page)
        target = page.evaluate("(({radius, base, z}) => [radius * Math.cos(base), radius * Math.sin(base), z])(dig.hand.target)")
        release(page, hand)
        middles = []
        for k, view in enumerate(views):
            rows, columns = np.nonzero(orange(view))
            assert len(rows) >= 12, f"eye {k} sees {len(rows)} pixels of the target"
            middles.append(np.array([np.median(columns) + 0.5, np.median(rows) + 0.5]))
            assert np.linalg.norm(middles[k] - project(page, room(page, target), k)) < 2.0
        wanted = [project(page, room(page, target), k) for k in range(2)]
        assert abs((middles[0] - middles[1] - wanted[0] + wanted[1])[0]) < 1.5
        # Background above, sand below, and eyes that do not see the same.
        assert np.abs(views[0][0, 0] - [233, 238, 243, 255]).max() <= 2
        assert (np.abs(views[0] - views[1]).max(axis=2) > 30).mean() > 0.05
        sand = page.evaluate("dig.scene.sandbox.surface_z_m")
        x, y = project(page, room(page, [0.55, 0.2, sand]), 0)
        red, green, blue, _ = views[0][round(y), round(x)]
        assert red > green > blue and red - blue > 40


def test_the_plate_follows_the_hand_and_stays_when_it_lets_go(dig, pages):
    page = pages(dig.url)
    hand = begin(page)
    before = plate(page)
    grip(page, hand)
    frames(page)
    # Nothing jumps, wherever the hand is.
    assert np.allclose(page.evaluate("[dig.hand.target.radius, dig.hand.target.z]"), before, atol=PLAY_M)
    lead(page, hand, [0, 0, 0.04])
    lead(page, hand, [0, 0, -0.04])
    # The drives have play in free air.
    assert np.allclose(plate(page), before, atol=PLAY_M)
    until(page, "dig.state.led?.hand === dig.hand.number")
    middle, height = page.evaluate("[dig.hand.target.z, dig.state.plate.z_m]")
    lead(page, hand, [0.02, 0.03, -0.04])
    assert page.evaluate("dig.hand.target.z") == pytest.approx(middle - 0.04, abs=1e-4)
    assert plate(page)[1] == pytest.approx(middle - 0.04, abs=PLAY_M)
    assert plate(page)[1] < height - 0.025
    # Turned with the hand while it is squeezed: here as the plate's own direction is turned by the same rotation.
    base, tool = page.evaluate("[dig.hand.target.base, dig.hand.target.tool]")
    out, up = in_room(page, [math.cos(base), math.sin(base), 0]), np.array([0.0, 1.0, 0.0])
    rotation = turn(np.cross(out, up), 20)
    along = turned(rotation, math.cos(math.radians(tool)) * out + math.sin(math.radians(tool)) * up)
    wanted = math.degrees(math.atan2(along @ up, along @ out))
    put(page, hand, place_of(page, hand), turn(up, 15))
    frames(page, 3)
    assert page.evaluate("dig.hand.target.tool") == tool
    page.evaluate("headset.act('squeezestart', 0)")
    put(page, hand, place_of(page, hand))
    frames(page, 3)
    # A turn about the vertical is none about the plate's edge.
    assert page.evaluate("dig.hand.target.tool") == pytest.approx(tool, abs=0.5)
    put(page, hand, place_of(page, hand), rotation)
    frames(page, 3)
    assert wanted > tool + 19 and page.evaluate("dig.hand.target.tool") == pytest.approx(wanted, abs=0.5)
    until(page, f"Math.abs(dig.state.plate.tool_angle_deg - {wanted}) < 2")
    page.evaluate("headset.act('squeezeend', 0)")
    # As far as the page's own hand may go, and not further.
    put(page, hand, place_of(page, hand) + [0, 3.0, 0])
    frames(page, 3)
    assert page.evaluate("dig.hand.target.z - dig.state.plate.z_m") < 0.16
    assert page.evaluate("dig.hand.target.z") <= page.evaluate("dig.scene.hand.height_m[1]")
    release(page, hand)
    until(page, "dig.state.led === null && !dig.hand.grips()")
    at = plate(page)
    # What moved swings out first.
    rest(page)
    assert np.allclose(plate(page), at, atol=2 * PLAY_M)
    at = plate(page)
    put(page, hand, place_of(page, hand) - [0, 1.0, 0])
    frames(page, 3)
    page.wait_for_timeout(300)
    assert page.evaluate("dig.hand.grips()") is False and np.allclose(plate(page), at, atol=PLAY_M)


@pytest.mark.long
def test_whatever_ends_the_grip_lets_go(dig, pages):
    page = pages(dig.url)
    hand = begin(page)
    put_back = "headset.session.inputSources[0].at = [[.2, 1.2, 1], [0, 0, 0, 1]]"
    ends = [
        ("headset.see('visible-blurred')", "headset.see('visible')"),
        ("headset.see('hidden')", "headset.see('visible')"),
        ("headset.session.inputSources[0].at = null", put_back),
        ("headset.session.inputSources[0].guessed = true", "headset.session.inputSources[0].guessed = false"),
        ("headset.tracked = false", "headset.tracked = true"),
        ("dig.hand.letGo()", "0"),
        ("dig.link.socket.close()", "0"),
        ("headset.remove(0)", "headset.add('right')"),
    ]
    for end, back in ends:
        grip(page, hand)
        until(page, "dig.state.led?.hand === dig.hand.number")
        page.evaluate(f"() => {{ {end}; }}")
        until(page, "!dig.hand.dragged")
        until(page, "dig.authorized && dig.state.led === null && dig.state.mode === 'ready'")
        page.evaluate(f"() => {{ {back}; }}")
        frames(page, 3)
        # It takes a new grip.
        assert page.evaluate("dig.hand.dragged || dig.visit.grip.source !== null") is False, end
        if "remove" not in end:
            release(page, hand)
        frames(page)
    grip(page, hand)
    until(page, "dig.state.led !== null")
    page.evaluate("headset.session.end()")
    until(page, "dig.visit === null && !dig.hand.grips() && dig.state.led === null")
    assert page.locator("#vr").inner_text() == "Enter VR" and said(page) == "Back on the page."
    # The button leaves, too.
    enter(page)
    assert page.locator("#vr").inner_text() == "Leave VR"
    page.locator("#vr").click()
    until(page, "dig.visit === null && headset.session === null")


@pytest.mark.long
def test_the_controller_shakes_with_the_force_and_its_button_stops_the_arm(dig, pages):
    page = pages(dig.url)
    hand = begin(page)
    grip(page, hand)
    dig_down(page, hand)
    assert page.evaluate("dig.soil.extremes()[0]") < -0.015
    pulses = page.evaluate("headset.pulses")
    shares, values = np.array([[min(1.0, one["force_n"] / page.evaluate("dig.scene.hand.force_n")), one["value"]] for one in pulses]).T
    # They grow with the force; how it fluctuates adds to them.
    assert len(pulses) > 10 and shares.max() > 0.15
    assert (values >= np.minimum(1.0, 0.8 * shares) - 1e-9).all() and (values <= 0.8 * shares + 0.3 + 1e-9).all()
    assert values[shares > np.quantile(shares, 0.7)].min() > values[shares < np.quantile(shares, 0.3)].min()
    until(page, "dig.visit.painter.says.depth_m > .025")
    says = page.evaluate("dig.visit.painter.says")
    assert says["force_n"] > 2.0 and says["warning"] == ""
    count = len(page.evaluate("headset.pulses"))
    release(page, hand)
    page.wait_for_timeout(500)
    assert len(page.evaluate("headset.pulses")) <= count + 1
    # The upper button is the emergency stop, once a press; the board says what the page says, and the next grip takes the plate again.
    page.evaluate("() => { headset.session.inputSources[0].gamepad.buttons[5].pressed = true; }")
    until(page, "dig.state.mode === 'fault'")
    until(page, "dig.visit.painter.says.warning.startsWith('The arm is off')")
    grip(page, hand)
    until(page, "dig.state.mode === 'ready' && dig.state.led?.hand === dig.hand.number")


def test_what_refuses_a_view_is_said(dig, pages):
    page = pages(dig.url)
    until(page, "!document.getElementById('vr').hidden")
    for name, words in [("NotSupportedError", "lacks what the view needs"), ("NotAllowedError", "not allowed"), ("InvalidStateError", "close it first"), ("OddError", "something went wrong")]:
        page.evaluate("name => { headset.refuse = [name, 'the headset sleeps']; }", name)
        page.locator("#vr").click()
        until(page, f"document.getElementById('told').textContent.includes({words!r})")
        assert "the headset sleeps" in said(page) and page.locator("#told").get_attribute("data-tone") == "bad"
        assert page.locator("#vr").inner_text() == "Enter VR"
    page.evaluate("() => { headset.refuse = null; }")
    # Whoever presses nothing gets no session.
    enter(page)
    page.evaluate("dig.visit.painter.gl.getExtension('WEBGL_lose_context').loseContext()")
    until(page, "dig.visit === null && headset.session === null")
    assert "lost the view" in said(page)
    # No floor is known, and the sand is before the head all the same.
    page.evaluate("() => { headset.hasFloor = false; headset.frames = 0; }")
    enter(page)
    assert np.allclose(page.evaluate("dig.visit.place.at"), [0, -0.5, -0.7], atol=1e-6)
    assert page.evaluate("dig.visit.painter.floor_z_m") is None


@pytest.mark.long
def test_who_watches_moves_the_sandbox_and_not_the_plate(dig, pages):
    page = pages(dig.url.partition("#")[0], NO_TOKEN)
    enter(page)
    right, left = add(page), add(page, "left")
    until(page, "dig.visit.painter.says.warning.startsWith('Watching only')")
    press(page, right)
    frames(page, 3)
    assert page.evaluate("dig.hand.target === null && !dig.hand.grips() && dig.visit.grip.source === null")
    # Two hands carry it: what they hold stays in them.
    put(page, right, [0.3, 1.0, -0.5])
    put(page, left, [-0.3, 1.0, -0.5])
    press(page, left)
    frames(page, 3)
    held = [page.evaluate("p => dig.visit.place.toBase(p)", list(place_of(page, hand))) for hand in (right, left)]
    put(page, right, [0.2, 1.2, -1.0])
    put(page, left, [0.1, 1.2, 0.1])
    frames(page, 3)
    for hand, point in zip((right, left), held, strict=True):
        assert np.allclose(room(page, point), place_of(page, hand), atol=1e-6)
    assert page.evaluate("dig.visit.place.scale") == pytest.approx(math.hypot(0.1, 1.1) / 0.6, rel=1e-6)
    release(page, right)
    release(page, left)
    page.evaluate("headset.recentre()")
    frames(page, 3)
    at, turned_by = page.evaluate("[dig.visit.place.at, dig.visit.place.turned]")
    assert np.allclose(at, [0, 1.1, -0.7], atol=1e-6) and page.evaluate("dig.visit.place.scale") == 1
    stick = "([k, x, y]) => { headset.session.inputSources[k].gamepad.axes = [0, 0, x, y]; }"
    for hand, axes, moved in [
        (left, [1, 0], "dig.visit.place.at[0] > .1"), (left, [0, -1], "dig.visit.place.at[2] < -.8"), (right, [0, -1], "dig.visit.place.at[1] > 1.2"),
        (right, [1, 0], f"dig.visit.place.turned > {turned_by + 0.3}"),
    ]:
        page.evaluate(stick, [hand, *axes])
        until(page, moved)
        page.evaluate(stick, [hand, 0, 0])
    page.evaluate("headset.act('squeezestart', 1)")
    page.evaluate(stick, [left, 0, -1])
    until(page, "dig.visit.place.scale === 4")
    page.evaluate(stick, [left, 0, 1])
    until(page, "dig.visit.place.scale === .5")
    page.evaluate(stick, [left, 0, 0])
    page.evaluate("() => { headset.session.inputSources[0].gamepad.buttons[3].pressed = true; }")
    until(page, "dig.visit.place.scale === 1")
    assert np.allclose(page.evaluate("dig.visit.place.at"), at, atol=1e-6)


@pytest.mark.long
def test_through_the_room_and_by_finger(dig, pages):
    page = pages(dig.url, script="window.HEADSET_PX = 240;")
    page.evaluate("() => { Object.assign(headset, {modes: ['immersive-ar'], blend: 'alpha-blend', head: [[0, 1.6, 0], [-.259, 0, 0, .966]]}); navigator.xr.dispatchEvent(new Event('devicechange')); }")
    take(page)
    enter(page, "ar")
    frames(page)
    left, _ = eyes(page)
    # What is not drawn lets the room through, sand does not.
    assert (left[..., 3] == 0).mean() > 0.1 and left[0, 0, 3] == 0
    x, y = project(page, room(page, [0.55, 0.2, page.evaluate("dig.scene.sandbox.surface_z_m")]), 0)
    assert left[round(y), round(x), 3] == 255
    # A finger's ray leads the plate at the distance that it had.
    finger = add(page, "none", "screen")
    eye = np.array([0, 1.6, 0])
    tip = room(page, page.evaluate("[dig.state.plate.x_m, dig.state.plate.y_m, dig.state.plate.z_m]"))

    def aim(point):
        way = (np.array(point) - eye) / np.linalg.norm(np.array(point) - eye)
        axis = np.cross([0, 0, -1], way)
        put(page, finger, eye, turn(axis, math.degrees(math.atan2(np.linalg.norm(axis), -way[2]))))

    aim(tip)
    grip(page, finger)
    frames(page)
    z = page.evaluate("dig.hand.target.z")
    aim(tip + [0, 0.03, 0])
    frames(page, 3)
    far = np.linalg.norm(tip - eye)
    up = tip + [0, 0.03, 0] - eye
    assert page.evaluate("dig.hand.target.z") - z == pytest.approx((eye + up * far / np.linalg.norm(up) - tip)[1], abs=0.002)
    page.evaluate("headset.remove(0)")
    until(page, "!dig.hand.grips() && dig.state.led === null")
