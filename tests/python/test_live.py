"""Live sessions from outside: `run`, `console`, the protocol in plain Python, a driver in Python, signals, kill -9."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PLAN = ROOT / "data" / "plans" / "table_6_2.toml"
DRIVER = ROOT / "examples" / "driver" / "driver.py"
# Nothing takes so long, also on a busy machine.
LONG_S = 120


class Operator:
    """A client of the line protocol."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.socket.settimeout(LONG_S)
        self.socket.connect(str(path))
        self.file = self.socket.makefile("r", encoding="utf-8")
        self.id = 0
        self.hello = self.next()

    def __del__(self):
        for end in [self.file, self.socket]:
            end.close()

    def next(self):
        line = self.file.readline()
        assert line, "the session is gone"
        return json.loads(line)

    def send(self, **command):
        self.id += 1
        message = {"type": "command", "id": self.id, "command": command}
        self.socket.sendall((json.dumps(message) + "\n").encode())
        return self.id

    def ask(self, **command):
        wanted = self.send(**command)
        return self.wait(lambda message: message.get("id") == wanted)

    def wait(self, found):
        while True:
            message = self.next()
            if found(message):
                return message

    def wait_event(self, kind):
        return self.wait(lambda message: message["type"] == "event" and message["kind"].startswith(kind))

    def wait_state(self, found=lambda state: True):
        return self.wait(lambda message: message["type"] == "state" and found(message))


class Session:
    """A running `soilctl run`."""

    def __init__(self, binary, folder, *options, name="run"):
        self.socket = folder / f"{name}.live"
        self.log = folder / f"{name}.mcap"
        words = [str(binary), "run", str(PLAN), "--socket", str(self.socket), "--log", str(self.log)]
        self.process = subprocess.Popen(
            [*words, *map(str, options), "--format", "json"],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
        )
        wait_for(self.socket, self.process)

    def end(self, code=0):
        out, err = self.process.communicate(timeout=LONG_S)
        assert self.process.returncode == code, f"exit code {self.process.returncode}: {out} {err}"
        return json.loads(out)


def wait_for(path, process):
    deadline = time.monotonic() + LONG_S
    while time.monotonic() < deadline:
        if process.poll() is not None:
            pytest.fail(f"it ended early: {process.communicate()}")
        try:
            with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
                if path.suffix == ".driver":
                    if path.exists():
                        return
                else:
                    probe.connect(str(path))
                    return
        except OSError:
            pass
        time.sleep(0.02)
    pytest.fail(f"{path} does not appear")


@pytest.fixture
def start(soilctl, tmp_path):
    """Function that starts a session; whatever is left is ended."""
    sessions = []

    def begin(*options, name="run"):
        session = Session(soilctl.binary, tmp_path, *options, name=name)
        sessions.append(session)
        return session

    yield begin
    for session in sessions:
        if session.process.poll() is None:
            session.process.kill()
            session.process.communicate()


def test_a_script_drives_a_session_and_gives_the_same_log_twice(soilctl, start, validate, tmp_path):
    script = tmp_path / "script.txt"
    script.write_text(
        "enable  # hold\nset speed_scale 0.8\nmove_joints 5,30,100,0,30\n"
        "wait trajectory_ended/joint_move/completed\nadvance 0.2\nstate\nend\n"
    )
    logs = []
    for name in ["one", "two"]:
        session = start(name=name)
        done = soilctl("console", "--connect", session.socket, "--script", script, code=0)
        assert "trajectory_ended/joint_move/completed" in done.stdout
        answer = session.end()
        validate(answer)
        assert answer["fault"] is None and answer["timing"] is None and answer["log_dropped_steps"] == 0
        logs.append(session.log.read_bytes())
        doctor = soilctl.json("log", "doctor", session.log)
        assert doctor["problems"] == []
        assert soilctl.json("replay", session.log)["identical"]
    assert logs[0] == logs[1]


