"""Progress of long work: a callback, or a bar of tqdm."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

#: What a function with ``progress`` takes: called with the steps done and of all steps, or True for a bar of tqdm.
Progress = Callable[[int, int], object] | bool | None


@contextmanager
def callback(progress: Progress, unit: str) -> Iterator[Callable[[int, int], object] | None]:
    """The callback that stands behind ``progress``, for the length of the work."""
    if progress is not True:
        yield progress or None
        return
    from tqdm import tqdm

    with tqdm(unit=f" {unit}") as bar:

        def show(done: int, total: int) -> None:
            bar.total = total
            bar.update(done - bar.n)
            bar.refresh()

        yield show


class Levels:
    """A bar of tqdm for meshes that refine themselves: nobody knows how many there will be."""

    def __init__(self) -> None:
        from tqdm import tqdm

        self.bar = tqdm(unit=" meshes")

    def __call__(self, level: Any) -> None:
        # There is none before the first pair of bounds.
        gap = "no gap yet" if level.gap is None else f"gap {100 * level.gap:.2f} %"
        self.bar.set_postfix_str(f"{level.elements} elements, {gap}")
        self.bar.update()

    def close(self) -> None:
        """Leaves the bar as it is."""
        self.bar.close()
