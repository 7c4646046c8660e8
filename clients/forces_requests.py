"""Forces at one operating point, with requests: python forces_requests.py [SERVER]"""

import sys

import requests

server = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"

point = {"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "slip": 0.2, "sinkage_m": 0.02}
answer = requests.post(f"{server}/v1/forces", json=point, timeout=60)
answer.raise_for_status()
forces = answer.json()
print(forces["longitudinal_force_n"], forces["normal_force_n"], forces["torque_n_m"])

# From here on the example is checked. An independent integration of the stresses over 401 000 points, rounded to the
# digits given.
assert abs(forces["longitudinal_force_n"] - 16.906) < 5e-4
assert abs(forces["normal_force_n"] - 89.716) < 5e-4
assert abs(forces["torque_n_m"] - 7.3396) < 5e-5

# The same asked by a query.
query = {"wheel.preset": "letter", "soil.preset": "letter-sand", "slip": 0.2, "sinkage_m": 0.02}
assert requests.get(f"{server}/v1/forces", params=query, timeout=60).json() == forces

# A refusal names every fault.
refused = requests.post(f"{server}/v1/forces", json={**point, "slip": 20, "sinkage_m": -1}, timeout=60)
assert refused.status_code == 422
assert {fault["pointer"] for fault in refused.json()["errors"]} == {"/slip", "/sinkage_m"}
