"""Domains from what Python users have: numbers, arrays, dicts, JSON, files, shapely's polygons."""

import json
import os
import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from . import _mindeg
from ._options import GoalOptions, InteriorOptions, as_json, names_its_options
from ._plain import number, plain, whole_number
from ._sizes import given_sizes

if TYPE_CHECKING:
    from typing_extensions import Self, Unpack


class Domain(_mindeg._Domain):
    """A polygon with its boundary points.

    ``source`` is one of

    - a dict or a JSON text, as ``docs/domains.md`` describes them;
    - a path to a file: JSON, or Gmsh's MSH with lines, Triangle's .poly, SVG, DXF, GeoJSON, WKT, OBJ lines
      or a CSV of points, as ``docs/outlines.md`` describes them;
    - an (n, 2) array, which is one ring of points, or a list of such rings: the outer one, then holes;
    - anything with ``__geo_interface__`` that has polygons, such as what shapely and geopandas give.

    Points of arrays, polygons and files are the boundary points and come back bit for bit, unless ``size``
    gives the length of the intervals instead. A side ends where its file begins another or where the
    boundary turns by more than ``corner_angle`` degrees, 30 by default; without these options, a ring of an
    array or a polygon is one side. ``feature`` is the name or the number, from 1, of one polygon of several;
    several that share edges and hang together are the regions of one domain, called after the property or column
    ``name_by``. ``layer`` chooses an object of a TopoJSON. ``repair`` makes polygons of rings that cross or touch, by the
    ``fill_rule`` "evenodd" or "nonzero", and mends borders between polygons; ``snap`` is how near points become one.
    """

    def __new__(
        cls,
        source: "str | os.PathLike[str] | Mapping[str, Any] | npt.ArrayLike | Any",
        *,
        name: str | None = None,
        size: float | None = None,
        corner_angle: float | None = None,
        feature: str | int | None = None,
        layer: str | None = None,
        name_by: str | None = None,
        repair: bool = False,
        snap: float | None = None,
        fill_rule: "Literal['evenodd', 'nonzero'] | None" = None,
    ) -> "Self":
        options = {
            "size": size,
            "corner_angle": corner_angle,
            "feature": feature,
            "layer": layer,
            "name_by": name_by,
            "repair": repair,
            "snap": snap,
            "fill_rule": fill_rule,
        }
        text = _json_of(source, {key: given for key, given in options.items() if given is not None and given is not False})
        if name is not None:
            text = json.dumps({**json.loads(text), "name": name})
        return super().__new__(cls, text)

    def __reduce__(self):
        return Domain, (self.to_json(),)

    @names_its_options(GoalOptions)
    def mesh(self, **goal: "Unpack[GoalOptions]") -> _mindeg.Mesh:
        """The mesh of least degree, or the one that a goal asks for: ``keep_angle=0.95`` or ``"95%"`` the least degree
        that keeps this share of Delaunay's minimum angle, ``max_degree`` the largest angle within a degree.
        ``mindeg.GOALS`` has all goals.
        """
        return self._mesh(**goal)

    @names_its_options(InteriorOptions)
    def interior(self, **options: "Unpack[InteriorOptions]") -> _mindeg.Mesh:
        """A mesh with interior points: the boundary stays, degrees are 5 to 7 inside, and the minimum angle gets near
        its proven limit. ``sizes`` are rows x, y, size, the path of a grid or a background mesh, a function that takes an
        (n, 2) array and gives n sizes, a dict as in JSON, or a list of these; ``fixed_points`` are rows x, y; ``mesh.report``
        has what was reached. ``docs/interior.md`` explains the options.
        """
        if options.get("sizes") is not None:
            options["sizes"] = given_sizes(options["sizes"], self.points)
        return self._interior(as_json(options))

    def compare(self) -> dict[str, Any]:
        """Delaunay, ear clipping and a fan beside mindeg: a dict, as ``mindeg compare`` writes it."""
        return json.loads(self._compare())

    def _repr_svg_(self):
        return self.mesh()._repr_svg_()


