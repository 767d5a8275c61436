"""The extension's operators in Blender without a window, beside Blender's own fills."""

import importlib.util
import math
import os
import subprocess
import sys
import time
import types
from pathlib import Path

import bpy  # Before bmesh, which it brings.
import bmesh
import pytest
from mathutils import Vector

EXTENSION = Path(__file__).resolve().parents[2] / "blender"


def loaded():
    """The extension, as Blender would load it."""
    spec = importlib.util.spec_from_file_location(
        "mindeg_extension", EXTENSION / "__init__.py", submodule_search_locations=[str(EXTENSION)]
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules["mindeg_extension"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session", autouse=True)
def extension():
    module = loaded()
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


def mapped(thing):
    """Gives its faces UVs, their places, and the second material."""
    bm = bmesh.from_edit_mesh(thing.data)
    uv = bm.loops.layers.uv.new("map")
    for face in bm.faces:
        face.material_index = 1
        for corner in face.loops:
            corner[uv].uv = corner.vert.co.xy
    return bm


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
    assert bpy.ops.mesh.mindeg_fill(keep_angle=0) == {"FINISHED"}
    degree, faces, area, _ = measured(thing)
    assert (degree, faces) == (ours, len(points) - 2)

    theirs = edit(points, edges)
    bpy.ops.mesh.fill()
    assert measured(theirs)[0] > ours
    assert area == pytest.approx(measured(theirs)[2], rel=1e-5)


def test_an_n_gon_is_retriangulated_in_place():
    points = rectangle()
    thing = edit(points, faces=[range(len(points))])
    assert bpy.ops.mesh.mindeg_fill(keep_angle=0) == {"FINISHED"}
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
    assert bpy.ops.mesh.mindeg_fill(max_degree=6) == {"FINISHED"}
    degree, faces, _, _ = measured(thing)
    assert faces == 18 and degree <= 6
    thing = edit(saddle, faces=[range(20)])
    assert bpy.ops.mesh.mindeg_fill(interior=True) == {"FINISHED"}
    _, faces, _, bm = measured(thing)
    assert faces > 60 and len(bm.verts) > 20
    assert_few_edges_inside(bm)


def assert_few_edges_inside(bm):
    """5 to 7 edges at every vertex off the boundary that only triangles meet, no needle, no face across another's edge."""
    for vertex in bm.verts:
        if not vertex.is_boundary and all(len(face.verts) == 3 for face in vertex.link_faces):
            assert 5 <= len(vertex.link_edges) <= 7
    assert all(edge.is_boundary or edge.is_contiguous for edge in bm.edges)
    least = min(math.degrees(corner.calc_angle()) for face in bm.faces if len(face.verts) == 3 for corner in face.loops)
    assert least > 25, least


@pytest.mark.parametrize("is_beside_faces", [False, True])
def test_a_bent_loop_gets_points_inside(is_beside_faces):
    rim = circle(24, wave=0.3)
    if is_beside_faces:
        # A collar of quads, which the filling goes on from.
        outer = [(1.3 * x, 1.3 * y, 1.69 * z) for x, y, z in rim]
        thing = edit(rim + outer, faces=[(i, 24 + i, 24 + (i + 1) % 24, (i + 1) % 24) for i in range(24)])
        bm = mapped(thing)
        bpy.ops.mesh.select_all(action="DESELECT")
        for edge in bm.edges:
            edge.select = all(vertex.index < 24 for vertex in edge.verts)
    else:
        thing = edit(rim, ring_edges(24))
    assert bpy.ops.mesh.mindeg_fill(interior=True) == {"FINISHED"}
    _, _, _, bm = measured(thing)
    inside = [vertex for vertex in bm.verts if not vertex.is_boundary and all(len(face.verts) == 3 for face in vertex.link_faces)]
    assert len(inside) > 20
    assert_few_edges_inside(bm)
    # A saddle: x² - y² times 0.3.
    assert all(abs(v.co.z - 0.3 * (v.co.x**2 - v.co.y**2)) < 0.06 for v in inside)
    if is_beside_faces:
        uv = bm.loops.layers.uv["map"]
        assert all(face.material_index == 1 for face in bm.faces)
        assert max((Vector(corner[uv].uv) - corner.vert.co.xy).length for face in bm.faces for corner in face.loops) < 0.1


def test_loops_far_apart_are_bridged_with_points_between():
    rings = [circle(16, height=height) for height in (0, 0.4, 5, 5.4)]
    quads = [(16 * k + i, 16 * k + (i + 1) % 16, 16 * (k + 1) + (i + 1) % 16, 16 * (k + 1) + i) for k in (0, 2) for i in range(16)]
    thing = edit([point for ring in rings for point in ring], faces=quads)
    bm = bmesh.from_edit_mesh(thing.data)
    bpy.ops.mesh.select_all(action="DESELECT")
    for edge in bm.edges:
        edge.select = edge.is_boundary and all(0.3 < vertex.co.z < 5.2 for vertex in edge.verts)
    assert bpy.ops.mesh.mindeg_bridge(interior=True) == {"FINISHED"}
    _, _, _, bm = measured(thing)
    assert len(bm.verts) > 64 + 100
    assert_few_edges_inside(bm)
    assert all(0.9 < vertex.co.xy.length < 1.1 for vertex in bm.verts)
    assert sum(edge.is_boundary for edge in bm.edges) == 32


def test_a_bent_loop_that_would_fold_says_so_and_has_no_points(capfd):
    """A cone under a rim that waves: what goes on from it comes back through it."""
    rim = [(x, y, 0.3 * math.sin(6 * math.atan2(y, x))) for x, y, _ in circle(24)]
    thing = edit([*rim, (0, 0, -1)], faces=[(i, (i + 1) % 24, 24) for i in range(24)])
    assert bpy.ops.mesh.mindeg_fill(interior=True) == {"FINISHED"}
    # Blender prints its reports.
    words = capfd.readouterr().out
    assert "no points inside: with points inside, it would fold" in words, words
    assert len(measured(thing)[3].verts) == 25


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


def min_angle(thing):
    bm = bmesh.from_edit_mesh(thing.data)
    angles = [corner.calc_angle() for face in bm.faces for corner in face.loops]
    return math.degrees(min(angles))


@pytest.mark.parametrize("rings", [[circle(32, radius=4), circle(12, radius=1.5)], [circle(32)], [rectangle()]], ids=["annulus", "circle", "rectangle"])
def test_the_default_has_blenders_angle_or_nearly_so_at_no_larger_degree(rings):
    points = [point for ring in rings for point in ring]
    edges, first = [], 0
    for ring in rings:
        edges += ring_edges(len(ring), first)
        first += len(ring)
    ours = edit(points, edges)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    degree, angle = measured(ours)[0], min_angle(ours)
    theirs = edit(points, edges)
    bpy.ops.mesh.fill()
    assert degree <= measured(theirs)[0]
    assert angle >= 0.95 * min_angle(theirs)


def painted(thing):
    """UVs and colors by position, two materials and a smooth face; gives what each corner has, by material and position."""
    bm = bmesh.from_edit_mesh(thing.data)
    uv = bm.loops.layers.uv.new("map")
    color = bm.loops.layers.float_color.new("paint")
    for index, face in enumerate(bm.faces):
        face.material_index, face.smooth = index % 2, bool(index % 2)
        for corner in face.loops:
            x, y, _ = corner.vert.co
            corner[uv].uv = (x / 8 + index, y / 8)
            corner[color] = (0.5 + x / 8, 0.5 + y / 8, index / 8, 1)
    return corners(bm)


def corners(bm):
    uv, color = bm.loops.layers.uv["map"], bm.loops.layers.float_color["paint"]
    return {
        (face.material_index, face.smooth, tuple(corner.vert.co), tuple(corner[uv].uv), tuple(corner[color]))
        for face in bm.faces
        for corner in face.loops
    }


@pytest.mark.parametrize("options", [{}, {"interior": True}])
def test_retriangulated_faces_keep_uvs_colors_and_materials(options):
    thing = edit(circle(42) + [(2, -1, 0), (2, 1, 0)], faces=[range(42), [0, 42, 43, 1]])
    before = painted(thing)
    assert len(before) == 46
    bpy.ops.mesh.select_all(action="SELECT")
    bm = bmesh.from_edit_mesh(thing.data)
    bm.faces.ensure_lookup_table()
    assert bpy.ops.mesh.mindeg_fill(**options) == {"FINISHED"}
    after = corners(bmesh.from_edit_mesh(thing.data))
    assert before <= after
    if not options:
        assert before == after
    # New points lie between those around.
    for material, smooth, (x, y, _), uv, color in after:
        if material == 0:
            assert uv == pytest.approx((x / 8, y / 8), abs=1e-3)
            assert color[:2] == pytest.approx((0.5 + x / 8, 0.5 + y / 8), abs=1e-3) and not smooth


@pytest.mark.parametrize("options", [{}, {"interior": True}])
def test_a_filled_hole_takes_uvs_and_material_from_the_faces_beside(options):
    outer, inner = circle(16, radius=2), circle(16)
    thing = edit(outer + inner, faces=[(i, (i + 1) % 16, 16 + (i + 1) % 16, 16 + i) for i in range(16)])
    mapped(thing)
    assert bpy.ops.mesh.mindeg_fill(**options) == {"FINISHED"}
    bm = bmesh.from_edit_mesh(thing.data)
    uv = bm.loops.layers.uv["map"]
    # The rim of the flat sheet stays open.
    assert sum(face.calc_area() for face in bm.faces) == pytest.approx(8 * math.sin(math.pi / 8) * 4, rel=1e-5)
    for face in bm.faces:
        assert face.material_index == 1
        for corner in face.loops:
            assert tuple(corner[uv].uv) == pytest.approx(tuple(corner.vert.co.xy), abs=1e-3)
    assert all(edge.is_boundary or edge.is_contiguous for edge in bm.edges)


def open_tube(tubes=3, count=12):
    """Tubes beside each other without ends."""
    points, faces = [], []
    for tube in range(tubes):
        first = len(points)
        for height in (0, 1):
            points += [(x + 4 * tube, y, z) for x, y, z in circle(count, height=height)]
        faces += [
            (first + i, first + (i + 1) % count, first + count + (i + 1) % count, first + count + i) for i in range(count)
        ]
    return points, faces


def test_with_all_selected_the_holes_are_filled_and_the_quads_stay():
    points, quads = open_tube()
    thing = edit(points, faces=quads)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    _, faces, _, bm = measured(thing)
    assert sum(len(face.verts) == 4 for face in bm.faces) == 36
    assert faces == 36 + 6 * 10
    assert all(edge.is_manifold and edge.is_contiguous for edge in bm.edges)


def test_one_sentence_tells_how_many(extension):
    loops = extension.operators.loops
    patches = []
    for x in range(3):
        points = [(px + 4 * x, py, pz) for px, py, pz in circle(12)]
        patches.append(loops.Patch(list(range(12 * x, 12 * x + 12)), [points]))
    loops.fill_all(patches, [], keep_angle=0.95)
    said = loops.said(patches, "hole")
    assert said == "Filled 3 holes with 30 triangles: degree at most 4, minimum angle 15.000°"
    assert [loops.angle(degrees) for degrees in (0, 0.0847149, 0.00001, 0.1, 26.56505)] == ["0°", "0.08471°", "0.00001°", "0.100°", "26.565°"]
    patches[1].fault = "it is too large"
    assert loops.said(patches, "hole").endswith("; 1 hole stays as it is: it is too large")
    assert loops.said(patches[:1], "face") == "Made 10 triangles of 1 face: degree 4 (least possible 4), minimum angle 15.000°"


def test_a_flat_sheet_is_not_closed_by_a_second_one():
    # Quads, all selected, no hole: they are retriangulated.
    grid = [(x, y, 0) for y in range(4) for x in range(4)]
    quads = [(x + 4 * y, x + 1 + 4 * y, x + 5 + 4 * y, x + 4 + 4 * y) for y in range(3) for x in range(3)]
    thing = edit(grid, faces=quads)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    _, faces, area, _ = measured(thing)
    assert (faces, area) == (18, pytest.approx(9))
    # Now there is nothing left to do.
    bpy.ops.mesh.select_all(action="SELECT")
    with pytest.raises(RuntimeError, match="the rim of a flat sheet stays open"):
        bpy.ops.mesh.mindeg_fill()


def test_holes_that_touch_are_both_filled():
    # A grid of 4 by 4 quads without two that share a corner; the far ones are bent up, so that it is no flat sheet.
    grid = [(x, y, 0.2 * max(0, x - 3)) for y in range(5) for x in range(5)]
    quads = [
        (x + 5 * y, x + 1 + 5 * y, x + 6 + 5 * y, x + 5 + 5 * y)
        for y in range(4)
        for x in range(4)
        if (x, y) not in ((1, 1), (2, 2))
    ]
    thing = edit(grid, faces=quads)
    bm = bmesh.from_edit_mesh(thing.data)
    bpy.ops.mesh.select_all(action="DESELECT")
    for edge in bm.edges:
        edge.select = edge.is_boundary and all(0 < vertex.co.x < 4 and 0 < vertex.co.y < 4 for vertex in edge.verts)
    assert bpy.ops.mesh.mindeg_fill() == {"FINISHED"}
    _, faces, _, bm = measured(thing)
    assert faces == 14 + 4 and sum(edge.is_boundary for edge in bm.edges) == 16


def test_long_work_tells_how_far_it_is_and_ends_when_cancelled(extension):
    working, mindeg = extension.operators.working, extension.operators.mindeg
    quick = working.Work(lambda: 7)
    assert quick.is_over(wait=10) and quick.result() == 7

    def fails():
        raise ValueError("no")

    failed = working.Work(fails)
    assert failed.is_over(wait=10)
    with pytest.raises(ValueError, match="no"):
        failed.result()

    loop = circle(900, wave=0.3)
    long = working.Work(lambda: mindeg.fill_loop(loop, max_degree=6))
    assert not long.is_over(wait=0.5)
    began = time.monotonic()
    long.cancel()
    assert long.is_over(wait=30) and long.result() is None
    assert time.monotonic() - began < 20
    assert long.words.startswith("mindeg: "), long.words


INSTALL = """
import sys
import bpy
bpy.ops.extensions.package_install_files(filepath=sys.argv[1], repo="user_default", enable_on_install=True)
print("enabled", [name for name in bpy.context.preferences.addons.keys() if name.endswith(".mindeg")])
print("registered", hasattr(bpy.types, "MESH_OT_mindeg_fill"))
"""


def test_a_shell_that_is_told_to_build_lets_python_do_it():
    told = subprocess.run(["bash", EXTENSION / "build"], capture_output=True, text=True)
    assert told.stderr.startswith("usage: ") and told.stderr.count("\n") == 1, told.stderr


def test_the_zip_is_installed_with_its_wheel(tmp_path):
    path = os.environ.get("MINDEG_EXTENSION")
    if not path:
        pytest.skip("tests/blender/run builds the zip")
    # In a Blender of its own: here the operators are registered already.
    run = subprocess.run(
        [sys.executable, "-c", INSTALL, path],
        env={**os.environ, "BLENDER_USER_RESOURCES": str(tmp_path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "enabled ['bl_ext.user_default.mindeg']" in run.stdout and "registered True" in run.stdout, run.stdout
    assert list(tmp_path.glob("extensions/.local/lib/python3*/site-packages/mindeg/_mindeg*"))


def test_a_menu_waits_without_a_frozen_window_and_esc_leaves_the_mesh(extension):
    """The steps that Blender takes with a window, which this Blender has not."""
    thing = edit(circle(900, wave=0.3), ring_edges(900))
    told = []

    class FromMenu(extension.operators._LongWork):
        interior, max_degree, keep_angle = False, 6, 0.95
        plan = extension.operators.MESH_OT_mindeg_fill.plan

        def report(self, kind, words):
            told.append((kind, words))

    space = types.SimpleNamespace
    shown, timers = [], []
    context = space(
        edit_object=thing,
        window=None,
        workspace=space(status_text_set=shown.append),
        window_manager=space(
            event_timer_add=lambda *_, **__: timers.append(1) or "timer",
            event_timer_remove=lambda timer: timers.remove(1),
            modal_handler_add=lambda operator: None,
        ),
    )
    operator = FromMenu()
    assert operator.invoke(context, None) == {"RUNNING_MODAL"} and timers == [1]
    assert operator.modal(context, space(type="TIMER")) == {"RUNNING_MODAL"} and "Esc cancels" in shown[-1]
    ended = operator.modal(context, space(type="ESC"))
    deadline = time.monotonic() + 60
    while ended == {"RUNNING_MODAL"} and time.monotonic() < deadline:
        time.sleep(0.05)
        ended = operator.modal(context, space(type="TIMER"))
    assert ended == {"CANCELLED"} and timers == [] and shown[-1] is None
    assert told == [({"INFO"}, "Cancelled; the mesh is as it was")] and measured(thing)[1] == 0
    # What is over at once needs no bar.
    context.edit_object = small = edit(circle(12), ring_edges(12))
    assert operator.invoke(context, None) == {"FINISHED"} and timers == []
    assert measured(small)[1] == 10 and told[-1][1].startswith("Filled 1 hole with 10 triangles: ")


def test_a_remesh_has_few_poles_and_keeps_shape_materials_and_uvs():
    bpy.ops.object.mode_set(mode="OBJECT") if bpy.context.mode != "OBJECT" else None
    bpy.ops.mesh.primitive_cube_add(size=2)
    thing = bpy.context.object
    bpy.ops.object.mode_set(mode="EDIT")
    bm = bmesh.from_edit_mesh(thing.data)
    uv = bm.loops.layers.uv.verify()
    for face in bm.faces:
        face.material_index = int(face.normal.z > 0.5)
        for corner in face.loops:
            corner[uv].uv = corner.vert.co.xy
    bmesh.update_edit_mesh(thing.data)
    assert bpy.ops.mesh.mindeg_remesh(size=0.4) == {"FINISHED"}
    degree, faces, area, bm = measured(thing)
    assert faces > 300 and area == pytest.approx(24, rel=1e-4)
    assert degree <= 7 and min(len(vertex.link_edges) for vertex in bm.verts) >= 5
    assert all(edge.is_manifold for edge in bm.edges)
    uv = bm.loops.layers.uv.verify()
    for face in bm.faces:
        assert face.material_index == int(face.normal.z > 0.5)
        if abs(face.normal.z) > 0.5:
            for corner in face.loops:
                assert tuple(corner[uv].uv) == pytest.approx(tuple(corner.vert.co.xy), abs=1e-3)
    edit([(0, 0, 0), (1, 0, 0)], [(0, 1)])
    with pytest.raises(RuntimeError, match="the mesh has no face"):
        bpy.ops.mesh.mindeg_remesh()
