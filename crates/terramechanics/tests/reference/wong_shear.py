#!/usr/bin/env python3
"""Wheels on soils with Wong's two shear laws, in 60-digit arithmetic: a reference to compare with.

The laws are written down here once more, from the displacement at the largest strength K_w:

    a hump, then a residual:  E = K_r {1 + [1/(K_r (1 - 1/e)) - 1] exp(1 - j/K_w)} {1 - exp(-j/K_w)}
    a peak, then decay:       E = (j/K_w) exp(1 - j/K_w)

and continued to a braking wheel as odd functions of j; a locked wheel (an endless displacement) has
minus the residual. All else (soil, wheel, rules of integration) is that of `reference.py`, which is
independent of the crate as well.

Run it, with mpmath installed, to write the cases:

    python3 wong_shear.py > wong_shear.json

The integrals are computed by two unlike rules, which have to agree to 1e-20.
"""

import json
import sys
import time

from mpmath import mp, mpf

from reference import Failure, Wheel, bekker, direct, half_sinkage, midpoint, reece, wong_reece


class WongWheel(Wheel):
    """A wheel whose soil has a shear law of Wong's."""

    def __init__(self, given):
        soil = given["soil"]
        shear = soil["shear"]
        self.K_w = mpf(shear["peak_displacement_m"])
        self.K_r = mpf(shear["residual_ratio"]) if shear["law"] == "wong_residual" else None
        # The base class asks for the modulus of a law that is not used: half of K_w would show.
        super().__init__(given | {"soil": soil | {"shear_modulus_m": self.K_w / 2}})

    def mobilisation(self, contact, theta):
        if self.locked:
            return -self.K_r if self.K_r is not None else mpf(0)
        j = self.shear_displacement(contact, theta)
        x = abs(j) / self.K_w
        if self.K_r is None:
            return mp.sign(j) * x * mp.exp(1 - x)
        hump = 1 + (1 / (self.K_r * (1 - mp.exp(-1))) - 1) * mp.exp(1 - x)
        return mp.sign(j) * self.K_r * hump * (1 - mp.exp(-x))


SAND, CLAY = direct(9.0e5, 1.1), bekker(1.2e4, 7.0e5, 0.6, 0.15)
SNOW = bekker(4370.0, 1.967e5, 1.6)


def cases_of(shear):
    def case(name, r, b, z, s, law, contact, c=0.0, phi=0.5, K_w=0.02, h=0.0, radius="rim", K_r=0.66):
        parameters = {"law": shear, "peak_displacement_m": K_w}
        if shear == "wong_residual":
            parameters["residual_ratio"] = K_r
        return f"{shear}, {name}", {
            "wheel": {"radius_m": r, "width_m": b, "lug_height_m": h, "lug_coefficient": 0.5},
            "soil": {"cohesion_pa": c, "friction_angle_rad": phi, "shear": parameters, "pressure_sinkage": law},
            "contact": contact,
            "slip": s,
            "sinkage_m": z,
            "normal_stress_radius": radius,
        }

    return [
        case("driving", 0.2, 0.1, 0.02, 0.2, SAND, midpoint()),
        case("driving past the peak", 0.2, 0.1, 0.05, 0.8, SAND, midpoint(-0.2), c=500.0, K_w=0.004, K_r=0.3),
        case("spinning on a stiff soil", 0.25, 0.15, 0.03, 1.0, CLAY, half_sinkage(), c=8000.0, phi=0.2, K_w=0.006),
        case("rolling", 0.2, 0.1, 0.03, 0.0, SAND, midpoint(-0.3)),
        case("braking, the shear reverses", 0.2, 0.1, 0.03, -0.1, SAND, midpoint(-0.2), c=300.0, K_w=0.01),
        case("braking hard", 0.3, 0.2, 0.05, -0.6, CLAY, wong_reece(0.45, 0.1), c=2000.0, phi=0.4, K_w=0.03, K_r=0.9),
        case("braking with lugs", 0.15, 0.1, 0.02, -0.3, SAND, midpoint(), c=400.0, h=0.02, radius="shearing", K_w=0.008),
        case("almost locked", 0.2, 0.1, 0.03, -0.98, SAND, midpoint(), K_w=0.02),
        case("locked", 0.2, 0.1, 0.03, -1.0, SAND, midpoint(), c=200.0),
        case("soft snow, deep", 0.2, 0.15, 0.15, 0.4, SNOW, midpoint(), c=1000.0, phi=0.345, K_w=0.022),
        case("a peak far beyond the contact", 0.2, 0.1, 0.01, 0.1, reece(5.0, 60.0, 15000.0, 0.9), midpoint(), K_w=1.0),
    ]


def main():
    started, cases = time.monotonic(), []
    for name, given in cases_of("wong_residual") + cases_of("wong_peak"):
        try:
            forces = WongWheel(given).quadrature(mpf(given["sinkage_m"]))
        except Failure as failure:
            sys.exit(f"{name}: {failure}")
        expected = {name: float(value) + 0.0 for name, value in forces.items()}  # no negative zero
        cases.append({"name": name, "input": given, "expected": {"quadrature": expected}})
        print(f"{time.monotonic() - started:6.1f} s  {name}", file=sys.stderr)
    json.dump(cases, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
