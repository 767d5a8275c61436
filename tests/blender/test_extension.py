"""The extension's operators in Blender without a window, beside Blender's own fills."""

import importlib.util
import math
import sys
from pathlib import Path

import bpy  # Before bmesh, which it brings.
import bmesh
import pytest

EXTENSION = Path(__file__).resolve().parents[2] / "blender"


@pytest.fixture(scope="session", autouse=True)
def extension():
    spec = importlib.util.spec_from_file_location(
        "mindeg_extension", EXTENSION / "__init__.py", submodule_search_locations=[str(EXTENSION)]
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules["mindeg_extension"] = module
    spec.loader.exec_module(module)
    module.register()
    yield module
    module.unregister()


def edit(vertices, edges=(), faces=()):
    """A mesh in edit mode, all of it selected."""
    if bpy.context.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    mesh = bpy.data.meshes.new("test")
    mesh.from_pydata(vertices, list(edges), list(faces))
    thing = bpy.data.objects.new("test", mesh)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    return thing


def measured(thing):
    bm = bmesh.from_edit_mesh(thing.data)
    degree = max(len(vertex.link_edges) for vertex in bm.verts)
    area = sum(face.calc_area() for face in bm.faces)
    return degree, len(bm.faces), area, bm


def ring_edges(count, first=0):
    return [(first + i, first + (i + 1) % count) for i in range(count)]


def rectangle():
    """12, 9, 4 and 4 intervals on a rectangle of 4 by 3."""
    corners = [(0, 0), (4, 0), (4, 3), (0, 3)]
    points = []
    for side, count in enumerate((12, 9, 4, 4)):
        (ax, ay), (bx, by) = corners[side], corners[(side + 1) % 4]
        points += [(ax + (bx - ax) * i / count, ay + (by - ay) * i / count, 0) for i in range(count)]
    return points


def circle(count, height=0.0, radius=1.0, wave=0.0):
    angles = [2 * math.pi * i / count for i in range(count)]
    return [(radius * math.cos(a), radius * math.sin(a), height + wave * math.cos(2 * a)) for a in angles]


@pytest.mark.parametrize(("points", "ours"), [(rectangle(), 5), (circle(32), 4)])
def test_filling_a_loop_has_fewer_edges_at_a_vertex_than_blenders_fill(points, ours):
    edges = ring_edges(len(points))
    thing = edit(points, edges)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    degree, faces, area, _ = measured(thing)
    assert (degree, faces) == (ours, len(points) - 2)

    theirs = edit(points, edges)
    bpy.ops.mesh.fill(use_beauty=False)
    assert measured(theirs)[0] > ours
    assert area == pytest.approx(measured(theirs)[2], rel=1e-5)


def test_an_n_gon_is_retriangulated_in_place():
    points = rectangle()
    thing = edit(points, faces=[range(len(points))])
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    degree, faces, area, bm = measured(thing)
    assert (degree, faces) == (5, 27)
    assert area == pytest.approx(12, rel=1e-6)
    assert all(face.normal.z > 0.99 for face in bm.faces)


def test_interior_points_are_added_on_request():
    thing = edit(circle(32), ring_edges(32))
    assert bpy.ops.mesh.mindeg_fill(interior=True) == {"FINISHED"}
    degree, _, _, bm = measured(thing)
    assert len(bm.verts) > 32 and degree <= 7


def test_loops_inside_others_are_holes():
    # An island in the hole is a piece of its own, and a loop of another plane is no hole.
    rings = [circle(32, radius=4), circle(16, radius=2), circle(8), circle(8, height=1)]
    edges, first = [], 0
    for ring in rings:
        edges += ring_edges(len(ring), first)
        first += len(ring)
    thing = edit([point for ring in rings for point in ring], edges)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    _, faces, area, bm = measured(thing)
    # A polygon with h holes has n + 2 h - 2 triangles.
    assert faces == (32 + 16 + 2 - 2) + (8 - 2) + (8 - 2)
    disk = lambda count, radius: count / 2 * math.sin(2 * math.pi / count) * radius**2
    assert area == pytest.approx(disk(32, 4) - disk(16, 2) + 2 * disk(8, 1), rel=1e-5)
    assert all(edge.is_boundary or edge.is_contiguous for edge in bm.edges)


@pytest.mark.parametrize("options", [{}, {"max_degree": 6}, {"keep_angle": 0.95}, {"interior": True}])
def test_every_option_fills_a_hole_beside_faces(options):
    # A square frame of quads around a square hole of 8 vertices: two edges of the frame at each outside.
    side = [-2, -1, 0, 1, 2]
    points = [(x, y, 0) for y in side for x in side if not x == y == 0]
    at = {point[:2]: place for place, point in enumerate(points)}
    quads = [
        [at[corner] for corner in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1))]
        for y in side[:-1]
        for x in side[:-1]
        if not (-1 <= x < 1 and -1 <= y < 1)
    ]
    thing = edit(points, faces=quads)
    bm = bmesh.from_edit_mesh(thing.data)
    bpy.ops.mesh.select_all(action="DESELECT")
    for edge in bm.edges:
        edge.select = edge.is_boundary and all(max(map(abs, vertex.co)) < 1.5 for vertex in edge.verts)
    assert bpy.ops.mesh.mindeg_fill(**options) == {"FINISHED"}
    degree, _, area, bm = measured(thing)
    assert area == pytest.approx(16)
    assert all(edge.is_boundary or edge.is_contiguous for edge in bm.edges)
    if "max_degree" in options:
        assert degree <= 6
    # Each angle is 45 or 90 degrees without a point inside, so none is added.
    assert len(bm.verts) == 24


