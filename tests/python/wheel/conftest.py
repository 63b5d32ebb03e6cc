"""For all tests of the wheel."""

import contextlib
import signal
import threading

# What was started in the background of a script ignores Ctrl-C, and so would everything that it starts.
signal.signal(signal.SIGINT, signal.default_int_handler)


@contextlib.contextmanager
def counting():
    """A list with a number that another thread raises meanwhile, as often as it gets the interpreter's lock."""
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    try:
        yield counted
    finally:
        stop.set()
        thread.join()
