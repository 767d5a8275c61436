"""mindeg beside Triangle, Gmsh and OCSMesh on one coast: the tables of benches/results/coast.md and docs/coast.md.

Every program gets the same points of the boundary, and the lengths of mindeg's edges as sizes, where it takes any: times a factor, by
up to four trials, until it has the triangles that mindeg has, within 2 %. Seconds are processor time: of the whole process for mindeg,
of the calls alone for the others.
"""

import json
import multiprocessing
import os
import resource
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import gmsh
import numpy as np
import triangle
from scipy.interpolate import LinearNDInterpolator, NearestNDInterpolator

from figures import figures

ROOT = Path(__file__).resolve().parents[3]
MINDEG = os.environ["MINDEG"]
CONDITION = ["condition", "sea.geojson", "--project", "auto", "--limit", "25", "--size", "4km", "-o", "conditioned.json"]
# An angle that every coast has: rings that touch are parted, which the others cannot mesh, and nothing else changes.
RAW = ["condition", "sea.geojson", "--project", "auto", "--limit", "0.01", "--growth", "0", "-o", "raw.json"]


class Coast:
    """A boundary, and the lengths of the edges of mindeg's mesh of it."""

    def __init__(self, path):
        domain = json.loads(path.read_text())

        def ring(corners, sides):
            for corner, side in zip(corners, sides):
                yield corner
                yield from side.get("points", [])

        outer = {"corners": domain["polygon"]["corners"], "sides": domain["sides"]}
        # An islet that touches another ring is a closed line round a hole.
        rings = [outer, *domain.get("holes", []), *domain.get("lines", [])]
        self.rings = [np.array(list(ring(each["corners"], each["sides"]))) for each in rings]
        index = {}
        # The indices of the points of each ring.
        self.loops = [np.array([index.setdefault(tuple(point), len(index)) for point in ring]) for ring in self.rings]
        self.points = np.array(list(index))

    def segments(self):
        return np.concatenate([np.stack([loop, np.roll(loop, -1)], axis=1) for loop in self.loops])

    def take_sizes(self, points, triangles):
        """The mean length of the edges at each vertex of a mesh, between them linear."""
        edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        lengths = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
        total, count = np.zeros(len(points)), np.zeros(len(points))
        for end in range(2):
            np.add.at(total, edges[:, end], lengths)
            np.add.at(count, edges[:, end], 1)
        self.mesh = points, triangles
        self.sizes = total / count
        self.factor = 1.0
        self.linear = LinearNDInterpolator(points, self.sizes)
        self.nearest = NearestNDInterpolator(points, self.sizes)

    def size_at(self, places):
        found = self.linear(places)
        return self.factor * np.where(np.isnan(found), self.nearest(places), found)

    def lengths(self):
        """The mean length of the two edges at each point of the boundary."""
        found = np.zeros(len(self.points))
        for loop, ring in zip(self.loops, self.rings):
            after = np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1)
            found[loop] = (after + np.roll(after, 1)) / 2
        return found

    def polygon(self):
        from shapely.geometry import Polygon

        return Polygon(self.rings[0], self.rings[1:])


def run(arguments, work):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([MINDEG, *map(str, arguments)], cwd=work, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        raise RuntimeError(done.stderr.strip()[-300:])
    return done.stdout and json.loads(done.stdout), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def own(name, work):
    answer, seconds = run(["mesh", f"{name}.json", "--interior", "-o", f"{name}.obj", "--json", "-q"], work)
    points, triangles = [], []
    for line in (work / f"{name}.obj").read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(x) for x in words[1:3]])
        elif words[:1] == ["f"]:
            triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return np.array(points), np.array(triangles), seconds, answer


def shewchuk(options):
    """Triangle with an angle, then refined three times to the areas that the sizes want."""

    def mesh(coast):
        from shapely.geometry import Polygon

        holes = [Polygon(ring).representative_point().coords[0] for ring in coast.rings[1:]]
        given = {"vertices": coast.points, "segments": coast.segments()} | ({"holes": np.array(holes)} if holes else {})
        start = time.process_time()
        found = triangle.triangulate(given, "p" + options)
        for _ in range(3):
            middles = found["vertices"][found["triangles"]].mean(axis=1)
            found["triangle_max_area"] = np.sqrt(3) / 4 * coast.size_at(middles)[:, None] ** 2
            found = triangle.triangulate(found, "pra" + options)
        return found["vertices"], found["triangles"], time.process_time() - start

    return mesh