def test_the_edges_beside_a_hole_count():
    # Of 8 points alone, triangles with degree 4 exist; with an edge out from each of them, none.
    frame = [(x, y, 0) for x, y in [(-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0)]]
    edit(frame, ring_edges(8))
    assert bpy.ops.mesh.mindeg_fill(max_degree=4) == {"FINISHED"}
    outer = [(2 * x, 2 * y, 0) for x, y, _ in frame]
    quads = [(8 + i, 8 + (i + 1) % 8, (i + 1) % 8, i) for i in range(8)]
    thing = edit(frame + outer, faces=quads)
    bm = bmesh.from_edit_mesh(thing.data)
    bpy.ops.mesh.select_all(action="DESELECT")
    for edge in bm.edges:
        edge.select = all(vertex.index < 8 for vertex in edge.verts)
    with pytest.raises(RuntimeError, match="the least is 5"):
        bpy.ops.mesh.mindeg_fill(max_degree=4)
    assert bpy.ops.mesh.mindeg_fill(max_degree=5) == {"FINISHED"}
    assert measured(thing)[0] == 5


def test_an_n_gon_off_its_plane_is_filled_as_a_loop_in_space():
    saddle = circle(20, wave=0.3)
    thing = edit(saddle, faces=[range(20)])
    with pytest.raises(RuntimeError, match="off its plane; keep_angle needs a planar loop"):
        bpy.ops.mesh.mindeg_fill(keep_angle=0.9)
    assert measured(thing)[1] == 1
    assert bpy.ops.mesh.mindeg_fill(max_degree=6) == {"FINISHED"}
    degree, faces, _, _ = measured(thing)
    assert faces == 18 and degree <= 6


def test_a_bridge_keeps_a_limit_or_says_what_is_possible():
    edges = ring_edges(12) + ring_edges(5, 12)
    thing = edit(circle(12, height=1) + circle(5), edges)
    with pytest.raises(RuntimeError, match="6"):
        bpy.ops.mesh.mindeg_bridge(max_degree=5)
    assert bpy.ops.mesh.mindeg_bridge(max_degree=7) == {"FINISHED"}
    assert measured(thing)[0] <= 7


def test_a_loop_in_space_is_filled_within_the_limit_and_agrees_with_the_faces_beside_it():
    # A tube without its lower end: the rim is bent.
    top, rim = circle(24, height=2), circle(24, wave=0.4)
    sides = [(i, 24 + i, 24 + (i + 1) % 24, (i + 1) % 24) for i in range(24)]
    thing = edit(top + rim, faces=[*sides, range(24)])
    bpy.ops.mesh.select_all(action="DESELECT")
    bm = bmesh.from_edit_mesh(thing.data)
    for edge in bm.edges:
        edge.select = edge.is_boundary
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    _, _, _, bm = measured(thing)
    assert all(edge.is_manifold and edge.is_contiguous for edge in bm.edges)
    assert max(len(vertex.link_edges) for vertex in bm.verts) <= 6


def test_loops_of_unequal_counts_are_bridged():
    thing = edit(circle(12, height=1) + circle(5), ring_edges(12) + ring_edges(5, 12))
    assert bpy.ops.mesh.mindeg_bridge() == {"FINISHED"}
    degree, faces, _, bm = measured(thing)
    assert (degree, faces) == (6, 17)
    assert all(edge.is_contiguous for edge in bm.edges if len(edge.link_faces) == 2)


def test_poles_are_selected():
    fan = [(0, 0, 0), *circle(8)]
    thing = edit(fan, faces=[(0, i, i % 8 + 1) for i in range(1, 9)])
    assert bpy.ops.mesh.mindeg_select_poles(above=6) == {"FINISHED"}
    bm = bmesh.from_edit_mesh(thing.data)
    assert [vertex.index for vertex in bm.verts if vertex.select] == [0]
    assert bpy.ops.mesh.mindeg_report() == {"FINISHED"}


def test_a_selection_that_is_no_loop_is_refused_in_words():
    edit([(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(0, 1), (1, 2)])
    with pytest.raises(RuntimeError, match="select closed loops"):
        bpy.ops.mesh.mindeg_fill()
