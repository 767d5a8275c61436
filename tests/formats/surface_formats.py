"""What real programs see in PLY, STL, OFF, Triangle's files, fort.14, 2DM and NPZ, and what mindeg
sees in theirs.

    surface_formats.py MINDEG_BINARY FOLDER [DOMAIN.json ...]

Without domains: every assets/domains/*.json.
"""

import json
import subprocess
import sys
from pathlib import Path

import numpy

from solver_formats import meshes
from tally import Tally

DOMAINS = Path(__file__).resolve().parents[2] / "assets" / "domains"
EXTENSIONS = ("ply", "stl", "off", "node", "14", "2dm", "npz")
# What ADCIRC calls islands among the types of land boundaries.
ISLANDS = (1, 11, 21)


class Expected:
    """A mesh as the files should have it: read from the OBJ by nobody's reader but this one."""

    def __init__(self, path):
        words = [line.split() for line in Path(path).read_text().splitlines()]
        self.points = numpy.array([row[1:4] for row in words if row[:1] == ["v"]], float)
        faces = [row[1:4] for row in words if row[:1] == ["f"]]
        corners = [[int(corner.split("/")[0]) - 1 for corner in face] for face in faces]
        self.triangles = numpy.array(corners)
        # The surface comes first, then each side.
        self.sides = sum(row[:1] == ["o"] for row in words) - 1
        edges = numpy.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, counts = numpy.unique(edges, axis=0, return_counts=True)
        self.boundary = set(map(tuple, edges[counts == 1].tolist()))
        self.area = area(self.points, self.triangles)


def area(points, triangles):
    a, b, c = (numpy.asarray(points, float)[triangles[:, i]] for i in range(3))
    return float(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)


def same(points, triangles, expected, single=True):
    """Fails unless points and triangles are the expected ones, in the same order."""
    wanted = expected.points.astype(numpy.float32) if single else expected.points
    assert numpy.array_equal(numpy.asarray(points, wanted.dtype), wanted), "points differ"
    assert numpy.array_equal(triangles, expected.triangles), "triangles differ"


def same_shape(points, triangles, expected):
    """Fails unless counts and area are as expected, in whatever order."""
    counts = len(points), len(triangles)
    wanted = len(expected.points), len(expected.triangles)
    assert counts == wanted, f"{counts} vertices and triangles, expected {wanted}"
    seen = area(points, numpy.asarray(triangles))
    # Single precision, for coordinates that may be far from the origin.
    far = numpy.abs(expected.points).max()
    tolerance = 1e-5 * expected.area + 1e-6 * far * numpy.ptp(expected.points, axis=0).sum()
    assert abs(seen - expected.area) <= tolerance, f"area {seen}, expected {expected.area}"


def trimesh_reads(stem, expected):
    import trimesh

    for extension in ("ply", "off"):
        mesh = trimesh.load(f"{stem}.{extension}", process=False)
        same(mesh.vertices, mesh.faces, expected, single=extension == "ply")
    # Triangles that share no vertex until they are welded.
    mesh = trimesh.load(f"{stem}.stl", process=False)
    assert len(mesh.vertices) == 3 * len(expected.triangles), "an STL has no shared vertices"
    mesh.merge_vertices(merge_norm=True, digits_vertex=12)
    same_shape(mesh.vertices, mesh.faces, expected)


def meshio_reads(stem, expected, package="meshio"):
    meshio = __import__(package)
    mesh = meshio.read(f"{stem}.ply")
    same(mesh.points, mesh.cells_dict["triangle"], expected)
    mesh = meshio.read(f"{stem}.stl")
    same_shape(mesh.points, mesh.cells_dict["triangle"], expected)
    mesh = meshio.read(f"{stem}.off")
    same(mesh.points, mesh.cells_dict["triangle"], expected, single=False)


def meshlane_reads(stem, expected):
    meshio_reads(stem, expected, package="meshlane")


