"""Meshes in the packages that they are converted to: the real ones, with their own figures."""

import meshio
import mindeg
import numpy as np
import pytest
import pyvista
import trimesh


@pytest.fixture(params=["boundary", "interior", "space"])
def mesh(request):
    if request.param == "space":
        # A roof: two rectangles that meet at an angle, which only three coordinates hold.
        points = [[0, 0, 0], [2, 0, 0], [2, 1, 1], [0, 1, 1], [2, 2, 0], [0, 2, 0]]
        triangles = [[0, 1, 2], [0, 2, 3], [3, 2, 4], [3, 4, 5]]
        return mindeg.Mesh(np.array(points, float), triangles, "roof")
    domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4], names=["a", "b", "c", "d"])
    return domain.mesh() if request.param == "boundary" else domain.mesh(interior=True)


def area(mesh):
    return 4 * np.sqrt(2) if mesh.points.shape[1] == 3 else 12


def in_space(mesh):
    return np.pad(mesh.points, ((0, 0), (0, 3 - mesh.points.shape[1])))


def test_pyvista(mesh, tmp_path):
    data = mesh.to_pyvista()
    assert isinstance(data, pyvista.PolyData) and data.is_all_triangles
    assert np.array_equal(data.points, in_space(mesh))
    assert np.array_equal(data.regular_faces, mesh.triangles)
    assert np.array_equal(data.point_data["degree"], mesh.degrees)
    assert data.area == pytest.approx(area(mesh))
    angles = data.cell_quality("min_angle")["min_angle"]
    assert angles.min() == pytest.approx(mesh.min_angle)
    # Without a window.
    plotter = pyvista.Plotter(off_screen=True, window_size=(200, 150))
    plotter.add_mesh(data, scalars="degree", show_edges=True)
    plotter.view_xy()
    picture = plotter.screenshot(tmp_path / "mesh.png", return_img=True)
    plotter.close()
    assert picture.shape == (150, 200, 3) and len(np.unique(picture.reshape(-1, 3), axis=0)) > 3


def test_trimesh(mesh, tmp_path):
    other = mesh.to_trimesh()
    assert isinstance(other, trimesh.Trimesh)
    assert np.array_equal(other.vertices, in_space(mesh))
    assert np.array_equal(other.faces, mesh.triangles)
    assert np.array_equal(other.vertex_attributes["degree"], mesh.degrees)
    assert np.array_equal(np.bincount(other.edges_unique.ravel()), mesh.degrees)
    assert other.area == pytest.approx(area(mesh))
    assert np.degrees(other.face_angles.min()) == pytest.approx(mesh.min_angle)
    assert other.is_winding_consistent
    other.export(tmp_path / "mesh.stl")
    assert len(mindeg.read(tmp_path / "mesh.stl").triangles) == len(mesh.triangles)


def test_meshio(mesh, tmp_path):
    other = mesh.to_meshio()
    assert isinstance(other, meshio.Mesh)
    assert np.array_equal(other.points, in_space(mesh))
    assert np.array_equal(other.cells_dict["triangle"], mesh.triangles)
    assert np.array_equal(other.point_data["degree"], mesh.degrees)
    assert set(other.cell_sets) == set(mesh.lines)
    for name, segments in mesh.lines.items():
        found = [
            block.data[chosen]
            for block, chosen in zip(other.cells, other.cell_sets[name], strict=True)
            if len(chosen)
        ]
        assert len(found) == 1 and np.array_equal(found[0], segments)
    # meshio writes it, and reads what it wrote.
    other.write(tmp_path / "mesh.vtu")
    again = meshio.read(tmp_path / "mesh.vtu")
    assert np.array_equal(again.cells_dict["triangle"], mesh.triangles)
    assert len(mindeg.read(tmp_path / "mesh.vtu").triangles) == len(mesh.triangles)
    # Gmsh's format by meshio has the names, too.
    other.write(tmp_path / "mesh.msh", file_format="gmsh22")
    lines = mindeg.read(tmp_path / "mesh.msh").lines
    assert {name: len(segments) for name, segments in lines.items()} == {name: len(segments) for name, segments in mesh.lines.items()}
