"""mindeg remesh beside other programs on the same surfaces: the tables of benches/results/surfaces.md.

Each peer gets its edge length by up to four trials, until it has the vertices that mindeg has, within 3 %. All meshes are judged
by `mindeg verify --surface`, which shares no code with what makes them: degrees, minimum angle, distances both ways. Seconds are processor
time: of the whole process for mindeg and MMGS, of the call alone, without reading and writing, for the others.
"""

import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np

import parts
from meshes import read_obj, read_off, write_obj

ROOT = Path(__file__).resolve().parents[3]
MINDEG = os.environ["MINDEG"]
MODELS = Path(os.environ["MODELS"])
# Models of libcgal-demo: whether features are looked for.
SHIPPED = {"fandisk": True, "anchor": True, "joint": True, "bones": False}
FEATURE = 40.0


def measured(work):
    start = time.process_time()
    result = work()
    return result, time.process_time() - start


def run(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return result, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def mindeg(part, features, repair, work):
    out = work / "mindeg.obj"
    angle = FEATURE if features else 180
    command = [MINDEG, "remesh", part, "-o", out, "--feature-angle", angle, "--json", *(["--repair"] if repair else [])]
    result, seconds = run(command)
    if not result.stdout:
        raise RuntimeError(result.stderr.strip()[-200:])
    return *read_obj(out), seconds, json.loads(result.stdout)


def pymeshlab_(part, features, size, work):
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(part))
    meshes.meshing_merge_close_vertices(threshold=pymeshlab.PercentageValue(1e-6))
    options = {"iterations": 10, "targetlen": pymeshlab.PureValue(size), "featuredeg": FEATURE if features else 180.0}
    _, seconds = measured(lambda: meshes.meshing_isotropic_explicit_remeshing(**options))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix(), seconds


def gpytoolbox_(part, features, size, work):
    import gpytoolbox

    points, triangles = read_obj(part)
    call = lambda: gpytoolbox.remesh_botsch(points, triangles.astype(np.int32), i=10, h=size, project=True)
    (points, triangles), seconds = measured(call)
    return points, triangles, seconds


def mmgs(part, features, size, work):
    import mmgs as package

    before, after = work / "mmgs.mesh", work / "mmgs.o.mesh"
    points, triangles = read_obj(part)
    with before.open("w") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices {len(points)}\n")
        file.writelines(f"{x!r} {y!r} {z!r} 0\n" for x, y, z in points.tolist())
        file.write(f"Triangles {len(triangles)}\n")
        file.writelines(f"{a + 1} {b + 1} {c + 1} 0\n" for a, b, c in triangles.tolist())
        file.write("End\n")
    program = Path(package.__file__).with_name("mmgs_O3")
    detection = ["-ar", FEATURE] if features else ["-nr"]
    diagonal = np.linalg.norm(points.max(axis=0) - points.min(axis=0))
    # With a closer distance it has more vertices than wanted, whatever its edge length.
    options = ["-v", 0, *detection, "-hsiz", size, "-hausd", 0.01 * diagonal]
    result, seconds = run([program, *options, before, after])
    if not after.exists():
        raise RuntimeError(result.stderr.strip()[-200:])
    words = after.read_text().split()
    at = words.index("Vertices")
    count = int(words[at + 1])
    points = np.array(words[at + 2 : at + 2 + 4 * count], dtype=float).reshape(-1, 4)[:, :3]
    at = words.index("Triangles")
    count = int(words[at + 1])
    triangles = np.array(words[at + 2 : at + 2 + 4 * count], dtype=int).reshape(-1, 4)[:, :3] - 1
    return points, triangles, seconds


def cgal(part, features, size, work):
    from compas_cgal.meshing import trimesh_remesh

    points, triangles = read_obj(part)
    call = lambda: trimesh_remesh((points, triangles.astype(np.int32)), size, 10)
    (points, triangles), seconds = measured(call)
    return np.asarray(points), np.asarray(triangles), seconds


