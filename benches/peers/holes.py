"""Fills loops in space with mindeg, MeshLab and CGAL, and prints what each of them makes.

    holes.py MINDEG_BINARY

Every loop has a collar: a ring of triangles outside, so that there is a mesh to fill and degrees
that it has already. CGAL fills the loop alone, as its function takes no mesh; all are measured with
the collar. Degrees are total ones, collar included. Self-intersections are MeshLab's count of new
triangles that cross another one.
"""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
import pymeshlab
from CGAL import CGAL_Polygon_mesh_processing as cgal
from CGAL.CGAL_Kernel import Point_3

COUNTS = (24, 48, 60)
# None is the default: the least from 6 up that takes at most 5 % more area. 999 is no limit at all.
LIMITS = {"mindeg": None} | {f"mindeg --max-degree {limit}": limit for limit in (6, 7, 8, 999)}


def circle(n):
    for i in range(n):
        yield 2 * math.pi * i / n


def saddle(n):
    return [(math.cos(t), math.sin(t), 0.5 * math.cos(2 * t)) for t in circle(n)]


def wavy(n):
    return [(math.cos(t), math.sin(t), 0.4 * math.cos(6 * t)) for t in circle(n)]


def noisy(n):
    random = numpy.random.default_rng(1)
    shifts = random.uniform(-0.15, 0.15, (n, 3)).tolist()
    return [(math.cos(t) + x, math.sin(t) + y, z) for t, (x, y, z) in zip(circle(n), shifts)]


def tennis_ball(n):
    a, b = 0.75, 0.25
    c = 2 * math.sqrt(a * b)
    return [
        (a * math.cos(t) + b * math.cos(3 * t), a * math.sin(t) - b * math.sin(3 * t), c * math.sin(2 * t))
        for t in circle(n)
    ]


LOOPS = {"saddle": saddle, "wavy": wavy, "noisy": noisy, "tennis ball": tennis_ball}


def collar(loop):
    """The loop, a larger copy of it, and the triangles between them, which leave the loop open."""
    n = len(loop)
    points = [tuple(p) for p in loop] + [tuple(1.4 * x for x in p) for p in loop]
    triangles = []
    for i in range(n):
        j = (i + 1) % n
        triangles += [(j, i, n + i), (j, n + i, n + j)]
    return points, triangles


def write_obj(path, points, triangles):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in points]
    lines += ["f " + " ".join(str(v + 1) for v in triangle) for triangle in triangles]
    path.write_text("\n".join(lines) + "\n")


def by_mindeg(mindeg, limit, folder, loop):
    """The filling, or the reason why there is none."""
    points, triangles = collar(loop)
    write_obj(folder / "open.obj", points, triangles)
    command = [mindeg, "fill", folder / "open.obj", "-o", folder / "closed.obj", "--loop", "v0", "-q"]
    if limit:
        command += ["--max-degree", str(limit)]
    finished = subprocess.run([*command, "--json"], capture_output=True, text=True)
    if finished.returncode:
        return None
    first, last = json.loads(finished.stdout)["filled"][0]["triangles"]
    faces = [line.split()[1:] for line in (folder / "closed.obj").read_text().splitlines() if line.startswith("f ")]
    return [tuple(int(corner.split("/")[0]) - 1 for corner in face) for face in faces[first:last]]


def by_meshlab(loop):
    points, triangles = collar(loop)
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(numpy.array(points), numpy.array(triangles)))
    # The collar's outer boundary is a hole as well; both are filled, and one is kept.
    meshes.meshing_close_holes(maxholesize=100000, newfaceselected=False, selfintersection=True)
    new = meshes.current_mesh().face_matrix()[len(triangles):]
    n = len(loop)
    return [tuple(int(v) for v in t) for t in new if all(v < n for v in t)]


def by_cgal(loop):
    points = cgal.Point_3_Vector()
    for x, y, z in loop:
        points.append(Point_3(x, y, z))
    found = []
    cgal.triangulate_hole_polyline(points, found)
    return [(t.first, t.second, t.third) for t in found]


def measure(loop, filling):
    points, triangles = collar(loop)
    n = len(loop)
    edges = {frozenset(pair) for t in triangles + filling for pair in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0]))}
    degrees = [0] * len(points)
    for edge in edges:
        for vertex in edge:
            degrees[vertex] += 1
    at = numpy.array(points)
    area, angle = 0.0, 180.0
    for t in filling:
        a, b, c = (at[v] for v in t)
        area += numpy.linalg.norm(numpy.cross(b - a, c - a)) / 2
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
            u, v = q - p, r - p
            turn = math.degrees(math.atan2(numpy.linalg.norm(numpy.cross(u, v)), float(u @ v)))
            angle = min(angle, turn)
    meshes = pymeshlab.MeshSet(verbose=False)
    meshes.add_mesh(pymeshlab.Mesh(at, numpy.array(triangles + filling)))
    meshes.compute_selection_by_self_intersections_per_face()
    crossing = meshes.current_mesh().face_selection_array()[len(triangles):].sum()
    is_whole = len(filling) == n - 2
    return max(degrees[:n]), area, angle, int(crossing), is_whole


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    mindeg = Path(sys.argv[1]).resolve()
    print("| loop | n | program | maximum degree | area | minimum angle | crossing triangles |")
    print("|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, make in LOOPS.items():
            for n in COUNTS:
                loop = make(n)
                fillings = {"MeshLab": by_meshlab(loop), "CGAL": by_cgal(loop)}
                for title, limit in LIMITS.items():
                    fillings[title] = by_mindeg(mindeg, limit, Path(folder), loop)
                for program, filling in fillings.items():
                    if not filling:
                        print(f"| {name} | {n} | {program} | | | | none |")
                        continue
                    degree, area, angle, crossing, is_whole = measure(loop, filling)
                    note = "" if is_whole else f" ({len(filling)} triangles of {n - 2})"
                    print(f"| {name} | {n} | {program}{note} | {degree} | {area:.3f} | {angle:.2f}° | {crossing} |")


if __name__ == "__main__":
    main()
