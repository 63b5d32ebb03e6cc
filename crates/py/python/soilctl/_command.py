"""The command ``soilctl``: the program itself, in this process."""

from __future__ import annotations

import signal
import sys

from ._native import run_command


def main() -> int:
    """Runs the command line of this process; the exit code."""
    # The program ends on Ctrl-C, or handles it by itself; Python's handler would wait for it to be over.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return run_command(["soilctl", *sys.argv[1:]])
