"""Does the first triangulation of a boundary matter for what is made of it?

Two tables for benches/results/interior.md. First: Lawson's flips from four triangulations of the same boundary
points. Second: the same triangulations divided uniformly, and a Poisson problem solved on each.
"""

import subprocess
import sys
from collections import deque
from fractions import Fraction

import numpy as np
import scipy.sparse.linalg as linalg
import skfem
from skfem.models.poisson import laplace

from meshes import MINDEG, ROOT, angles, folder, mindeg, read_obj, write_section

DOMAINS = [
    "boundary-layer-channel",
    "figure-1",
    "gusset",
    "slender-fin",
    "survey-parcel",
    "unequal-hexagon",
    "wing-panel",
]
STARTS = {
    "least degree": "mindeg",
    "Delaunay": "delaunay",
    "ear clipping": "ear-clipping",
    "fan": "fan",
}


def starts(name, work):
    """The triangulations of a domain's boundary points that `mindeg compare` makes."""
    domain = ROOT / "assets" / "domains" / f"{name}.json"
    meshes = work / name
    command = [MINDEG, "compare", domain, "-o", work / f"{name}.json", "--save-meshes", meshes, "-q"]
    subprocess.run([str(word) for word in command], check=True)
    found = {}
    for start, file in STARTS.items():
        path = meshes / f"{file}.obj"
        if path.exists():
            found[start] = read_obj(path)
    return found


def in_circle(a, b, c, d):
    """Above 0 if d is inside the circle through a, b, c, which run counter-clockwise. Exact in its sign."""

    def determinant(number):
        rows = [[number(p[0]) - number(d[0]), number(p[1]) - number(d[1])] for p in (a, b, c)]
        squares = [x * x + y * y for x, y in rows]
        (ax, ay), (bx, by), (cx, cy) = rows
        return (
            squares[0] * (bx * cy - by * cx)
            + squares[1] * (cx * ay - cy * ax)
            + squares[2] * (ax * by - ay * bx)
        ), max(squares)

    value, square = determinant(float)
    if abs(value) > 1e-9 * square * square:
        return value
    return determinant(Fraction)[0]


def orientation(a, b, c):
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    extent = max(abs(b[0] - a[0]), abs(b[1] - a[1]), abs(c[0] - a[0]), abs(c[1] - a[1]))
    if abs(value) > 1e-12 * extent * extent:
        return value
    a, b, c = ([Fraction(x) for x in p] for p in (a, b, c))
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def lawson(mesh):
    """Flips until the mesh is Delaunay's; the edges then, and the number of flips."""
    points = mesh.points.tolist()
    opposite = {}
    for a, b, c in mesh.triangles.tolist():
        opposite[a, b], opposite[b, c], opposite[c, a] = c, a, b
    queue = deque(edge for edge in opposite if edge[0] < edge[1] and edge[::-1] in opposite)
    queued, flips = set(queue), 0
    while queue:
        edge = queue.popleft()
        queued.discard(edge)
        a, b = edge
        if (a, b) not in opposite or (b, a) not in opposite:
            continue
        c, d = opposite[a, b], opposite[b, a]
        p = [points[v] for v in (a, b, c, d)]
        if in_circle(p[0], p[1], p[2], p[3]) <= 0:
            continue
        # The circle's inside makes the quadrilateral convex, up to rounded sides.
        if orientation(p[2], p[3], p[1]) <= 0 or orientation(p[3], p[2], p[0]) <= 0:
            continue
        flips += 1
        del opposite[a, b], opposite[b, a]
        for u, v, w in ((c, d, b), (d, c, a)):
            opposite[u, v], opposite[v, w], opposite[w, u] = w, u, v
        for u, v in ((a, d), (d, b), (b, c), (c, a)):
            key = (min(u, v), max(u, v))
            if (v, u) in opposite and (u, v) in opposite and key not in queued:
                queued.add(key)
                queue.append(key)
    return {(min(edge), max(edge)) for edge in opposite}, flips


