"""Takes the controller's steps out of a log with Python's mcap and numpy; prints the seconds it took.

`wrench` reads six numbers at their fixed place in the bytes, the least that one can do; `decoder` has mcap-ros2-support
decode the messages and takes out what soilctl uses of them. Neither looks for strokes or fits anything.
"""

import json
import sys
import time

import numpy as np
from mcap.reader import make_reader

TOPIC = "/controller/step"
# Four bytes say how the rest is encoded; the numbers before the wrench take 72 more.
WRENCH_AT = 76


def wrench(reader):
    rows = [
        np.frombuffer(message.data, "<f8", 6, WRENCH_AT)
        for _, _, message in reader.iter_messages(topics=[TOPIC], log_time_order=False)
    ]
    return np.stack(rows)


def decoder(reader):
    rows = [
        np.concatenate(
            [step.wrench, step.motor_joints_rad, step.external_joints_rad, step.joint_torques_nm, [step.tick]]
        )
        for _, _, _, step in reader.iter_decoded_messages(topics=[TOPIC], log_time_order=False)
    ]
    return np.stack(rows)


def main():
    how, path = sys.argv[1:]
    start = time.perf_counter()
    with open(path, "rb") as file:
        if how == "decoder":
            from mcap_ros2.decoder import DecoderFactory

            rows = decoder(make_reader(file, decoder_factories=[DecoderFactory()]))
        else:
            rows = wrench(make_reader(file))
    assert np.isfinite(rows).all()
    print(json.dumps({"rows": len(rows), "mean": float(rows[:, 0].mean()), "seconds": time.perf_counter() - start}))


main()
