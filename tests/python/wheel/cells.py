"""Functions for sweeps; a module of their own, so that workers can import them."""

import os
import signal
import time

import numpy as np


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
