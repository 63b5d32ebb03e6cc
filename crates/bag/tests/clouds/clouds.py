"""Makes `clouds.mcap` and `clouds.bag` beside it by `rosbags`, with the points laid out by numpy: tests/points.rs states what they hold.

    python clouds.py            (with rosbags==0.11.9 numpy)
"""

import shutil
from pathlib import Path

import numpy as np
from rosbags.rosbag1 import Writer as Bag1Writer
from rosbags.rosbag2 import StoragePlugin, Writer as Bag2Writer
from rosbags.typesys import Stores, get_typestore

HERE = Path(__file__).parent
START_NS = 1_700_000_000_000_000_000
NUMBERS = {"f4": 7, "f8": 8, "u1": 2, "u2": 4}


def clouds():
    """Point (i, j) is at (i / 8, j / 4, (i + j) / 16); that of row 1, column 2 has no height."""
    rows, columns = 2, 3
    for number, (order, kind, padding) in enumerate((("<", "f4", 8), (">", "f8", 0), (">", "f4", 0))):
        names = {"intensity": order + "u2", "x": order + kind, "y": order + kind, "ring": "u1", "z": order + kind}
        layout = np.dtype({"names": list(names), "formats": list(names.values())})
        points = np.zeros((rows, columns), layout)
        j, i = np.mgrid[:rows, :columns]
        points["x"], points["y"], points["z"] = i / 8, j / 4, (i + j) / 16
        points["z"][1, 2] = np.nan
        raw = b"".join(row.tobytes() + b"\0" * padding for row in points)
        if number == 2:  # unorganised
            rows, columns = 1, rows * columns
        fields = [(name, layout.fields[name][1], NUMBERS[format[-2:]]) for name, format in names.items()]
        step = len(raw) // rows
        yield number, dict(height=rows, width=columns, fields=fields, big=order == ">", point_step=layout.itemsize, row_step=step, raw=raw)


def messages(ros):
    store = get_typestore(Stores.ROS1_NOETIC if ros == 1 else Stores.ROS2_HUMBLE)
    types = store.types
    for number, cloud in clouds():
        t = START_NS + number * 10**9
        stamp = types["builtin_interfaces/msg/Time"](sec=t // 10**9, nanosec=t % 10**9)
        seq = {"seq": number} if ros == 1 else {}
        field = types["sensor_msgs/msg/PointField"]
        yield store, t + 5, types["sensor_msgs/msg/PointCloud2"](
            header=types["std_msgs/msg/Header"](stamp=stamp, frame_id="bin", **seq),
            height=cloud["height"],
            width=cloud["width"],
            fields=[field(name=name, offset=offset, datatype=number, count=1) for name, offset, number in cloud["fields"]],
            is_bigendian=cloud["big"],
            point_step=cloud["point_step"],
            row_step=cloud["row_step"],
            data=np.frombuffer(cloud["raw"], np.uint8),
            is_dense=False,
        )


def main():
    folder = HERE / "clouds"
    shutil.rmtree(folder, ignore_errors=True)
    with Bag2Writer(folder, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connection = None
        for store, t, message in messages(2):
            connection = connection or writer.add_connection("/scan", message.__msgtype__, typestore=store)
            writer.write(connection, t, store.serialize_cdr(message, message.__msgtype__))
    (folder / "clouds.mcap").replace(HERE / "clouds.mcap")
    shutil.rmtree(folder)
    (HERE / "clouds.bag").unlink(missing_ok=True)
    with Bag1Writer(HERE / "clouds.bag") as writer:
        connection = None
        for store, t, message in messages(1):
            connection = connection or writer.add_connection("/scan", message.__msgtype__, typestore=store)
            writer.write(connection, t, store.serialize_ros1(message, message.__msgtype__))


main()