def rectangle(
    width: float,
    height: float,
    *,
    intervals: int | Sequence[int] | np.ndarray | None = None,
    size: float | None = None,
    names: Sequence[str | None] | None = None,
    name: str | None = None,
) -> Domain:
    """An upright rectangle with a corner at the origin; its sides are bottom, right, top, left.

    ``intervals`` is one number for all sides or one for each; ``size`` is the length to aim at instead.
    """
    outline = {"rectangle": {"width": number(width, "width"), "height": number(height, "height")}}
    return _with_sides(outline, 4, intervals, size, names, name)


def polygon(
    corners: "npt.ArrayLike",
    *,
    holes: "Sequence[npt.ArrayLike]" = (),
    intervals: int | Sequence[int] | np.ndarray | None = None,
    size: float | None = None,
    names: Sequence[str | None] | None = None,
    name: str | None = None,
) -> Domain:
    """A polygon with these corners, convex or not; ``holes`` are lists of corners.

    ``intervals`` is one number for all sides or one for each side of the outer ring; ``size`` is the length
    to aim at instead. With ``holes``, give one number or a size.
    """
    outline: dict[str, Any] = {"polygon": {"corners": _ring(corners, "corners")}}
    if len(holes):
        outline["holes"] = [{"corners": _ring(hole, f"holes[{place}]")} for place, hole in enumerate(holes)]
    return _with_sides(outline, len(outline["polygon"]["corners"]), intervals, size, names, name)


def _with_sides(outline, count, intervals, size, names, name):
    if name is not None:
        outline["name"] = name
    if (intervals is None) == (size is None):
        raise ValueError("give either intervals or size")
    sides = [{} for _ in range(count)]
    if size is not None:
        outline["size"] = number(size, "size")
    elif np.ndim(intervals) == 0:
        intervals = whole_number(intervals, "intervals")
        for hole in outline.get("holes", []):
            hole["sides"] = [{"intervals": intervals} for _ in hole["corners"]]
        sides = [{"intervals": intervals} for _ in range(count)]
    else:
        if len(intervals) != count:
            raise ValueError(f"found {len(intervals)} intervals for {count} sides; give one for each")
        sides = [{"intervals": whole_number(of_side, f"intervals[{side}]")} for side, of_side in enumerate(intervals)]
    if names is not None:
        if len(names) != count:
            raise ValueError(f"found {len(names)} names for {count} sides; give one for each")
        for side, of_side in zip(sides, names):
            if of_side is not None:
                side["name"] = str(of_side)
    if any(sides):
        outline["sides"] = sides
    return Domain(outline)


def _json_of(source, options):
    """The domain in JSON: the one form that the library reads, and that is pickled."""
    if isinstance(source, os.PathLike) or isinstance(source, str) and source.lstrip()[:1] != "{":
        return _outline(source, None, **options)
    is_mapping = isinstance(source, Mapping)
    if isinstance(source, (str, _mindeg._Domain)) or is_mapping and "type" not in source:
        if options:
            keys = " and ".join(options)
            raise ValueError(f"{keys} is for points, polygons and files; a domain in JSON has its own keys for that")
        if is_mapping:
            return json.dumps(plain(source, ""))
        return source if isinstance(source, str) else source.to_json()
    geometry = source if is_mapping else getattr(source, "__geo_interface__", None)
    if geometry is None:
        rings = _rings_of_arrays(source)
    elif geometry.get("type") == "Polygon":
        rings = {f"coordinates[{index}]": [point[:2] for point in ring] for index, ring in enumerate(geometry["coordinates"])}
    else:
        return _outline(None, json.dumps(geometry, default=plain), **options)
    if not rings:
        raise ValueError("the polygon is empty; give at least three points")
    outer, *holes = [_ring(ring, key) for key, ring in rings.items()]
    if options:
        return _outline(None, json.dumps({"type": "Polygon", "coordinates": [outer, *holes]}), **options)
    return json.dumps({"ring": outer, **({"holes": [{"ring": hole} for hole in holes]} if holes else {})})


