"""Domains from what Python users have: numbers, arrays, dicts, JSON, files, shapely's polygons."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from . import _mindeg
from ._options import MeshOptions, ReadingOptions, separated, shows_its_options, wish
from ._plain import number, plain, whole_number

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
    from typing_extensions import Self, Unpack


class Domain(_mindeg._Domain):
    """A polygon with its boundary points, holes and regions: what to mesh.

    ``source`` is one of

    - an (n, 2) array, which is one ring of points, or a list of such rings: the outer one, then holes. A ring may
      repeat its first point at its end;
    - anything with ``__geo_interface__`` that has polygons, such as what shapely and geopandas (with a CRS) give, or a dict of GeoJSON;
    - a path to a file: JSON, or Gmsh's MSH with lines, Triangle's .poly, SVG, DXF, GeoJSON, TopoJSON, WKT, OBJ lines
      or a CSV of points, as ``docs/outlines.md`` describes them;
    - a dict or a JSON text, as ``docs/domains.md`` describes them.

    Points of arrays, polygons and files are the boundary points and come back bit for bit, unless ``size``
    gives the length of the intervals instead, and ``size_of`` that on sides and lines of a name: ``{"river": 200}``. A side ends where its file begins another or where the
    boundary turns by more than ``corner_angle`` degrees, 30 unless given; without these options, a ring of an
    array or a polygon is one side.

    ``feature`` is the name or the number, from 1, of one polygon of several; several that share edges and hang together
    are the regions of one domain, called after the property or column ``name_by``. ``layer`` chooses an object of
    a TopoJSON or a layer of a DXF. ``sea_in`` is a box (west, south, east, north): the largest part of it that no polygon
    covers is the domain, the sea between lands. ``repair`` makes polygons of rings that cross or touch, by the ``fill_rule`` "evenodd" or
    "nonzero", and mends borders between polygons; ``snap`` is how near points become one. ``project`` makes metres of degrees of
    longitude and latitude: "auto", "utm", "laea", "stereographic" or "EPSG:N"; "none" takes them as planar.

    Domains are equal if their points, sides, names, limits and wishes are.
    """

    @shows_its_options(ReadingOptions)
    def __new__(
        cls,
        source: str | os.PathLike[str] | Mapping[str, Any] | npt.ArrayLike | Any,
        *,
        name: str | None = None,
        **reading: Unpack[ReadingOptions],
    ) -> Self:
        goal, wanted, options = separated(reading)
        for key in [*goal, *wanted]:
            raise TypeError(f"{key} is for meshes; give it to Domain.mesh")
        text, names = _json_of(source, options)
        if name is not None:
            text = json.dumps({**json.loads(text), "name": name})
        return super().__new__(cls, text, names)

    def __reduce__(self):
        return Domain, (self.to_json(),)

    @shows_its_options(MeshOptions)
    def mesh(self, *, interior: bool | None = None, preset: str | None = None, **options: Unpack[MeshOptions]) -> _mindeg.Mesh:
        """The mesh of least degree, or the one that a goal asks for; or, with ``interior=True``, a mesh with points inside.

        Of the boundary points alone: ``keep_angle=0.95`` or ``"95%"`` gives the least degree that keeps this share of Delaunay's
        minimum angle, ``max_degree=6`` the largest angle within a degree. ``mindeg.GOALS`` has all goals.

        With points inside the boundary stays, degrees are 5 to 7 inside, and the minimum angle gets near its proven limit.
        ``growth`` is how fast sizes grow from the boundary. ``sizes`` are rows x, y, size, the path of a grid or a
        background mesh, a function that takes an (n, 2) array and gives n sizes, a dict as in JSON, or a list of these;
        ``fixed_points`` are rows x, y; ``docs/interior.md`` explains all. ``report`` of the mesh has what was reached.

        Without ``interior``, the domain's JSON decides. A mesh that breaks a rule of ``preset``, a program of ``mindeg.PRESETS``,
        is a ``ValueError`` that names the place.
        """
        goal, wanted, reading = separated(options)
        for key in reading:
            raise TypeError(f"{key} is for making a domain; give it to Domain, or to mindeg.mesh")
        return self._mesh(self._wish(interior, preset, goal, wanted))

    def _wish(self, interior: bool | None, preset: str | None, goal: Mapping[str, Any], wanted: Mapping[str, Any]) -> dict[str, Any]:
        """A wish as the library reads it, with the sizes of functions at this domain's points."""
        wanted = {name: value for name, value in wanted.items() if value is not None}
        if "sizes" in wanted:
            from ._sizes import given_sizes

            wanted["sizes"] = given_sizes(wanted["sizes"], self.points)
        return wish(interior, preset, goal, wanted)

    @shows_its_options()
    def condition(
        self,
        *,
        limit: float = 25.0,
        within: float | None = None,
        size: float | None = None,
        growth: float | None = None,
        least_island: float | None = None,
        narrowest: float | None = None,
        keep: Sequence[str] = (),
        across: float | None = None,
        min_size: float | None = None,
        sizes: npt.ArrayLike | Callable[[Any], npt.ArrayLike] | Sequence[Any] | Mapping[str, Any] | str | os.PathLike[str] | None = None,
        preset: str | None = None,
    ) -> tuple[Domain, dict[str, Any]]:
        """The least change of the boundary that lets a mesh with points inside have no angle below ``limit`` degrees.

        The boundary moves by ``within`` at most, an eighth of ``size`` without it; ``size`` is the length of edges, which change
        gradually, by ``growth`` (0.4 without it; 0 puts points only where the limit needs them). ``keep`` names sides that stay. Straits, inlets and spits below ``narrowest`` are closed or cut off. A border of two regions changes once, for both.
        Edges get no longer than ``across`` and ``sizes``, as in ``mesh``, want the mesh to be there, down to ``min_size`` or an eighth of ``size``.
        Gives the new domain, and the changes as ``mindeg condition --json`` has them.
        """
        keep = [keep] if isinstance(keep, str) else list(keep)
        wanted = {"across": across, "min_size": min_size, "sizes": sizes}
        given = (within, size, growth, least_island, narrowest)
        text, changes = self._condition(self._wish(True, preset, {}, wanted), limit, given, keep)
        return _mindeg._Domain.__new__(Domain, text), changes

    def advice(self) -> dict[str, Any]:
        """The mesh to take, by what it is for: the same advice as in ``mindeg degree`` and ``mindeg explore``.

        The keys ``"solver"``, ``"patch"`` and ``"fewest"`` have ``max_degree``, ``min_angle`` and ``share_of_delaunay`` of a mesh,
        ``words``, which say why to take it, and ``options``: ``domain.mesh(**domain.advice()["patch"]["options"])`` makes it.
        ``first`` is the key to take unless you know better; a mesh that cannot be made is None, and ``no_solver`` says why no points
        can be inside. Where points on edges of the boundary bring a larger angle, ``conditioned`` has the figures of that mesh,
        ``domain.condition()[0].mesh(interior=True)``, and ``points_on_edges`` their number; else None and 0. Takes the time of four meshes.
        """
        found, options = self._advice()
        words = dict(found["words"])
        words["solver"] = " ".join(filter(None, (words["solver"], found["on_edges"])))
        told = {key: found[key] for key in ("first", "no_solver", "conditioned", "points_on_edges")}
        return told | {
            purpose: found[purpose] and {**found[purpose], "words": words[purpose], "options": options[purpose]} for purpose in options
        }

    def compare(self) -> dict[str, Any]:
        """Delaunay, ear clipping and a fan beside mindeg: a dict, as ``mindeg compare`` writes it."""
        return json.loads(self._compare())

    def _repr_svg_(self):
        return self.mesh()._repr_svg_()


