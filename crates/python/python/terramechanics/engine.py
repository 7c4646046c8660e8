"""The engine of Dask: threads of this process, or a cluster."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def engine() -> Iterator[Any]:
    """While it is open, Dask computes in threads of this process; where `DASK_SCHEDULER_ADDRESS` is set, on that cluster.

    Yields:
        The client of the cluster; None for threads.
    """
    import dask

    if dask.config.get("scheduler-address", None) is None:
        with dask.config.set(scheduler="threads"):
            yield None
    else:
        from distributed import Client

        with Client() as client:
            yield client