def pyacvd_(part, features, size, work):
    import pyacvd
    import pyvista

    points, triangles = read_obj(part)
    faces = np.hstack([np.full((len(triangles), 1), 3), triangles])
    area = 0.5 * np.linalg.norm(
        np.cross(points[triangles[:, 1]] - points[triangles[:, 0]], points[triangles[:, 2]] - points[triangles[:, 0]]), axis=1
    ).sum()
    wanted = round(area / (0.5 * math.sqrt(3) * size * size))

    def call():
        clustering = pyacvd.Clustering(pyvista.PolyData(points, faces))
        while clustering.mesh.n_points < 10 * wanted:
            clustering.subdivide(2)
        clustering.cluster(wanted)
        return clustering.create_mesh()

    mesh, seconds = measured(call)
    return np.asarray(mesh.points), np.asarray(mesh.faces).reshape(-1, 4)[:, 1:], seconds


def gmsh_(part, features, size, work):
    import gmsh

    stl = work / "gmsh.stl"
    points, triangles = read_obj(part)
    with stl.open("w") as file:
        file.write("solid part\n")
        for corners in points[triangles].tolist():
            file.write("facet normal 0 0 0\nouter loop\n")
            file.writelines(f"vertex {x!r} {y!r} {z!r}\n" for x, y, z in corners)
            file.write("endloop\nendfacet\n")
        file.write("endsolid part\n")
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("Mesh.Algorithm", 6)
        gmsh.merge(str(stl))

        def call():
            gmsh.model.mesh.classifySurfaces(math.radians(FEATURE if features else 180), True, True, math.pi)
            gmsh.model.mesh.createGeometry()
            gmsh.option.setNumber("Mesh.MeshSizeMin", size)
            gmsh.option.setNumber("Mesh.MeshSizeMax", size)
            gmsh.model.mesh.generate(2)

        _, seconds = measured(call)
        tags, points, _ = gmsh.model.mesh.getNodes()
        index = {tag: i for i, tag in enumerate(tags.tolist())}
        _, triangles = gmsh.model.mesh.getElementsByType(2)
        corners = np.array([index[tag] for tag in triangles.tolist()]).reshape(-1, 3)
        return np.array(points).reshape(-1, 3), corners, seconds
    finally:
        gmsh.finalize()


PEERS = {
    "pymeshlab": pymeshlab_, "gpytoolbox": gpytoolbox_, "MMGS": mmgs, "CGAL": cgal, "pyacvd": pyacvd_, "Gmsh": gmsh_,
}


def judged(points, triangles, part, features, work):
    """What `mindeg verify --surface` says of a mesh."""
    path = work / "judged.obj"
    write_obj(path, points, triangles)
    command = [MINDEG, "verify", path, "--surface", part, "--tolerance", "100%", "--json", "-q"]
    result, _ = run([*command, "--feature-angle", FEATURE] if features else command)
    found = json.loads(result.stdout)
    diagonal = found["diagonal"]
    share = lambda distance: 100 * distance["at_least"] / diagonal if distance else 0.0
    degrees = [found[key] for key in ("interior_degree", "boundary_degree") if found[key]]
    a, b, c = (np.asarray(points)[np.asarray(triangles)[:, i]] for i in range(3))

    def angle(p, q, r):
        u, v = q - p, r - p
        return np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1)))

    least = np.minimum(np.minimum(angle(a, b, c), angle(b, c, a)), angle(c, a, b))
    return {
        "vertices": found["vertices"],
        "outside": len(found["violations"]),
        "proven": len(found["certified"]),
        "least": min(low for low, _ in degrees),
        "most": max(high for _, high in degrees),
        "angle": found["min_angle"],
        "below": int((least < 30).sum()),
        "there": share(found["to_part"]),
        "back": share(found["from_part"]),
        "features": share(found["features_from_part"]),
        "crossings": found["crossings"],
    }


def at_count(peer, part, features, wanted, size, work):
    """The mesh of a peer with nearly so many vertices, by up to four trials of its edge length."""
    best = None
    for _ in range(4):
        points, triangles, seconds = peer(part, features, size, work)
        used = len(np.unique(triangles))
        if used == 0:
            raise RuntimeError("no triangle")
        off = abs(used / wanted - 1)
        if best is None or off < best[0]:
            best = off, points, triangles, seconds
        if off < 0.03:
            break
        size *= math.sqrt(used / wanted)
    return best[1:]


