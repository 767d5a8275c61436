"""mindeg beside Triangle, Gmsh and MMG2D: the table of docs/interior.md.

Every program gets the boundary's points as they are and may add none on it. Settings are those that
gave each its best meshes in trials: see the table's notes.
"""

import statistics
import sys
import time
from importlib.metadata import version
from pathlib import Path

import gmsh
import mmg2d
import numpy as np
import triangle

from meshes import Mesh, cases, folder, improve, measure, mindeg, timed, write_section

MMG = Path(mmg2d.__file__).with_name("mmg2d_O3")


def own(case, work):
    mesh, _, seconds = mindeg(case.domain, work)
    return mesh, seconds


def ring_edges(count):
    return np.stack([np.arange(count), (np.arange(count) + 1) % count], axis=1)


def shewchuk(options):
    def mesh(case, work):
        given = {"vertices": case.ring, "segments": ring_edges(len(case.ring))}
        start = time.process_time()
        found = triangle.triangulate(given, options)
        seconds = time.process_time() - start
        return Mesh(found["vertices"], found["triangles"]), seconds

    return mesh


def frontal(algorithm):
    def mesh(case, work):
        gmsh.initialize(interruptible=False)
        try:
            gmsh.option.setNumber("General.Verbosity", 0)
            gmsh.option.setNumber("Mesh.Algorithm", algorithm)
            gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 1)
            count = len(case.ring)
            length = np.linalg.norm(np.roll(case.ring, -1, axis=0) - case.ring, axis=1)
            size = (length + np.roll(length, 1)) / 2
            points = [
                gmsh.model.geo.addPoint(x, y, 0, size[i], i + 1)
                for i, (x, y) in enumerate(case.ring.tolist())
            ]
            lines = [
                gmsh.model.geo.addLine(points[i], points[(i + 1) % count]) for i in range(count)
            ]
            gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
            gmsh.model.geo.synchronize()
            for line in lines:
                gmsh.model.mesh.setTransfiniteCurve(line, 2)
            start = time.process_time()
            gmsh.model.mesh.generate(2)
            seconds = time.process_time() - start
            tags, coordinates, _ = gmsh.model.mesh.getNodes()
            points = coordinates.reshape(-1, 3)[:, :2]
            _, _, nodes = gmsh.model.mesh.getElements(2)
            index = np.zeros(int(tags.max()) + 1, dtype=int)
            index[tags.astype(int)] = np.arange(len(tags))
            triangles = index[nodes[0].astype(int)].reshape(-1, 3)
        finally:
            gmsh.finalize()
        return with_ring_first(case, points, counter_clockwise(points, triangles)), seconds

    return mesh


def mmg(case, work):
    # It starts from a triangulation of the boundary, whose edges are required, with the mean of the two
    # intervals as the size at a vertex. Without sizes, or from Triangle's meshes, it did worse.
    given = {"vertices": case.ring, "segments": ring_edges(len(case.ring))}
    start = triangle.triangulate(given, "p")
    before, after, sizes = work / "before.mesh", work / "after.mesh", work / "before.sol"
    write_medit(before, start["vertices"], start["triangles"], len(case.ring))
    length = np.linalg.norm(np.roll(case.ring, -1, axis=0) - case.ring, axis=1)
    size = (length + np.roll(length, 1)) / 2
    lines = ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(size)), "1 1"]
    sizes.write_text("\n".join(lines + [repr(h) for h in size.tolist()]) + "\nEnd\n")
    command = [MMG, "-v", "0", "-nosurf", "-hgrad", "1.3", "-sol", sizes, before, after]
    _, seconds = timed(command)
    points, triangles = read_medit(after)
    return with_ring_first(case, points, counter_clockwise(points, triangles)), seconds


def write_medit(path, points, triangles, ring):
    lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(points))]
    lines += [f"{x!r} {y!r} 0" for x, y in points.tolist()]
    lines += ["Triangles", str(len(triangles))]
    lines += ["{} {} {} 0".format(*(t + 1)) for t in triangles]
    lines += ["Edges", str(ring)]
    lines += [f"{a + 1} {b + 1} 1" for a, b in ring_edges(ring)]
    lines += ["RequiredEdges", str(ring)] + [str(i + 1) for i in range(ring)]
    lines += ["RequiredVertices", str(ring)] + [str(i + 1) for i in range(ring)]
    path.write_text("\n".join(lines) + "\nEnd\n")


