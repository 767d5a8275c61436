"""Boundaries, what a mesh of one is like, and mindeg called as its users call it."""

import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]
MINDEG = os.environ["MINDEG"]


@dataclass
class Mesh:
    """Points and counter-clockwise triangles; the boundary's points come first."""

    points: np.ndarray
    triangles: np.ndarray


@dataclass
class Case:
    """A boundary, its outline first and holes after it, with the proven limit of its minimum angle."""

    name: str
    domain: Path
    rings: list
    limit: float

    @property
    def points(self):
        return np.concatenate(self.rings)

    @property
    def edges(self):
        """The boundary's edges, by indices of its points."""
        starts = np.cumsum([0] + [len(ring) for ring in self.rings])
        turn = lambda start, end: np.roll(np.arange(start, end), -1)
        after = np.concatenate([turn(a, b) for a, b in zip(starts, starts[1:])])
        return np.stack([np.arange(len(after)), after], axis=1)

    @property
    def degrees(self):
        """The most edges at each vertex of the boundary: 5, at reflex corners 2 + round(angle / 60 degrees)."""
        points, edges = self.points, self.edges
        before = np.empty(len(points), dtype=int)
        before[edges[:, 1]] = edges[:, 0]
        u, v = points[edges[:, 1]] - points, points[before] - points
        turn = np.arctan2(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0], (u * v).sum(axis=1)) % math.tau
        reflex = turn > math.pi * (1 + 1e-9)
        wide = 2 + np.floor(turn / (math.pi / 3) + 0.5 + 1e-9).astype(int)
        return np.where(reflex, np.maximum(5, wide), 5)


def random_polygon(numbers):
    """A convex polygon of 3 to 8 sides on an ellipse, with 3 to 60 intervals on each side."""
    sides = numbers.randint(3, 8)
    flat = 0.4 + 0.6 * numbers.random()
    while True:
        turns = sorted(numbers.random() for _ in range(sides))
        gaps = [(turns[(i + 1) % sides] - turns[i]) % 1.0 for i in range(sides)]
        if all(0.3 / sides < gap < 0.45 for gap in gaps):
            break
    corners = [
        [10 * math.cos(math.tau * turn), 10 * flat * math.sin(math.tau * turn)] for turn in turns
    ]
    counts = [{"intervals": numbers.randint(3, 60)} for _ in range(sides)]
    return {"polygon": {"corners": corners}, "sides": counts}


def cases(folder):
    """The convex domains of assets/domains and twelve random polygons, always the same."""
    domains = sorted((ROOT / "assets" / "domains").glob("*.json"))
    domains = [path for path in domains if is_convex(path)]
    numbers = random.Random(12)
    for index in range(12):
        path = folder / f"random-{index + 1:02}.json"
        path.write_text(json.dumps(random_polygon(numbers)))
        domains.append(path)
    return [case(path, folder) for path in domains]


def outlines(folder):
    """Shapes made by chance and real outlines, which mindeg was not tuned to."""
    script = Path(__file__).with_name("outlines.py")
    run([sys.executable, script, folder])
    files = [path for part in ["shapes", "real"] for path in sorted((folder / part).glob("*.json"))]
    return [case(path, folder) for path in files]


def is_convex(path):
    """Whether a file is one of a convex domain without holes, which all programs here take."""
    return run([MINDEG, "degree", path], check=False).returncode == 0


def case(domain, folder):
    mesh, summary, _ = mindeg(domain, folder)
    points = mesh.points[: summary["boundary_vertices"]]
    # Rings one after another: an edge of the mesh's rim from each point to the next closes one.
    sides = {tuple(edge) for edge in directed_edges(mesh).tolist()}
    after = dict(edge for edge in sides if edge[::-1] not in sides)
    rings, start = [], 0
    while start < len(points):
        end = start
        while after[end] != start:
            end += 1
        rings.append(points[start : end + 1])
        start = end + 1
    return Case(domain.stem, domain, rings, summary["limit"]["angle_limit"])


def run(command, check=True):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if check and done.returncode not in (0,):
        raise RuntimeError(f"{command}: {done.stderr}")
    return done


