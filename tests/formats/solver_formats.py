"""What real programs see in MSH, VTU, legacy VTK, SU2 and Abaqus input, and what mindeg sees in
their files.

    solver_formats.py MINDEG_BINARY FOLDER [DOMAIN.json ...]
"""

import json
import re
import subprocess
import sys
import warnings
from collections import Counter
from pathlib import Path

import numpy

from tally import Tally

DOMAINS = Path(__file__).resolve().parents[2] / "assets" / "domains"
# The files of a mesh: what each is called besides the domain, and how mindeg is told.
FILES = {
    "-4.msh": [],
    "-4a.msh": ["--ascii"],
    "-2.msh": ["--msh-version", "2.2"],
    "-2a.msh": ["--msh-version", "2.2", "--ascii"],
    ".vtu": [],
    "-a.vtu": ["--ascii"],
    ".vtk": [],
    "-a.vtk": ["--ascii"],
    ".su2": [],
    ".inp": [],
}
# Domains that are also meshed with interior points.
INTERIOR = ("plate-with-holes", "wing-panel")
# The most vertices of a domain that a Poisson problem is solved on.
MOST_SOLVED = 400


class Expected:
    """A mesh as the files should have it: read from an OBJ by nobody's reader but this one."""

    def __init__(self, obj, report, domain):
        rows = [line.split() for line in Path(obj).read_text().splitlines()]
        self.points = numpy.array([row[1:4] for row in rows if row[:1] == ["v"]], float)
        faces = [row[1:4] for row in rows if row[:1] == ["f"]]
        corners = [[int(corner.split("/")[0]) - 1 for corner in face] for face in faces]
        self.triangles = numpy.array(corners)
        names = [row[1] for row in rows if row[:1] == ["o"]][1:]
        # An OBJ has no blanks in names; sides without a name are "side 1" and so on.
        given = given_names(json.loads(Path(domain).read_text()), len(names))
        names = [name or seen.replace("_", " ") for name, seen in zip(given, names)]
        self.sides = dict(zip(names, report["intervals"]))
        # Each side's segments follow its name; a side that closes a ring has no vertex more.
        self.vertices, place = {}, 0
        segments = numpy.array([row[1:3] for row in rows if row[:1] == ["l"]], int) - 1
        for name, count in self.sides.items():
            self.vertices[name] = len(numpy.unique(segments[place : place + count]))
            place += count
        self.degrees = degrees(self.triangles)
        self.min_angles = min_angles(self.points, self.triangles)


def given_names(domain, count):
    """The name of each side in the file, or None; sides may be left out of it."""
    holes = domain.get("holes", [])
    named = lambda ring: [side.get("name") for side in ring.get("sides", [])]
    of_holes = []
    for hole in holes:
        sides = named(hole)
        of_holes += sides + [None] * (len(hole.get("corners", [0])) - len(sides))
    of_outline = named(domain)
    return of_outline + [None] * (count - len(of_outline) - len(of_holes)) + of_holes


def edges_of(triangles):
    return numpy.sort(numpy.asarray(triangles)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)


def degrees(triangles):
    return numpy.bincount(numpy.unique(edges_of(triangles), axis=0).ravel())


def min_angles(points, triangles):
    corners = points[triangles]
    ahead = numpy.roll(corners, -1, axis=1) - corners
    behind = numpy.roll(corners, 1, axis=1) - corners
    sines = numpy.linalg.norm(numpy.cross(ahead, behind), axis=2)
    return numpy.degrees(numpy.arctan2(sines, (ahead * behind).sum(axis=2))).min(axis=1)


def area(points, triangles):
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return numpy.cross(b - a, c - a)[:, 2].sum() / 2


