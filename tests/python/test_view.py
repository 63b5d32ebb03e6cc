"""`soilctl view`: the recording, read back with Rerun's own package and compared with the log; the layout for Foxglove."""

import json
import os
import re
import shutil
import subprocess
import time
import tomllib
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
import rerun.chunk
from conftest import decoded
from mcap.reader import make_reader
from mcap.writer import Writer
from monitor_page import CHROMIUM_ARGS, LONG_S, ROOT, SAFE_FORCE
from rerun_page import RERUN, Viewer, picture, share

FORCE_M_PER_N = 0.005
LEAD_SCALE = 5.0

# Taken by the fixture `browser`: the viewer needs WebGL.
__all__ = ["CHROMIUM_ARGS"]

# The index at the end of a recording is optional, and left out.
pytestmark = pytest.mark.filterwarnings("ignore:RRD file has no footer")


@pytest.fixture(scope="module")
def log(stroke_log, tmp_path_factory):
    """A copy, since a recording is written beside it."""
    return shutil.copy(stroke_log, tmp_path_factory.mktemp("view") / stroke_log.name)


@pytest.fixture(scope="module")
def messages(log):
    return decoded(log)


@pytest.fixture(scope="module")
def answer(soilctl, log):
    return soilctl.json("view", log, "--no-open")


@pytest.fixture(scope="module")
def recording(answer):
    return Recording(Path(answer["recording"]))


class Recording:
    """Entities of a recording: components of all rows that have a time, and of those that always hold."""

    def __init__(self, path):
        self.reader = rerun.chunk.RrdReader(path)
        self.rows, self.fixed, self.times = {}, {}, {}
        for chunk in self.reader.stream():
            batch = chunk.to_record_batch()
            kinds = {field.name: field.metadata[b"rerun:kind"] for field in batch.schema}
            target = self.fixed if chunk.is_static else self.rows
            entity = target.setdefault(str(chunk.entity_path), {})
            for name, column in zip(batch.schema.names, batch.columns, strict=True):
                if kinds[name] == b"data":
                    entity.setdefault(name, []).extend(column.to_pylist())
                elif kinds[name] == b"index":
                    times = self.times.setdefault(str(chunk.entity_path), [])
                    times.extend(column.cast("int64").to_pylist())

    def blueprint(self):
        """Entity to values of its components, the only row of each."""
        (store,) = self.reader.blueprints()
        assert store.application_id == self.reader.recordings()[0].application_id == "soilctl"
        found = {}
        for chunk in self.reader.stream(store=store):
            batch = chunk.to_record_batch()
            for field, column in zip(batch.schema, batch.columns, strict=True):
                if field.metadata[b"rerun:kind"] == b"data":
                    (found.setdefault(str(chunk.entity_path), {})[field.name],) = column.to_pylist()
        return found

    def vectors(self, entity):
        """Arrows as arrays, one a row: where from, and how far."""
        columns = self.rows[entity]
        return [np.array([[row[0] if row else [np.nan] * 3][0] for row in columns[f"Arrows3D:{part}"]]) for part in ("origins", "vectors")]


