"""What is to be said of rows reaches the user, whatever form they have."""

import json
import warnings

import dask
import dask.dataframe
import numpy
import pandas
import pyarrow
import xarray

import terramechanics

REQUEST = {"wheel.preset": "letter", "soil.preset": "letter-sand", "normal_load_n": 80}
SLIPS = numpy.append(numpy.linspace(0.1, 0.3, 7), 9.0)


def told(work):
    """The codes of which work warns, in order."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        work()
    return [str(one.message).split(":")[0] for one in caught if issubclass(one.category, terramechanics.ModelWarning)]


def codes(found):
    return {warning["code"] for warning in found}


def test_every_form_tells_the_same():
    expected = codes(terramechanics.batch({"slip": SLIPS}, REQUEST).warnings)
    assert {"small_wheel", "invalid_row"} <= expected
    frame = pandas.DataFrame({"slip": SLIPS})
    assert codes(terramechanics.batch(frame, REQUEST).attrs["warnings"]) == expected
    table = terramechanics.batch(pyarrow.table({"slip": SLIPS}), REQUEST)
    assert codes(json.loads(table.schema.metadata[b"warnings"])) == expected
    cells = xarray.Dataset({"slip": ("x", SLIPS)})
    once = told(lambda: terramechanics.batch(cells, REQUEST))
    assert sorted(once) == sorted(expected)
    with dask.config.set(scheduler="synchronous"):
        assert told(lambda: terramechanics.batch(cells.chunk(x=4), REQUEST)) == []
        assert set(told(lambda: terramechanics.batch(cells.chunk(x=4), REQUEST).compute())) == expected
        parts = dask.dataframe.from_pandas(frame, npartitions=2)
        assert set(told(lambda: terramechanics.batch(parts, REQUEST).compute())) == expected


def test_a_code_is_told_once_of_many_parts():
    cells = xarray.Dataset({"slip": ("x", numpy.linspace(0.1, 0.3, 40))}).chunk(x=4)
    with warnings.catch_warnings(record=True) as caught, dask.config.set(scheduler="synchronous"):
        warnings.simplefilter("default")
        terramechanics.batch(cells, REQUEST).compute()
    found = [str(one.message) for one in caught if issubclass(one.category, terramechanics.ModelWarning)]
    assert found and len(found) == len(set(found))


def test_texts_in_place_of_numbers_are_refused_at_once():
    for form in ({"slip": ["0.1"]}, pandas.DataFrame({"slip": ["0.1"]}), pyarrow.table({"slip": ["0.1"]})):
        try:
            terramechanics.batch(form, REQUEST)
        except terramechanics.Refused as refused:
            assert refused.errors[0]["detail"] == "must be a column of numbers (integers, Float32 or Float64), not of texts"
        else:
            raise AssertionError(type(form))
