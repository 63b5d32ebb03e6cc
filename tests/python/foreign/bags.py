"""Bags of other arms with known strokes: motion, soil, sensor, and what goes wrong with clocks."""

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from . import arms, cdr, soils

GRAVITY = 9.80665


@dataclass
class Case:
    """What a bag is like. Times in s, lengths in m, forces in N."""

    arm: str = "seven"
    seed: int = 0
    strokes: int = 6
    noise: float = 0.15
    noise_corner_hz: float = 0.0  # 0: white
    wrench_hz: float = 1000.0
    joint_hz: float = 250.0
    tool_n: float = 3.4
    tool_at: tuple = (0.02, -0.01, 0.09)
    bias: tuple = (1.2, -2.1, 4.0, 0.05, -0.02, 0.01)
    drift: float = 0.002  # N/s
    force: tuple = (2.0, 13.0)
    kinds: tuple = ("drastic", "gradual")
    alpha: tuple = (60.0, 90.0)
    depth: tuple = (0.02, 0.05)
    width: float = 0.1
    plan: tuple = ()  # of each stroke: kind, force, tool angle; drawn if empty
    delta: tuple = (10.0, 20.0)
    wall_s: float = 1.7e9  # first stamp
    posture: float = 0.3  # how far the wrist turns in free air, rad; 0: one posture
    presses: int = 0  # contacts without travel
    trouble: tuple = ()
    container: str = "mcap-zstd"


@dataclass
class Truth:
    """A stroke as it was made."""

    kind: str
    force_n: float
    alpha_deg: float
    depth_m: float
    start_s: float  # of the push, from the first stamp
    end_s: float
    fail_s: float
    law: str = ""


@dataclass
class Bag:
    case: Case
    arm: arms.Arm
    t: np.ndarray
    joints_t: np.ndarray
    joints: np.ndarray
    wrench: np.ndarray
    truth: list = field(default_factory=list)
    contacts: list = field(default_factory=list)  # [from, to] of each touch of the soil


def make(case):
    """Moves the arm, asks the soil, reads the sensor."""
    rng = np.random.default_rng(case.seed)
    alphas = rng.uniform(*case.alpha, case.strokes + case.presses)
    heading = rng.uniform(-0.3, 0.3)
    if case.arm == "gantry":
        alphas[:] = alphas[0]
        arm = arms.gantry_at(alphas[0], heading)
    else:
        arm = {"seven": arms.seven, "hung": arms.hung}[case.arm]()
    script = Script(arm, heading)
    rows = []
    script.rest(rng.uniform(2.0, 4.0))
    order = ["stroke"] * case.strokes + ["press"] * case.presses
    rng.shuffle(order)
    for number, what in enumerate(order):
        planned = case.plan[number] if case.plan else None
        if planned:
            alphas[number] = planned[2]
        here = np.array(arm.reach) + rng.uniform(-1, 1, 2) * np.array(arm.span)
        depth = rng.uniform(*case.depth)
        travel = 0.0 if what == "press" else rng.uniform(0.025, 0.05)
        row = script.stroke(here, alphas[number], depth, travel, rng, 0.0 if case.arm == "gantry" else case.posture)
        row.update(kind=rng.choice(case.kinds), force=np.exp(rng.uniform(*np.log(case.force))), depth=depth,
                   alpha=alphas[number], travel=travel, law=rng.choice(["exponential", "tanh", "power", "sine"]))
        if planned:
            row.update(kind=planned[0], force=planned[1])
        rows.append(row)
    script.rest(rng.uniform(1.5, 3.0))
    end = script.time
    t = np.arange(0, end, 1 / case.wrench_hz)
    joints_t = np.arange(0, end, 1 / case.joint_hz) + rng.uniform(0, 0.5 / case.joint_hz)
    path = script.path()
    turn, place = arm.sensor_pose(path(t))
    _, tip = arm.plate_pose(path(t))
    force, truth, contacts = soil_force(case, arm, rows, t, tip, heading, rng)
    to_sensor = np.transpose(turn, (0, 2, 1))
    weight = np.einsum("nij,j->ni", to_sensor, [0, 0, -case.tool_n])
    in_sensor = np.einsum("nij,nj->ni", to_sensor, force)
    # The soil pushes at a third of its depth above the edge.
    lever = np.einsum("nij,nj->ni", to_sensor, tip + [0, 0, 0.01] - place)
    torque = np.cross(lever, in_sensor) + np.cross(np.array(case.tool_at), weight)
    clean = np.concatenate([in_sensor + weight, torque], 1)
    direction = rng.normal(size=3)
    direction /= np.linalg.norm(direction)
    drift = np.concatenate([np.outer(case.drift * t, direction), np.zeros((len(t), 3))], 1)
    sd = np.array([case.noise] * 3 + [0.02 * case.noise] * 3)
    noise = rng.normal(size=clean.shape)
    if case.noise_corner_hz:
        from scipy.signal import lfilter

        share = np.exp(-2 * np.pi * case.noise_corner_hz / case.wrench_hz)
        noise = lfilter([np.sqrt(1 - share**2)], [1, -share], noise, axis=0)
    wrench = clean + np.array(case.bias) + drift + sd * noise
    joints = path(joints_t) + 2e-6 * rng.normal(size=(len(joints_t), len(arm.moving)))
    return Bag(case, arm, t, joints_t, joints, wrench, truth, contacts)


