"""Writes domains to measure on, always the same: shapes made by chance and real outlines.

    python3 outlines.py FOLDER

FOLDER/shapes: 40 L, T, U, wedge, star and hole shapes. FOLDER/real: 50 states, counties, countries and icons of at most
260 points. FOLDER/states: all polygons of the states of the USA; FOLDER/us: the lower 48 with borders as fixed lines. Real outlines
come from the npm packages us-atlas, world-atlas and simple-icons, which npm fetches.
"""

import gzip
import io
import json
import math
import random
import re
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

PACKAGES = ["us-atlas@3.0.1", "world-atlas@2.0.2", "simple-icons@15.22.0"]


def corners_of(kind, numbers):
    a, b = numbers.uniform(0.2, 0.8), numbers.uniform(0.2, 0.8)
    w, h = numbers.uniform(3, 9), numbers.uniform(3, 9)
    if kind == "l":
        return [[0, 0], [w, 0], [w, a * h], [b * w, a * h], [b * w, h], [0, h]]
    if kind == "t":
        left, right = sorted([0.45 * a, 1 - 0.45 * b])
        return [[left * w, 0], [right * w, 0], [right * w, a * h], [w, a * h], [w, h], [0, h], [0, a * h], [left * w, a * h]]
    if kind == "u":
        left, right = 0.45 * a, 1 - 0.45 * b
        return [[0, 0], [w, 0], [w, h], [right * w, h], [right * w, a * h], [left * w, a * h], [left * w, h], [0, h]]
    if kind == "wedge":
        turn = math.radians(numbers.uniform(12, 50))
        return [[0, 0], [10, 0], [10 * math.cos(turn), 10 * math.sin(turn)]]
    count = numbers.randint(5, 9)
    if kind == "star":
        radii = [numbers.uniform(3, 9) for _ in range(count)]
    else:
        radii = [numbers.uniform(6, 9)] * count
    return [
        [r * math.cos(math.tau * i / count), r * math.sin(math.tau * i / count)]
        for i, r in enumerate(radii)
    ]


def shapes():
    numbers = random.Random(2026)
    for index in range(40):
        kind = ["l", "t", "u", "wedge", "star", "hole"][index % 6]
        corners = [[round(x, 6) for x in corner] for corner in corners_of(kind, numbers)]
        size = numbers.uniform(0.4, 1.0)
        sides = [{"size": round(size * numbers.choice([0.5, 1, 1, 1, 2]), 4)} for _ in corners]
        domain = {"polygon": {"corners": corners}, "sides": sides}
        if kind == "hole":
            at, r = numbers.uniform(-1, 1), numbers.uniform(1, 2)
            square = [[at - r, -r], [at + r, -r], [at + r, r], [at - r, r]]
            domain["holes"] = [{"corners": [[round(x, 6) for x in c] for c in square], "size": round(size, 4)}]
        yield f"{kind}{index:02}", domain


def points_of(topology):
    (sx, sy), (tx, ty) = topology["transform"]["scale"], topology["transform"]["translate"]
    for arc in topology["arcs"]:
        x = y = 0
        points = []
        for dx, dy in arc:
            x, y = x + dx, y + dy
            points.append([x * sx + tx, y * sy + ty])
        yield points


def ring_of(arcs, indices):
    ring = []
    for index in indices:
        points = arcs[index] if index >= 0 else arcs[~index][::-1]
        ring += points[:-1]
    return ring


def polygons_of(geometry):
    return {"Polygon": [geometry.get("arcs")], "MultiPolygon": geometry.get("arcs")}.get(geometry["type"], [])


def area(ring):
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1])) / 2


def domain(name, rings):
    rings = [[p for p, q in zip(ring, ring[1:] + ring[:1]) if p != q] for ring in rings]
    if any(len(ring) < 3 for ring in rings):
        return None
    outer = rings[0] if area(rings[0]) > 0 else rings[0][::-1]
    holes = [ring if area(ring) < 0 else ring[::-1] for ring in rings[1:]]
    found = {"name": name, "ring": outer}
    if holes:
        found["holes"] = [{"ring": ring} for ring in holes]
    return found


def load(folder, package, path):
    archive = next(Path(folder).glob(package + "-*.tgz"))
    with tarfile.open(archive) as tar:
        return tar.extractfile("package/" + path).read().decode()


def polygons(topology, name):
    arcs = list(points_of(topology))
    for geometry in topology["objects"][name]["geometries"]:
        label = re.sub(r"\W+", "_", str(geometry.get("properties", {}).get("name", geometry.get("id"))))
        for index, polygon in enumerate(polygons_of(geometry)):
            found = domain(f"{label}-{index}", [ring_of(arcs, ring) for ring in polygon])
            if found:
                yield found


