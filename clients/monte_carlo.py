"""Forces for many draws of a soil, from Parquet to Parquet, with Dask: python monte_carlo.py [ROWS [FOLDER]]

Computes in threads of this process, or on the cluster of which DASK_SCHEDULER_ADDRESS is the address; the folder is one that all of
its machines see.
"""

import sys
import tempfile
from pathlib import Path

import dask.dataframe
import numpy
import pandas

import terramechanics

rows = int(float(sys.argv[1])) if len(sys.argv) > 1 else 10_000_000
folder = Path(sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp())
ROWS_OF_PART = min(250_000, -(-rows // 8))


def draws(part):
    """The draws of a part, which depend on its number alone."""
    random = numpy.random.default_rng([1, part])
    count = min(ROWS_OF_PART, rows - part * ROWS_OF_PART)
    return pandas.DataFrame({
        "soil.cohesion_pa": random.lognormal(numpy.log(500), 0.5, count),
        "soil.friction_angle_rad": random.normal(0.6, 0.05, count),
        "soil.pressure_sinkage.n0": random.normal(1.0, 0.05, count),
        "slip": random.uniform(0.05, 0.6, count),
    })


REQUEST = {
    "wheel": {"radius_m": 0.15, "width_m": 0.1}, "normal_load_n": 80, "method": "explicit",
    "soil": {"shear_modulus_m": 0.018, "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820e3}},
}  # fmt: skip
WANTED = ["longitudinal_force_n", "torque_n_m", "sinkage_m"]

with terramechanics.engine():
    parts = dask.dataframe.from_map(draws, range(-(-rows // ROWS_OF_PART)), meta=draws(0).iloc[:0])
    parts.to_parquet(folder / "draws", write_index=False)
    soils = dask.dataframe.read_parquet(folder / "draws")
    terramechanics.batch(soils, REQUEST, columns=WANTED).to_parquet(folder / "forces", write_index=False)
    forces = dask.dataframe.read_parquet(folder / "forces")
    pull = forces.longitudinal_force_n
    sums, count, ok, stuck = dask.compute(forces[WANTED].sum(), forces.shape[0], (forces.status == "ok").sum(), (pull < 0).sum())

print(f"{count} rows in {folder}, {ok} with an answer; the wheel pushes nothing forward in {stuck / count:.2%}")
print("sums", *(repr(float(value)) for value in sums), int(ok), int(stuck))

# From here on the example is checked: all rows are there, and some of them are requests of their own.
assert count == rows and ok > 0.99 * rows
first = draws(0)
found = pandas.read_parquet(folder / "forces" / "part.0.parquet")
for at in range(0, len(first), max(1, len(first) // 5)):
    alone = terramechanics.ask("forces", {**REQUEST, **first.iloc[at]})
    assert found.longitudinal_force_n[at] == alone["longitudinal_force_n"], at
