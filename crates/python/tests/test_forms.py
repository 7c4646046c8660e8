"""The forms of rows: what goes in comes out, and the numbers do not depend on the form."""

import pickle
import threading
import time

import dask
import dask.dataframe
import numpy
import pandas
import pyarrow
import pytest
import xarray

import terramechanics
from terramechanics import _native

REQUEST = {"wheel.preset": "letter", "soil.preset": "letter-sand", "normal_load_n": 80}
ROVER = {
    "gravity_m_s2": 1.625, "method": "linearised",
    "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}}, "soil.preset": "letter-sand",
}  # fmt: skip


def some(count=5000):
    random = numpy.random.default_rng(7)
    return {"slip": random.uniform(-0.3, 0.9, count), "soil.cohesion_pa": random.uniform(0, 500, count)}


def bits(columns):
    return {name: numpy.asarray(columns[name], numpy.float64).tobytes() for name in columns if name != "status"}


def test_a_row_is_a_request_of_its_own():
    rows = some(40)
    found = terramechanics.batch(rows, REQUEST)
    for at in range(40):
        alone = terramechanics.ask("forces", {**REQUEST, **{name: values[at] for name, values in rows.items()}})
        assert {name: found[name][at] for name in ("torque_n_m", "sinkage_m")} == {
            name: alone[name] for name in ("torque_n_m", "sinkage_m")
        }
    assert set(found.status) == {"ok"} and found["torque_n_m"].shape == (40,)


def test_frames_tables_and_data_sets_have_the_numbers_of_arrays():
    rows = some()
    arrays = terramechanics.batch(rows, REQUEST)
    index = pandas.Index(numpy.arange(5000) * 3, name="id")
    frame = terramechanics.batch(pandas.DataFrame(rows, index=index), REQUEST)
    assert bits(frame) == bits(arrays) and frame.index.equals(index) and (frame.status == "ok").all()
    assert frame.attrs["warnings"] == arrays.warnings
    table = terramechanics.batch(pyarrow.table(rows), REQUEST)
    assert bits(table.to_pandas()) == bits(arrays)
    lazy = terramechanics.batch(dask.dataframe.from_pandas(pandas.DataFrame(rows), npartitions=3), REQUEST)
    assert bits(lazy.compute()) == bits(arrays) and list(lazy.columns) == list(frame.columns)
    square = {name: (("y", "x"), values.reshape(50, 100)) for name, values in rows.items()}
    whole = terramechanics.batch(xarray.Dataset(square), REQUEST)
    assert whole.torque_n_m.units == "N.m" and whole.status.dtype == numpy.int8
    parts = terramechanics.batch(xarray.Dataset(square).chunk(x=30, y=20), REQUEST)
    assert parts.torque_n_m.chunks is not None
    for data in (whole, parts.compute()):
        assert bits({name: data[name].values.ravel() for name in arrays}) == bits(arrays)


def test_a_map_takes_dimensions_from_all_its_fields():
    slopes, loads = xarray.DataArray([0.0, 0.1], dims="slope"), xarray.DataArray([5.0, 20.0, 40.0], dims="mass")
    found = terramechanics.batch(xarray.Dataset({"slope_rad": slopes, "mass_kg": loads}), ROVER, of="vehicle")
    assert found.slip.dims == ("slope", "mass")
    for i, slope in enumerate([0.0, 0.1]):
        for j, mass in enumerate([5.0, 20.0, 40.0]):
            alone = terramechanics.ask("vehicle", {**ROVER, "slope_rad": slope, "mass_kg": mass})
            for name in ("slip", "largest_slope_rad"):
                assert numpy.nan_to_num(found[name].values[i, j], nan=-1) == (-1 if alone[name] is None else alone[name])
            assert found.climbs.values[i, j] == alone["climbs"]


def test_neither_threads_nor_pieces_nor_the_place_in_memory_change_a_bit(monkeypatch):
    rows = some()
    once = bits(terramechanics.batch(rows, REQUEST))
    for threads in (1, 2, 5):
        assert bits(terramechanics.batch(rows, REQUEST, threads=threads)) == once
    monkeypatch.setattr("terramechanics.rows.PIECE", 700)
    assert bits(terramechanics.batch(rows, REQUEST)) == once
    strided = {name: numpy.repeat(values, 3)[::3] for name, values in rows.items()}
    unaligned = {}
    for name, values in rows.items():
        room = numpy.empty(values.nbytes + 1, numpy.uint8)
        unaligned[name] = room[1:].view(numpy.float64)
        unaligned[name][:] = values
        assert not unaligned[name].flags.aligned
    swapped = {name: values.astype(">f8") for name, values in rows.items()}
    for form in (strided, unaligned, swapped):
        assert bits(terramechanics.batch(form, REQUEST)) == once


def test_the_native_part_refuses_a_buffer_that_is_not_aligned():
    values = numpy.zeros(17, numpy.uint8)[1:].view(numpy.float64)
    table = _native.Table("forces", b"{}", ["slip"], False, None)
    with pytest.raises(BufferError):
        table.rows([(values, None, None)], 1)


def test_warnings_do_not_depend_on_pieces(monkeypatch):
    rows = some()
    once = terramechanics.batch(rows, REQUEST).warnings
    monkeypatch.setattr("terramechanics.rows.PIECE", 700)
    assert once and terramechanics.batch(rows, REQUEST).warnings == once


