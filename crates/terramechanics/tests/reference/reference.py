#!/usr/bin/env python3
"""Forces of a rigid wheel on soil in 60-digit arithmetic: a reference to compare with.

The equations are those of the letter "Improving engineering models of terramechanics for
planetary exploration" with the project's errata; equation numbers below are the letter's.
Nothing here is shared with the code it checks, and nothing is tuned for speed: formulas stand as
they are written, and cancellation is met with digits instead of with algebra.

Run it, with mpmath installed, to write the cases at the edges of the model:

    python3 reference.py > edge_cases.json

Every case has a `name`, an `input` and an `expected`; the field names are those of the HTTP API.
An input is read as the exact value of its doubles. A result is printed as the shortest decimal
that reads back as the double nearest to it.

The integrals (10) are computed by two unlike rules, and the run stops unless these agree to
1e-20. So does a solved sinkage that does not bracket its load to 1e-18, or a load that some
method does not carry, or meets at more than one sinkage.
"""

import json
import sys
import time

from mpmath import mp, mpf

mp.dps = 60

METHODS = ("quadrature", "linearised", "explicit")
AGREEMENT = mpf(10) ** -20
BRACKET = mpf(10) ** -18


class Failure(Exception):
    """The reference cannot vouch for a number."""


# --------------------------------------------------------------------------------------------------
# Quadrature rules: lists of (x, weight) on (0, 1)
# --------------------------------------------------------------------------------------------------


def gauss_legendre(order):
    """Nodes and weights on (-1, 1), by Newton's method on the recurrence of the polynomials."""
    nodes = []
    for i in range(order):
        x = mp.cos(mp.pi * (i + mpf(3) / 4) / (order + mpf(1) / 2))
        for _ in range(12):
            previous, value = mpf(1), x
            for k in range(2, order + 1):
                previous, value = value, ((2 * k - 1) * x * value - (k - 1) * previous) / k
            slope = order * (x * value - previous) / (x * x - 1)
            x -= value / slope
        nodes.append((x, 2 / ((1 - x * x) * slope * slope)))
    return nodes


def graded_gauss(order, panel, reach):
    """Gauss-Legendre on panels that shrink geometrically towards both ends.

    With the distance from an end written exp(-y)/2, the panels are of equal length in y. A power
    of the distance, or an exponential boundary layer of any thickness, is smooth in y. What lies
    nearer to an end than exp(-reach)/2 is left out.
    """
    rule = []
    panels = int(mp.ceil(mpf(reach) / panel))
    for x, weight in gauss_legendre(order):
        for k in range(panels):
            distance = mp.exp(-panel * (k + (1 + x) / 2)) / 2
            share = weight * panel / 2 * distance
            rule += [(distance, share), (1 - distance, share)]
    return rule


def tanh_sinh(step, reach):
    """The double exponential rule: x = 1 / (1 + exp(pi sinh t)), by the trapezoidal rule in t."""
    rule = []
    count = int(mpf(reach) / step)
    for k in range(-count, count + 1):
        t = k * step
        x = 1 / (1 + mp.exp(mp.pi * mp.sinh(t)))
        rule.append((x, step * mp.pi * mp.cosh(t) * x * (1 - x)))
    return rule


FINE = graded_gauss(order=30, panel=mpf("1.25"), reach=52)
CHECK = tanh_sinh(step=mpf(1) / 72, reach=mpf("3.7"))
COARSE = graded_gauss(order=10, panel=mpf(3), reach=27)  # for scans and first guesses only
COARSE_DIGITS = 34


# --------------------------------------------------------------------------------------------------
# The model
# --------------------------------------------------------------------------------------------------


class Contact:
    """Angles of the contact at one sinkage: entry, maximum stress, exit."""

    def __init__(self, z, theta_1, theta_m, theta_2):
        self.z, self.theta_1, self.theta_m, self.theta_2 = z, theta_1, theta_m, theta_2


