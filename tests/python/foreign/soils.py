"""What the soil does to the plate in these bags, by forms that the reader does not fit."""

import numpy as np


def drastic(u, force, at, residual, width):
    """Rises as a power of the displacement, breaks, and falls to a residual over `width`."""
    rise = force * np.clip(u / at, 0, 1) ** 0.6
    fall = force * (residual + (1 - residual) * np.exp(-np.clip(u - at, 0, None) / width))
    return np.where(u < at, rise, fall)


def gradual(u, force, length, law):
    """Tends to the force by one of several laws."""
    x = np.clip(u, 0, None) / length
    return force * {
        "exponential": 1 - np.exp(-x),
        "tanh": np.tanh(x),
        "power": 1 - (1 + x / 4) ** -4,
        "sine": np.where(x < 2, np.sin(np.clip(x, 0, 2) * np.pi / 4), 1.0),
    }[law]
