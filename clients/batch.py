"""Forces for many rows as Arrow streams, with pyarrow: python batch.py [SERVER]"""

import io
import json
import sys

import numpy
import pyarrow
import requests

server = sys.argv[1] if len(sys.argv) > 1 else "http://127.0.0.1:8080"

count = 20_000
random = numpy.random.default_rng(1)
rows = pyarrow.table({
    "id": numpy.arange(count),
    "soil.cohesion_pa": random.uniform(0, 500, count),
    "wheel.radius_m": random.uniform(0.1, 0.3, count),
    "slip": random.uniform(-0.2, 0.8, count),
    "soil.preset": pyarrow.array(["letter-sand", "wong-dry-sand"] * (count // 2)).dictionary_encode(),
})

def pieces(table):
    """The table as an Arrow stream, a batch of 64 Ki rows at a time."""
    sink = io.BytesIO()
    with pyarrow.ipc.new_stream(sink, table.schema) as writer:
        for batch in table.to_batches(max_chunksize=1 << 16):
            writer.write_batch(batch)
            yield sink.getvalue()
            sink.seek(0)
            sink.truncate()
    yield sink.getvalue()

answer = requests.post(
    f"{server}/v1/batch?wheel.width_m=0.1&normal_load_n=80&method=explicit&echo=id",
    data=pieces(rows), headers={"Content-Type": "application/vnd.apache.arrow.stream"}, stream=True, timeout=60,
)
answer.raise_for_status()
batches = list(pyarrow.ipc.open_stream(answer.raw).iter_batches_with_custom_metadata())
forces = pyarrow.Table.from_batches(batch for batch, _ in batches)
last, metadata = batches[-1]
assert last.num_rows == 0 and int(metadata["rows"]) == count, "the answer was cut"
print(forces.select(["id", "sinkage_m", "torque_n_m", "status"]).slice(0, 3).to_pandas())

# From here on the example is checked: order, types and warnings, and some rows against requests of their own.
assert forces["id"].to_pylist() == list(range(count))
assert forces.schema.field("torque_n_m").type == pyarrow.float64()
assert forces["status"].type == pyarrow.string() and set(forces["status"].to_pylist()) == {"ok"}
assert any(warning["code"] == "small_wheel" for warning in json.loads(metadata["warnings"]))
for i in range(0, count, 2_999):
    row = {name: column[i].as_py() for name, column in zip(rows.column_names, rows.columns)}
    body = {
        "wheel": {"radius_m": row["wheel.radius_m"], "width_m": 0.1},
        "soil": {"preset": row["soil.preset"], "cohesion_pa": row["soil.cohesion_pa"]},
        "slip": row["slip"], "normal_load_n": 80, "method": "explicit",
    }
    alone = requests.post(f"{server}/v1/forces", json=body, timeout=60)
    alone.raise_for_status()
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m", "sinkage_m"]:
        assert forces[name][i].as_py() == alone.json()[name], (name, i)

# A bad row is null and says why; one without a value has no value in any column either.
bad = pyarrow.table({"slip": [0.1, 7.0, None]})
answer = requests.post(
    f"{server}/v1/batch?wheel.preset=letter&soil.preset=letter-sand&sinkage_m=0.02",
    data=b"".join(pieces(bad)), headers={"Content-Type": "application/vnd.apache.arrow.stream"}, timeout=60,
)
forces = pyarrow.ipc.open_stream(answer.content).read_all()
assert forces["torque_n_m"].is_valid().to_pylist() == [True, False, False]
assert [status.split(" ")[0:2] for status in forces["status"].to_pylist()] == [["ok"], ["invalid:", "/slip"], ["invalid:", "/slip"]]
