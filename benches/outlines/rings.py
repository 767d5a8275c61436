#!/usr/bin/env python3
"""Outlines of countries (Natural Earth, npm package world-atlas) as rings of points in text files.

Installs the package into target/outlines, takes the largest ring of each country, and writes one file
a country and resolution with a line "x y" for each point. `ring_degrees`, an example of the crate mindeg,
reads them:

    benches/outlines/rings.py 10m Canada Brazil
    cargo run --release -p mindeg --example ring_degrees -- target/outlines/*.txt

The package rounds coordinates to a grid, on which many rings touch or cross themselves. The script stays
on the grid, where products are exact, and mends the rings: spikes go, a vertex on another edge is put
into it, loops that touch or cross the rest are cut off. y is scaled by a number with few bits.
"""

import json
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

PACKAGE = "world-atlas@2.0.2"
FOLDER = Path(__file__).resolve().parents[2] / "target" / "outlines"
# The side of the squares that edges are looked up in.
CELL = 64


def cross(o, p, q):
    return (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])


def is_between(p, a, b):
    """Whether p is on the edge from a to b, and neither end."""
    within = all(min(a[i], b[i]) <= p[i] <= max(a[i], b[i]) for i in (0, 1))
    return within and p != a and p != b and cross(a, b, p) == 0


def without_spikes(ring):
    kept = []
    for point in ring:
        kept.append(point)
        while len(kept) >= 3:
            a, b, c = kept[-3:]
            back = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) <= 0
            if cross(a, b, c) != 0 or not back:
                break
            kept[-2:] = [c] if c != a else []
    return kept


def with_touching_vertices(ring):
    columns = defaultdict(list)
    for point in ring:
        columns[point[0] // CELL].append(point)
    points = []
    for a, b in zip(ring, ring[1:] + ring[:1]):
        low, high = sorted((a[0] // CELL, b[0] // CELL))
        on = {p for column in range(low, high + 1) for p in columns[column] if is_between(p, a, b)}
        points += [a] + sorted(on, key=lambda p: (p[0] - a[0]) ** 2 + (p[1] - a[1]) ** 2)
    return points


def largest_loop(ring):
    """The longest part between two visits of a point."""
    path, places, loops = [], {}, []
    for point in ring:
        if point in places:
            start = places[point]
            loops.append(path[start:])
            for other in path[start + 1 :]:
                del places[other]
            del path[start + 1 :]
        else:
            places[point] = len(path)
            path.append(point)
    return max(loops + [path], key=len)


def without_crossing(ring):
    """The ring without the shorter part between two edges that cross, or None if none do."""
    edges = list(zip(ring, ring[1:] + ring[:1]))
    squares = defaultdict(list)
    for i, (a, b) in enumerate(edges):
        columns = range(min(a[0], b[0]) // CELL, max(a[0], b[0]) // CELL + 1)
        rows = range(min(a[1], b[1]) // CELL, max(a[1], b[1]) // CELL + 1)
        for square in ((x, y) for x in columns for y in rows):
            for j in squares[square]:
                c, d = edges[j]
                apart = cross(a, b, c) * cross(a, b, d) < 0 and cross(c, d, a) * cross(c, d, b) < 0
                if apart:
                    short = i - j < len(ring) / 2
                    return ring[: j + 1] + ring[i + 1 :] if short else ring[j + 1 : i + 1]
            squares[square].append(i)
    return None


def mended(ring):
    while True:
        before = ring
        ring = largest_loop(with_touching_vertices(without_spikes(ring)))
        if ring == before:
            shorter = without_crossing(ring)
            if shorter is None:
                return ring
            ring = shorter


def main():
    resolution, *names = sys.argv[1:] or ["10m"]
    FOLDER.mkdir(parents=True, exist_ok=True)
    subprocess.run(["npm", "install", "--silent", "--prefix", FOLDER, PACKAGE], check=True)
    path = FOLDER / "node_modules" / "world-atlas" / f"countries-{resolution}.json"
    atlas = json.loads(path.read_text())
    scale_x, scale_y = atlas["transform"]["scale"]
    stretch = round(scale_y / scale_x * 64) / 64
    arcs = []
    for arc in atlas["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x, y = x + dx, y + dy
            points.append((x, y))
        arcs.append(points)

    def ring(ids):
        points = []
        for index in ids:
            arc = arcs[index] if index >= 0 else arcs[~index][::-1]
            points += arc[1:] if points else arc
        return points[:-1]

    for country in atlas["objects"]["countries"]["geometries"]:
        name = country["properties"]["name"]
        if names and name not in names:
            continue
        polygons = country.get("arcs") or []
        if country["type"] == "Polygon":
            polygons = [polygons]
        outline = mended(max((ring(polygon[0]) for polygon in polygons), key=len, default=[]))
        area = sum(cross((0, 0), a, b) for a, b in zip(outline, outline[1:] + outline[:1]))
        if area < 0:
            outline.reverse()
        lines = "".join(f"{x} {y * stretch!r}\n" for x, y in outline)
        (FOLDER / f"{name.replace(' ', '_')}_{resolution}.txt").write_text(lines)


if __name__ == "__main__":
    main()
