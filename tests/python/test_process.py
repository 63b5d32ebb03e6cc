"""`soilctl process` on bags of other programs, written by the independent library rosbags."""

import csv
import json
import math
import signal
import subprocess
import time

import mcap.writer
import numpy as np
import pytest
from mcap.reader import make_reader
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

STORE = get_typestore(Stores.ROS2_HUMBLE)
TYPES = STORE.types
SURFACE_M = 0.40
DEPTH_M = 0.025
WIDTH_M = 0.1
FAILURE_N = 6.0

# A gantry: two sliding joints carry a plate that hangs straight down, its sensor turned by 30 deg about y.
URDF = """<robot name="gantry">
<link name="world"/><link name="cart"/><link name="lift"/><link name="load_cell"/><link name="blade_edge"/>
<joint name="cart_x" type="prismatic"><parent link="world"/><child link="cart"/><axis xyz="1 0 0"/>
  <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="lift_z" type="prismatic"><parent link="cart"/><child link="lift"/><axis xyz="0 0 1"/>
  <limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="cell" type="fixed"><parent link="lift"/><child link="load_cell"/>
  <origin xyz="0 0 0" rpy="0 0.5235987755982988 0"/></joint>
<joint name="edge" type="fixed"><parent link="lift"/><child link="blade_edge"/>
  <origin xyz="0 0 -0.1" rpy="3.141592653589793 0 0"/></joint>
</robot>"""
DELTA = math.radians(20.0)
BIAS = np.array([1.5, -0.7, 4.0])


def motion(t):
    """Cart, lift and force of the soil on the plate (x, z) of one stroke of 12 s."""
    low, high = SURFACE_M - DEPTH_M, SURFACE_M + 0.02
    if t < 2.0:
        return 0.0, high, 0.0
    if t < 4.0:
        z = high + (low - high) * (t - 2.0) / 2.0
        return 0.0, z, 0.0
    if t < 9.0:
        x = 0.02 * (t - 4.0) / 5.0
        force = FAILURE_N * min(1.0, x / 0.004) * (1.0 - 0.15 * (1.0 - math.exp(-max(0.0, x - 0.004) / 0.002)))
        return x, low, force
    z = low + (high - low) * min(1.0, (t - 9.0) / 1.0)
    return 0.02, z, 0.0


