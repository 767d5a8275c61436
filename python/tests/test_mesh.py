"""Meshes: arrays, files, other packages, Ctrl-C."""

import os
import pickle
import signal
import threading
import time

import mindeg
import numpy as np
import pytest


@pytest.fixture
def mesh():
    return mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4], names=["a", "b", "c", "d"]).mesh()


def test_arrays_are_made_once_and_have_the_promised_types(mesh):
    assert mesh.points is mesh.points and mesh.triangles is mesh.triangles
    assert (mesh.points.dtype, mesh.points.shape) == (np.float64, (29, 2))
    assert (mesh.triangles.dtype, mesh.triangles.shape) == (np.uint32, (27, 3))
    assert mesh.degrees.sum() == 2 * (2 * 29 - 3)


def test_lines_are_the_sides(mesh):
    assert [(name, len(segments)) for name, segments in mesh.lines.items()] == [
        ("a", 12),
        ("b", 9),
        ("c", 4),
        ("d", 4),
    ]


def test_a_mesh_survives_pickling(mesh):
    other = pickle.loads(pickle.dumps(mesh))
    assert np.array_equal(other.points, mesh.points)
    assert np.array_equal(other.triangles, mesh.triangles)
    assert list(other.lines) == ["a", "b", "c", "d"]
    assert other.least_max_degree == mesh.least_max_degree


def test_pickling_keeps_groups_materials_depths_and_kinds(tmp_path):
    """What only some files have: written again, they are the same."""
    path, again = tmp_path / "coast.14", tmp_path / "again.14"
    path.write_text(
        "coast\n2 4\n1 0 0 1.5\n2 4 0 2.5\n3 4 3 2\n4 0 3 1\n1 3 1 2 3\n2 3 1 3 4\n"
        "1\n2\n2 0\n1\n2\n1\n4\n4 0\n2\n3\n4\n1\n"
    )
    mesh = mindeg.read(path)
    pickle.loads(pickle.dumps(mesh)).save(again)
    mesh.save(path)
    assert again.read_text() == path.read_text()
    assert " 2.5\n" in again.read_text()
    path, again = tmp_path / "two.obj", tmp_path / "again.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no left\nf 1 2 3\no right\nf 1 3 4\n")
    mesh = mindeg.read(path)
    pickle.loads(pickle.dumps(mesh)).save(again)
    mesh.save(path)
    assert again.read_text() == path.read_text() and "right" in again.read_text()
    painted, one, two = (tmp_path / name for name in ("painted.obj", "one.glb", "two.glb"))
    painted.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n")
    mesh = mindeg.read(painted)
    mesh.save(one)
    pickle.loads(pickle.dumps(mesh)).save(two)
    assert two.read_bytes() == one.read_bytes() and b'"blue"' in two.read_bytes()


@pytest.mark.parametrize("extension", ["obj", "glb", "gltf", "msh", "vtu", "vtk", "ply", "npz"])
def test_every_format_brings_the_triangles_back(mesh, tmp_path, extension):
    path = tmp_path / f"plate.{extension}"
    mesh.save(path)
    other = mindeg.read(path)
    assert np.array_equal(other.triangles, mesh.triangles)
    assert np.allclose(other.points, mesh.points, atol=1e-6)


def test_a_file_is_replaced_whole_or_not_at_all(mesh, tmp_path):
    path = tmp_path / "plate.obj"
    path.write_text("old")
    with pytest.raises(ValueError, match="tells no format"):
        mesh.save(tmp_path / "plate.foo")
    with pytest.raises(FileNotFoundError, match=r"missing/plate\.obj: .*its folder does not exist") as told:
        mesh.save(tmp_path / "missing" / "plate.obj")
    assert ".part" not in str(told.value)
    assert path.read_text() == "old"
    mesh.save(path)
    assert path.read_text().count("\nf ") == 27
    assert os.listdir(tmp_path) == ["plate.obj"]


@pytest.mark.skipif(os.name == "nt", reason="links need rights there")
def test_a_link_is_not_replaced(mesh, tmp_path):
    target, link = tmp_path / "target.obj", tmp_path / "link.obj"
    target.write_text("old")
    link.symlink_to(target)
    with pytest.raises(OSError, match=r"link\.obj: it is a link"):
        mesh.save(link)
    assert link.is_symlink() and target.read_text() == "old"


