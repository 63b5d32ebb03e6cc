"""From the force at which a plate fails soil to the soil's friction angle and density.

Angles are in degrees, everything else in SI units; both are in the names of arguments. Arrays come and go as numpy
arrays. Errors are those of :mod:`soilctl.errors`.
"""

from __future__ import annotations

from importlib.metadata import version as _version

from ._native import (
    MODELS,
    Arm,
    Prediction,
    failure_surface,
    predict,
    valid_range,
)
from ._store import Store
from ._sweep import Failure, SweepResult, sweep
from .errors import (
    FileError,
    InputError,
    InputTypeError,
    NoAnswerError,
    SoilctlError,
    SweepError,
)

__version__ = _version("soilctl")

__all__ = [
    "MODELS",
    "Arm",
    "Failure",
    "FileError",
    "InputError",
    "InputTypeError",
    "NoAnswerError",
    "Prediction",
    "SoilctlError",
    "Store",
    "SweepError",
    "SweepResult",
    "__version__",
    "failure_surface",
    "predict",
    "sweep",
    "valid_range",
]
