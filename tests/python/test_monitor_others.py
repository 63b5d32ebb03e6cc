"""`soilctl monitor` on logs of other programs, and views that have all of an arm in them, in a browser."""

import math

import numpy as np
import pytest
from monitor_page import CHROMIUM_ARGS, MOST_PX, camera, marker, project, seek, serve, still, until
from rosbags.rosbag2 import StoragePlugin, Writer
from test_process import BIAS, DELTA, STORE, SURFACE_M, TYPES, URDF, motion, write_bag

# Taken by the fixture `browser`: this page needs WebGL.
__all__ = ["CHROMIUM_ARGS", "serve"]


@pytest.fixture(scope="module")
def six_joints(tmp_path_factory):
    """A bag of rosbags' writer: an arm of six joints and a gripper, without wrenches; its joints and their positions at a time."""
    places = {"pan": ("revolute", [0, 0, 0.09], "z"), "lift": ("revolute", [0, 0.13, 0], "y"), "elbow": ("revolute", [0, -0.12, 0.42], "y"),
              "wrist_1": ("revolute", [0, 0, 0.39], "y"), "wrist_2": ("continuous", [0, 0.1, 0], "z"), "wrist_3": ("revolute", [0, 0, 0.1], "y"),
              "flange": ("fixed", [0, 0.09, 0], "z"), "finger": ("prismatic", [0, 0.06, 0], "x")}
    links = ["base", *places]
    # Meshes are in files that a bag does not hold: such links are drawn as bones.
    urdf = "".join(f'<link name="{link}"><visual><geometry><mesh filename="package://a/{link}.stl"/></geometry></visual></link>' for link in links)
    urdf += '<link name="other_finger"/><joint name="other" type="prismatic"><parent link="flange"/><child link="other_finger"/>'
    urdf += '<axis xyz="1 0 0"/><mimic joint="finger" multiplier="-1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
    for parent, (name, (kind, xyz, axis)) in zip(links, places.items(), strict=False):
        urdf += f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{name}"/><origin xyz="{xyz[0]} {xyz[1]} {xyz[2]}"/>'
        urdf += f'<axis xyz="{" ".join(str(int(axis == a)) for a in "xyz")}"/><limit lower="-6" upper="6" effort="1" velocity="1"/></joint>'

    def positions(t):
        return {"pan": 0.5 * math.sin(0.3 * t), "lift": -0.8 + 0.3 * math.sin(0.5 * t), "elbow": 1.6 + 0.2 * math.sin(0.7 * t), "wrist_1": -0.8,
                "wrist_2": math.sin(t), "wrist_3": 0.3, "finger": 0.02 + 0.02 * math.sin(t)}

    def tip(t, link="finger"):
        """By hand: product of shifts and turns."""
        turn, at, values = np.eye(3), np.zeros(3), positions(t)
        for name, (kind, xyz, axis) in places.items():
            at = at + turn @ np.array(xyz)
            c, s = math.cos(values.get(name, 0)), math.sin(values.get(name, 0))
            if kind == "prismatic":
                at = at + turn @ np.array([values[name], 0, 0])
            elif kind != "fixed":
                turn = turn @ (np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) if axis == "z" else np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]))
            if name == link:
                return at
        raise AssertionError(link)

    path = tmp_path_factory.mktemp("six") / "bag"
    state, header, stamp = TYPES["sensor_msgs/msg/JointState"], TYPES["std_msgs/msg/Header"], TYPES["builtin_interfaces/msg/Time"]
    with Writer(path, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        words = TYPES["std_msgs/msg/String"]
        connection = writer.add_connection("/robot_description", words.__msgtype__, typestore=STORE)
        writer.write(connection, 0, STORE.serialize_cdr(words(data=f'<robot name="six">{urdf}</robot>'), words.__msgtype__))
        connection = writer.add_connection("/arm/joints", state.__msgtype__, typestore=STORE)
        for k in range(2000):
            values = positions(k / 100)
            # The gripper tells of itself, in messages of its own.
            for names in [list(values)[:6], ["finger"]]:
                ns = (1_700_000_000 * 100 + k) * 10_000_000
                message = state(header=header(stamp=stamp(sec=ns // 10**9, nanosec=ns % 10**9), frame_id=""), name=names,
                                position=np.array([values[name] for name in names]), velocity=np.array([]), effort=np.array([]))
                writer.write(connection, ns, STORE.serialize_cdr(message, state.__msgtype__))
    return next(path.glob("*.mcap")), tip


@pytest.mark.long
def test_a_view_has_all_of_the_arm_in_it(serve, stroke_log, six_joints):
    # All corners of bodies, and of the box, as the page draws them.
    points = """(() => { const {scene} = monitor, {sandbox} = scene.description, links = scene.arm.pose(scene.arm.values(scene.state, monitor.names));
      return [scene.arm.extent(links), sandbox && [sandbox.x_m, sandbox.y_m, [sandbox.floor_z_m, sandbox.top_z_m]]]; })()"""
    for number, path in enumerate([stroke_log, six_joints[0]]):
        _, page = serve("--play", path)
        for width, height in [(1280, 800), (1366, 668), (390, 844)]:
            page.set_viewport_size({"width": width, "height": height})
            for view in ["home", "side"]:
                # It is fitted at the middle, and the arm leaves it at the beginning.
                seek(page, 10.0)
                page.evaluate("view => monitor.scene.show(view)", view)
                for time_s in [10.0, 0.0, 15.0]:
                    seek(page, time_s)
                    found, box = page.evaluate(points)
                    if box:
                        found += [[x, y, z] for x in box[0] for y in box[1] for z in box[2]]
                    else:
                        assert number == 1
                    look = camera(page)
                    seen = np.array([project(np.array(point), look) for point in found])
                    assert (seen.min(axis=0) >= 4).all() and (seen.max(axis=0) <= [look["width"] - 4, look["height"] - 4]).all(), (view, time_s)
                    # And not lost in it.
                    assert ((seen.max(axis=0) - seen.min(axis=0)) / [look["width"], look["height"]]).max() > 0.4
        # Whoever turns it keeps it.
        page.locator("#scene").focus()
        page.keyboard.press("ArrowLeft")
        still(page)
        before = camera(page)
        seek(page, 0.0)
        assert camera(page) == before
        assert page.problems == []


def off_from(page, tip):
    return float(np.linalg.norm(marker(page) - project(np.asarray(tip), camera(page))))


def test_an_arm_of_another_program(serve, six_joints):
    log, tip = six_joints
    _, page = serve("--play", log)
    errors = {}
    for view in ["home", "side", "top"]:
        page.evaluate("view => monitor.scene.show(view)", view)
        for time_s in [0.5, 7.0, 13.0, 19.5]:
            seek(page, time_s)
            shown_s = page.evaluate("monitor.state.time_s")
            assert 0 <= time_s - shown_s <= 0.041
            errors[view, time_s] = off_from(page, tip(shown_s))
            assert page.evaluate("monitor.state.tip_m") == pytest.approx(list(tip(shown_s)), abs=1e-6)
    assert max(errors.values()) <= MOST_PX, errors
    # Curves of what there is, and nothing else.
    shown = page.evaluate("[...document.querySelectorAll('#charts figure')].filter(figure => !figure.hidden).map(figure => figure.querySelector('canvas').dataset.chart)")
    assert shown == ["z", "joints", "time"]
    text = page.locator("#readout").inner_text()
    assert "wrist_2" in text and "mm" in text
    assert page.evaluate("monitor.charts.data.positions.at(-1).length") == 7
    # A joint that follows another one, which the log does not name.
    other = page.evaluate("monitor.scene.arm.pose(monitor.scene.arm.values(monitor.state, monitor.names)).other_finger.slice(12, 15)")
    shown_s = page.evaluate("monitor.state.time_s")
    assert np.linalg.norm(np.array(other) - tip(shown_s, "flange")) == pytest.approx(0.02 + 0.02 * math.sin(shown_s), abs=1e-6)
    picture = "document.querySelector('[data-chart=joints]').toDataURL()"
    before = page.evaluate(picture)
    seek(page, 0.0)
    page.keyboard.press(" ")
    until(page, "monitor.player.state.playing && monitor.state.time_s > 1")
    assert page.evaluate(picture) != before
    assert page.locator("#events").is_hidden() and page.problems == [] and page.requests == []
    # Another link at which to look.
    _, page = serve("--play", log, "--plate-frame", "wrist_1")
    seek(page, 7.0)
    assert off_from(page, tip(page.evaluate("monitor.state.time_s"), "wrist_1")) <= MOST_PX


def test_forces_of_another_program(serve, soilctl, tmp_path):
    bag = write_bag(tmp_path, shuffle=True, frame="load_cell")
    urdf = tmp_path / "gantry.urdf"
    soilctl.refuses("monitor", "--play", bag, mentions=["--urdf", "bag"])
    urdf.write_text(URDF, encoding="utf-8")
    soilctl.refuses("monitor", "--play", bag, "--urdf", urdf, "--plate-frame", "nowhere", mentions=["nowhere", "blade_edge"])
    soilctl.refuses("monitor", "--play", bag, "--urdf", urdf, "--joint-topic", "/none", mentions=["/none", "/gantry/joints"])
    _, page = serve("--play", bag, "--urdf", urdf, "--plate-frame", "blade_edge", "--surface-z", SURFACE_M)
    for time_s in [1.5, 6.0, 8.0]:
        seek(page, time_s)
        state = page.evaluate("monitor.state")
        x, z, force = motion(state["time_s"])
        assert state["tip_m"] == pytest.approx([x, 0, z], abs=1e-6)
        assert off_from(page, [x, 0, z]) <= MOST_PX
        # The sensor's reading, not tared, turned by its 30 deg about y.
        turn = math.radians(30)
        root = np.array([math.cos(turn) * BIAS[0] + math.sin(turn) * BIAS[2], BIAS[1], -math.sin(turn) * BIAS[0] + math.cos(turn) * BIAS[2]])
        root += force * np.array([-math.cos(DELTA), 0, math.sin(DELTA)])
        # Joints and wrenches are up to 0.2 s apart in this bag.
        assert state["force_n"] == pytest.approx(root, abs=0.15)
    assert page.evaluate("monitor.charts.level_m") == SURFACE_M
    assert "0.4" not in page.locator("#legend").inner_text() and "force as read" in page.locator("#legend").inner_text()
    assert page.problems == []
