"""The bias of the linear estimator: what it makes of noise-free data of the quadrature, whose stresses are not linear.

    cargo run --release &
    python3 benches/linear_bias.py [http://127.0.0.1:8080]

For every complete wheel and soil of the catalogue the quadrature gives torque and sinkage over a grid of slips and loads; the
linear estimator then looks for cohesion and friction, knowing the shear modulus. Prints the least, the fifth, the fiftieth, the
ninety-fifth percentile and the largest of its errors, and of what is left of them when the reply's own `model_bias` is taken
off; in how many cases both intervals of 95 % hold the truth; and all that once more where the answer calls both estimates
determined. The contact is what was measured with the soil, else the midpoint. Needs Python 3 and nothing else.
"""

import json
import math
import sys
import urllib.error
import urllib.request

SERVER = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"
SLIPS = [0.1, 0.2, 0.4, 0.6]
PRESSURES = [1e3, 2e3, 4e3, 8e3]  # load over width and diameter of the wheel (Pa)


def ask(path, body=None):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(SERVER + path, data, {"Content-Type": "application/json"})
    with urllib.request.urlopen(request) as answer:
        return json.load(answer)


def complete(name):
    return [entry for entry in ask(f"/v1/{name}")[name] if not entry["missing"]]


def measured(wheel, soil):
    """Slip, sinkage, load and torque by the quadrature."""
    columns = {"slip": [], "sinkage_m": [], "normal_force_n": [], "torque_n_m": []}
    for pressure in PRESSURES:
        body = {"wheel": {"preset": wheel["id"]}, "soil": {"preset": soil["id"]}, "slip": SLIPS}
        body["normal_load_n"] = pressure * wheel["wheel"]["width_m"] * 2 * wheel["wheel"]["radius_m"]
        answer = ask("/v1/slip-sweep", body)["columns"]
        for name, column in columns.items():
            column += answer[name]
    return columns


def line(wheel, soil):
    """Errors of both estimates, whether they are called determined, hold the truth, the errors less the stated bias, the cohesion."""
    data = measured(wheel, soil)
    if any(load is None for load in data["normal_force_n"]):
        return None  # the soil does not carry all loads
    known = {"wheel": {"preset": wheel["id"]}, "soil": {"preset": soil["id"]}, "estimator": "linear"}
    answer = ask("/v1/identify", {**known, "fit": ["cohesion_pa", "friction_angle_rad"], "data": data})
    errors, holds, left = [], [], []
    for estimate in answer["estimates"]:
        truth = soil["soil"][estimate["parameter"]]
        errors.append(estimate["value"] - truth)
        lower, upper = estimate["interval_95"]
        holds.append(lower <= truth <= upper)
        left.append(errors[-1] - estimate.get("model_bias", math.nan))
    return errors, answer["identifiable"], all(holds), left, soil["soil"]["cohesion_pa"]


def spread(what, values, unit, scale=1):
    values = sorted(scale * value for value in values)
    picked = [values[round(share * (len(values) - 1))] for share in (0, 0.05, 0.5, 0.95, 1)]
    print(f"{what:34}", *(f"{value:10.4g}" for value in picked), f" {unit}  ({len(values)})")


def main():
    wheels, soils = complete("wheels"), complete("soils")
    found = []
    for wheel in wheels:
        for soil in soils:
            try:
                found.append(line(wheel, soil))
            except urllib.error.HTTPError as error:
                if error.code != 422:
                    raise
    found = [one for one in found if one]
    determined = [one for one in found if one[1]]
    for name, some in [("all", found), ("determined", determined)]:
        spread(f"cohesion, {name}", [errors[0] for errors, *_ in some], "Pa")
        spread(f"the same over the truth, {name}", [one[0][0] / one[4] for one in some if one[4] > 0], "")
        spread(f"friction angle, {name}", [errors[1] for errors, *_ in some], "°", math.degrees(1))
        spread(f"cohesion less model_bias, {name}", [left[0] for *_, left, _ in some if left[0] == left[0]], "Pa")
        spread(f"friction less model_bias, {name}", [left[1] for *_, left, _ in some if left[1] == left[1]], "°", math.degrees(1))
        print(f"the intervals of both hold the truth in {sum(holds for _, _, holds, *_ in some)} of {len(some)}")


main()