class Script:
    """Way points of the plate, solved for the joints."""

    def __init__(self, arm, heading):
        self.arm, self.heading, self.time = arm, heading, 0.0
        self.q = np.array(arm.home, float)
        self.knots = [(0.0, self.q)]

    def rest(self, seconds):
        for share in np.linspace(0, 1, max(2, int(seconds / 0.2)) + 1)[1:]:
            self.knots.append((self.time + share * seconds, self.q))
        self.time += seconds

    def go(self, place, turn, speed, steps=None, least_s=0.6):
        """In a straight line, slow at both ends."""
        turn_now, place_now = (part[0] for part in self.arm.plate_pose(self.q))
        way = np.asarray(place, float) - place_now
        seconds = max(least_s, np.linalg.norm(way) / speed)
        steps = steps or max(6, int(seconds / 0.1))
        rest = turn @ turn_now.T
        angle = np.arccos(np.clip((np.trace(rest) - 1) / 2, -1, 1))
        axis = np.array([rest[2, 1] - rest[1, 2], rest[0, 2] - rest[2, 0], rest[1, 0] - rest[0, 1]])
        for share in np.linspace(0, 1, steps + 1)[1:]:
            smooth = share if steps > 60 else share**2 * (3 - 2 * share)
            now = turn_now if angle < 1e-9 else arms.axis_angle(axis, angle * smooth) @ turn_now
            self.q = self.arm.solve(now, place_now + smooth * way, self.q)
            self.knots.append((self.time + share * seconds, self.q))
        self.time += seconds

    def stroke(self, here, alpha, depth, travel, rng, posture):
        arm = self.arm
        turn = arm.pose_for(alpha, self.heading)
        ahead = np.array([np.cos(self.heading), np.sin(self.heading), 0])
        begin = np.array([*here, arm.surface_z])
        if posture:
            for _ in range(2):
                lean = arms.rpy(*(posture * rng.uniform(-1, 1, 3)))
                self.go(begin + [0, 0, 0.08], lean @ turn, 0.2, least_s=1.5)
                self.rest(rng.uniform(0.8, 1.5))
        self.go(begin + [0, 0, 0.06], turn, 0.2, least_s=1.5)
        self.rest(rng.uniform(1.0, 2.0))
        down = self.time
        self.go(begin - [0, 0, depth], turn, rng.uniform(0.01, 0.03))
        self.rest(rng.uniform(0.5, 2.0))
        start = self.time
        if travel:
            self.go(begin - [0, 0, depth] + travel * ahead, turn, rng.uniform(0.004, 0.012))
        end = self.time
        self.rest(rng.uniform(0.5, 2.0))
        self.go(begin + travel * ahead + [0, 0, 0.06], turn, rng.uniform(0.02, 0.05))
        up = self.time
        self.rest(rng.uniform(0.5, 1.5))
        return {"down": down, "start": start, "end": end, "up": up, "begin": begin, "ahead": ahead}

    def path(self):
        times = np.array([t for t, _ in self.knots])
        return CubicSpline(times, np.array([q for _, q in self.knots]), bc_type="natural")