@shows_its_options()
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
    return _with_sides(outline, 4, intervals, size, names, name, [("rectangle.width", "width"), ("rectangle.height", "height")])


@shows_its_options()
def polygon(
    corners: npt.ArrayLike,
    *,
    holes: Sequence[npt.ArrayLike] = (),
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
    called = [("polygon.corners", "corners"), ("polygon", "corners"), *((f"holes[{index}].corners", f"holes[{index}]") for index in range(len(holes)))]
    return _with_sides(outline, len(outline["polygon"]["corners"]), intervals, size, names, name, called)


def _with_sides(outline, count, intervals, size, names, name, called):
    """A domain of an outline whose keys are ``called`` by arguments."""
    if name is not None:
        outline["name"] = name
    if (intervals is None) == (size is None):
        raise ValueError("give either intervals or size")
    sides = [{} for _ in range(count)]
    if size is not None:
        outline["size"] = number(size, "size")
    elif isinstance(intervals, str) or not hasattr(intervals, "__len__") or getattr(intervals, "shape", None) == ():
        intervals = whole_number(intervals, "intervals")
        for hole in outline.get("holes", []):
            hole["sides"] = [{"intervals": intervals} for _ in hole["corners"]]
        sides = [{"intervals": intervals} for _ in range(count)]
    else:
        if len(intervals) != count:
            raise ValueError(f"found {len(intervals)} intervals for {count} sides; give one for each")
        sides = [{"intervals": whole_number(of_side, f"intervals[{side}]")} for side, of_side in enumerate(intervals)]
        called = [*called, *((f"sides[{side}].intervals", f"intervals[{side}]") for side in range(count))]
    if names is not None:
        if len(names) != count:
            raise ValueError(f"found {len(names)} names for {count} sides; give one for each")
        for side, of_side in zip(sides, names):
            if of_side is not None:
                side["name"] = str(of_side)
        called = [*called, *((f"sides[{side}].name", f"names[{side}]") for side in range(count))]
    if any(sides):
        outline["sides"] = sides
    return _mindeg._Domain.__new__(Domain, json.dumps(outline), called)


def _json_of(source, options) -> tuple[str, list[tuple[str, str]] | None]:
    """The domain in JSON, the one form that the library reads, and what its keys are called in arguments, if it was made of these."""
    path, text = path_or_text(source)
    if path is not None:
        return _outline(path, None, **options), None
    if text is None and is_domain(source):
        if options:
            keys = " and ".join(options)
            raise ValueError(f"{keys} is for points, polygons and files; a domain in JSON has its own keys for that")
        if isinstance(source, Mapping):
            return json.dumps(plain(source, "")), []
        return (source, None) if isinstance(source, str) else (source.to_json(), [])
    if not has_reference_system(source):
        options = {"project": "none", **options} if options or text is not None else options
    if text is not None:
        return _outline(None, text, **options), []
    if options:
        text, called = polygon_text(source)
        return _outline(None, text, **options, called=called), []
    rings = _rings(source)
    outer, *holes = _points_of(rings)
    paths = ["ring", *(f"holes[{index}].ring" for index in range(len(holes)))]
    domain: dict[str, Any] = {"ring": outer, "holes": [{"ring": hole} for hole in holes]}
    return json.dumps(domain if holes else {"ring": outer}), list(zip(paths, rings))


def path_or_text(source) -> tuple[str | os.PathLike[str] | None, str | None]:
    """The path of a file, or the text of GeoJSON or of a model, that a source is; neither for others."""
    if isinstance(source, os.PathLike) or isinstance(source, str) and source.lstrip()[:1] not in ("{", "["):
        return source, None
    if isinstance(source, Mapping) and "faces" in source:
        return None, json.dumps(plain(source, ""))
    geometry = _geometry(source)
    if geometry is None or geometry.get("type") == "Polygon":
        return None, None
    parts = geometry.get("features", geometry.get("geometries", geometry.get("coordinates", [None])))
    if len(parts) == 0:
        kind = "dict" if isinstance(source, Mapping) else type(source).__name__
        raise ValueError(f"the {kind} is empty; give at least one polygon")
    crs = getattr(source, "crs", None)
    if crs is not None and getattr(crs, "is_projected", False):
        code = crs.to_epsg()
        geometry = {**geometry, "crs": {"type": "name", "properties": {"name": f"EPSG:{code}" if code else crs.to_string()}}}
    return None, json.dumps(geometry, default=plain)


def is_domain(source) -> bool:
    """Whether a source that is no file and has no text is a domain, as an object or in JSON."""
    return isinstance(source, (str, _mindeg._Domain)) or isinstance(source, Mapping) and "type" not in source


def has_reference_system(source) -> bool:
    """Whether a source says what its coordinates are, as GeoJSON and what has a CRS do; shapes and arrays are planar."""
    crs = getattr(source, "crs", None)
    return isinstance(source, Mapping) or any(getattr(crs, kind, False) for kind in ("is_geographic", "is_projected"))


def _geometry(source) -> Mapping[str, Any] | None:
    """The GeoJSON that a source is or has."""
    if isinstance(source, Mapping):
        return source if "type" in source else None
    if isinstance(source, (list, tuple)) and source and all(isinstance(one, Mapping) or hasattr(one, "__geo_interface__") for one in source):
        found = [_geometry(one) or {} for one in source]
        features = [one if one.get("type") == "Feature" else {"type": "Feature", "properties": {}, "geometry": one} for one in found]
        return {"type": "FeatureCollection", "features": features}
    geometry: Mapping[str, Any] | None = getattr(source, "__geo_interface__", None)
    if geometry and geometry.get("type") == "LinearRing":
        # shapely's own type, which GeoJSON does not have.
        return {"type": "Polygon", "coordinates": [geometry["coordinates"]]}
    return geometry


def _rings(source) -> dict[str, Any]:
    """The rings of a polygon or of arrays, each with its key."""
    geometry = _geometry(source)
    if geometry is not None:
        return {f"coordinates[{index}]": [point[:2] for point in ring] for index, ring in enumerate(geometry["coordinates"])}
    import numpy as np

    if hasattr(source, "__array__") and not isinstance(source, np.ndarray):
        source = np.asarray(source)
    try:
        is_ring = np.ndim(source[0]) == 1 and np.ndim(source[0][0]) == 0
    except (IndexError, KeyError):
        raise ValueError("no points; give (n, 2)") from None
    except TypeError:
        kind = type(source).__name__
        raise TypeError(f"{kind} is no domain; give points, a polygon, a path or a dict") from None
    return {"points": source} if is_ring else {f"rings[{index}]": ring for index, ring in enumerate(source)}


def polygon_text(source) -> tuple[str, str]:
    """The GeoJSON of a polygon or of arrays, and what messages call it."""
    rings = _rings(source)
    points = _points_of(rings)
    return json.dumps({"type": "Polygon", "coordinates": points}), next(iter(rings)).split("[")[0]


def _points_of(rings) -> list[Any]:
    if not rings:
        raise ValueError("the polygon is empty; give at least three points")
    return [_ring(ring, key) for key, ring in rings.items()]


def _ring(points, key):
    """Points of a ring in the plane, without the last one where it repeats the first, as it does in files."""
    rows = _mindeg._rows_of_two(points, key)
    return rows[:-1] if len(rows) > 1 and rows[0] == rows[-1] else rows


#: How the polygons of a source are read, where nothing else is asked for.
_READING: dict[str, Any] = {
    "called": "the outline",
    "layer": None,
    "name_by": None,
    "sea_in": None,
    "corner_angle": 30.0,
    "size": None,
    "size_of": {},
    "feature": None,
    "repair": False,
    "snap": None,
    "fill_rule": None,
    "project": None,
}


def reading_of(path, text, **options):
    """A file, or GeoJSON, and all options of its reader."""
    options = {key: _read_as(key, given) for key, given in options.items() if given is not None}
    return {**_READING, **options, "path": path, "text": text}


def _read_as(key, given):
    """An option of a reader as the library takes it; a fault names its key."""
    if key in ("size", "snap", "corner_angle"):
        return number(given, key)
    if key == "size_of":
        if not isinstance(given, Mapping):
            raise TypeError(f"{key} is {given!r}; give a dict of names and sizes")
        return {str(name): number(size, f"{key}[{name!r}]") for name, size in given.items()}
    if key == "feature":
        return str(given)
    if key == "sea_in":
        corners = list(given) if isinstance(given, Iterable) and not isinstance(given, str) else []
        if len(corners) != 4:
            raise ValueError(f"sea_in is {given!r}; give west, south, east and north")
        return [number(corner, key) for corner in corners]
    is_repair = key == "repair"
    if not isinstance(given, bool if is_repair else str):
        raise TypeError(f"{key} is {given!r}; give {'True or False' if is_repair else 'a text'}")
    return given


def _outline(path, text, **options):
    """The domain in a file, or in GeoJSON, as the readers of outlines make it."""
    domain, notes = _mindeg._domain_of_outline(reading_of(path, text, **options))
    warn(notes, 5)
    return domain


def warn(notes: Iterable[str], stacklevel: int) -> None:
    """Says what a reader left out or changed, at the line that called it."""
    for note in notes:
        warnings.warn(note, stacklevel=stacklevel)
