"""Rerun's own viewer, which its package brings along for the browser, on a recording."""

import contextlib
import io
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import numpy as np
from monitor_page import LONG_S
from PIL import Image

RERUN = Path(sys.executable).with_name("rerun")


def free_port():
    with socket.socket() as any_port:
        any_port.bind(("127.0.0.1", 0))
        return any_port.getsockname()[1]


class Viewer:
    """A server of the viewer and of a recording for it."""

    def __init__(self, recording, home):
        page, data = free_port(), free_port()
        words = [RERUN, recording, "--serve-web", "--bind", "127.0.0.1", "--web-viewer-port", page, "--port", data, "--renderer", "webgl"]
        # `rerun` starts the program proper, which is not to outlive it: all of them are one group.
        self.process = subprocess.Popen([str(word) for word in words], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        start_new_session=True, env={**os.environ, "HOME": str(home), "RERUN_ANALYTICS": "0"})
        base = f"http://127.0.0.1:{page}"
        self.url = f"{base}/?url=rerun%2Bhttp%3A%2F%2F127.0.0.1%3A{data}%2Fproxy&renderer=webgl"
        deadline = time.monotonic() + LONG_S
        while not answers(base):
            if self.process.poll() is not None or time.monotonic() > deadline:
                self.end()
                raise AssertionError(f"{base} does not answer; the viewer's exit code is {self.process.returncode}")
            time.sleep(0.1)

    def end(self):
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait(timeout=LONG_S)


def answers(url):
    try:
        with urllib.request.urlopen(url, timeout=5):
            return True
    except OSError:
        return False


def picture(page):
    """The page as it is, as an image."""
    return Image.open(io.BytesIO(page.screenshot())).convert("RGB")


def share(image, colour, box, off=12):
    """Share of the pixels in a box (left, top, right, bottom as shares of the page) that have nearly this colour."""
    pixels = np.asarray(image).astype(int)
    height, width, _ = pixels.shape
    left, top, right, bottom = (round(part * size) for part, size in zip(box, [width, height] * 2, strict=True))
    return float((np.abs(pixels[top:bottom, left:right] - colour).max(axis=2) <= off).mean())
