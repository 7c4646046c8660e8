#!/usr/bin/env python3
"""Wheels with lugs whose slip and displacement are counted on several circles, in 60-digit arithmetic: a reference to compare with.

The displacement is counted on a circle of its own, from where that enters the soil; the slip compares the speed of travel with that
of another. Exits by the ratio of the sinkages behind and ahead, and interfaces in place of the soil's strength, are here as well.
The contact, its stresses and both rules of integration are those of reference.py, the force across is that of side_force.py and the
two zones those of two_zones.py; nothing is shared with the code that is checked.

Run it, with mpmath installed, to write the cases:

    python3 circles.py > circles.json

The run stops unless two unlike rules of integration agree to 1e-20 on every integral.
"""

import json
import sys

from mpmath import mp, mpf

from reference import Contact, Wheel, bekker
from side_force import COUPLINGS, SidewaysWheel, as_doubles
from two_zones import BrakingWheel


class OnCircles:
    """What the circles, the exit and the interface change of a wheel."""

    def __init__(self, given):
        super().__init__(given)
        tip = self.r + mpf(given["wheel"]["lug_height_m"])
        radii = {"rim": self.r, "shearing": self.r_s, "lug_tip": tip}
        self.r_j, r_slip = radii[given["shear_displacement_radius"]], radii[given["slip_radius"]]
        if not self.locked:
            self.travel = (1 - self.s) * r_slip if self.s >= 0 else r_slip / (1 + self.s)
            self.kappa = self.travel / self.r_j
        self.own_cohesion = given["soil"]["cohesion_pa"]
        interface = given["contact"].get("interface")
        if interface:
            self.c, self.K = mpf(interface["adhesion_pa"]), mpf(interface["shear_modulus_m"])
            self.K_y = self.K
            self.tan_phi = mp.tan(mpf(interface["friction_angle_rad"]))

    def contact(self, z):
        contact = super().contact(z)
        if "exit" in self.rule:
            exit_angle = -mp.acos(1 - mpf(self.rule["exit"]["ratio"]) * z / self.r)
            peak = contact.theta_m if self.rule["rule"] != "midpoint" else (contact.theta_1 + exit_angle) / 2
            contact = Contact(z, contact.theta_1, peak, exit_angle)
        return contact

    def entry(self, contact):
        """Where the circle of the displacement enters the soil."""
        return mp.acos((self.r - contact.z) / self.r_j)

    def shear_displacement(self, contact, theta):
        entry = self.entry(contact)
        return self.r_j * (entry - theta) - self.travel * (mp.sin(entry) - mp.sin(theta))

    def lateral_displacement(self, contact, theta):
        return self.travel * (self.entry(contact) - theta) * abs(mp.tan(self.beta))


class LuggedWheel(OnCircles, Wheel):
    pass


class SidewaysLuggedWheel(OnCircles, SidewaysWheel):
    """The soil beside the wheel fails in itself, whatever the interface with the rim."""

    def wall(self, contact, theta):
        adhesion, self.c = self.c, mpf(self.own_cohesion)
        resistance = super().wall(contact, theta)
        self.c = adhesion
        return resistance


class BrakingLuggedWheel(OnCircles, BrakingWheel):
    """Its skid is that of the circle of the displacement."""

    def __init__(self, given):
        super().__init__(given)
        phi = mpf(given["soil"]["friction_angle_rad"])
        self.i = None if self.locked else self.kappa - 1
        self.theta_0 = self.parting_angle(mp.tan(mp.pi / 4 - phi / 2))

    def skids(self):
        return True  # whether its circle does, the parting angle tells

    def displacement_front(self, contact, theta):
        t1, t0 = self.entry(contact), self.theta_0
        chord = (mp.sin(t1) - mp.sin(t0)) / (t1 - t0)
        return self.travel * ((t1 - theta) * chord - (mp.sin(t1) - mp.sin(theta)))

    def displacement_rear(self, theta):
        return self.r_j * (self.theta_0 - theta) - self.travel * (mp.sin(self.theta_0) - mp.sin(theta))


MIDPOINT = {"rule": "midpoint", "c3": 0.0}
BEHIND = {"rule": "wong_reece", "c1": 0.35, "c2": 0.1, "c3": -1.2}
RAISED = {"rule": "wong_reece", "c1": 0.4, "c2": 0.15, "exit": {"ratio": 1.15}}
SLIPPERY = {"friction_angle_rad": 0.4, "adhesion_pa": 50.0, "shear_modulus_m": 0.004}


def given(s, z, slip, displacement, contact=MIDPOINT, r=0.157, b=0.165, h=0.01, coefficient=0.5, c=250.0, phi=0.5568, K=0.0114,
          **rest):
    return {
        "wheel": {"radius_m": r, "width_m": b, "lug_height_m": h, "lug_coefficient": coefficient},
        "soil": {"cohesion_pa": c, "friction_angle_rad": phi, "shear_modulus_m": K, "unit_weight_n_m3": 16000.0,
                 "pressure_sinkage": bekker(15600.0, 2407400.0, 1.1)},
        "contact": contact,
        "slip": s,
        "sinkage_m": z,
        "slip_radius": slip,
        "shear_displacement_radius": displacement,
    } | rest


