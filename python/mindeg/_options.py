"""The options of meshes and of readers, written once for everything that takes them."""

from __future__ import annotations

import ast
import difflib
import functools
import inspect
import json
import os
from typing import TYPE_CHECKING, Any, Literal, TypedDict, TypeVar

from ._plain import plain

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    import numpy.typing as npt

    _Function = TypeVar("_Function", bound=Callable[..., Any])


class GoalOptions(TypedDict, total=False):
    """What a mesh of boundary points is to be; ``mindeg.GOALS`` explains each. Give one of them, and ``max_degree`` beside it."""

    keep_angle: float | str | None
    max_degree: int | None
    optimize: Literal["angle"] | None


class InteriorOptions(TypedDict, total=False):
    """What is wanted of points inside; ``docs/interior.md`` explains each."""

    growth: float | None
    size_inside: float | None
    min_size: float | None
    max_size: float | None
    across: float | None
    interior_degree: tuple[int, int] | None
    boundary_degree: int | None
    boundary_corners: int | None
    target_angle: float | None
    prefer: Literal["degree", "angle"] | None
    sizes: npt.ArrayLike | Callable[[Any], npt.ArrayLike] | Sequence[Any] | Mapping[str, Any] | str | os.PathLike[str] | None
    fixed_points: npt.ArrayLike | None
    max_points: int | None


class MeshOptions(GoalOptions, InteriorOptions, total=False):
    """A goal, or what is wanted of points inside."""


class ReadingOptions(TypedDict, total=False):
    """How points, polygons and files become a domain; ``mindeg.Domain`` explains each."""

    size: float | None
    size_of: Mapping[str, float] | None
    corner_angle: float | None
    feature: str | int | None
    layer: str | None
    name_by: str | None
    sea_in: tuple[float, float, float, float] | None
    repair: bool | None
    snap: float | None
    fill_rule: Literal["evenodd", "nonzero"] | None
    project: str | None


class _Shown(str):
    """An annotation as help() is to show it: without quotes."""

    def __repr__(self) -> str:
        return str(self).replace("npt.", "").replace("_mindeg.", "").replace("os.PathLike[str]", "PathLike")


def shows_its_options(*options: type) -> Callable[[_Function], _Function]:
    """Makes a signature that help() and notebooks show: all options in place of ``**options``, annotations as they are written."""

    def shown(function: _Function) -> _Function:
        signature = inspect.signature(function)
        parameters = [parameter for parameter in signature.parameters.values() if parameter.kind is not parameter.VAR_KEYWORD]
        for of_one in options:
            for name, kind in of_one.__annotations__.items():
                kind = getattr(kind, "__forward_arg__", kind)
                parameters.append(inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind))
        parameters = [
            parameter if parameter.annotation is parameter.empty else parameter.replace(annotation=_Shown(parameter.annotation))
            for parameter in parameters
        ]
        gives = signature.return_annotation
        gives = gives if gives is signature.empty else _Shown(gives)
        setattr(function, "__signature__", signature.replace(parameters=parameters, return_annotation=gives))
        return function

    return shown


with open(os.path.join(os.path.dirname(__file__), "_mindeg.pyi"), encoding="utf-8") as _stub:
    #: The functions of the stub of the module in Rust, by name.
    _STUBS = {node.name: node for node in ast.parse(_stub.read()).body if isinstance(node, ast.FunctionDef)}


def shows_its_types(function: _Function) -> _Function:
    """The same function with the types of its stub in the signature that help() shows: a function in Rust has none."""
    stub = _STUBS[function.__name__]
    written = [*stub.args.args, *stub.args.kwonlyargs]
    types = {argument.arg: ast.unparse(argument.annotation) for argument in written if argument.annotation}
    signature = inspect.signature(function)
    parameters = [parameter.replace(annotation=_Shown(types[name])) for name, parameter in signature.parameters.items()]
    gives = _Shown(ast.unparse(stub.returns) if stub.returns else "None")

    @functools.wraps(function)
    def called(*args: Any, **options: Any) -> Any:
        return function(*args, **options)

    called.__module__ = "mindeg"
    setattr(called, "__signature__", signature.replace(parameters=parameters, return_annotation=gives))
    return called  # type: ignore[return-value]


def separated(options: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any], dict[str, Any]]:
    """Goals, wishes for points inside, and options of readers, those that are given; any other is a fault."""
    kinds = (GoalOptions, InteriorOptions, ReadingOptions)
    found: tuple[dict[str, Any], ...] = ({}, {}, {})
    for name, value in options.items():
        place = next((place for place, kind in enumerate(kinds) if name in kind.__annotations__), None)
        if place is None:
            names = ["interior", "preset", *(key for kind in kinds for key in kind.__annotations__)]
            near = difflib.get_close_matches(name, names, 1)
            meant = f'; did you mean "{near[0]}"?' if near else ";"
            raise TypeError(f'no option is named "{name}"{meant} the options are {", ".join(names)}')
        if value is not None and value is not False:
            found[place][name] = value
    return found  # type: ignore[return-value]


def wish(interior: bool | None, preset: str | None, goal: Mapping[str, Any], wanted: Mapping[str, Any]) -> dict[str, Any]:
    """The mesh that is wanted, as the library reads it."""
    if interior is not None and not isinstance(interior, bool):
        raise TypeError(f"interior is {interior!r}; give True or False, and options such as growth beside it")
    return {"interior": interior, "goal": dict(goal), "options": as_json(wanted), "preset": preset}


def as_json(wanted: Mapping[str, Any]) -> str:
    """Wishes for points inside that are given, as the library reads them."""
    return json.dumps({key: plain(value, key) for key, value in wanted.items() if value is not None})
