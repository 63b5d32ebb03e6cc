"""How fast a vectorised prediction is: `python benchmark_predict.py`. Nothing is asserted but that the answers agree.

Coulomb's coefficient at a million points: by soilctl, by its closed form in numpy, by the same in a Python loop, and by
one call of soilctl a point.
The least of several runs of each counts, in turn, since others may use the machine.
"""

import math
import time

import numpy as np

import soilctl

POINTS, LOOPED, CALLED, RUNS = 10**6, 10**5, 10**4, 5


def closed_form(m, alpha_deg, phi_deg, delta_deg):
    """Passive minus active, slant-normalised, level surface; `m` is numpy or math (Terzaghi 1943, p. 105)."""
    alpha, phi, delta = m.radians(alpha_deg), m.radians(phi_deg), m.radians(delta_deg)
    mirrored = math.pi - alpha
    a = m.sin(alpha)
    q = m.sqrt(m.sin(phi + delta) * m.sin(phi) / (m.sin(alpha + delta) * a))
    passive = m.sin(alpha - phi) ** 2 / (m.sin(alpha + delta) * (1 - q) ** 2)
    q = m.sqrt(m.sin(phi + delta) * m.sin(phi) / (m.sin(mirrored - delta) * m.sin(mirrored)))
    active = m.sin(mirrored + phi) ** 2 / (m.sin(mirrored - delta) * (1 + q) ** 2)
    return passive - active


def main():
    random = np.random.default_rng(1)
    alpha, phi, delta = (random.uniform(*ends, POINTS) for ends in ((60, 100), (30, 40), (5, 20)))

    def ours():
        return soilctl.predict(
            "coulomb", tool_angle_deg=alpha, friction_angle_deg=phi, interface_friction_deg=delta
        ).coefficient

    def vectorised():
        return closed_form(np, alpha, phi, delta)

    part = [values[:LOOPED].tolist() for values in (alpha, phi, delta)]

    def looped():
        return [closed_form(math, *angles) for angles in zip(*part, strict=True)]

    def called():
        return [
            soilctl.predict(
                "coulomb", tool_angle_deg=a, friction_angle_deg=p, interface_friction_deg=d
            ).coefficient
            for a, p, d in zip(*(values[:CALLED] for values in part), strict=True)
        ]

    np.testing.assert_allclose(ours(), vectorised(), rtol=1e-9)
    np.testing.assert_allclose(ours()[:LOOPED], looped(), rtol=1e-9)
    least = {}
    for _ in range(RUNS):
        works = (
            ("soilctl", ours, POINTS),
            ("numpy", vectorised, POINTS),
            ("loop", looped, LOOPED),
            ("calls", called, CALLED),
        )
        for name, work, points in works:
            wall, cpu = time.perf_counter(), time.process_time()
            work()
            taken = (1e9 * (time.perf_counter() - wall) / points, 1e9 * (time.process_time() - cpu) / points)
            least[name] = tuple(map(min, zip(taken, least.get(name, taken), strict=True)))
    for name, (wall, cpu) in least.items():
        print(f"{name:8s} {wall:8.1f} ns a point, {cpu:8.1f} ns of all processors")
    for index, kind in enumerate(("wall", "processor")):
        ns = {name: taken[index] for name, taken in least.items()}
        ratios = {name: taken / ns["soilctl"] for name, taken in ns.items()}
        print(f"{kind} time over soilctl's: " + ", ".join(f"{name} {ratio:.2f}" for name, ratio in ratios.items()))


if __name__ == "__main__":
    main()