def along(name, **values):
    """All three methods."""
    case = given(**values)
    wheel, z = LuggedWheel(case), mpf(case["sinkage_m"])
    contact = wheel.contact(z)
    angles = {"entry_rad": contact.theta_1, "maximum_stress_rad": contact.theta_m, "exit_rad": contact.theta_2}
    answers = {method: getattr(wheel, method)(z) for method in ("quadrature", "linearised", "explicit")}
    return {"name": name, "input": case, "expected": as_doubles(answers | {"angles": angles})}


def across(name, **values):
    """Quadrature at a slip angle, by both couplings."""
    case = given(**values)
    wheel = SidewaysLuggedWheel(case)
    answers = {each: wheel.forces(mpf(case["sinkage_m"]), each) for each in COUPLINGS}
    return {"name": name, "input": case, "expected": as_doubles(answers)}


def two_zones(name, **values):
    """Quadrature of a braking wheel with two zones."""
    case = given(**values) | {"braking": "two_zone"}
    answer = BrakingLuggedWheel(case).quadrature(mpf(case["sinkage_m"]))
    return {"name": name, "input": case, "expected": as_doubles({"quadrature": answer})}


def cases():
    yield along("shearing circle, slip of the rim", s=0.1, z=0.012, slip="rim", displacement="shearing")
    yield along("rolling on the rim", s=0.0, z=0.012, slip="rim", displacement="shearing")
    yield along("rolling on the lug tips", s=0.0, z=0.03, slip="lug_tip", displacement="shearing")
    yield along("driving on the tips, skidding on the rim", s=0.02, z=0.02, slip="lug_tip", displacement="rim")
    yield along("braking on the rim, driving on the shearing circle", s=-0.02, z=0.02, slip="rim", displacement="shearing")
    yield along("braking a little more", s=-0.05, z=0.03, slip="rim", displacement="shearing", contact=BEHIND)
    yield along("braking hard", s=-0.7, z=0.03, slip="lug_tip", displacement="shearing")
    yield along("locked", s=-1.0, z=0.03, slip="shearing", displacement="shearing")
    yield along("on the spot", s=1.0, z=0.05, slip="lug_tip", displacement="shearing")
    yield along("to the axle", s=0.3, z=0.157, slip="rim", displacement="shearing", contact=BEHIND)
    yield along("lugs far above the sinkage", s=0.1, z=1e-6, slip="rim", displacement="shearing", h=0.03)
    yield along("lugs far below the sinkage", s=0.1, z=0.02, slip="rim", displacement="shearing", h=1e-9)
    yield along("lugs far below a light contact", s=0.0, z=1e-6, slip="rim", displacement="shearing", h=1e-10)
    yield along("stiff shear", s=0.2, z=0.02, slip="rim", displacement="shearing", K=1e-5)
    yield along("whole lugs", s=0.2, z=0.02, slip="rim", displacement="shearing", coefficient=1.0, h=0.03)
    yield along("exit by ratio", s=0.4, z=0.011, slip="rim", displacement="shearing", contact=RAISED)
    yield along("exit by ratio, to the axle", s=0.1, z=0.157, slip="shearing", displacement="shearing", contact=RAISED)
    yield along("exit by ratio, braking", s=-0.2, z=0.03, slip="rim", displacement="shearing", contact=RAISED)
    yield along("interface", s=0.2, z=0.015, slip="rim", displacement="shearing", contact=MIDPOINT | {"interface": SLIPPERY})
    yield along("interface, braking", s=-0.1, z=0.015, slip="rim", displacement="rim", contact=RAISED | {"interface": SLIPPERY})

    yield across("sideways", s=0.2, z=0.02, slip="rim", displacement="shearing", slip_angle_rad=0.2)
    yield across("sideways on the tips", s=0.02, z=0.02, slip="lug_tip", displacement="shearing", slip_angle_rad=-0.3)
    yield across("sideways, braking", s=-0.1, z=0.02, slip="rim", displacement="shearing", slip_angle_rad=0.1, contact=BEHIND)
    yield across("sideways, interface", s=0.3, z=0.02, slip="shearing", displacement="shearing", slip_angle_rad=0.2,
                 contact=RAISED | {"interface": SLIPPERY})
    yield across("sideways, locked", s=-1.0, z=0.02, slip="rim", displacement="shearing", slip_angle_rad=0.2)

    yield two_zones("two zones, slip of the rim", s=-0.1, z=0.03, slip="rim", displacement="shearing")
    yield two_zones("two zones, slip of the tips", s=-0.02, z=0.03, slip="lug_tip", displacement="shearing", contact=BEHIND)
    yield two_zones("two zones, driving on the tips", s=0.01, z=0.03, slip="lug_tip", displacement="shearing")
    yield two_zones("two zones, locked", s=-1.0, z=0.1, slip="rim", displacement="shearing")


if __name__ == "__main__":
    answers = []
    for case in cases():
        print(case["name"], file=sys.stderr)
        answers.append(case)
    json.dump(answers, sys.stdout, indent=1)
    print()
