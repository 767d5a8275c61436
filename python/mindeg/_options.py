"""Goals and interior points: their options, written once for everything that takes them, and the optimiser alone."""

import inspect
import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal, TypedDict, TypeVar

import numpy.typing as npt

from . import _mindeg
from ._plain import plain

if TYPE_CHECKING:
    from typing_extensions import Unpack

_Function = TypeVar("_Function", bound=Callable[..., Any])


class GoalOptions(TypedDict, total=False):
    """What a mesh of boundary points is to be; `mindeg.GOALS` explains each. Give one of them."""

    keep_angle: float | str | None
    max_degree: int | None
    optimize: Literal["angle"] | None


class InteriorOptions(TypedDict, total=False):
    """What is wanted of interior points; `docs/interior.md` explains each."""

    growth: float | None
    size_inside: float | None
    min_size: float | None
    max_size: float | None
    interior_degree: tuple[int, int] | None
    boundary_degree: int | None
    target_angle: float | None
    prefer: Literal["degree", "angle"] | None
    sizes: "npt.ArrayLike | Callable[[Any], npt.ArrayLike] | Sequence[Any] | Mapping[str, Any] | str | os.PathLike[str] | None"
    fixed_points: "npt.ArrayLike | None"
    max_points: int | None


def names_its_options(options: type) -> Callable[[_Function], _Function]:
    """Lists the options in the signature that help() and notebooks show, in place of ``**options``."""

    def named(function: _Function) -> _Function:
        signature = inspect.signature(function)
        *others, _ = signature.parameters.values()
        for name, kind in options.__annotations__.items():
            kind = getattr(kind, "__forward_arg__", kind)
            others.append(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind))
        setattr(function, "__signature__", signature.replace(parameters=others))
        return function

    return named


def as_json(options: Mapping[str, object]) -> str:
    """The options that are given, as the library reads them."""
    names = InteriorOptions.__annotations__
    for name in options:
        if name not in names:
            raise ValueError(f'no option is named "{name}"; give {", ".join(names)}')
    return json.dumps({key: plain(value, key) for key, value in options.items() if value is not None})


@names_its_options(InteriorOptions)
def improve(
    points: "_mindeg.Mesh | npt.ArrayLike", triangles: "npt.ArrayLike | None" = None, **options: "Unpack[InteriorOptions]"
) -> _mindeg.Mesh:
    """The optimiser alone on a planar mesh, given as a mesh or as points and triangles: the boundary stays.

    Options as for ``Domain.interior``; ``report["before"]`` has what the mesh was like.
    """
    return _mindeg._improve(points, triangles, as_json(options))
