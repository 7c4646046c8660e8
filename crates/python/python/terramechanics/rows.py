"""Rows of requests, as arrays of NumPy."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _native
from .cells import Cells
from .refused import refusals
from .requests import Request, body

Of = Literal["forces", "vehicle"]
ExtraColumns = Literal["refuse", "ignore"]

STATUS = "status"
OK = "ok"

PIECE = 1 << 18
"""Rows that are handed over at once: between two pieces an interrupt is heard, and the copies of one fit in little memory."""


class Column(NamedTuple):
    """A column of an answer."""

    name: str
    unit: str
    """By the Unified Code for Units of Measure; 1 for a ratio."""
    meaning: str


@dataclass(frozen=True)
class Rows(Mapping[str, NDArray[numpy.float64]]):
    """The answers to rows: a mapping from the names of quantities to arrays of shape (rows,), NaN where there is no number.

    Attributes:
        status: of shape (rows,), `ok`, or why a row has no answer: `invalid: /slip must be …`, `no_solution: …`, `not_climbed: …`.
        about: name, unit and meaning of each column.
        warnings: what is to be said of the rows, as at the end of an answer of `/v1/batch`.
        assumed: what was assumed of the catalogue, where the request allows it.
    """

    columns: dict[str, NDArray[numpy.float64]]
    status: NDArray[Any]
    about: list[Column]
    warnings: list[dict[str, Any]] = field(default_factory=list)
    assumed: list[dict[str, Any]] = field(default_factory=list)

    def __getitem__(self, name: str) -> NDArray[numpy.float64]:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)


def processors() -> int:
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@dataclass(frozen=True)
class Common:
    """What rows have in common, and what is wanted of them."""

    request: Request
    of: Of = "forces"
    columns: Sequence[str] | None = None
    extra_columns: ExtraColumns = "refuse"

    def __post_init__(self) -> None:
        if self.extra_columns not in ("refuse", "ignore"):
            raise ValueError(f"extra_columns is `refuse` or `ignore`, not {self.extra_columns!r}")


class Table:
    """Rows of these columns. The names of the answer's columns are known before there are rows."""

    def __init__(self, names: Sequence[str], common: Common) -> None:
        asked = None if common.columns is None else list(common.columns)
        ignores_extra = common.extra_columns == "ignore"
        with refusals():
            self.native = _native.Table(common.of, body(common.request), list(names), ignores_extra, asked)
        self.about = [Column(*column) for column in self.native.columns()]

    def answer(self, cells: Sequence[Cells], rows: int, threads: int | None) -> Rows:
        """The answers to so many rows of cells, in the order of the names."""
        columns = {name: numpy.empty(rows) for name, _, _ in self.about}
        status = numpy.full(rows, OK, object)
        for start in range(0, rows, PIECE):
            piece = slice(start, min(start + PIECE, rows))
            parts = [(values[piece], None if there is None else there[piece], texts) for values, there, texts in cells]
            with refusals():
                found = self.native.rows(parts, threads or processors())
            for place, column in enumerate(columns.values()):
                found.copy(place, column[piece])
            for row, fault in found.faults():
                status[start + row] = fault
        end = json.loads(self.native.end())
        return Rows(columns, status, self.about, end["warnings"], end.get("assumed", []))