@names_its_options(InteriorOptions)
def mesh_map(
    source: "str | os.PathLike[str] | Mapping[str, Any] | Any",
    *,
    layer: str | None = None,
    name_by: str | None = None,
    size: float | None = None,
    corner_angle: float | None = None,
    repair: bool = False,
    snap: float | None = None,
    fill_rule: "Literal['evenodd', 'nonzero'] | None" = None,
    **options: "Unpack[InteriorOptions]",
) -> _mindeg.Mesh:
    """One mesh with interior points of all polygons of a source, whose regions they are: ``mesh.groups`` by name.

    ``source`` is the path of a file, a dict of GeoJSON, or anything with ``__geo_interface__``, such as a GeoDataFrame of
    geopandas, whose column ``name_by`` names the regions. Borders that polygons share are there once. The other options
    are those of ``Domain`` and of ``Domain.interior``; ``docs/maps.md`` explains maps.
    """
    if isinstance(source, (str, os.PathLike)):
        path, text = source, None
    else:
        geometry = source if isinstance(source, Mapping) else getattr(source, "__geo_interface__", None)
        if geometry is None:
            raise TypeError(f"{type(source).__name__} has no polygons; give a path, GeoJSON or what has __geo_interface__")
        path, text = None, json.dumps(geometry, default=plain)
    if options.get("sizes") is not None:
        if callable(options["sizes"]):
            raise ValueError("sizes: a function is for a single domain; give an array, a grid or a file")
        options["sizes"] = given_sizes(options["sizes"], np.zeros((1, 2)))
    given = _reading(
        path, text, layer=layer, name_by=name_by, size=size, corner_angle=corner_angle, repair=repair, snap=snap, fill_rule=fill_rule
    )
    mesh, notes = _mindeg._mesh_of_map(given, as_json(options))
    for note in notes:
        warnings.warn(note, stacklevel=2)
    return mesh


#: How the polygons of a source are read, where nothing else is asked for.
_READING = {
    "layer": None,
    "name_by": None,
    "corner_angle": 30.0,
    "size": None,
    "feature": None,
    "repair": False,
    "snap": None,
    "fill_rule": None,
}


def _reading(path, text, **options):
    """A file, or GeoJSON, and all options of its reader."""
    options = {key: given for key, given in options.items() if given is not None}
    if "feature" in options:
        options["feature"] = str(options["feature"])
    return {**_READING, **options, "path": path, "text": text}


def _outline(path, text, **options):
    """The domain in a file, or in GeoJSON, as the readers of outlines make it."""
    domain, notes = _mindeg._domain_of_outline(_reading(path, text, **options))
    for note in notes:
        warnings.warn(note, stacklevel=4)
    return domain


def _rings_of_arrays(source):
    """One ring of points, or a list of rings, each with its key."""
    if hasattr(source, "__array__") and not isinstance(source, np.ndarray):
        source = np.asarray(source)
    try:
        is_ring = np.ndim(source[0]) == 1 and np.ndim(source[0][0]) == 0
    except (IndexError, KeyError):
        raise ValueError("no points; give (n, 2)") from None
    except TypeError:
        kind = type(source).__name__
        raise TypeError(f"{kind} is no domain; give a dict, a path, points or a polygon") from None
    return {"points": source} if is_ring else {f"rings[{index}]": ring for index, ring in enumerate(source)}


def _ring(points, key):
    """Points of a ring in the plane, without the last one where it repeats the first, as it does in files."""
    rows = _mindeg._rows_of_two(points, key)
    return rows[:-1] if len(rows) > 1 and rows[0] == rows[-1] else rows