def cases(work):
    for name, make in parts.PARTS.items():
        stl = work / f"{name.replace(' ', '-')}.stl"
        parts.write_stl(make, stl)
        obj = stl.with_suffix(".obj")
        result, _ = run([MINDEG, "convert", stl, "-o", obj, "-q"])
        assert result.returncode == 0, result.stderr
        # Triangles of an STL share no point: equal ones become one, for the programs that do not weld.
        points, triangles = read_obj(obj)
        points, same = np.unique(points, axis=0, return_inverse=True)
        write_obj(obj, points, same.reshape(-1)[triangles])
        yield name, True, obj
    for name, features in SHIPPED.items():
        obj = work / f"{name}.obj"
        write_obj(obj, *read_off(MODELS / f"{name}.off"))
        yield name, features, obj


def main():
    work = Path(tempfile.mkdtemp(prefix="mindeg-surfaces-"))
    wanted = sys.argv[1:]
    rows = []
    for name, features, part in cases(work):
        if wanted and name not in wanted:
            continue
        try:
            points, triangles, seconds, answer = mindeg(part, features, name in parts.PARTS, work)
        except RuntimeError as error:
            print(f"{name}: {error}", file=sys.stderr)
            continue
        size, count = answer["size"], answer["vertices"]
        rows.append((name, features, "mindeg", judged(points, triangles, part, features, work), seconds))
        print(rows[-1], flush=True)
        for peer, call in PEERS.items():
            try:
                points, triangles, seconds = at_count(call, part, features, count, size, work)
                rows.append((name, features, peer, judged(points, triangles, part, features, work), seconds))
            except Exception as error:
                print(f"{name}, {peer}: {error}", file=sys.stderr)
                rows.append((name, features, peer, None, 0.0))
            print(rows[-1], flush=True)
    text = table(rows)
    print(text)
    if not wanted:
        write_section("surfaces", text)


def table(rows):
    lines = []
    for title, of_kind in [("With features from 40°", True), ("Without", False)]:
        own = [row for row in rows if row[1] == of_kind]
        names = list(dict.fromkeys(row[0] for row in own))
        if not names:
            continue
        lines += [
            f"{title}: {', '.join(names)}.",
            "",
            "| program | meshes | vertices | out of range | degrees | minimum angle, worst | triangles below 30° "
            "| mesh to part, worst | part to mesh, worst | sharp edges, worst | crossings | CPU s |",
            "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|",
        ]
        for program in ["mindeg", *PEERS]:
            found = [row for row in own if row[2] == program and row[3]]
            if not found:
                lines.append(f"| {program} | 0 |  |  |  |  |  |  |  |  |  |  |")
                continue
            of = lambda key: [row[3][key] for row in found]
            lines.append(
                f"| {program} | {len(found)} | {sum(of('vertices')):,} | {sum(of('outside')):,} "
                f"| {min(of('least'))}..{max(of('most'))} | {min(of('angle')):.1f}° | {sum(of('below')):,} "
                f"| {max(of('there')):.2f} % | {max(of('back')):.2f} % "
                f"| {f'''{max(of('features')):.2f} %''' if of_kind else '–'} | {sum(of('crossings')):,} "
                f"| {sum(row[4] for row in found):.1f} |"
            )
        lines.append("")
    lines += [
        "| model | vertices | out of range: " + ", ".join(["mindeg", *PEERS]) + " | minimum angle: the same | CPU s of mindeg |",
        "|---|--:|---|---|--:|",
    ]
    for name in dict.fromkeys(row[0] for row in rows):
        own = {row[2]: row for row in rows if row[0] == name}
        each = lambda text: ", ".join(text(own[p][3]) if own[p][3] else "–" for p in ["mindeg", *PEERS])
        lines.append(
            f"| {name} | {own['mindeg'][3]['vertices']:,} | {each(lambda f: str(f['outside']))} "
            f"| {each(lambda f: f'''{f['angle']:.0f}°''')} | {own['mindeg'][4]:.1f} |"
        )
    packages = ["pymeshlab", "gpytoolbox", "pymmg", "compas-cgal", "pyacvd", "gmsh", "cadquery-ocp-novtk"]
    lines += ["", "Packages: " + ", ".join(f"{name} {version(name)}" for name in packages) + ".", ""]
    return "\n".join(lines)


def write_section(name, text, page="benches/results/surfaces.md"):
    """Replaces the text between two marks of a page."""
    page = ROOT / page
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->"
    content = page.read_text()
    head, rest = content.split(begin)
    page.write_text(head + begin + text + end + rest.split(end)[1])


if __name__ == "__main__":
    main()
