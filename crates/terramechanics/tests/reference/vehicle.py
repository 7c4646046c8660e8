#!/usr/bin/env python3
"""A rover on a slope whose wheels turn at one slip, at equal torques, or as they are told.

Run it, with mpmath installed, to write the cases:

    python3 vehicle.py > vehicle.json

All balances are solved at once by Newton's method in all unknowns: the sinkage of every wheel, the slip
of every wheel that turns with others, and the torque that they share or the slope. The loads are those of
springs of one stiffness under a rigid body, whose heave and pitch are unknowns like the others. Forces of
one wheel are those of `reference.py`. Every case is solved with two unlike numbers of nodes, which have to
agree to 1e-14.
"""

import json
import sys

from mpmath import mp, mpf

from reference import Failure, Wheel, gauss_legendre

mp.dps = 34
AGREEMENT = mpf(10) ** -14
RULES = [[((1 + x) / 2, weight / 2) for x, weight in gauss_legendre(order)] for order in (20, 26)]

FIRM = {
    "cohesion_pa": 1000.0, "friction_angle_rad": 0.7, "shear_modulus_m": 0.018,
    "pressure_sinkage": {"law": "bekker", "k_c": 1400.0, "k_phi": 820e3, "n0": 1.0},
}
SOFT = {
    "cohesion_pa": 300.0, "friction_angle_rad": 0.6, "shear_modulus_m": 0.012,
    "pressure_sinkage": {"law": "bekker", "k_c": 900.0, "k_phi": 400e3, "n0": 1.0},
}
NARROW, WIDE = {"radius_m": 0.1, "width_m": 0.06}, {"radius_m": 0.12, "width_m": 0.08}
CONTACT = {"rule": "wong_reece", "c1": 0.4, "c2": 0.2}
STATIONS = [
    {"x_m": 0.4, "wheel": NARROW, "soil": FIRM},
    {"x_m": 0.05, "wheel": WIDE, "soil": FIRM},
    {"x_m": -0.5, "wheel": NARROW, "soil": SOFT},
]


def own(*turnings):
    """The stations, each with what it is told."""
    return [station | turning for station, turning in zip(STATIONS, turnings)]


ROVER = {
    "mass_kg": 20.0, "gravity_m_s2": 1.625, "stations": STATIONS, "drive": "one_slip",
    "centre_of_mass": {"x_m": 0.02, "height_m": 0.2}, "slope_rad": 0.1, "hitch_pull_n": 0.0, "hitch_height_m": 0.0,
}
CASES = {
    "one slip": {},
    "one slip, pull at a high hitch": {"hitch_pull_n": 2.0, "hitch_height_m": 0.3},
    "one slip, pushed downhill at a high hitch": {"slope_rad": -0.15, "hitch_pull_n": -1.0, "hitch_height_m": 0.25},
    "equal torques": {"drive": "equal_torque"},
    "equal torques, steep": {"drive": "equal_torque", "slope_rad": 0.25, "hitch_pull_n": 0.5, "hitch_height_m": 0.1},
    "equal torques, downhill": {"drive": "equal_torque", "slope_rad": -0.2},
    "front brakes, downhill": {"stations": own({"slip": -0.3}, {}, {}), "slope_rad": -0.2},
    "middle spins faster": {"stations": own({}, {"slip": 0.4}, {}), "slope_rad": 0.2},
    "rear rolls freely": {"stations": own({}, {}, {"torque_n_m": 0.0})},
    "middle under a torque": {"stations": own({}, {"torque_n_m": 0.4}, {}), "hitch_pull_n": 1.0},
    "rear rolls freely, the others at equal torques": {
        "stations": own({}, {}, {"torque_n_m": 0.0}), "drive": "equal_torque",
    },
    "rear locked, downhill": {"stations": own({}, {}, {"slip": -1.0}), "slope_rad": -0.25},
    "rear locked, the others at equal torques, downhill": {
        "stations": own({}, {}, {"slip": -1.0}), "drive": "equal_torque", "slope_rad": -0.25,
    },
    "middle locked, steep downhill": {"stations": own({}, {"slip": -1.0}, {}), "slope_rad": -0.45},
    "largest slope with the rear locked": {"stations": own({}, {}, {"slip": -1.0}), "slope_rad": None, "slip_limit": 0.6},
    "largest slope at equal torques": {"drive": "equal_torque", "slope_rad": None, "slip_limit": 0.6},
    "largest slope at one slip, pull at a high hitch": {
        "slope_rad": None, "slip_limit": 0.5, "hitch_pull_n": 1.0, "hitch_height_m": 0.3,
    },
    "largest slope with the rear at a crawl": {"stations": own({}, {}, {"slip": 0.05}), "slope_rad": None, "slip_limit": 0.6},
}


