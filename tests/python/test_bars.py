"""Rows of bars between which the soil goes on: against exact forces and a limit equilibrium that knows nothing of this code."""

import json
import math

import pytest
from scipy.optimize import brentq, minimize_scalar

HEIGHT, PHI, COHESION, WEIGHT = 6.0, 30.0, 8.0, 18.0
NAILS, LENGTH = [1.2, 2.8, 4.4], 4.5
CUT = """
default_boundary = "free"
objective = {{kind = "strength-reduction"}}
[[soil]]
name = "silt"
phi_deg = 30
cohesion_kpa = 8
unit_weight_kn_m3 = 18
[[region]]
soil = "silt"
polygon = [[-6, -3], [14, -3], [14, 6], [0, 6], [0, 0], [-6, 0]]
[[boundary]]
kind = "fixed"
sides = ["bottom"]
[[boundary]]
kind = "smooth"
sides = ["left", "right"]
[[member]]
name = "facing"
line = [[0, 6], [0, 0]]
moment_knm_per_m = 200
shear_kn_per_m = 300
tensile_kn_per_m = 500
compressive_kn_per_m = 500
{nails}
"""


def nails(tensile, pullout, more=""):
    """Level rows that the facing holds."""
    one = '[[member]]\nname = "row {i}"\nline = [[0, {y}], [{length}, {y}]]\ntensile_kn_per_m = {tensile}\npullout_kn_per_m2 = {pullout}\nattached = ["start"]\n{more}\n'
    return "".join(one.format(i=i, y=y, length=LENGTH, tensile=tensile, pullout=pullout, more=more) for i, y in enumerate(NAILS))


def wedge(tensile, pullout):
    """The factor at which a rigid wedge slides out along the worst plane through the toe (Coulomb), with the dilation of the flow rule.

    The facing goes along, so nails are torn or pulled out of the ground behind, whose grip is divided by the factor as its strength is. What acts on
    the wedge does the work of nothing for a velocity of one at the angle `theta - phi` to the horizontal.
    """

    def unbalanced(factor, theta):
        phi = math.atan(math.tan(math.radians(PHI)) / factor)
        behind = [max(0.0, LENGTH - y / math.tan(theta)) for y in NAILS]
        force = sum(min(tensile, pullout / factor * length) for length in behind)
        held = COHESION / factor * HEIGHT / math.sin(theta) * math.cos(phi) + force * math.cos(theta - phi)
        return held - WEIGHT * HEIGHT**2 / (2 * math.tan(theta)) * math.sin(theta - phi)

    def factor(theta):
        return brentq(unbalanced, 0.05, 50, args=(theta,))

    angles = [math.radians(deg) for deg in range(30, 88)]
    best = min(angles, key=factor)
    found = minimize_scalar(factor, bounds=(best - 0.03, best + 0.03), method="bounded")
    return min(found.fun, factor(best))


def solved(soilctl, tmp_path, text, *more):
    file = tmp_path / "problem.toml"
    file.write_text(text)
    answer = soilctl.json("solve", file, *more)
    assert answer["certified"] is True and answer["lower"] <= answer["upper"]
    return answer


@pytest.mark.parametrize("tensile, pullout", [(60, 15), (15, 60)])
def test_a_nailed_cut_is_no_safer_than_a_wedge_says(soilctl, tmp_path, tensile, pullout):
    """Any mechanism is an upper bound; a plane is near the worst where the nails are level."""
    plane = wedge(tensile, pullout)
    text = CUT.format(nails=nails(tensile, pullout))
    answer = solved(soilctl, tmp_path, text, "--max-gap", "0.1", "--max-elements", "3000", "--max-seconds", "60")
    assert answer["lower"] <= plane and answer["upper"] <= 1.03 * plane, (answer["lower"], answer["upper"], plane)
    # Far more than without nails.
    assert answer["lower"] > 1.15 * wedge(0, 0)


def test_what_is_said_of_bars(soilctl, tmp_path):
    """The check, the words of proofs, and a saved proof that is altered."""
    file, proof = tmp_path / "cut.toml", tmp_path / "cut.json"
    file.write_text(CUT.format(nails=nails(60, 15, "free_length_m = 1.5")).replace("strength-reduction", "unit-weight"))
    checked = soilctl.json("solve", file, "--check")
    rows = {row["name"]: row for row in checked["members"]}
    assert rows["row 1"]["pullout_kn_per_m2"] == [15, 15] and rows["row 1"]["free_length_m"] == 1.5
    assert rows["facing"]["pullout_kn_per_m2"] is None and not checked["notes"]
    assert "15 from 1.5 m" in soilctl("solve", file, "--check").stdout
    soilctl("solve", file, "--max-gap", "0.3", "--max-elements", "1500", "--save", proof)
    assert "bars between which the soil goes on" in soilctl("certify", proof).stdout
    saved = json.loads(proof.read_text())
    for member in saved["statement"]["members"]:
        for grip in member.get("pullout", []):
            grip["resistance"] = [0.5 * value for value in grip["resistance"]]
    proof.write_text(json.dumps(saved))
    assert soilctl("certify", proof, code=1).stdout
