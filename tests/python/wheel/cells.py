"""Functions for sweeps; a module of their own, so that workers can import them."""

import os
import signal
import time

import numpy as np

import soilctl


def square(number, offset=0.0):
    return {"square": number**2 + offset, "values": np.arange(3.0) * number}


def poisoned(number):
    """Refuses every thirtieth number; slow enough that a worker can be killed midway."""
    time.sleep(0.02)
    if number % 30 == 7:
        raise ValueError(f"poison {number}")
    return {"square": number**2, "curve": np.linspace(0.0, float(number), 5)}


def healed(number):
    return {"square": number**2, "curve": np.linspace(0.0, float(number), 5)}


def deadly(number):
    """Kills its own process for one number, as the kernel does when memory runs out."""
    if number == 5:
        os.kill(os.getpid(), signal.SIGKILL)
    return number


def not_finite(number):
    return float("nan")


def fails_without_words(number):
    raise RuntimeError


def told_again(number):
    return {"number": number, "half": None if number == 3 else number / 2}


def contradicts(number):
    return {"number": number + 1}


def of_other_shape(number):
    return {"values": np.arange(number)}


def bracket(alpha):
    return soilctl.bound(tool_angle_deg=alpha, friction_angle_deg=30.0, interface_friction_deg=10.0, max_gap=0.3)


class Tripler:
    def run(self, number):
        return 3 * number
