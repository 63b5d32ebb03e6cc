"""The simulated plant, driven by a controller of the user's own."""

import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import soilctl

ARM = soilctl.Arm()
START = np.radians([0.0, 30.0, 100.0, 0.0, 30.0])


class Holder:
    """Holds the motors where they were at first: springs and dampers on the encoders' counts."""

    def __init__(self):
        self.first = self.last = None
        self.steps = 0
        hold = ARM.gravity_torques(START)
        # The same work at motors and joints: torques go by the transposed map.
        unit = np.eye(5) * 1e-3
        origin = ARM.joint_angles(np.zeros(5))
        self.hold = np.array([(ARM.joint_angles(row) - origin) @ hold / 1e-3 for row in unit])

    def step(self, sensed):
        counts = sensed.motor_counts
        if self.first is None:
            self.first = self.last = counts
        error, rate = self.first - counts, counts - self.last
        self.last = counts
        self.steps += 1
        return self.hold + 1e-4 * error - 1e-3 * rate


def test_a_controller_of_ones_own_drives_10000_steps():
    plant = soilctl.Plant()
    controller = Holder()
    sensed = plant.run(controller, ticks=10_001)
    assert controller.steps == 10_000 and sensed.tick == plant.ticks == 10_001
    joints = plant.truth["joint_angles_rad"]
    assert np.isfinite(joints).all()
    assert abs(joints - START).max() < np.radians(10.0), "it holds the arm"


def test_the_same_torques_give_the_same_bits():
    def run():
        plant = soilctl.Plant("ticino_rained", seed=3)
        readings = [plant.step([0.1 * n, 0.2, -0.1, 0.0, 0.05]).wrench for n in range(50)]
        return np.array(readings), plant.truth

    (first, truth), (second, _) = run(), run()
    np.testing.assert_array_equal(first, second)
    assert first.shape == (50, 6) and set(truth) >= {"tip_m", "depth_m", "failing", "limit_force_n"}
    other = soilctl.Plant("ticino_rained", seed=4)
    assert not np.array_equal(other.step(np.zeros(5)).wrench, first[0])


@pytest.mark.parametrize(
    ("torques", "error", "words"),
    [
        ([0, 0, np.nan, 0, 0], soilctl.InputError, r"motor_torques_nm\[2\] is nan"),
        ([np.inf, 0, 0, 0, 0], soilctl.InputError, "inf"),
        ([1e9, 0, 0, 0, 0], soilctl.InputError, "must be between"),
        ([0, 0, 0, 0], soilctl.InputError, "length 5"),
        (np.zeros((1, 5)), soilctl.InputError, "shape"),
        ([], soilctl.InputError, "empty"),
        (["a"] * 5, soilctl.InputTypeError, "real numbers"),
        (None, soilctl.InputTypeError, "real numbers"),
    ],
)
def test_a_refused_torque_leaves_the_plant_as_it_was(torques, error, words):
    tried, untouched = soilctl.Plant("ticino_rained"), soilctl.Plant("ticino_rained")
    for plant in (tried, untouched):
        plant.step(np.ones(5))
    with pytest.raises(error, match=words):
        tried.step(torques)
    assert tried.ticks == untouched.ticks == 1
    for _ in range(20):
        np.testing.assert_array_equal(tried.step(np.ones(5)).wrench, untouched.step(np.ones(5)).wrench)
    np.testing.assert_array_equal(tried.truth["joint_angles_rad"], untouched.truth["joint_angles_rad"])


def test_a_nan_from_a_controller_is_refused_in_its_tick():
    plant = soilctl.Plant()

    def controller(sensed):
        return np.full(5, np.nan if sensed.tick == 7 else 0.0)

    with pytest.raises(soilctl.InputError, match=r"after tick 7: motor_torques_nm\[0\] is nan"):
        plant.run(controller, ticks=100)
    assert plant.ticks == 7
    with pytest.raises(soilctl.InputTypeError, match="after tick 7: motor_torques_nm holds"):
        plant.run(lambda sensed: ["a"] * 5, ticks=1)


def test_two_runs_are_as_one():
    whole, parts = soilctl.Plant("ticino_rained"), soilctl.Plant("ticino_rained")
    once, twice = Holder(), Holder()
    last = whole.run(once, ticks=100)
    for _ in range(2):
        sensed = parts.run(twice, ticks=50)
    assert once.steps == twice.steps == 99 and sensed.tick == last.tick == 100
    np.testing.assert_array_equal(sensed.wrench, last.wrench)
    np.testing.assert_array_equal(sensed.motor_counts, last.motor_counts)
    np.testing.assert_array_equal(parts.truth["joint_angles_rad"], whole.truth["joint_angles_rad"])
    assert parts.energy_j == whole.energy_j


class Slow:
    """Torques that let other threads run while they are read."""

    def __array__(self, dtype=None, copy=None):
        time.sleep(1e-3)
        return np.zeros(5)


