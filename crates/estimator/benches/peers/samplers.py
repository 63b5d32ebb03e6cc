"""How long samplers take to reach the ranges of an estimate. Reads a problem as JSON, prints a JSON line a method.

Coulomb's wedges on both sides of the plate in closed form, vectorised over soils. A soil is consistent if each of its
forces lies in its interval. Samplers are helped: the ensemble begins at a consistent soil, and uniform draws come from
the box that the estimate has found.
"""

import json
import sys
import time

import emcee
import numpy as np

SHARES = (0.8, 0.9, 0.95, 0.99)


def wedge(alpha, beta, phi, delta, weight, surcharge, cohesion, adhesion):
    """Force on a plate of unit slant length by the wedge of least resistance to its weight; radians.

    With u = cot(theta - beta), theta the angle of the plane, the force by weight is the product of two linear functions of u over
    a third. In terms of the third, v, it is p v + q + r / v, stationary at v = sqrt(r / p).
    """
    def line(angle):
        return np.sin(angle), np.cos(angle)

    (a, b), (c, d) = line(alpha + beta), line(beta + phi)
    e, g = line(alpha + delta + phi + beta)
    b, d = b - a * g / e, d - c * g / e
    a, c = a / e, c / e
    v = np.sqrt(b * d / (a * c))
    theta = beta + np.arctan2(1.0, (v - g) / e)
    # The far end of the wedge: along the surface from the top of the plate, and along the plane from its tip.
    r = np.sin(alpha + theta) / np.sin(theta - beta)
    s = np.sin(alpha + beta) / np.sin(theta - beta)
    area = 0.5 * r * np.sin(alpha + beta)
    # Balance across the direction of the resultant on the plane; forces of the plate, of cohesion and of adhesion.
    down = weight * area + surcharge * r
    across = down * np.sin(theta + phi) + cohesion * s * np.cos(phi) - adhesion * np.cos(alpha + theta + phi)
    return across / np.sin(alpha + delta + phi + theta)


class Problem:
    def __init__(self, given):
        self.names = given["names"]
        self.known = given["known"]
        self.ranges = np.array(given["ranges"])
        self.prior = np.array(given["prior"])
        strokes = given["strokes"]
        self.alpha = np.radians([s["alpha_deg"] for s in strokes])
        self.length = np.array([s["slant_m"] for s in strokes])
        self.width = np.array([s["width_m"] for s in strokes])
        self.low = np.array([s["low_n"] for s in strokes])
        self.high = np.array([s["high_n"] for s in strokes])
        self.gravity = given["gravity_m_s2"]

    def forces(self, soils):
        """Net forces in N: soils along rows, strokes along columns."""
        value = {name: np.full((len(soils), 1), known) for name, known in self.known.items()}
        value |= {name: soils[:, [k]] for k, name in enumerate(self.names)}
        phi, delta, beta = (np.radians(value[name]) for name in ("Friction", "InterfaceFriction", "Slope"))
        weight = value["Density"] * self.gravity * self.length
        q, c, a = value["Surcharge"], value["Cohesion"], value["Adhesion"]
        ahead = wedge(self.alpha, beta, phi, delta, weight, q, c, a)
        behind = wedge(np.pi - self.alpha, -beta, -phi, -delta, weight, q, -c, -a)
        return (ahead - behind) * self.length * self.width

    def consistent(self, soils):
        inside = np.all((soils >= self.prior[:, 0]) & (soils <= self.prior[:, 1]), axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            forces = self.forces(soils)
            return inside & np.all((forces >= self.low) & (forces <= self.high), axis=1)

    def log_probability(self, soils):
        return np.where(self.consistent(soils), 0.0, -np.inf)


class Reached:
    """When which share of the estimate's ranges was seen, in the quantity that is worst."""

    def __init__(self, problem):
        self.ranges = problem.ranges
        self.low = np.full(len(self.ranges), np.inf)
        self.high = -self.low
        self.soils = 0
        self.start = time.perf_counter()
        self.at = {}

    def add(self, soils, count):
        self.soils += count
        if len(soils):
            self.low = np.minimum(self.low, soils.min(axis=0))
            self.high = np.maximum(self.high, soils.max(axis=0))
        for share in SHARES:
            if self.share() >= share:
                self.at.setdefault(share, self.seconds())

    def share(self):
        return float(np.min((self.high - self.low) / (self.ranges[:, 1] - self.ranges[:, 0])))

    def seconds(self):
        return time.perf_counter() - self.start

    def goes_on(self, limit):
        return SHARES[-1] not in self.at and self.seconds() < limit

    def tell(self, method):
        seconds = [self.at.get(share) for share in SHARES]
        outside = np.maximum(self.ranges[:, 0] - self.low, self.high - self.ranges[:, 1])
        beyond = float(np.max(outside / (self.ranges[:, 1] - self.ranges[:, 0])))
        line = {"method": method, "soils": self.soils, "share": self.share(), "beyond": beyond, "seconds": seconds}
        print(json.dumps(line), flush=True)


def ensemble(problem, start, limit, moves, method):
    """Walkers from a consistent soil, spread as far as stays consistent."""
    random = np.random.default_rng(1)
    reached = Reached(problem)
    count = 64
    width = problem.ranges[:, 1] - problem.ranges[:, 0]
    walkers = np.empty((0, len(width)))
    while len(walkers) < count:
        drawn = start + 0.02 * width * random.uniform(-1.0, 1.0, (count, len(width)))
        walkers = np.vstack([walkers, drawn[problem.consistent(drawn)]])
    sampler = emcee.EnsembleSampler(
        count, len(width), problem.log_probability, moves=moves, vectorize=True
    )
    state = emcee.State(walkers[:count])
    while reached.goes_on(limit):
        state = sampler.run_mcmc(state, 200, store=True, skip_initial_state_check=True)
        reached.add(sampler.get_chain(flat=True), 200 * count)
        sampler.reset()
    reached.tell(method)


def draws(problem, limit):
    """Uniform draws from the box of the answer."""
    random = np.random.default_rng(2)
    reached = Reached(problem)
    while reached.goes_on(limit):
        soils = random.uniform(problem.ranges[:, 0], problem.ranges[:, 1], (50_000, len(problem.ranges)))
        reached.add(soils[problem.consistent(soils)], len(soils))
    reached.tell("uniform draws from the answer's box")


def main():
    given = json.load(sys.stdin)
    problem = Problem(given)
    truth = np.array(given["truth"])
    found = problem.forces(truth[None, :])[0]
    forces = np.array([s["force_n"] for s in given["strokes"]])
    error = np.max(np.abs(found / forces - 1.0))
    assert error < 1e-9, f"forces differ by {error}"
    limit = given["seconds"]
    ensemble(problem, truth, limit, None, "emcee, stretch moves")
    differential = [(emcee.moves.DEMove(), 0.8), (emcee.moves.DESnookerMove(), 0.2)]
    ensemble(problem, truth, limit, differential, "emcee, differential evolution")
    draws(problem, limit)


if __name__ == "__main__":
    main()