def frontal(smoothings, optimisations=(), has_field=True):
    """Gmsh's Frontal-Delaunay: the boundary's edges undivided, sizes a field, or those of the boundary."""

    def mesh(coast):
        gmsh.initialize(interruptible=False)
        try:
            for option, value in [("General.Verbosity", 0), ("Mesh.Algorithm", 6), ("Mesh.Smoothing", smoothings)] + [
                ("Mesh.MeshSizeExtendFromBoundary", not has_field), ("Mesh.MeshSizeFromPoints", not has_field)
            ]:
                gmsh.option.setNumber(option, value)
            geo = gmsh.model.geo
            lengths = coast.lengths()
            for index, (x, y) in enumerate(coast.points.tolist()):
                geo.addPoint(x, y, 0, lengths[index], index + 1)
            loops = [[geo.addLine(a + 1, b + 1) for a, b in zip(loop, np.roll(loop, -1))] for loop in coast.loops]
            geo.addPlaneSurface([geo.addCurveLoop(loop) for loop in loops])
            geo.synchronize()
            for line in sum(loops, []):
                gmsh.model.mesh.setTransfiniteCurve(line, 2)
            if has_field:
                size_field(coast)
            start = time.process_time()
            gmsh.model.mesh.generate(2)
            for name in optimisations:
                gmsh.model.mesh.optimize(name)
            seconds = time.process_time() - start
            tags, coordinates, _ = gmsh.model.mesh.getNodes()
            index = np.zeros(int(tags.max()) + 1, dtype=int)
            index[tags.astype(int)] = np.arange(len(tags))
            _, nodes = gmsh.model.mesh.getElementsByType(2)
            return coordinates.reshape(-1, 3)[:, :2], index[nodes.astype(int)].reshape(-1, 3), seconds
        finally:
            gmsh.finalize()

    return mesh


def size_field(coast):
    points, triangles = coast.mesh
    corners = points[triangles]
    flat = [corners[:, :, 0], corners[:, :, 1], np.zeros((len(corners), 3)), coast.factor * coast.sizes[triangles]]
    view = gmsh.view.add("sizes")
    gmsh.view.addListData(view, "ST", len(corners), np.concatenate(flat, axis=1).ravel())
    field = gmsh.model.mesh.field.add("PostView")
    gmsh.model.mesh.field.setNumber(field, "ViewTag", view)
    gmsh.model.mesh.field.setAsBackgroundMesh(field)


def ocsmesh(engine, **options):
    """OCSMesh's driver; sizes are those of mindeg's mesh, where the engine takes any."""

    def mesh(coast):
        import geopandas
        import ocsmesh
        from ocsmesh.driver import MeshDriver
        from ocsmesh.internal import MeshData

        crs = "EPSG:32635"
        shape = ocsmesh.Geom(coast.polygon(), crs=crs)
        size = None
        if engine == "gmsh":
            points, triangles = coast.mesh
            size = ocsmesh.Hfun(ocsmesh.Mesh(MeshData(coords=points, tria=triangles, values=coast.factor * coast.sizes[:, None], crs=crs)))
        start = time.process_time()
        found = MeshDriver(shape, size, crs=crs, engine_name=engine, **options).run().meshdata
        return found.coords, found.tria, time.process_time() - start

    return mesh


# Whether its sizes can be scaled.
PEERS = {
    "Triangle `pq30Y`": (shewchuk("q30Y"), True),
    "Triangle `pq33Y`": (shewchuk("q33Y"), True),
    "Triangle `pq30`": (shewchuk("q30"), True),
    "Gmsh": (frontal(1), True),
    "Gmsh, 10 smoothings": (frontal(10), True),
    "Gmsh, 10 smoothings, Laplace2D, Relocate2D": (frontal(10, ["Laplace2D", "Relocate2D"]), True),
    "Gmsh, 10 smoothings, sizes of the boundary": (frontal(10, has_field=False), False),
    "OCSMesh, Gmsh `exact`": (ocsmesh("gmsh", bnd_representation="exact"), True),
    "OCSMesh, Gmsh `adapt`": (ocsmesh("gmsh", bnd_representation="adapt"), True),
    "OCSMesh, Triangle `pq30Y`": (ocsmesh("triangle", opts="q30Y"), False),
}
# The most that all trials of a program may take.
MOST_SECONDS = 120
# The rows of docs/coast.md.
SHORT = ["mindeg", "Triangle `pq30Y`", "Triangle `pq30`", "Gmsh", "Gmsh, 10 smoothings", "OCSMesh, Gmsh `exact`", "OCSMesh, Gmsh `adapt`"]
HEAD = [
    "| program | triangles | inside without 5 to 7 edges | greatest degree | minimum angle | first percentile | mean eta "
    "| boundary points new / gone | CPU s |",
    "|---|--:|--:|--:|--:|--:|--:|--:|--:|",
]