class Seen:
    """A mesh as a program has it."""

    def __init__(self, points, triangles, segments, sides=None, degrees=None, min_angles=None):
        self.points, self.triangles, self.segments = map(numpy.asarray, (points, triangles, segments))
        # Names of sides, each with its number of segments; of vertices where they are node sets.
        self.sides, self.degrees, self.min_angles = sides, degrees, min_angles
        self.are_node_sets = self.have_labels = False

    def checks(self, expected):
        """A name and whether it is as expected, one at a time."""
        yield "vertices", self.points.shape[0] == len(expected.points)
        yield "triangles", numpy.array_equal(self.triangles, expected.triangles)
        axes = self.points.shape[1]
        yield "points", numpy.array_equal(self.points, expected.points[:, :axes])
        points = numpy.pad(self.points, ((0, 0), (0, 3 - axes)))
        whole = area(expected.points, expected.triangles)
        yield "area", abs(area(points, self.triangles) - whole) <= 1e-12 * abs(whole)
        if len(self.segments):
            ends = Counter(self.segments.ravel().tolist())
            yield "boundary closed", set(ends.values()) == {2}
            edges = Counter(map(tuple, edges_of(self.triangles).tolist()))
            outer = {edge for edge, count in edges.items() if count == 1}
            found = set(map(tuple, numpy.sort(self.segments, axis=1).tolist()))
            yield "boundary", found == outer and len(self.segments) == len(outer)
        if self.sides is not None:
            # Labels of Abaqus and markers of SU2 have no blanks.
            label = lambda name: re.sub(r"[^A-Za-z0-9_-]", "_", name)
            wanted = expected.vertices if self.are_node_sets else expected.sides
            if self.have_labels:
                wanted = {label(name): count for name, count in wanted.items()}
            yield "sides", self.sides == wanted
        if self.degrees is not None:
            yield "degrees", numpy.array_equal(self.degrees, expected.degrees)
        if self.min_angles is not None:
            close = numpy.allclose(self.min_angles, expected.min_angles, rtol=1e-6, atol=1e-9)
            yield "minimum angles", close


def gmsh_sees(path):
    import gmsh

    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        tags, points, _ = gmsh.model.mesh.getNodes()
        order = numpy.argsort(tags)
        points = points.reshape(-1, 3)[order]
        elements = dict(zip(*gmsh.model.mesh.getElements()[::2]))
        corners = lambda kind, count: elements[kind].astype(int).reshape(-1, count) - 1
        sides = None
        if path.suffix == ".msh":
            sides = {}
            for dimension, tag in gmsh.model.getPhysicalGroups(1):
                curves = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
                counts = [len(gmsh.model.mesh.getElements(1, curve)[1][0]) for curve in curves]
                sides[gmsh.model.getPhysicalName(dimension, tag)] = sum(counts)
        data = {}
        for view in gmsh.view.getTags():
            kind, of, values, _, _ = gmsh.view.getModelData(view, 0)
            data[kind] = numpy.array(values)[:, 0][numpy.argsort(of)]
        segments = corners(1, 2)
        angles = data.get("ElementData")
        angles = None if angles is None else angles[len(segments):]
        return Seen(points, corners(2, 3), segments, sides, data.get("NodeData"), angles)
    finally:
        gmsh.finalize()


