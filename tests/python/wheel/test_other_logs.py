"""Recordings of other programs: what is in them, and their topics as tables."""

from pathlib import Path

import numpy as np
import pytest

import soilctl

DATA = Path(__file__).parents[3] / "crates" / "bag" / "tests" / "data"
START_S = 1_700_000_000


@pytest.mark.parametrize("name", ["none.mcap", "lz4.mcap", "bz2.bag", "sqlite", "split"])
def test_every_container(name):
    """What `make.py` there wrote: 16 messages every 10 ms, stamped 500 ns late."""
    info = soilctl.log_info(DATA / name)
    assert info["clock_origin_s"] == START_S and info["problems"] == info["damage"] == []
    wrench = info["topics"]["/wrench"]
    assert (wrench["messages"], wrench["kind"], wrench["gaps"], wrench["longest_gaps"]) == (16, "wrench", 0, [])
    assert info["start_ns"] == pytest.approx(START_S * 10**9, abs=1000) and isinstance(info["start_ns"], int)
    table = soilctl.log_table(DATA / name, "/wrench")
    assert table["time_s"] == pytest.approx(np.arange(16) * 0.01 + 5e-7, abs=1e-9)
    assert (table["wrench_force_x"] == np.arange(16) / 8).all()
    joints = soilctl.log_table(DATA / name, "/joint_states")
    assert (joints["base_position"] == np.arange(16) / 8).all()


def test_what_is_missing():
    with pytest.raises(soilctl.InputError, match="/joint_states"):
        soilctl.log_table(DATA / "none.mcap", "/none")
    with pytest.raises(soilctl.FileError, match="not a recording"):
        soilctl.log_info(DATA / "make.py")
    with pytest.raises(FileNotFoundError, match=r"none\.bag"):
        soilctl.log_info(DATA / "nothing" / "none.bag")
