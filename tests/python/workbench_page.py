"""What the workbench's tests share: a running workbench, and its page in a browser."""

import re

import pytest
from monitor_page import LONG_S, Served, until


class Workbench(Served):
    """A running `soilctl workbench`."""

    def __init__(self, binary, *words):
        super().__init__(binary, "workbench", *words, "--port", "0")


def open_page(browser, url, ready="window.workbench?.state.greeted", **options):
    """A page in a context of its own; it carries `problems` and `requests` to elsewhere."""
    context = browser.new_context(**{"viewport": {"width": 1280, "height": 800}, "reduced_motion": "reduce", "accept_downloads": True, **options})
    page = context.new_page()
    page.problems, page.requests = [], []
    page.on("console", lambda m: page.problems.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda error: page.problems.append(str(error)))
    own = re.match(r"http://([^/]+)/", url).group(1)
    page.on("request", lambda r: page.requests.append(r.url) if own not in r.url and not r.url.startswith(("data:", "blob:")) else None)
    page.set_default_timeout(LONG_S * 1000)
    page.goto(url)
    until(page, ready)
    return page


def settled(page):
    """Waits until the document is checked; returns it."""
    until(page, "workbench.state.asked && workbench.state.answered === workbench.state.asked && workbench.state.sent === workbench.store.problem")
    page.evaluate("() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    return page.evaluate("workbench.store.problem")


def begin(page, template):
    """Takes a template by its card."""
    page.locator(f"[data-template={template}]").click()
    return settled(page)


def solve(page, gap="0.1"):
    """Solves by keyboard; returns the bounds as they are told."""
    page.locator("#tab-result").click()
    page.locator("#gap").select_option(gap)
    page.locator("#section").focus()
    page.keyboard.press("Control+Enter")
    until(page, "['solved', 'failed'].includes(document.body.dataset.solver)")
    assert page.evaluate("document.body.dataset.solver") == "solved", page.locator("#failure").text_content()
    shown = [float(page.locator(f"dl.pair .{side} dd").get_attribute("data-value")) for side in ["lower", "upper"]]
    assert page.locator("#proof").text_content() == "Both bounds are proven with interval arithmetic."
    return shown


def save(page):
    page.keyboard.press("Control+s")
    until(page, "document.getElementById('told').textContent.endsWith('was saved')")


def click(page, x_m, y_m, **options):
    """Clicks a place of the ground."""
    x, y = page.evaluate("p => workbench.view.px(p)", [x_m, y_m])
    page.locator("#section").click(position={"x": x, "y": y}, **options)


@pytest.fixture
def serve(soilctl, browser):
    """Function that starts a workbench and opens one of its pages; all ends with the test, without errors on the page."""
    started, pages = [], []

    def run(*words, path="", **looks):
        workbench = Workbench(soilctl.binary, *words)
        started.append(workbench)
        page = open_page(browser, workbench.url.replace("#", f"{path}#"), **looks)
        pages.append(page)
        return workbench, page

    yield run
    for page in pages:
        assert page.problems == [] and page.requests == []
        page.context.close()
    for workbench in started:
        workbench.end()
