"""The package against the service at BASE_URL: bytes for bytes, bits for bits, word for word."""

import io
import json
import os
import urllib.error
import urllib.parse
import urllib.request

import numpy
import pyarrow
import pytest

import terramechanics
from terramechanics import _native

SERVER = os.environ["BASE_URL"]
ARROW = "application/vnd.apache.arrow.stream"

WHEEL = {"preset": "letter"}
SOIL = {"preset": "letter-sand"}


def post(path, data, media="application/json"):
    """The status and the bytes of an answer."""
    request = urllib.request.Request(SERVER + path, data, {"Content-Type": media})
    try:
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.status, answer.read()
    except urllib.error.HTTPError as error:
        return error.code, error.read()


def examples():
    """Each operation with the example of its request in the contract."""
    with urllib.request.urlopen(SERVER + "/openapi.json", timeout=60) as answer:
        paths = json.load(answer)["paths"]
    for name in terramechanics.operations():
        content = paths[f"/v1/{name}"]["post"]["requestBody"]["content"]["application/json"]
        yield name, content["example"] if "example" in content else next(iter(content["examples"].values()))["value"]


@pytest.mark.parametrize(("operation", "request_"), list(examples()))
def test_an_answer_is_that_of_the_service_byte_for_byte(operation, request_):
    status, expected = post(f"/v1/{operation}", json.dumps(request_).encode())
    assert status == 200 and _native.answer(operation, json.dumps(request_).encode()) == expected


REFUSED = [
    ("forces", {}),
    ("forces", {"wheel": WHEEL, "soil": {"preset": "moon"}, "slip": 2, "sinkage_m": -1}),
    ("forces", {"wheel": WHEEL, "soil": {**SOIL, "cohesion_kpa": 1}, "slip": 0.2, "sinkage_m": 0.02}),
    ("forces", {"wheel": WHEEL, "soil": SOIL, "slip": 0.2, "normal_load_n": 1e9}),
    ("forces", {"wheel": WHEEL, "soil": SOIL, "slip": 0.2, "sinkage_m": 0.02, "method": "exactly"}),
    ("slip-sweep", {"wheel": WHEEL, "soil": SOIL, "slip": [0.1], "sinkage_m": 0.02}),
    ("vehicle", {"mass_kg": 20, "soil": SOIL}),
    ("sweep", {"of": "forces", "request": {}, "axes": [{"field": "slip"}]}),
]


@pytest.mark.parametrize(("operation", "request_"), REFUSED)
def test_a_refusal_is_that_of_the_service_word_for_word(operation, request_):
    status, expected = post(f"/v1/{operation}", json.dumps(request_).encode())
    assert status == 422
    with pytest.raises(terramechanics.Refused) as refused:
        terramechanics.ask(operation, request_)
    assert refused.value.problem == json.loads(expected)


def test_what_is_no_json_is_refused_alike():
    for text in (b"{", b"[1, 2", b"\xff", b'{"slip": NaN}'):
        status, expected = post("/v1/forces", text)
        assert status == 400
        with pytest.raises(_native.Problem) as problem:
            _native.answer("forces", text)
        assert json.loads(problem.value.args[0]) == json.loads(expected)


def by_service(table, constants):
    """The table that `/v1/batch` answers, and what is at its end; or its problem."""
    sink = io.BytesIO()
    with pyarrow.ipc.new_stream(sink, table.schema) as writer:
        for batch in table.to_batches(max_chunksize=1 << 15):
            writer.write_batch(batch)
    status, answer = post("/v1/batch?" + urllib.parse.urlencode(constants), sink.getvalue(), ARROW)
    if status != 200:
        return json.loads(answer)
    batches = list(pyarrow.ipc.open_stream(answer).iter_batches_with_custom_metadata())
    end = {key.decode(): json.loads(value) for key, value in batches[-1][1].items()}
    return pyarrow.Table.from_batches(batch for batch, _ in batches), end


