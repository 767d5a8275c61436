"""What every viewer must see in a file, given the program's report and the domain's outline.

Each function yields one check at a time: a name, what was expected, what was seen, and
whether that passes. A check named "note" is printed and counts as neither.
"""

import math

# Single precision keeps seven digits; two are left for what is summed up from them.
RELATIVE_TOLERANCE = 1e-5
# In degrees, before the rounding of the coordinates themselves is added.
ANGLE_TOLERANCE = 0.01
STEPS_TO_TELL_A_SHAPE = 10


def check_report(report, outline, outputs):
    """What the program says of the mesh, and that it wrote the files it was asked for."""
    vertices, triangles = report["vertices"], report["triangles"]
    # A polygon has two triangles fewer than vertices, each hole adds two, and so does a vertex inside.
    inside = report.get("interior_points", 0)
    expected = vertices - 2 + 2 * outline.holes + inside
    yield equal("triangles reported", expected, triangles)
    yield equal("vertices reported", sum(report["intervals"]) + inside, vertices)
    # With points inside no degree is known to be the least.
    if report.get("least_max_degree") is not None:
        least, seen = report["least_max_degree"], report["max_degree"]
        yield "max_degree reported", f"at least the optimum {least}", seen, seen >= least
    # A .gltf has a .bin beside it.
    binaries = sum(str(file).endswith(".bin") for file in report["files"])
    documents = sum(str(file).endswith(".gltf") for file in report["files"])
    yield equal("binaries reported", documents, binaries)
    yield equal("files reported", len(outputs), len(report["files"]) - binaries)


def check_mesh(reading, report, outline):
    """What MeshLab and Blender see."""
    yield equal("meshes", 1, reading["meshes"])
    yield equal("vertices", report["vertices"], reading["vertices"])
    yield equal("faces", report["triangles"], reading["faces"])
    yield equal("non-manifold edges", 0, reading["non_manifold_edges"])
    yield equal("boundary edges", sum(report["intervals"]), reading["boundary_edges"])
    yield equal("connected components", 1, reading["components"])
    yield equal("maximum degree", max_degree(report), reading["max_degree"])
    yield check_bounds(reading, outline)
    yield from check_shape(reading, report, outline)


def max_degree(report):
    """A mesh with interior points reports the smallest and the largest degree, inside and around."""
    if "max_degree" in report:
        return report["max_degree"]
    return max(report["interior_degree"][1], report["boundary_degree"][1])


def check_extras(reading, line_segments, has_colors):
    """What a file holds on request only, where the viewer tells of it."""
    if "line_segments" in reading:
        yield equal("line segments", line_segments, reading["line_segments"])
    if "has_colors" in reading:
        yield equal("vertex colors", has_colors, reading["has_colors"])


def check_bounds(reading, outline):
    """Where the mesh stands, in the domain's own coordinates."""
    tolerance = RELATIVE_TOLERANCE * outline.extent + reading["place_step"]
    expected, seen = [[*low, *high] for low, high in (outline.bounds, reading["bounds"])]
    passed = all(abs(e - s) <= tolerance for e, s in zip(expected, seen))
    return "bounds", f"{show(expected)} within {tolerance:.3g}", show(seen), passed


def check_shape(reading, report, outline):
    """Area, orientation and angles: what is left of them after the viewer's rounding."""
    step, shortest = reading["shape_step"], reading["shortest_edge"]
    # No triangle is lower than this. Where it is but a few steps, rounding alone flattens
    # triangles or turns them over.
    lowest = shortest * math.sin(math.radians(report["min_angle"]))
    if step * STEPS_TO_TELL_A_SHAPE > lowest:
        reason = f"coordinates are rounded to steps of {step:g}, too coarse for these triangles"
        yield "note", "", f"only the topology and the bounds are compared: {reason}", True
        return
    # Moving the whole outline outwards by a step changes the area by about this much.
    tolerance = max(RELATIVE_TOLERANCE * outline.area, step * outline.perimeter)
    yield close("area", outline.area, reading["area"], tolerance)
    yield equal("faces turned away", 0, reading["faces_turned_away"])
    # Moving both ends of an edge by a step turns it by at most this.
    tolerance = ANGLE_TOLERANCE + math.degrees(4 * step / shortest)
    for name in ("min_angle", "max_angle"):
        yield close(name, report[name], reading[name], tolerance)


def check_validation(reading, report, outline):
    """What the Khronos validator says."""
    for remark in reading["remarks"]:
        yield "note", "", remark, True
    for severity in ("errors", "warnings"):
        found = reading[severity]
        yield severity, 0, " ".join([str(len(found)), *found]), not found
    # It counts the vertices again for each line, which shares them with the surface.
    yield equal("vertices", report["vertices"] * reading["primitives"], reading["vertices"])
    yield equal("faces", report["triangles"], reading["faces"])


def equal(name, expected, seen):
    return name, expected, seen, expected == seen


def close(name, expected, seen, tolerance):
    passed = abs(expected - seen) <= tolerance
    return name, f"{expected:.9g} within {tolerance:.3g}", f"{seen:.9g}", passed


def show(numbers):
    return "(" + ", ".join(f"{number:.9g}" for number in numbers) + ")"
