#!/usr/bin/env python3
"""A wheel in dry grains by the resistive force method, in 40-digit arithmetic: a reference to compare with.

The formulas are the published ones, with angles, as Li, Zhang and Goldman (2013) print them; the stiffness
is the polynomial of Agarwal, Goldman and Kamrin (2023). The integrals along the rim are computed by two
unlike rules (tanh-sinh and Gauss-Legendre, on panels that grow from the lowest point), which have to agree
to 1e-24. A load is solved by bisection of the sinkage.

Run it, with mpmath installed, to write the cases:

    python3 resistive_force.py > resistive_force.json
"""

import json
import sys

from mpmath import mp, mpf

mp.dps = 40
AGREEMENT = mpf(10) ** -24

A00, A10, B11, B01, B_11 = (mpf(x) for x in ("0.206", "0.169", "0.212", "0.358", "0.055"))
C11, C01, C_11, D10 = (mpf(x) for x in ("-0.124", "0.253", "0.007", "0.088"))

NAMES = ("traction_n", "resistance_n", "normal_support_n", "shear_support_n", "torque_n_m")


class Failure(Exception):
    """The reference itself is in doubt."""


class Grains:
    """A wheel at its slip; every method takes the sinkage z."""

    def __init__(self, given):
        wheel, soil = given["wheel"], given["soil"]
        self.r, self.b, self.s = mpf(wheel["radius_m"]), mpf(wheel["width_m"]), mpf(given["slip"])
        if "granular_stiffness_n_m3" in soil:
            self.xi = mpf(soil["granular_stiffness_n_m3"])
        else:
            mu = mp.tan(mpf(soil["friction_angle_rad"]))
            weight = mpf(soil["bulk_density_kg_m3"]) * mpf(soil["gravity_m_s2"])
            self.xi = weight * (894 * mu**3 - 386 * mu**2 + 89 * mu)

    def direction(self, theta):
        """gamma; v / (r omega) is 1 - s driving and 1 / (1 + s) braking."""
        if self.s == -1:
            return mp.pi
        ratio = 1 - self.s if self.s >= 0 else 1 / (1 + self.s)
        return mp.atan2(mp.sin(theta), mp.cos(theta) - ratio)

    def stresses(self, theta, theta_1):
        """sigma and tau."""
        beta, gamma = -theta, self.direction(theta)
        up = (A00 + A10 * mp.cos(2 * beta) + B11 * mp.sin(2 * beta + gamma) + B01 * mp.sin(gamma)
              + B_11 * mp.sin(-2 * beta + gamma))
        along = (C11 * mp.cos(2 * beta + gamma) + C01 * mp.cos(gamma) + C_11 * mp.cos(-2 * beta + gamma)
                 + D10 * mp.sin(2 * beta))
        pressure = self.xi * self.r * 2 * mp.sin((theta_1 + theta) / 2) * mp.sin((theta_1 - theta) / 2)
        return (pressure * (up * mp.cos(theta) - along * mp.sin(theta)),
                pressure * (along * mp.cos(theta) + up * mp.sin(theta)))

    def panels(self, theta_1):
        """Ends of panels that double from well inside the layer in which gamma swings."""
        end = min(theta_1, max(abs(self.s), mpf(10) ** -30 * theta_1) / 8)
        ends = [mpf(0)]
        while end < theta_1:
            ends.append(end)
            end *= 2
        return ends + [theta_1]

    def parts(self, z):
        theta_1 = 2 * mp.asin(mp.sqrt(z / (2 * self.r)))
        panels = self.panels(theta_1)

        def integrand(theta, name):
            sigma, tau = self.stresses(theta, theta_1)
            return {"traction_n": tau * mp.cos(theta), "resistance_n": sigma * mp.sin(theta),
                    "normal_support_n": sigma * mp.cos(theta), "shear_support_n": tau * mp.sin(theta),
                    "torque_n_m": self.r * tau}[name]

        sums = {}
        for name in NAMES:
            one, other = (mp.quad(lambda theta: integrand(theta, name), panels, method=method)
                          for method in ("gauss-legendre", "tanh-sinh"))
            size = mp.quad(lambda theta: abs(integrand(theta, name)), panels, method="gauss-legendre", maxdegree=4)
            if abs(one - other) > AGREEMENT * size:
                raise Failure(f"the rules disagree on {name}: {one} and {other}")
            sums[name] = self.b * self.r * one
        return sums

    def result(self, z):
        parts = self.parts(z)
        return {
            "granular_stiffness_n_m3": self.xi,
            "longitudinal_force_n": parts["traction_n"] - parts["resistance_n"],
            "normal_force_n": parts["normal_support_n"] + parts["shear_support_n"],
        } | parts

    def normal(self, z):
        theta_1 = 2 * mp.asin(mp.sqrt(z / (2 * self.r)))

        def upward(theta):
            sigma, tau = self.stresses(theta, theta_1)
            return sigma * mp.cos(theta) + tau * mp.sin(theta)

        return self.b * self.r * mp.quad(upward, self.panels(theta_1), method="gauss-legendre")

    def sinkage(self, load):
        """The sinkage that carries a load, by the secant rule within a bracket."""
        low, high = mpf(0), self.r
        at_low, at_high = -mpf(load), self.normal(high) - load
        if at_high < 0:
            raise Failure("the load is too large")
        for turn in range(200):
            z = (low + high) / 2 if turn % 3 == 2 else low - at_low * (high - low) / (at_high - at_low)
            here = self.normal(z) - load
            if abs(here) < mpf(10) ** -20 * load:
                return z
            if here < 0:
                low, at_low = z, here
            else:
                high, at_high = z, here
        raise Failure("no sinkage was found")


