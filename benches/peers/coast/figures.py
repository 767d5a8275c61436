"""What a mesh of a coast is like, by code that shares nothing with mindeg's."""

import math
from dataclasses import dataclass

import numpy as np


@dataclass
class Figures:
    triangles: int
    outside: int
    greatest: int
    least_angle: float
    first_percent: float
    eta: float
    added: int
    gone: int


def figures(points, triangles, given, area):
    """The figures of a mesh; `given` are the points of the boundary as they were. Fails on a mesh that does not cover the area once."""
    points, triangles = np.asarray(points, dtype=float), np.asarray(triangles)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    sides = np.stack([((q - p) ** 2).sum(axis=1) for p, q in ((b, c), (c, a), (a, b))], axis=1)
    doubled = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    # Opposite the shortest side: its cosine from the law of cosines, its sine from the area.
    sides.sort(axis=1)
    least = np.degrees(np.arctan2(2 * doubled, sides[:, 1] + sides[:, 2] - sides[:, 0]))
    eta = 2 * math.sqrt(3) * doubled / sides.sum(axis=1)

    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, uses = np.unique(edges, axis=0, return_counts=True)
    if uses.max() > 2:
        raise ValueError("three triangles share an edge")
    degrees = np.bincount(edges.ravel(), minlength=len(points))
    is_rim = np.zeros(len(points), dtype=bool)
    is_rim[edges[uses == 1].ravel()] = True
    inside = degrees[(degrees > 0) & ~is_rim]

    added, gone = changed(points[is_rim], given)
    if gone == 0 and abs(doubled.sum() / 2 / area - 1) > 1e-9:
        raise ValueError("triangles overlap, or leave gaps")
    return Figures(
        triangles=len(triangles),
        outside=int(((inside < 5) | (inside > 7)).sum()),
        greatest=int(degrees.max()),
        least_angle=float(least.min()),
        first_percent=float(np.percentile(least, 1)),
        eta=float(eta.mean()),
        added=added,
        gone=gone,
    )


def changed(rim, given):
    """How many points of a mesh's rim no given point is at, and how many given points are not on the rim, within a centimetre."""
    from scipy.spatial import cKDTree

    near = 0.01
    added = cKDTree(given).query(rim)[0] > near
    gone = cKDTree(rim).query(given)[0] > near
    return int(added.sum()), int(gone.sum())
