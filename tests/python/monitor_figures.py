"""Measures the monitor: how soon a state is on the page, what pages cost the servo, and memory over an hour of log. Not a test: it says
numbers.

    SOILCTL=target/debug/soilctl .venv/bin/python tests/python/monitor_figures.py --latency --servo --memory
"""

import argparse
import contextlib
import json
import os
import re
import socket
import subprocess
import tempfile
import threading
import time
from pathlib import Path

import numpy as np
from monitor_page import CHROMIUM_ARGS, LONG_S, ROOT, Monitor, open_page, write_plan
from playwright.sync_api import sync_playwright


def latency(binary, browser, folder, seconds):
    """From the tick to the page's handler. Ticks of a session in real time come at even times; the quickest message of every two
    seconds is taken to have needed no time, so that what is said is more than the quickest way by so much."""
    plan = ROOT / "data" / "plans" / "table_6_2.toml"
    words = [binary, "run", plan, "--socket", folder / "live", "--log", folder / "run.mcap", "--real-time", "--quiet", "--format", "json"]
    run = subprocess.Popen(words, stdout=subprocess.PIPE, encoding="utf-8")
    while not (folder / "live").exists():
        time.sleep(0.05)
    monitor = Monitor(binary, "--connect", folder / "live", "--commands")
    pages = [open_page(browser, monitor.url) for _ in range(1)]
    for line in ["enable", "move_joints 20,50,80,0,20", "move_joints -20,30,100,0,30"]:
        pages[0].evaluate("line => monitor.commands.line(line)", line)
        pages[0].wait_for_timeout(300)
    pages[0].evaluate("monitor.heard.length = 0")
    frames = [int(page.evaluate("document.getElementById('scene').dataset.frames")) for page in pages]
    begin = time.monotonic()
    pages[0].wait_for_timeout(1000 * seconds)
    passed = time.monotonic() - begin
    heard = np.array(pages[0].evaluate("monitor.heard"))
    drawn = [int(page.evaluate("document.getElementById('scene').dataset.frames")) - n for page, n in zip(pages, frames, strict=True)]
    late = heard[:, 1] - 2.0 * heard[:, 0]
    window = np.floor(heard[:, 0] * 0.002 / 2.0)
    late -= np.array([late[window == w].min() for w in window])
    for page in pages:
        page.context.close()
    print(monitor.end().strip())
    run.terminate()
    out = run.communicate(timeout=LONG_S)[0]
    print(f"states: {len(heard)} in {passed:.1f} s, {len(heard) / passed:.1f} a second")
    print("tick to handler in ms: median {:.1f}, p95 {:.1f}, largest {:.1f}".format(*np.percentile(late, [50, 95, 100])))
    print("pictures a second:", ", ".join(f"{n / passed:.1f}" for n in drawn))
    print(out)


def connected(listen):
    """A program that is connected like a page."""
    host, port = listen.rsplit(":", 1)
    end = socket.create_connection((host, int(port)))
    head = [f"GET /socket HTTP/1.1\r\nHost: {listen}", "Upgrade: websocket", "Connection: Upgrade", "Sec-WebSocket-Version: 13",
            "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA=="]
    end.sendall(("\r\n".join(head) + "\r\n\r\n").encode())
    return end


def swallow(end):
    with contextlib.suppress(OSError):
        while end.recv(1 << 16):
            pass


def servo(binary, folder, seconds):
    """Lateness and work of the servo without a monitor, and with five pages and one that stops reading."""
    plan = ROOT / "data" / "plans" / "table_6_2.toml"
    for watched in [False, True]:
        live = folder / f"live_{watched}"
        words = [binary, "run", plan, "--socket", live, "--log", folder / f"servo_{watched}.mcap", "--real-time", "--quiet", "--format", "json",
                 "--seconds", str(seconds)]
        run = subprocess.Popen(words, stdout=subprocess.PIPE, encoding="utf-8")
        while not live.exists():
            time.sleep(0.05)
        if watched:
            monitor = Monitor(binary, "--connect", live)
            ends = [connected(monitor.listen) for _ in range(6)]
            for end in ends[1:]:
                threading.Thread(target=swallow, args=(end,), daemon=True).start()
        timing = json.loads(run.communicate(timeout=seconds + LONG_S)[0])["timing"]
        if watched:
            for end in ends:
                end.close()
            print(monitor.end().strip())
        print("with pages:" if watched else "alone:", json.dumps(timing))


def resident_mb(pid):
    return int(re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{pid}/status").read_text())[1]) / 1024


def memory(binary, folder):
    """Memory of the monitor while a page plays an hour of log at 60 times real time."""
    # The arm stands still for most of it, which makes as many states as if it moved.
    plan = write_plan(folder, [(-14.0, 80.0, 0.025)])
    socket_path, log = folder / "hour", folder / "hour.mcap"
    words = [binary, "run", plan, "--socket", socket_path, "--log", log, "--seconds", "3600", "--quiet", "--format", "json"]
    begin = time.monotonic()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    print(f"an hour of log: {log.stat().st_size / 1e6:.0f} MB, made in {time.monotonic() - begin:.0f} s")
    begin = time.monotonic()
    monitor = Monitor(binary, "--play", log)
    print(f"read in {time.monotonic() - begin:.1f} s; {resident_mb(monitor.process.pid):.0f} MB")
    end = connected(monitor.listen)
    threading.Thread(target=swallow, args=(end,), daemon=True).start()
    for message in [{"type": "speed", "speed": 60}, {"type": "play"}]:
        end.sendall(frame(json.dumps(message).encode()))
    for _ in range(7):
        print(f"{resident_mb(monitor.process.pid):.1f} MB")
        time.sleep(10)
    end.close()
    print(monitor.end().strip())


def frame(payload):
    """A text frame of a client with a mask of zeros."""
    assert len(payload) < 126
    return bytes([0x81, 0x80 | len(payload), 0, 0, 0, 0]) + payload


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--latency", action="store_true")
    parser.add_argument("--servo", action="store_true")
    parser.add_argument("--memory", action="store_true")
    parser.add_argument("--seconds", type=float, default=30)
    args = parser.parse_args()
    binary = Path(os.environ["SOILCTL"]).resolve()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path="/usr/bin/chromium", args=CHROMIUM_ARGS)
        if args.latency:
            latency(binary, browser, Path(folder), args.seconds)
        if args.servo:
            servo(binary, Path(folder), args.seconds)
        if args.memory:
            memory(binary, Path(folder))
        browser.close()


if __name__ == "__main__":
    main()
