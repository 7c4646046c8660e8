#!/usr/bin/env python3
"""The pulls of the public single-wheel tests by the integrals, on several circles.

Run it, with mpmath installed, to write the values:

    python3 public_tests.py > public_tests.json

It reads the measured sets in `validation/` and the soil in `catalogue/`, and solves the sinkage for the
measured load. The stresses, the displacement and the three circles are those of the equations, and nothing
here is shared with another program. `entry_of_rim` counts the displacement from where the rim enters the
soil: the equation counts it from where the shearing circle does, before the rim.
"""

import json
import pathlib

from mpmath import acos, cos, exp, findroot, mp, mpf, quad, sin, sqrt, tan

mp.dps = 20

ROOT = pathlib.Path(__file__).resolve().parents[4]
SETS = ["ding-2011-smooth", "ding-2011-lug10", "hurrell-2025-rashid", "wang-han-2016-smooth", "wang-han-2016-lug10"]
WAYS = {
    "slip_on_rim": {"slip": "rim", "displacement": "shearing", "entry": "displacement"},
    "slip_on_shearing_circle": {"slip": "shearing", "displacement": "shearing", "entry": "displacement"},
    "all_on_rim": {"slip": "rim", "displacement": "rim", "entry": "displacement"},
    "entry_of_rim": {"slip": "rim", "displacement": "shearing", "entry": "rim"},
    "entry_of_rim_slip_on_shearing_circle": {"slip": "shearing", "displacement": "shearing", "entry": "rim"},
}
LUG_COEFFICIENT = mpf(1) / 2


def soil_of(asked):
    """The soil in the names of a request."""
    if "preset" not in asked:
        return asked
    soils = json.loads((ROOT / "catalogue/soils.json").read_text())
    record = next(soil for soil in soils if soil["id"] == asked["preset"])
    values = {name: of["value"] for name, of in record["values"].items()}
    return values | {"pressure_sinkage": {name: values[name] for name in ("k_c", "k_phi", "n0")}}


def forces(wheel, soil, slip, way, sinkage):
    """Pull and normal force."""
    r, b = mpf(wheel["radius_m"]), mpf(wheel["width_m"])
    radii = {"rim": r, "shearing": r + LUG_COEFFICIENT * mpf(wheel["lug_height_m"])}
    r_s, r_j = radii["shearing"], radii[way["displacement"]]
    travel = (1 - mpf(slip)) * radii[way["slip"]]
    law, cohesion = soil["pressure_sinkage"], mpf(soil["cohesion_pa"])
    modulus = mpf(law["k_c"]) / b + mpf(law["k_phi"])
    exponent, shear_modulus = mpf(law["n0"]), mpf(soil["shear_modulus_m"])
    friction = tan(mpf(soil["friction_angle_rad"]))
    entry = acos(1 - sinkage / r)
    peak = entry / 2
    start = acos((r - sinkage) / r_j) if way["entry"] == "displacement" else entry

    def stresses(angle):
        front = angle if angle >= peak else entry - angle / peak * (entry - peak)
        normal = modulus * max(r * (cos(front) - cos(entry)), mpf(0)) ** exponent
        displacement = r_j * (start - angle) - travel * (sin(start) - sin(angle))
        share = 1 - exp(-abs(displacement) / shear_modulus)
        return normal, (share if displacement >= 0 else -share) * (cohesion + normal * friction)

    def forward(angle):
        normal, shear = stresses(angle)
        return b * (r_s * shear * cos(angle) - r * normal * sin(angle))

    def upward(angle):
        normal, shear = stresses(angle)
        return b * (r_s * shear * sin(angle) + r * normal * cos(angle))

    return quad(forward, [0, peak, entry]), quad(upward, [0, peak, entry])


def solved(wheel, soil, slip, way, load):
    """Sinkage and pull under a load."""
    def missing(sinkage):
        return forces(wheel, soil, slip, way, sinkage)[1] / load - 1

    low, high = mpf(10) ** -6, mpf(wheel["radius_m"])
    sinkage = findroot(missing, (low, high), solver="anderson", tol=mpf(10) ** -26)
    return sinkage, forces(wheel, soil, slip, way, sinkage)[0]


def predicted(record):
    """Every way with its sinkages and pulls, and its error of the pull over the load."""
    soil, measured = soil_of(record["soil"]), record["measured"]
    load = mpf(measured["normal_load_n"])
    found = {}
    for name, way in WAYS.items():
        rows = [solved(record["wheel"], soil, slip, way, load) for slip in measured["slip"]]
        errors = [(pull - force) / load for (_, pull), force in zip(rows, measured["longitudinal_force_n"])]
        found[name] = {
            "sinkage_m": [float(sinkage) for sinkage, _ in rows],
            "longitudinal_force_n": [float(pull) for _, pull in rows],
            "drawbar_rmse_over_load": float(sqrt(sum(error**2 for error in errors) / len(errors))),
        }
    return found


def main():
    sets = {}
    for name in SETS:
        record = json.loads((ROOT / f"validation/{name}.json").read_text())
        sets[name] = {"points": len(record["measured"]["slip"]), "ways": predicted(record)}
    print(json.dumps(sets, indent=1))


if __name__ == "__main__":
    main()