def test_threads_may_share_a_plant():
    plant = soilctl.Plant()

    def drive(_):
        for _ in range(20):
            plant.step(Slow())
            assert plant.ticks > 0 and np.isfinite(plant.truth["tip_m"]).all()
        plant.run(lambda sensed: Slow(), ticks=20)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(drive, range(4)))
    assert plant.ticks == 4 * 40


def test_a_controller_may_look_at_the_plant_and_its_errors_come_through():
    plant = soilctl.Plant()
    seen = []

    def controller(sensed):
        seen.append(plant.truth["tip_m"])
        if sensed.tick == 3:
            raise RuntimeError("enough")
        return np.zeros(5)

    with pytest.raises(RuntimeError, match="enough"):
        plant.run(controller, ticks=10)
    assert len(seen) == 3


def test_bad_plants_are_refused():
    with pytest.raises(soilctl.InputError, match="no soil"):
        soilctl.Plant("cheese")
    with pytest.raises(soilctl.NoAnswerError, match="deg"):
        soilctl.Plant(joint_angles_deg=[0, 300, 0, 0, 0])
    with pytest.raises(soilctl.InputTypeError, match="step"):
        soilctl.Plant().run(object(), ticks=3)
    with pytest.raises(soilctl.InputError, match="ticks"):
        soilctl.Plant().run(Holder(), ticks=0)
    with pytest.raises(soilctl.InputError, match="no soil to prepare"):
        soilctl.Plant().prepare_soil()


def test_the_limit_force_is_that_of_the_model():
    alpha, depth = 80.0, 0.02
    pose = soilctl.Arm.digging_pose(radius_m=0.43, height_m=-0.3302 - depth, tool_angle_deg=alpha)
    start = np.degrees(ARM.inverse(pose))
    plant = soilctl.Plant("ticino_rained", joint_angles_deg=start, seed=2)
    plant.step(np.zeros(5), amplifiers_enabled=False)
    truth, soil = plant.truth, plant.soil
    assert truth["depth_m"] == pytest.approx(depth, rel=0.02)
    there = soilctl.predict(
        "chen",
        tool_angle_deg=np.degrees(truth["tool_angle_rad"]),
        depth_m=truth["depth_m"],
        width_m=0.127,
        **soil,
    )
    assert truth["limit_force_n"] == pytest.approx(there.force_n, rel=0.01)
    assert soilctl.Plant().soil is None


# Torques are what the arm takes; who learns may rescale them.
@pytest.mark.filterwarnings("ignore:.*symmetric and normalized space")
def test_the_environment_follows_gymnasiums_rules():
    gymnasium = pytest.importorskip("gymnasium")
    checker = pytest.importorskip("gymnasium.utils.env_checker")
    import soilctl.gym  # noqa: F401

    env = gymnasium.make("soilctl/Plant-v0", disable_env_checker=True).unwrapped
    checker.check_env(env, skip_render_check=True)
    first, _ = env.reset(seed=5)
    again, _ = env.reset(seed=5)
    for name, values in first.items():
        np.testing.assert_array_equal(values, again[name])
    with pytest.raises(soilctl.InputError):
        env.step(np.full(5, np.nan))


def test_the_environment_is_the_plant():
    gymnasium = pytest.importorskip("gymnasium")
    from soilctl.gym import PlantEnv

    torques = np.array([0.3, 0.2, -0.1, 0.0, 0.05])
    env = PlantEnv("ticino_loose", ticks_per_step=5, reward=lambda truth: -truth["depth_m"])
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(torques)
    env.reset(seed=9)
    seed = int(np.random.Generator(np.random.PCG64(np.random.SeedSequence(9))).integers(2**32))
    plant = soilctl.Plant("ticino_loose", seed=seed)
    plant.step(np.zeros(5), amplifiers_enabled=False)
    for _ in range(10):
        observation, reward, terminated, truncated, info = env.step(torques)
        sensed = [plant.step(torques) for _ in range(5)][-1]
        np.testing.assert_array_equal(observation["wrench"], sensed.wrench)
        np.testing.assert_array_equal(observation["motor_counts"], sensed.motor_counts)
        assert reward == -plant.truth["depth_m"] and not terminated and not truncated
    wrong = [
        {"max_torque_nm": 0.0},
        {"max_torque_nm": np.nan},
        {"ticks_per_step": 0},
        {"ticks_per_step": 1.5},
        {"soil": "cheese"},
        {"seed": 1},
        {"model": "none"},
        {"surface_z_m": np.nan},
        {"render_mode": "human"},
        {"reward": 3},
    ]
    for bad in wrong:
        with pytest.raises(soilctl.InputError):
            PlantEnv(**bad)
    with pytest.raises(TypeError, match="colour"):
        PlantEnv(colour="red")
    made = gymnasium.make("soilctl/Plant-v0", render_mode=None)
    made.reset(seed=1)
    assert made.render_mode is None
