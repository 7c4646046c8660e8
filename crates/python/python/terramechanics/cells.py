"""Columns as the cells of the native part: numbers, numbers with flags, places among texts, or flags.

In arrays of NumPy every number counts, and NaN is a number that no field takes. Missing values of masked arrays, pandas and Arrow are
fields that were not sent with their row.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy
from numpy.typing import NDArray

from .refused import Refused

Cells: TypeAlias = tuple[NDArray[Any], NDArray[numpy.uint8] | None, list[str] | None]

ABSENT = 2
"""Neither true nor false."""


def unfit(name: str, kind: object) -> Refused:
    """The refusal of a column of that kind, as the service has it for a column of Arrow."""
    pointer = "/" + name.replace(".", "/")
    detail = f"must be a column of numbers, booleans, texts or a dictionary of texts, not of {kind}"
    return Refused({
        "type": "/problems/invalid-input", "title": "The request cannot be computed", "status": 422,
        "detail": f"{pointer}: {detail}", "errors": [{"pointer": pointer, "detail": detail}],
    })  # fmt: skip


def numbers(values: Any, there: Any = None) -> Cells:
    """Cells of numbers, of which `there` tells those that count. Arrays of other engines need not be aligned or contiguous."""
    array = numpy.require(values, numpy.float64, ["C", "A"])
    return (array, None, None) if there is None else (array, numpy.require(there, numpy.uint8, ["C", "A"]), None)


def places(of: Any, texts: Any) -> Cells:
    """Cells of places among texts; -1 for none."""
    return numpy.require(of, numpy.int32, ["C", "A"]), None, [str(text) for text in texts]


def of_array(name: str, values: Any) -> Cells:
    """The cells of an array of one dimension."""
    if isinstance(values, numpy.ma.MaskedArray):
        there = ~numpy.ma.getmaskarray(values)
        if values.dtype.kind in "fiu":
            return numbers(values.filled(0), there)
        return of_objects(name, numpy.array(values.tolist(), object))
    array = numpy.asarray(values)
    if array.ndim != 1:
        raise ValueError(f"`{name}` has {array.ndim} dimensions; a column has one, and what all rows have in common stands in the request")
    match array.dtype.kind:
        case "f" | "i" | "u":
            return numbers(array)
        case "b":
            return numpy.require(array, numpy.uint8, ["C", "A"]), None, None
        case "U" | "T":
            texts, of = numpy.unique(array, return_inverse=True)
            return places(of, texts)
        case "O":
            return of_objects(name, array)
    raise unfit(name, array.dtype)


def of_objects(name: str, values: NDArray[Any]) -> Cells:
    """The cells of an array of objects, of which None and NaN are missing."""
    there = numpy.array([value is not None and value == value for value in values], bool)
    kinds = {type(value) for value in values[there]}
    if all(issubclass(kind, str) for kind in kinds):
        texts, of = numpy.unique(values[there].astype(str), return_inverse=True)
        all_places = numpy.full(len(values), -1, numpy.int32)
        all_places[there] = of
        return places(all_places, texts)
    if kinds <= {bool, numpy.bool_}:
        flags = numpy.full(len(values), ABSENT, numpy.uint8)
        flags[there] = values[there].astype(bool)
        return flags, None, None
    if all(issubclass(kind, (int, float, numpy.number)) for kind in kinds):
        return numbers(numpy.where(there, values, 0).astype(numpy.float64), there)
    raise unfit(name, "a mixture of " + ", ".join(sorted(kind.__name__ for kind in kinds)))


def of_series(name: str, series: Any) -> Cells:
    """The cells of a column of pandas."""
    import pandas

    dtype = series.dtype
    if isinstance(dtype, pandas.CategoricalDtype):
        if pandas.api.types.is_numeric_dtype(dtype.categories.dtype):
            return of_series(name, series.astype(dtype.categories.dtype if not series.hasnans else "float64"))
        return places(series.cat.codes.to_numpy(), dtype.categories)
    if pandas.api.types.is_bool_dtype(dtype):
        return series.astype("uint8" if not series.hasnans else "UInt8").to_numpy(numpy.uint8, na_value=ABSENT), None, None
    if pandas.api.types.is_numeric_dtype(dtype) and dtype.kind != "c":
        missing = series.isna().to_numpy(bool)
        if not missing.any():
            return numbers(series.to_numpy(numpy.float64))
        return numbers(series.to_numpy(numpy.float64, na_value=0.0), ~missing)
    if isinstance(dtype, pandas.StringDtype):
        of, texts = pandas.factorize(series)
        return places(of, texts)
    if dtype == object:
        return of_objects(name, series.to_numpy(object))
    raise unfit(name, dtype)


def of_arrow(name: str, column: Any) -> Cells:
    """The cells of a column of Arrow."""
    import pyarrow

    kind = column.type
    types = pyarrow.types
    if isinstance(column, pyarrow.ChunkedArray):
        column = column.unify_dictionaries().combine_chunks() if types.is_dictionary(kind) else column.combine_chunks()
        if isinstance(column, pyarrow.ChunkedArray):
            column = pyarrow.concat_arrays(column.chunks) if column.num_chunks else pyarrow.array([], kind)
    if types.is_floating(kind) or types.is_integer(kind):
        there = column.is_valid().cast("uint8").to_numpy() if column.null_count else None
        return numbers(column.cast(pyarrow.float64(), safe=False).fill_null(0.0).to_numpy(), there)
    if types.is_null(kind):
        return numbers(numpy.zeros(len(column)), numpy.zeros(len(column)))
    if types.is_boolean(kind):
        return column.cast("uint8").fill_null(ABSENT).to_numpy(), None, None
    if types.is_string(kind) or types.is_large_string(kind) or types.is_string_view(kind):
        column = column.cast(pyarrow.string()).dictionary_encode()
        kind = column.type
    if types.is_dictionary(kind) and (types.is_string(kind.value_type) or types.is_large_string(kind.value_type)):
        texts = column.dictionary.to_pylist()
        of = column.indices.cast(pyarrow.int32()).fill_null(-1).to_numpy()
        if None in texts:
            of = numpy.where(of == texts.index(None), -1, of)
        return places(of, texts)
    raise unfit(name, kind)
