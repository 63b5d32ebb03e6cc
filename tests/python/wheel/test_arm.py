"""The arm as a library."""

import numpy as np
import pytest

import soilctl

ARM = soilctl.Arm()
POSTURES = np.radians(
    [[0.0, 30.0, 100.0, 0.0, 30.0], [10.0, 40.0, 80.0, 5.0, 45.0], [-15.0, 20.0, 90.0, -8.0, 60.0]]
)


def test_inverse_undoes_forward():
    poses = ARM.forward(POSTURES)
    assert poses.shape == (3, 5)
    np.testing.assert_allclose(ARM.forward(ARM.inverse(poses)), poses, atol=1e-12)
    np.testing.assert_array_equal(ARM.forward(POSTURES[1]), poses[1])
    assert ARM.forward(np.tile(POSTURES, (4, 2, 1, 1))).shape == (4, 2, 3, 5)


def test_the_jacobian_is_the_derivative():
    step = 1e-6
    jacobian = ARM.jacobian(POSTURES)
    assert jacobian.shape == (3, 5, 5)
    for joint in range(5):
        shift = np.zeros(5)
        shift[joint] = step
        slope = (ARM.forward(POSTURES + shift) - ARM.forward(POSTURES - shift)) / (2 * step)
        np.testing.assert_allclose(jacobian[..., joint], slope, atol=1e-8)


def test_forces_and_velocities_do_the_same_work():
    rates, force = np.full((3, 5), 0.2), np.tile([10.0, -4.0, 3.0, 0.5, 0.1], (3, 1))
    power = (ARM.velocity(POSTURES, rates) * force).sum(axis=1)
    np.testing.assert_allclose((ARM.joint_torques(POSTURES, force) * rates).sum(axis=1), power)


def test_one_posture_or_one_rate_goes_with_many():
    for method in (ARM.velocity, ARM.joint_torques):
        one = np.array([0.2, -0.1, 0.3, 0.1, 0.05])
        np.testing.assert_array_equal(method(POSTURES, one), method(POSTURES, np.tile(one, (3, 1))))
        np.testing.assert_array_equal(method(POSTURES[0], np.tile(one, (4, 1))), np.tile(method(POSTURES[0], one), (4, 1)))
        assert method(POSTURES[:, None], np.ones((2, 5))).shape == (3, 2, 5)
    assert ARM.jacobian(np.full([1] * 30 + [5], 0.5)).shape == (*[1] * 30, 5, 5)


def test_springs_pull_back():
    springs = [1000.0, 2000.0, 3000.0, 0.0, 0.0]
    posture, shift = np.radians([0.0, 30.0, 100.0, 0.0, 30.0]), [0.01, 0.0, 0.002, 0.0, 0.0]
    torques = ARM.stiffness_torques(posture, shift, stiffness=springs)
    np.testing.assert_allclose(torques, ARM.joint_torques(posture, [10.0, 0.0, 6.0, 0.0, 0.0]), atol=1e-12)
    np.testing.assert_array_equal(ARM.stiffness_torques(posture, shift, stiffness=np.diag(springs)), torques)
    assert ARM.stiffness_torques(posture, shift, stiffness=springs, wrist_locked=True)[4] == 0.0


def test_motors_and_joints_are_two_views():
    np.testing.assert_allclose(ARM.joint_angles(ARM.motor_angles(POSTURES)), POSTURES, atol=1e-12)
    assert ARM.gravity_torques(POSTURES).shape == (3, 5)


def test_a_digging_pose_is_reached():
    pose = ARM.digging_pose(radius_m=0.5, height_m=-0.3, tool_angle_deg=80.0)
    joints = ARM.inverse(pose)
    np.testing.assert_allclose(ARM.forward(joints), pose, atol=1e-12)
    ARM.check_limits(joints)
    assert "<robot" in ARM.urdf()
    low, high = ARM.limits_rad
    assert (low < joints).all() and (joints < high).all()


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: ARM.forward(np.zeros(4)), soilctl.InputError, "last axis must have length 5"),
        (lambda: ARM.forward(0.3), soilctl.InputError, "last axis"),
        (lambda: ARM.forward(np.zeros((0, 5))), soilctl.InputError, "empty"),
        (lambda: ARM.forward([0, 0, np.nan, 0, 0]), soilctl.InputError, r"joint_angles_rad\[2\] is nan"),
        (lambda: ARM.forward([0, 0, 1e9, 0, 0]), soilctl.InputError, "1000 rad"),
        (lambda: ARM.forward(["a"] * 5), soilctl.InputTypeError, "real numbers"),
        (lambda: ARM.inverse([[0.5, 0, 0, 3, 0], [50, 0, 0, 3, 0]]), soilctl.NoAnswerError, r"element \[1\]"),
        (lambda: ARM.velocity(POSTURES, POSTURES[:2]), soilctl.InputError, "shape"),
        (lambda: ARM.velocity(POSTURES, np.ones(4)), soilctl.InputError, "last axis must have length 5"),
        (lambda: ARM.forward(np.zeros([1] * 40 + [5])), soilctl.InputError, "41 axes"),
        (lambda: ARM.check_limits(np.full(5, 3.1)), soilctl.NoAnswerError, "limit"),
        (lambda: soilctl.Arm("no-such-file.toml"), soilctl.FileError, "no-such-file"),
        (lambda: soilctl.Arm.from_toml("x = 1"), soilctl.InputError, "the text"),
    ],
)
def test_bad_input_is_refused(call, error, words):
    with pytest.raises(error, match=words):
        call()


def test_skewing_is_that_of_springs_in_the_joints():
    """Springs of the settings' gains in shoulder and elbow, by a Jacobian from differences; figure 5-6."""
    answer = soilctl.answer("arm", "skewing", "--radius", 0.3)
    assert answer["exit_code"] == 0 and answer["worst_stiffness_deg"] <= 1e-6 and answer["worst_pid_deg"] > 30.0
    joints = ARM.inverse(ARM.digging_pose(radius_m=0.3, height_m=answer["height_m"], tool_angle_deg=answer["alpha_deg"]))
    steps = 1e-6 * np.eye(5)[1:3]
    jacobian = np.stack([ARM.forward(joints + step) - ARM.forward(joints - step) for step in steps], axis=1)[[0, 2]] / 2e-6
    gains = np.diag([600.0 + 20.0, 500.0 + 20.0])
    for row in answer["rows"]:
        error = np.radians(row["error_deg"])
        torques = gains @ np.linalg.solve(jacobian, [np.cos(error), np.sin(error)])
        force = np.linalg.solve(jacobian.T, torques)
        assert np.degrees(np.arctan2(force[1], force[0]) - error) == pytest.approx(row["pid_deg"], abs=1e-4)


def test_the_urdf_is_also_a_verb():
    assert soilctl.answer("arm", "urdf")["urdf"] == ARM.urdf()
    with pytest.raises(soilctl.InputError, match="reach"):
        soilctl.answer("arm", "skewing", "--radius", 3)
