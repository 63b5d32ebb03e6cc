"""How fast a vectorised prediction is: `python benchmark_predict.py`. Nothing is asserted but that the answers agree.

Coulomb's coefficient at a million points: by soilctl, by its closed form in numpy, by the same in a Python loop, and by
one call of soilctl a point. Then Chen & Liu's, the default, whose mechanism has to be searched: by soilctl and in a Python loop; and
the brackets of the table.
The least of several runs of each counts, in turn, since others may use the machine.
"""

import math
import time

import numpy as np

import soilctl

POINTS, LOOPED, CALLED, SEARCHED, RUNS = 10**6, 10**5, 10**4, 10**3, 5


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


def chen_liu(alpha_deg, phi_deg, delta_deg):
    """Passive minus active as above, by Chen & Liu (1990), section 5.3, without wall dilation; a golden section over rho."""
    alpha, phi, delta = map(math.radians, (alpha_deg, phi_deg, delta_deg))

    def least(alpha, phi, delta, sign):
        dip, t3 = math.pi / 4 - phi / 2, 3 * math.tan(phi)

        def weight(rho):
            psi = 0.0 if rho < 0 else max(alpha - rho - dip, 0.0)
            x, d = alpha - rho - psi, alpha - rho
            toe, growth = math.cos(x + phi), math.exp(t3 * psi)
            spiral = (growth * (t3 * math.cos(x) - math.sin(x)) - (t3 * math.cos(d) - math.sin(d))) / (t3**2 + 1)
            triangle = growth * math.cos(phi) * math.sin(x) * math.cos(x) / toe
            r0 = math.cos(rho - phi) / math.cos(phi)
            return sign * r0 * (math.sin(rho) * math.cos(d) + r0 * (spiral + triangle)) / math.cos(rho + delta)

        low = min(alpha + phi - math.pi / 2, 0.0) + 1e-9
        high = min(math.pi / 2 - delta, math.pi / 2 + phi, alpha) - 1e-9
        scan = [low + (high - low) * i / 16 for i in range(17)]
        best = min(range(17), key=lambda i: weight(scan[i]))
        low, high = scan[max(best - 1, 0)], scan[min(best + 1, 16)]
        golden = (math.sqrt(5) - 1) / 2
        while high - low > 1e-8:
            a, b = high - golden * (high - low), low + golden * (high - low)
            low, high = (low, b) if weight(a) < weight(b) else (a, high)
        return weight(0.5 * (low + high))

    return least(alpha, phi, delta, 1) + min(least(math.pi - alpha, -phi, -delta, -1), 0.0)


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

    def chen(points):
        a, p, d = (values[:points] for values in (alpha, phi, delta))
        return soilctl.predict("chen", tool_angle_deg=a, friction_angle_deg=p, interface_friction_deg=d).coefficient

    def looked_up():
        a, p, d = (values[:LOOPED] for values in (70 + 0.75 * (alpha - 60), phi, delta))
        return soilctl.predict("table", tool_angle_deg=a, friction_angle_deg=p, interface_friction_deg=d).coefficient

    def searched():
        return [chen_liu(*angles) for angles in zip(*(values[:SEARCHED] for values in part), strict=True)]

    np.testing.assert_allclose(chen(SEARCHED), searched(), rtol=1e-9)
    np.testing.assert_allclose(ours(), vectorised(), rtol=1e-9)
    np.testing.assert_allclose(ours()[:LOOPED], looped(), rtol=1e-9)
    least = {}
    for _ in range(RUNS):
        works = (
            ("soilctl", ours, POINTS),
            ("numpy", vectorised, POINTS),
            ("loop", looped, LOOPED),
            ("calls", called, CALLED),
            ("chen", lambda: chen(LOOPED), LOOPED),
            ("its loop", searched, SEARCHED),
            # Tables begin at 70 degrees.
            ("table", looked_up, LOOPED),
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
        ratios = [f"{name} {ns[name] / ns['soilctl']:.2f}" for name in ("numpy", "loop", "calls")]
        print(f"{kind} time over soilctl's: {', '.join(ratios)}; chen's loop over chen {ns['its loop'] / ns['chen']:.0f}, table over chen {ns['table'] / ns['chen']:.2f}")


if __name__ == "__main__":
    main()