class Wheel:
    """One wheel on one soil at one slip; every method below takes the sinkage z."""

    def __init__(self, given):
        wheel, soil = given["wheel"], given["soil"]
        self.r = mpf(wheel["radius_m"])
        self.b = mpf(wheel["width_m"])
        lug_height = mpf(wheel.get("lug_height_m", 0))
        lug_coefficient = mpf(wheel.get("lug_coefficient", 0.5))
        self.r_s = self.r + lug_coefficient * lug_height  # (9)
        self.r_n = {"rim": self.r, "shearing": self.r_s}[given.get("normal_stress_radius", "rim")]

        self.s = mpf(given["slip"])
        self.locked = self.s == -1
        if self.locked:
            self.kappa = None
        elif self.s >= 0:
            self.kappa = 1 - self.s
        else:
            self.kappa = 1 / (1 + self.s)

        self.c = mpf(soil["cohesion_pa"])
        self.tan_phi = mp.tan(mpf(soil["friction_angle_rad"]))
        self.K = mpf(soil["shear_modulus_m"])
        law = soil["pressure_sinkage"]
        self.N = mpf(law["n0"]) + mpf(law.get("n1", 0)) * self.s
        self.K_s = self.sinkage_modulus(law)

        self.rule = given.get("contact", {"rule": "midpoint"})
        self.peak_sinkage = given.get("peak_sinkage")
        self.lambda_a = given.get("lambda_a", 0)
        self.lambda_b = given.get("lambda_b", 0)
        if not (self.K_s > 0 and self.N > 0 and -1 <= self.s <= 1):
            raise Failure("outside the model")

    def sinkage_modulus(self, law):
        """K_s of (1), in Pa/m^N."""
        if law["law"] == "bekker":
            return mpf(law["k_c"]) / self.b + mpf(law["k_phi"])
        if law["law"] == "direct":
            return mpf(law["k_s"])
        if law["law"] == "reece":
            strength = (self.c * mpf(law["k_c"])
                        + mpf(law["unit_weight_n_m3"]) * self.b * mpf(law["k_phi"]))
            return strength / self.b ** self.N
        if law["law"] == "diameter":
            return mpf(law["k"]) * (2 * self.r) ** mpf(law["m"])
        raise Failure("unknown law " + law["law"])

    def contact(self, z):
        if not 0 < z <= self.r:
            raise Failure("sinkage outside (0, r]")
        theta_1 = mp.acos(1 - z / self.r)
        theta_2 = mpf(self.rule.get("c3", 0)) * theta_1
        if self.rule["rule"] == "midpoint":
            theta_m = (theta_1 + theta_2) / 2
        elif self.rule["rule"] == "wong_reece":
            theta_m = (mpf(self.rule["c1"]) + mpf(self.rule["c2"]) * self.s) * theta_1
        elif self.rule["rule"] == "half_sinkage":
            theta_m = mp.acos(1 - z / (2 * self.r))
        else:
            raise Failure("unknown rule " + self.rule["rule"])
        if not theta_2 < theta_m < theta_1:
            raise Failure("the maximum stress does not lie inside the contact")
        return Contact(z, theta_1, theta_m, theta_2)

    def depth(self, contact, theta):
        """Depth of a rim point, (3) in front of the maximum and (4) behind it."""
        if theta < contact.theta_m:
            behind = (theta - contact.theta_2) / (contact.theta_m - contact.theta_2)
            theta = contact.theta_1 - behind * (contact.theta_1 - contact.theta_m)
        depth = self.r * (mp.cos(theta) - mp.cos(contact.theta_1))
        return max(depth, mpf(0))  # the last digit may fall below zero at the very ends

    def normal_stress(self, depth):
        """(1)"""
        return self.K_s * depth ** self.N

    def shear_displacement(self, contact, theta):
        """j of (6), negative where the rim is dragged forwards over the soil."""
        return self.r * ((contact.theta_1 - theta)
                         - self.kappa * (mp.sin(contact.theta_1) - mp.sin(theta)))

    def mobilisation(self, contact, theta):
        """E: the share of the shear strength that is mobilised, with the sign of j."""
        if self.locked:
            return mpf(-1)
        j = self.shear_displacement(contact, theta)
        return mp.sign(j) * (1 - mp.exp(-abs(j) / self.K))

    def shear_stress(self, normal_stress, mobilisation):
        """(5)"""
        return mobilisation * (self.c + normal_stress * self.tan_phi)

    # ------------------------------------------------------------------------- the three methods

    def breakpoints(self, contact):
        """The ends of the contact and every angle inside at which a stress is not smooth.

        j turns only where cos(theta) = 1/kappa, so at most twice, and between its turning points
        it changes sign at most once. The turning points are returned as well: near one of them j
        may come close to zero without reaching it.
        """
        points = {contact.theta_2, contact.theta_m, contact.theta_1}
        if self.locked or self.kappa < 1:
            return sorted(points)
        turn = mp.acos(1 / self.kappa)
        turns = [x for x in (-turn, turn) if contact.theta_2 < x < contact.theta_1]
        stations = [contact.theta_2, *turns, contact.theta_1]
        for low, high in zip(stations, stations[1:]):
            at_low = self.shear_displacement(contact, low)
            if at_low * self.shear_displacement(contact, high) >= 0:
                continue
            for _ in range(mp.prec + 10):
                middle = (low + high) / 2
                if at_low * self.shear_displacement(contact, middle) > 0:
                    low = middle
                else:
                    high = middle
            points.add((low + high) / 2)
        return sorted(points | set(turns))

    def integrals(self, contact, rule):
        """The integrals of (10) over the contact, and the same of the integrands' magnitudes."""
        names = ("sigma_sin", "sigma_cos", "tau_cos", "tau_sin", "tau")
        sums = dict.fromkeys(names, mpf(0))
        magnitudes = dict.fromkeys(names, mpf(0))
        points = self.breakpoints(contact)
        for low, high in zip(points, points[1:]):
            for x, weight in rule:
                theta = low + (high - low) * x
                weight = weight * (high - low)
                cos, sin = mp.cos_sin(theta)
                sigma = self.normal_stress(self.depth(contact, theta)) * weight
                # The weight stands for d(theta): it multiplies the cohesion as well.
                tau = self.mobilisation(contact, theta) * (self.c * weight + sigma * self.tan_phi)
                for name, value in zip(
                    names, (sigma * sin, sigma * cos, tau * cos, tau * sin, tau)
                ):
                    sums[name] += value
                    magnitudes[name] += abs(value)
        return sums, magnitudes

    def quadrature(self, z, rule=None):
        """(10). Without a rule: by both fine rules, which have to agree.

        What they cannot tell from zero is zero: at theta_2 = -theta_1 and theta_m = 0 the normal
        stress is symmetric, and its resistance vanishes.
        """
        contact = self.contact(z)
        sums, magnitudes = self.integrals(contact, rule or FINE)
        if rule is None:
            others, _ = self.integrals(contact, CHECK)
            for name, value in sums.items():
                if abs(value - others[name]) > AGREEMENT * magnitudes[name]:
                    deviation = abs(value - others[name]) / magnitudes[name]
                    raise Failure(f"{name}: the rules differ by {mp.nstr(deviation, 3)}")
                if abs(value) < AGREEMENT * magnitudes[name]:
                    sums[name] = mpf(0)
        return result(
            traction=self.r_s * self.b * sums["tau_cos"],
            resistance=self.r_n * self.b * sums["sigma_sin"],
            normal_support=self.r_n * self.b * sums["sigma_cos"],
            shear_support=self.r_s * self.b * sums["tau_sin"],
            torque=self.r_s ** 2 * self.b * sums["tau"],
        )

    def shape_integrals(self, contact):
        """A, B and H of (12), exact for stresses that rise and fall linearly."""
        t1, tm, t2 = contact.theta_1, contact.theta_m, contact.theta_2
        a = (mp.cos(tm) - mp.cos(t2)) / (tm - t2) + (mp.cos(tm) - mp.cos(t1)) / (t1 - tm)
        b = (mp.sin(tm) - mp.sin(t2)) / (tm - t2) + (mp.sin(tm) - mp.sin(t1)) / (t1 - tm)
        return a, b, (t1 - t2) / 2

    def peak_stresses(self, contact, default):
        """sigma and tau at the angle of maximum stress, and E there."""
        if (self.peak_sinkage or default) == "half":
            z_m = contact.z / 2  # (8)
        else:
            z_m = self.r * (mp.cos(contact.theta_m) - mp.cos(contact.theta_1))
        sigma = self.normal_stress(z_m)
        return sigma, self.shear_stress(sigma, self.mobilisation(contact, contact.theta_m))

    def linearised(self, z):
        """(11)"""
        contact = self.contact(z)
        a, b, h = self.shape_integrals(contact)
        sigma, tau = self.peak_stresses(contact, default="geometric")
        x, y = self.r_n * self.b * sigma, self.r_s * self.b * tau
        return result(a * y, b * x, a * x, b * y, torque=self.r_s * h * y)

    def explicit(self, z):
        """(14) to (17)"""
        contact = self.contact(z)
        exact_a, exact_b, _ = self.shape_integrals(contact)
        half = z / (2 * self.r)
        lambda_a, lambda_b = self.lambda_a, self.lambda_b
        lambda_a = 1 - exact_a / mp.sqrt(half) if lambda_a == "exact" else mpf(lambda_a)
        lambda_b = exact_b / half - 1 if lambda_b == "exact" else mpf(lambda_b)
        a, b = (1 - lambda_a) * mp.sqrt(half), (1 + lambda_b) * half  # (14)
        sigma, tau = self.peak_stresses(contact, default="half")
        x, y = self.r_n * self.b * sigma, self.r_s * self.b * tau
        torque = self.r_s ** 2 / 2 * self.b * contact.theta_1 * tau  # (17)
        return result(a * y, b * x, a * x, b * y, torque)

    # ----------------------------------------------------------------- the sinkage under a load

    def sinkage_for_load(self, load, method):
        """The one z in (0, r] at which F_z is the load."""

        def excess(z, rule=CHECK):
            arguments = (z, rule) if method == "quadrature" else (z,)
            return getattr(self, method)(*arguments)["normal_force_n"] - load

        with mp.workdps(COARSE_DIGITS):
            # Four sinkages a decade from 1e-9 r to 0.1 r, then steps of 0.05 r up to r.
            scan = [self.r * mpf(10) ** (mpf(k) / 4 - 9) for k in range(32)]
            scan += [self.r * k / 20 for k in range(2, 20)] + [self.r]
            values = [excess(z, COARSE) for z in scan]
            if values[-1] <= 0:
                raise Failure(f"{method} does not carry {load} N")
            crossings = [i for i in range(1, len(scan)) if (values[i - 1] < 0) != (values[i] < 0)]
            if len(crossings) != 1:
                raise Failure(f"{method} meets {load} N at {len(crossings)} sinkages")
            low, high = scan[crossings[0] - 1], scan[crossings[0]]
            guess = illinois(lambda z: excess(z, COARSE), low, high)

        z, last = guess, guess * (1 + mpf(10) ** -7)
        value, last_value = excess(z), excess(last)
        for _ in range(12):  # secant
            step = value * (z - last) / (value - last_value)
            last, last_value = z, value
            z = z - step
            if abs(step) < z * mpf(10) ** -22:
                break
            value = excess(z)
        if not (excess(z * (1 - BRACKET), FINE) < 0 < excess(z * (1 + BRACKET), FINE)):
            raise Failure(f"{method} did not settle on a sinkage for {load} N")
        return z