def lower_48(topology):
    """The mainland as one outline, the borders between states as fixed lines."""
    arcs = list(points_of(topology))
    uses = {}
    for geometry in topology["objects"]["states"]["geometries"]:
        for polygon in polygons_of(geometry):
            for arc in (a if a >= 0 else ~a for ring in polygon for a in ring):
                uses[arc] = uses.get(arc, 0) + 1
    nation = topology["objects"]["nation"]["geometries"][0]
    rings = max(polygons_of(nation), key=lambda p: abs(area(ring_of(arcs, p[0]))))
    found = domain("lower-48", [ring_of(arcs, ring) for ring in rings])
    known = {tuple(p) for ring in [found["ring"]] for p in ring}
    lines = [arcs[arc] for arc, count in sorted(uses.items()) if count == 2]
    joined, left = [], lines
    while True:
        now = [line for line in left if tuple(line[0]) in known or tuple(line[-1]) in known]
        if not now:
            break
        left = [line for line in left if line not in now]
        known |= {tuple(p) for line in now for p in line}
        joined += now
    outer = list(zip(found["ring"], found["ring"][1:] + found["ring"][:1]))
    sides = {frozenset(map(tuple, ends)) for ends in outer}
    lines = []
    for line in joined:
        run = [line[0]]
        for start, end in zip(line, line[1:]):
            if frozenset(map(tuple, (start, end))) in sides:
                lines.append(run)
                run = [end]
            else:
                run.append(end)
        lines.append(run)
    found["lines"] = [{"points": run} for run in lines if len(run) > 1]
    found["interior"] = {}
    return found


def icon(text):
    """The largest closed run of straight pieces of an icon's path, if it has at least 8 points."""
    path = re.search(r' d="([^"]+)"', text)
    tokens = re.findall(r"[a-zA-Z]|-?(?:\d+\.?\d*|\.\d+)", path.group(1)) if path else []
    x = y = 0.0
    rings, ring, command, i = [], [], "", 0
    counts = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6, "s": 4, "q": 4, "t": 2, "z": 0}
    while i < len(tokens):
        if tokens[i].isalpha():
            command = tokens[i]
            i += 1
        kind = command.lower()
        if kind not in counts:
            return None
        count = counts[kind]
        if kind == "z":
            rings.append(ring)
            ring = []
            continue
        try:
            values = [float(t) for t in tokens[i : i + count]]
        except ValueError:
            return None
        i += count
        base = (x, y) if command.islower() else (0.0, 0.0)
        if kind == "h":
            x = base[0] + values[0]
        elif kind == "v":
            y = base[1] + values[0]
        else:
            x, y = base[0] + values[-2], base[1] + values[-1]
        if kind == "m":
            ring = []
            command = "l" if command == "m" else "L"
        ring.append([round(x, 6), round(-y, 6)])
    rings = [r for r in rings if len(r) >= 8]
    return max(rings, key=lambda r: abs(area(r)), default=None)


def is_simple(ring):
    def turn(a, b, c):
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    edges = list(zip(ring, ring[1:] + ring[:1]))
    for i, (a, b) in enumerate(edges):
        for c, d in edges[i + 2 : len(edges) - (i == 0)]:
            if turn(a, b, c) * turn(a, b, d) <= 0 and turn(c, d, a) * turn(c, d, b) <= 0:
                return False
    return True


def write(folder, domains):
    folder.mkdir(parents=True, exist_ok=True)
    for name, found in domains:
        (folder / f"{name}.json").write_text(json.dumps(found))


def main():
    target = Path(sys.argv[1])
    write(target / "shapes", shapes())
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["npm", "pack", "--silent", *PACKAGES], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        states = json.loads(load(folder, "us-atlas", "states-albers-10m.json"))
        counties = json.loads(load(folder, "us-atlas", "counties-albers-10m.json"))
        world = json.loads(load(folder, "world-atlas", "countries-50m.json"))
        all_states = list(polygons(states, "states"))
        write(target / "states", ((d["name"], d) for d in all_states))
        write(target / "us", [("lower-48", lower_48(states))])
        numbers = random.Random(2027)
        size = lambda d: len(d["ring"]) + sum(len(h["ring"]) for h in d.get("holes", []))
        some = lambda found, low, count: numbers.sample([d for d in found if low <= size(d) <= 260], count)
        real = [("state", d) for d in some(all_states, 20, 12)]
        real += [("county", d) for d in some(list(polygons(counties, "counties")), 20, 13)]
        real += [("country", d) for d in some(list(polygons(world, "countries")), 20, 12)]
        archive = next(Path(folder).glob("simple-icons-*.tgz"))
        # Members are read in any order, which takes long in a compressed file.
        with tarfile.open(fileobj=io.BytesIO(gzip.decompress(archive.read_bytes()))) as tar:
            names = sorted(m for m in tar.getnames() if m.endswith(".svg"))
            numbers.shuffle(names)
            icons = 0
            for name in names:
                ring = icon(tar.extractfile(name).read().decode())
                if ring and len(ring) <= 260 and icons < 13:
                    found = domain("icon-" + Path(name).stem, [ring])
                    if found and len(found["ring"]) >= 8 and is_simple(found["ring"]):
                        real.append(("icon", found))
                        icons += 1
        write(target / "real", ((f"{kind}-{d['name']}", d) for kind, d in real))


if __name__ == "__main__":
    main()
