# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops of edges, and meshes for them. Nothing here knows Blender: it works on lists and arrays."""

import mindeg
import numpy as np

# A loop is planar if no point is farther than this from its plane, as a share of the loop's size.
PLANAR = 1e-5


def loops_of(edges):
    """The closed loops that edges form, each a list of vertices; a ValueError names what is none."""
    beside = {}
    for a, b in edges:
        beside.setdefault(a, []).append(b)
        beside.setdefault(b, []).append(a)
    wrong = next((vertex for vertex, others in beside.items() if len(others) != 2), None)
    if wrong is not None:
        raise ValueError(
            f"vertex {wrong} has {len(beside[wrong])} selected edges; select closed loops, with 2 at each vertex"
        )
    loops, seen = [], set()
    for start in beside:
        if start in seen:
            continue
        loop, previous, vertex = [], None, start
        while vertex not in seen:
            seen.add(vertex)
            loop.append(vertex)
            a, b = beside[vertex]
            previous, vertex = vertex, (b if a == previous else a)
        loops.append(loop)
    return loops


def plane_of(points):
    """The center, two axes and the largest distance of a loop from its plane, by Newell's normal."""
    points = np.asarray(points, dtype=float)
    center = points.mean(axis=0)
    around = points - center
    normal = np.cross(around, np.roll(around, -1, axis=0)).sum(axis=0)
    length = np.linalg.norm(normal)
    if length == 0:
        raise ValueError("the loop has no area; move its vertices apart")
    normal /= length
    least = np.eye(3)[np.argmin(np.abs(normal))]
    first = np.cross(normal, least)
    first /= np.linalg.norm(first)
    axes = np.array([first, np.cross(normal, first)])
    return center, axes, np.abs(around @ normal).max()


def nested(rings):
    """The rings in groups, by their numbers: an outer one, then those in its plane and inside it, which are its holes."""
    rings = [np.asarray(ring, dtype=float) for ring in rings]
    planes = [plane_of(ring) for ring in rings]
    inside = [
        {outer for outer in range(len(rings)) if outer != ring and _holds(rings[outer], planes[outer], rings[ring])}
        for ring in range(len(rings))
    ]
    groups = {ring: [ring] for ring in range(len(rings)) if len(inside[ring]) % 2 == 0}
    for ring, outers in enumerate(inside):
        if ring not in groups:
            # The ring around it that most others are around.
            groups[max(outers & groups.keys(), key=lambda outer: len(inside[outer]))].append(ring)
    return list(groups.values())


def _holds(outer, plane, ring):
    """Whether a ring lies in the plane of another and its first point inside."""
    center, axes, off = plane
    size = np.ptp(outer, axis=0).max()
    if max(off, np.abs((ring - center) @ np.cross(*axes)).max()) > PLANAR * size:
        return False
    x, y = (ring[0] - center) @ axes.T
    ax, ay = ((outer - center) @ axes.T).T
    bx, by = np.roll(ax, -1), np.roll(ay, -1)
    crosses = (ay > y) != (by > y)
    right = ax[crosses] + (y - ay[crosses]) / (by - ay)[crosses] * (bx - ax)[crosses] > x
    return bool(right.sum() % 2)


def fill(rings, *, external=None, excluded=(), interior=False, **goal):
    """Triangles for a ring of points in space and its holes: new points, triangles, and a line that says what was reached.

    A planar ring is meshed as a polygon, any other as a loop in space. ``goal`` is for ``Domain.mesh``. ``external`` are the edges at each vertex without those
    of the filling; limits count them.
    """
    rings = [np.asarray(ring, dtype=float) for ring in rings]
    points = np.concatenate(rings)
    center, axes, off = plane_of(rings[0])
    size = np.ptp(points, axis=0).max()
    if off > PLANAR * size:
        max_degree = goal.pop("max_degree", None)
        if interior or goal:
            wanted = "interior points need" if interior else f"{next(iter(goal))} needs"
            raise ValueError(f"the loop is {off:.3g} off its plane; {wanted} a planar loop")
        triangles, facts = mindeg.fill_loop(
            points, external=external, excluded=list(excluded), max_degree=max_degree
        )
        return [], triangles.tolist(), f"degree {facts['max_degree']} (limit {facts['limit']})"
    outside = np.zeros(len(points), dtype=int) if external is None else np.maximum(np.asarray(external) - 2, 0)
    outer, *holes = [((ring - center) @ axes.T).tolist() for ring in rings]
    source = {"ring": outer, "holes": [{"ring": hole} for hole in holes]}
    source["vertices"] = [
        {"vertex": int(vertex), "outside_degree": int(outside[vertex])} for vertex in np.flatnonzero(outside)
    ]
    domain = mindeg.Domain({key: value for key, value in source.items() if value})
    # A ring that runs the other way round is turned: what its vertices are called here.
    names = _names(domain.points, np.concatenate([outer, *holes]))
    if interior:
        mesh = domain.interior()
        new = center + mesh.points[len(points) :] @ axes
        names = [*names, *range(len(points), len(mesh.points))]
        reached = mesh.report
        words = (
            f"minimum angle {reached['min_angle']:.1f}°, at most {reached['angle_limit']:.1f}° possible; "
            f"{len(reached['violations'])} vertices outside 5 to 7 edges"
        )
        return new.tolist(), np.array(names)[mesh.triangles].tolist(), words
    mesh = domain.mesh(**goal)
    least = mesh.least_max_degree
    bound = f"least possible {least}" if least is not None else "least possible unknown"
    degree = (mesh.degrees + outside[names]).max()
    return [], np.array(names)[mesh.triangles].tolist(), (
        f"degree {degree} ({bound}), minimum angle {mesh.min_angle:.1f}°"
    )


def _names(points, given):
    """The number that each point was given with; they come back bit for bit."""
    number = {tuple(point): place for place, point in enumerate(given.tolist())}
    return [number[tuple(point)] for point in points.tolist()]


def bridge(first, second, *, external=None, max_degree=None):
    """Triangles between two loops of points, the second turned to run as the first does."""
    first, second = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
    normals = [np.cross(loop - loop.mean(axis=0), np.roll(loop - loop.mean(axis=0), -1, axis=0)).sum(axis=0)
               for loop in (first, second)]
    order = np.arange(len(second))
    if normals[0] @ normals[1] < 0:
        order = order[::-1]
    if external is not None:
        external = [*external[: len(first)], *(external[len(first) + i] for i in order)]
    triangles, facts = mindeg.bridge_loops(
        first, np.ascontiguousarray(second[order]), external=external, max_degree=max_degree
    )
    names = np.concatenate([np.arange(len(first)), len(first) + order])
    words = (
        f"degree {facts['max_degree']} (least possible {facts['least_max_degree']}), "
        f"minimum angle {facts['min_angle']:.1f}°"
    )
    return names[triangles].tolist(), words
