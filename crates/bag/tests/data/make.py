"""Makes the recordings beside it, by writers that are not ours: `rosbags` and the `mcap` package.

    python make.py            (with rosbags==0.11.9 mcap==1.6.0 lz4 zstandard)

All of them hold the same messages; `tests/common/mod.rs` states what these say. Numbers are multiples of 1/8, so that they are the
same in every encoding.
"""

import io
import shutil
import sqlite3
from pathlib import Path

import numpy as np
from mcap.writer import CompressionType, IndexType, Writer as McapWriter
from rosbags.rosbag1 import Writer as Bag1Writer
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer as Bag2Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

HERE = Path(__file__).parent
START_NS = 1_700_000_000_000_000_000
STEP_NS = 10_000_000

MY_WRENCH = """
# What the sensor of a vendor says.
uint32 OK = 0
std_msgs/Header header
geometry_msgs/Wrench wrench
uint32 status 0   # see above
string sensor
"""
PAIR = """
uint8 count
float64 value
"""
EVERYTHING = """
std_msgs/Header header
bool flag
int8 i8
uint16 u16
int64 i64
float32 f32
string text
string WORDS="constant"
float64[3] vector
uint8[] bytes
string[] names
my_robot_msgs/Pair pair
my_robot_msgs/Pair[] pairs
my_robot_msgs/Pair[2] two
bool last
"""


def stores(ros):
    store = get_typestore(Stores.ROS1_NOETIC if ros == 1 else Stores.ROS2_HUMBLE)
    for name, text in (("MyWrench", MY_WRENCH), ("Pair", PAIR), ("Everything", EVERYTHING)):
        store.register(get_types_from_msg(text, f"my_robot_msgs/msg/{name}"))
    return store


def messages(store, ros):
    """Topic, type, time and message of everything in a recording."""
    types = store.types
    time, vector = types["builtin_interfaces/msg/Time"], types["geometry_msgs/msg/Vector3"]

    def header(ns, frame):
        stamp = time(sec=ns // 10**9, nanosec=ns % 10**9)
        fields = {"stamp": stamp, "frame_id": frame}
        return types["std_msgs/msg/Header"](**({"seq": 7, **fields} if ros == 1 else fields))

    def wrench(i):
        return types["geometry_msgs/msg/Wrench"](
            force=vector(x=i / 8, y=-i / 8, z=1.0), torque=vector(x=0.5, y=0.25, z=i * 2.0)
        )

    floats = lambda *values: np.array(values, dtype=np.float64)
    urdf = '<?xml version="1.0"?>\n<robot name="r"><link name="plate_tip"/></robot>'
    yield "/robot_description", "std_msgs/msg/String", START_NS, types["std_msgs/msg/String"](data=urdf)
    pair = types["my_robot_msgs/msg/Pair"]
    for i in range(16):
        t = START_NS + i * STEP_NS
        yield (
            "/joint_states",
            "sensor_msgs/msg/JointState",
            t + 1,
            types["sensor_msgs/msg/JointState"](
                header=header(t, ""),
                name=["base", "arm", "bucket_é"],
                position=floats(i / 8, -i / 8, 2.0),
                velocity=floats(0.125, 0.25, 0.5),
                effort=floats(),
            ),
        )
        yield (
            "/wrench",
            "geometry_msgs/msg/WrenchStamped",
            t + 2,
            types["geometry_msgs/msg/WrenchStamped"](header=header(t + 500, "ft_sensor"), wrench=wrench(i)),
        )
        if i % 4 == 0:
            yield "/bare_wrench", "geometry_msgs/msg/Wrench", t + 3, wrench(i)
            yield (
                "/vendor/force",
                "my_robot_msgs/msg/MyWrench",
                t + 4,
                types["my_robot_msgs/msg/MyWrench"](
                    header=header(t + 700, "flange"), wrench=wrench(i), status=i, sensor="s"
                ),
            )
            yield (
                "/everything",
                "my_robot_msgs/msg/Everything",
                t + 5,
                types["my_robot_msgs/msg/Everything"](
                    header=header(t, "f"),
                    flag=True,
                    i8=-5,
                    u16=60_000,
                    i64=-(2**40),
                    f32=0.125,
                    text="a, b",
                    vector=floats(1, 2, 3),
                    bytes=np.array([1, 2, 255], dtype=np.uint8),
                    names=["x", "yz"],
                    pair=pair(count=1, value=0.5),
                    pairs=[pair(count=n, value=n / 8) for n in range(3)],
                    two=[pair(count=9, value=-1.0), pair(count=8, value=-2.0)],
                    last=True,
                ),
            )
    yield "/truth/soil", "std_msgs/msg/String", START_NS + 3 * 10**8, types["std_msgs/msg/String"](data="sand")


def rosbag2(path, plugin, compression=CompressionMode.NONE):
    store = stores(2)
    shutil.rmtree(path, ignore_errors=True)
    writer = Bag2Writer(path, version=9, storage_plugin=plugin)
    writer.set_compression(compression, CompressionFormat.ZSTD)
    with writer:
        connections = {}
        for topic, kind, t, message in messages(store, 2):
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(connections[topic], t, store.serialize_cdr(message, kind))
    for file in path.glob("*.db3"):
        smaller(file)


def smaller(path):
    """Pages of 1 kB instead of 4 kB, since files that are kept should be small."""
    db = sqlite3.connect(path)
    db.executescript("PRAGMA page_size=1024; VACUUM;")
    db.close()


def rosbag1(path, compression=None):
    store = stores(1)
    path.unlink(missing_ok=True)
    writer = Bag1Writer(path)
    writer.chunk_threshold = 2000
    if compression:
        writer.set_compression(compression)
    with writer:
        connections = {}
        for topic, kind, t, message in messages(store, 1):
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=store)
            writer.write(connections[topic], t, store.serialize_ros1(message, kind))


