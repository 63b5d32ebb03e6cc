"""`soilctl heights`: what scans of the ground before and after a stroke say.

The ground is made by numpy: a heap whose edge is known, a furrow, noise, and a scanner that moved between the scans. Recordings are written by `rosbags`. What the
files of GDAL and tifffile say is tested in `crates/heights`.
"""

import csv
import importlib.util
import math

import numpy as np
import pytest
from conftest import strict_json
from foreign import bags, score
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

WIDTH, FURROW, DEEP, TOP = 0.127, 0.05, 0.012, 0.008
PLATE, HEADING = (0.31, -0.12), 30.0


@pytest.fixture(scope="module")
def ground(data):
    spec = importlib.util.spec_from_file_location("make_places", data / "places" / "make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def rough(x, y):
    return 0.002 * np.sin(35 * x + 4 * y) + 0.0015 * np.sin(28 * y - 9 * x)


def moved(x, y, edge, heading=HEADING, plate=PLATE):
    """Change of height by a stroke: a heap up to `edge` with straight sides on a block, and a furrow behind the plate."""
    c, s = math.cos(math.radians(heading)), math.sin(math.radians(heading))
    ahead = c * (x - plate[0]) + s * (y - plate[1])
    left = c * (y - plate[1]) - s * (x - plate[0])
    wide = np.abs(left) < WIDTH / 2
    heap = np.where(wide & (ahead >= 0) & (ahead < edge), TOP * (1 - ahead / edge) + 0.001, 0.0)
    return heap - np.where(wide & (ahead < 0) & (ahead > -FURROW), DEEP, 0.0)


def grids(folder, random, edge, *, cell=0.0025, noise=0.0003, tilt=0.01, up=0.003):
    """Two ESRI grids around the plate; the second scan is higher and tilted."""
    count = int(0.36 / cell)
    low = np.array(PLATE) - 0.18
    x, y = np.meshgrid(*(axis + cell * (np.arange(count) + 0.5) for axis in low))
    paths = []
    for name, heights in (("before", rough(x, y)), ("after", rough(x, y) + moved(x, y, edge) + up + tilt * x)):
        heights = heights + random.normal(0.0, noise, x.shape)
        header = f"ncols {count}\nnrows {count}\nxllcorner {low[0]:.9f}\nyllcorner {low[1]:.9f}\ncellsize {cell}\nNODATA_value -9999\n"
        rows = "\n".join(" ".join(f"{z:.6f}" for z in row) for row in heights[::-1])
        paths.append(folder / f"{name}.asc")
        paths[-1].write_text(header + rows + "\n")
    return paths


def place(plate=PLATE, heading=HEADING):
    return ["--plate-x", plate[0], "--plate-y", plate[1], "--heading", heading, "--plate-sd", 0.0005]


def ask(soilctl, *arguments, code=0):
    return strict_json(soilctl("heights", *arguments, "--format", "json", code=code).stdout)


def test_edge_and_volumes_hold_the_truth(soilctl, tmp_path, validate):
    """In eight scans no more than one distance is outside of its range; volumes are those of boxes and wedges, which cells meet to a percent or two."""
    random, held = np.random.default_rng(1), 0
    for _ in range(8):
        edge = random.uniform(0.05, 0.1)
        answer = ask(soilctl, *grids(tmp_path, random, edge), *place(), "--width", WIDTH)
        low, high = answer["ground_break"]["within_m"]
        held += low <= edge <= high
        assert high - low < 0.03
        heap, furrow = edge * WIDTH * (TOP / 2 + 0.001), FURROW * WIDTH * DEEP
        assert answer["heap"]["volume_m3"] == pytest.approx(heap, rel=0.03)
        assert answer["furrow"]["volume_m3"] == pytest.approx(furrow, rel=0.03)
        assert answer["swelling"] == pytest.approx(heap / furrow, rel=0.04)
        # Differences of two heights have the noise of both; the scanner's lift and tilt are found.
        assert answer["noise_m"] == pytest.approx(0.0003 * math.sqrt(2), rel=0.1)
        assert answer["shift"]["up_m"] == pytest.approx(0.003 + 0.01 * PLATE[0], abs=1e-4)
        assert answer["shift"]["tilt_deg"] == pytest.approx([math.degrees(math.atan(0.01)), 0.0], abs=0.02)
    validate(answer)
    assert held >= 7


STORE = get_typestore(Stores.ROS2_HUMBLE)


def header(t, frame):
    stamp = STORE.types["builtin_interfaces/msg/Time"](sec=int(t), nanosec=round(t % 1 * 1e9))
    return STORE.types["std_msgs/msg/Header"](stamp=stamp, frame_id=frame)


def cloud(t, points, frame):
    """Floats without rows, as many depth cameras write them."""
    field = STORE.types["sensor_msgs/msg/PointField"]
    return STORE.types["sensor_msgs/msg/PointCloud2"](
        header=header(t, frame), height=1, width=len(points), fields=[field(name=n, offset=4 * i, datatype=7, count=1) for i, n in enumerate("xyz")],
        is_bigendian=False, point_step=12, row_step=12 * len(points), data=np.frombuffer(points.astype("<f4").tobytes(), np.uint8), is_dense=False,
    )  # fmt: skip


def write_bag(path, messages):
    """Messages as (topic, time in s, message), in the order of their times."""
    with Writer(path, version=9, storage_plugin=StoragePlugin.MCAP) as writer:
        connections = {}
        for topic, t, message in sorted(messages, key=lambda one: one[1]):
            kind = message.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=STORE)
            writer.write(connections[topic], round(t * 1e9), STORE.serialize_cdr(message, kind))
    return path