def test_a_mesh_names_no_file_outside_its_folder(tmp_path):
    inside = tmp_path / "in"
    inside.mkdir()
    (tmp_path / "outside.bin").write_bytes(bytes(36))
    (tmp_path / "outside.mtl").write_text("newmtl steel\nKd 1 0 0\n")
    gltf = inside / "a.gltf"
    gltf.write_text(
        '{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 36, "uri": "../outside.bin"}]}'
    )
    with pytest.raises(ValueError, match="outside.bin"):
        mindeg.read(gltf)
    obj = inside / "a.obj"
    obj.write_text("mtllib ../outside.mtl\nusemtl steel\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    mindeg.read(obj).save(inside / "b.obj")
    assert "Kd 1 0 0" not in "".join(path.read_text() for path in inside.glob("b.*"))


@pytest.mark.skipif(os.name == "nt", reason="pipes have no names there")
def test_what_a_poly_names_is_a_regular_file(tmp_path):
    poly = tmp_path / "a.poly"
    poly.write_text("0 2 0 0\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n")
    os.mkfifo(tmp_path / "a.node")
    with pytest.raises(ValueError, match="it is a pipe or a device"):
        mindeg.Domain(poly)


def test_inspecting_arrays_finds_what_is_wrong():
    points = np.array([[0.0, 0], [2, 0], [2, 2], [0, 2], [1, 1]])
    found = mindeg.inspect(points, [[0, 1, 4], [1, 2, 4], [4, 2, 3], [3, 4, 0]])
    assert found["inconsistent_edges"] == [[0, 4], [3, 4]]
    assert (found["max_degree"], found["euler_characteristic"]) == (4, 1)
    # The keys are those of the command line.
    keys = ["vertices", "faces", "degree_histogram", "metrics", "worst_triangles", "outline", "polygon"]
    assert set(keys) <= set(found)
    assert found["degree_histogram"] == {"boundary": {"3": 4}, "interior": {"4": 1}}
    assert found["metrics"]["min_angle"]["median"] == pytest.approx(45)
    assert mindeg.inspect(points, [[0, 1, 4]], poles_above=1)["poles"][0]["degree"] == 2


def test_the_least_degree_of_an_outline_is_told():
    mesh = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4]).mesh(max_degree=7)
    assert mindeg.inspect(mesh.points, mesh.triangles)["outline"]["least_max_degree"] == 5


@pytest.mark.parametrize("triangles", [[[0, 1, 9]], [[0, 1]], [[0.5, 1, 2]], [[-1, 0, 1]]])
def test_wrong_triangles_are_value_errors(triangles):
    with pytest.raises(ValueError, match="."):
        mindeg.inspect(np.zeros((3, 2)), triangles)


def test_a_notebook_shows_a_picture(mesh):
    assert mesh._repr_svg_().startswith("<svg")


def test_other_packages_take_the_mesh(mesh):
    trimesh = pytest.importorskip("trimesh")
    assert isinstance(mesh.to_trimesh(), trimesh.Trimesh)
    assert mesh.to_trimesh().area == pytest.approx(12)
    pytest.importorskip("meshio")
    assert len(mesh.to_meshio().cells_dict["triangle"]) == 27
    assert set(mesh.to_meshio().cell_sets) == {"a", "b", "c", "d"}


def test_control_c_cancels_work():
    domain = mindeg.rectangle(4, 3, intervals=[900, 900, 900, 900])
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        domain.tradeoff()
    assert time.monotonic() - start < 20


def test_other_threads_run_while_it_works():
    domain = mindeg.rectangle(4, 3, intervals=[200, 200, 200, 200])
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(None)
            time.sleep(0.005)

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        domain.mesh(keep_angle=0.95)
    finally:
        done.set()
        thread.join()
    assert len(ticks) > 3


def test_a_loop_in_space_is_closed_within_a_limit():
    angles = np.linspace(0, 2 * np.pi, 25)[:-1]
    saddle = np.column_stack([np.cos(angles), np.sin(angles), 0.4 * np.cos(2 * angles)])
    triangles, facts = mindeg.fill_loop(saddle)
    degrees = np.bincount(triangles.ravel(), minlength=24) + 1
    assert triangles.shape == (22, 3)
    assert facts["limit"] == 6 and degrees.max() == facts["max_degree"] <= 6
    assert facts["area_without_limit"] <= facts["area"]
    with pytest.raises(ValueError, match="at least 3"):
        mindeg.fill_loop(saddle[:2])
    with pytest.raises(ValueError, match="no such vertex"):
        mindeg.fill_loop(saddle, excluded=[(0, 99)])


def test_loops_of_unequal_counts_are_joined():
    def ring(count, z):
        angles = np.linspace(0, 2 * np.pi, count + 1)[:-1]
        return np.column_stack([np.cos(angles), np.sin(angles), np.full(count, float(z))])

    triangles, facts = mindeg.bridge_loops(ring(12, 1), ring(5, 0))
    assert triangles.shape == (17, 3)
    assert facts["max_degree"] == facts["least_max_degree"] == facts["at_least"] == 2 + 1 + 3
