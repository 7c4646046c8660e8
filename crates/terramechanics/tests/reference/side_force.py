#!/usr/bin/env python3
"""The force across a wheel that moves at a slip angle, in 60-digit arithmetic: a reference to compare with.

Lateral shear and bulldozing as Ishigami et al. (2005, 2007) write them, with both stresses by
themselves or as one stress along the slip velocity (Pavlov & Johnson 2024). The contact, its
stresses and both rules of integration are those of reference.py; here as there nothing is shared
with the code that is checked.

Run it, with mpmath installed, to write the cases:

    python3 side_force.py > side_force_cases.json

The run stops unless two unlike rules of integration agree to 1e-20 on every integral. The bounds
D1 = 4.03 and D2/2 = 2.55 at 37.2 degrees are those printed in the paper of 2005.
"""

import json
import sys

from mpmath import mp, mpf

from reference import AGREEMENT, CHECK, FINE, Failure, Wheel, bekker, direct, result

COUPLINGS = ("independent", "coupled")


def wall_factors(phi):
    """D1 and D2 from the angle of the wedge, as printed."""
    x = mp.pi / 4 - phi / 2
    d1 = mp.cot(x) + mp.tan(x + phi)
    d2 = mp.cot(x) + mp.cot(x) ** 2 / mp.cot(phi)
    return d1, d2


class SidewaysWheel(Wheel):
    def __init__(self, given):
        super().__init__(given)
        soil = given["soil"]
        self.K_y = mpf(soil.get("lateral_shear_modulus_m", soil["shear_modulus_m"]))
        self.gamma = mpf(soil["unit_weight_n_m3"])
        self.beta = mpf(given["slip_angle_rad"])
        self.d1, self.d2 = wall_factors(mpf(soil["friction_angle_rad"]))

    def lateral_displacement(self, contact, theta):
        """The wheel moves sideways by kappa r |tan beta| for every radian that it turns."""
        return self.r * self.kappa * (contact.theta_1 - theta) * abs(mp.tan(self.beta))

    def lateral_share(self, contact, theta):
        if self.locked:
            return mpf(1)
        return 1 - mp.exp(-self.lateral_displacement(contact, theta) / self.K_y)

    def shares(self, contact, theta, coupling):
        """Shares of the strength along the rim, signed, and across it, not signed."""
        if coupling == "independent":
            return self.mobilisation(contact, theta), self.lateral_share(contact, theta)
        if self.locked:
            along, across = -mp.cos(theta), abs(mp.tan(self.beta))
            return along / mp.hypot(along, across), across / mp.hypot(along, across)
        j_x = self.shear_displacement(contact, theta)
        j_y = self.lateral_displacement(contact, theta)
        mobilised = 1 - mp.exp(-mp.hypot(j_x / self.K, j_y / self.K_y))
        v_x = 1 - self.kappa * mp.cos(theta)
        v_y = self.kappa * abs(mp.tan(self.beta))
        speed = mp.hypot(v_x, v_y)
        return mp.sign(j_x) * mobilised * abs(v_x) / speed, mobilised * v_y / speed

    def wall(self, contact, theta):
        """R_b (r - h cos theta), N per radian."""
        h = self.r * (mp.cos(theta) - mp.cos(contact.theta_1))
        resistance = self.d1 * (self.c * h + self.d2 * self.gamma * h * h / 2)
        return resistance * (self.r - h * mp.cos(theta))

    def sums(self, contact, coupling, rule):
        names = ("sigma_sin", "sigma_cos", "tau_cos", "tau_sin", "tau",
                 "tau_y", "tau_y_sin", "wall", "wall_sin", "part", "part_sin")
        sums, sizes = dict.fromkeys(names, mpf(0)), dict.fromkeys(names, mpf(0))
        points = set(self.breakpoints(contact))
        if contact.theta_2 < 0 < contact.theta_1:
            points.add(mpf(0))  # the slip velocity of a driving wheel is least there
        points = sorted(points)
        for low, high in zip(points, points[1:]):
            for x, weight in rule:
                theta = low + (high - low) * x
                weight = weight * (high - low)
                cos, sin = mp.cos_sin(theta)
                sigma = self.normal_stress(self.depth(contact, theta))
                strength = self.c + sigma * self.tan_phi
                along, across = self.shares(contact, theta, coupling)
                tau, tau_y, wall = along * strength, across * strength, self.wall(contact, theta)
                part = wall * self.lateral_share(contact, theta)
                values = (sigma * sin, sigma * cos, tau * cos, tau * sin, tau,
                          tau_y, tau_y * sin, wall, wall * sin, part, part * sin)
                for name, value in zip(names, values):
                    sums[name] += weight * value
                    sizes[name] += weight * abs(value)
        return sums, sizes

    def forces(self, z, coupling):
        contact = self.contact(z)
        sums, sizes = self.sums(contact, coupling, FINE)
        others, _ = self.sums(contact, coupling, CHECK)
        for name, value in sums.items():
            if abs(value - others[name]) > AGREEMENT * sizes[name]:
                raise Failure(f"{name}: off by {mp.nstr(abs(value - others[name]) / sizes[name], 3)}")
        sign, area = mp.sign(self.beta), self.r_s * self.b
        answer = result(
            traction=area * sums["tau_cos"],
            resistance=self.r_n * self.b * sums["sigma_sin"],
            normal_support=self.r_n * self.b * sums["sigma_cos"],
            shear_support=area * sums["tau_sin"],
            torque=self.r_s * area * sums["tau"],
        )
        for bulldozing, key in (("full", "wall"), ("mobilised", "part")):
            lateral = sign * (area * sums["tau_y"] + sums[key])
            moment = self.r_s * area * sums["tau_y_sin"] + self.r * sums[key + "_sin"]
            answer[bulldozing] = {
                "lateral_force_n": lateral,
                "overturning_moment_n_m": self.r * lateral,
                "aligning_moment_n_m": sign * moment,
            }
        return answer


