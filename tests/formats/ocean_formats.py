"""What readers of ocean models see in fort.14, SELAFIN, UGRID NetCDF and GeoJSON.

    ocean_formats.py MINDEG_BINARY FOLDER [DOMAIN.json ...]
"""

import importlib.util
import json
import subprocess
import sys
import warnings
from pathlib import Path

import numpy
import xarray

from solver_formats import DOMAINS, Expected, meshes
from tally import Tally

# A bay of four triangles round a point, with an open side, in degrees, and its depths.
BAY = """bay
4 5
1 20.5 38.25 3.5
2 21.5 38.25 4
3 21.5 39.25 0
4 20.5 39.25 1.25
5 21 38.75 7
1 3 1 2 5
2 3 2 3 5
3 3 3 4 5
4 3 4 1 5
1
2
2 = nodes of open boundary 1 (sea)
1
2
1
4
4 0 = nodes of land boundary 1 (coast)
2
3
4
1
"""


def twice_area(points):
    x, y = points.T
    return (x * numpy.roll(y, -1) - numpy.roll(x, -1) * y).sum()


def boundary_edges(triangles):
    """The directed edges that only one triangle has."""
    edges = {tuple(edge) for edge in triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2).tolist()}
    return {(a, b) for a, b in edges if (b, a) not in edges}


def selafin(path, points, triangles):
    seen = xarray.open_dataset(path, engine="selafin")
    own = numpy.column_stack([seen.x.values, seen.y.values])
    yield "points, bit for bit", numpy.array_equal(own, points)
    yield "triangles", numpy.array_equal(numpy.asarray(seen.attrs["ikle2"]) - 1, triangles)
    edges = boundary_edges(triangles)
    after = dict(edges)
    numbers = numpy.asarray(seen.attrs["ipobo"])
    order = numpy.argsort(numbers)[(numbers == 0).sum() :]
    yield "boundary points have the numbers from 1", sorted(numbers[order]) == [*range(1, len(edges) + 1)]
    yield "and are those of the boundary", {*order.tolist()} == {*after}
    # Each ring is one run of numbers, with the mesh on its left.
    rings, start = [], 0
    for at, vertex in enumerate(order.tolist()):
        if after[vertex] == order[start]:
            rings.append(order[start : at + 1])
            start = at + 1
        elif at + 1 == len(order) or after[vertex] != order[at + 1]:
            break
    yield "rings are runs", start == len(order)
    areas = [twice_area(points[ring]) for ring in rings]
    yield "the outer ring comes first", bool(areas) and areas[0] > 0 and all(area < 0 for area in areas[1:])
    firsts = [points[ring].sum(axis=1).argmin() for ring in rings]
    yield "a ring begins in the south-west", not any(firsts)
    rows = [row.split() for row in path.with_suffix(".cli").read_text().splitlines()]
    yield "the .cli has them in order", [(int(row[11]) - 1, int(row[12])) for row in rows] == [
        (vertex, number) for number, vertex in enumerate(order.tolist(), 1)
    ]


def ugrid(path, points, triangles):
    seen = xarray.open_dataset(path, engine="scipy")
    topology = seen.mesh2d.attrs
    yield "the topology", (topology["cf_role"], topology["topology_dimension"]) == ("mesh_topology", 2)
    x, y = topology["node_coordinates"].split()
    own = numpy.column_stack([seen[x].values, seen[y].values])
    yield "points, bit for bit", numpy.array_equal(own, points)
    faces = seen[topology["face_node_connectivity"]]
    yield "triangles", faces.attrs["start_index"] == 0 and numpy.array_equal(faces.values, triangles)
    ends = {*map(tuple, seen[topology["boundary_node_connectivity"]].values.tolist())}
    yield "the boundary", ends >= boundary_edges(triangles)
    flags = seen.boundary_id.attrs
    names = flags["flag_meanings"].split()
    yield "names of lines", sorted(set(seen.boundary_id.values)) == [*range(1, len(names) + 1)]


def geojson(path, points, triangles):
    features = json.loads(path.read_text())["features"]
    kinds = [feature["geometry"]["type"] for feature in features]
    yield "one polygon for each triangle", kinds.count("Polygon") == len(triangles)
    own = numpy.array([feature["geometry"]["coordinates"][0] for feature in features[: len(triangles)]])
    yield "corners, bit for bit", numpy.array_equal(own, points[triangles[:, [0, 1, 2, 0]]])
    lines = sum(len(feature["geometry"]["coordinates"]) - 1 for feature in features if "line" in feature["properties"])
    yield "lines", lines >= len(boundary_edges(triangles))


READERS = {".slf": selafin, ".nc": ugrid, ".geojson": geojson}