def meshlab_reads(stem, expected):
    import pymeshlab

    for extension in ("ply", "off", "stl"):
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(f"{stem}.{extension}")
        mesh = meshes.current_mesh()
        same_shape(mesh.vertex_matrix(), mesh.face_matrix(), expected)
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(f"{stem}-colors.ply")
    colors = meshes.current_mesh().vertex_color_matrix()
    assert len(numpy.unique(colors, axis=0)) > 1, "degrees have colors"
    same(meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix(), expected,
         single=False)


def triangle_reads(stem, expected):
    import triangle

    stem = Path(stem)
    data = triangle.load(str(stem.parent), stem.name)
    assert numpy.array_equal(data["vertices"], expected.points[:, :2]), "vertices differ"
    assert numpy.array_equal(data["triangles"], expected.triangles), "triangles differ"
    boundary = {
        "vertices": data["vertices"],
        "segments": data["segments"],
        "segment_markers": data["segment_markers"],
    }
    # A point in each hole.
    boundary |= {key: data[key] for key in ("holes",) if key in data}
    # All points are on the boundary: any triangulation has as many triangles, but
    # where points on slanted sides are rounded to the inside, slivers beyond them.
    made = triangle.triangulate(boundary, "pQ")
    assert len(made["vertices"]) == len(expected.points), "Triangle adds no vertex"
    assert len(made["triangles"]) == len(expected.triangles), "Triangle makes as many triangles"
    markers = numpy.unique(data["segment_markers"]).tolist()
    assert markers == list(range(1, expected.sides + 1)), "every side has its marker"


def numpy_reads(stem, expected):
    with numpy.load(f"{stem}.npz", allow_pickle=False) as arrays:
        same(arrays["points"], arrays["triangles"], expected, single=False)
        kinds = [arrays[name].dtype.str for name in ("points", "triangles", "degrees")]
        assert kinds == ["<f8", "<u4", "<u4"], kinds
        edges = expected.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        edges = numpy.unique(numpy.sort(edges, axis=1), axis=0)
        assert numpy.array_equal(arrays["degrees"], numpy.bincount(edges.ravel())), "degrees"
        angles = arrays["min_angles"]
        assert angles.shape == (len(expected.triangles),) and angles.min() > 0, "minimum angles"


def py2dm_reads(stem, expected):
    import py2dm

    with py2dm.Reader(f"{stem}.2dm") as mesh:
        points = numpy.array([node.pos for node in mesh.iter_nodes()])
        triangles = numpy.array([element.nodes for element in mesh.iter_elements()]) - 1
        strings = list(mesh.iter_node_strings())
    same(points, triangles, expected, single=False)
    segments = sum(len(string.nodes) - 1 for string in strings)
    assert segments == len(expected.boundary), "node strings go once round"


def swan_reads(stem, expected):
    """Reads a fort.14 as SWAN does: numbers in a fixed order, the rest of a line passed over, and
    vertices and elements numbered without gaps."""
    lines = iter(Path(f"{stem}.14").read_text().splitlines())
    next(lines)
    integers = lambda count: [int(word) for word in next(lines).split()[:count]]
    elements, vertices = integers(2)
    points, triangles = [], []
    for number in range(1, vertices + 1):
        words = next(lines).split()
        assert int(words[0]) == number, "numbering of vertices is not sequential"
        points.append([float(word) for word in words[1:3]] + [0])
    for number in range(1, elements + 1):
        words = integers(5)
        assert words[:2] == [number, 3], "numbering of elements is not sequential"
        triangles.append(words[2:])
    same(points, numpy.array(triangles) - 1, expected, single=False)
    edges = []
    for kind in ("open", "land"):
        (boundaries,), (nodes,) = integers(1), integers(1)
        counted = 0
        for _ in range(boundaries):
            count, of = integers(1) + [0] if kind == "open" else integers(2)
            members = [integers(1)[0] - 1 for _ in range(count)]
            # An island does not repeat its first node.
            edges += zip(members, members[1:] + (members[:1] if of in ISLANDS else []))
            counted += count
        assert counted == nodes, f"{counted} nodes of {kind} boundaries, {nodes} announced"
    assert next(lines, None) is None, "the file ends"
    found = {(min(edge), max(edge)) for edge in edges}
    assert found == expected.boundary and len(found) == len(edges), "all boundary edges, once"


