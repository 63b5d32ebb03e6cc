"""Results on disk, addressed by what they are the result of."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from . import _native
from ._canonical import decode, encode


class Store:
    """A folder of results. Several programs may use it at a time, also on a shared file system.

    A result is in ``results/ab/abcd....json``, where ``abcd...`` is the SHA-256 of function, version and cell. It
    appears in one step (written beside, then renamed) and never changes. Errors are in ``failed/``, until the cell
    succeeds. ``soilctl table build --store`` fills such a folder, too.

    Attributes:
        folder: The folder, a ``pathlib.Path``.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = Path(folder)

    def __repr__(self) -> str:
        return f"Store({str(self.folder)!r})"

    @staticmethod
    def key(name: str, version: str, cell: Any) -> str:
        """The address of a cell's result."""
        return _native.store_key(name, version, encode(cell, "cell").decode())

    def path(self, key: str) -> Path:
        """Where the result of a key is, once it is there."""
        return _native.store_paths(self.folder, key)[0]

    def failure_path(self, key: str) -> Path:
        """Where the error of a key is, if it failed last time."""
        return _native.store_paths(self.folder, key)[1]

    def has(self, key: str) -> bool:
        """Whether there is a sound result; one that is damaged counts as missing, and is made again."""
        return _native.store_has(self.folder, key)

    def read(self, key: str) -> Any:
        """The result of a key.

        Raises:
            FileError: If it is not there, or not what was written.
        """
        return decode(_native.store_read(self.folder, key))

    def publish(self, key: str, name: str, version: str, cell: Any, result: bytes) -> None:
        """Stores the canonical bytes of a result; the key is that of name, version and cell."""
        _native.store_publish(self.folder, name, version, encode(cell, "cell").decode(), result.decode())

    def note_failure(self, key: str, name: str, version: str, cell: Any, error: str) -> None:
        """Keeps the error of a cell, for people; it is no reason not to try again."""
        _native.store_note_failure(self.folder, name, version, encode(cell, "cell").decode(), error)
