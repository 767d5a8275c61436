"""Periodic curves between mindeg and Gmsh: what mindeg writes Gmsh reads, and what Gmsh writes mindeg keeps.

    gmsh_periodic.py MINDEG_BINARY FOLDER [DOMAIN.json ...]
"""

import json
import subprocess
import sys
from pathlib import Path

import gmsh
from tally import Tally

# The right side is the left one, moved; the top is the bottom.
TORUS = {
    "polygon": {"corners": [[0, 0], [4, 0], [4.25, 3], [0.25, 3]]},
    "sides": [
        {"intervals": 9, "name": "bottom", "spacing": {"bump": {"ratio": 0.5}}},
        {"name": "right", "match": {"of": "left"}},
        {"name": "top", "match": {"of": "bottom"}},
        {"intervals": 7, "name": "left"},
    ],
}

# A quarter of a ring, whose cuts are periodic by rotation, and a box, whose sides are by translation.
SECTOR = """
Point(1) = {1, 0, 0, 0.2}; Point(2) = {3, 0, 0, 0.4}; Point(3) = {0, 3, 0, 0.4}; Point(4) = {0, 1, 0, 0.2}; Point(9) = {0, 0, 0};
Line(1) = {1, 2}; Circle(2) = {2, 9, 3}; Line(3) = {3, 4}; Circle(4) = {4, 9, 1};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Periodic Curve {3} = {-1} Rotate {{0, 0, 1}, {0, 0, 0}, Pi / 2};
Physical Curve("cuts") = {1, 3}; Physical Curve("walls") = {2, 4}; Physical Surface("fluid") = {1};
"""


def links(path):
    """For each periodic curve that Gmsh finds in a file: the pairs of points, and the points moved by its matrix."""
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        tags, flat, _ = gmsh.model.mesh.getNodes()
        point = {tag: flat[3 * index : 3 * index + 3] for index, tag in enumerate(tags)}
        found = []
        for _, curve in gmsh.model.getEntities(1):
            other, nodes, others, matrix = gmsh.model.mesh.getPeriodicNodes(1, curve)
            if other != curve:
                rows = [matrix[4 * row : 4 * row + 4] for row in range(3)]
                moved = [[sum(row[i] * point[node][i] for i in range(3)) + row[3] for row in rows] for node in others]
                found.append(([point[node] for node in nodes], moved))
        return found
    finally:
        gmsh.finalize()


def links_in_text(path):
    """The same from the text of an MSH 2.2: Gmsh 4.15 takes no periodic curves from that version, not even its own."""
    parts = path.read_text(encoding="utf-8").split("$")
    nodes, periodic = (next(part for part in parts if part.startswith(name)).split("\n") for name in ("Nodes", "Periodic"))
    point = {int(tag): [float(x) for x in at] for tag, *at in (line.split() for line in nodes[2:-1])}
    rest, found = iter(periodic[2:]), []
    for _ in range(int(periodic[1])):
        next(rest)
        matrix = [float(x) for x in next(rest).removeprefix("Affine ").split()]
        rows = [matrix[4 * row : 4 * row + 4] for row in range(3)]
        pairs = [[int(tag) for tag in next(rest).split()] for _ in range(int(next(rest)))]
        moved = [[sum(row[i] * point[of][i] for i in range(3)) + row[3] for row in rows] for _, of in pairs]
        found.append(([point[node] for node, _ in pairs], moved))
    return found


def farthest(links):
    return max((abs(a - b) for own, moved in links for one, other in zip(own, moved) for a, b in zip(one, other)), default=9.0)


def main():
    mindeg, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    tally = Tally()

    def run(*arguments):
        subprocess.run([mindeg, *arguments, "-q"], check=True, capture_output=True, text=True)

    domain = folder / "torus.json"
    domain.write_text(json.dumps(TORUS), encoding="utf-8")
    for version in ("2.2", "4.1"):
        for encoding in ((), ("--ascii",)):
            mesh = folder / "torus.msh"
            name = f"a torus in MSH {version} {' '.join(encoding)}"
            run("mesh", domain, "--interior", "-o", mesh, "--msh-version", version, *encoding)
            found = tally.attempt(f"Gmsh reads {name}", links, mesh)
            if version == "2.2":
                found = links_in_text(mesh) if encoding else None
            if found is not None:
                counts = sorted(len(own) for own, _ in found)
                tally.record(f"{name} has both pairs of sides", counts == [8, 10], counts)
                tally.record(f"{name} is periodic to the last bit", farthest(found) <= 1e-15, farthest(found))

    script, curves, mesh = folder / "sector.geo", folder / "sector.msh", folder / "sector-mesh.msh"
    script.write_text(SECTOR, encoding="utf-8")
    gmsh_program = Path(sys.executable).parent / "gmsh"
    for version in ("22", "41"):
        command = [sys.executable, gmsh_program, "-1", script, "-o", curves, "-format", f"msh{version}", "-v", "0"]
        subprocess.run(command, check=True, capture_output=True, text=True)
        run("mesh", curves, "--interior", "-o", mesh)
        found = tally.attempt(f"Gmsh reads a sector of its own from MSH {version}", links, mesh)
        if found is not None:
            counts = [len(own) for own, _ in found]
            tally.record(f"the sector of MSH {version} stays periodic", len(found) == 1 and counts[0] > 5, counts)
            tally.record(f"the sector of MSH {version} matches", bool(found) and farthest(found) <= 1e-14)
    tally.finish()


if __name__ == "__main__":
    main()
