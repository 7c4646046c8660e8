"""The native part: bytes and buffers in and out. Use the package around it."""

from collections.abc import Sequence
from typing import Any, final

from numpy import float64, uint8
from numpy.typing import NDArray

class Problem(Exception):
    """A request without an answer: the problem document of the service, as JSON."""

def operations() -> list[str]:
    """The names of the operations that `ask` knows: the paths of the service behind `/v1/`."""

def answer(operation: str, body: bytes) -> bytes:
    """The answer of an operation to a JSON body, as JSON."""

def fail() -> None:
    """Fails as a defect of the package would, so that its tests see that the interpreter goes on."""

@final
class Table:
    """Rows of one operation that have a part of their request in common."""

    def __new__(
        cls, of: str, constants: bytes, names: Sequence[str], ignores_extra: bool, asked: Sequence[str] | None
    ) -> Table: ...
    def columns(self) -> list[tuple[str, str, str]]:
        """Name, unit and meaning of each column of the answer."""

    def rows(self, cells: Sequence[tuple[NDArray[Any], NDArray[uint8] | None, Sequence[str] | None]], threads: int) -> Rows:
        """What the next rows give, found on so many threads."""

    def end(self) -> str:
        """What is to be said of all rows so far, as JSON."""

@final
class Rows:
    """What rows gave."""

    def copy(self, column: int, into: NDArray[float64]) -> None:
        """Copies a column into a buffer of as many numbers."""

    def faults(self) -> list[tuple[int, str]]:
        """The rows without an answer, and why."""
