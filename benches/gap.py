"""The gap between the methods: how much normal force the closed forms carry against the quadrature.

    cargo run --release &
    python3 benches/gap.py [http://127.0.0.1:8080]

Prints, for each rule of the contact, the least, the median and the largest relative difference of F_z, first on the letter's
wheel and sand, then over every complete wheel and soil of the catalogue. Needs Python 3 and nothing else.
"""

import json
import statistics
import sys
import urllib.error
import urllib.request

SERVER = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"
SLIPS = [0, 0.1, 0.2, 0.4, 0.6, 0.8, 1]
CLOSED_FORMS = ["linearised", "explicit"]


def ask(path, body=None):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(SERVER + path, data, {"Content-Type": "application/json"})
    with urllib.request.urlopen(request) as answer:
        return json.load(answer)


def complete(name):
    return [entry for entry in ask(f"/v1/{name}")[name] if not entry["missing"]]


def gaps(wheels, soils, rule, depths):
    """Relative differences of F_z by method; points without a solution are left out."""
    found = {method: [] for method in CLOSED_FORMS}
    for wheel in wheels:
        for soil in soils:
            for depth in depths:
                body = {
                    "wheel": {"preset": wheel["id"]},
                    "soil": {"preset": soil["id"]},
                    "contact": {"rule": rule},
                    "sinkage_m": depth * wheel["wheel"]["radius_m"],
                    "slip": SLIPS,
                    "methods": ["quadrature", *CLOSED_FORMS],
                }
                exact, *closed = (series["columns"]["normal_force_n"] for series in ask("/v1/compare", body)["series"])
                for method, column in zip(CLOSED_FORMS, closed):
                    pairs = zip(column, exact)
                    found[method] += [force / true - 1 for force, true in pairs if force is not None and true is not None and true > 0]
    return found


def main():
    wheels, soils = complete("wheels"), complete("soils")
    letter = [wheel for wheel in wheels if wheel["id"] == "letter"], [soil for soil in soils if soil["id"] == "letter-sand"]
    for rule in ["midpoint", "half_sinkage"]:
        for what, (some_wheels, some_soils), depths in [
            ("the letter's", letter, [0.0025, 0.01, 0.025, 0.05, 0.1, 0.2, 0.3]),
            ("the catalogue", (wheels, soils), [0.01, 0.05, 0.1, 0.2, 0.3]),
        ]:
            for method, values in gaps(some_wheels, some_soils, rule, depths).items():
                least, median, largest = (100 * of(values) for of in (min, statistics.median, max))
                print(f"{rule:13} {what:14} {method:11} {least:6.1f} % {median:6.1f} % {largest:6.1f} %  ({len(values)} points)")


main()
