"""A curve from an address, with pandas: python curve_pandas.py [SERVER]"""

import sys

import pandas
import requests

server = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"

curve = pandas.read_csv(
    f"{server}/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand&soil.cohesion_pa=200"
    "&slip.from=0&slip.to=1&slip.points=101&normal_load_n=80&format=csv"
)
print(curve[["slip", "sinkage_m", "longitudinal_force_n", "torque_n_m"]].iloc[::20])

# From here on the example is checked. The curve is the one that a POST answers with, and carries the load; pandas reads
# a decimal to within its last digit.
body = {
    "wheel": {"preset": "letter"},
    "soil": {"preset": "letter-sand", "cohesion_pa": 200},
    "slip": {"from": 0, "to": 1, "points": 101},
    "normal_load_n": 80,
}
posted = requests.post(f"{server}/v1/slip-sweep", json=body, timeout=60)
posted.raise_for_status()
assert len(curve) == 101
pandas.testing.assert_frame_equal(curve, pandas.DataFrame(posted.json()["columns"]), rtol=1e-14, atol=0)
assert (curve["normal_force_n"] - 80).abs().max() < 1e-6

# At 20 mm and 20 % slip: an independent integration of the stresses over 401 000 points, rounded to the digits given.
curve = pandas.read_csv(
    f"{server}/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand"
    "&slip.from=0&slip.to=1&slip.points=101&sinkage_m=0.02&format=csv"
)
row = curve[curve["slip"] == 0.2].iloc[0]
assert abs(row["longitudinal_force_n"] - 16.906) < 5e-4
assert abs(row["normal_force_n"] - 89.716) < 5e-4
assert abs(row["torque_n_m"] - 7.3396) < 5e-5
