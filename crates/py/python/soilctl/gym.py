"""The simulated plant as a Gymnasium environment (``pip install soilctl[gym]``).

``gymnasium.make("soilctl/Plant-v0")`` works once this module is imported.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from ._native import Plant, Sensed
from .errors import InputError, InputTypeError

__all__ = ["PlantEnv"]

_COUNTS = 2.0**31
_LARGE = 1e6


class PlantEnv(gymnasium.Env[dict[str, Any], NDArray[np.float64]]):
    """Motor torques in, readings out; one step is a tick of 2 ms, or several.

    Actions are the torques of the five motors in N m; ``gymnasium.wrappers.RescaleAction`` makes them numbers from -1 to 1.
    Observations are what the sensors report: ``motor_counts`` (5,), ``external_counts`` (5,) and ``wrench`` (6,). An episode has
    no end of its own: ``gymnasium.make(..., max_episode_steps=5000)`` gives it one.

    Args:
        soil: One of ``soilctl.SOILS``; without one there is no sand.
        max_torque_nm: Bound of the action space.
        ticks_per_step: Ticks for which an action is held.
        reward: What a step is worth, told by ``Plant.truth`` (a dict) after it; 0 if not given.
        render_mode: None; there is nothing to be seen.
        options: Further keywords of :class:`soilctl.Plant`, but not its seed, which :meth:`reset` takes.

    Raises:
        InputError: If a number is out of its range, a name is unknown, or a seed or a way of rendering is given.
        TypeError: If there is no such option.
        FileError, NoAnswerError: What else :class:`soilctl.Plant` refuses.
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        soil: str | None = "ticino_rained",
        *,
        max_torque_nm: float = 50.0,
        ticks_per_step: int = 1,
        reward: Callable[[dict[str, Any]], float] | None = None,
        render_mode: str | None = None,
        **options: Any,
    ) -> None:
        if not 0.0 < max_torque_nm <= 1e4:
            raise InputError(f"max_torque_nm is {max_torque_nm} N m; it must be above 0 and at most 10000 N m")
        try:
            ticks = operator.index(ticks_per_step)
        except TypeError as problem:
            raise InputTypeError(f"ticks_per_step is {ticks_per_step!r}; it must be a whole number") from problem
        if ticks < 1:
            raise InputError(f"ticks_per_step is {ticks}; it must be at least 1")
        if render_mode is not None:
            raise InputError(f"render_mode is {render_mode!r}; it must be None, there is nothing to be seen")
        if not (reward is None or callable(reward)):
            raise InputTypeError(f"reward is of type {type(reward).__name__}; it must be callable")
        if "seed" in options:
            raise InputError("seed is none of the options; give it to reset()")
        # Refuses what reset() would refuse.
        Plant(soil, **options)
        self.render_mode = render_mode
        self._soil = soil
        self._options = options
        self._ticks = ticks
        self._reward = reward
        self._plant: Plant | None = None
        self.action_space = spaces.Box(-max_torque_nm, max_torque_nm, (5,), np.float64)
        counts = spaces.Box(-_COUNTS, _COUNTS, (5,), np.float64)
        wrench = spaces.Box(-_LARGE, _LARGE, (6,), np.float64)
        self.observation_space = spaces.Dict({"external_counts": counts, "motor_counts": counts, "wrench": wrench})

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Any], dict[str, Any]]:
        """A plant at rest; the seed is that of the noise of sensors and soil."""
        super().reset(seed=seed)
        plant_seed = int(self.np_random.integers(2**32))
        self._plant = Plant(self._soil, seed=plant_seed, **self._options)
        sensed = self._plant.step(np.zeros(5), amplifiers_enabled=False)
        return _observation(sensed), {"truth": self._plant.truth}

    def step(self, action: NDArray[np.float64]) -> tuple[dict[str, Any], float, bool, bool, dict[str, Any]]:
        """Holds the torques for the ticks of a step.

        Raises:
            InputError: If a torque is not finite; the plant is as it was before.
            SimulationError: If the arm left all bounds.
        """
        if self._plant is None:
            raise gymnasium.error.ResetNeeded("call reset() before step()")
        for _ in range(self._ticks):
            sensed = self._plant.step(action)
        truth = self._plant.truth
        reward = 0.0 if self._reward is None else float(self._reward(truth))
        return _observation(sensed), reward, False, False, {"truth": truth}


def _observation(sensed: Sensed) -> dict[str, Any]:
    return {
        "external_counts": sensed.external_counts.astype(np.float64),
        "motor_counts": sensed.motor_counts.astype(np.float64),
        "wrench": sensed.wrench,
    }


gymnasium.register("soilctl/Plant-v0", entry_point=PlantEnv)
