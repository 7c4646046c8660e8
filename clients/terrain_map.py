"""Where a rover gets through: slip, sinkage and power over a terrain, with xarray and Dask:
python terrain_map.py [CELLS A SIDE] [PIECES]

Computes in threads of this process, or on the cluster of which DASK_SCHEDULER_ADDRESS is the address. A map that does not fit into
memory is computed in pieces, one after the other: `python terrain_map.py 2000 25` takes a hundred million cells.
"""

import sys
import time

import numpy
import xarray

import terramechanics

side = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
pieces = int(sys.argv[2]) if len(sys.argv) > 2 else 1
STEP = 1.0  # m

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


def terrain(piece):
    """A made-up terrain: waves of all lengths, the longer the higher."""
    random = numpy.random.default_rng(1 + piece)
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
    return xarray.Dataset(
        {"slope_rad": (("y", "x"), slope), "soil.cohesion_pa": (("y", "x"), 600 - 500 * loose)},
        {"x": numpy.arange(side) * STEP, "y": numpy.arange(side) * STEP},
    ).chunk(x=max(50, side // 8), y=max(50, side // 8))


def check(ground, rover):
    """The map has its shape and units, and a cell is the rover alone."""
    assert rover.slip.shape == (side, side) and rover.power_w.units == "W" and not rover.climbs.isnull().any()
    for at in range(0, side, side // 5):
        cell = {name: float(ground[name].values[at, at]) for name in ("slope_rad", "soil.cohesion_pa")}
        alone = terramechanics.ask("vehicle", {**ROVER, **cell})
        assert bool(rover.climbs.values[at, at]) == alone["climbs"], at
        if alone["slip"] is not None:
            assert rover.slip.values[at, at] == alone["slip"] and rover.power_w.values[at, at] == alone["power_w"], at


sums, others = numpy.zeros(len(WANTED)), 0
with terramechanics.engine():
    for piece in range(pieces):
        ground = terrain(piece)
        began, began_work = time.monotonic(), time.process_time()
        rover = terramechanics.batch(ground, ROVER, of="vehicle", columns=WANTED).compute()
        print(f"piece {piece + 1} of {pieces}: {time.monotonic() - began:.1f} s, in this process {time.process_time() - began_work:.1f} s of processors")
        check(ground, rover)
        sums += [float(rover[name].sum()) for name in WANTED]
        others += int((rover.status != 0).sum())

print(rover)
cells = pieces * side**2
through = rover.where(rover.climbs == 1)
print(f"the rover climbs {sums[WANTED.index('climbs')] / cells:.1%} of {cells} cells uphill, in the last piece at slips of {float(through.slip.mean()):.3f} on average")
print("sums", *(repr(float(each)) for each in sums), others)
