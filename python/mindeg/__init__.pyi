import os
from collections.abc import Mapping, Sequence
from typing import Any, final

import numpy as np
import numpy.typing as npt

_Points = npt.ArrayLike
_Source = str | os.PathLike[str] | Mapping[str, Any] | npt.ArrayLike | Any

@final
class Degree:
    reached: int
    at_least: int
    @property
    def is_proven(self) -> bool: ...

@final
class Suggestion:
    max_degree: int
    changes: list[tuple[int, int]]
    intervals: list[int]

@final
class TradeOffPoint:
    max_degree: int
    min_angle: float
    share: float
    mesh: Mesh

@final
class Mesh:
    def __new__(
        cls, points: npt.ArrayLike, triangles: npt.ArrayLike, name: str | None = None
    ) -> Mesh: ...
    @property
    def points(self) -> npt.NDArray[np.float64]: ...
    @property
    def triangles(self) -> npt.NDArray[np.uint32]: ...
    @property
    def degrees(self) -> npt.NDArray[np.uint32]: ...
    @property
    def lines(self) -> list[tuple[str, npt.NDArray[np.uint32]]]: ...
    @property
    def name(self) -> str | None: ...
    @property
    def max_degree(self) -> int: ...
    @property
    def min_angle(self) -> float: ...
    @property
    def max_angle(self) -> float: ...
    @property
    def least_max_degree(self) -> int | None: ...
    @property
    def found_by(self) -> str | None: ...
    @property
    def report(self) -> dict[str, Any] | None: ...
    def save(
        self,
        path: str | os.PathLike[str],
        *,
        format: str | None = None,
        ascii: bool = False,
        msh_version: str | None = None,
        double: bool = False,
        fields: bool = True,
        degree_colors: bool = False,
    ) -> None: ...
    def to_meshio(self) -> Any: ...
    def to_trimesh(self) -> Any: ...
    def to_pyvista(self) -> Any: ...

class Domain:
    def __new__(
        cls,
        source: _Source,
        *,
        name: str | None = None,
        size: float | None = None,
        corner_angle: float = 30.0,
        feature: str | int | None = None,
        repair: bool = False,
    ) -> Domain: ...
    @property
    def name(self) -> str | None: ...
    @property
    def points(self) -> npt.NDArray[np.float64]: ...
    def to_json(self) -> str: ...
    def degree(self) -> Degree: ...
    def mesh(self, *, max_degree: int | None = None, keep_angle: float | None = None) -> Mesh: ...
    def interior(self, **options: Any) -> Mesh: ...
    def tradeoff(self) -> list[TradeOffPoint]: ...
    def suggest(self) -> list[Suggestion]: ...
    def compare(self) -> dict[str, Any]: ...

def rectangle(
    width: float,
    height: float,
    *,
    intervals: int | Sequence[int] | None = None,
    size: float | None = None,
    names: Sequence[str | None] | None = None,
    name: str | None = None,
) -> Domain: ...
def polygon(
    corners: _Points,
    *,
    holes: Sequence[_Points] = (),
    intervals: int | Sequence[int] | None = None,
    size: float | None = None,
    names: Sequence[str | None] | None = None,
    name: str | None = None,
) -> Domain: ...
def read(path: str | os.PathLike[str]) -> Mesh: ...
def inspect(
    points: npt.ArrayLike,
    triangles: npt.ArrayLike,
    *,
    weld: float | None = ...,
    corner_angle: float = 1.0,
    poles_above: int = 8,
) -> dict[str, Any]: ...
def improve(points: npt.ArrayLike, triangles: npt.ArrayLike, **options: Any) -> Mesh: ...
def fill_loop(
    points: npt.ArrayLike,
    *,
    external: Sequence[int] | None = None,
    excluded: Sequence[tuple[int, int]] = ...,
    max_degree: int | None = None,
) -> tuple[npt.NDArray[np.uint32], dict[str, Any]]: ...
def bridge_loops(
    first: npt.ArrayLike,
    second: npt.ArrayLike,
    *,
    external: Sequence[int] | None = None,
    excluded: Sequence[tuple[int, int]] = ...,
    max_degree: int | None = None,
) -> tuple[npt.NDArray[np.uint32], dict[str, Any]]: ...
