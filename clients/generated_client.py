"""A client generated from the contract: python generated_client.py [SERVER]

openapi-python-client generate --meta none --url http://127.0.0.1:8080/openapi.json
"""

import sys

from terramechanics_client import Client
from terramechanics_client.api.forces import forces
from terramechanics_client.models import ForcesRequest, Soil, SoilPreset, Wheel, WheelPreset

from terramechanics_client import models
from terramechanics_client.api.forces import forces_of_query, slip_sweep, slip_sweep_of_query

server = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"

wheel, soil = Wheel(preset=WheelPreset.LETTER), Soil(preset=SoilPreset.LETTER_SAND)
request = ForcesRequest(wheel=wheel, soil=soil, slip=0.2, sinkage_m=0.02)
answer = forces.sync(client=Client(server), body=request)
print(answer.longitudinal_force_n, answer.normal_force_n, answer.torque_n_m)


def check(found):
    """Against an independent integration of the stresses over 401 000 points, rounded to the digits given."""
    assert isinstance(found, models.Forces), found
    assert abs(found.longitudinal_force_n - 16.906) < 5e-4
    assert abs(found.normal_force_n - 89.716) < 5e-4
    assert abs(found.torque_n_m - 7.3396) < 5e-5


# From here on the example is checked.
client = Client(server)
check(answer)

# The sand spelled out, with one of the laws and the rules that the contract offers.
law = models.BekkerLaw(law=models.BekkerLawLaw.BEKKER, k_c=-660, k_phi=754130, n0=0.91)
sand = Soil(cohesion_pa=0, friction_angle_rad=0.478, shear_modulus_m=0.005, pressure_sinkage=law)
midpoint = models.MidpointContact(rule=models.MidpointContactRule.MIDPOINT)
request = ForcesRequest(
    wheel=Wheel(radius_m=0.2, width_m=0.1), soil=sand, contact=midpoint, slip=0.2, sinkage_m=0.02
)
check(forces.sync(client=client, body=request))

# The same asked by a query, whose parameters are named with an underscore for the dot.
letter = {
    "wheel_preset": WheelPreset.LETTER,
    "soil_preset": SoilPreset.LETTER_SAND,
}
check(forces_of_query.sync(client=client, slip=0.2, sinkage_m=0.02, **letter))

# A curve, by either way.
sand = Soil(preset=SoilPreset.LETTER_SAND, cohesion_pa=200)
slips = models.SlipRange(from_=0, to=1, points=101)
request = models.SlipSweepRequest(wheel=wheel, soil=sand, slip=slips, normal_load_n=80)
posted = slip_sweep.sync(client=client, body=request)
curve = slip_sweep_of_query.sync(
    client=client,
    wheel_preset=WheelPreset.LETTER,
    soil_preset=SoilPreset.LETTER_SAND,
    soil_cohesion_pa=200,
    slip_from=0,
    slip_to=1,
    slip_points=101,
    normal_load_n=80,
)
assert len(curve.columns.slip) == 101
assert max(abs(force - 80) for force in curve.columns.normal_force_n) < 1e-6
assert curve == posted

# A refusal is a problem with every fault.
refused = forces.sync(client=client, body=ForcesRequest(wheel=wheel, soil=soil, slip=20, sinkage_m=-1))
assert isinstance(refused, models.Problem), refused
assert {fault.pointer for fault in refused.errors} == {"/slip", "/sinkage_m"}