def turn(axis, angles):
    """Rotation matrices about an axis, one for each angle (Rodrigues)."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angles = np.asarray(angles)[:, None, None]
    return np.eye(3) + np.sin(angles) * cross + (1 - np.cos(angles)) * (cross @ cross)


class Chain:
    """Forward kinematics from the URDF alone."""

    def __init__(self, text):
        self.joints = {joint.find("child").get("link"): joint for joint in ET.fromstring(text).findall("joint")}
        self.names = [joint.get("name") for joint in self.joints.values() if joint.get("type") == "revolute"]

    def frame(self, link, positions):
        """Rotations and origins of a link in the base frame; `positions` has a column for each joint."""
        count = len(positions)
        rotation, origin = np.broadcast_to(np.eye(3), (count, 3, 3)), np.zeros((count, 3))
        while link in self.joints:
            joint = self.joints[link]
            place = joint.find("origin")
            xyz, (roll, pitch, yaw) = ([float(v) for v in place.get(key).split()] for key in ("xyz", "rpy"))
            fixed = (turn([0, 0, 1], [yaw]) @ turn([0, 1, 0], [pitch]) @ turn([1, 0, 0], [roll]))[0]
            if joint.get("type") == "revolute":
                axis = [float(v) for v in joint.find("axis").get("xyz").split()]
                fixed = fixed @ turn(axis, positions[:, self.names.index(joint.get("name"))])
            rotation = fixed @ rotation
            origin = (fixed @ origin[:, :, None])[:, :, 0] + xyz
            link = joint.find("parent").get("link")
        return rotation, origin


@pytest.fixture(scope="module")
def chain(messages):
    return Chain(messages["/robot_description"][0][1].data)


def positions(messages, topic):
    return np.array([message.position for _, message in messages[topic]])


def rtz_to_base(rtz, base_rad):
    """Along r, t, z of the base joint to x, y, z."""
    (r, t, z), cos, sin = np.asarray(rtz).T, np.cos(base_rad), np.sin(base_rad)
    return np.stack([r * cos - t * sin, r * sin + t * cos, z], axis=1)


def close(found, expected):
    """Equal to single precision."""
    scale = max(1e-3, np.abs(expected).max())
    return found.shape == expected.shape and np.abs(found - expected).max() <= 1e-6 * scale


def strokes(messages):
    """Steps within strokes, and how many of these come to an end within the log."""
    inside = [step.trajectory == "stroke" for _, step in messages["/controller/step"]]
    ends = sum(before and not after for before, after in zip(inside, inside[1:]))
    return [step for (_, step), here in zip(messages["/controller/step"], inside) if here], ends


def test_rows_are_the_messages(answer, validate, recording, messages):
    validate(answer)
    count = {topic: len(found) for topic, found in messages.items()}
    steps = [step for _, step in messages["/controller/step"]]
    in_stroke, ends = strokes(messages)
    assert in_stroke and ends
    hand = "/world/base_link/column_link/upper_arm_link/forearm_link/twist_link/hand_link"
    links = hand.split("/")[3:]
    expected = {"/world/base_link/" + "/".join(links[: k + 1]): count["/tf"] for k in range(len(links))}
    expected |= {place: count["/tf_static"] for place in (f"{hand}/ft_sensor", f"{hand}/plate_tip", "/world/base_link/soil_surface")}
    expected |= dict.fromkeys(["/world/force/sensor", "/force_sensor"], count["/wrench"])
    expected |= dict.fromkeys(["/world/force/plate", "/force/plate"], count["/controller/step"])
    expected |= dict.fromkeys(["/world/force/truth", "/force/truth", "/force/limit", "/height/true_depth"], count["/truth/soil"])
    expected |= dict.fromkeys(["/joints/position", "/joints/torque"], count["/joint_states"])
    # A row without values ends each stroke.
    expected |= dict.fromkeys(["/world/lead", "/friction_angle", "/displacement"], len(in_stroke) + ends)
    expected[f"{hand}/plate_tip/safe_force"] = 2 * ends
    expected["/events"] = sum(len(step.events) for step in steps)
    homed = np.cumsum([any(event.kind == "homed" for event in step.events) or any(step.pose) for step in steps]) > 0
    expected["/height"] = int(homed.sum())
    for name in ("mode", "trajectory", "sequence"):
        values = [getattr(step, name) for step in steps]
        expected[f"/state/{name}"] = sum(a != b for a, b in zip(["", *values], values))
    found = {entity: len(next(iter(columns.values()))) for entity, columns in recording.rows.items()}
    assert found == expected
    assert {entity["entity"]: entity["rows"] for entity in answer["entities"]} == expected
    assert answer["steps"] == len(steps) and answer["damage"] == [] and answer["viewer"] is None
    assert recording.times["/force/plate"] == [time for time, _ in messages["/controller/step"]]
    assert recording.times["/world/force/sensor"] == [time for time, _ in messages["/wrench"]]


def test_the_sensor_s_arrow_is_its_force_turned_to_the_base(recording, messages, chain):
    at = positions(messages, "/joint_states")
    force = np.array([[m.wrench.force.x, m.wrench.force.y, m.wrench.force.z] for _, m in messages["/wrench"]])
    assert all(m.header.frame_id == "ft_sensor" for _, m in messages["/wrench"])
    rotation, _ = chain.frame("ft_sensor", at)
    _, tip = chain.frame("plate_tip", at)
    origins, vectors = recording.vectors("/world/force/sensor")
    assert close(vectors, FORCE_M_PER_N * (rotation @ force[:, :, None])[:, :, 0])
    assert close(origins, tip)
    assert np.abs(vectors).max() > 0.01


def test_the_arrows_of_controller_truth_and_lead(recording, messages, chain):
    steps = [step for _, step in messages["/controller/step"]]
    for entity, at, rtz in [
        ("plate", positions(messages, "/joint_states"), [step.force_rtz_n for step in steps]),
        ("truth", positions(messages, "/truth/joint_states"), [soil.force_rtz_n for _, soil in messages["/truth/soil"]]),
    ]:
        origins, vectors = recording.vectors(f"/world/force/{entity}")
        assert close(vectors, FORCE_M_PER_N * rtz_to_base(rtz, at[:, 0]))
        assert close(origins, chain.frame("plate_tip", at)[1])
        assert np.abs(vectors).max() > 0.01
    inside, _ = strokes(messages)
    at = np.array([step.external_joints_rad for step in inside])
    lead = np.array([step.lead_m for step in inside])
    down = np.array([step.lead_inclination_rad for step in inside])
    expected = LEAD_SCALE * rtz_to_base(np.stack([-lead * np.cos(down), 0 * lead, -lead * np.sin(down)], axis=1), at[:, 0])
    origins, vectors = recording.vectors("/world/lead")
    drawn = np.isfinite(vectors).all(axis=1)
    assert close(vectors[drawn], expected) and close(origins[drawn], chain.frame("plate_tip", at)[1])


def test_the_safe_area_is_the_table_around_the_plate_s_normal(recording, messages, chain):
    table_deg, table_n = (np.array([float(v) for v in re.findall(r"-?\d+\.\d+", text)]) for text in SAFE_FORCE)
    (entity,) = [name for name in recording.rows if name.endswith("/plate_tip/safe_force")]
    rows = recording.rows[entity]
    shape, gone = rows["Mesh3D:vertex_positions"][:2]
    assert not gone and not rows["Mesh3D:triangle_indices"][1]
    corners = np.array(shape)
    faces = np.array(rows["Mesh3D:triangle_indices"][0])
    assert faces.min() == 0 and faces.max() == len(corners) - 1 and (corners[0] == 0).all()
    rim = corners[1:]
    assert np.abs(rim[:, 1]).max() < 1e-6
    angles = np.linspace(table_deg[0], table_deg[-1], len(rim))
    assert np.linalg.norm(rim, axis=1) == pytest.approx(FORCE_M_PER_N * np.interp(angles, table_deg, table_n), rel=1e-4)
    # By which angle in the frame of the plate a force of some angle to its normal is told from the rim, and the measured
    # force from the controller's own friction angle: both must agree.
    turned = np.degrees(np.unwrap(np.arctan2(rim[:, 2], rim[:, 0])))
    assert np.abs(np.diff(turned)) == pytest.approx(np.full(len(rim) - 1, 60 / (len(rim) - 1)), rel=1e-3)
    inside, _ = strokes(messages)
    told = dict(zip(recording.times["/friction_angle"], recording.rows["/friction_angle"]["Scalars:scalars"], strict=True))
    times = {step.tick: time for time, step in messages["/controller/step"]}
    steps = [step for step in inside if np.linalg.norm(step.force_rtz_n) > 2][::50]
    assert len(steps) > 5
    joints = np.array([step.external_joints_rad for step in steps])
    rotation, _ = chain.frame("plate_tip", joints)
    force = rtz_to_base([step.force_rtz_n for step in steps], joints[:, 0])
    x, _, z = (np.swapaxes(rotation, 1, 2) @ force[:, :, None])[:, :, 0].T
    slope = np.sign(turned[-1] - turned[0])
    found = angles[0] + slope * ((np.degrees(np.arctan2(z, x)) - turned[0] + 180) % 360 - 180)
    expected = np.array([told[times[step.tick]][0] for step in steps])
    assert np.median(np.abs((found - expected + 180) % 360 - 180)) < 1.0


def test_frames_chain_to_the_forward_kinematics(recording, messages, chain):
    at = positions(messages, "/joint_states")[::10]
    entity, rotation, origin = "/world/base_link", np.broadcast_to(np.eye(3), (len(at), 3, 3)), np.zeros((len(at), 3))
    for link in ("column_link", "upper_arm_link", "forearm_link", "twist_link", "hand_link"):
        entity += f"/{link}"
        columns = recording.rows[entity]
        place = np.array([row[0] for row in columns["Transform3D:translation"]])
        x, y, z, w = np.array([row[0] for row in columns["Transform3D:quaternion"]]).T
        own = np.stack([
            np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], axis=1),
            np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], axis=1),
            np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=1),
        ], axis=1)
        origin = origin + (rotation @ place[:, :, None])[:, :, 0]
        rotation = rotation @ own
        expected = chain.frame(link, at)
        assert np.abs(rotation - expected[0]).max() < 1e-5 and np.abs(origin - expected[1]).max() < 1e-5


def test_shapes_are_those_of_the_urdf(recording, messages):
    robot = ET.fromstring(messages["/robot_description"][0][1].data)
    for link in robot.findall("link"):
        drawn = {e: c for e, c in recording.fixed.items() if re.fullmatch(rf".*/{link.get('name')}/shape_\d+", e)}
        visuals = link.findall("visual")
        assert len(drawn) == len(visuals)
        for (_, columns), visual in zip(sorted(drawn.items()), visuals, strict=True):
            shape = visual.find("geometry")[0]
            numbers = {key: [float(v) for v in value.split()] for key, value in shape.attrib.items()}
            expected = {
                "box": lambda n: {"Boxes3D:half_sizes": [[v / 2 for v in n["size"]]]},
                "cylinder": lambda n: {"Cylinders3D:lengths": n["length"], "Cylinders3D:radii": n["radius"]},
                "sphere": lambda n: {"Ellipsoids3D:half_sizes": [n["radius"] * 3]},
            }[shape.tag](numbers)
            archetype = next(iter(expected)).split(":")[0]
            expected[f"{archetype}:centers"] = [[float(v) for v in visual.find("origin").get("xyz").split()]]
            for name, values in expected.items():
                assert np.allclose(columns[name][0], values, rtol=1e-6), (link.get("name"), name)


def test_curves_states_and_events(soilctl, log, recording, messages):
    steps = [step for _, step in messages["/controller/step"]]
    curves = {
        "/force/plate": [list(step.force_rtz_n) for step in steps],
        "/force/limit": [[soil.limit_force_n, soil.limit_force_now_n] for _, soil in messages["/truth/soil"]],
        "/height/true_depth": [[soil.depth_m * 1e3] for _, soil in messages["/truth/soil"]],
        "/joints/torque": [list(message.effort) for _, message in messages["/joint_states"]],
    }
    for entity, values in curves.items():
        assert recording.rows[entity]["Scalars:scalars"] == values
    inside, _ = strokes(messages)
    # The plate's normal lies a quarter turn from the plate; the tool angle is that of the plate from the horizontal.
    angle = [row for row in recording.rows["/friction_angle"]["Scalars:scalars"] if row]
    wanted = np.degrees([step.desired_inclination_rad - step.force_inclination_rad for step in inside])
    assert np.allclose(np.diff(angle, axis=1)[:, 0], wanted, atol=1e-9)
    way = np.array([row[0] for row in recording.rows["/displacement"]["Scalars:scalars"] if row])
    radius = np.array([np.hypot(*step.pose[:2]) for step in inside])
    assert np.allclose(way, (radius[0] - radius) * 1e3, atol=1e-9) and way.max() > 1.0
    modes = [state for (state,) in recording.rows["/state/mode"]["StateChange:state"]]
    changes = [step.mode for before, step in zip([None, *steps], steps) if before is None or before.mode != step.mode]
    assert modes == changes
    # No state is a row without values.
    moves = [step.trajectory for before, step in zip(["", *[step.trajectory for step in steps]], steps) if before != step.trajectory]
    assert [row[0] if row else "" for row in recording.rows["/state/trajectory"]["StateChange:state"]] == moves
    assert "" in moves and "stroke" in moves
    texts = [row[0] for row in recording.rows["/events"]["TextLog:text"]]
    kinds = [event.kind for step in steps for event in step.events]
    assert [text.split()[0] for text in texts] == kinds and "trajectory_started/stroke" in kinds
    for entity, names in [("/force/plate", ["r", "t", "z"]), ("/joints/position", ["base", "shoulder", "elbow", "twist", "wrist"])]:
        assert recording.fixed[entity]["SeriesLines:names"] == [names]
    (page,) = recording.fixed["/about"]["TextDocument:text"][0]
    assert "format version: 1" in page
    for stroke in soilctl.json("log", "info", log)["content"]["strokes"]:
        assert f"| {stroke['number']} | {stroke['start_s']} | {stroke['end_s']} | {stroke['finish']} |" in page


def test_the_box_is_where_the_plant_has_it(recording, messages):
    with (ROOT / "data" / "plant" / "default.toml").open("rb") as file:
        box = tomllib.load(file)["box"]
    # As the settings state it, before the arm has touched the sand.
    frames = [frame for _, tf in messages["/tf_static"] for frame in tf.transforms]
    level = next(frame.transform.translation.z for frame in frames if frame.child_frame_id == "soil_surface")
    drawn = recording.fixed["/world/base_link/sandbox"]
    (centres,), (halves,) = drawn["Boxes3D:centers"], drawn["Boxes3D:half_sizes"]
    for centre, half, top in zip(centres, halves, [level, box["top_z_m"]], strict=True):
        for axis, ends in enumerate([box["x_m"], box["y_m"], [box["floor_z_m"], top]]):
            assert [centre[axis] - half[axis], centre[axis] + half[axis]] == pytest.approx(ends, abs=1e-6)


def test_the_layout_shows_what_is_there(recording):
    layout = recording.blueprint()
    entities = {*recording.rows, *recording.fixed}
    views = {entity: columns for entity, columns in layout.items() if "ViewBlueprint:class_identifier" in columns}
    kinds = {columns["ViewBlueprint:class_identifier"][0] for columns in views.values()}
    assert kinds == {"3D", "TimeSeries", "TextLog", "TextDocument", "StateTimeline"}
    for entity, columns in views.items():
        (origin,) = columns["ViewBlueprint:space_origin"]
        assert any(place == origin or place.startswith(f"{origin}/") for place in entities), origin
        assert layout[f"{entity}/ViewContents"]["ViewContents:query"] == ["+ $origin/**"]
        assert (f"{entity}/PlotLegend" in layout) == (columns["ViewBlueprint:class_identifier"] == ["TimeSeries"])
    # Every view hangs on the root.
    root = bytes(layout["/viewport"]["ViewportBlueprint:root_container"][0]).hex()
    seen, open_ = set(), [f"/container/{root[:8]}-{root[8:12]}-{root[12:16]}-{root[16:20]}-{root[20:]}"]
    while open_:
        entity = open_.pop()
        seen.add(entity)
        open_ += ["/" + inner for inner in layout[entity].get("ContainerBlueprint:contents", [])]
    assert {*views} <= seen and all(entity in layout for entity in seen)


def test_the_viewer_shows_it_as_it_is_laid_out(answer, browser, tmp_path):
    """Rerun's own viewer, in the browser: arm at the left, forces at the top right, heights below."""
    viewer = Viewer(answer["recording"], tmp_path)
    page = browser.new_page(viewport={"width": 1400, "height": 900})
    page.set_default_timeout(LONG_S * 1000)
    try:
        page.goto(viewer.url)
        blue, orange = (0, 114, 178), (230, 159, 0)
        wanted = {"force r": (blue, (0.6, 0.06, 1, 0.28)), "force z": (orange, (0.6, 0.06, 1, 0.28)), "edge": (blue, (0.6, 0.65, 1, 0.8)),
                  "true depth": (orange, (0.6, 0.65, 1, 0.8))}
        deadline = time.monotonic() + LONG_S
        while True:
            image = picture(page)
            found = {name: share(image, colour, box) for name, (colour, box) in wanted.items()}
            # The arm is grey, in a place that is white around it.
            found["arm"] = sum(share(image, [grey] * 3, (0, 0.06, 0.6, 0.58), off=8) for grey in range(70, 140, 17))
            if min(found.values()) > 5e-4 and found["arm"] > 0.02:
                break
            assert time.monotonic() < deadline, found
            page.wait_for_timeout(500)
        # Curves are at the right only.
        assert share(image, orange, (0, 0.06, 0.6, 0.58)) == 0
    finally:
        page.close()
        viewer.end()


