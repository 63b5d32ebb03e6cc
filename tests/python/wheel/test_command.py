"""The command that the wheel installs, and its answers in this process."""

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
    assert capfd.readouterr() == ("", "")


def test_control_c_ends_the_command_with_what_there_is(tmp_path):
    words = ["bound", "--alpha", "90", "--phi", "30", "--delta", "0", "--max-gap", "1e-9", "--max-seconds", "300"]
    work = subprocess.Popen([COMMAND, *words, "--format", "json"], stdout=subprocess.PIPE, text=True)
    time.sleep(5.0)
    work.send_signal(signal.SIGINT)
    text, _ = work.communicate(timeout=120)
    # In the first seconds there may be no bounds yet on a slow machine; then it is said.
    assert work.returncode in (2, 3) and (work.returncode == 2 or json.loads(text)["ended"] == "stopped")


def test_control_c_ends_an_answer():
    timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        words = ["--alpha", 90, "--phi", 30, "--delta", 0]
        soilctl.answer("bound", *words, "--max-gap", 1e-9, "--max-seconds", 300, "--max-elements", 1000000)
    timer.join()
