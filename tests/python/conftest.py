"""Fixtures: the command-line tool, the schemas of its answers, and a browser."""

import json
import os
import shutil
import signal
import subprocess
from pathlib import Path

import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from monitor_page import write_plan

# What was started in the background of a script ignores Ctrl-C, and so would everything that it starts.
signal.signal(signal.SIGINT, signal.default_int_handler)

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT / "data"
SCHEMAS = ROOT / "docs" / "schemas"

# A call that takes longer has hung.
TIMEOUT_S = 300

CHROMIUM_ARGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def _refuse_constant(word):
    raise AssertionError(f"the answer holds {word}, which is not JSON")


def strict_json(text):
    """One JSON document and nothing else, without NaN and infinities."""
    return json.loads(text, parse_constant=_refuse_constant)


class Soilctl:
    """Runs the binary under test."""

    def __init__(self, binary):
        self.binary = binary

    def __call__(self, *args, code=None, cwd=ROOT, stdin=None):
        """The completed process; checks the exit code if `code` is given."""
        words = [str(self.binary), *map(str, args)]
        done = subprocess.run(
            words,
            cwd=cwd,
            input=stdin,
            stdin=subprocess.DEVNULL if stdin is None else None,
            capture_output=True,
            encoding="utf-8",
            timeout=TIMEOUT_S,
            check=False,
            env={**os.environ, "NO_COLOR": "1"},
        )
        if code is not None:
            shown = f"{' '.join(words[1:])}\nstdout: {done.stdout[:2000]}\nstderr: {done.stderr[:2000]}"
            assert done.returncode == code, f"exit code {done.returncode} instead of {code}: {shown}"
        return done

    def json(self, *args, code=0, **options):
        """The JSON answer."""
        return strict_json(self(*args, "--format", "json", code=code, **options).stdout)

    def refuses(self, *args, mentions=(), **options):
        """Checks for exit code 2, an empty stdout and a message that holds every one of the given texts."""
        done = self(*args, code=2, **options)
        assert done.stdout == ""
        assert done.stderr.strip(), "there is no message"
        assert "panicked" not in done.stderr, done.stderr
        for text in mentions:
            assert text in done.stderr, f"{text!r} is not in: {done.stderr}"
        return done.stderr


@pytest.fixture(scope="session")
def soilctl():
    """The command-line tool that the environment variable SOILCTL points to."""
    binary = os.environ.get("SOILCTL")
    if not binary:
        pytest.fail("SOILCTL must hold the path of the soilctl binary; `cargo xtask test` sets it", pytrace=False)
    path = Path(binary).resolve()
    if not path.is_file():
        advice = "build it with `cargo build -p soilctl`"
        pytest.fail(f"SOILCTL is {binary!r}, which is not a file; {advice}", pytrace=False)
    return Soilctl(path)


@pytest.fixture(scope="session")
def validate():
    """Function that checks an answer against the schema file of its kind."""
    import jsonschema

    def check(answer):
        name = answer["schema"].replace("/", ".") + ".json"
        schema = json.loads((SCHEMAS / name).read_text(encoding="utf-8"))
        cls = jsonschema.validators.validator_for(schema)
        cls.check_schema(schema)
        cls(schema).validate(answer)

    return check


@pytest.fixture(scope="session")
def data():
    """The data folder."""
    return DATA


@pytest.fixture(scope="module")
def browser(request):
    """Debian's Chromium, started once a module, with the module's own CHROMIUM_ARGS if it has them."""
    from playwright.sync_api import sync_playwright

    executable = shutil.which("chromium")
    if executable is None:
        pytest.fail("there is no chromium on PATH; `cargo xtask setup` installs it", pytrace=False)
    arguments = getattr(request.module, "CHROMIUM_ARGS", CHROMIUM_ARGS)
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=executable, args=arguments)
        yield started
        started.close()


@pytest.fixture
def open_page(browser):
    """Function that opens a file in a new context, everything but the file itself cut off.

    The page carries `requests` (URLs that it asked for beside the file) and `problems` (errors of console and
    scripts).
    """
    contexts = []

    def open_file(path, **options):
        context = browser.new_context(**options)
        contexts.append(context)
        url = Path(path).resolve().as_uri()
        page = context.new_page()
        page.requests, page.problems = [], []

        def note(request):
            if request.url != url and not request.url.startswith(("data:", "blob:")):
                page.requests.append(request.url)

        def handle(route):
            request = route.request
            if request.url == url and request.is_navigation_request():
                route.continue_()
            else:
                note(request)
                route.abort()

        context.route("**/*", handle)
        # Whatever does not pass the route above: sockets, and requests made by the browser for the page.
        page.on("websocket", lambda socket: page.requests.append(socket.url))
        page.on("request", note)
        page.on("console", lambda m: page.problems.append(m.text) if m.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: page.problems.append(str(error)))
        page.goto(url, wait_until="load")
        return page

    yield open_file
    for context in contexts:
        context.close()


def decoded(log):
    """Topic to list of (log time in ns, message) of a log, by the `mcap` package."""
    found = {}
    with log.open("rb") as file:
        for _, channel, message, content in make_reader(file, decoder_factories=[DecoderFactory()]).iter_decoded_messages():
            found.setdefault(channel.topic, []).append((message.log_time, content))
    return found


@pytest.fixture(scope="session")
def stroke_log(soilctl, tmp_path_factory):
    """A log of one simulated stroke, 25 mm deep at 80 deg; not to be changed."""
    folder = tmp_path_factory.mktemp("stroke")
    plan = write_plan(folder, [(-14.0, 80.0, 0.025)])
    soilctl("simulate", plan, "--out", folder / "out", code=0)
    return folder / "out" / "batch_000.mcap"