def mcap(path, ros=2, little=True, keep=lambda i: True, idl=False, **options):
    store = stores(ros)
    out = io.BytesIO()
    writer = McapWriter(out, chunk_size=2000, **options)
    writer.start(profile=f"ros{ros}", library="make.py")
    schemas, channels = {}, {}
    for i, (topic, kind, t, message) in enumerate(messages(store, ros)):
        if not keep(i):
            continue
        if kind not in schemas:
            if idl:
                text, encoding = "module made_up { };", "ros2idl"
            else:
                text, _ = store.generate_msgdef(kind, ros_version=ros)
                if kind == "my_robot_msgs/msg/MyWrench":
                    # As people write it, with comments and constants.
                    text = MY_WRENCH + text[text.index("=" * 80) :]
                encoding = f"ros{ros}msg"
            name = kind if ros == 2 else kind.replace("/msg/", "/")
            schemas[kind] = writer.register_schema(name, encoding, text.encode())
        if topic not in channels:
            channels[topic] = writer.register_channel(
                topic, "cdr" if ros == 2 else "ros1", schemas[kind], {"offered_qos_profiles": ""}
            )
        raw = (
            store.serialize_cdr(message, kind, little_endian=little)
            if ros == 2
            else store.serialize_ros1(message, kind)
        )
        writer.add_message(channels[topic], t, bytes(raw), t)
    writer.finish()
    path.write_bytes(out.getvalue())


def split(path):
    """Three parts with the metadata that ROS 2 writes for them."""
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir()
    count = sum(1 for _ in messages(stores(2), 2))
    names = []
    for part in range(3):
        names.append(f"{path.name}_{part}.mcap")
        mcap(path / names[-1], keep=lambda i: i * 3 // count == part, compression=CompressionType.ZSTD)
    listed = "".join(f"    - {name}\n" for name in names)
    (path / "metadata.yaml").write_text(
        "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n  duration:\n    nanoseconds: 300000000\n"
        f"  message_count: {count}\n  compression_format: \"\"\n  compression_mode: \"\"\n"
        f"  relative_file_paths:\n{listed}  files: []\n"
    )


def old(path, source):
    """As ROS 2 wrote it before Iron: without definitions, and here without the index, as after a kill."""
    shutil.copy(source, path)
    db = sqlite3.connect(path)
    db.executescript(
        "DROP TABLE message_definitions; DROP TABLE metadata; DROP TABLE schema; DROP INDEX timestamp_idx;"
        "ALTER TABLE topics DROP COLUMN type_description_hash; VACUUM;"
    )
    db.close()


def main():
    sqlite = HERE / "sqlite"
    rosbag2(sqlite, StoragePlugin.SQLITE3)
    rosbag2(HERE / "sqlite_message", StoragePlugin.SQLITE3, CompressionMode.MESSAGE)
    rosbag2(HERE / "sqlite_file", StoragePlugin.SQLITE3, CompressionMode.FILE)
    rosbag2(HERE / "mcap", StoragePlugin.MCAP)
    rosbag2(HERE / "mcap_file", StoragePlugin.MCAP, CompressionMode.FILE)
    old(HERE / "old.db3", sqlite / "sqlite.db3")
    split(HERE / "split")
    for name, compression in (("none", None), ("bz2", "BZ2"), ("lz4", "LZ4")):
        rosbag1(HERE / f"{name}.bag", compression and getattr(Bag1Writer.CompressionFormat, compression))
    mcap(HERE / "none.mcap", compression=CompressionType.NONE)
    mcap(HERE / "zstd.mcap", compression=CompressionType.ZSTD, enable_data_crcs=True)
    mcap(HERE / "lz4.mcap", compression=CompressionType.LZ4)
    mcap(HERE / "unchunked.mcap", use_chunking=False)
    mcap(
        HERE / "bare.mcap",
        compression=CompressionType.LZ4,
        index_types=IndexType.NONE,
        repeat_channels=False,
        repeat_schemas=False,
        use_statistics=False,
        use_summary_offsets=False,
        enable_crcs=False,
    )
    mcap(HERE / "big_endian.mcap", little=False, compression=CompressionType.ZSTD)
    mcap(HERE / "idl.mcap", idl=True, compression=CompressionType.ZSTD)
    mcap(HERE / "ros1.mcap", ros=1, compression=CompressionType.LZ4)


main()