def soil_force(case, arm, rows, t, tip, heading, rng):
    """Force of the soil on the plate in the root frame, what was made, and when the plate was in the soil."""
    force, truth, contacts = np.zeros((len(t), 3)), [], []
    for row in rows:
        inside = (t >= row["down"]) & (t <= row["up"])
        sunk = np.clip(arm.surface_z - tip[:, 2], 0, None) * inside
        if not (sunk > 0).any():
            continue
        ahead = row["ahead"]
        u = np.clip((tip - row["begin"]) @ ahead, 0, None)
        share = sunk / row["depth"]
        # Insertion: upwards along the plate; it fades with the first millimetres of travel and while the plate rests.
        press = row["force"] * rng.uniform(0.5, 1.2)
        rest = np.clip(t - row["start"], None, 0)
        vertical = press * share**2 * (0.8 + 0.2 * np.exp(rest)) * np.exp(-u / 0.001)
        rising = t > row["end"]
        vertical[rising] = -0.1 * press * share[rising]
        alpha = np.radians(row["alpha"])
        down = np.cos(alpha) * ahead - np.sin(alpha) * np.array([0, 0, 1.0])
        normal = np.array([-down[2] * ahead[0], -down[2] * ahead[1], np.cos(alpha)])  # ahead of the plate
        here = np.outer(-vertical, down)
        if row["travel"]:
            delta = np.radians(rng.uniform(*case.delta))
            if row["kind"] == "drastic":
                at = rng.uniform(0.2, 0.5) * row["travel"]
                curve = soils.drastic(u, row["force"], at, rng.uniform(0.55, 0.8), 0.0015)
            else:
                at = row["travel"]
                curve = soils.gradual(u, row["force"], row["travel"] / rng.uniform(5, 9), row["law"])
            curve = curve * np.clip(share, 0, 1) ** 2
            # Relaxation at rest, and unloading while the plate leaves.
            after = np.clip(t - row["end"], 0, None)
            curve = curve * (0.85 + 0.15 * np.exp(-after / 0.6))
            unit = -np.cos(delta) * normal - np.sin(delta) * down
            here = here + np.outer(curve, unit)
            push = (t >= row["start"]) & (t <= row["end"])
            fail = t[push][np.argmin(np.abs(u[push] - at))] if row["kind"] == "drastic" else row["end"]
            size = row["force"] if row["kind"] == "gradual" else np.linalg.norm(here[np.searchsorted(t, fail)])
            truth.append(Truth(str(row["kind"]), float(size), float(row["alpha"]), float(row["depth"]),
                               float(row["start"]), float(row["end"]), float(fail),
                               "" if row["kind"] == "drastic" else str(row["law"])))
        force[inside] += here[inside]
        contacts.append([float(row["down"]), float(row["up"])])
    return force, truth, contacts