def record(path, scans, frames=("bin", "bin"), topic="/camera/points"):
    clouds = zip(scans, frames, strict=True)
    return write_bag(path, [(topic, 1000 + t, cloud(1000 + t, points, frame)) for t, (points, frame) in enumerate(clouds)])


def scan(random, edge=None, count=60_000):
    x, y = (axis + random.uniform(-0.18, 0.18, count) for axis in PLATE)
    z = rough(x, y) + random.normal(0.0, 0.001, count) + (0.0 if edge is None else moved(x, y, edge))
    points = np.column_stack([x, y, z])
    points[::50] = np.nan
    return points


def test_clouds_of_a_recording(soilctl, tmp_path, validate):
    random, edge = np.random.default_rng(2), 0.08
    path = record(tmp_path / "scan", [scan(random), scan(random, edge), scan(random, 0.12)], frames=("bin",) * 3)
    answer = ask(soilctl, path, path, *place(), "--width", WIDTH, "--cell", 0.004, "--after-at", 1)
    validate(answer)
    low, high = answer["ground_break"]["within_m"]
    assert low <= edge <= high
    for second, found in enumerate(answer["maps"]):
        assert (found["format"], found["frame"], found["time_s"]) == ("cloud", "bin", 1000 + second)
        assert found["missing_points"] == 1200 and found["points"] == 58_800
        # 16 mm2 of 0.36 m by 0.36 m.
        assert found["points_per_cell"] == pytest.approx(58_800 * 0.004**2 / 0.36**2, abs=1)
    low, high = ask(soilctl, path, path, *place(), "--width", WIDTH, "--cell", 0.004)["ground_break"]["within_m"]
    assert low <= 0.12 <= high
    # By itself some five points a cell, on the same cells in both.
    answer = ask(soilctl, path, path, *place(), "--width", WIDTH, "--topic", "/camera/points")
    assert 4 <= answer["maps"][0]["points_per_cell"] <= 6 and answer["maps"][0]["size"] == answer["maps"][1]["size"]
    for options, words in [
        (("--after-at", 0), "has one cloud at both times"),
        (("--before-at", 2, "--after-at", 1), "older than that before it"),
        (("--topic", "/scan"), "no topic /scan"),
    ]:
        assert words in soilctl("heights", path, path, *place(), "--width", WIDTH, *options, code=2).stderr
    apart = record(tmp_path / "apart", [scan(random), scan(random, edge)], frames=("bin", "camera"))
    assert "in the frame bin, the one after in camera" in soilctl("heights", apart, apart, *place(), "--width", WIDTH, code=2).stderr