def meshio_sees(path, package="meshio"):
    meshio = __import__(package)
    mesh = meshio.read(path)
    kinds = [block.type for block in mesh.cells]
    of_kind = lambda kind: [i for i, name in enumerate(kinds) if name == kind]
    triangles = numpy.concatenate([mesh.cells[i].data for i in of_kind("triangle")])
    segments = [mesh.cells[i].data for i in of_kind("line")]
    segments = numpy.concatenate(segments) if segments else numpy.empty((0, 2), int)
    sides = None
    if path.suffix == ".msh":
        tags = numpy.concatenate([mesh.cell_data["gmsh:physical"][i] for i in of_kind("line")])
        names = {tag: name for name, (tag, dimension) in mesh.field_data.items() if dimension == 1}
        sides = dict(Counter(names[tag] for tag in tags))
    elif path.suffix == ".vtu":
        names = bytes(mesh.field_data["side_names"]).decode().split("\0")[:-1]
        (line,) = of_kind("line")
        sides = dict(Counter(names[side] for side in mesh.cell_data["side"][line]))
    elif path.suffix == ".su2":
        # The names have become numbers from 1, in the order of the file.
        names = re.findall(r"^MARKER_TAG= *(.+)$", path.read_text(), re.MULTILINE)
        tags = numpy.concatenate([mesh.cell_data["su2:tag"][i] for i in of_kind("line")])
        sides = dict(Counter(names[tag - 1] for tag in tags))
    elif path.suffix == ".inp":
        sides = {name: len(set(nodes)) for name, nodes in mesh.point_sets.items()}
    angles = mesh.cell_data.get("min_angle")
    angles = angles and numpy.concatenate([angles[i] for i in of_kind("triangle")]).ravel()
    degrees = mesh.point_data.get("degree")
    degrees = None if degrees is None else degrees.ravel()
    seen = Seen(mesh.points, triangles, segments, sides, degrees, angles)
    seen.are_node_sets = path.suffix == ".inp"
    seen.have_labels = path.suffix in (".inp", ".su2")
    return seen


def meshlane_sees(path):
    return meshio_sees(path, package="meshlane")


def vtk_sees(path):
    """ParaView's own readers."""
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    if path.suffix == ".vtu":
        reader = vtk.vtkXMLUnstructuredGridReader()
    else:
        reader = vtk.vtkUnstructuredGridReader()
        reader.ReadAllScalarsOn()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    assert grid.GetNumberOfPoints(), "no points"
    types = vtk_to_numpy(grid.GetCellTypes())
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    triangles = corners[: 3 * (types == 5).sum()].reshape(-1, 3)
    segments = corners[triangles.size :].reshape(-1, 2)
    data = grid.GetCellData()
    sides = None
    if path.suffix == ".vtu":
        names = vtk_to_numpy(grid.GetFieldData().GetArray("side_names")).tobytes()
        names = names.decode().split("\0")
        side = vtk_to_numpy(data.GetArray("side"))
        assert (side[types == 5] == -1).all(), "a triangle has a side"
        sides = dict(Counter(names[index] for index in side[types == 3]))
    angles = vtk_to_numpy(data.GetArray("min_angle"))[types == 5]
    degrees = vtk_to_numpy(grid.GetPointData().GetArray("degree"))
    return Seen(vtk_to_numpy(grid.GetPoints().GetData()), triangles, segments, sides, degrees, angles)


# Which files each program reads. Gmsh 4.15.2 reads no binary .vtk, also not its own.
PROGRAMS = {
    "Gmsh": (gmsh_sees, ("-4.msh", "-4a.msh", "-2.msh", "-2a.msh", "-a.vtk")),
    "meshio": (meshio_sees, tuple(FILES)),
    "meshlane": (meshlane_sees, tuple(FILES)),
    "VTK": (vtk_sees, (".vtu", "-a.vtu", ".vtk", "-a.vtk")),
}


def poisson(path, expected):
    """Solves for x + 2 y with scikit-fem: its value on one named side, its flux through the others.

    Linear elements have the solution exactly, so any side that is not where it should be shows.
    """
    import skfem
    from skfem.helpers import dot, grad

    mesh = skfem.MeshTri.load(path)
    missing = set(expected.sides) - set(mesh.boundaries)
    assert not missing, f"no boundaries {missing}"
    basis = skfem.Basis(mesh, skfem.ElementTriP1())
    exact = mesh.p[0] + 2 * mesh.p[1]
    stiffness = skfem.BilinearForm(lambda u, v, _: dot(grad(u), grad(v))).assemble(basis)
    fixed, *others = expected.sides
    load = numpy.zeros(basis.N)
    for side in others:
        facets = skfem.FacetBasis(mesh, skfem.ElementTriP1(), facets=mesh.boundaries[side])
        flux = skfem.LinearForm(lambda v, w: (w.n[0] + 2 * w.n[1]) * v)
        load += flux.assemble(facets)
    known = basis.get_dofs(fixed).all()
    assert len(known) == expected.vertices[fixed], "vertices of the first side"
    solution = skfem.solve(*skfem.condense(stiffness, load, x=exact, D=known))
    error = numpy.abs(solution - exact).max() / numpy.ptp(exact)
    assert error < 1e-7, f"off by {error:.3g}"


