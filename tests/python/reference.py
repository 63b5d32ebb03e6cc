"""Coulomb's earth pressure and the force on a plate, written independently of the program."""

import numpy as np

GRAVITY_M_S2 = 9.80665


def coulomb_k_depth(alpha_deg, phi_deg, delta_deg, beta_deg=0.0):
    """Coulomb's passive and active coefficients, normalised by the vertical depth. NaN where there is none."""
    alpha, phi, delta, beta = (
        np.radians(np.asarray(x, dtype=float)) for x in (alpha_deg, phi_deg, delta_deg, beta_deg)
    )
    with np.errstate(invalid="ignore", divide="ignore"):
        q = np.sqrt(np.sin(phi + delta) * np.sin(phi + beta) / (np.sin(alpha + delta) * np.sin(alpha + beta)))
        passive = np.sin(alpha - phi) ** 2 / (np.sin(alpha) ** 2 * np.sin(alpha + delta) * (1 - q) ** 2)
        # The active side is the same wall seen from behind: alpha -> pi - alpha, beta -> -beta, with the forces of
        # friction reversed. Written out, that is the same expression with 1 + q in place of 1 - q.
        alpha_b, beta_b = np.pi - alpha, -beta
        q_b = np.sqrt(np.sin(phi + delta) * np.sin(phi - beta_b) / (np.sin(alpha_b - delta) * np.sin(alpha_b + beta_b)))
        active = np.sin(alpha_b + phi) ** 2 / (np.sin(alpha_b) ** 2 * np.sin(alpha_b - delta) * (1 + q_b) ** 2)
        limit = 1.0 - 1e-9
        return np.where(q < limit, passive, np.nan), np.where(q < limit, active, np.nan)


def coulomb_k_net_slant(alpha_deg, phi_deg, delta_deg, beta_deg=0.0):
    """Passive minus active, normalised by the slant length."""
    passive, active = coulomb_k_depth(alpha_deg, phi_deg, delta_deg, beta_deg)
    return (passive - active) * np.sin(np.radians(alpha_deg)) ** 2


def coulomb_force_n(alpha_deg, phi_deg, delta_deg, density_kg_m3, depth_m, width_m):
    """Force on a plate in level, cohesionless soil."""
    passive, active = coulomb_k_depth(alpha_deg, phi_deg, delta_deg)
    return 0.5 * density_kg_m3 * GRAVITY_M_S2 * depth_m**2 * width_m * (passive - active)
