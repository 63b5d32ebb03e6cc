"""Results on disk, addressed by what they are the result of."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import uuid
from pathlib import Path
from typing import Any

from ._canonical import decode, encode
from .errors import FileError

_FORMAT = "soilctl.sweep/1"


class Store:
    """A folder of results. Several programs may use it at a time, also on a shared file system.

    A result is in ``results/ab/abcd....json``, where ``abcd...`` is the SHA-256 of function, version and cell. It
    appears in one step (written beside, then renamed) and never changes. Errors are in ``failed/``, until the cell
    succeeds.

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
        asked = {"format": _FORMAT, "function": name, "version": version, "cell": cell}
        return hashlib.sha256(encode(asked, "cell")).hexdigest()

    def path(self, key: str) -> Path:
        """Where the result of a key is, once it is there."""
        return self.folder / "results" / key[:2] / f"{key}.json"

    def failure_path(self, key: str) -> Path:
        """Where the error of a key is, if it failed last time."""
        return self.folder / "failed" / f"{key}.json"

    def has(self, key: str) -> bool:
        """Whether there is a sound result; one that is damaged counts as missing, and is made again."""
        try:
            self.read(key)
        except FileError:
            return False
        return True

    def read(self, key: str) -> Any:
        """The result of a key.

        Raises:
            FileError: If it is not there, or not what was written.
        """
        path = self.path(key)
        try:
            document = json.loads(path.read_bytes())
            result = document["result"].encode("utf-8")
            sound = hashlib.sha256(result).hexdigest() == document["sha256"]
        except OSError as problem:
            raise FileError(f"{path}: {problem.strerror}", path, problem.errno) from problem
        except (ValueError, KeyError, AttributeError, TypeError) as problem:
            raise FileError(f"{path} is no result of a sweep; delete it, and it is made again", path) from problem
        if not sound:
            raise FileError(f"{path} is damaged; delete it, and it is made again", path)
        return decode(result)

    def publish(self, key: str, name: str, version: str, cell: Any, result: bytes) -> None:
        """Stores the canonical bytes of a result."""
        document = {
            "format": _FORMAT,
            "function": name,
            "version": version,
            "cell": cell,
            "sha256": hashlib.sha256(result).hexdigest(),
            "result": result.decode("utf-8"),
        }
        _write(self.path(key), encode(document, "result") + b"\n")
        self.failure_path(key).unlink(missing_ok=True)

    def note_failure(self, key: str, name: str, version: str, cell: Any, error: str) -> None:
        """Keeps the error of a cell, for people; it is no reason not to try again."""
        document = {"format": _FORMAT, "function": name, "version": version, "cell": cell, "error": error}
        _write(self.failure_path(key), encode(document, "failure") + b"\n")


def _write(path: Path, data: bytes) -> None:
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex}")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with open(partial, "xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError as problem:
        with contextlib.suppress(OSError):
            partial.unlink()
        told = f"{path}: {problem.strerror}; check the folder and the free space"
        raise FileError(told, path, problem.errno) from problem
