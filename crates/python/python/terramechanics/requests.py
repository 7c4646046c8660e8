"""Requests as mappings of fields."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from . import _native
from .refused import refusals

Request = Mapping[str, Any]
"""The fields of a request, by their names in the service. `{"soil": {"cohesion_pa": 200}}` and `{"soil.cohesion_pa": 200}` are the
same."""


def nested(request: Request) -> dict[str, Any]:
    """The request with objects in place of dotted names."""
    tree: dict[str, Any] = {}
    for name, value in request.items():
        if isinstance(value, Mapping):
            value = nested(value)
        *around, last = name.split(".")
        place = tree
        for part in around:
            within = place.setdefault(part, {})
            if not isinstance(within, dict):
                raise ValueError(f"`{name}` is a field of `{part}`, which is given as {within!r}")
            place = within
        known = place.get(last)
        if isinstance(known, dict) and isinstance(value, dict):
            both = [name for name in known if name in value]
            if not both:
                known.update(value)
                continue
        if last in place:
            raise ValueError(f"`{name}` is given twice")
        place[last] = value
    return tree


def body(request: Request) -> bytes:
    """The request as JSON. Scalars and arrays of NumPy are numbers and lists."""
    return json.dumps(nested(request), default=plain).encode()


def plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a request has numbers, words, lists and mappings, not {type(value).__name__}")


def ask(operation: str, request: Request) -> dict[str, Any]:
    """The answer to one request: that of `POST /v1/<operation>`, byte for byte, as a dictionary.

    Args:
        operation: `forces`, `slip-sweep`, `vehicle` or another of `operations()`.
        request: the fields of the request, in SI units and radians, by their names in the service.

    Returns:
        The quantities of the answer by their names, whose suffix is the unit (`torque_n_m`), and its `warnings`.

    Raises:
        Refused: the problem of the service.
    """
    with refusals():
        answer: dict[str, Any] = json.loads(_native.answer(operation, body(request)))
    return answer
