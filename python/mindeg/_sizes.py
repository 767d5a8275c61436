"""Sizes of interior points from arrays, files and functions, as the library reads them."""

import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _mindeg

#: Cells along the longer side of the domain that a function is asked in first.
_FIRST = 32
#: How often a cell may be divided in four, and how many cells there may be.
_LEVELS = 8
_MOST_CELLS = 200_000
#: A cell is divided where a value in its middle differs from the mean of its corners by more than this share.
_TOLERANCE = 0.05


def given_sizes(sizes: Any, points: "npt.NDArray[np.float64] | None") -> Any:
    """The list of sizes in JSON, for a domain with these boundary points; functions need the points."""
    if callable(sizes) or isinstance(sizes, (str, os.PathLike, Mapping)):
        sizes = [sizes]
    if isinstance(sizes, np.ndarray) or not isinstance(sizes, Sequence):
        return sizes
    return [_given(size, points) for size in sizes]


def _given(size, points):
    if callable(size):
        return _sampled(size, points.min(axis=0), points.max(axis=0))
    if isinstance(size, (str, os.PathLike)):
        return _mindeg._sizes_of_file(os.fspath(size))
    if isinstance(size, Mapping) and "rows" in size:
        rows = np.asarray(size["rows"], float)
        return {**size, "rows": [[value if np.isfinite(value) else None for value in row] for row in rows.tolist()]}
    return size


def _sampled(function, low, high):
    """A function of an (n, 2) array as sizes on triangles: on a grid, and finer where it is not linear. Values that are
    no sizes, such as NaN, are left out.
    """
    side = float((high - low).max()) / _FIRST
    columns, rows = np.maximum(1, np.ceil((high - low) / side - 1e-9)).astype(int)
    corners = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1).reshape(-1, 2) * side + low
    points, triangles, count = [], [], 0
    for level in range(_LEVELS + 1):
        steps = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5]]) * side
        places = (corners[:, None] + steps).reshape(-1, 2)
        values = np.asarray(function(places), float)
        if values.shape != (len(places),):
            raise ValueError(f"sizes: the function gave an array of the shape {values.shape} for {len(places)} points; give ({len(places)},)")
        values = values.reshape(-1, 5)
        with np.errstate(invalid="ignore"):
            is_size = np.isfinite(values) & (values > 0)
            least = np.where(is_size, values, np.inf).min(axis=1)
            bends = np.abs(values[:, :4].mean(axis=1) - values[:, 4]) > _TOLERANCE * values[:, 4]
        divides = (bends | ~is_size.all(axis=1)) & is_size.any(axis=1) & (side > least)
        if level == _LEVELS or count + len(corners) + 3 * divides.sum() > _MOST_CELLS:
            divides[:] = False
        kept = ~divides & is_size.any(axis=1)
        # Four triangles around the middle of each cell, of those whose values are sizes.
        first = 5 * (count + np.arange(kept.sum()))[:, None, None]
        fans = first + np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
        points.append(np.column_stack([places.reshape(-1, 5, 2)[kept].reshape(-1, 2), values[kept].reshape(-1)]))
        triangles.append(fans.reshape(-1, 3))
        count += int(kept.sum())
        quarters = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * side / 2
        corners = (corners[divides][:, None] + quarters).reshape(-1, 2)
        side /= 2
        if len(corners) == 0:
            break
    points, triangles = np.concatenate(points), np.concatenate(triangles)
    is_size = np.isfinite(points[:, 2]) & (points[:, 2] > 0)
    if not is_size.any():
        raise ValueError("sizes: the function gave no size; sizes are finite numbers above 0")
    index = np.cumsum(is_size) - 1
    triangles = index[triangles[is_size[triangles].all(axis=1)]]
    return {"points": points[is_size], "triangles": triangles}
