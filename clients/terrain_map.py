"""Where a rover gets through: slip, sinkage and power over a terrain, with xarray and Dask: python terrain_map.py [CELLS A SIDE]

Computes in threads of this process, or on the cluster of which DASK_SCHEDULER_ADDRESS is the address.
"""

import sys

import numpy
import xarray

import terramechanics

side = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
STEP = 1.0  # m

# A made-up terrain: waves of all lengths, the longer the higher.
random = numpy.random.default_rng(1)
x, y = numpy.meshgrid(numpy.fft.rfftfreq(side, STEP), numpy.fft.fftfreq(side, STEP))
lengths = numpy.hypot(x, y)
lengths[0, 0] = numpy.inf
waves = random.normal(size=lengths.shape) + 1j * random.normal(size=lengths.shape)
height = numpy.fft.irfft2(waves * lengths**-1.9, (side, side))
down, across = numpy.gradient(height, STEP)
steepness = numpy.hypot(down, across)
slope = numpy.arctan(steepness * (0.12 / steepness.mean()))
# Looser soil in the hollows.
loose = (height.max() - height) / (height.max() - height.min())
terrain = xarray.Dataset(
    {"slope_rad": (("y", "x"), slope), "soil.cohesion_pa": (("y", "x"), 600 - 500 * loose)},
    {"x": numpy.arange(side) * STEP, "y": numpy.arange(side) * STEP},
).chunk(x=max(50, side // 8), y=max(50, side // 8))

ROVER = {
    "mass_kg": 20, "gravity_m_s2": 1.625, "forward_velocity_m_s": 0.02,
    "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
    "soil": {
        "friction_angle_rad": 0.6, "shear_modulus_m": 0.018,
        "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820e3, "n0": 1},
    },
    "method": "linearised",
}  # fmt: skip
WANTED = ["slip", "climbs", "power_w", "largest_sinkage_m"]

with terramechanics.engine():
    rover = terramechanics.batch(terrain, ROVER, of="vehicle", columns=WANTED).compute()

print(rover)
through = rover.where(rover.climbs == 1)
print(f"the rover climbs {float(rover.climbs.mean()):.1%} of the cells uphill, at slips of {float(through.slip.mean()):.3f} on average")
print("sums", *(repr(float(rover[name].sum())) for name in WANTED), int((rover.status != 0).sum()))

# From here on the example is checked: the map has its shape and units, and a cell is the rover alone.
assert rover.slip.shape == (side, side) and rover.power_w.units == "W" and not rover.climbs.isnull().any()
for at in range(0, side, side // 5):
    cell = {"slope_rad": slope[at, at], "soil.cohesion_pa": terrain["soil.cohesion_pa"].values[at, at]}
    alone = terramechanics.ask("vehicle", {**ROVER, **cell})
    assert bool(rover.climbs.values[at, at]) == alone["climbs"], at
    if alone["slip"] is not None:
        assert rover.slip.values[at, at] == alone["slip"] and rover.power_w.values[at, at] == alone["power_w"], at
