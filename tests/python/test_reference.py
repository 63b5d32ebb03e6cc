"""The tests' own reference against the published table, so that it is not just a second copy of the program."""

import csv

import numpy as np
import reference


def test_coulomb_reference_reproduces_appendix_c(data):
    with open(data / "appendix_c.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["coulomb"]]
    assert len(rows) == 286
    alpha, phi, delta, printed = (
        np.array([float(row[key]) for row in rows]) for key in ("alpha_deg", "phi_deg", "delta_deg", "coulomb")
    )
    found = reference.coulomb_k_net_slant(alpha, phi, delta)
    assert np.max(np.abs(found - printed)) <= 0.0006


def test_rankine_is_the_limit_of_a_smooth_vertical_plate():
    passive, active = reference.coulomb_k_depth(90.0, 30.0, 0.0)
    assert np.isclose(passive, 3.0) and np.isclose(active, 1 / 3)
