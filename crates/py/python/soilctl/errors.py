"""What soilctl raises. Messages are those of the command line.

All are :class:`SoilctlError`; each is also the built-in exception that one would expect, so
``except ValueError`` works too.
"""

from __future__ import annotations

__all__ = [
    "FileError",
    "InputError",
    "InputTypeError",
    "Interrupted",
    "NoAnswerError",
    "ProofError",
    "SimulationError",
    "SoilctlError",
    "SweepError",
]


class SoilctlError(Exception):
    """Any error of soilctl."""


class InputError(SoilctlError, ValueError):
    """A value that makes no sense: out of range, not finite, of the wrong shape, empty, or an unknown name."""


class InputTypeError(InputError, TypeError):
    """An argument of a type that cannot be used, such as an array of text or of complex numbers."""


class FileError(SoilctlError, OSError):
    """A file that cannot be read or written."""


class NoAnswerError(SoilctlError, ArithmeticError):
    """Sound input without a finite answer: a singular geometry, a pose out of reach, a budget too small."""


class ProofError(SoilctlError):
    """A saved solution that proves nothing."""


class SimulationError(SoilctlError, RuntimeError):
    """A simulation that cannot go on."""


class SweepError(SoilctlError, RuntimeError):
    """Cells of a sweep that failed; the message names them."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a computation that had something to show already.

    Attributes:
        best: The result so far, of the type that the function would have returned, or ``None``.
    """

    best: object

    def __init__(self, message: str = "", best: object = None) -> None:
        super().__init__(message)
        self.best = best