def gantry(alpha_deg):
    """Three sliding axes with a plate, its z axis down along it, and a camera that looks down from the base."""
    alpha, heading = math.radians(alpha_deg), math.radians(HEADING)
    ahead, up = np.array([math.cos(heading), math.sin(heading), 0.0]), np.array([0.0, 0.0, 1.0])
    down, across = math.cos(alpha) * ahead - math.sin(alpha) * up, np.cross(up, ahead)
    turn = Rotation.from_matrix(np.stack([np.cross(across, down), across, down], 1)).as_euler("xyz")
    links, joints = ["base", "x", "y", "z", "blade", "wrist", "camera_optical"], []
    for parent, link, axis in (("base", "x", "1 0 0"), ("x", "y", "0 1 0"), ("y", "z", "0 0 1")):
        limit = '<limit lower="-2" upper="2" effort="9" velocity="9"/>'
        joints.append(f'<joint name="to_{link}" type="prismatic"><parent link="{parent}"/><child link="{link}"/><axis xyz="{axis}"/>{limit}</joint>')
    fixed = (
        ("z", "blade", (0, 0, 0), turn),
        ("z", "wrist", (0, 0, 0.3), (0, 0, 0)),
        ("base", "camera_optical", (0.3, -0.1, 0.7), (math.pi, 0, 0.4)),
    )
    for parent, link, xyz, rpy in fixed:
        origin = f'<origin xyz="{" ".join(map(str, xyz))}" rpy="{" ".join(map(str, rpy))}"/>'
        joints.append(f'<joint name="to_{link}" type="fixed"><parent link="{parent}"/><child link="{link}"/>{origin}</joint>')
    urdf = '<robot name="g">' + "".join(f'<link name="{link}"/>' for link in links) + "".join(joints) + "</robot>"
    return urdf, lambda points: Rotation.from_euler("xyz", (math.pi, 0, 0.4)).inv().apply(points - (0.3, -0.1, 0.7)), ahead


def test_the_arm_of_the_recording_tells_where_the_plate_was(soilctl, tmp_path, validate):
    """A drag of 50 mm whose face ends at the plate's place, then the arm goes away; the camera's z points down."""
    random, edge, depth, alpha_deg = np.random.default_rng(6), 0.08, 0.025, 70.0
    urdf, into_camera, ahead = gantry(alpha_deg)
    (tmp_path / "arm.urdf").write_text(urdf)
    # The lower edge is ahead of the face by what the plate leans.
    surface = rough(*PLATE)
    end = np.array([*PLATE, surface]) + depth / math.tan(math.radians(alpha_deg)) * ahead - (0, 0, depth)
    begin, high = end - FURROW * ahead, np.array([0, 0, 0.2])
    times, places = [0.0, 1, 3, 5, 6, 8], np.array([begin + high, begin + high, begin, end, end + high, end + 4 * high])
    states = []
    for t in np.arange(0.0, 8.0, 0.02):
        position = np.array([np.interp(t, times, places[:, i]) for i in range(3)])
        empty = np.array([])
        state = STORE.types["sensor_msgs/msg/JointState"](header=header(2000 + t, ""), name=["to_x", "to_y", "to_z"], position=position, velocity=empty, effort=empty)
        states.append(("/joint_states", 2000 + t, state))
    scans = [(t, into_camera(scan(random, of))) for t, of in ((0.5, None), (7.5, edge))]
    clouds = [("/points", 2000 + t, cloud(2000 + t, points, "camera_optical")) for t, points in scans]
    path = write_bag(tmp_path / "arm", states + clouds)
    arm = ["--urdf", tmp_path / "arm.urdf", "--plate-frame", "blade", "--width", WIDTH, "--cell", 0.004, "--plate-sd", 0.001]
    answer = ask(soilctl, path, path, *arm)
    validate(answer)
    assert answer["plate"]["x_m"] == pytest.approx(PLATE[0], abs=1e-3) and answer["plate"]["y_m"] == pytest.approx(PLATE[1], abs=1e-3)
    assert answer["plate"]["heading_deg"] == pytest.approx(HEADING, abs=0.5)
    low, high = answer["ground_break"]["within_m"]
    assert low <= edge <= high
    # The depth is known from the arm and the first scan.
    assert answer["pushed_m"] == pytest.approx(FURROW * DEEP / depth, rel=0.08)
    for options, words in [
        (("--plate-frame", "wrist"), "was never below the ground"),
        (("--plate-frame", "shovel"), "shovel"),
        (("--after-at", 0.1), "one cloud at both times"),
        (("--plate-x", 1), "cannot be used with '--plate-x"),
    ]:
        words_of = [word for word in arm if word not in ("--plate-frame", "blade")] if "--plate-frame" in options else arm
        assert words in soilctl("heights", path, path, *words_of, *options, code=2).stderr
    elsewhere = [("/points", t, cloud(t, points, "map")) for _, t, _ in clouds for points in [scans[0][1]]]
    path = write_bag(tmp_path / "elsewhere", states + elsewhere)
    assert "clouds are in the frame map" in soilctl("heights", path, path, *arm, code=2).stderr


