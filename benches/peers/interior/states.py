"""mindeg beside Triangle and Gmsh on the states of the USA as one map: the table of benches/results/maps.md.

Every program gets the polygons of us-atlas with each border once, and may add no point to a border. Triangle and Gmsh get the
planar graph by their own interfaces; mindeg gets the file as npm ships it.
"""

import json
import subprocess
import sys
from importlib.metadata import version

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from meshes import MINDEG, Mesh, angles, directed_edges, edges, folder, read_obj, timed, write_section
from outlines import area, load, points_of, polygons_of, ring_of
from peers import in_gmsh, in_triangle


class Map:
    """The points of all polygons, each once, and the edges with the polygons on their left and on their right."""

    def __init__(self, topology):
        self.index, self.beside, self.polygons = {}, {}, []
        arcs = list(points_of(topology))
        for geometry in topology["objects"]["states"]["geometries"]:
            for polygon in polygons_of(geometry):
                rings = [self.ring(ring_of(arcs, ring), hole > 0) for hole, ring in enumerate(polygon)]
                for ring in rings:
                    for a, b in zip(ring, ring[1:] + ring[:1]):
                        self.beside.setdefault((min(a, b), max(a, b)), []).append(len(self.polygons))
                self.polygons.append(rings)
        self.points = np.array(list(self.index))
        self.edges = np.array(sorted(self.beside))
        shared = np.array([len(self.beside[tuple(edge)]) == 2 for edge in self.edges.tolist()])
        on_edge = lambda chosen: np.isin(np.arange(len(self.points)), self.edges[chosen])
        #: Points of borders between polygons that are not on the outer boundary, too.
        self.is_border = on_edge(shared) & ~on_edge(~shared)

    def ring(self, points, is_hole):
        points = [p for p, q in zip(points, points[1:] + points[:1]) if p != q]
        points = points if (area(points) > 0) != is_hole else points[::-1]
        return [self.index.setdefault(tuple(p), len(self.index)) for p in points]

    def inside(self, mesh):
        """The mesh without triangles outside all polygons."""
        sides = np.sort(directed_edges(mesh), axis=1)
        owner = np.tile(np.arange(len(mesh.triangles)), 3)
        order = np.lexsort((sides[:, 1], sides[:, 0]))
        sides, owner = sides[order], owner[order]
        same = (sides[1:] == sides[:-1]).all(axis=1)
        free = np.array([tuple(side) not in self.beside for side in sides[1:].tolist()])
        joins = same & free
        pairs = (np.ones(joins.sum()), (owner[:-1][joins], owner[1:][joins]))
        count, part = connected_components(coo_array(pairs, shape=(len(mesh.triangles),) * 2), directed=False)
        kept = np.zeros(count, dtype=bool)
        # An edge with one polygon has it on the left of the way that the polygon's ring runs.
        ways = {(a, b) for rings in self.polygons for ring in rings for a, b in zip(ring, ring[1:] + ring[:1])}
        for index, t in enumerate(mesh.triangles.tolist()):
            if any(way in ways for way in zip(t, t[1:] + t[:1])):
                kept[part[index]] = True
        return Mesh(mesh.points, mesh.triangles[kept[part]])

    def names(self, points):
        """For each point of a mesh its index among the map's points, bit for bit, or -1."""
        return np.array([self.index.get(tuple(point), -1) for point in points.tolist()])


def shewchuk(options):
    def mesh(states, work):
        found, seconds = in_triangle({"vertices": states.points, "segments": states.edges}, options)
        return states.inside(found), seconds

    return mesh


def frontal(algorithm, smoothings):
    return lambda states, work: in_gmsh(algorithm, smoothings, states.points, states.edges, states.polygons)


def own(states, work):
    out = work / "states.obj"
    given = ["--layer", "states", "--name-by", "name", "--interior", "-o", out, "-q"]
    _, seconds = timed([MINDEG, "mesh", work / "states-albers-10m.json", *given])
    return read_obj(out), seconds


PROGRAMS = {
    "Triangle `pqYY`": shewchuk("pqYY"),
    "Triangle `pq30YY`": shewchuk("pq30YY"),
    "Gmsh Frontal-Delaunay (6)": frontal(6, 1),
    "Gmsh Frontal-Delaunay (6), 10 smoothings": frontal(6, 10),
    "**mindeg --interior**": own,
}


def row(name, states, mesh, seconds):
    names = states.names(mesh.points)
    kept = {tuple(sorted(edge)) for edge in names[edges(mesh)].tolist()}
    lost = [edge for edge in states.beside if edge not in kept]
    if lost:
        raise ValueError(f"{len(lost)} edges of the map are missing")
    degrees = np.bincount(edges(mesh).ravel(), minlength=len(mesh.points))
    is_border = (names >= 0) & states.is_border[names]
    border, free = degrees[is_border], degrees[(names < 0) & (degrees > 0)]
    cells = [
        name,
        f"{len(mesh.triangles):,}",
        f"{((free < 5) | (free > 7)).sum():,} of {len(free):,}",
        f"{(border > 7).sum()} / {(border < 5).sum()} of {len(border):,}",
        str(degrees.max()),
        f"{angles(mesh).min():.2f}°",
        f"{seconds:.2f}",
    ]
    return "| " + " | ".join(cells) + " |"


def main():
    work = folder()
    subprocess.run(["npm", "pack", "--silent", "us-atlas@3.0.1", "--pack-destination", work], check=True, capture_output=True)
    text = load(work, "us-atlas", "states-albers-10m.json")
    (work / "states-albers-10m.json").write_text(text)
    states = Map(json.loads(text))
    rows = []
    for name, program in PROGRAMS.items():
        try:
            rows.append(row(name, states, *program(states, work)))
        except (ValueError, RuntimeError) as error:
            print(f"{name}: {error}", file=sys.stderr)
            rows.append(f"| {name} | no mesh: {error} | | | | | |")
        print(rows[-1], file=sys.stderr, flush=True)
    packages = ", ".join(f"{package} {version(package)}" for package in ["triangle", "gmsh"])
    text = f"""\
| program | triangles | free vertices outside 5..7 | border vertices above 7 / below 5 | greatest degree | minimum angle | CPU s |
|---|---|---|---|---|---|---|
{chr(10).join(rows)}

{len(states.polygons)} polygons, {len(states.points):,} points; packages {packages}. Border vertices are those between states alone.
"""
    print(text)
    write_section("states", text, page="benches/results/maps.md")


if __name__ == "__main__":
    main()
