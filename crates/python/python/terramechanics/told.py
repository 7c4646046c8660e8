"""What is to be said of rows, told where the form of the answer has no lasting place for it."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable, Mapping
from typing import Any


class ModelWarning(UserWarning):
    """What is to be said of the answers to rows: the code of a warning of the service, the field that it is about, and its advice.

    `warnings.simplefilter("error", terramechanics.ModelWarning)` makes an exception of it, and the filter `ignore` silences it.
    """


def tell(found: Iterable[Mapping[str, Any]]) -> None:
    """Warns of each code once. For which rows it holds, and by how much, differs from part to part and is not said."""
    for code, field, advice in dict.fromkeys((one["code"], one.get("pointer"), one["advice"]) for one in found):
        message = f"{code}: {f'of {field}. ' if field else ''}{advice}"
        if not told_by_worker(message):
            warnings.warn(message, ModelWarning, stacklevel=2)


def told_by_worker(message: str) -> bool:
    """Whether this runs in a worker of a cluster, which then tells those who asked for the work."""
    worker = sys.modules.get("distributed.worker")
    if worker is None:
        return False
    try:
        worker.get_worker()
    except ValueError:
        return False
    worker.warn(message, ModelWarning)
    return True
