"""Rows in the forms that users have them in: mappings of arrays, frames of pandas and Dask, tables of Arrow, data sets of xarray."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar, overload

import numpy
from numpy.typing import ArrayLike, NDArray

from .cells import Cells, of_array, of_arrow, of_series
from .refused import Refused
from .requests import Request
from .rows import OK, STATUS, Column, Common, ExtraColumns, Of, Rows, Table
from .told import tell

STATUSES = (OK, "invalid", "no_solution", "not_climbed")
"""What the flags of a data set mean."""

Form = TypeVar("Form")


@overload
def batch(
    rows: Mapping[str, ArrayLike], request: Request = ..., *, of: Of = ..., columns: Sequence[str] | None = ...,
    extra_columns: ExtraColumns = ..., threads: int | None = ...,
) -> Rows: ...  # fmt: skip
@overload
def batch(
    rows: Form, request: Request = ..., *, of: Of = ..., columns: Sequence[str] | None = ...,
    extra_columns: ExtraColumns = ..., threads: int | None = ...,
) -> Form: ...  # fmt: skip
def batch(
    rows: Any,
    request: Request = {},
    *,
    of: Of = "forces",
    columns: Sequence[str] | None = None,
    extra_columns: ExtraColumns = "refuse",
    threads: int | None = None,
) -> Any:
    """The answers to rows of requests, in the form in which the rows come.

    Each row is a request of its own. A column is one of its fields, with a dot between an object and its field
    (`soil.cohesion_pa` in Pa, `wheel.radius_m` in m, `slip` as a ratio), and `request` has what all rows have in common. Numbers are
    those of `POST /v1/batch`, of rovers those of `POST /v1/vehicle`, bit for bit, however many threads find them.

    Args:
        rows: the columns, all of one shape.
            A mapping of arrays of shape (rows,) gives `Rows`, a mapping of such arrays.
            A `pandas.DataFrame` gives one with the same index; its `attrs` have `warnings` and `assumed`.
            A `dask.dataframe.DataFrame` gives one that computes its parts where Dask has it. What is to be said of them is a
            `ModelWarning`, once for each code.
            A `pyarrow.Table` or `RecordBatch` gives another; the metadata of its schema has `warnings` and `assumed`.
            An `xarray.Dataset` gives one of the same dimensions, in which each quantity has its unit, and `status` is a flag. What
            Dask holds stays with Dask. What is to be said of the rows is a `ModelWarning`, once for each code.
        request: fields of all rows.
        of: `forces` of a wheel, or `vehicle`, a rover on one slope.
        columns: the names of those columns of the answer that are wanted. A rover without `largest_slope_rad` takes a fraction of
            the time.
        extra_columns: `refuse` names every column that is no field, `ignore` leaves such columns out.
        threads: threads of this process; all processors unless given, and one within Dask, which has threads of its own.

    A missing value of pandas, Arrow or a masked array is a field that was not sent with its row. NaN in an array of NumPy or xarray
    is a number that no field takes: its row is invalid.

    Raises:
        Refused: what no row can mend, such as a column that is no field. What is wrong with one row stands in its status.
    """
    if threads is not None and threads < 1:
        raise ValueError("threads is at least 1")
    common = Common(request, of, columns, extra_columns)
    match type(rows).__module__.split(".")[0], type(rows).__name__:
        case "pandas", "DataFrame":
            return of_frame(rows, common, threads)
        case ("dask" | "dask_expr"), "DataFrame":
            whole = partial(of_part, common=common, threads=threads or 1)
            return rows.map_partitions(whole, meta=of_frame(rows._meta, common, 1))
        case "pyarrow", ("Table" | "RecordBatch"):
            return of_arrow_table(rows, common, threads)
        case "xarray", "Dataset":
            return of_dataset(rows, common, threads)
    if not isinstance(rows, Mapping):
        raise TypeError(f"rows are a mapping of arrays, a frame, a table or a data set, not {type(rows).__name__}")
    return answered(list(rows), lambda name: of_array(name, rows[name]), common, threads)


def answered(names: Sequence[str], cells_of: Callable[[str], Cells], common: Common, threads: int | None) -> Rows:
    """The answers to rows of columns with these names, whose cells `cells_of` gives."""
    # That a column is no field is told before that it has neither numbers nor texts.
    table = Table(names, common)
    if common.extra_columns == "ignore":
        names = [name for name in names if is_field(name, common.of)]
        table = Table(names, common)
    cells = {name: cells_of(name) for name in names}
    counts = {len(values) for values, _, _ in cells.values()}
    if len(counts) > 1:
        lengths = ", ".join(f"`{name}` {len(values)}" for name, (values, _, _) in cells.items())
        raise ValueError(f"the columns differ in their number of rows: {lengths}")
    return table.answer(list(cells.values()), counts.pop() if counts else 0, threads)


def is_field(name: str, of: Of) -> bool:
    """Whether a column is a field of the request."""
    try:
        Table([name], Common({}, of))
    except Refused:
        return False
    return True


def of_frame(frame: Any, common: Common, threads: int | None) -> Any:
    import pandas

    names = [str(name) for name in frame.columns]
    places = {name: place for place, name in enumerate(names)}
    found = answered(names, lambda name: of_series(name, frame.iloc[:, places[name]]), common, threads)
    result = pandas.DataFrame(dict(found), index=frame.index)
    result[STATUS] = pandas.Series(found.status, index=frame.index, dtype="str")
    result.attrs = {"warnings": found.warnings, "assumed": found.assumed}
    return result


def of_part(part: Any, common: Common, threads: int) -> Any:
    """The answer to a part of a frame of Dask, which joins the parts without their attributes."""
    result = of_frame(part, common, threads)
    tell(result.attrs["warnings"])
    return result


def of_arrow_table(table: Any, common: Common, threads: int | None) -> Any:
    import pyarrow

    found = answered(table.schema.names, lambda name: of_arrow(name, table.column(name)), common, threads)
    arrays = [pyarrow.array(values, from_pandas=True) for values in found.values()]
    arrays.append(pyarrow.array(found.status, pyarrow.string()))
    metadata = {"warnings": json.dumps(found.warnings), "assumed": json.dumps(found.assumed)}
    return type(table).from_arrays(arrays, names=[*found, STATUS]).replace_schema_metadata(metadata)


def of_dataset(dataset: Any, common: Common, threads: int | None) -> Any:
    import xarray

    names = [str(name) for name in dataset.data_vars]
    if not names:
        raise ValueError("the data set has no variables; each is a field of the request")
    about = Table(names, common).about
    arrays = [dataset[name] for name in names]
    is_lazy = any(array.chunks is not None for array in arrays)
    *values, status = xarray.apply_ufunc(
        partial(of_cells, names=names, about=about, common=common, threads=threads or (1 if is_lazy else None)),
        *arrays,
        output_core_dims=[[] for _ in [*about, STATUS]],
        output_dtypes=[*(numpy.float64 for _ in about), numpy.int8],
        dask="parallelized",
        keep_attrs=False,
    )
    for (_, unit, meaning), array in zip(about, values):
        array.attrs = {"units": unit, "long_name": meaning}
    status.attrs = {"flag_values": numpy.arange(len(STATUSES), dtype=numpy.int8), "flag_meanings": " ".join(STATUSES)}
    return xarray.Dataset({**{name: array for (name, _, _), array in zip(about, values)}, STATUS: status})


def of_cells(*arrays: NDArray[Any], names: Sequence[str], about: Sequence[Column], common: Common, threads: int | None) -> Any:
    """The columns of the answer and the flag of each cell, in the shape that the arrays have together."""
    together = numpy.broadcast_arrays(*arrays)
    shape = together[0].shape
    if together[0].size == 0:
        return (*(numpy.empty(shape) for _ in about), numpy.empty(shape, numpy.int8))
    flat = {name: array.ravel() for name, array in zip(names, together)}
    found = answered(names, lambda name: of_array(name, flat[name]), common, threads)
    tell(found.warnings)
    flags = numpy.zeros(len(found.status), numpy.int8)
    for row in numpy.flatnonzero(found.status != OK):
        flags[row] = STATUSES.index(found.status[row].split(":")[0])
    return (*(values.reshape(shape) for values in found.values()), flags.reshape(shape))
