"""Requests and answers as pydantic models made from the contract: python pydantic_models.py [SERVER]

datamodel-codegen --allow-private-network --url http://127.0.0.1:8080/openapi.json --output terramechanics_models.py
"""

import sys

import requests
from pydantic import ValidationError

from terramechanics_models import Forces, ForcesRequest, Problem, SlipSweep, SlipSweepRequest

server = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"
json_type = {"Content-Type": "application/json"}


def ask(path, request):
    # `from` is called from_ in Python, hence the aliases. Fields that were not set go as null: to the service, left out.
    return requests.post(server + path, data=request.model_dump_json(by_alias=True, warnings=False), headers=json_type, timeout=60)


request = ForcesRequest(wheel={"preset": "letter"}, soil={"preset": "letter-sand"}, slip=0.2, sinkage_m=0.02)
answer = ask("/v1/forces", request)
forces = Forces.model_validate_json(answer.text)
print(forces.longitudinal_force_n, forces.normal_force_n, forces.torque_n_m)

# From here on the example is checked. An independent integration of the stresses over 401 000 points, rounded to the
# digits given.
answer.raise_for_status()
assert abs(forces.longitudinal_force_n - 16.906) < 5e-4
assert abs(forces.normal_force_n - 89.716) < 5e-4
assert abs(forces.torque_n_m - 7.3396) < 5e-5

# A sweep under a load, with the sand spelled out.
sand = {
    "cohesion_pa": 0, "friction_angle_rad": 0.478, "shear_modulus_m": 0.005,
    "pressure_sinkage": {"law": "bekker", "k_c": -660, "k_phi": 754130, "n0": 0.91},
}
slips = {"from": 0, "to": 1, "points": 101}
curve = ask("/v1/slip-sweep", SlipSweepRequest(wheel={"preset": "letter"}, soil=sand, slip=slips, normal_load_n=80))
curve = SlipSweep.model_validate_json(curve.text)
assert len(curve.columns.normal_force_n) == 101
assert all(abs(force - 80) < 1e-6 for force in curve.columns.normal_force_n)

# The models refuse what the service would, and a problem is a model as well.
try:
    ForcesRequest(wheel={"preset": "letter"}, soil={"preset": "letter-sand"}, slip=20, sinkage_m=0.02)
except ValidationError as error:
    assert error.errors()[0]["loc"][0] == "slip"
else:
    raise AssertionError("a slip of 20 was taken")
problem = ask("/v1/forces", ForcesRequest(wheel={"preset": "letter"}, soil={"preset": "letter-sand"}, slip=0.2))
assert problem.status_code == 422
assert Problem.model_validate_json(problem.text).status == 422