def timed(command):
    """Runs a command; its output and the processor's time it took, in seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = run(command)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, spent


def mindeg(domain, folder):
    """A mesh of a domain with interior points, the summary, and the seconds."""
    out = folder / "mindeg.obj"
    text, seconds = timed([MINDEG, "mesh", domain, "--interior", "-o", out, "--json", "-q"])
    return read_obj(out), json.loads(text), seconds


def improve(mesh, folder):
    """A mesh improved by `mindeg improve`, and the seconds."""
    before, after = folder / "before.obj", folder / "after.obj"
    write_obj(mesh, before)
    _, seconds = timed([MINDEG, "improve", before, "-o", after, "-q"])
    return read_obj(after), seconds


def read_obj(path):
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(x) for x in words[1:3]])
        elif words[:1] == ["f"]:
            triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return Mesh(np.array(points), np.array(triangles))


def write_obj(mesh, path):
    lines = [f"v {x!r} {y!r} 0" for x, y in mesh.points.tolist()]
    lines += ["f {} {} {}".format(*(t + 1)) for t in mesh.triangles]
    path.write_text("\n".join(lines) + "\n")


def angles(mesh):
    """The angles of all triangles in degrees, three a row."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))

    def at(p, q, r):
        u, v = q - p, r - p
        cross = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        return np.degrees(np.arctan2(cross, (u * v).sum(axis=1)))

    return np.stack([at(a, b, c), at(b, c, a), at(c, a, b)], axis=1)


def directed_edges(mesh):
    t = mesh.triangles
    return np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]])


def edges(mesh):
    return np.unique(np.sort(directed_edges(mesh), axis=1), axis=0)


@dataclass
class Figures:
    triangles: int
    min_angle: float
    share: float
    mean_min_angle: float
    eta: float
    interior: int
    boundary: int
    violations: int
    grading: float


def measure(mesh, case):
    """What a mesh of a boundary is like; fails on one that is no mesh of it."""
    count = len(case.points)
    if not np.array_equal(mesh.points[:count], case.points):
        raise ValueError("the boundary's points were changed")
    all_angles = angles(mesh)
    if all_angles.min() <= 0:
        raise ValueError("a triangle is inverted or flat")
    sides = {tuple(edge) for edge in directed_edges(mesh).tolist()}
    rim = {tuple(edge) for edge in case.edges.tolist()}
    if {edge for edge in sides if edge[::-1] not in sides} != rim:
        raise ValueError("the boundary's edges are others")
    degrees = np.bincount(edges(mesh).ravel(), minlength=len(mesh.points))
    inside, outside = degrees[count:], degrees[:count]
    inside = inside[inside > 0]
    wrong = int((outside > case.degrees).sum()) + int(((inside < 5) | (inside > 7)).sum())
    least = all_angles.min(axis=1)
    return Figures(
        triangles=len(mesh.triangles),
        min_angle=float(least.min()),
        share=float(least.min() / case.limit),
        mean_min_angle=float(least.mean()),
        eta=eta(mesh),
        interior=int(inside.max(initial=0)),
        boundary=int(outside.max()),
        violations=wrong,
        grading=grading(mesh),
    )


def eta(mesh):
    """The mean of 4 sqrt(3) times the area over the sum of the squared edges: 1 for equilateral triangles."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    doubled = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    squares = (u**2).sum(axis=1) + (v**2).sum(axis=1) + ((c - b) ** 2).sum(axis=1)
    return float((2 * math.sqrt(3) * doubled / squares).mean())


def grading(mesh):
    """The 99th percentile of the square root of the area ratio of neighbouring triangles."""
    a, b, c = (mesh.points[mesh.triangles[:, i]] for i in range(3))
    u, v = b - a, c - a
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    owner = np.tile(np.arange(len(mesh.triangles)), 3)
    both = np.sort(directed_edges(mesh), axis=1)
    order = np.lexsort((both[:, 1], both[:, 0]))
    both, owner = both[order], owner[order]
    same = (both[1:] == both[:-1]).all(axis=1)
    ratio = area[owner[1:][same]] / area[owner[:-1][same]]
    if len(ratio) == 0:
        return 1.0
    return float(np.percentile(np.sqrt(np.maximum(ratio, 1 / ratio)), 99))


def write_section(name, text, page="benches/results/interior.md"):
    """Replaces the text between two marks of a page."""
    page = ROOT / page
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    content = page.read_text()
    head, rest = content.split(begin)
    page.write_text(head + begin + text + end + rest.split(end)[1])


def folder():
    return Path(tempfile.mkdtemp(prefix="mindeg-interior-"))