def flip_table(work):
    names = list(STARTS)
    lines = [
        "| domain | inner edges | " + " | ".join(f"from {name}" for name in names) + " | different |",
        "|---|---|" + "---|" * len(names) + "---|",
    ]
    for domain in DOMAINS:
        meshes = starts(domain, work)
        results = {name: lawson(mesh) for name, mesh in meshes.items()}
        count = len(meshes["Delaunay"].points)
        direct = results["Delaunay"][0]
        different = max(len(found - direct) for found, _ in results.values())
        cells = [str(results[name][1]) if name in results else "not valid" for name in names]
        lines.append(f"| {domain} | {count - 3} | " + " | ".join(cells) + f" | {different} |")
        print(domain, file=sys.stderr)
    return "\n".join(lines) + "\n"


def divided(mesh, times):
    """Each triangle in four, so many times."""
    found = skfem.MeshTri(mesh.points.T.copy(), mesh.triangles.T.copy())
    return found.refined(times) if times else found


def poisson(mesh):
    """The L2 error of P1 elements on a smooth solution, and the condition number."""
    low, high = mesh.p.min(axis=1), mesh.p.max(axis=1)
    center, length = (low + high) / 2, (high - low).max()

    def exact(x):
        u, v = (x[0] - center[0]) / length, (x[1] - center[1]) / length
        return np.sin(5 * u + 1) * np.exp(2 * v)

    def load(x):
        return (25 - 4) / length**2 * exact(x)

    basis = skfem.Basis(mesh, skfem.ElementTriP1(), intorder=6)
    matrix = laplace.assemble(basis)
    right = skfem.LinearForm(lambda v, w: load(w.x) * v).assemble(basis)
    values = exact(mesh.p)
    fixed = mesh.boundary_nodes()
    solved = skfem.solve(*skfem.condense(matrix, right, x=values, D=fixed))
    error = skfem.Functional(lambda w: (w["u"] - exact(w.x)) ** 2).assemble(basis, u=solved)
    free = np.setdiff1d(np.arange(mesh.nvertices), fixed)
    inner = matrix[free][:, free].tocsc()
    most = linalg.eigsh(inner, k=1, which="LM", return_eigenvectors=False)[0]
    least = linalg.eigsh(inner, k=1, sigma=0, which="LM", return_eigenvectors=False)[0]
    return float(np.sqrt(error)), float(most / least)


def poisson_table(work):
    lines = [
        "| domain | start | triangles | minimum angle | L2 error x triangles, against Delaunay's | condition number / inner vertices |",
        "|---|---|---|---|---|---|",
    ]
    for domain in DOMAINS:
        if domain == "slender-fin":
            continue
        meshes = starts(domain, work)
        interior, _, _ = mindeg(ROOT / "assets" / "domains" / f"{domain}.json", work)
        meshes["with interior points"] = interior
        reference = None
        order = ["Delaunay", "least degree", "ear clipping", "fan", "with interior points"]
        for name in [name for name in order if name in meshes]:
            mesh = meshes[name]
            least = angles(mesh).min()
            if least <= 1e-6:
                lines.append(f"| {domain} | {name} | | flat triangles | | |")
                continue
            times = 0
            while len(mesh.triangles) * 4**times < 12_000:
                times += 1
            fine = divided(mesh, times)
            error, condition = poisson(fine)
            product = error * fine.nelements
            reference = reference or product
            inner = fine.nvertices - len(fine.boundary_nodes())
            lines.append(
                f"| {domain} | {name} | {fine.nelements:,} | {least:.2f}° | {product / reference:.2f} "
                f"| {condition / inner:.2f} |"
            )
        print(domain, file=sys.stderr)
    return "\n".join(lines) + "\n"


def main():
    work = folder()
    for name, table in [("flips", flip_table(work)), ("poisson", poisson_table(work))]:
        print(table)
        write_section(name, table)


if __name__ == "__main__":
    main()
