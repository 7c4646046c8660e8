"""Refusals, in the words of the service."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from . import _native


class Refused(ValueError):
    """A request without an answer. `problem` is the problem document (RFC 9457) that the service sends.

    Attributes:
        problem: the document, with `type`, `title`, `status` and `detail`.
        errors: of bad input every fault: its JSON pointer, what is wrong, and where there are bounds its numbers.
    """

    def __init__(self, problem: dict[str, Any]) -> None:
        super().__init__(problem)
        self.problem = problem

    @property
    def errors(self) -> list[dict[str, Any]]:
        errors: list[dict[str, Any]] = self.problem.get("errors", [])
        return errors

    def __str__(self) -> str:
        lines = [f"{self.problem['title']}: {self.problem['detail']}"]
        if len(self.errors) > 1:
            lines += [f"  {error['pointer']} {error['detail']}" for error in self.errors]
        return "\n".join(lines)


@contextmanager
def refusals() -> Iterator[None]:
    """Refusals of the native part as `Refused`."""
    try:
        yield
    except _native.Problem as problem:
        raise Refused(json.loads(problem.args[0])) from None