def result(traction, resistance, normal_support, shear_support, torque):
    """The forces with their four parts: traction AY, resistance BX, supports AX and BY."""
    return {
        "longitudinal_force_n": traction - resistance,
        "normal_force_n": normal_support + shear_support,
        "torque_n_m": torque,
        "traction_n": traction,
        "resistance_n": resistance,
        "normal_support_n": normal_support,
        "shear_support_n": shear_support,
    }


def illinois(function, low, high):
    """A root to about twelve digits, by false position with Illinois' halving."""
    at_low, at_high = function(low), function(high)
    for _ in range(100):
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        value = function(middle)
        if value == 0:
            return middle
        if (value < 0) != (at_high < 0):
            low, at_low = high, at_high
        else:
            at_low /= 2
        done = abs(middle - high) < abs(middle) * mpf(10) ** -12
        high, at_high = middle, value
        if done:
            break
    return high


def expected(given, load=None):
    """Everything a case expects, as doubles."""
    wheel, z = Wheel(given), mpf(given["sinkage_m"])
    contact = wheel.contact(z)
    answer = {method: getattr(wheel, method)(z) for method in METHODS}
    answer["angles"] = {
        "entry_rad": contact.theta_1,
        "maximum_stress_rad": contact.theta_m,
        "exit_rad": contact.theta_2,
    }
    if load is not None:
        answer["sinkage_for_load"] = {"normal_load_n": load} | {
            method: wheel.sinkage_for_load(mpf(load), method) for method in METHODS
        }
    return {
        block: {name: float(value) + 0.0 for name, value in values.items()}  # no negative zero
        for block, values in answer.items()
    }


