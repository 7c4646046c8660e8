#!/usr/bin/env python3
"""A braking wheel with two zones, and the towed wheel, in 60-digit arithmetic: a reference to compare with.

The law is that of Wong and Reece (1967), part II, in the terms of the paper: skid i = v/(r omega) - 1,
K_v, magnitudes of the shear displacement, and the signs of the shear in the integrals. The angle
theta_0 is found by bisection of its condition. All else (soil, wheel, rules of integration) is that of
`reference.py`, which is independent of the crate as well.

Run it, with mpmath installed, to write the cases:

    python3 two_zones.py > two_zones.json

The integrals are computed by two unlike rules, which have to agree to 1e-20. A towed wheel is solved by
Newton's method in (skid, sinkage) until both balances hold to 1e-22.
"""

import json
import sys
import time

from mpmath import mp, mpf

from reference import AGREEMENT, CHECK, COARSE, FINE, Contact, Failure, Wheel, bekker, direct, reece, result

BALANCE = mpf(10) ** -22


class BrakingWheel(Wheel):
    """A wheel that skids; every method takes the sinkage z."""

    def __init__(self, given):
        super().__init__(given)
        if not self.skids():
            raise Failure("the wheel does not brake")
        phi = mpf(given["soil"]["friction_angle_rad"])
        self.exit_ratio = mpf(given.get("contact", {}).get("c3", 0))
        self.i = None if self.locked else self.kappa - 1
        self.theta_0 = self.parting_angle(mp.tan(mp.pi / 4 - phi / 2))

    def skids(self):
        return -1 <= self.s < 0

    def parting_angle(self, slope):
        """The root of slope = (cos x - 1 / (1 + i)) / sin x; the right side falls from infinity."""
        share = mpf(0) if self.locked else 1 / (1 + self.i)
        low, high = mpf(0), mp.pi / 2
        for _ in range(mp.prec + 40):
            middle = (low + high) / 2
            if (mp.cos(middle) - share) / mp.sin(middle) > slope:
                low = middle
            else:
                high = middle
        return (low + high) / 2

    def contact(self, z):
        theta_1 = mp.acos(1 - z / self.r)
        theta_2 = self.exit_ratio * theta_1
        if not (0 < z <= self.r and theta_2 < self.theta_0 < theta_1):
            raise Failure("no room for two zones")
        return Contact(z, theta_1, self.theta_0, theta_2)

    def displacement_front(self, contact, theta):
        t1, t0, skid = contact.theta_1, self.theta_0, 1 + self.i
        k_v = (skid * (mp.sin(t1) - mp.sin(t0)) / (t1 - t0) - 1) / skid
        return self.r * ((t1 - theta) * (1 + k_v * skid) - skid * (mp.sin(t1) - mp.sin(theta)))

    def displacement_rear(self, theta):
        return self.r * ((self.theta_0 - theta)
                         - (1 + self.i) * (mp.sin(self.theta_0) - mp.sin(theta)))

    def zones(self, contact):
        """The panels to integrate over, each with the sign of its shear on the wheel."""
        panels = [(self.theta_0, contact.theta_1, 1)]
        rear = [contact.theta_2, self.theta_0]
        if not self.locked:
            turn = -mp.acos(1 / (1 + self.i))
            if contact.theta_2 < turn:
                rear.insert(1, turn)
                if self.displacement_rear(contact.theta_2) > 0:
                    low, high = contact.theta_2, turn
                    for _ in range(mp.prec + 10):
                        middle = (low + high) / 2
                        low, high = (middle, high) if self.displacement_rear(middle) > 0 else (low, middle)
                    rear.insert(1, low)
                    panels.append((rear[0], low, 1))  # the displacement has turned round
                    rear = rear[1:]
        return panels + [(low, high, -1) for low, high in zip(rear, rear[1:])]

    def integrals(self, contact, rule):
        names = ("sigma_sin", "sigma_cos", "tau_cos", "tau_sin", "tau")
        sums = dict.fromkeys(names, mpf(0))
        magnitudes = dict.fromkeys(names, mpf(0))
        for low, high, sign in self.zones(contact):
            for x, weight in rule:
                theta = low + (high - low) * x
                weight = weight * (high - low)
                cos, sin = mp.cos_sin(theta)
                sigma = self.normal_stress(self.depth(contact, theta)) * weight
                if self.locked:
                    share = mpf(1)
                else:
                    front = low == self.theta_0
                    j = self.displacement_front(contact, theta) if front else self.displacement_rear(theta)
                    share = 1 - mp.exp(-abs(j) / self.K)
                tau = sign * share * (self.c * weight + sigma * self.tan_phi)
                for name, value in zip(names, (sigma * sin, sigma * cos, tau * cos, tau * sin, tau)):
                    sums[name] += value
                    magnitudes[name] += abs(value)
        return sums, magnitudes


def moved(given, s):
    return given | {"slip": s}


def balance(given, load, s, z, rule):
    """Torque and excess of the normal force, each over the load."""
    wheel = BrakingWheel(moved(given, s))
    forces = wheel.quadrature(z, rule)
    return forces["torque_n_m"] / (load * wheel.r_s), forces["normal_force_n"] / load - 1


