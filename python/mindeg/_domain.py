"""Domains from what Python users have: numbers, arrays, dicts, JSON, files, shapely's polygons."""

import json
import os
import warnings
from collections.abc import Mapping

import numpy as np

from . import _mindeg


class Domain(_mindeg._Domain):
    """A polygon with its boundary points.

    ``source`` is one of

    - a dict or a JSON text, as ``docs/domains.md`` describes them;
    - a path to a file: JSON, or Gmsh's MSH with lines, Triangle's .poly, SVG, DXF, GeoJSON, WKT, OBJ lines
      or a CSV of points, as ``docs/outlines.md`` describes them;
    - an (n, 2) array, which is one ring of points, or a list of such rings: the outer one, then holes;
    - anything with ``__geo_interface__`` that is a polygon, such as one of shapely's.

    Points of arrays and polygons are the boundary points and come back bit for bit; so do those of a file,
    unless ``size`` gives the length of the intervals instead. A side ends where its file begins another or
    where the boundary turns by more than ``corner_angle`` degrees. ``feature`` is the name or the number,
    from 1, of one polygon of several; ``repair`` parts rings that touch themselves.
    """

    def __new__(cls, source, *, name=None, **options):
        text = _json_of(source, options)
        if name is not None:
            text = json.dumps({**json.loads(text), "name": name})
        return super().__new__(cls, text)

    def __init__(self, source, *, name=None, **options):
        pass

    def __reduce__(self):
        return Domain, (self.to_json(),)

    def compare(self):
        """Delaunay, ear clipping and a fan beside mindeg: a dict, as ``mindeg compare`` writes it."""
        return json.loads(self._compare())

    def _repr_svg_(self):
        return self.mesh()._repr_svg_()


def rectangle(width, height, *, intervals=None, size=None, names=None, name=None):
    """An upright rectangle with a corner at the origin; its sides are bottom, right, top, left.

    ``intervals`` is one number for all sides or one for each; ``size`` is the length to aim at instead.
    """
    outline = {"rectangle": {"width": _number(width), "height": _number(height)}}
    return _with_sides(outline, 4, intervals, size, names, name)


def polygon(corners, *, holes=(), intervals=None, size=None, names=None, name=None):
    """A polygon with these corners, convex or not; ``holes`` are lists of corners.

    ``intervals`` is one number for all sides or one for each side of the outer ring; ``size`` is the length
    to aim at instead. With ``holes``, give one number or a size.
    """
    outline = {"polygon": {"corners": _rows(corners)}}
    if len(holes):
        outline["holes"] = [{"corners": _rows(hole)} for hole in holes]
    return _with_sides(outline, len(corners), intervals, size, names, name)


def _with_sides(outline, count, intervals, size, names, name):
    if name is not None:
        outline["name"] = name
    if (intervals is None) == (size is None):
        raise ValueError("give either intervals or size")
    sides = [{} for _ in range(count)]
    if size is not None:
        outline["size"] = _number(size)
    else:
        if np.ndim(intervals) == 0:
            for hole in outline.get("holes", []):
                hole["sides"] = [{"intervals": int(intervals)} for _ in hole["corners"]]
            intervals = [intervals] * count
        if len(intervals) != count:
            raise ValueError(f"found {len(intervals)} intervals for {count} sides; give one for each")
        for side, of_side in zip(sides, intervals):
            side["intervals"] = int(of_side)
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
    if isinstance(source, os.PathLike) or isinstance(source, str) and source.lstrip()[:1] != "{":
        return _file(source, **options)
    if options:
        raise ValueError(f"{', '.join(options)}: for a path to a file only")
    if isinstance(source, _mindeg._Domain):
        return source.to_json()
    if isinstance(source, str):
        return source
    if isinstance(source, Mapping) and "type" not in source:
        return json.dumps(source, default=_plain)
    geometry = source if isinstance(source, Mapping) else getattr(source, "__geo_interface__", None)
    if geometry is not None:
        return _rings_json(_rings_of(geometry))
    return _rings_json(_rings_of_arrays(source))


def _file(path, *, size=None, corner_angle=30.0, feature=None, repair=False):
    feature = None if feature is None else str(feature)
    text, notes = _mindeg._domain_of_file(path, size, corner_angle, feature, repair)
    for note in notes:
        warnings.warn(note, stacklevel=4)
    return text


def _rings_of_arrays(source):
    """One ring of points, or a list of rings."""
    if hasattr(source, "__array__"):
        source = np.asarray(source)
    try:
        is_ring = np.ndim(source[0]) == 1 and np.ndim(source[0][0]) == 0
    except (IndexError, KeyError):
        raise ValueError("no points; give (n, 2)") from None
    except TypeError:
        kind = type(source).__name__
        raise TypeError(f"{kind} is no domain; give a dict, a path, points or a polygon") from None
    return [source] if is_ring else source


def _rings_of(geometry):
    kind = geometry.get("type")
    if kind == "Feature":
        return _rings_of(geometry["geometry"])
    if kind != "Polygon":
        raise ValueError(f"the geometry is a {kind}; give a Polygon, one domain each")
    return [_opened(ring) for ring in geometry["coordinates"]]


def _opened(ring):
    """A ring without the last point where that repeats the first, and in the plane."""
    ring = [point[:2] for point in ring]
    return ring[:-1] if len(ring) > 1 and tuple(ring[0]) == tuple(ring[-1]) else ring


def _rings_json(rings):
    outer, *holes = [_rows(ring) for ring in rings]
    domain = {"ring": outer}
    if holes:
        domain["holes"] = [{"ring": hole} for hole in holes]
    return json.dumps(domain)


def _rows(points):
    """Rows of two numbers; a float stays the float it is."""
    rows = np.asarray(points)
    if rows.dtype.kind not in "iuf":
        raise ValueError(f"found points of the type {rows.dtype}; give real numbers")
    rows = rows.astype(float)
    if rows.ndim != 2 or rows.shape[1] != 2:
        raise ValueError(f"found points of shape {rows.shape}; give (n, 2)")
    return rows.tolist()


def _number(value):
    return value if isinstance(value, int) else float(value)


def _plain(value):
    """Numpy's numbers and arrays in a dict."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} in a domain; give numbers, texts, lists and dicts")