# --------------------------------------------------------------------------------------------------
# The cases
# --------------------------------------------------------------------------------------------------


def bekker(k_c, k_phi, n0, n1=0.0):
    return {"law": "bekker", "k_c": k_c, "k_phi": k_phi, "n0": n0, "n1": n1}


def direct(k_s, n0, n1=0.0):
    return {"law": "direct", "k_s": k_s, "n0": n0, "n1": n1}


def reece(k_c, k_phi, unit_weight, n0, n1=0.0):
    return {"law": "reece", "k_c": k_c, "k_phi": k_phi, "unit_weight_n_m3": unit_weight,
            "n0": n0, "n1": n1}


def diameter(k, m, n0, n1=0.0):
    return {"law": "diameter", "k": k, "m": m, "n0": n0, "n1": n1}


def midpoint(c3=0.0):
    return {"rule": "midpoint", "c3": c3}


def wong_reece(c1, c2, c3=0.0):
    return {"rule": "wong_reece", "c1": c1, "c2": c2, "c3": c3}


def half_sinkage(c3=0.0):
    return {"rule": "half_sinkage", "c3": c3}


CASES = []


def case(name, r, b, z, s, law, contact, c=0.0, phi=0.5, K=0.01, h=0.0, lug=0.5,
         radius="rim", peak=None, la=0.0, lb=0.0, load_at=None):
    """One case. `load_at` is the z/r near which the wheel carries the load to be solved for."""
    given = {
        "wheel": {"radius_m": r, "width_m": b, "lug_height_m": h, "lug_coefficient": lug},
        "soil": {"cohesion_pa": c, "friction_angle_rad": phi, "shear_modulus_m": K,
                 "pressure_sinkage": law},
        "contact": contact,
        "slip": s,
        "sinkage_m": z,
        "normal_stress_radius": radius,
    }
    if peak is not None:
        given["peak_sinkage"] = peak
    given |= {"lambda_a": la, "lambda_b": lb}
    CASES.append((name, given, load_at))