def test_rerun_finds_nothing_wrong(answer, tmp_path):
    """Its own check of every chunk against the types that it knows, after it has added the index."""
    home = {**os.environ, "HOME": str(tmp_path), "RERUN_ANALYTICS": "0"}
    indexed = tmp_path / "indexed.rrd"
    for words in (["optimize", answer["recording"], "-o", indexed], ["verify", indexed]):
        done = subprocess.run([RERUN, "rrd", *words], capture_output=True, text=True, timeout=300, check=False, env=home)
        assert done.returncode == 0, done.stdout + done.stderr
        assert "ERROR" not in done.stderr and "WARN" not in done.stderr, done.stderr


def test_the_same_log_gives_the_same_bytes(soilctl, answer, log, tmp_path):
    again = tmp_path / "again.rrd"
    soilctl.json("view", log, "--no-open", "--out", again)
    assert again.read_bytes() == Path(answer["recording"]).read_bytes()
    assert not list(tmp_path.glob("*.part"))


def test_early_logs_whose_truth_is_shorter(soilctl, log, tmp_path):
    early = tmp_path / "early.mcap"
    with log.open("rb") as source, early.open("wb") as target:
        reader = make_reader(source)
        writer = Writer(target)
        writer.start(profile="ros2", library="early")
        summary = reader.get_summary()
        schemas = {s.id: writer.register_schema(s.name, s.encoding, s.data) for s in summary.schemas.values()}
        channels = {c.id: writer.register_channel(c.topic, c.message_encoding, schemas[c.schema_id], c.metadata) for c in summary.channels.values()}
        for record in reader.iter_metadata():
            writer.add_metadata(record.name, record.metadata)
        for _, channel, message in reader.iter_messages():
            # The encapsulation and five numbers: depth, limit, force along r, t, z.
            data = message.data[: 4 + 5 * 8] if channel.topic == "/truth/soil" else message.data
            writer.add_message(channels[channel.id], message.log_time, data, message.publish_time, message.sequence)
        writer.finish()
    whole, answer = (soilctl.json("view", file, "--no-open", "--out", tmp_path / f"{file.stem}.rrd") for file in (log, early))
    rows = [{entity["entity"]: entity["rows"] for entity in found["entities"]} for found in (whole, answer)]
    assert rows[0] == rows[1] and rows[0]["/force/limit"] > 0
    limits = Recording(tmp_path / "early.rrd").rows["/force/limit"]["Scalars:scalars"]
    assert {len(row) for row in limits} == {1} and np.isfinite(limits).all()


