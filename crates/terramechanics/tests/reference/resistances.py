#!/usr/bin/env python3
"""Bekker's resistances and thrust of a wheel in 50-digit arithmetic: a reference to compare with.

Formulas stand as the papers print them (Bekker 1956, 1960, 1969; Terzaghi 1943, with Coduto's
N_gamma), with the cosines and differences that lose digits in doubles. Nothing here is shared with
the code it checks. Run it, with mpmath installed, to write the cases:

    python3 resistances.py > resistances.json

Every case has an `input` and an `expected`; the field names are those of the HTTP API. An input is
read as the exact value of its doubles. Where a formula needs what the input lacks, null is expected.
"""

import json
import random

from mpmath import mp, mpf

mp.dps = 50
CASES = 60


def pick(draw, low, high):
    """A double, log-uniform, of at most four digits, so that the file stays short."""
    return float(f"{10 ** draw.uniform(low, high):.4g}")


def law_of(draw):
    n0 = round(draw.uniform(0.4, 2.0), 3)
    return draw.choice(
        [
            {"law": "bekker", "k_c": round(draw.uniform(-500, 5000)), "k_phi": pick(draw, 5, 7), "n0": n0},
            {"law": "direct", "k_s": pick(draw, 5, 7), "n0": n0},
            {
                "law": "reece",
                "k_c": round(draw.uniform(0, 100), 1),
                "k_phi": pick(draw, 1.5, 3.5),
                "unit_weight_n_m3": pick(draw, 3.2, 4.3),
                "n0": n0,
            },
            {"law": "diameter", "k": pick(draw, 5, 7), "m": round(draw.uniform(-0.5, 0.5), 3), "n0": n0},
        ]
    )


def modulus(law, wheel, cohesion):
    value = {name: mpf(number) for name, number in law.items() if name != "law"}
    b, n = mpf(wheel["width_m"]), value["n0"]
    match law["law"]:
        case "bekker":
            return value["k_c"] / b + value["k_phi"]
        case "direct":
            return value["k_s"]
        case "reece":
            return (cohesion * value["k_c"] + value["unit_weight_n_m3"] * b * value["k_phi"]) / b**n
        case "diameter":
            return value["k"] * (2 * mpf(wheel["radius_m"])) ** value["m"]


def bearing(phi):
    n_q = mp.exp((3 * mp.pi / 2 - phi) * mp.tan(phi)) / (2 * mp.cos(mp.pi / 4 + phi / 2) ** 2)
    n_c = (n_q - 1) / mp.tan(phi)
    n_gamma = 2 * (n_q + 1) * mp.tan(phi) / (1 + mpf("0.4") * mp.sin(4 * phi))
    return n_c, n_gamma


def bulldozing(b, diameter, z, c, phi, gamma):
    n_c, n_gamma = bearing(phi)
    k_c = (n_c - mp.tan(phi)) * mp.cos(phi) ** 2
    k_gamma = (2 * n_gamma / mp.tan(phi) + 1) * mp.cos(phi) ** 2
    alpha = mp.acos(1 - 2 * z / diameter)
    l_0 = z * mp.tan(mp.pi / 4 - phi / 2) ** 2
    return (
        b * mp.sin(alpha + phi) / (2 * mp.sin(alpha) * mp.cos(phi)) * (2 * z * c * k_c + gamma * z**2 * k_gamma)
        + l_0**3 * gamma / 3 * (mp.pi / 2 - phi)
        + c * l_0**2 * (1 + mp.tan(mp.pi / 4 + phi / 2))
    )


def thrust(b, diameter, h, z, load, c, phi, k, slip):
    length = diameter / 2 * mp.acos(1 - 2 * z / diameter)
    x = slip * length / k
    cohesive = b * length * c * (1 + 2 * h / b)
    frictional = load * mp.tan(phi) * (1 + (mpf("0.64") * (h / b) * mp.atan(b / h) if h else 0))
    return (cohesive + frictional) * (1 - (1 - mp.exp(-x)) / x)


def expected(case):
    wheel, soil = case["wheel"], case["soil"]
    b, diameter, h = mpf(wheel["width_m"]), 2 * mpf(wheel["radius_m"]), mpf(wheel["lug_height_m"])
    c, phi, k = (mpf(soil[name]) for name in ("cohesion_pa", "friction_angle_rad", "shear_modulus_m"))
    load, n = mpf(case["normal_load_n"]), mpf(soil["pressure_sinkage"]["n0"])
    b_k = b * modulus(soil["pressure_sinkage"], wheel, c)
    share = 3 * load / ((3 - n) * mp.sqrt(diameter))
    z = (share / b_k) ** (2 / (2 * n + 1))
    if z > diameter / 2:
        return None
    compaction = b_k ** (-1 / (2 * n + 1)) * share ** ((2 * n + 2) / (2 * n + 1)) / (n + 1)
    gamma = soil.get("unit_weight_n_m3", soil["pressure_sinkage"].get("unit_weight_n_m3"))
    slip = case.get("slip")
    results = {
        "rigid_wheel_sinkage_m": z,
        "compaction_resistance_n": compaction,
        "bulldozing_resistance_n": None if gamma is None else bulldozing(b, diameter, z, c, phi, mpf(gamma)),
        "thrust_n": thrust(b, diameter, h, z, load, c, phi, k, mpf(slip)) if slip else None,
    }
    return {name: None if value is None else float(value) for name, value in results.items()}


def main():
    draw, cases = random.Random(1969), []
    while len(cases) < CASES:
        case = {
            "wheel": {
                "radius_m": pick(draw, -1.3, 0),
                "width_m": pick(draw, -1.3, 0),
                "lug_height_m": draw.choice([0.0, pick(draw, -2.5, -1.3)]),
            },
            "soil": {
                "cohesion_pa": draw.choice([0.0, pick(draw, 1, 4)]),
                "friction_angle_rad": round(draw.uniform(0.02, 0.85), 4),
                "shear_modulus_m": pick(draw, -3, -1),
                "pressure_sinkage": law_of(draw),
            },
            "normal_load_n": pick(draw, -2, 4),
        }
        if draw.random() < 0.7:
            case["soil"]["unit_weight_n_m3"] = pick(draw, 3, 4.3)
        if draw.random() < 0.8:
            case["slip"] = pick(draw, -4, 0)
        results = expected(case)
        if results:
            cases.append({"input": case, "expected": results})
    print("[\n" + ",\n".join(json.dumps(case) for case in cases) + "\n]")


main()
