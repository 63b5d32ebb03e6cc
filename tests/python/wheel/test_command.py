"""The command that the wheel installs, and its answers in this process."""

import errno
import json
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

import soilctl

WORDS = ["predict", "--alpha", "80", "--phi", "40", "--delta", "25"]
COMMAND = Path(sys.executable).with_name("soilctl")


def run(*words):
    return subprocess.run([COMMAND, *words], capture_output=True, text=True, timeout=120, check=False)


def test_the_installed_command_answers():
    done = run(*WORDS, "--format", "json")
    assert done.returncode == 0 and done.stderr == ""
    here = soilctl.answer(*WORDS)
    assert here.pop("exit_code") == 0
    assert json.loads(done.stdout) == here


def test_exit_codes_and_messages_are_the_programs():
    done = run("predict", "--alpha", "500", "--phi", "40", "--delta", "25")
    assert done.returncode == 2 and done.stdout == ""
    with pytest.raises(soilctl.InputError) as caught:
        soilctl.answer("predict", "--alpha", 500, "--phi", 40, "--delta", 25)
    assert done.stderr.strip() == f"error: {caught.value}"
    assert run("--version").stdout.split() == ["soilctl", soilctl.__version__]
    assert run().returncode == 2 and run("--help").returncode == 0


def test_wrong_usage_is_an_exception(capfd):
    with pytest.raises(soilctl.InputError, match="unexpected argument"):
        soilctl.answer("predict", "--nonsense")
    with pytest.raises(soilctl.FileError, match="no-such-file.json"):
        soilctl.answer("certify", "no-such-file.json")
    with pytest.raises(soilctl.FileError, match="no-such-file.toml"):
        soilctl.answer("solve", "no-such-file.toml")
    with pytest.raises(soilctl.InputError, match="talks to its user"):
        soilctl.answer("run", "plan.toml", "--socket", "socket")
    with pytest.raises(soilctl.InputError, match="its shell"):
        soilctl.answer("completions", "bash")
    assert capfd.readouterr() == ("", "")


def test_errors_of_files_are_those_of_the_system(tmp_path):
    gone = tmp_path / "gone.toml"
    calls = [soilctl.solve, soilctl.certify, soilctl.Arm, soilctl.log_info, lambda path: soilctl.Plant(file=path)]
    for call in calls:
        with pytest.raises(FileNotFoundError, match="gone.toml") as caught:
            call(gone)
        assert isinstance(caught.value, soilctl.FileError)
        assert (caught.value.errno, caught.value.filename) == (errno.ENOENT, str(gone))
    with pytest.raises(FileNotFoundError) as caught:
        soilctl.answer("certify", gone)
    assert caught.value.errno == errno.ENOENT
    with pytest.raises(soilctl.FileError) as caught:
        soilctl.certify(tmp_path)
    assert caught.value.errno == errno.EISDIR and not isinstance(caught.value, FileNotFoundError)


def interrupted(*words, when, cwd=None):
    """Starts the command, sends Ctrl-C once `when()` holds, and waits for the end."""
    work = subprocess.Popen([COMMAND, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=cwd)
    deadline = time.monotonic() + 120.0
    while not when() and work.poll() is None and time.monotonic() < deadline:
        time.sleep(0.02)
    assert work.poll() is None, work.communicate()
    work.send_signal(signal.SIGINT)
    out, notes = work.communicate(timeout=120)
    return work.returncode, out, notes


def after(seconds):
    end = time.monotonic() + seconds
    return lambda: time.monotonic() > end


def test_control_c_ends_the_command_with_what_there_is():
    words = ["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-gap", "1e-9", "--max-work", str(10**12)]
    code, out, _ = interrupted(*words, "--max-elements", "1000000", "--format", "json", when=after(5.0))
    # In the first seconds there may be no bounds yet on a slow machine; then it is said.
    assert code in (2, 3)
    if code == 3:
        answer = json.loads(out)
        exact = 3.0 - 1.0 / 3.0
        assert answer["ended"] == "stopped" and answer["lower"] <= exact <= answer["upper"]


PLAN = """
version = 1
design = "two batches"
soil = "ticino_loose"
model = "chen"
[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.012, delta_set_deg = 23.0 }]
[[batches]]
radius_m = 0.4318
strokes = [{ base_deg = 5.0, alpha_deg = 80.0, depth_m = 0.012, delta_set_deg = 23.0 }]
"""


def test_control_c_keeps_the_batches_that_are_finished(tmp_path):
    (tmp_path / "plan.toml").write_text(PLAN)
    words = ["simulate", "plan.toml", "--out", "logs", "--threads", "1", "--format", "json"]
    first = tmp_path / "logs" / "batch_000.mcap"
    code, out, _ = interrupted(*words, when=first.exists, cwd=tmp_path)
    told = json.loads(out)
    assert code == 3 and not told["complete"] and told["strokes_done"] == 1
    kept = first.read_bytes()
    assert not list((tmp_path / "logs").glob("*001.mcap"))
    # The same command goes on, and ends where a run that nobody stopped ends.
    done = subprocess.run([COMMAND, *words], cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0 and json.loads(done.stdout)["resumed_batches"] == 1
    assert first.read_bytes() == kept
    words[3] = "again"
    subprocess.run([COMMAND, *words], cwd=tmp_path, capture_output=True, timeout=300, check=True)
    for name in ("batch_000.mcap", "batch_001.mcap"):
        assert (tmp_path / "again" / name).read_bytes() == (tmp_path / "logs" / name).read_bytes()


def test_control_c_keeps_the_cases_of_a_table_that_are_solved(tmp_path):
    axes = ["--alpha", "80:90:10", "--phi", "25:45:5", "--delta", "10:20:5"]
    words = ["table", "build", *axes, "--max-gap", "0.03", "--out", "table.csv", "--threads", "1"]
    journal = tmp_path / "table.csv.partial.jsonl"

    def one_is_solved():
        return journal.exists() and len(journal.read_text().splitlines()) > 1

    code, _, _ = interrupted(*words, when=one_is_solved, cwd=tmp_path)
    lines = journal.read_text().splitlines()
    assert code == 3 and not (tmp_path / "table.csv").exists()
    assert len(lines) > 1 and all(json.loads(line) for line in lines)


def test_control_c_ends_what_has_nothing_to_keep(tmp_path):
    # A pipe that says nothing: the command waits for a log that never comes.
    os.mkfifo(tmp_path / "log.mcap")
    writer = os.open(tmp_path / "log.mcap", os.O_RDWR)
    try:
        for words in (["log", "info"], ["replay"]):
            code, out, _ = interrupted(*words, "log.mcap", when=after(1.0), cwd=tmp_path)
            assert code in (-signal.SIGINT, 130) and out == ""
    finally:
        os.close(writer)


def test_control_c_ends_an_answer():
    timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        words = ["--alpha", 90, "--phi", 30, "--delta", 0]
        soilctl.answer("bound", *words, "--max-gap", 1e-9, "--max-work", 10**12, "--max-elements", 1000000)
    timer.join()