def ocsmesh(folder):
    """OCSMesh's reader of fort.14, without the rest of it, which is a gigabyte."""
    path = folder / "ocsmesh-2.2.0" / "ocsmesh" / "mesh" / "parsers" / "grd.py"
    spec = importlib.util.spec_from_file_location("grd", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def depths(mindeg, folder):
    """A bay with depths and an open side, by way of each format that has them."""
    bay = folder / "bay.gr3"
    bay.write_text(BAY)
    expected = [3.5, 4, 0, 1.25, 7]
    for suffix in (".slf", ".nc"):
        subprocess.run([mindeg, "convert", bay, "-o", bay.with_suffix(suffix), "--quiet"], check=True)
    for path in (bay.with_suffix(".14"), folder / "written.gr3"):
        subprocess.run([mindeg, "convert", bay, "-o", path, "--quiet"], check=True)
        seen = ocsmesh(folder.parent).read(path, crs=False)
        rows = [line.split() for line in BAY.splitlines()[2:11]]
        nodes = {row[0]: [(float(row[1]), float(row[2])), float(row[3])] for row in rows[:5]}
        yield f"{path.name} in OCSMesh: points and depths", seen["nodes"] == nodes
        yield f"{path.name} in OCSMesh: triangles", seen["elements"] == {row[0]: row[2:] for row in rows[5:]}
        runs = {kind: [run["indexes"] for run in runs.values()] for kind, runs in seen["boundaries"].items()}
        yield f"{path.name} in OCSMesh: the open side and the coast", runs == {None: [[1, 2]], 0: [[2, 3, 4, 1]]}
    selafin = xarray.open_dataset(bay.with_suffix(".slf"), engine="selafin")
    yield "bay.slf: the bottom counts upwards", (-selafin.B.values[0]).tolist() == expected
    codes = [row.split()[:3] for row in bay.with_suffix(".cli").read_text().splitlines()]
    yield "bay.cli: both ends of the open side", codes == [["5", "4", "4"]] * 2 + [["2"] * 3] * 2
    ugrid = xarray.open_dataset(bay.with_suffix(".nc"), engine="scipy")
    yield "bay.nc: depths", ugrid.depth.values.tolist() == expected
    again = folder / "again.gr3"
    subprocess.run([mindeg, "convert", bay.with_suffix(".slf"), "-o", again, "--quiet"], check=True)
    rows = [line.split() for line in again.read_text().splitlines()[2:7]]
    yield "bay.slf in mindeg: points and depths", rows == [line.split() for line in BAY.splitlines()[2:7]]
    # The same depths on a grid, as an ESRI grid and as rows of numpy in another order.
    x, y = numpy.meshgrid(numpy.arange(5.0), numpy.arange(4.0))
    z = 10 + 3 * x + numpy.sin(y)
    head = "ncols 5\nnrows 4\nxllcenter 0\nyllcenter 0\ncellsize 1\n"
    (folder / "depth.asc").write_text(head + "\n".join(" ".join(map(repr, row)) for row in z[::-1].tolist()))
    meshes = []
    for name, kind in (("depth.asc", None), ("depth.npy", ">f8"), ("fortran.npy", "<f8")):
        if kind:
            rows = numpy.column_stack([x.ravel(), y.ravel(), z.ravel()])[::-1].astype(kind)
            numpy.save(folder / name, numpy.asfortranarray(rows) if name == "fortran.npy" else rows)
        out = folder / f"{name}.14"
        command = [mindeg, "mesh", "--rectangle", "4x3", "--size", "0.5", "--interior", "--depth", folder / name, "-o", out, "--quiet"]
        subprocess.run(command, check=True)
        meshes.append(out.read_text().splitlines()[1:])
    yield "depths of numpy's rows", meshes[0] == meshes[1] == meshes[2]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__.strip())
    warnings.simplefilter("ignore")
    mindeg, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    domains = [Path(name) for name in sys.argv[3:]] or sorted(DOMAINS.glob("*.json"))
    folder.mkdir(parents=True, exist_ok=True)
    tally = Tally()
    for name, command, domain in meshes(mindeg, domains):
        paths = [folder / f"{name}{suffix}" for suffix in (".obj", *READERS)]
        outputs = [word for path in paths for word in ("-o", path)]
        finished = subprocess.run(
            [*command, *outputs, "--boundary-lines", "--json"], capture_output=True, text=True
        )
        if finished.returncode:
            tally.record(f"{name} in mindeg", False, finished.stderr.strip())
            continue
        expected = Expected(paths[0], json.loads(finished.stdout), domain)
        points = expected.points[:, :2]
        for path in paths[1:]:
            checks = READERS[path.suffix](path, points, expected.triangles)
            for check, is_right in tally.attempt(f"{path.name}: read", list, checks) or ():
                tally.record(f"{path.name}: {check}", is_right, "not as expected")
    for check, is_right in tally.attempt("bay.gr3: read", list, depths(mindeg, folder)) or ():
        tally.record(check, is_right, "not as expected")
    tally.finish()


if __name__ == "__main__":
    main()
