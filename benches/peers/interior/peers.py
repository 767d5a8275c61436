"""mindeg beside Triangle, Gmsh and MMG2D: the table of benches/results/interior.md.

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

from meshes import Mesh, cases, folder, improve, measure, mindeg, outlines, timed, write_section

MMG = Path(mmg2d.__file__).with_name("mmg2d_O3")


def own(case, work):
    mesh, _, seconds = mindeg(case.domain, work)
    return mesh, seconds


def holes(case):
    """A point in each hole, from the middle of one of its edges."""
    found = []
    for ring in case.rings[1:]:
        turned = np.array([ring[0][1] - ring[1][1], ring[1][0] - ring[0][0]])
        found.append((ring[0] + ring[1]) / 2 - 1e-6 * turned)
    return {"holes": np.array(found)} if found else {}


def shewchuk(options):
    return lambda case, work: in_triangle({"vertices": case.points, "segments": case.edges} | holes(case), options)


def in_triangle(given, options):
    start = time.process_time()
    found = triangle.triangulate(given, options)
    seconds = time.process_time() - start
    return Mesh(found["vertices"], found["triangles"]), seconds


def frontal(algorithm, smoothings=1):
    def mesh(case, work):
        ends = np.cumsum([len(ring) for ring in case.rings])
        polygon = [ring.tolist() for ring in np.split(np.arange(ends[-1]), ends[:-1])]
        found, seconds = in_gmsh(algorithm, smoothings, case.points, case.edges, [polygon])
        return with_ring_first(case, found.points, found.triangles), seconds

    return mesh


def in_gmsh(algorithm, smoothings, points, edges, polygons):
    """Gmsh's mesh of polygons, each a list of rings of points, whose edges stay undivided."""
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Verbosity", 0)
        gmsh.option.setNumber("Mesh.Algorithm", algorithm)
        gmsh.option.setNumber("Mesh.Smoothing", smoothings)
        gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 1)
        geo = gmsh.model.geo
        size = sizes(points, edges)
        for index, (x, y) in enumerate(points.tolist()):
            geo.addPoint(x, y, 0, size[index], index + 1)
        lines = {}
        for a, b in edges.tolist():
            lines[a, b] = geo.addLine(a + 1, b + 1)
            lines[b, a] = -lines[a, b]
        for rings in polygons:
            loops = [[lines[way] for way in zip(ring, ring[1:] + ring[:1])] for ring in rings]
            geo.addPlaneSurface([geo.addCurveLoop(loop) for loop in loops])
        geo.synchronize()
        for line in (line for line in lines.values() if line > 0):
            gmsh.model.mesh.setTransfiniteCurve(line, 2)
        start = time.process_time()
        gmsh.model.mesh.generate(2)
        seconds = time.process_time() - start
        tags, coordinates, _ = gmsh.model.mesh.getNodes()
        found = coordinates.reshape(-1, 3)[:, :2]
        _, _, nodes = gmsh.model.mesh.getElements(2)
        index = np.zeros(int(tags.max()) + 1, dtype=int)
        index[tags.astype(int)] = np.arange(len(tags))
        triangles = index[nodes[0].astype(int)].reshape(-1, 3)
    finally:
        gmsh.finalize()
    return Mesh(found, counter_clockwise(found, triangles)), seconds


def sizes(points, edges):
    """The mean of the intervals at each vertex of the boundary."""
    lengths = np.linalg.norm(np.diff(points[edges], axis=1)[:, 0], axis=1)
    size, count = np.zeros(len(points)), np.zeros(len(points))
    for end in range(2):
        np.add.at(size, edges[:, end], lengths)
        np.add.at(count, edges[:, end], 1)
    return size / count


def mmg(case, work):
    # It starts from a triangulation of the boundary, whose edges are required, with the mean of the two
    # intervals as the size at a vertex. Without sizes, or from Triangle's meshes, it did worse.
    given = {"vertices": case.points, "segments": case.edges}
    start = triangle.triangulate(given, "p")
    before, after, file = work / "before.mesh", work / "after.mesh", work / "before.sol"
    write_medit(before, start["vertices"], start["triangles"], case.edges)
    size = sizes(case.points, case.edges)
    lines = ["MeshVersionFormatted 2", "Dimension 2", "SolAtVertices", str(len(size)), "1 1"]
    file.write_text("\n".join(lines + [repr(h) for h in size.tolist()]) + "\nEnd\n")
    command = [MMG, "-v", "0", "-nosurf", "-hgrad", "1.3", "-sol", file, before, after]
    _, seconds = timed(command)
    points, triangles = read_medit(after)
    return with_ring_first(case, points, counter_clockwise(points, triangles)), seconds