def test_a_stroke_of_the_plan_by_pipe(soilctl, start):
    session = start()
    lines = (
        "enable\nset speed_scale 1\nmove_tip 0.4318 0 -0.28 90\nwait trajectory_ended/cartesian_move/completed\n"
        "stroke radius_m=0.4318 base_deg=0 tool_angle_deg=90 depth_m=0.0254 delta_deg=23\n"
        "start insert_stroke_pullout\nwait inserted\nstate\nabort\nend\n"
    )
    done = soilctl("console", "--connect", session.socket, "--format", "json", stdin=lines, code=0)
    messages = [json.loads(line) for line in done.stdout.splitlines()]
    assert messages[0]["type"] == "hello" and messages[0]["strokes"] == 48
    kinds = [message["kind"] for message in messages if message["type"] == "event"]
    assert "surface_found" in kinds and "inserted" in kinds
    [state] = [message for message in messages if message["type"] == "state"]
    assert state["plate"]["z_m"] < -0.33 and state["mode"] == "ready"
    session.end()


def test_a_refused_command_ends_a_script(soilctl, start):
    session = start()
    done = soilctl("console", "--connect", session.socket, stdin="start homing\nenable\n", code=1)
    assert "enable" in done.stderr
    done = soilctl("console", "--connect", session.socket, stdin="fly\n", code=1)
    assert "there is no command `fly`" in done.stderr
    done = soilctl("console", "--connect", session.socket, stdin="enable\nwait homed 0.2\n", code=1)
    assert "no homed within" in done.stderr
    soilctl("console", "--connect", session.socket, stdin="help\nend\n", code=0)
    session.end()


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_leads_to_the_safe_state_and_a_whole_log(soilctl, start, which):
    session = start("--real-time")
    operator = Operator(session.socket)
    assert operator.hello["protocol"] == 1 and operator.hello["real_time"]
    assert operator.ask(name="enable")["type"] == "ack"
    operator.ask(name="velocity", rates_deg_s=[3, 0, 0, 0, 0])
    operator.wait_state(lambda state: state["trajectory"] == "joint_velocity")
    session.process.send_signal(which)
    assert operator.wait(lambda message: message["type"] == "end")["reason"] == "asked to end"
    answer = session.end()
    timing = answer["timing"]
    assert sum(timing["lateness"]["counts"]) == answer["ticks"]
    out = session.log.with_suffix(".csv")
    soilctl("log", "export", session.log, "--out", out, code=0)
    rows = out.read_text().splitlines()
    header, last = rows[0].split(","), rows[-1].split(",")
    step = dict(zip(header, last))
    assert (step["mode"], step["amplifiers_enabled"], step["motor_torques_nm_0"]) == ("off", "false", "0")
    assert soilctl.json("log", "doctor", session.log)["problems"] == []
    assert not session.socket.exists()


def test_states_come_about_thirty_times_a_second(start):
    session = start("--real-time", "--seconds", 4)
    operator = Operator(session.socket)
    first = operator.wait_state()
    last = operator.wait_state(lambda state: state["time_s"] >= first["time_s"] + 2)
    assert last["dropped"] == {"log_steps": 0, "states": 0, "events": 0, "messages": 0}
    count = 1
    while operator.next()["type"] != "end":
        count += 1
    assert count < 40 * 4, "not more than some thirty a second"
    session.end()


def test_kill_9_in_real_time_loses_at_most_a_second(soilctl, start, tmp_path):
    session = start("--real-time")
    operator = Operator(session.socket)
    operator.ask(name="enable")
    last = operator.wait_state(lambda state: state["tick"] >= 1300)
    session.process.kill()
    session.process.communicate()
    fixed = tmp_path / "fixed.mcap"
    soilctl.json("log", "recover", session.log, "--out", fixed, code=3)
    content = soilctl.json("log", "info", fixed, code=0)["content"]
    assert content["missing_steps"] == 0
    assert content["steps"] >= last["tick"] - 500
    assert soilctl.json("replay", fixed)["identical"]
    # The socket of a dead session is replaced.
    session.log.rename(tmp_path / "killed.mcap")
    again = start()
    assert Operator(again.socket).ask(name="end")["type"] == "ack"
    again.end()