class Rover:
    """The balances of a rover as functions of its unknowns."""

    def __init__(self, given, rule, at_limit=None):
        self.given, self.rule, self.at_limit = given, rule, at_limit
        self.stations = given["stations"]
        self.together = [i for i, of in enumerate(self.stations) if "slip" not in of and "torque_n_m" not in of]
        self.equal = given["drive"] == "equal_torque"

    def unpacked(self, unknowns):
        """Slope, heave and pitch, sinkages, the shared torque and slips.

        Sinkages are unknown by their logarithms and slips by their arc sines, so that no step of Newton's
        method leaves the model.
        """
        left = list(unknowns)
        take = left.pop
        slope = take(0) if self.given["slope_rad"] is None else mpf(self.given["slope_rad"])
        heave, pitch = take(0), take(0)
        sinkages = [mp.exp(take(0)) for _ in self.stations]
        torque = take(0) if self.equal else None
        shared = None
        if not self.equal:
            shared = mpf(self.given["slip_limit"]) if self.given["slope_rad"] is None else mp.sin(take(0))
        slips = []
        for i, of in enumerate(self.stations):
            if "slip" in of:
                slips.append(mpf(of["slip"]))
            elif i in self.together and not self.equal:
                slips.append(shared)
            elif i == self.at_limit:
                slips.append(mpf(self.given["slip_limit"]))
            else:
                slips.append(mp.sin(take(0)))
        if left:
            raise Failure("unknowns are left over")
        return slope, heave, pitch, sinkages, torque, slips

    def start(self, slip):
        count = 0 if self.given["slope_rad"] is not None else 1
        free = sum("torque_n_m" in of for of in self.stations)
        moving = (len(self.together) - (self.at_limit is not None)) if self.equal else (0 if count else 1)
        torque = [mpf("0.2")] if self.equal else []
        if not self.equal:
            slips = [mpf(slip)] * moving + [mpf("-0.05")] * free
        else:
            slips = []
            for i, of in enumerate(self.stations):
                if i in self.together and i != self.at_limit:
                    slips.append(mpf(slip))
                elif "torque_n_m" in of:
                    slips.append(mpf("-0.05"))
        return [mpf(slip)] * count + [mpf(10), mpf(0)] + [mp.log(mpf("0.012"))] * len(self.stations) + torque + slips

    def wheels(self, unknowns):
        _, _, _, sinkages, _, slips = self.unpacked(unknowns)
        found = []
        for of, sinkage, slip in zip(self.stations, sinkages, slips):
            wheel = Wheel({"wheel": of["wheel"], "soil": of["soil"], "slip": slip, "contact": CONTACT})
            found.append(wheel.quadrature(sinkage, self.rule))
        return found

    def balances(self, *unknowns):
        slope, heave, pitch, _, torque, _ = self.unpacked(unknowns)
        given, forces = self.given, self.wheels(unknowns)
        weight = mpf(given["mass_kg"]) * mpf(given["gravity_m_s2"])
        pull, centre = mpf(given["hitch_pull_n"]), given["centre_of_mass"]
        down, along = weight * mp.cos(slope), weight * mp.sin(slope)
        loads = [heave + pitch * mpf(of["x_m"]) for of in self.stations]
        moment = sum(load * mpf(of["x_m"]) for load, of in zip(loads, self.stations))
        sums = [
            sum(loads) - down,
            moment - down * mpf(centre["x_m"]) + along * mpf(centre["height_m"]) + pull * mpf(given["hitch_height_m"]),
            sum(of["longitudinal_force_n"] for of in forces) - along - pull,
        ]
        sums += [of["normal_force_n"] - load for of, load in zip(forces, loads)]
        if self.equal:
            sums += [forces[i]["torque_n_m"] - torque for i in self.together]
        sums += [
            force["torque_n_m"] - mpf(of["torque_n_m"]) for of, force in zip(self.stations, forces) if "torque_n_m" in of
        ]
        return sums


def solved(given, rule):
    """The unknowns, from the first start from which Newton's method comes to rest at a physical point."""
    limits = [None]
    if given["drive"] == "equal_torque" and given["slope_rad"] is None:
        limits = range(len(given["stations"]))
    for at_limit in limits:
        rover = Rover(given, rule, at_limit)
        for slip in ("0.2", "-0.1", "0.05", "0.3", "0.4", "0.5", "0.6"):
            try:
                found = mp.findroot(rover.balances, rover.start(slip), solver="mdnewton", tol=mpf(10) ** -36, maxsteps=14)
            except (Failure, ValueError, ZeroDivisionError, TypeError):
                continue
            slips = rover.unpacked(found)[5]
            limit = mpf(given.get("slip_limit", 1))
            if all(mp.im(x) == 0 for x in found) and all(-1 <= s <= 1 for s in slips):
                if at_limit is None or all(slips[i] <= limit for i in rover.together):
                    return rover, list(found)
    raise Failure("no start leads to a rover")


def case(name, changes):
    given = ROVER | changes
    (_, coarse), (rover, fine) = (solved(given, rule) for rule in RULES)
    for one, other in zip(coarse, fine):
        if abs(one - other) > AGREEMENT * max(abs(other), mpf("1e-3")):
            raise Failure(f"{name}: the rules differ, {mp.nstr(one - other, 3)} of {mp.nstr(other, 8)}")
    slope, heave, pitch, sinkages, _, slips = rover.unpacked(fine)
    wheels = [
        {
            "slip": float(slip), "sinkage_m": float(sinkage), "normal_load_n": float(heave + pitch * mpf(of["x_m"])),
            "longitudinal_force_n": float(force["longitudinal_force_n"]), "torque_n_m": float(force["torque_n_m"]),
        }
        for of, slip, sinkage, force in zip(rover.stations, slips, sinkages, rover.wheels(fine))
    ]
    return {"name": name, "input": given | {"contact": CONTACT}, "expected": {"slope_rad": float(slope), "wheels": wheels}}


def main():
    cases = []
    for name, changes in CASES.items():
        cases.append(case(name, changes))
        print(name, file=sys.stderr)
    json.dump(cases, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
