"""Progress of long work, and its cancellation."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from ._options import shows_its_options

#: What long work calls; the library looks here.
callback: ContextVar[Callable[[str, int, int], object] | None] = ContextVar("mindeg.progress", default=None)


@shows_its_options()
@contextmanager
def progress(call: Callable[[str, int, int], object]) -> Iterator[None]:
    """Long work in a ``with`` block calls ``call(stage, done, total)`` about twenty times a second.

    It does so in the thread in which it was begun. What ``call`` raises cancels the work, and comes out of it, as Ctrl-C does.

    >>> import mindeg
    >>> with mindeg.progress(lambda stage, done, total: print(stage, done, total)):
    ...     mesh = mindeg.rectangle(4, 3, size=0.5).mesh(interior=True)
    """
    token = callback.set(call)
    try:
        yield
    finally:
        callback.reset(token)