def foreign_files(stem, folder):
    """The mesh as other programs write it."""
    import gmsh
    import meshio
    import meshlane
    import vtk

    gmsh.initialize(interruptible=False)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(f"{stem}-4.msh")
    for version in (4.1, 2.2):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(str(folder / f"gmsh-{version}-{binary}.msh"))
    gmsh.option.setNumber("Mesh.Binary", 0)
    gmsh.write(str(folder / "gmsh.vtk"))
    gmsh.finalize()
    for package in (meshio, meshlane):
        name = package.__name__
        mesh = package.read(f"{stem}.vtu")
        package.write(folder / f"{name}-zlib.vtu", mesh)
        package.write(folder / f"{name}-base64.vtu", mesh, compression=None)
        package.write(folder / f"{name}-ascii.vtu", mesh, binary=False)
        package.write(folder / f"{name}-51.vtk", mesh)
        package.write(folder / f"{name}-42.vtk", mesh, file_format="vtk42")
        # In MSH 4.1 they write several types of cells only with the entities of their points.
        plain = package.Mesh(mesh.points, [(c.type, c.data) for c in mesh.cells])
        package.write(folder / f"{name}-22.msh", plain, file_format="gmsh22")
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(f"{stem}.vtu")
    reader.Update()
    for mode, kind in enumerate(("ascii", "base64", "appended")):
        for compressor in ("None", "ZLib"):
            for header in (32, 64):
                for encode in (0, 1) if kind == "appended" else (0,):
                    writer = vtk.vtkXMLUnstructuredGridWriter()
                    writer.SetInputData(reader.GetOutput())
                    writer.SetDataMode(mode)
                    writer.SetHeaderType(header)
                    writer.SetEncodeAppendedData(encode)
                    getattr(writer, f"SetCompressorTypeTo{compressor}")()
                    writer.SetBlockSize(1024)
                    name = f"vtk-{kind}-{compressor}-{header}-{encode}.vtu"
                    writer.SetFileName(str(folder / name))
                    writer.Write()
    for version in (42, 51):
        for kind in (1, 2):
            writer = vtk.vtkUnstructuredGridWriter()
            writer.SetInputData(reader.GetOutput())
            writer.SetFileVersion(version)
            writer.SetFileType(kind)
            writer.SetFileName(str(folder / f"vtk-{version}-{kind}.vtk"))
            writer.Write()


def mindeg_sees(mindeg, file, expected):
    finished = subprocess.run([mindeg, "inspect", file, "--json"], capture_output=True, text=True)
    assert finished.stdout, finished.stderr
    report = json.loads(finished.stdout)
    seen = [report[key] for key in ("vertices", "faces", "line_segments", "boundary_edges")]
    around = sum(expected.sides.values())
    wanted = [len(expected.points), len(expected.triangles), around, around]
    assert seen == wanted, f"{seen}, expected {wanted}"
    # Text of other programs may be rounded.
    whole = area(expected.points, expected.triangles)
    assert abs(report["area"] - whole) <= 1e-4 * abs(whole), f"area {report['area']}"


def mindeg_keeps_names(mindeg, file, expected):
    """Whether names that mindeg reads from a file of another program reach Gmsh again."""
    again = file.with_name(f"again-{file.stem}.msh")
    subprocess.run([mindeg, "convert", file, "-o", again, "--quiet"], check=True)
    seen = gmsh_sees(again).sides
    assert seen == expected.sides, f"{seen}, expected {expected.sides}"