def braking_slip(r, z, angle):
    """The double nearest to the slip at which j changes sign at the angle, given theta_1."""
    theta_1 = mp.acos(1 - mpf(z) / mpf(r))
    theta = angle(theta_1)
    return float((mp.sin(theta_1) - mp.sin(theta)) / (theta_1 - theta) - 1)


def shallow_cases():
    """z/r from 1e-6 to 1e-3 with every contact rule: driving, free of slip, braking."""
    firm, loose = bekker(-660.0, 754130.0, 0.91), direct(2.1e6, 1.1, 0.3)
    weighed, scaled = reece(15.0, 420.0, 15200.0, 0.7, 0.1), diameter(3.1e5, -0.2, 0.62, 0.2)
    case("shallow 1e-6 driving midpoint", 0.2, 0.1, 2e-7, 0.3, firm, midpoint(),
         phi=0.478, K=0.005, load_at=1e-5)
    case("shallow 1e-5 driving wong_reece", 0.25, 0.18, 2.5e-6, 0.15, loose,
         wong_reece(0.4, 0.2, -0.1), c=250.0, K=0.012, h=0.01, load_at=1.2e-5)
    case("shallow 1e-4 driving half_sinkage", 0.1, 0.08, 1e-5, 0.6, weighed, half_sinkage(),
         c=800.0, phi=0.61, K=0.018, radius="shearing", h=0.006, lug=1.0)
    case("shallow 1e-3 driving midpoint", 0.4, 0.3, 4e-4, 0.05, scaled, midpoint(-0.25),
         phi=0.55, K=0.025, peak="geometric", la="exact", lb="exact", load_at=0.9e-5)
    case("shallow 1e-6 no slip wong_reece", 0.3, 0.2, 3e-7, 0.0, loose, wong_reece(0.43, 0.32),
         c=1200.0, K=0.01)
    case("shallow 1e-5 no slip half_sinkage", 0.2, 0.1, 2e-6, 0.0, firm, half_sinkage(-0.3),
         phi=0.478, K=0.005, la="exact", lb="exact", load_at=1e-5)
    case("shallow 1e-4 no slip midpoint", 0.12, 0.09, 1.2e-5, 0.0, scaled, midpoint(),
         c=300.0, K=0.002, peak="half")
    case("shallow 1e-3 no slip wong_reece", 0.5, 0.35, 5e-4, 0.0, weighed,
         wong_reece(0.3, 0.1, -0.2), c=2000.0, K=0.03, h=0.02, radius="shearing", load_at=1.1e-3)
    case("shallow 1e-6 braking half_sinkage", 0.15, 0.12, 1.5e-7, -0.2, scaled, half_sinkage(),
         K=0.004, peak="half", la=0.05, lb=0.02)
    case("shallow 1e-5 braking midpoint", 0.2, 0.1, 2e-6, -0.4, firm, midpoint(-0.4),
         phi=0.478, K=0.005, load_at=1e-5)
    case("shallow 1e-4 braking wong_reece", 0.22, 0.16, 2.2e-5, -0.1, direct(6.0e5, 0.8),
         wong_reece(0.45, 0.3), K=0.008, h=0.012, load_at=1.3e-5)
    case("shallow 1e-3 braking half_sinkage", 0.35, 0.25, 3.5e-4, -0.05, weighed,
         half_sinkage(-0.5), c=600.0, phi=0.45, K=0.02, la="exact", lb=0.0)
    # Here j changes sign inside a contact of about a milliradian.
    case("shallow 1e-6 braking sign change", 0.2, 0.1, 2e-7,
         braking_slip(0.2, 2e-7, lambda t: t / 3), firm, midpoint(), phi=0.478, K=0.005)
    case("shallow 1e-3 braking two sign changes", 0.2, 0.1, 2e-4,
         braking_slip(0.2, 2e-4, lambda t: -t / 4), firm, midpoint(-1.0), phi=0.478, K=0.0005)