def test_damaged_logs(soilctl, validate, log, tmp_path):
    """A cut log is shown as far as it goes, and so is what `log recover` makes of it."""
    cut, fixed = tmp_path / "cut.mcap", tmp_path / "fixed.mcap"
    whole = log.read_bytes()
    cut.write_bytes(whole[: len(whole) // 2])
    answer = soilctl.json("view", cut, "--no-open", code=3)
    validate(answer)
    assert "ends after" in answer["damage"][0]
    shown = Recording(Path(answer["recording"]))
    assert "Damaged" in shown.fixed["/about"]["TextDocument:text"][0][0]
    assert "damaged" in soilctl("view", cut, "--no-open", code=3).stderr
    soilctl("log", "recover", cut, "--out", fixed, code=3)
    recovered = soilctl.json("view", fixed, "--no-open")
    assert recovered["entities"] == answer["entities"] and recovered["damage"] == []
    assert 0 < recovered["steps"] == len(shown.rows["/force/plate"]["Scalars:scalars"])


def test_the_viewer_is_opened_or_told_of(soilctl, log, tmp_path):
    out = tmp_path / "a.rrd"
    note = tmp_path / "opened"
    viewer = tmp_path / "viewer"
    viewer.write_text(f'#!/bin/sh\necho "$@" > {note}.new && mv {note}.new {note}\n', encoding="utf-8")
    viewer.chmod(0o755)
    answer = soilctl.json("view", log, "--out", out, "--viewer", viewer)
    assert answer["viewer"] == str(viewer)
    for _ in range(600):
        if note.exists():
            break
        subprocess.run(["sleep", "0.1"], check=True)
    assert note.read_text(encoding="utf-8").strip() == str(out)
    told = subprocess.run(
        [soilctl.binary, "view", log, "--out", out], capture_output=True, text=True, check=True, env={"PATH": str(tmp_path / "empty")}
    ).stderr
    assert "pip install rerun-sdk" in told and f"rerun {out}" in told
    soilctl.refuses("view", log, "--out", out, "--viewer", tmp_path / "none", mentions=["none", "cannot be started", "--no-open"])


def test_wrong_use_is_refused(soilctl, log, tmp_path, data):
    out = tmp_path / "a.rrd"
    soilctl.refuses("view", tmp_path / "none.mcap", "--no-open", mentions=["none.mcap"])
    soilctl.refuses("view", data / "soils.csv", "--no-open", "--out", out, mentions=["soils.csv", "not a recording"])
    soilctl.refuses("view", log, "--no-open", "--out", tmp_path / "a.mcap", mentions=["a.mcap", "must end in .rrd"])
    soilctl.refuses("view", log, "--no-open", "--out", tmp_path / "no" / "a.rrd", mentions=["a.rrd", "check the path"])
    copy = tmp_path / "log.rrd"
    copy.write_bytes(log.read_bytes())
    soilctl.refuses("view", copy, "--no-open", mentions=["the log itself"])
    assert copy.read_bytes() == log.read_bytes() and sorted(tmp_path.iterdir()) == [copy]


def values(tree, key):
    """Everything under a key, wherever it stands."""
    if isinstance(tree, dict):
        for name, inner in tree.items():
            if name == key:
                yield inner
            yield from values(inner, key)
    elif isinstance(tree, list):
        for inner in tree:
            yield from values(inner, key)


def panels(tree):
    """Ids of panels in a tree of splits."""
    if isinstance(tree, str):
        return [tree]
    assert set(tree) == {"direction", "first", "second", "splitPercentage"}
    return panels(tree["first"]) + panels(tree["second"])


def test_the_foxglove_layout_names_what_the_log_has(soilctl, log, messages, tmp_path):
    path = tmp_path / "foxglove.json"
    answer = soilctl.json("view", log, "--no-open", "--out", tmp_path / "a.rrd", "--foxglove-layout", path)
    assert answer["foxglove_layout"] == str(path)
    layout = json.loads(path.read_text(encoding="utf-8"))
    config = layout["configById"]
    shown = panels(layout["layout"])
    for tabs in values(config, "tabs"):
        shown += [panel for tab in tabs for panel in panels(tab["layout"])]
    assert sorted(shown) == sorted(config), "a panel is not shown, or has no settings"
    assert {panel.split("!")[0] for panel in config} == {"3D", "Plot", "StateTransitions", "RawMessages", "Tab"}
    paths = [item["value"] for name in ("Plot", "StateTransitions") for panel in config if panel.startswith(name) for item in config[panel]["paths"]]
    paths += [*values(config, "topicPath"), *values(config, "topic")]
    assert len(paths) > 25
    for path in paths:
        topic = max((topic for topic in messages if path == topic or path.startswith(f"{topic}.")), key=len, default=None)
        assert topic, path
        value = messages[topic][-1][1]
        for name, index in re.findall(r"\.(\w+)(?:\[(\d+)\])?", path[len(topic):]):
            value = getattr(value, name)
            value = value[int(index)] if index else value
        assert re.fullmatch(r"(\.\w+(\[\d+\])?)*", path[len(topic):]), path
    frames = {t.child_frame_id for topic in ("/tf", "/tf_static") for _, m in messages[topic] for t in m.transforms} | {"base_link"}
    named = [*values(config, "followTf"), *values(config, "frameId")]
    named += [key.removeprefix("frame:") for transforms in values(config, "transforms") for key in transforms if key.startswith("frame:")]
    assert len(named) >= 5 and {*named} <= frames