def write_medit(path, points, triangles, edges):
    lines = ["MeshVersionFormatted 2", "Dimension 2", "Vertices", str(len(points))]
    lines += [f"{x!r} {y!r} 0" for x, y in points.tolist()]
    lines += ["Triangles", str(len(triangles))]
    lines += ["{} {} {} 0".format(*(t + 1)) for t in triangles]
    ring = len(edges)
    lines += ["Edges", str(ring)]
    lines += [f"{a + 1} {b + 1} 1" for a, b in edges]
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

    distance, index = cKDTree(points).query(case.points)
    extent = np.ptp(case.points, axis=0).max()
    if distance.max() > 1e-9 * extent or len(set(index.tolist())) < len(index):
        raise ValueError("the boundary's points were changed")
    is_rest = np.ones(len(points), dtype=bool)
    is_rest[index] = False
    name = np.empty(len(points), dtype=int)
    name[index] = np.arange(len(index))
    name[is_rest] = len(index) + np.arange(is_rest.sum())
    return Mesh(np.concatenate([case.points, points[is_rest]]), name[triangles])


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


# Beside outlines that nothing was tuned to: the best settings of each.
OTHERS = {
    "Triangle `pq30Y`": shewchuk("pq30Y"),
    "Gmsh Frontal-Delaunay (6), 10 smoothings": frontal(6, 10),
    "**mindeg --interior**": own,
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


def meshes(programs, all_cases, work):
    """The figures and seconds of each program by the name of the case, and the names of failures."""
    found = {}
    for name, program in programs.items():
        found[name], failed = {}, []
        for case in all_cases:
            try:
                mesh, seconds = program(case, work)
                found[name][case.name] = measure(mesh, case), seconds
            except (ValueError, RuntimeError) as error:
                failed.append(case.name)
                print(f"{name}, {case.name}: {error}", file=sys.stderr)
        print(f"{name}: {len(found[name])} meshes", file=sys.stderr)
        yield name, found[name], failed


def short_row(name, found, best):
    figures = [figures for figures, _ in found.values()]
    of = lambda key: [getattr(each, key) for each in figures]
    cells = [
        name,
        str(len(found)),
        f"{sum(of('triangles')):,}",
        f"{statistics.mean(of('eta')):.3f}",
        f"{statistics.mean(min(share, 1) for share in of('share')):.3f}",
        str(sum(of("violations"))),
        str(sum(count == 0 for count in of("violations"))),
        str(best),
        f"{sum(seconds for _, seconds in found.values()):.2f}",
    ]
    return "| " + " | ".join(cells) + " |"


def others(work):
    """The second table."""
    found = {name: each for name, each, _ in meshes(OTHERS, outlines(work), work)}
    angle = lambda name, case: found[name][case][0].min_angle if case in found[name] else 0.0
    every = sorted({case for each in found.values() for case in each})
    largest = {case: max(angle(name, case) for name in found) for case in every}
    rows = [
        short_row(name, each, sum(angle(name, case) >= largest[case] - 0.3 for case in every))
        for name, each in found.items()
    ]
    own, gmsh = (found[name] for name in ["**mindeg --interior**", list(OTHERS)[1]])
    ratio = lambda case: own[case][0].triangles / gmsh[case][0].triangles
    alike = [case for case in every if case in own and case in gmsh and 0.85 <= ratio(case) <= 1.15]
    mean = lambda each: statistics.mean(each[case][0].eta for case in alike)
    return f"""\
| program | meshes | triangles | mean quality (eta) | share of the limit | violations | outlines without | largest minimum angle (0.3° apart) | CPU s |
|---|---|---|---|---|---|---|---|---|
{chr(10).join(rows)}

{len(every)} outlines: 40 L, T, U, wedge, star and hole shapes made by chance, 50 states, counties, countries and icons. On the
{len(alike)} where mindeg and Gmsh have as many triangles (±15%), eta is {mean(own):.3f} and {mean(gmsh):.3f}.
"""


def main():
    work = folder()
    all_cases = cases(work)
    rows, sums = [], {}
    for name, found, failed in meshes(PROGRAMS, all_cases, work):
        rows.append(row(name, list(found.values()), failed))
        sums[name] = sum(figures.triangles for figures, _ in found.values())
    ratio = sums["**mindeg --interior**"] / sums["Gmsh Frontal-Delaunay (6)"]
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
    text = others(work)
    print(text)
    write_section("outlines", text)


if __name__ == "__main__":
    main()