METHODS = ["explicit", "linearised", "quadrature"]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sinkage", ["sinkage_m", "normal_load_n"])
def test_rows_are_those_of_a_batch_bit_for_bit(method, sinkage):
    count = 6000
    random = numpy.random.default_rng(3)
    # Some rows out of bounds, some without an answer.
    depths = random.uniform(-0.001, 0.25, count) if sinkage == "sinkage_m" else random.uniform(-1, 4000, count)
    rows = pyarrow.table({
        "slip": random.uniform(-1.02, 1.02, count),
        "soil.cohesion_pa": random.uniform(-5, 2000, count),
        "soil.preset": pyarrow.array(["letter-sand", "wong-dry-sand", None] * (count // 3)),
        "wheel.radius_m": random.uniform(0.05, 0.4, count),
        sinkage: depths,
        "soil.pressure_sinkage.n0": pyarrow.array([None, 0.9, 1.0] * (count // 3)),
    })
    constants = {"wheel.width_m": 0.1, "method": method, "soil.shear_modulus_m": 0.02}
    expected, end = by_service(rows, constants)
    found = terramechanics.batch(rows, constants)
    assert found.schema.names == expected.schema.names
    for name in expected.schema.names:
        assert found[name].combine_chunks().equals(expected[name].combine_chunks()), name
    kinds = {status.split(":")[0] for status in found["status"].to_pylist()}
    assert {"ok", "invalid"} <= kinds
    assert json.loads(found.schema.metadata[b"warnings"]) == end["warnings"]
    by_arrays = terramechanics.batch({name: rows[name].to_numpy() for name in rows.schema.names[:2]}, {
        **constants, "soil.preset": "letter-sand", "wheel.radius_m": 0.2, sinkage: 0.02 if sinkage == "sinkage_m" else 80})
    plain, _ = by_service(rows.select(["slip", "soil.cohesion_pa"]), {
        **constants, "soil.preset": "letter-sand", "wheel.radius_m": 0.2, sinkage: 0.02 if sinkage == "sinkage_m" else 80})
    for name in by_arrays:
        assert by_arrays[name].tobytes() == plain[name].to_numpy().tobytes(), name


def test_what_all_rows_lack_is_refused_alike():
    cases = [
        ({"slip": [0.1, 0.2]}, {"wheel.preset": "letter"}),
        ({"slip": [0.1, 0.2]}, {"wheel.preset": "letter", "soil.preset": "letter-sand"}),
        ({"slip": [0.1], "cohesion": [3.0]}, {"wheel.preset": "letter", "soil.preset": "letter-sand", "sinkage_m": 0.02}),
        ({"slip": [0.1], "soil": [3.0]}, {"wheel.preset": "letter", "sinkage_m": 0.02}),
        ({"slip": [0.1]}, {"wheel.preset": "letter", "soil.preset": "letter-sand", "sinkage_m": 0.02, "slip": 0.3}),
        ({"slip": [0.1]}, {"wheel.preset": "letter", "soil.preset": "letter-sand", "sinkage_m": 0.02, "methode": "explicit"}),
        ({"slip": ["a", "b"]}, {"wheel.preset": "letter", "soil.preset": "letter-sand"}),
    ]
    for rows, constants in cases:
        table = pyarrow.table(rows)
        expected = by_service(table, constants)
        assert isinstance(expected, dict), constants
        for form in (table, {name: numpy.asarray(values) for name, values in rows.items()}):
            with pytest.raises(terramechanics.Refused) as refused:
                terramechanics.batch(form, constants)
            assert refused.value.problem == expected


def test_what_was_assumed_is_told_alike():
    with urllib.request.urlopen(SERVER + "/v1/soils", timeout=60) as answer:
        listed = next(value for value in json.load(answer).values() if isinstance(value, list))
    table = pyarrow.table({"slip": [0.1, 0.2, 0.3]})
    for soil in (soil["id"] for soil in listed if soil.get("assumed")):
        constants = {"wheel.preset": "letter", "soil.preset": soil, "sinkage_m": 0.02}
        answer = by_service(table, {**constants, "assume": "true"})
        if isinstance(answer, tuple) and "assumed" in answer[1]:
            break
    expected, end = answer
    found = terramechanics.batch(table, {**constants, "assume": True})
    assert json.loads(found.schema.metadata[b"assumed"]) == end["assumed"] and end["assumed"]
    assert json.loads(found.schema.metadata[b"warnings"]) == end["warnings"]
    assert found["torque_n_m"].combine_chunks().equals(expected["torque_n_m"].combine_chunks())


def test_rovers_are_those_of_the_service_bit_for_bit():
    rover = {
        "mass_kg": 20, "gravity_m_s2": 1.625, "forward_velocity_m_s": 0.02, "soil": SOIL, "method": "linearised",
        "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
    }  # fmt: skip
    slopes, cohesions = numpy.linspace(-0.2, 0.7, 12), numpy.array([0.0, 300.0, 2e4])
    axes = [{"field": "/slope_rad", "values": slopes.tolist()}, {"field": "/soil/cohesion_pa", "values": cohesions.tolist()}]
    status, answer = post("/v1/sweep", json.dumps({"of": "vehicle", "request": rover, "axes": axes}).encode())
    assert status == 200
    expected = json.loads(answer)
    rows = {"slope_rad": numpy.repeat(slopes, 3), "soil.cohesion_pa": numpy.tile(cohesions, 12)}
    found = terramechanics.batch(rows, rover, of="vehicle")
    for name in found:
        if name != "slope_rad":
            column = numpy.array([numpy.nan if value is None else value for value in expected["columns"][name]])
            assert found[name].tobytes() == column.tobytes(), name
    assert [status.split(":")[0] for status in found.status] == expected["columns"]["status"]
    assert {"ok", "not_climbed"} <= {status.split(":")[0] for status in found.status}
    assert found.warnings == expected["warnings"]


def test_a_rover_that_is_refused_is_so_alike():
    rover = {
        "mass_kg": 20, "soil": SOIL, "method": "linearised", "slope_rad": 0.1,
        "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
    }  # fmt: skip
    cohesions = [200.0, -1.0, 1e9, numpy.nan]
    found = terramechanics.batch({"soil.cohesion_pa": numpy.array(cohesions)}, rover, of="vehicle", columns=["slip"])
    assert found.status[0] == "ok" and found.status[3].startswith("invalid: /soil/cohesion_pa ")
    for cohesion, status in zip(cohesions[1:3], found.status[1:3]):
        problem = json.loads(post("/v1/vehicle", json.dumps({**rover, "soil": {**SOIL, "cohesion_pa": cohesion}}).encode())[1])
        assert status == f"invalid: {problem['errors'][0]['pointer']} {problem['errors'][0]['detail']}"
    bare = {name: value for name, value in rover.items() if name != "wheels"}
    problem = json.loads(post("/v1/vehicle", json.dumps({**bare, "mass_kg": 20}).encode())[1])
    with pytest.raises(terramechanics.Refused) as refused:
        terramechanics.batch({"mass_kg": [20.0, 30.0]}, {name: bare[name] for name in bare if name != "mass_kg"}, of="vehicle")
    assert refused.value.problem == problem
