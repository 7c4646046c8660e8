"""Forces of a rigid wheel on soil: the requests of the terramechanics service, answered in this process.

`ask` answers one request, `batch` answers rows. Both take the fields of the service under its names, in SI units and radians
(`soil.cohesion_pa`, `wheel.radius_m`, `slip`), give its numbers bit for bit, and refuse in its words.

    >>> import terramechanics
    >>> answer = terramechanics.ask("forces", {
    ...     "wheel.preset": "letter", "soil.preset": "letter-sand", "slip": 0.2, "sinkage_m": 0.02})
    >>> round(answer["longitudinal_force_n"], 1)
    16.9
    >>> rows = terramechanics.batch(
    ...     {"slip": [0.1, 0.2], "soil.cohesion_pa": [0.0, 500.0]},
    ...     {"wheel.preset": "letter", "soil.preset": "letter-sand", "normal_load_n": 80})
    >>> rows["torque_n_m"].shape
    (2,)
"""

from ._native import operations
from .engine import engine
from .refused import Refused
from .requests import Request, ask
from .rows import Column, Rows
from .told import ModelWarning
from .veneer import batch

__all__ = ["Column", "ModelWarning", "Refused", "Request", "Rows", "ask", "batch", "engine", "operations"]
