"""Logs, read by the tools that others use: Python `mcap` with ROS 2 support, `rosbags`, and Rerun's MCAP loader."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pyarrow.csv
import pyarrow.parquet
import pytest
import rerun.chunk
from conftest import decoded
from mcap.reader import make_reader
from rosbags.highlevel import AnyReader

TICKS = 26000
TICK_NS = 2_000_000
COUNTS = {
    "/controller/step": TICKS,
    "/controller/keyframe": TICKS // 500,
    "/joint_states": TICKS,
    "/motor_states": TICKS,
    "/wrench": TICKS,
    "/tf": TICKS // 10,
    "/tf_static": 2,
    "/robot_description": 1,
    "/truth/joint_states": TICKS,
    "/truth/soil": TICKS,
}
JOINTS = ["base", "shoulder", "elbow", "twist", "wrist"]


@pytest.fixture(scope="session")
def log(soilctl, tmp_path_factory):
    """A log of one whole stroke, by the example that the Rust tests built beside the program."""
    path = tmp_path_factory.mktemp("log") / "stroke.mcap"
    example = soilctl.binary.parent / "examples" / "write_log"
    assert example.is_file(), "build it with `cargo build --workspace --examples`"
    subprocess.run([example, path, str(TICKS)], check=True, timeout=1200)
    return path


@pytest.fixture(scope="session")
def messages(log):
    return decoded(log)


def test_mcap_reads_every_message(log, messages):
    assert {topic: len(found) for topic, found in messages.items()} == COUNTS
    with log.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        assert reader.get_header().profile == "ros2"
        attachment = next(reader.iter_attachments())
        metadata = {record.name: record.metadata for record in reader.iter_metadata()}
    by_topic = {channel.topic: channel.id for channel in summary.channels.values()}
    assert {topic: summary.statistics.channel_message_counts[id] for topic, id in by_topic.items()} == COUNTS
    assert all(schema.encoding == "ros2msg" for schema in summary.schemas.values())
    assert all(channel.message_encoding == "cdr" for channel in summary.channels.values())
    assert all(index.compression == "zstd" for index in summary.chunk_indexes)
    assert attachment.name == "robot.urdf"
    assert attachment.data.decode() == messages["/robot_description"][0][1].data
    assert set(metadata) == {"soilctl.session", "soilctl.configuration", "soilctl.stroke", "soilctl.end"}
    assert metadata["soilctl.end"] == {"steps": str(TICKS), "dropped_steps": "0"}


def test_times_are_those_of_the_ticks(messages):
    steps = messages["/controller/step"]
    assert [time for time, _ in steps] == [step.tick * TICK_NS for _, step in steps]
    assert [step.step for _, step in steps] == list(range(TICKS))
    for topic in ("/joint_states", "/wrench"):
        stamps = [m.header.stamp.sec * 10**9 + m.header.stamp.nanosec for _, m in messages[topic]]
        assert stamps == [time for time, _ in messages[topic]]


def test_values_are_those_of_the_step(messages):
    """The same numbers in messages of different layout: no field is displaced."""
    for (_, step), (_, joints), (_, motors), (_, wrench) in zip(
        *(messages[topic] for topic in ("/controller/step", "/joint_states", "/motor_states", "/wrench")), strict=True
    ):
        assert joints.name == JOINTS
        assert list(joints.position) == list(step.external_joints_rad)
        assert list(joints.effort) == list(step.joint_torques_nm)
        assert list(motors.effort) == list(step.motor_torques_nm)
        force, torque = wrench.wrench.force, wrench.wrench.torque
        assert [force.x, force.y, force.z, torque.x, torque.y, torque.z] == list(step.wrench)
        assert wrench.header.frame_id == "ft_sensor"
        assert step.mode in ("off", "ready", "fault")


def test_the_stroke_is_in_the_events_and_the_metadata(log, messages):
    kinds = [event.kind for _, step in messages["/controller/step"] for event in step.events]
    for kind in ("surface_found", "inserted", "trajectory_started/stroke", "stroke_ended"):
        assert kind in kinds, kinds
    requests = [step.request for _, step in messages["/controller/step"] if step.request]
    assert requests == ["stroke", "start/insert_stroke_pullout", "push/cartesian_move"]
    with log.open("rb") as file:
        stroke = next(r.metadata for r in make_reader(file).iter_metadata() if r.name == "soilctl.stroke")
    inside = [step for _, step in messages["/controller/step"] if step.trajectory == "stroke"]
    assert [inside[0].tick, inside[-1].tick] == [int(stroke["start_tick"]), int(stroke["end_tick"])]


def test_frames_lead_to_the_tip(messages):
    """Forward kinematics from /tf alone gives the pose that the controller computed, but for the stretch of the cables."""

    def matrix(link):
        q, t = link.transform.rotation, link.transform.translation
        x, y, z, w = q.x, q.y, q.z, q.w
        return np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t.x],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t.y],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t.z],
            [0, 0, 0, 1],
        ])

    steps = dict(messages["/controller/step"])
    fixed = messages["/tf_static"][0][1].transforms
    for time, message in messages["/tf"][::40]:
        links = {link.child_frame_id: link for link in [*fixed, *message.transforms]}
        place, frame = np.eye(4), "plate_tip"
        while frame != "base_link":
            place = matrix(links[frame]) @ place
            frame = links[frame].header.frame_id
        step = steps[time]
        # Behind the encoders the elbow gives way by 1/130 rad a Nm, and neither lever is longer than 0.6 m.
        stretch = 0.6**2 / 130 * np.linalg.norm(step.force_rtz_n)
        assert np.linalg.norm(place[:3, 3] - step.pose[:3]) <= stretch + 1e-12


def test_rosbags_reads_every_message(log, messages):
    with AnyReader([log]) as bag:
        assert {connection.topic: connection.msgcount for connection in bag.connections} == COUNTS
        profiles = {connection.topic: connection.ext.offered_qos_profiles for connection in bag.connections}
        assert all(len(profile) == 1 for profile in profiles.values())
        assert profiles["/robot_description"][0].durability.name == "TRANSIENT_LOCAL"
        assert profiles["/wrench"][0].reliability.name == "RELIABLE"
        places = dict.fromkeys(COUNTS, 0)
        for connection, time, raw in bag.messages():
            decoded = bag.deserialize(raw, connection.msgtype)
            expected_time, expected = messages[connection.topic][places[connection.topic]]
            places[connection.topic] += 1
            assert time == expected_time
            if connection.topic == "/wrench":
                assert decoded.wrench.force.z == expected.wrench.force.z
            elif connection.topic == "/controller/step":
                assert decoded.tick == expected.tick
                assert decoded.lead_m == expected.lead_m
                assert decoded.sequence == expected.sequence
                assert [event.value for event in decoded.events] == [event.value for event in expected.events]
            elif connection.topic == "/controller/keyframe":
                assert bytes(decoded.state) == bytes(expected.state)
        assert places == COUNTS


def test_rerun_converts_every_message(log, tmp_path):
    """`rerun mcap convert`, then the rows of each entity."""
    program = Path(sys.executable).with_name("rerun")
    out = tmp_path / "log.rrd"
    home = {**os.environ, "HOME": str(tmp_path), "RERUN_ANALYTICS": "0"}
    done = subprocess.run(
        [program, "mcap", "convert", str(log), "-o", str(out)],
        capture_output=True, text=True, timeout=300, check=False, env=home,
    )
    assert done.returncode == 0, done.stderr
    assert "ERROR" not in done.stderr, done.stderr
    rows = {}
    for chunk in rerun.chunk.RrdReader(out).stream():
        if not chunk.is_static:
            rows[chunk.entity_path] = rows.get(chunk.entity_path, 0) + chunk.num_rows
    # One row a transform: five moving links; two on the hand and the surface, as configured and as touched.
    expected = {**COUNTS, "/tf": 5 * COUNTS["/tf"], "/tf_static": 3 * COUNTS["/tf_static"]}
    for topic in ("/joint_states", "/motor_states", "/truth/joint_states"):
        expected.update({f"{topic}/{part}": TICKS for part in ("position", "velocity", "effort")})
    assert rows == expected


def test_the_program_agrees(soilctl, validate, log):
    answer = soilctl.json("log", "info", log)
    validate(answer)
    assert {topic["topic"]: topic["messages"] for topic in answer["content"]["topics"]} == COUNTS
    doctor = soilctl.json("log", "doctor", log)
    assert doctor["problems"] == doctor["damage"] == []
    for options in ([], ["--from-keyframe", 17]):
        replay = soilctl.json("replay", log, *options)
        validate(replay)
        assert (replay["identical"], replay["first_difference"]) == (True, None)
        assert replay["steps"] == TICKS - (17 * 500 if options else 0)


@pytest.mark.parametrize("topic", ["/controller/step", "/joint_states", "/wrench", "/truth/soil"])
def test_tables_hold_the_messages(soilctl, validate, log, messages, tmp_path, topic):
    text, binary = tmp_path / "table.csv", tmp_path / "table.parquet"
    for out in (text, binary):
        answer = soilctl.json("log", "export", log, "--topic", topic, "--out", out)
        validate(answer)
        assert answer["written"]["rows"] == TICKS
    csv = pyarrow.csv.read_csv(text)
    table = pyarrow.parquet.read_table(binary)
    assert csv.column_names == table.column_names
    assert csv.num_rows == table.num_rows == TICKS
    time = np.array([time for time, _ in messages[topic]]) / 1e9
    for read in (csv, table):
        assert (read["time_s"].to_numpy() == time).all()
    expected = {
        "/controller/step": lambda m: ("motor_torques_nm_1", m.motor_torques_nm[1]),
        "/joint_states": lambda m: ("elbow_position", m.position[2]),
        "/wrench": lambda m: ("force_z", m.wrench.force.z),
        "/truth/soil": lambda m: ("depth_m", m.depth_m),
    }[topic]
    name = expected(messages[topic][0][1])[0]
    values = [expected(message)[1] for _, message in messages[topic]]
    for read in (csv, table):
        assert read[name].to_pylist() == values


def test_cut_files_are_recovered(soilctl, validate, log, tmp_path):
    cut, fixed = tmp_path / "cut.mcap", tmp_path / "fixed.mcap"
    whole = log.read_bytes()
    cut.write_bytes(whole[: len(whole) * 2 // 3])
    answer = soilctl.json("log", "recover", cut, "--out", fixed, code=3)
    validate(answer)
    steps = answer["content"]["steps"]
    assert steps % 500 == 0 and 0 < steps < TICKS
    with fixed.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        assert sum(1 for _ in reader.iter_messages("/controller/step")) == steps
    assert soilctl.json("replay", fixed)["steps"] == steps
    assert soilctl.json("replay", cut, code=3)["identical"]
    assert soilctl.json("log", "info", cut, code=3)["content"]["steps"] == steps
    assert soilctl.json("log", "doctor", cut, code=3)["damage"]


def test_wrong_use_is_refused(soilctl, log, tmp_path, data):
    table = tmp_path / "table.xlsx"
    soilctl.refuses("log", "export", log, "--out", table, mentions=["table.xlsx", ".csv or .parquet"])
    soilctl.refuses("log", "export", log, "--topic", "/dig", "--out", tmp_path / "a.csv", mentions=["/dig", "/wrench"])
    soilctl.refuses("log", "recover", log, "--out", log, mentions=["the log itself"])
    soilctl.refuses("log", "info", data / "soils.csv", mentions=["soils.csv", "not a recording that can be read"])
    soilctl.refuses("log", "info", tmp_path / "none.mcap", mentions=["none.mcap"])
    soilctl.refuses("replay", log, "--from-keyframe", TICKS // 500, mentions=[f"no key frame {TICKS // 500}", f"has {TICKS // 500}"])