def towed(given, load, s, z):
    """Skid and sinkage at which a load is carried without a torque, from a first guess."""
    for rule, wanted in ((COARSE, mpf(10) ** -8), (CHECK, BALANCE)):
        for _ in range(60):
            torque, excess = balance(given, load, s, z, rule)
            if max(abs(torque), abs(excess)) < wanted:
                break
            ds, dz = s * mpf(10) ** -18, z * mpf(10) ** -18
            by_s = [(a - b) / ds for a, b in zip(balance(given, load, s + ds, z, rule), (torque, excess))]
            by_z = [(a - b) / dz for a, b in zip(balance(given, load, s, z + dz, rule), (torque, excess))]
            determinant = by_s[0] * by_z[1] - by_z[0] * by_s[1]
            step_s = (torque * by_z[1] - by_z[0] * excess) / determinant
            step_z = (by_s[0] * excess - torque * by_s[1]) / determinant
            share = min(mpf(1), abs(s) / 3 / abs(step_s), z / 5 / abs(step_z))
            s, z = s - share * step_s, z - share * step_z
        else:
            raise Failure("Newton's method does not arrive")
    torque, excess = balance(given, load, s, z, FINE)
    if max(abs(torque), abs(excess)) > AGREEMENT:
        raise Failure("the rules disagree on the balance")
    forces = BrakingWheel(moved(given, s)).quadrature(z)
    return {"normal_load_n": load, "slip": s, "sinkage_m": z,
            "towing_resistance_n": -forces["longitudinal_force_n"]}


def given(r, b, law, c=0.0, phi=0.5, K=0.01, h=0.0, lug=0.5, c3=0.0, radius="rim"):
    return {
        "wheel": {"radius_m": r, "width_m": b, "lug_height_m": h, "lug_coefficient": lug},
        "soil": {"cohesion_pa": c, "friction_angle_rad": phi, "shear_modulus_m": K, "pressure_sinkage": law},
        "contact": {"rule": "midpoint", "c3": c3},
        "normal_stress_radius": radius,
    }


LETTER = given(0.2, 0.1, bekker(-660.0, 754130.0, 0.91), phi=0.478, K=0.005)
LUGGED = given(0.15, 0.12, direct(7.0e5, 0.95, 0.1), c=400.0, h=0.03, lug=1.0, c3=-0.1, radius="shearing")
CLAY = given(0.3, 0.2, reece(15.0, 420.0, 15200.0, 0.7), c=6000.0, phi=0.2, K=0.006)
STIFF = given(0.2, 0.1, bekker(1200.0, 5.0e5, 0.95), c=350.0, phi=0.53, K=1e-5)

# Name, wheel and soil, slip, sinkage.
PLACES = [
    ("letter, slip -0.05", LETTER, -0.05, 0.02),
    ("letter, slip -0.3", LETTER, -0.3, 0.05),
    ("letter, slip -1e-9", LETTER, -1e-9, 0.02),
    ("letter, slip -1e-4", LETTER, -1e-4, 0.02),
    ("letter, slip -0.8", LETTER, -0.8, 0.12),
    ("letter, slip -0.999", LETTER, -0.999, 0.15),
    ("letter, slip -0.999999999", LETTER, -0.999999999, 0.15),
    ("letter, locked", LETTER, -1.0, 0.15),
    ("thin, z/r 1e-6", LETTER, -3e-4, 2e-7),
    ("thin, z/r 1e-4", LUGGED, -2e-3, 1.5e-5),
    ("lugs", LUGGED, -0.2, 0.03),
    ("lugs, locked", LUGGED, -1.0, 0.13),
    ("clay", CLAY, -0.15, 0.06),
    ("clay, deep", CLAY, -0.6, 0.3),
    ("stiff shear", STIFF, -0.1, 0.03),
    ("stiff shear, slip -0.9", STIFF, -0.9, 0.14),
    ("front zone of 1e-5 rad", LETTER, -0.2, None),
    ("friction alone, 1.2 rad", given(0.2, 0.15, direct(7.0e5, 0.95), phi=1.2), -0.1, 0.04),
    ("cohesion alone", given(0.2, 0.15, direct(7.0e5, 0.95), c=1500.0, phi=0.0, c3=-0.2), -0.1, 0.03),
    ("exit at minus entry, displacement turned", given(0.2, 0.12, bekker(500.0, 4.0e5, 0.9), c=100.0, c3=-1.0, K=0.002),
     -0.01, 0.12),
    ("exit ahead of the lowest point", given(0.2, 0.12, bekker(500.0, 4.0e5, 0.9), c=100.0, c3=0.3), -0.25, 0.05),
]

# Name, wheel and soil, load, and near where.
LOADS = [
    ("letter", LETTER, 80.0, -0.08, 0.02),
    ("letter, light", LETTER, 1e-3, -3e-3, 2e-5),
    ("letter, heavy", LETTER, 500.0, -0.25, 0.065),
    ("lugs", LUGGED | {"normal_stress_radius": "rim"}, 60.0, -0.06, 0.012),
    ("clay", CLAY, 900.0, -0.04, 0.006),
]


def doubles(values):
    return {name: float(value) + 0.0 for name, value in values.items()}


def main():
    started, cases = time.monotonic(), []
    for name, place, s, z in PLACES:
        wheel = BrakingWheel(moved(place, s))
        if z is None:
            z = float(wheel.r * (1 - mp.cos(wheel.theta_0 + mpf(10) ** -5)))
        contact = wheel.contact(mpf(z))
        angles = {"entry_rad": contact.theta_1, "maximum_stress_rad": contact.theta_m, "exit_rad": contact.theta_2}
        cases.append({"name": name, "input": moved(place, s) | {"sinkage_m": z},
                      "expected": {"angles": doubles(angles), "quadrature": doubles(wheel.quadrature(mpf(z)))}})
        print(f"{time.monotonic() - started:6.1f} s  {name}", file=sys.stderr)
    for name, place, load, s, z in LOADS:
        cases.append({"name": f"towed, {name}", "input": place, "towed": doubles(towed(place, load, mpf(s), mpf(z)))})
        print(f"{time.monotonic() - started:6.1f} s  towed, {name}: {cases[-1]['towed']}", file=sys.stderr)
    json.dump(cases, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(str(failure))