def write_bag(folder, strokes=1, joints=("cart_x", "lift_z"), shuffle=False, rates=(80.0, 250.0), frame="load_cell",
              topics=("/gantry/joints", "/cell/wrench"), description=False):
    """A bag of strokes one after the other; gives the path of its file."""
    time, header = TYPES["builtin_interfaces/msg/Time"], TYPES["std_msgs/msg/Header"]
    joint_type, wrench_type = TYPES["sensor_msgs/msg/JointState"], TYPES["geometry_msgs/msg/WrenchStamped"]
    wrench, vector = TYPES["geometry_msgs/msg/Wrench"], TYPES["geometry_msgs/msg/Vector3"]
    rng = np.random.default_rng(1)
    start = 1_700_000_000
    messages = []
    stamp = lambda t: time(sec=start + int(t), nanosec=int((t - int(t)) * 1e9))
    for k in range(int(12 * strokes * rates[0])):
        t = k / rates[0]
        x, z, _ = motion(t % 12)
        at = {"cart_x": x + 0.1 * int(t // 12), "lift_z": z + 0.1, "gripper": 0.3}
        names = [name for name in at if name in joints or name == "gripper"]
        message = joint_type(header=header(stamp=stamp(t), frame_id=""), name=names,
                             position=np.array([at[n] for n in names]), velocity=np.array([]), effort=np.array([]))
        messages.append((t, topics[0], joint_type.__msgtype__, message))
    turn = math.radians(30.0)
    for k in range(int(12 * strokes * rates[1])):
        t = k / rates[1] + 0.001
        _, _, force = motion(t % 12)
        # Soil pushes the plate back and, by friction, up.
        root = np.array([-force * math.cos(DELTA), 0.0, force * math.sin(DELTA)])
        cell = np.array([math.cos(turn) * root[0] - math.sin(turn) * root[2], 0.0,
                         math.sin(turn) * root[0] + math.cos(turn) * root[2]])
        reading = cell + BIAS + rng.normal(0, 0.02, 3)
        message = wrench_type(header=header(stamp=stamp(t), frame_id=frame),
                              wrench=wrench(force=vector(*map(float, reading)), torque=vector(0.0, 0.0, 0.0)))
        messages.append((t, topics[1], wrench_type.__msgtype__, message))
    messages.sort(key=lambda m: m[0])
    if shuffle:
        late = [m[0] + rng.uniform(0, 0.2) for m in messages]
        messages = [messages[i] for i in np.argsort(late)]
    path = folder / "bag"
    with Writer(path, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connections = {}
        if description:
            text = TYPES["std_msgs/msg/String"]
            connection = writer.add_connection("/robot_description", text.__msgtype__, typestore=STORE)
            writer.write(connection, start * 10**9, STORE.serialize_cdr(text(data=URDF), text.__msgtype__))
        for i, (_, topic, kind, message) in enumerate(messages):
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=STORE)
            # The log's own times are of no use: all close together.
            writer.write(connections[topic], start * 10**9 + i, STORE.serialize_cdr(message, kind))
    return next(path.glob("*.mcap"))


@pytest.fixture
def urdf(tmp_path):
    path = tmp_path / "gantry.urdf"
    path.write_text(URDF)
    return path


def options(urdf):
    return ["--urdf", urdf, "--plate-frame", "blade_edge", "--surface-z", SURFACE_M, "--width", WIDTH_M]


def process(soilctl, *args):
    done = soilctl("process", "--format", "json", *map(str, args))
    return done, json.loads(done.stdout) if done.stdout else None


def check(stroke):
    assert stroke["alpha_deg"] == pytest.approx(90.0, abs=1e-6)
    assert stroke["depth_m"] == pytest.approx(DEPTH_M, abs=1e-6)
    # The peak is sharp and the force falls from there.
    assert stroke["force_n"] == pytest.approx(FAILURE_N, rel=0.03)
    assert stroke["friction_angle_deg"] == pytest.approx(20.0, abs=1.0)


def test_other_topics_rates_and_another_arm(soilctl, tmp_path, urdf):
    done, answer = process(soilctl, write_bag(tmp_path), *options(urdf))
    assert done.returncode == 0, done.stderr
    assert len(answer["strokes"]) == 1
    check(answer["strokes"][0])
    assert not answer["logs"][0]["own"]


def test_urdf_in_the_bag_several_strokes_and_stamps_out_of_order(soilctl, tmp_path):
    bag = write_bag(tmp_path, strokes=3, shuffle=True, description=True)
    done, answer = process(soilctl, bag, "--plate-frame", "blade_edge", "--surface-z", SURFACE_M, "--width", WIDTH_M)
    assert done.returncode == 0, done.stderr
    assert len(answer["strokes"]) == 3
    for stroke in answer["strokes"]:
        check(stroke)


def test_given_windows_and_tare(soilctl, tmp_path, urdf):
    windows = tmp_path / "strokes.csv"
    windows.write_text("start,end\n16.1,20.9\n")
    bag = write_bag(tmp_path, strokes=2)
    tare = ",".join(map(str, BIAS))
    done, answer = process(soilctl, bag, *options(urdf), "--strokes", windows, f"--tare={tare}")
    assert done.returncode == 0, done.stderr
    assert len(answer["strokes"]) == 1
    check(answer["strokes"][0])


def test_what_is_missing_is_named(soilctl, tmp_path, urdf):
    bag = write_bag(tmp_path, joints=("cart_x",))
    for args, words in [
        (options(urdf), ["lift_z", "gripper"]),
        (["--surface-z", SURFACE_M, "--width", WIDTH_M], ["--urdf"]),
        (["--urdf", urdf, "--plate-frame", "blade_edge", "--width", WIDTH_M], ["--surface-z"]),
        (["--urdf", urdf, "--plate-frame", "blade_edge", "--surface-z", SURFACE_M], ["--width"]),
        ([*options(urdf), "--wrench-topic", "/wrong"], ["/wrong", "/cell/wrench", "WrenchStamped"]),
        ([*options(urdf), "--joint-topic", "/cell/wrench"], ["/cell/wrench", "JointState"]),
        ([*options(urdf), "--sensor-frame", "cell"], ["cell", "load_cell"]),
    ]:
        done, _ = process(soilctl, bag, *args)
        assert done.returncode == 2, done.stderr
        for word in words:
            assert word in done.stderr


def test_no_stroke_is_said(soilctl, tmp_path, urdf):
    windows = tmp_path / "strokes.csv"
    windows.write_text("start,end\n0.5,1.5\n")
    done, answer = process(soilctl, write_bag(tmp_path), *options(urdf), "--strokes", windows)
    assert done.returncode == 1
    assert answer["strokes"] == []
    assert answer["logs"][0]["skipped"][0]["reason"]


def test_one_bad_file_of_many(soilctl, tmp_path, urdf):
    logs = tmp_path / "logs"
    logs.mkdir()
    for name in "abc":
        folder = tmp_path / name
        folder.mkdir()
        write_bag(folder).rename(logs / f"{name}.mcap")
    (logs / "bad.mcap").write_bytes(b"this is no log")
    out = tmp_path / "out"
    out.mkdir()
    files = {}
    for threads in (1, 3):
        table = out / f"{threads}" / "strokes.csv"
        table.parent.mkdir()
        done, answer = process(soilctl, logs, *options(urdf), "--out", table, "--threads", threads)
        assert done.returncode == 3, done.stderr
        assert "bad.mcap" in done.stderr
        assert [s["stroke_id"] for s in answer["strokes"]] == ["a-1", "b-1", "c-1"]
        # Three logs of the same hours cannot be on one clock: they follow one another.
        times = [s["time_s"] for s in answer["strokes"]]
        assert times[0] < times[1] < times[2]
        files[threads] = [(table.parent / name).read_bytes() for name in ("strokes.csv", "traces.csv", "campaign.json")]
    assert files[1] == files[3]
    # The same command again reads only what failed, and writes the same.
    table = out / "1" / "strokes.csv"
    done, answer = process(soilctl, logs, *options(urdf), "--out", table)
    assert answer["reused"] == 3
    assert [(table.parent / n).read_bytes() for n in ("strokes.csv", "traces.csv", "campaign.json")] == files[1]
    lines = (out / "1" / "manifest.jsonl").read_text().splitlines()
    assert len(lines) == 5
    with open(table, newline="") as rows:
        assert [row["method"] for row in csv.DictReader(rows)] == ["drop"] * 3


def test_parquet_has_the_same_rows(soilctl, tmp_path, urdf):
    import pyarrow.parquet

    table = tmp_path / "strokes.parquet"
    done, answer = process(soilctl, write_bag(tmp_path), *options(urdf), "--out", table)
    assert done.returncode == 0, done.stderr
    rows = pyarrow.parquet.read_table(table).to_pylist()
    assert len(rows) == 1
    for key, value in rows[0].items():
        assert (answer["strokes"][0].get(key) or None) == (value or None), key


PLAN = """
version = 1
soil = "ticino_rained"
model = "chen"
[[batches]]
strokes = [{ radius_m = 0.4318, base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.02, delta_set_deg = 23.0 }]
"""


def copied(log, path, change_truth):
    """The log, written anew by another library; what is logged as truth is reversed if wanted."""
    with log.open("rb") as source, path.open("wb") as target:
        reader, writer = make_reader(source), mcap.writer.Writer(target)
        writer.start(profile="ros2", library="copy")
        for attachment in reader.iter_attachments():
            writer.add_attachment(
                attachment.create_time, attachment.log_time, attachment.name, attachment.media_type, attachment.data
            )
        for metadata in reader.iter_metadata():
            writer.add_metadata(metadata.name, metadata.metadata)
        channels = {}
        for schema, channel, message in reader.iter_messages(log_time_order=False):
            if channel.id not in channels:
                schema_id = writer.register_schema(schema.name, schema.encoding, schema.data)
                channels[channel.id] = writer.register_channel(
                    channel.topic, channel.message_encoding, schema_id, channel.metadata
                )
            changes = change_truth and channel.topic.startswith("/truth/")
            # The first four bytes say how the rest is encoded.
            data = message.data[:4] + message.data[:3:-1] if changes else message.data
            writer.add_message(channels[channel.id], message.log_time, data, message.publish_time, message.sequence)
        writer.finish()


def test_own_log_is_processed_and_its_truth_is_never_read(soilctl, tmp_path):
    (tmp_path / "plan.toml").write_text(PLAN)
    soilctl("simulate", "plan.toml", "--out", "runs", code=0, cwd=tmp_path)
    outputs = []
    for name in ["true", "false"]:
        folder = tmp_path / name
        folder.mkdir()
        copied(tmp_path / "runs" / "batch_000.mcap", folder / "batch.mcap", change_truth=name == "false")
        done = soilctl("process", "--format", "json", "--out", "strokes.csv", "batch.mcap", cwd=folder)
        assert done.returncode in (0, 1), done.stderr
        outputs.append((done.stdout, (folder / "traces.csv").read_bytes()))
        log = json.loads(done.stdout)["logs"][0]
        assert log["own"] and log["strokes"] + len(log["skipped"]) == 1
    assert (tmp_path / "true" / "batch.mcap").read_bytes() != (tmp_path / "false" / "batch.mcap").read_bytes()
    assert outputs[0] == outputs[1]


def results(folder):
    return [(folder / name).read_bytes() for name in ("strokes.csv", "traces.csv", "campaign.json")]


def lines(path):
    return path.read_bytes().count(b"\n") if path.exists() else 0


@pytest.fixture
def many_logs(tmp_path, urdf):
    """Sixty logs, and the command that reads them."""
    logs = tmp_path / "logs"
    logs.mkdir()
    bag = write_bag(tmp_path)
    for i in range(60):
        (logs / f"log_{i:02}.mcap").write_bytes(bag.read_bytes())

    def command(soilctl, folder):
        folder.mkdir(exist_ok=True)
        words = ["process", logs, *options(urdf), "--out", folder / "strokes.csv", "--threads", 1, "--format", "json"]
        return [str(soilctl.binary), *map(str, words)]

    return command


def stopped_by(kind, command, manifest):
    """Sends a signal once a few logs are done."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        ends = time.monotonic() + 60.0
        while lines(manifest) < 6:
            assert running.poll() is None and time.monotonic() < ends
            time.sleep(0.002)
        running.send_signal(kind)
        answer, _ = running.communicate(timeout=60)
    return running.returncode, answer


@pytest.mark.parametrize("kind", [signal.SIGINT, signal.SIGKILL])
def test_stopped_work_goes_on_where_it_was(soilctl, tmp_path, many_logs, kind):
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    subprocess.run(many_logs(soilctl, whole), check=True, capture_output=True)
    command = many_logs(soilctl, broken)
    code, answer = stopped_by(kind, command, broken / "manifest.jsonl")
    if kind == signal.SIGINT:
        # What was done by then is there.
        assert code == 3
        assert 5 <= len(json.loads(answer)["strokes"]) < 60
    else:
        assert code == -signal.SIGKILL
    done = subprocess.run(command, check=True, capture_output=True)
    assert 5 <= json.loads(done.stdout)["reused"] < 60
    assert results(broken) == results(whole)
    # Nothing is left over.
    assert sorted(p.name for p in broken.iterdir()) == sorted(p.name for p in whole.iterdir())


def test_shards_are_united_by_the_same_command(soilctl, tmp_path, many_logs):
    whole, shared = tmp_path / "whole", tmp_path / "shared"
    subprocess.run(many_logs(soilctl, whole), check=True, capture_output=True)
    # Two shards at the same time, of which one is killed.
    command = many_logs(soilctl, shared)
    with subprocess.Popen([*command, "--shard", "1/2"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE) as other:
        code, _ = stopped_by(signal.SIGKILL, [*command, "--shard", "2/2"], shared / "manifest.shard_2_of_2.jsonl")
        assert code == -signal.SIGKILL
        answer = json.loads(other.communicate(timeout=60)[0])
    assert len(answer["strokes"]) == 30 and answer["reused"] == 0
    assert not (shared / "strokes.csv").exists(), "a share is no campaign"
    again = subprocess.run([*command, "--shard", "1/2"], check=True, capture_output=True)
    assert json.loads(again.stdout)["reused"] == 30
    done = subprocess.run(command, check=True, capture_output=True)
    assert 35 <= json.loads(done.stdout)["reused"] < 60, "what the killed one had read counts, too"
    assert results(shared) == results(whole)
    assert sorted(p.name for p in shared.iterdir()) == sorted(p.name for p in whole.iterdir())
    # More shards than logs, as an array job may have.
    idle = subprocess.run([*many_logs(soilctl, tmp_path / "idle"), "--shard", "61/61"], check=True, capture_output=True)
    assert json.loads(idle.stdout)["strokes"] == []
    for words, mentions in (
        (["--shard", "3/2", "--out", shared / "strokes.csv"], ["--shard", "I/N"]),
        (["--shard", "1/2"], ["--out"]),
        (["--shard", "1/2", "--out", shared / "strokes.csv", "--report", shared / "r.html"], ["--report"]),
    ):
        soilctl.refuses("process", tmp_path / "logs", *words, mentions=mentions)
