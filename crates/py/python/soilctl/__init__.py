"""From the force at which a plate fails soil to the soil's friction angle and density.

Angles are in degrees, everything else in SI units; both are in the names of arguments. Arrays come and go as numpy
arrays. Errors are those of :mod:`soilctl.errors`.
"""

from __future__ import annotations

from . import use_cases
from ._native import (
    MODELS,
    VERSION as _VERSION,
    Arm,
    Bracket,
    Certificate,
    Estimate,
    Plant,
    Prediction,
    Progress,
    Sensed,
    Solution,
    bound,
    failure_surface,
    log_info,
    log_recover,
    log_table,
    soil_names,
    solve,
    valid_range,
)
from ._cases import solve_cases
from ._store import Store
from ._strokes import diagnose, estimate, predict
from ._sweep import Failure, SweepResult, sweep
from ._verbs import answer, certify, process, replay, shear, simulate
from .errors import (
    FileError,
    InputError,
    InputTypeError,
    Interrupted,
    MissingFileError,
    NoAnswerError,
    ProofError,
    SimulationError,
    SoilctlError,
    SweepError,
)

#: Names of the soils that a :class:`Plant` can have.
SOILS = soil_names()

#: The version of the package, the same as that of the command.
__version__ = _VERSION

__all__ = [
    "MODELS",
    "SOILS",
    "Arm",
    "Bracket",
    "Certificate",
    "Estimate",
    "Failure",
    "FileError",
    "InputError",
    "InputTypeError",
    "Interrupted",
    "MissingFileError",
    "NoAnswerError",
    "Plant",
    "Prediction",
    "Progress",
    "ProofError",
    "Sensed",
    "SimulationError",
    "SoilctlError",
    "Solution",
    "Store",
    "SweepError",
    "SweepResult",
    "__version__",
    "answer",
    "bound",
    "certify",
    "diagnose",
    "estimate",
    "failure_surface",
    "log_info",
    "log_recover",
    "log_table",
    "predict",
    "process",
    "replay",
    "shear",
    "simulate",
    "solve",
    "solve_cases",
    "sweep",
    "use_cases",
    "valid_range",
]