def test_a_driver_in_python(soilctl, start, tmp_path):
    path = tmp_path / "arm.driver"
    driver = subprocess.Popen([sys.executable, str(DRIVER), str(path)], stderr=subprocess.PIPE, encoding="utf-8")
    try:
        wait_for(path, driver)
        session = start("--driver", path, "--driver-timeout", 10000, "--seconds", 600)
        operator = Operator(session.socket)
        assert operator.hello["simulated"] is False
        assert operator.ask(name="enable")["type"] == "ack"
        assert operator.ask(name="velocity", rates_deg_s=[4, 0, 0, 0, 0], seconds=1.0)["type"] == "ack"
        operator.wait_event("trajectory_ended/joint_velocity/completed")
        state = operator.wait_state()
        assert state["mode"] == "ready" and state["fault"] is None, state
        assert operator.ask(name="end")["type"] == "ack"
        answer = session.end()
        assert answer["fault"] is None and answer["problems"] == []
        assert driver.wait(timeout=LONG_S) == 0
        assert soilctl.json("replay", session.log)["identical"]
    finally:
        if driver.poll() is None:
            driver.kill()
        driver.communicate()


def test_a_driver_that_dies_ends_the_session_with_its_reason(start, tmp_path):
    path = tmp_path / "arm.driver"
    driver = subprocess.Popen([sys.executable, str(DRIVER), str(path)], stderr=subprocess.PIPE, encoding="utf-8")
    wait_for(path, driver)
    session = start("--driver", path, "--driver-timeout", 5000, "--seconds", 600)
    operator = Operator(session.socket)
    operator.ask(name="enable")
    operator.wait_state(lambda state: state["mode"] == "ready")
    driver.kill()
    driver.communicate()
    assert operator.wait_event("fault/")["kind"] == "fault/motor_encoder_stale"
    answer = session.end(code=3)
    assert "closed the connection" in answer["problems"][0]
    assert answer["ended"] == "the driver went away"


def test_a_played_log_tells_what_the_session_told(soilctl, start):
    session = start()
    operator = Operator(session.socket)
    operator.ask(name="enable")
    operator.ask(name="move_joints", joints_deg=[5, 30, 100, 0, 30])
    operator.wait_event("trajectory_ended/joint_move/completed")
    live = operator.wait_state(lambda state: state["paused"])
    operator.ask(name="end")
    session.end()
    played = soilctl("console", "--play", session.log, "--format", "json", code=0)
    messages = [json.loads(line) for line in played.stdout.splitlines()]
    [same] = [message for message in messages if message["type"] == "state" and message["tick"] == live["tick"]] or [None]
    kinds = [message["kind"] for message in messages if message["type"] == "event"]
    assert kinds[0] == "enabled" and kinds[-1] == "disabled"
    if same is not None:
        for key in ["mode", "homed", "joints_deg", "plate", "force_rtz_n", "trajectory"]:
            assert same[key] == live[key], key
    text = soilctl("console", "--play", session.log, stdin="seek 0.2\nstep 3\nplay 1\nstate\nquit\n", code=0).stdout
    assert "shoulder" in text and "force" in text
    soilctl("console", "--play", session.log, stdin="fly\n", code=1)
    soilctl.refuses("console", "--play", session.log.with_name("none.mcap"), mentions=["none.mcap"])
    cut = session.log.with_name("cut.mcap")
    cut.write_bytes(session.log.read_bytes()[: session.log.stat().st_size // 2])
    assert "damaged: " in soilctl("console", "--play", cut, code=3).stderr


def test_wrong_use_is_refused(soilctl, tmp_path):
    log = tmp_path / "there.mcap"
    log.write_bytes(b"precious")
    live = tmp_path / "live"
    soilctl.refuses("run", PLAN, "--socket", live, "--log", log, mentions=["exists"])
    assert log.read_bytes() == b"precious"
    other = tmp_path / "run.mcap"
    soilctl.refuses("run", PLAN, "--socket", log, "--log", other, mentions=["no socket"])
    assert not other.exists()
    soilctl.refuses("run", PLAN, "--socket", live, "--log", other, "--seconds", -1, mentions=["--seconds"])
    soilctl.refuses("run", PLAN, "--socket", live, "--log", other, "--driver", tmp_path / "none", mentions=["none"])
    soilctl.refuses("run", tmp_path / "none.toml", "--socket", live, mentions=["none.toml"])
    soilctl.refuses("console", mentions=["--connect"])
    soilctl.refuses("console", "--connect", live, mentions=["live"])


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_a_full_disk_is_told(start, soilctl, tmp_path):
    done = soilctl("run", PLAN, "--socket", tmp_path / "live", "--log", "/dev/full", "--seconds", 2, "--format", "json")
    assert done.returncode in (2, 3), done
    assert "no space left" in (done.stdout + done.stderr).lower()