def deep_cases():
    """z = r: a quarter of the wheel in the ground."""
    case("deep driving midpoint", 0.2, 0.1, 0.2, 0.25, bekker(-660.0, 754130.0, 0.91), midpoint(),
         phi=0.478, K=0.005, load_at=0.8)
    case("deep no slip half_sinkage", 0.1, 0.2, 0.1, 0.0, direct(3.3e5, 1.3), half_sinkage(-0.2),
         c=500.0, K=0.02, peak="geometric", la="exact", lb="exact")
    case("deep braking wong_reece", 0.3, 0.15, 0.3, -0.3, diameter(2.0e5, 0.3, 0.8, 0.1),
         wong_reece(0.5, 0.2, -0.15), c=150.0, K=0.015, h=0.02, radius="shearing", peak="half")
    case("deep exit at minus entry no slip", 0.25, 0.2, 0.25, 0.0, direct(4.0e5, 0.9),
         midpoint(-1.0), phi=0.6, K=0.01)


def slip_cases():
    """Slips at, and next to, those where the model changes its form."""
    letter = bekker(-660.0, 754130.0, 0.91, 0.2)
    for s in (0.0, 1e-9, 1e-6, -1e-9, -1e-6):
        case(f"slip {s!r}", 0.2, 0.1, 0.013, s, letter, midpoint(-0.05), c=120.0, phi=0.478,
             K=0.005, h=0.008)
    case("slip 1 on the spot", 0.16, 0.14, 0.021, 1.0, reece(8.0, 300.0, 14000.0, 0.8, 0.35),
         wong_reece(0.35, 0.3, -0.1), c=700.0, phi=0.58, K=0.011, h=0.01, lug=1.0,
         peak="geometric", la=0.06, lb=0.03, load_at=0.2)
    case("locked", 0.2, 0.1, 0.013, -1.0, letter, midpoint(-0.05), c=120.0, phi=0.478, K=0.005,
         h=0.008, load_at=0.05)
    case("locked half_sinkage", 0.13, 0.2, 0.06, -1.0, diameter(4.1e5, 0.2, 0.9, 0.4),
         half_sinkage(-0.6), c=40.0, phi=0.7, K=0.02, radius="shearing", h=0.01, lug=0.7,
         peak="geometric", la=0.1, lb="exact")
    case("slip -0.999", 0.2, 0.1, 0.013, -0.999, letter, midpoint(-0.05), c=120.0, phi=0.478,
         K=0.005, h=0.008)
    # theta_1 lies beyond arccos(1 + s): j is positive in the last two milliradians.
    case("slip -0.999 deep", 0.2, 0.1, 0.2, -0.999, letter, midpoint(), phi=0.4, K=0.005)
    case("slip -0.99", 0.3, 0.2, 0.04, -0.99, direct(9.0e5, 1.05, 0.1), wong_reece(0.5, 0.2),
         c=90.0, phi=0.52, K=0.015, load_at=0.06)