def at_count(call, coast, wanted):
    """The mesh of a peer with nearly so many triangles."""
    best = None
    for _ in range(4):
        points, triangles, seconds = call(coast)
        ratio = len(triangles) / wanted
        if best is None or abs(ratio - 1) < best[0]:
            best = abs(ratio - 1), points, triangles, seconds
        if best[0] < 0.02:
            break
        coast.factor *= ratio**0.5
    return best[1:]


def in_time(call):
    """What a call gives, in a process of its own: some meshes never end."""
    receiver, sender = multiprocessing.Pipe(duplex=False)

    def work():
        try:
            sender.send((call(), None))
        except Exception as error:
            sender.send((None, error))

    process = multiprocessing.get_context("fork").Process(target=work)
    process.start()
    try:
        if not receiver.poll(MOST_SECONDS):
            raise TimeoutError(f"no mesh in {MOST_SECONDS} s")
        found, error = receiver.recv()
    finally:
        process.kill()
        process.join()
    if error:
        raise error
    return found


def row(program, found, seconds):
    return (
        f"| {program} | {found.triangles:,} | {found.outside:,} | {found.greatest} | {found.least_angle:.2f}° "
        f"| {found.first_percent:.1f}° | {found.eta:.3f} | {found.added:,} / {found.gone:,} | {seconds:.2f} |"
    )


def rows_of(name, work):
    """The rows of all programs on a coast."""
    coast = Coast(work / f"{name}.json")
    points, triangles, seconds, answer = own(name, work)
    coast.take_sizes(points, triangles)
    area = coast.polygon().area
    rows = {"mindeg": row("**mindeg**", figures(points, triangles, coast.points, area), seconds)}
    for program, (call, is_scaled) in PEERS.items():
        coast.factor = 1.0
        try:
            found = in_time(lambda: at_count(call, coast, len(triangles)) if is_scaled else call(coast))
            rows[program] = row(program, figures(*found[:2], coast.points, area), found[2])
        except Exception as error:
            print(f"{name}, {program}: {error}", file=sys.stderr)
            what = f"none in {MOST_SECONDS} s" if isinstance(error, TimeoutError) else type(error).__name__
            rows[program] = f"| {program} | {what} |  |  |  |  |  |  |  |"
        print(rows[program], flush=True)
    return rows, answer["limit"]["angle_limit"], len(coast.points)


def main():
    work = Path(tempfile.mkdtemp(prefix="mindeg-coast-"))
    sys.path.insert(0, str(ROOT / "tests" / "outlines"))
    import coasts

    (work / "sea.geojson").write_text(json.dumps(coasts.sea(Path(os.environ["WORLD_ATLAS"]), "aegean")))
    answer, seconds = run([*CONDITION, "--json", "-q"], work)
    run([*RAW, "--json", "-q"], work)
    told = {
        "conditioned": f"conditioned in {seconds:.2f} s, moved by {answer['moved']:.0f} m at most",
        "raw": "projected only",
    }
    full, short = [], [HEAD[0], HEAD[1]]
    for name, what in told.items():
        rows, limit, count = rows_of(name, work)
        full += [f"### The coast {what}: {count:,} points, which allow {limit:.2f}°", "", *HEAD, *rows.values(), ""]
        short += [rows[program].replace("| ", f"| {name}: ", 1) for program in SHORT]
    packages = ", ".join(f"{name} {version(name)}" for name in ["triangle", "gmsh", "ocsmesh"])
    text = "\n".join([*full, f"Packages: {packages}.", ""])
    print(text)
    write_section("coast", text)
    write_table(short)


def write_section(name, text, page="benches/results/coast.md"):
    """Replaces the text between two marks of a page."""
    page = ROOT / page
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    content = page.read_text()
    head, rest = content.split(begin)
    page.write_text(head + begin + text + end + rest.split(end)[1])


def write_table(rows, page="docs/coast.md"):
    """Replaces the table of a page that has the same columns."""
    page = ROOT / page
    head, rest = page.read_text().split(HEAD[0])
    after = rest[rest.index("\n\n") :] if "\n\n" in rest else "\n"
    page.write_text(head + "\n".join(rows) + after)


if __name__ == "__main__":
    main()
