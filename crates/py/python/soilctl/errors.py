"""What soilctl raises. Messages are those of the command line.

All are :class:`SoilctlError`; each is also the built-in exception that one would expect, so
``except ValueError`` works too.
"""

from __future__ import annotations

import errno as codes
import os
import re
from typing import Any

__all__ = [
    "FileError",
    "InputError",
    "InputTypeError",
    "Interrupted",
    "MissingFileError",
    "NoAnswerError",
    "ProofError",
    "SimulationError",
    "SoilctlError",
    "SweepError",
]

#: How a message of the compiled part tells what the system said.
_CODE = re.compile(r"\(os error (\d+)\)")


class SoilctlError(Exception):
    """Any error of soilctl."""


class InputError(SoilctlError, ValueError):
    """A value that makes no sense: out of range, not finite, of the wrong shape, empty, or an unknown name."""


class InputTypeError(InputError, TypeError):
    """An argument of a type that cannot be used, such as an array of text or of complex numbers."""


class FileError(SoilctlError, OSError):
    """A file that cannot be read or written. If it is not there, a :class:`MissingFileError`.

    Attributes:
        errno: The system's number of what went wrong; None if it was not the system that refused.
        strerror: The same in words; None likewise.
        filename: The file; None if the message alone says which one it is.
    """

    def __new__(cls, message: str = "", filename: str | os.PathLike[str] | None = None, errno: int | None = None) -> FileError:
        found = _CODE.search(str(message))
        code = int(found[1]) if errno is None and found else errno
        # As OSError itself does.
        kind = MissingFileError if cls is FileError and code == codes.ENOENT else cls
        error = super().__new__(kind, message)
        error.errno = code
        error.strerror = None if code is None else os.strerror(code)
        error.filename = None if filename is None else os.fspath(filename)
        return error

    def __init__(self, message: str = "", filename: str | os.PathLike[str] | None = None, errno: int | None = None) -> None:
        super().__init__(message)

    def __str__(self) -> str:
        """The message, which has all of it."""
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.args[0], self.filename, self.errno)


class MissingFileError(FileError, FileNotFoundError):
    """A file that is not there."""


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