def read_medit(path):
    words = iter(path.read_text().split())
    points = triangles = None
    for word in words:
        if word == "Vertices":
            count = int(next(words))
            values = [float(next(words)) for _ in range(3 * count)]
            points = np.array(values).reshape(-1, 3)[:, :2]
        elif word == "Triangles":
            count = int(next(words))
            values = [int(next(words)) for _ in range(4 * count)]
            triangles = np.array(values).reshape(-1, 4)[:, :3] - 1
    return points, triangles


def counter_clockwise(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    turned = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] < 0
    triangles = triangles.copy()
    triangles[turned] = triangles[turned][:, ::-1]
    return triangles


def with_ring_first(case, points, triangles):
    """The same mesh with the boundary's points first, exactly as they were given."""
    from scipy.spatial import cKDTree

    distance, index = cKDTree(points).query(case.ring)
    extent = np.ptp(case.ring, axis=0).max()
    if distance.max() > 1e-9 * extent or len(set(index.tolist())) < len(index):
        raise ValueError("the boundary's points were changed")
    is_rest = np.ones(len(points), dtype=bool)
    is_rest[index] = False
    name = np.empty(len(points), dtype=int)
    name[index] = np.arange(len(index))
    name[is_rest] = len(index) + np.arange(is_rest.sum())
    return Mesh(np.concatenate([case.ring, points[is_rest]]), name[triangles])


def improved(program):
    def mesh(case, work):
        before, _ = program(case, work)
        return improve(before, work)

    return mesh


PROGRAMS = {
    "Triangle `pqY`": shewchuk("pqY"),
    "Triangle `pq30Y`": shewchuk("pq30Y"),
    "Gmsh Delaunay (5)": frontal(5),
    "Gmsh Frontal-Delaunay (6)": frontal(6),
    "Gmsh Packing of Parallelograms (9)": frontal(9),
    "MMG2D": mmg,
    "**mindeg --interior**": own,
    "mindeg improve on Triangle `pq30Y`": improved(shewchuk("pq30Y")),
    "mindeg improve on Gmsh (6)": improved(frontal(6)),
}


def row(name, found, failed):
    of = lambda key: [getattr(figures, key) for figures, _ in found]
    angle, share = of("min_angle"), of("share")
    cells = [
        name,
        f"{sum(of('triangles')):,}",
        f"{min(angle):.1f}° / {statistics.median(angle):.1f}°",
        f"{statistics.mean(share):.2f} / {min(share):.2f}",
        f"{statistics.mean(of('mean_min_angle')):.1f}°",
        f"{max(of('interior'))} / {max(of('boundary'))}",
        str(sum(of("violations"))),
        str(sum(count == 0 for count in of("violations"))),
        f"{statistics.mean(of('grading')):.2f}",
        f"{sum(seconds for _, seconds in found):.2f}",
    ]
    if failed:
        cells[0] += f" ({len(found)} domains; no valid mesh: {', '.join(failed)})"
    return "| " + " | ".join(cells) + " |"


def main():
    work = folder()
    all_cases = cases(work)
    rows, sums = [], {}
    for name, program in PROGRAMS.items():
        found, failed = [], []
        for case in all_cases:
            try:
                mesh, seconds = program(case, work)
                found.append((measure(mesh, case), seconds))
            except (ValueError, RuntimeError) as error:
                failed.append(case.name)
                print(f"{name}, {case.name}: {error}", file=sys.stderr)
        print(f"{name}: {len(found)} meshes", file=sys.stderr)
        rows.append(row(name, found, failed))
        sums[name] = {c.name: f.triangles for c, (f, _) in zip(all_cases, found)} if not failed else {}
    ratio = sum(sums["**mindeg --interior**"].values()) / sum(
        sums["Gmsh Frontal-Delaunay (6)"].values()
    )
    packages = ", ".join(f"{name} {version(name)}" for name in ["triangle", "gmsh", "pymmg"])
    text = f"""\
| program | triangles | minimum angle, worst / median | share of the limit, mean / worst | mean of minimum angles | greatest degree inside / boundary | violations | domains without | grading | CPU s |
|---|---|---|---|---|---|---|---|---|---|
{chr(10).join(rows)}

{len(all_cases)} boundaries ({len(all_cases) - 12} of `assets/domains`, 12 random); packages {packages}. mindeg has
{ratio:.2f} of the triangles of Gmsh's Frontal-Delaunay.
"""
    print(text)
    write_section("peers", text)


if __name__ == "__main__":
    main()