def strokes(ground, phi_deg):
    bounds = ground.Bounds()
    for alpha_deg in (70.0, 80.0, 90.0, 100.0):
        depth_m = 0.0254 * math.sin(math.radians(alpha_deg))
        force_n = bounds.force_n(alpha_deg, phi_deg, 20.0, 1550.0, depth_m)
        yield {
            "stroke_id": f"s{alpha_deg:.0f}", "alpha_deg": alpha_deg, "depth_m": depth_m, "width_m": WIDTH, "force_n": force_n,
            "force_sd_n": 0.02 * force_n, "delta_set_deg": 20.0, "remark": "dry",
        }  # fmt: skip


def test_a_scan_goes_into_the_stroke_table_and_narrows_or_contradicts(soilctl, tmp_path, ground):
    """Sand that dilates by its friction angle breaks where Chen and Liu's mechanism says, found by brute force."""
    random, phi = np.random.default_rng(3), 36.0
    rows = list(strokes(ground, phi))
    table, out = tmp_path / "strokes.csv", tmp_path / "out.csv"
    with open(table, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    crack = ground.break_distance_m(80.0, phi, 20.0, rows[1]["depth_m"])
    scans = grids(tmp_path, random, crack, noise=0.0002)
    into = ["--strokes", table, "--stroke", "s80", "--out", out]
    answer = ask(soilctl, *scans, *place(), *into)
    assert (answer["plate"]["width_m"], answer["written"]) == (WIDTH, str(out))
    assert answer["pushed_m"] == pytest.approx(FURROW * DEEP / rows[1]["depth_m"], rel=0.03)
    with open(out, newline="") as file:
        written = list(csv.DictReader(file))
    assert [row["remark"] for row in written] == ["dry"] * 4
    assert [row["break_distance_m"] != "" for row in written] == [False, True, False, False]
    assert float(written[1]["break_distance_m"]) == answer["ground_break"]["distance_m"]
    assert float(written[1]["break_distance_sd_m"]) == answer["ground_break"]["sd_m"] + answer["ground_break"]["resolution_m"]
    said = strict_json(soilctl("surface", out, "--delta", 20, "--format", "json").stdout)
    chen = next(model for model in said["models"] if model["surface"] == "chen")
    force = said["force"]["phi_deg"]
    assert chen["agreement"] == "agrees" and chen["phi_both_deg"][0] <= phi <= chen["phi_both_deg"][1]
    assert chen["phi_both_deg"][1] - chen["phi_both_deg"][0] < force[1] - force[0]
    # It is not written over without being told to; half of the distance contradicts the forces.
    assert "--replace" in soilctl("heights", *scans, *place(), *into, code=2).stderr
    near = grids(tmp_path, random, 0.4 * crack, noise=0.0002)
    ask(soilctl, *near, *place(), *into, "--replace")
    said = strict_json(soilctl("surface", out, "--delta", 20, "--format", "json", code=1).stdout)
    assert {model["agreement"] for model in said["models"]} <= {"nearer", "no-friction"}
    for options, words in [(("--stroke", "s81"), "no stroke `s81`; it has s70, s80"), (("--stroke", "s80", "--out", tmp_path), "is there")]:
        assert words in soilctl("heights", *scans, *place(), "--strokes", table, *options, code=2).stderr


def test_what_cannot_be_said_is_not(soilctl, tmp_path):
    random = np.random.default_rng(4)
    scans = grids(tmp_path, random, 0.08)
    answer = ask(soilctl, scans[0], scans[0], *place(), "--width", WIDTH, code=1)
    assert answer["ground_break"] is None and "nothing near the plate rises" in answer["no_break_because"]
    assert any("the same in both maps" in warning for warning in answer["warnings"])
    long = grids(tmp_path, random, 0.5)
    answer = ask(soilctl, *long, *place(), "--width", WIDTH, code=1)
    assert "where the map ends" in answer["no_break_because"] and answer["heap"]["off_map"]
    # The plate looked at from behind, or beside where it was: nothing rises there.
    assert ask(soilctl, *scans, *place(heading=HEADING + 180), "--width", WIDTH, code=1)["ground_break"] is None
    for options, words in [
        ((*place((5.0, 0.0)), "--width", WIDTH), "no ground within"),
        (place(), "give --width"),
        (("--plate-x", 1, "--width", WIDTH), "--plate-y"),
        (("--width", WIDTH), "the plate's place is not known"),
        ((*place(), "--width", 0), "--width is 0 m; it must be at least 0.0001 m"),
        ((*place(), "--width", WIDTH, "--deviations", 0.5), "--deviations is 0.5"),
        ((*place(), "--width", WIDTH, "--out", tmp_path / "o.csv"), "--strokes"),
    ]:
        assert words in soilctl("heights", *scans, *options, code=2).stderr
    assert "check the path" in soilctl("heights", tmp_path / "none.tif", scans[1], *place(), "--width", WIDTH, code=2).stderr


def test_the_scans_of_the_documentation_are_what_their_script_makes(data, tmp_path):
    spec = importlib.util.spec_from_file_location("make_scan", data / "scan" / "make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    folder = tmp_path / "data" / "scan"
    folder.mkdir(parents=True)
    for name in ("places", "plate_bounds.csv"):
        (folder.parent / name).symlink_to(data / name)
    module.HERE = folder
    module.main()
    for name in ("before.asc", "after.asc"):
        assert (folder / name).read_bytes() == (data / "scan" / name).read_bytes()


def test_the_page_opens(soilctl, tmp_path, open_page):
    page = tmp_path / "heights.html"
    soilctl("heights", *grids(tmp_path, np.random.default_rng(5), 0.08), *place(), "--width", WIDTH, "--depth", 0.025, "--report", page)
    opened = open_page(page)
    assert opened.locator("h1").inner_text() == "What does a scan of the ground say?"
    assert opened.locator("figure").count() == 3


def test_process_reads_the_scans_around_each_stroke(soilctl, tmp_path, validate):
    """An arm and forces made by `foreign`, and clouds between its strokes: also one while the plate is in the ground, which must not count."""
    random, edges = np.random.default_rng(3), (0.09, 0.07)
    case = bags.Case(arm="gantry", seed=5, strokes=2, noise=0.05, kinds=("drastic",), alpha=(70.0, 70.0), width=WIDTH, container="mcap-none", plan=(("drastic", 8.0, 70.0),) * 2)
    bag = bags.make(case)
    surface = bag.arm.surface_z
    tips = bag.arm.plate_pose(bag.joints)[1]
    at = lambda t: tips[np.searchsorted(bag.joints_t, t)]
    middle = np.mean([at(stroke.end_s) for stroke in bag.truth], 0)

    def scene(t, moves):
        x, y = (axis + random.uniform(-0.3, 0.3, 150_000) for axis in middle[:2])
        z = surface + rough(x, y) + random.normal(0.0, 0.0005, len(x)) + sum(moved(x, y, *move) for move in moves)
        message = cloud(case.wall_s + t, np.column_stack([x, y, z]), "")
        return "/points", round((case.wall_s + t) * 1e9), bytes(STORE.serialize_cdr(message, message.__msgtype__))

    clouds, moves = [], []
    for (down, up), stroke, edge in zip(bag.contacts, bag.truth, edges, strict=True):
        begin, end = at(stroke.start_s), at(stroke.end_s)
        ahead = (end - begin)[:2] / np.linalg.norm((end - begin)[:2])
        face = end[:2] - stroke.depth_m / math.tan(math.radians(stroke.alpha_deg)) * ahead
        heading = math.degrees(math.atan2(ahead[1], ahead[0]))
        clouds.append(scene(down - 0.4, moves))
        clouds.append(scene((stroke.start_s + stroke.end_s) / 2, [*moves, (0.03, heading, face)]))
        moves.append((edge, heading, face))
        clouds.append(scene(up + 0.2, moves))
    messages = sorted([*bags.stream(bag), *clouds], key=lambda message: message[1])
    types = {"/arm/joint_states": bags.JOINTS, "/ft/wrench_raw": bags.WRENCH, "/points": "sensor_msgs/msg/PointCloud2"}
    path = tmp_path / "arm.mcap"
    bags.write_mcap(path, types, messages, "none")
    path.with_suffix(".urdf").write_text(bag.arm.urdf())
    options = score.options(bag, path)
    answer = soilctl.json("process", path, *options, "--out", tmp_path / "strokes.csv")
    validate(answer)
    scans = answer["logs"][0]["scans"]
    assert [scan["reason"] for scan in scans] == [None, None]
    with open(tmp_path / "strokes.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row, scan, edge in zip(rows, scans, edges, strict=True):
        assert row["stroke_id"] == scan["stroke_id"] and float(row["break_distance_m"]) == scan["break_distance_m"]
        assert abs(scan["break_distance_m"] - edge) < 2 * scan["break_distance_sd_m"] < 0.03
    # Forces are what they are without clouds; a topic that is asked for and not there is missed.
    done = soilctl("process", path, *options, "--scan-topic", "/depth", "--format", "json", code=3)
    without = strict_json(done.stdout)
    assert "no topic /depth" in without["logs"][0]["unusable"][-1]
    assert [row["force_n"] for row in without["strokes"]] == [row["force_n"] for row in answer["strokes"]]
    assert "broke the ground" in soilctl("process", path, *options).stdout
