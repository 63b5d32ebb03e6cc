"""Arms of other makers: chains of joints, their URDF, forward and inverse kinematics in numpy alone.

Nothing here is shared with the reader that is tested: rotations are built from Rodrigues' formula, poses are 4 x 4 matrices, and
the inverse is damped least squares on a numerical Jacobian."""

from dataclasses import dataclass, field

import numpy as np


def rpy(roll, pitch, yaw):
    """Rotation by fixed axes x, y, z, as URDF has it."""
    return axis_angle([0, 0, 1], yaw) @ axis_angle([0, 1, 0], pitch) @ axis_angle([1, 0, 0], roll)


def axis_angle(axis, angle):
    """Rodrigues' formula; `angle` may be an array, then the result is (n, 3, 3)."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.asarray(angle, float)[..., None, None]
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * (cross @ cross)


@dataclass
class Joint:
    name: str
    kind: str
    xyz: tuple = (0, 0, 0)
    rpy: tuple = (0, 0, 0)
    axis: tuple = (0, 0, 1)


@dataclass
class Arm:
    """A chain from the root to the sensor, and the plate fixed to the sensor."""

    name: str
    joints: list
    tool_xyz: tuple
    tool_rpy: tuple
    home: np.ndarray
    reach: tuple  # middle of the working area: x, y
    span: tuple  # half of its size
    surface_z: float
    sensor: str = "wrist_ft"
    plate: str = "blade_edge"
    extra: list = field(default_factory=list)  # joints that do not matter to the plate

    @property
    def moving(self):
        return [j for j in self.joints if j.kind != "fixed"]

    def urdf(self):
        links, joints = ["world"], []
        for number, joint in enumerate(self.joints):
            child = self.sensor if joint is self.joints[-1] else f"segment_{number}"
            limit = '<limit lower="-3.1" upper="3.1" effort="100" velocity="2"/>'
            joints.append(
                f'<joint name="{joint.name}" type="{joint.kind}"><parent link="{links[-1]}"/><child link="{child}"/>'
                f'<origin xyz="{text(joint.xyz)}" rpy="{text(joint.rpy)}"/><axis xyz="{text(joint.axis)}"/>{limit}</joint>'
            )
            links.append(child)
        joints.append(
            f'<joint name="blade_mount" type="fixed"><parent link="{self.sensor}"/><child link="{self.plate}"/>'
            f'<origin xyz="{text(self.tool_xyz)}" rpy="{text(self.tool_rpy)}"/></joint>'
        )
        links.append(self.plate)
        for name in self.extra:
            joints.append(
                f'<joint name="{name}" type="revolute"><parent link="world"/><child link="{name}_link"/>'
                f'<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
            )
            links.append(f"{name}_link")
        body = "".join(f'<link name="{link}"/>' for link in links)
        return f'<?xml version="1.0"?><robot name="{self.name}">{body}{"".join(joints)}</robot>'

    def sensor_pose(self, q):
        """Rotation (n, 3, 3) and place (n, 3) of the sensor at positions (n, joints)."""
        q = np.atleast_2d(q)
        turn, place = np.tile(np.eye(3), (len(q), 1, 1)), np.zeros((len(q), 3))
        column = 0
        for joint in self.joints:
            place = place + turn @ np.asarray(joint.xyz, float)
            turn = turn @ rpy(*joint.rpy)
            if joint.kind == "fixed":
                continue
            value = q[:, column]
            column += 1
            if joint.kind == "prismatic":
                place = place + np.einsum("nij,j,n->ni", turn, np.asarray(joint.axis, float), value)
            else:
                turn = turn @ axis_angle(joint.axis, value)
        return turn, place

    def plate_pose(self, q):
        turn, place = self.sensor_pose(q)
        return turn @ rpy(*self.tool_rpy), place + turn @ np.asarray(self.tool_xyz, float)

    def solve(self, turn, place, guess):
        """Positions that bring the plate to a pose, from a guess; refuses if they do not."""
        q = np.array(guess, float)
        for _ in range(100):
            miss = self.miss(q, turn, place)
            if np.abs(miss).max() < 1e-10:
                return q
            jacobian = (self.misses(q + 1e-7 * np.eye(len(q)), turn, place) - miss).T / 1e-7
            damped = jacobian.T @ jacobian + 1e-10 * np.eye(len(q))
            move = np.linalg.solve(damped, -jacobian.T @ miss)
            if np.abs(move).max() < 1e-13:
                break
            q += move * min(1.0, 0.3 / max(1e-12, np.abs(move).max()))
        worst = np.abs(self.miss(q, turn, place)).max()
        # A gantry cannot turn: it goes where it can.
        if worst < 1e-7:
            return q
        raise ValueError(f"{self.name} cannot reach {place}: {worst:.2e}")

    def miss(self, q, turn, place):
        return self.misses(q, turn, place)[0]

    def misses(self, q, turn, place):
        """How far plates at positions (n, joints) are from a pose: place, and half the sine of the angle about each axis."""
        turns, places = self.plate_pose(q)
        rest = turn @ np.transpose(turns, (0, 2, 1))
        twist = 0.5 * np.stack([rest[:, 2, 1] - rest[:, 1, 2], rest[:, 0, 2] - rest[:, 2, 0], rest[:, 1, 0] - rest[:, 0, 1]], 1)
        return np.concatenate([places - place, -twist], 1)

    def pose_for(self, alpha_deg, heading, pitch=0.0):
        """Rotation of the plate: its z axis down along the plate at the tool angle, pulled along the heading (rad)."""
        ahead = np.array([np.cos(heading), np.sin(heading), 0.0])
        alpha = np.radians(alpha_deg) + pitch
        down = np.cos(alpha) * ahead - np.sin(alpha) * np.array([0, 0, 1.0])
        across = np.cross([0, 0, 1.0], ahead)
        return np.stack([np.cross(across, down), across, down], 1)


def text(values):
    return " ".join(f"{value:.17g}" for value in values)


def seven():
    """Seven joints in the manner of a light-weight arm: shoulder, elbow and wrist of crossing axes."""
    z, y = (0, 0, 1), (0, 1, 0)
    names = [f"lbr_a{k}" for k in range(1, 8)]
    offsets = [(0, 0, 0.15), (0, 0, 0.19), (0, 0, 0.21), (0, 0, 0.19), (0, 0, 0.21), (0, 0, 0.19), (0, 0, 0.08)]
    axes = [z, y, z, (0, -1, 0), z, y, z]
    joints = [Joint(n, "revolute", o, (0, 0, 0), a) for n, o, a in zip(names, offsets, axes)]
    joints.append(Joint("ft_mount", "fixed", (0, 0, 0.045), (0, 0, 0.6)))
    return Arm("seven", joints, (0.02, -0.015, 0.17), (0.1, -0.05, -0.4),
               np.array([0.1, 0.5, 0.0, -1.5, 0.0, 1.1, 0.0]), (0.5, 0.05), (0.06, 0.16), 0.08, extra=["finger_left"])


def gantry():
    """Three sliding axes; the plate keeps its attitude."""
    joints = [
        Joint("bridge", "prismatic", (0, 0, 1.0), (0, 0, 0), (1, 0, 0)),
        Joint("carriage", "prismatic", (0, 0, 0), (0, 0, 0), (0, 1, 0)),
        Joint("quill", "prismatic", (0, 0, 0), (0, 0, 0), (0, 0, -1)),
        Joint("cell_mount", "fixed", (0, 0, -0.1), (np.pi, 0, 0.3)),
    ]
    # The plate's z axis points down at 75 deg with the travel along x.
    arm = Arm("gantry", joints, (0.0, 0.01, 0.12), (0, 0, 0), np.array([0.5, 0.3, 0.3]), (0.5, 0.3), (0.25, 0.15), 0.2)
    return arm


def gantry_at(alpha_deg, heading):
    """A gantry whose plate is bolted on at this tool angle and heading."""
    arm = gantry()
    turn = rpy(np.pi, 0, 0.3).T @ arm.pose_for(alpha_deg, heading)
    pitch = -np.arcsin(turn[2, 0])
    arm.tool_rpy = (np.arctan2(turn[2, 1], turn[2, 2]), pitch, np.arctan2(turn[1, 0], turn[0, 0]))
    return arm


def hung():
    """Six joints on a ceiling: its base is turned over by a fixed joint."""
    z, y = (0, 0, 1), (0, 1, 0)
    joints = [
        Joint("ceiling", "fixed", (0.1, -0.2, 1.25), (np.pi, 0, 0.2)),
        Joint("axis_1", "continuous", (0, 0, 0.12), (0, 0, 0), z),
        Joint("axis_2", "revolute", (0, 0, 0.1), (0, 0, 0), y),
        Joint("axis_3", "revolute", (0.02, 0, 0.42), (0, 0, 0), y),
        Joint("axis_4", "revolute", (0, 0, 0.2), (0, 0, 0), z),
        Joint("axis_5", "revolute", (0, 0, 0.19), (0, 0, 0), y),
        Joint("axis_6", "continuous", (0, 0, 0.07), (0, 0, 0), z),
        Joint("load_cell", "fixed", (0, 0, 0.03), (0, 0, -1.1)),
    ]
    return Arm("hung", joints, (-0.01, 0.02, 0.14), (0.05, 0.08, 1.0),
               np.array([0.3, -0.7, 1.6, 0.1, -0.9, 0.2]), (0.5, -0.35), (0.07, 0.14), 0.3)


def stage():
    """One sliding joint that lowers a plate."""
    joints = [Joint("stage_z", "prismatic", (0, 0, 0.6), (0, 0, 0), (0, 0, -1)),
              Joint("cell_mount", "fixed", (0, 0, -0.05), (np.pi, 0, 0))]
    return Arm("stage", joints, (0, 0, 0.1), (0, 0, 0), np.array([0.1]), (0, 0), (0, 0), 0.3)