def given(r, b, phi, slip, z, rho=None, g=None, xi=None):
    soil = {"friction_angle_rad": phi}
    soil |= {"granular_stiffness_n_m3": xi} if xi else {"bulk_density_kg_m3": rho, "gravity_m_s2": g}
    return {"wheel": {"radius_m": r, "width_m": b}, "soil": soil, "slip": slip, "sinkage_m": z}


# At the edges: name, slip, sinkage over radius.
EDGES = [
    ("spinning on the spot, to the axle", 1.0, 1.0),
    ("driving hard, to the axle", 0.99, 1.0),
    ("driving, to the axle", 0.2, 1.0),
    ("hardly driving, to the axle", 1e-3, 1.0),
    ("rolling, to the axle", 0.0, 1.0),
    ("hardly braking, to the axle", -1e-3, 1.0),
    ("braking, to the axle", -0.4, 1.0),
    ("locked, to the axle", -1.0, 1.0),
    ("all but locked", -0.999999, 0.3),
    ("a layer of a hundredth of the contact", 4e-3, 0.08),
    ("a layer of a hundredth, braking", -4e-3, 0.08),
    ("a layer of a ten thousandth", 4e-5, 0.08),
    ("a layer of a ten thousandth, braking", -4e-5, 0.08),
    ("a layer of 1e-8 rad", 1e-8, 0.1),
    ("a layer of 1e-8 rad, braking", -1e-8, 0.1),
    ("a layer of 1e-13 rad", 1e-13, 0.5),
    ("thin, driving", 0.3, 1e-6),
    ("thin, rolling", 0.0, 1e-6),
    ("thin, hardly driving", 1e-5, 1e-6),
    ("thin, braking", -0.1, 1e-6),
    ("thin, locked", -1.0, 1e-6),
]

# Name, slip, load.
LOADS = [("driving", 0.25, 90.0), ("rolling", 0.0, 5.0), ("braking", -0.1, 300.0), ("a feather", 0.1, 1e-6)]


def doubles(values):
    return {name: float(value) for name, value in values.items()}


def main():
    cases = []
    for name, slip, share in EDGES:
        case = given(0.2, 0.1, 0.6, slip, 0.2 * share, xi=2e6)
        cases.append({"name": name, "input": case, "expected": doubles(Grains(case).result(mpf(case["sinkage_m"])))})
        print(name, file=sys.stderr)
    for name, slip, load in LOADS:
        case = given(0.15, 0.12, 0.55, slip, None, rho=1600.0, g=3.721)
        case.pop("sinkage_m")
        z = Grains(case).sinkage(mpf(load))
        cases.append({"name": f"load, {name}", "input": case | {"normal_load_n": load}, "expected": {"sinkage_m": float(z)}})
        print(f"load, {name}: {float(z)}", file=sys.stderr)
    json.dump(cases, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(str(failure))
