# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops of edges, and meshes for them. Nothing here knows Blender: it works on lists and arrays."""

import mindeg
import numpy as np
from mindeg._mindeg import _points_between as between

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
        count = len(beside[wrong])
        raise ValueError(
            f"vertex {wrong} has {count} selected edge{'' if count == 1 else 's'}; select closed loops, with 2 at each vertex"
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


def directed_loops(edges):
    """The closed loops of edges (from, to), taken apart where they touch; edges that form none are left out."""
    after = {}
    for a, b in edges:
        after.setdefault(a, []).append(b)
    loops = []
    for start in list(after):
        while after[start]:
            path, place = [start], {start: 0}
            while after.get(path[-1]):
                vertex = after[path[-1]].pop()
                if vertex in place:
                    loops.append(path[place[vertex] :])
                    for gone in path[place[vertex] + 1 :]:
                        del place[gone]
                    del path[place[vertex] + 1 :]
                else:
                    place[vertex] = len(path)
                    path.append(vertex)
    return loops


def is_rim(points, normals):
    """Whether a loop, in the direction of the faces along it, bounds a flat sheet all round: to fill it would lay triangles
    on these faces. ``normals`` are theirs.
    """
    points, normals = np.asarray(points, dtype=float), np.asarray(normals, dtype=float)
    _, axes, off = plane_of(points)
    return bool(off <= PLANAR * np.ptp(points, axis=0).max() and (normals @ np.cross(*axes)).min() > 1 - PLANAR)


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
    """The rings in groups, by their indices: an outer one, then those in its plane and inside it, which are its holes."""
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


class Patch:
    """The triangles of one polygon or loop."""

    def __init__(self, names, rings):
        #: The vertices of the rings by the names that the caller knows, one ring after the other.
        self.names = names
        self.rings = rings
        #: The corners of the triangles beside the rings, three each; only points inside ask for them.
        self.around = []
        #: Points inside, and triangles of the indices of ``names``, then of these points.
        self.new, self.triangles = [], []
        self.degree, self.min_angle = 0, 180.0
        #: What else there is to say: a bound, or why the patch has no triangles.
        self.words, self.fault = "", None


def fill_all(patches, edges, **wanted):
    """Fills patches one after the other; the edges and triangles that one adds count for those after it. ``edges`` are pairs of names."""
    made = []
    beside = {}
    for a, b in edges:
        beside.setdefault(a, set()).add(b)
        beside.setdefault(b, set()).add(a)
    for patch in patches:
        names = patch.names
        index = {name: place for place, name in enumerate(names)}
        external = [len(beside.get(name, ())) for name in names]
        excluded = [[place, index[other]] for name, place in index.items() for other in beside.get(name, ()) if index.get(other, -1) > place]
        patch.around += [corner for of, corners in made if not index.keys().isdisjoint(of) for corner in corners]
        try:
            fill(patch, external, excluded, **wanted)
        except ValueError as error:
            patch.fault = str(error)
            continue
        points = [*(tuple(point) for ring in patch.rings for point in ring), *map(tuple, patch.new)]
        for corners in patch.triangles:
            if wanted.get("interior"):
                of = [names[corner] for corner in corners if corner < len(names)]
                made.append((of, [points[corner] for corner in corners]))
            for a, b in zip(corners, [*corners[1:], corners[0]]):
                if max(a, b) < len(names):
                    beside.setdefault(names[a], set()).add(names[b])
                    beside.setdefault(names[b], set()).add(names[a])


def fill(patch, external, excluded, *, interior=False, keep_angle=None, max_degree=None, **goal):
    """Triangles for a ring of points in space and its holes.

    A planar ring is meshed as a polygon, any other as a loop in space, for which there is no Delaunay triangulation whose angle could be
    kept. ``external`` are the edges at each vertex without those of the filling; limits count them.
    """
    rings = [np.asarray(ring, dtype=float) for ring in patch.rings]
    points = np.concatenate(rings)
    center, axes, off = plane_of(rings[0])
    size = np.ptp(points, axis=0).max()
    if off > PLANAR * size:
        triangles, facts = mindeg.fill_loop(points, external=external, excluded=excluded, max_degree=max_degree)
        patch.triangles, patch.degree = triangles.tolist(), facts["max_degree"]
        patch.min_angle = mindeg.Mesh(points, triangles).min_angle
        patch.words = f"limit {facts['limit']}"
        if interior:
            _put_points(patch, rings, triangles, external)
        return
    outside = np.maximum(np.asarray(external) - 2, 0)
    outer, *holes = [((ring - center) @ axes.T).tolist() for ring in rings]
    source = {"ring": outer, "holes": [{"ring": hole} for hole in holes]}
    source["vertices"] = [
        {"vertex": int(vertex), "outside_degree": int(outside[vertex])} for vertex in np.flatnonzero(outside)
    ]
    domain = mindeg.Domain({key: value for key, value in source.items() if value})
    # A ring that runs the other way round is turned: what its vertices are called here.
    names = _names(domain.points, np.concatenate([outer, *holes]))
    if interior:
        mesh = domain.mesh(interior=True)
        names = [*names, *range(len(points), len(mesh.points))]
        patch.new = (center + mesh.points[len(points) :] @ axes).tolist()
        patch.degree = mesh.max_degree
        reached = mesh.report
        violations = len(reached["violations"])
        patch.words = f"at most {angle(reached['angle_limit'])} possible"
        if violations:
            patch.words += f", {violations} {'vertex' if violations == 1 else 'vertices'} outside 5 to 7 edges"
    else:
        # The highest degree demanded, else the share of the angle.
        if max_degree is not None:
            goal["max_degree"] = max_degree
        elif keep_angle is not None and not goal:
            goal["keep_angle"] = keep_angle
        mesh = domain.mesh(**goal)
        patch.degree = int((mesh.degrees + outside[names]).max())
        least = mesh.least_max_degree
        patch.words = f"least possible {least}" if least is not None else ""
    patch.triangles, patch.min_angle = np.array(names)[mesh.triangles].tolist(), mesh.min_angle


def _put_points(patch, rims, triangles, external):
    """Gives a patch in space points inside; where there are none, its triangles stay, and its words say why."""
    try:
        new, triangles = between(rims, triangles, np.reshape(patch.around, (-1, 3)))
    except ValueError as fault:
        patch.words += f"; no points inside: {fault}"
        return
    patch.new, patch.triangles = new.tolist(), triangles.tolist()
    points = np.concatenate([*rims, new])
    edges = {(int(min(a, b)), int(max(a, b))) for corners in triangles for a, b in zip(corners, np.roll(corners, -1))}
    degrees = np.bincount(np.array(sorted(edges)).ravel(), minlength=len(points))
    degrees[: len(external)] += np.asarray(external) - 2
    patch.degree, patch.min_angle = int(degrees.max()), mindeg.Mesh(points, triangles).min_angle
    inside = degrees[len(external) :]
    violations = int(((inside < 5) | (inside > 7)).sum())
    patch.words = f"{_counted(inside, 'point')} inside"
    if violations:
        patch.words += f", {violations} of them outside 5 to 7 edges"


def angle(degrees):
    """An angle as all of mindeg writes it: to three decimals, and one too small for them to four digits."""
    if degrees >= 0.1:
        return f"{degrees:.3f}°"
    return f"{np.format_float_positional(degrees, precision=4, unique=False, fractional=False, trim='-')}°"


def said(patches, what):
    """What was done, in one sentence; ``what`` is "hole" or "face"."""
    done = [patch for patch in patches if patch.fault is None]
    left = [patch for patch in patches if patch.fault is not None]
    if not done:
        raise ValueError(left[0].fault if left else "there is nothing to fill")
    triangles = sum(len(patch.triangles) for patch in done)
    words = f"Filled {_counted(done, what)} with {_counted(range(triangles), 'triangle')}: " if what == "hole" else (
        f"Made {_counted(range(triangles), 'triangle')} of {_counted(done, what)}: "
    )
    words += f"degree {'' if len(done) == 1 else 'at most '}{max(patch.degree for patch in done)}"
    if len(done) == 1 and done[0].words:
        words += f" ({done[0].words})"
    words += f", minimum angle {angle(min(patch.min_angle for patch in done))}"
    if left:
        words += f"; {_counted(left, what)} {'stays' if len(left) == 1 else 'stay'} as {'it is' if len(left) == 1 else 'they are'}: {left[0].fault}"
    return words


def _counted(things, what):
    return f"{len(things)} {what}{'' if len(things) == 1 else 's'}"


def _names(points, given):
    """The index that each point was given with; they come back bit for bit."""
    index = {tuple(point): place for place, point in enumerate(given.tolist())}
    return [index[tuple(point)] for point in points.tolist()]


def bridge(patch, external, *, interior=False, max_degree=None):
    """Triangles between the two loops of a patch, the second turned to run as the first does, and points between them if wanted."""
    first, second = (np.asarray(ring, dtype=float) for ring in patch.rings)
    normals = [np.cross(loop - loop.mean(axis=0), np.roll(loop - loop.mean(axis=0), -1, axis=0)).sum(axis=0)
               for loop in (first, second)]
    order = np.arange(len(second))
    if normals[0] @ normals[1] < 0:
        order = order[::-1]
    turned = [*external[: len(first)], *(external[len(first) + i] for i in order)]
    triangles, facts = mindeg.bridge_loops(
        first, np.ascontiguousarray(second[order]), external=turned, max_degree=max_degree
    )
    names = np.concatenate([np.arange(len(first)), len(first) + order])
    patch.triangles = names[triangles].tolist()
    patch.degree, patch.min_angle = facts["max_degree"], facts["min_angle"]
    patch.words = f"least possible {facts['least_max_degree']}"
    if interior:
        _put_points(patch, [first, second], names[triangles], external)