def test_missing_values_were_not_sent_and_nan_in_an_array_is_refused():
    given = [0.0, 300.0, None]
    preset = terramechanics.ask("forces", {**REQUEST, "slip": 0.2})["torque_n_m"]
    request = {**REQUEST, "slip": 0.2}
    forms = [
        pandas.DataFrame({"soil.cohesion_pa": given}),
        pandas.DataFrame({"soil.cohesion_pa": pandas.array(given, "Float64")}),
        pandas.DataFrame({"soil.cohesion_pa": pandas.Series(given, dtype=object)}),
        pyarrow.table({"soil.cohesion_pa": given}),
        pyarrow.table({"soil.cohesion_pa": pyarrow.chunked_array([[0], [300, None]])}),
        {"soil.cohesion_pa": numpy.ma.masked_invalid([0.0, 300.0, numpy.nan])},
        {"soil.cohesion_pa": numpy.array(given, object)},
    ]
    for form in forms:
        torque = numpy.asarray(terramechanics.batch(form, request)["torque_n_m"])
        assert torque[2] == preset and torque[1] != torque[0], type(form)
    nan = terramechanics.batch({"soil.cohesion_pa": numpy.array([0.0, numpy.nan])}, request)
    assert nan.status[0] == "ok" and nan.status[1].startswith("invalid: /soil/cohesion_pa ") and numpy.isnan(nan["torque_n_m"][1])


def test_words_come_in_every_form():
    words = ["letter-sand", "wong-dry-sand", "letter-sand"]
    request = {"wheel.preset": "letter", "slip": 0.2, "sinkage_m": 0.02}
    expected = [terramechanics.ask("forces", {**request, "soil.preset": word})["torque_n_m"] for word in words]
    forms = [
        {"soil.preset": words},
        {"soil.preset": numpy.array(words, object)},
        {"soil.preset": numpy.array(words, numpy.dtypes.StringDType())},
        pandas.DataFrame({"soil.preset": words}),
        pandas.DataFrame({"soil.preset": pandas.Categorical(words)}),
        pandas.DataFrame({"soil.preset": pandas.Series(words, dtype=object)}),
        pyarrow.table({"soil.preset": words}),
        pyarrow.table({"soil.preset": pyarrow.chunked_array([words[:1], words[1:]]).dictionary_encode()}),
    ]
    for form in forms:
        assert list(numpy.asarray(terramechanics.batch(form, request)["torque_n_m"])) == expected
    flags = terramechanics.batch({"soil.preset": words, "assume": [True, False, True]}, request)
    assert list(flags["torque_n_m"]) == expected


def test_only_what_is_asked_for_is_answered():
    found = terramechanics.batch(some(3), REQUEST, columns=["torque_n_m", "sinkage_m"])
    assert sorted(found) == ["sinkage_m", "torque_n_m"]
    with pytest.raises(terramechanics.Refused, match="has no column `torque_nm`; did you mean `torque_n_m`"):
        terramechanics.batch(some(3), REQUEST, columns=["torque_nm"])


def test_extra_columns_are_refused_or_left_out():
    frame = pandas.DataFrame({"slip": [0.1, 0.2], "when": pandas.to_datetime(["2020-01-01", "2020-01-02"])})
    with pytest.raises(terramechanics.Refused, match="unknown column `when`"):
        terramechanics.batch(frame, REQUEST)
    assert (terramechanics.batch(frame, REQUEST, extra_columns="ignore").status == "ok").all()
    dates = frame.rename(columns={"when": "soil.cohesion_pa"})
    for extra in ("refuse", "ignore"):
        with pytest.raises(terramechanics.Refused, match="must be a column of numbers"):
            terramechanics.batch(dates, REQUEST, extra_columns=extra)


def test_columns_of_different_lengths_and_dimensions_are_refused():
    with pytest.raises(ValueError, match="differ in their number of rows"):
        terramechanics.batch({"slip": [0.1, 0.2], "normal_load_n": [80.0]}, {"wheel.preset": "letter", "soil.preset": "letter-sand"})
    with pytest.raises(ValueError, match="has 2 dimensions"):
        terramechanics.batch({"slip": numpy.zeros((2, 2))}, REQUEST)
    with pytest.raises(ValueError, match="given twice"):
        terramechanics.ask("forces", {"soil": {"cohesion_pa": 1}, "soil.cohesion_pa": 2})


def test_without_rows_there_are_the_columns():
    frame = terramechanics.batch(pandas.DataFrame({"slip": pandas.Series([], dtype=float)}), REQUEST)
    assert len(frame) == 0 and frame.torque_n_m.dtype == numpy.float64 and "status" in frame


def test_a_defect_is_an_exception_and_the_interpreter_goes_on():
    with pytest.raises(RuntimeError, match="a defect of terramechanics: on purpose"):
        _native.fail()
    assert terramechanics.operations()


def test_other_threads_of_python_run_meanwhile():
    rows = {"slip": numpy.linspace(0.01, 0.9, 20_000)}
    began = time.monotonic()
    worker = threading.Thread(target=terramechanics.batch, args=(rows, REQUEST))
    worker.start()
    longest, last = 0.0, time.monotonic()
    while worker.is_alive():
        now = time.monotonic()
        longest, last = max(longest, now - last), now
    # Were the interpreter held, this thread would wait for nearly all of the time.
    assert longest < (time.monotonic() - began) / 2


def test_a_refusal_travels_between_processes():
    with pytest.raises(terramechanics.Refused) as refused:
        terramechanics.ask("forces", {})
    again = pickle.loads(pickle.dumps(refused.value))
    assert again.problem == refused.value.problem and str(again) == str(refused.value)