def stream(bag):
    """Messages of a bag with its troubles: (topic, log time in ns, bytes), in the order of the file."""
    case, rng = bag.case, np.random.default_rng(bag.case.seed + 10_000)
    wall = int(case.wall_s * 1e9)
    names = [joint.name for joint in bag.arm.moving]
    joints_ns = wall + np.round(bag.joints_t * 1e9).astype(np.int64)
    wrench_ns = wall + np.round(bag.t * 1e9).astype(np.int64)
    joints, wrench = bag.joints.copy(), bag.wrench.copy()
    lag = {"joints": 2e6, "wrench": 2e6}
    if "latency" in case.trouble:
        lag["wrench"] = 40e6
    log_joints = joints_ns + (lag["joints"] * (1 + 0.3 * rng.random(len(joints_ns)))).astype(np.int64)
    log_wrench = wrench_ns + (lag["wrench"] * (1 + 0.3 * rng.random(len(wrench_ns)))).astype(np.int64)
    keep_joints, keep_wrench = np.ones(len(joints_ns), bool), np.ones(len(wrench_ns), bool)
    quiet = free_times(bag)
    if "jump" in case.trouble:
        # Clocks of both senders are set back or ahead by the same amount at one time in free air.
        at, by = wall + int(1e9 * rng.choice(quiet)), int(rng.choice([-1, 1]) * rng.uniform(5, 4000) * 1e9)
        joints_ns, wrench_ns = (np.where(ns > at, ns + by, ns) for ns in (joints_ns, wrench_ns))
    if "unstamped" in case.trouble:
        joints_ns, wrench_ns = np.zeros_like(joints_ns), np.zeros_like(wrench_ns)
    if "gaps" in case.trouble:
        for at in rng.choice(quiet, 3):
            keep_wrench &= ~((bag.t > at) & (bag.t < at + rng.uniform(0.05, 0.4)))
        for at in rng.choice(quiet, 3):
            keep_joints &= ~((bag.joints_t > at) & (bag.joints_t < at + rng.uniform(0.02, 0.1)))
    if "late_joints" in case.trouble:
        keep_joints &= bag.joints_t > 1.5
    if "not_finite" in case.trouble:
        hit = rng.random(len(wrench)) < 2e-4
        wrench[hit, rng.integers(0, 6)] = rng.choice([np.nan, np.inf])
    if "clipped" in case.trouble:
        # A sensor that reaches to half of the least failure force on each axis, about its own zero.
        reach = 0.4 * min(t.force_n for t in bag.truth)
        wrench[:, :3] = np.clip(wrench[:, :3], np.array(case.bias[:3]) - reach, np.array(case.bias[:3]) + reach)
    if "dead" in case.trouble:
        wrench[:] = wrench[0]
    if "sign" in case.trouble:
        wrench = -wrench
    if "degrees" in case.trouble:
        joints = np.degrees(joints)
    if "slow" in case.trouble:
        keep_wrench &= np.arange(len(wrench)) % max(1, int(case.wrench_hz / 2)) == 0
    if "no_air" in case.trouble:
        first = bag.truth[0]
        inside = lambda t: (t > first.start_s - 0.4) & (t < first.end_s - 0.2)
        keep_wrench &= inside(bag.t)
        keep_joints &= inside(bag.joints_t)
    if "hole" in case.trouble:
        # Nothing was recorded for a while before each failure.
        for stroke in bag.truth:
            at = stroke.start_s + 0.5 * (stroke.fail_s - stroke.start_s)
            keep_wrench &= ~((bag.t > at) & (bag.t < at + 0.35 * (stroke.fail_s - stroke.start_s)))
    missing = names[1] if "joint_missing" in case.trouble else None
    if missing:
        joints, names = np.delete(joints, 1, axis=1), [name for name in names if name != missing]
    messages = []
    if "split" in case.trouble:
        half = len(names) // 2
        parts = [(names[:half], joints[:, :half], 0), (names[half:], joints[:, half:], 300_000)]
    else:
        extra = [] if "extra_missing" in case.trouble else bag.arm.extra
        parts = [(extra + names, np.concatenate([np.zeros((len(joints), len(extra))), joints], 1), 0)]
    for part, values, shift in parts:
        rows = cdr.joint_states(joints_ns[keep_joints] + shift * (joints_ns[keep_joints] != 0), part, values[keep_joints])
        messages += list(zip(["/arm/joint_states"] * len(rows), log_joints[keep_joints] + shift, rows))
    rows = cdr.wrenches(wrench_ns[keep_wrench], bag.arm.sensor, wrench[keep_wrench])
    messages += list(zip(["/ft/wrench_raw"] * len(rows), log_wrench[keep_wrench], rows))
    if "duplicates" in case.trouble:
        messages += [messages[k] for k in rng.integers(0, len(messages), len(messages) // 200)]
    if "by_topic" not in case.trouble:
        messages.sort(key=lambda message: message[1])
    if "shuffled" in case.trouble:
        order = np.arange(len(messages)) + rng.uniform(0, 40, len(messages))
        messages = [messages[k] for k in np.argsort(order)]
    return messages


def free_times(bag):
    """Times well away from the soil."""
    t = np.arange(0.5, bag.t[-1] - 0.6, 0.1)
    free = np.ones(len(t), bool)
    for begin, end in bag.contacts:
        free &= (t < begin - 0.6) | (t > end + 0.3)
    return t[free]


ENDINGS = {"mcap": ".mcap", "db3": ".db3", "ros1": ".bag"}
JOINTS, WRENCH = "sensor_msgs/msg/JointState", "geometry_msgs/msg/WrenchStamped"


def definition(name, version=2):
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE if version == 2 else Stores.ROS1_NOETIC)
    return store.generate_msgdef(name, ros_version=version)[0]


def write(bag, folder, name="bag"):
    """Writes a bag into a folder and, beside it, its URDF and what is true of it; gives the bag's path."""
    path = Path(folder) / f"{name}{ENDINGS[bag.case.container.partition('-')[0]]}"
    types = {"/arm/joint_states": JOINTS, "/ft/wrench_raw": WRENCH}
    messages = stream(bag)
    kind, _, option = bag.case.container.partition("-")
    {"mcap": write_mcap, "db3": write_db3, "ros1": write_ros1}[kind](path, types, messages, option)
    path.with_suffix(".urdf").write_text(bag.arm.urdf())
    told = {"case": asdict(bag.case), "truth": [asdict(t) for t in bag.truth], "contacts": bag.contacts,
            "surface_z": bag.arm.surface_z, "plate": bag.arm.plate}
    path.with_suffix(".json").write_text(json.dumps(told))
    return path


def write_mcap(path, types, messages, option):
    from mcap.writer import CompressionType, Writer

    compression = {"zstd": CompressionType.ZSTD, "lz4": CompressionType.LZ4}.get(option, CompressionType.NONE)
    with open(path, "wb") as file:
        writer = Writer(file, compression=compression, use_chunking=option != "plain")
        writer.start(profile="ros2", library="another program")
        channels = {}
        for topic, name in types.items():
            schema = writer.register_schema(name, "ros2msg", definition(name).encode())
            channels[topic] = writer.register_channel(topic, "cdr", schema)
        for number, (topic, time, data) in enumerate(messages):
            writer.add_message(channels[topic], int(time), data, int(time), number)
        writer.finish()


def write_db3(path, types, messages, option):
    import sqlite3

    base = sqlite3.connect(path)
    base.executescript(
        "create table topics(id integer primary key, name text not null, type text not null, serialization_format text "
        "not null, offered_qos_profiles text not null);"
        "create table messages(id integer primary key, topic_id integer not null, timestamp integer not null, data blob not null);"
    )
    ids = {}
    for number, (topic, name) in enumerate(types.items(), 1):
        base.execute("insert into topics values (?, ?, ?, 'cdr', '')", (number, topic, name))
        ids[topic] = number
    base.executemany("insert into messages(topic_id, timestamp, data) values (?, ?, ?)",
                     ((ids[topic], int(time), data) for topic, time, data in messages))
    base.commit()
    base.close()


def write_ros1(path, types, messages, option):
    from rosbags.rosbag1 import Writer
    from rosbags.typesys import Stores, get_typestore

    two, one = get_typestore(Stores.ROS2_HUMBLE), get_typestore(Stores.ROS1_NOETIC)
    writer = Writer(path)
    if option:
        writer.set_compression({"lz4": Writer.CompressionFormat.LZ4, "bz2": Writer.CompressionFormat.BZ2}[option])
    with writer:
        connections = {topic: writer.add_connection(topic, name, typestore=one) for topic, name in types.items()}
        for topic, time, data in messages:
            writer.write(connections[topic], int(time), two.cdr_to_ros1(data, types[topic]))


TROUBLES = ("latency", "jump", "unstamped", "gaps", "late_joints", "not_finite", "split", "extra_missing", "duplicates",
            "by_topic", "shuffled")


def any_case(seed):
    """A case of all that may come: noise of 0.02 to 1 N, 50 to 2000 Hz, tools up to 50 N, forces from 8 times the noise on."""
    rng = np.random.default_rng(seed)
    noise = float(np.exp(rng.uniform(*np.log([0.02, 1.0]))))
    least = max(2.0, 8.5 * noise)
    high = float(np.exp(rng.uniform(np.log(1.5 * least), np.log(200.0))))
    rate = float(rng.choice([50, 100, 250, 500, 1000, 2000]))
    return Case(
        arm=str(rng.choice(["seven", "gantry", "hung"])),
        seed=seed,
        strokes=int(rng.integers(3, 7)),
        presses=int(rng.integers(0, 3)),
        noise=noise,
        noise_corner_hz=float(rng.choice([0.0, 0.0, rate * rng.uniform(0.03, 0.2)])),
        wrench_hz=rate,
        joint_hz=float(rng.choice([50, 100, 250, 500])),
        tool_n=float(rng.uniform(0, 50) if rng.random() < 0.5 else rng.uniform(0, 5)),
        tool_at=tuple(rng.uniform(-0.03, 0.03, 2)) + (float(rng.uniform(0.02, 0.12)),),
        bias=tuple(rng.normal(0, 10, 3)) + tuple(rng.normal(0, 0.3, 3)),
        drift=float(rng.uniform(0, 0.005)),
        force=(least, high),
        posture=float(rng.choice([0.0, 0.15, 0.4])),
        trouble=tuple(str(t) for t in TROUBLES if rng.random() < 0.15),
        container=str(rng.choice(["mcap-zstd", "mcap-lz4", "mcap-none", "mcap-plain"])),
    )


def press(seed=0, noise=0.3, hz=100.0, force=250.0, level=False):
    """A stage with one sliding joint presses a plate down, rests, and comes up: no stroke. With `level` it moves along the ground, and
    the force falls only while it stands still."""
    rng = np.random.default_rng(seed)
    arm = arms.stage()
    if level:
        # The same stage on its side, at the depth of 30 mm.
        arm.joints[0].axis, arm.joints[0].xyz, arm.surface_z = (1, 0, 0), (0, 0, 0.38), 0.26
    case = Case(arm="stage", seed=seed, strokes=0, noise=noise, wrench_hz=hz, joint_hz=100.0, tool_n=8.0, width=0.1)
    way = 0.22 if not level else 0.06
    times = np.array([0, 8.0, 8.0 + way / 0.01, 28.0 + way / 0.01, 32.0 + way / 0.01, 36.0 + way / 0.01])
    t = np.arange(0, times[-1], 1 / hz)
    joints_t = np.arange(5.0, times[-1], 0.01)
    at = lambda s: np.interp(s, times, [0, 0, way, way, 0, 0])
    turn, place = arm.sensor_pose(at(t)[:, None])
    _, tip = arm.plate_pose(at(t)[:, None])
    rest = np.clip(t - times[2], 0, None)
    if level:
        going = np.clip(at(t) / way, 0, 1)
        size = np.where(t <= times[3], force * going * np.where(rest > 0, 0.5 + 0.5 * np.exp(-rest / 4), 1.0), 0.0)
        world = np.outer(size, [-1, 0, 0.2])
    else:
        sunk = np.clip(arm.surface_z - tip[:, 2], 0, None)
        size = force * (sunk / 0.1) ** 1.2 * np.where(rest > 0, 0.7 + 0.3 * np.exp(-rest / 2), 1.0)
        world = np.outer(np.where(t > times[3], 0.0, size), [0, 0, 1.0])
    to_sensor = np.transpose(turn, (0, 2, 1))
    clean = np.einsum("nij,nj->ni", to_sensor, world + [0, 0, -case.tool_n])
    wrench = np.concatenate([clean, np.zeros_like(clean)], 1) + np.array(case.bias) + noise * rng.normal(size=(len(t), 6))
    return Bag(case, arm, t, joints_t, at(joints_t)[:, None], wrench, [], [[float(times[1]), float(times[4])]])