def as_doubles(values):
    return {k: as_doubles(v) if isinstance(v, dict) else float(v) + 0.0 for k, v in values.items()}


def case(name, s, beta, r=0.2, b=0.1, z=0.02, law=None, contact=None, c=0.0, phi=0.5, K=0.01,
         K_y=None, gamma=15000.0, h=0.0, radius="rim"):
    soil = {"cohesion_pa": c, "friction_angle_rad": phi, "shear_modulus_m": K,
            "unit_weight_n_m3": gamma, "pressure_sinkage": law or bekker(-660.0, 754130.0, 0.91)}
    if K_y is not None:
        soil["lateral_shear_modulus_m"] = K_y
    given = {
        "wheel": {"radius_m": r, "width_m": b, "lug_height_m": h, "lug_coefficient": 0.5},
        "soil": soil,
        "contact": contact or {"rule": "midpoint", "c3": 0.0},
        "slip": s,
        "sinkage_m": z,
        "normal_stress_radius": radius,
        "slip_angle_rad": beta,
    }
    try:
        wheel = SidewaysWheel(given)
        answers = {each: as_doubles(wheel.forces(mpf(z), each)) for each in COUPLINGS}
    except Failure as failure:
        sys.exit(f"{name}: {failure}")
    print(name, file=sys.stderr)
    return {"name": name, "input": given, "expected": answers}


def cases():
    wong_reece = {"rule": "wong_reece", "c1": 0.4, "c2": 0.15, "c3": -0.3}
    simulant = {"c": 800.0, "phi": 0.649262, "K": 0.0185, "gamma": 15690.0,
                "law": bekker(1370.0, 814000.0, 1.0), "contact": wong_reece, "r": 0.09}
    return [
        case("the letter's wheel", 0.2, 0.1),
        case("to the other side", 0.2, -0.1),
        case("rolling", 0.0, 0.15),
        case("rolling, exit behind", 0.0, 0.1, contact=wong_reece),
        case("little slip and angle", 0.01, 0.01, contact=wong_reece),
        case("spinning on the spot", 1.0, 0.3),
        case("large angle", 0.3, 1.4, c=2000.0),
        case("simulant, smooth wheel", 0.2, 0.27925268, z=0.015, **simulant),
        case("lugs and cohesion", 0.4, 0.3, h=0.03, c=1500.0, K_y=0.018, radius="shearing"),
        case("moduli that differ", 0.15, 0.2, K=0.005, K_y=0.03, contact=wong_reece),
        case("stiff shear", 0.1, 0.05, K=1e-5),
        case("shallow", 0.25, 0.2, z=2e-6, K=1e-4),
        case("deep", 0.5, 0.4, z=0.2, law=direct(2e5, 0.6), c=500.0, contact=wong_reece),
        case("braking a little", -0.03, 0.1, contact=wong_reece),
        case("braking", -0.1, 0.2, c=300.0),
        case("braking hard", -0.6, 0.1, h=0.02),
        case("braking, small angle", -0.05, 0.001),
        case("locked", -1.0, 0.2, c=300.0, contact=wong_reece),
    ]


if __name__ == "__main__":
    d1, d2 = wall_factors(mp.radians(mpf("37.2")))
    assert abs(d1 - mpf("4.03")) < 0.005 and abs(d2 / 2 - mpf("2.55")) < 0.005
    json.dump(cases(), sys.stdout, indent=1)
    print()