def shear_modulus_cases():
    """Boundary layers of E from hair-thin to as wide as the contact."""
    for ratio in (400, 2000, 20000):
        case(f"r/K {ratio} driving", 0.2, 0.1, 0.03, 0.2, bekker(1200.0, 5.0e5, 0.95), midpoint(),
             c=350.0, phi=0.53, K=0.2 / ratio, load_at=0.07 if ratio == 20000 else None)
        case(f"r/K {ratio} braking", 0.2, 0.1, 0.03, -0.08, direct(8.0e5, 1.0, 0.15),
             wong_reece(0.45, 0.1, -0.2), c=350.0, phi=0.53, K=0.2 / ratio)
    case("r/K 20000 no slip", 0.4, 0.2, 0.02, 0.0, direct(8.0e5, 0.7), half_sinkage(-0.8),
         c=50.0, phi=0.5, K=2e-5)
    case("r/K 0.1 driving", 0.2, 0.1, 0.05, 0.4, bekker(900.0, 3.0e5, 1.1), half_sinkage(),
         c=600.0, phi=0.5, K=2.0)
    case("r/K 0.1 braking", 0.2, 0.1, 0.05, -0.35, bekker(900.0, 3.0e5, 1.1), midpoint(-0.3),
         c=600.0, phi=0.5, K=2.0, load_at=0.1)


def exponent_cases():
    """N far from one: stresses like a step, and stresses like a needle."""
    case("N 0.11", 0.25, 0.2, 0.02, 0.2, direct(2.0e4, 0.11), midpoint(-0.1), c=300.0, K=0.01,
         load_at=0.1)
    case("N 0.05 driving", 0.2, 0.15, 0.01, 0.5, direct(1.5e4, 0.03, 0.04), half_sinkage(),
         c=100.0, K=0.008, la="exact", lb="exact")
    case("N 0.05 braking", 0.2, 0.15, 0.01, -0.2, direct(1.5e4, 0.05), midpoint(-0.6), c=100.0,
         K=0.008)
    case("N 2.5", 0.3, 0.2, 0.08, 0.3, bekker(2.0e5, 3.0e7, 2.2, 1.0), wong_reece(0.4, 0.2, -0.2),
         c=200.0, K=0.01, load_at=0.3)
    case("N 4", 0.15, 0.1, 0.05, 0.1, diameter(4.0e9, 0.1, 4.0), midpoint(), K=0.012, peak="half",
         load_at=0.5)
    case("N 4 braking", 0.15, 0.1, 0.05, -0.15, diameter(4.0e9, 0.1, 4.0), half_sinkage(-0.3),
         K=0.012, peak="geometric")


def exit_cases():
    """Exit angles far behind, and in front of, the lowest point."""
    case("c3 -1", 0.2, 0.12, 0.03, 0.25, bekker(500.0, 4.0e5, 0.9), midpoint(-1.0), c=100.0,
         K=0.01)
    case("c3 -0.9", 0.2, 0.12, 0.03, 0.25, bekker(500.0, 4.0e5, 0.9), half_sinkage(-0.9), c=100.0,
         K=0.01, la="exact", lb="exact", load_at=0.12)
    case("c3 -0.5", 0.2, 0.12, 0.03, 0.25, bekker(500.0, 4.0e5, 0.9), wong_reece(0.1, 0.2, -0.5),
         c=100.0, K=0.01, peak="half", radius="shearing", h=0.005)
    case("c3 +0.3", 0.2, 0.12, 0.03, 0.25, bekker(500.0, 4.0e5, 0.9), midpoint(0.3), c=100.0,
         K=0.01, la="exact", lb="exact")
    case("c3 +0.3 braking", 0.2, 0.12, 0.03, -0.3, bekker(500.0, 4.0e5, 0.9), half_sinkage(0.3),
         c=100.0, K=0.01)


