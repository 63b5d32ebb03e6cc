"""What the tests of the plate's bench share."""

from monitor_page import until

READY = "window.bench?.state.greeted && bench.state.shown"


def rested(page):
    """Waits until the models that search have answered too, and strokes are estimated; returns what is shown of the plate."""
    until(page, "bench.state.of?.slow && Object.keys(bench.values).every(key => bench.values[key] === bench.state.of[key])")
    return page.evaluate("bench.state.shown")


def estimated(page, with_next=False):
    """Waits until the table as it is now is estimated; returns what is shown of it."""
    until(page, "!bench.strokes.asker.isBusy && bench.strokes.shown !== null && bench.strokes.csvOf === bench.strokes.table.csv")
    if with_next:
        until(page, "bench.strokes.candidates !== null")
    return page.evaluate("bench.strokes.shown")


def force(page, model, ends):
    """Least and greatest force as the table of models tells them."""
    row = page.locator(f"[data-model='{model} {ends}']")
    return [float(row.get_attribute(f"data-{side}")) for side in ["low", "high"]]