def markers_are_tags(mindeg, folder):
    """Whether Gmsh and meshio see the markers of Triangle's segments as physical tags."""
    import gmsh
    import meshio

    poly = folder / "markers.poly"
    poly.write_text("4 2 0 0\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n4 1\n1 1 2 20\n2 2 3 7\n3 3 4 20\n4 4 1 300\n0\n")
    for suffix in ("-4.msh", "-2.msh"):
        path = folder / f"markers{suffix}"
        subprocess.run([mindeg, "mesh", poly, "-o", path, "--quiet", *FILES[suffix]], check=True)
        mesh = meshio.read(path)
        blocks = zip(mesh.cells, mesh.cell_data["gmsh:physical"])
        tags = [int(tag) for block, tags in blocks if block.type == "line" for tag in tags]
        assert sorted(tags) == [7, 20, 20, 300], f"meshio, {path.name}: {tags}"
        gmsh.initialize(interruptible=False)
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            gmsh.open(str(path))
            tags = [tag for _, tag in gmsh.model.getPhysicalGroups(1)]
        finally:
            gmsh.finalize()
        assert tags == [7, 20, 300], f"Gmsh, {path.name}: {tags}"


def meshes(mindeg, domains):
    """For each mesh its name, the command that makes it, and its domain."""
    for domain in domains:
        command = [mindeg, "mesh", domain]
        yield domain.stem, command, domain
        if domain.stem in INTERIOR:
            yield f"{domain.stem}-interior", [*command, "--interior"], domain


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    warnings.simplefilter("ignore")
    mindeg, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    domains = [Path(name) for name in sys.argv[3:]] or sorted(DOMAINS.glob("*.json"))
    folder.mkdir(parents=True, exist_ok=True)
    tally = Tally()
    tally.attempt("markers of a .poly in Gmsh and meshio", markers_are_tags, mindeg, folder)

    for name, command, domain in meshes(mindeg, domains):
        stem = folder / name
        obj = f"{stem}.obj"
        finished = subprocess.run(
            [*command, "-o", obj, "--boundary-lines", "--json"], capture_output=True, text=True
        )
        if finished.returncode:
            tally.record(f"{name} in mindeg", False, finished.stderr.strip())
            continue
        expected = Expected(obj, json.loads(finished.stdout), domain)
        for suffix, options in FILES.items():
            subprocess.run([*command, "--quiet", "-o", f"{stem}{suffix}", *options], check=True)
        for program, (sees, suffixes) in PROGRAMS.items():
            for suffix in suffixes:
                path = Path(f"{stem}{suffix}")
                seen = tally.attempt(f"{path.name} in {program}: read", sees, path)
                for check, is_right in seen.checks(expected) if seen else ():
                    tally.record(f"{path.name} in {program}: {check}", is_right, "not as expected")
        if len(expected.points) <= MOST_SOLVED:
            for suffix in ("-4.msh", "-2.msh"):
                path = f"{stem}-angles{suffix}"
                goal = [] if "--interior" in command else ["--keep-angle", "100%"]
                options = [*goal, *FILES[suffix]]
                subprocess.run([*command, "--quiet", "-o", path, *options], check=True)
                tally.attempt(f"{Path(path).name} in scikit-fem: Poisson", poisson, path, expected)
        others = folder / f"{name}-others"
        others.mkdir(exist_ok=True)
        for stale in others.iterdir():
            stale.unlink()
        tally.attempt(f"{name}: files of other programs", foreign_files, stem, others)
        for file in sorted(others.iterdir()):
            tally.attempt(f"{name}: {file.name} in mindeg", mindeg_sees, mindeg, file, expected)
            if file.suffix == ".msh" and file.name.startswith("gmsh"):
                what = f"{name}: names of {file.name} in mindeg"
                tally.attempt(what, mindeg_keeps_names, mindeg, file, expected)
    tally.finish()


if __name__ == "__main__":
    main()