READERS = [
    trimesh_reads,
    meshio_reads,
    meshlane_reads,
    meshlab_reads,
    triangle_reads,
    numpy_reads,
    py2dm_reads,
    swan_reads,
]


def foreign_files(folder, expected):
    """The mesh as other programs write it."""
    import meshio
    import pymeshlab
    import trimesh

    points, triangles = expected.points, expected.triangles
    mesh = trimesh.Trimesh(points, triangles, process=False)
    for name, options in [("a.ply", {"encoding": "ascii"}), ("b.ply", {}), ("a.stl", {}),
                          ("b.stl", {"file_type": "stl_ascii"}), ("a.off", {})]:
        mesh.export(folder / f"trimesh-{name}", **options)
    mesh = meshio.Mesh(points, [("triangle", triangles)])
    for name, options in [("a.ply", {"binary": False}), ("b.ply", {}), ("a.stl", {"binary": False}),
                          ("b.stl", {"binary": True}), ("a.off", {})]:
        mesh.write(folder / f"meshio-{name}", **options)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(points, triangles))
    for name in ("a.ply", "a.stl", "a.off"):
        meshes.save_current_mesh(str(folder / f"meshlab-{name}"))
    numpy.savez(folder / "numpy-a.npz", points=points, triangles=triangles)
    numpy.savez_compressed(folder / "numpy-c.npz", points=points, triangles=triangles)
    numpy.savez(
        folder / "numpy-b.npz",
        points=numpy.asfortranarray(points[:, :2].astype(">f8")),
        triangles=triangles.astype(numpy.int16 if len(points) < 1 << 15 else numpy.uint64),
    )


def mindeg_reads(mindeg, file, expected):
    finished = subprocess.run([mindeg, "inspect", file, "--json"], capture_output=True, text=True)
    assert finished.stdout, finished.stderr
    report = json.loads(finished.stdout)
    seen = report["vertices"], report["faces"]
    wanted = len(expected.points), len(expected.triangles)
    assert seen == wanted, f"{seen} vertices and faces, expected {wanted}"


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    mindeg, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    domains = [Path(name) for name in sys.argv[3:]] or sorted(DOMAINS.glob("*.json"))
    folder.mkdir(parents=True, exist_ok=True)
    tally = Tally()

    for name, command, _ in meshes(mindeg, domains):
        stem = folder / name
        outputs = [f"{stem}.{extension}" for extension in ("obj", *EXTENSIONS)]
        command = [*command, "--quiet", "--boundary-lines"]
        # What 32 bits cannot hold goes without PLY and STL.
        finished = subprocess.run(
            [*command, *(word for output in outputs for word in ("-o", output))],
            capture_output=True, text=True,
        )
        if finished.returncode:
            tally.record(f"{name} in mindeg", False, finished.stderr.strip())
            continue
        colors = [*command, "-o", f"{stem}-colors.ply", "--degree-colors", "--double"]
        subprocess.run(colors, check=True)
        expected = Expected(f"{stem}.obj")
        for reader in READERS:
            tally.attempt(f"{name} in {reader.__name__[:-6]}", reader, stem, expected)
        others = folder / f"{name}-others"
        others.mkdir(exist_ok=True)
        foreign_files(others, expected)
        for file in sorted(others.iterdir()):
            tally.attempt(f"{name}: {file.name} in mindeg", mindeg_reads, mindeg, file, expected)
    tally.finish()


if __name__ == "__main__":
    main()