def sign_change_cases():
    """Braking wheels on which j changes sign inside the contact."""
    law = bekker(700.0, 6.0e5, 1.0, 0.2)

    def reversing(name, angle, contact, r=0.2, z=0.05, K=0.01, **options):
        case(name, r, 0.1, z, braking_slip(r, z, angle), law, contact, c=80.0, phi=0.5, K=K,
             **options)

    reversing("sign change in front of the maximum", lambda t: 0.75 * t, midpoint(), load_at=0.2)
    reversing("sign change behind the maximum", lambda t: 0.2 * t, midpoint(), load_at=0.24)
    reversing("two sign changes behind the maximum", lambda t: -0.15 * t, midpoint(-1.0), z=0.12,
              K=0.002)
    reversing("two sign changes behind the maximum, half_sinkage", lambda t: -0.2 * t,
              half_sinkage(-0.9), z=0.15, K=0.0005)
    reversing("two sign changes in front of the maximum", lambda t: -0.15 * t,
              wong_reece(-0.9, 0.0, -1.0), z=0.12, K=0.002)
    reversing("sign changes on either side of the maximum", lambda t: -0.15 * t,
              wong_reece(-0.35, 0.0, -1.0), z=0.12, K=0.002)
    # At a slip a little closer to zero, j would turn without changing its sign.
    reversing("two sign changes nearly meeting", lambda t: near_double_root(t, 1e-5),
              midpoint(-1.0), z=0.12, K=1e-5)
    reversing("sign change 1e-9 in front of the maximum", lambda t: t / 2 + mpf(10) ** -9,
              midpoint())
    reversing("sign change 1e-9 behind the maximum", lambda t: t / 2 - mpf(10) ** -9, midpoint())
    reversing("sign change at the maximum to rounding", lambda t: t / 2, midpoint())
    reversing("sign change 1e-4 from entry", lambda t: t - mpf(10) ** -4, midpoint())
    reversing("sign change 1e-8 from entry", lambda t: t - mpf(10) ** -8, midpoint(-0.2), K=0.0001)
    reversing("sign change 1e-9 inside exit", lambda t: -t / 5 + mpf(10) ** -9, midpoint(-0.2))
    reversing("sign change 1e-9 outside exit", lambda t: -t / 5 - mpf(10) ** -9, midpoint(-0.2))


def near_double_root(theta_1, distance):
    """An angle the given distance in front of the one where, at one slip, j turns on zero."""
    low, high = -theta_1, mpf(0)
    for _ in range(mp.prec):
        middle = (low + high) / 2
        # The slope of (theta_1 - theta) / (sin theta_1 - sin theta) changes sign there.
        slope = (theta_1 - middle) * mp.cos(middle) - (mp.sin(theta_1) - mp.sin(middle))
        low, high = (middle, high) if slope < 0 else (low, middle)
    return low + mpf(distance)


def strength_cases():
    """Cohesion and friction at their ends, and lugs."""
    law = direct(7.0e5, 0.95, 0.1)
    case("c 0, phi 0: no shear at all", 0.2, 0.15, 0.02, 0.3, law, midpoint(), phi=0.0)
    case("phi 0: cohesion alone", 0.2, 0.15, 0.02, 0.3, law, midpoint(-0.2), c=1500.0, phi=0.0)
    case("c 20000 driving", 0.2, 0.15, 0.02, 0.3, law, half_sinkage(), c=20000.0, phi=0.3,
         load_at=0.15)
    case("c 20000 braking", 0.2, 0.15, 0.02, -0.3, law, midpoint(), c=20000.0, phi=0.3)
    case("phi 1.2", 0.2, 0.15, 0.02, 0.3, law, wong_reece(0.45, 0.1), phi=1.2, load_at=0.05)
    case("k_c negative", 0.3, 0.05, 0.04, 0.2, bekker(-3.0e4, 6.5e5, 0.85, 0.1), midpoint(),
         K=0.015)
    for lug in (0.0, 0.5, 1.0):
        case(f"lug coefficient {lug}", 0.15, 0.12, 0.025, 0.35, law, midpoint(-0.1), c=400.0,
             h=0.03, lug=lug, radius="shearing" if lug else "rim",
             peak="half" if lug == 1.0 else "geometric")


def main():
    for add in (shallow_cases, deep_cases, slip_cases, shear_modulus_cases, exponent_cases,
                exit_cases, sign_change_cases, strength_cases):
        add()
    started, cases = time.monotonic(), []
    for name, given, load_at in CASES:
        try:
            load = None
            if load_at is not None:
                carried = Wheel(given).quadrature(mpf(given["wheel"]["radius_m"]) * mpf(load_at))
                load = float(f"{float(carried['normal_force_n']):.4g}")
            cases.append({"name": name, "input": given, "expected": expected(given, load)})
        except Failure as failure:
            sys.exit(f"{name}: {failure}")
        print(f"{time.monotonic() - started:6.1f} s  {name}", file=sys.stderr)
    json.dump(cases, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
