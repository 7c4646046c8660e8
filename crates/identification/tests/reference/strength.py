#!/usr/bin/env python3
"""Cohesion and friction of weighted samples with their covariance, by dense matrices: a reference to compare with.

The stress points follow from the closed forms of A, B and H (Shibly et al. 2005) as they are printed, the weighted least squares
from the matrices X and W written out, with the residual operator as a whole matrix: nothing of it is recursive or centred, as
the crate's is. Run it, with numpy installed, to write the cases:

    python3 strength.py > strength.json
"""

import json

import numpy as np

WHEEL = {"radius_m": 0.15, "width_m": 0.12, "lug_height_m": 0.008, "lug_coefficient": 0.5}
SHEAR_MODULUS = 0.012
CONTACT = {"c1": 0.45, "c2": 0.1, "c3": -0.05}
COHESION, TAN_FRICTION = 600.0, 0.6
SAMPLES = 60
ROWS = [2, 9, 59]  # the last sample that is known


def geometry(slip, sinkage):
    """A, B, H and E at the peak."""
    r, K = WHEEL["radius_m"], SHEAR_MODULUS
    t1 = np.arccos(1 - sinkage / r)
    tm, t2 = (CONTACT["c1"] + CONTACT["c2"] * slip) * t1, CONTACT["c3"] * t1
    a = (np.cos(tm) - np.cos(t2)) / (tm - t2) + (np.cos(tm) - np.cos(t1)) / (t1 - tm)
    b = (np.sin(tm) - np.sin(t2)) / (tm - t2) + (np.sin(tm) - np.sin(t1)) / (t1 - tm)
    j = r * (t1 - tm - (1 - slip) * (np.sin(t1) - np.sin(tm)))
    return a, b, (t1 - t2) / 2, 1 - np.exp(-j / K)


def radii():
    return WHEEL["radius_m"], WHEEL["radius_m"] + WHEEL["lug_coefficient"] * WHEEL["lug_height_m"]


def measured(slip, sinkage, normal, strength):
    """Load and torque of linear stresses with these at their peak."""
    (r, rs), width = radii(), WHEEL["width_m"]
    a, b, h, e = geometry(slip, sinkage)
    shear = e * strength
    return r * width * a * normal + rs * width * b * shear, rs * rs * width * h * shear


def point(slip, sinkage, load, torque):
    (r, rs), width = radii(), WHEEL["width_m"]
    a, b, h, e = geometry(slip, sinkage)
    shear = torque / (rs * rs * width * h)
    return (load - rs * width * b * shear) / (r * width * a), shear / e


def line(points, forgetting):
    n = len(points)
    x = np.array([[1.0, normal] for normal, _ in points])
    y = np.array([strength for _, strength in points])
    w = np.diag(forgetting ** np.arange(n - 1, -1, -1.0))
    inverse = np.linalg.inv(x.T @ w @ x)
    beta = inverse @ x.T @ w @ y
    operator = w - w @ x @ inverse @ x.T @ w
    residual = y - x @ beta
    freedom = np.trace(operator)
    noise = residual @ w @ residual / freedom
    covariance = noise * inverse @ x.T @ w @ w @ x @ inverse
    return {
        "row": n - 1,
        "cohesion_pa": beta[0],
        "tan_friction": beta[1],
        "cohesion_variance_pa2": covariance[0, 0],
        "tan_friction_variance": covariance[1, 1],
        "covariance_pa": covariance[0, 1],
        "freedom": freedom,
    }


def main():
    rng = np.random.default_rng(7)
    slips, sinkages = rng.uniform(0.05, 0.7, SAMPLES), rng.uniform(0.008, 0.04, SAMPLES)
    normals = rng.uniform(4e3, 12e3, SAMPLES)
    strengths = COHESION + normals * TAN_FRICTION + rng.normal(0, 60.0, SAMPLES)
    loads, torques = measured(slips, sinkages, normals, strengths)
    rows = np.array([slips, sinkages, loads, torques]).T.tolist()
    points = [point(*row) for row in rows]
    cases = [
        {"forgetting_factor": factor, "estimates": [line(points[: row + 1], factor) for row in ROWS]}
        for factor in (1.0, 0.99, 0.9, 0.6)
    ]
    contact = {"rule": "wong_reece", **CONTACT}
    known = {"wheel": WHEEL, "shear_modulus_m": SHEAR_MODULUS, "contact": contact}
    print(json.dumps({**known, "samples": rows, "cases": cases}, indent=1))


main()
