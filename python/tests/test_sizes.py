"""Sizes of interior points: files, functions, grids."""

import numpy as np
import pytest

import mindeg

SQUARE = mindeg.rectangle(4, 4, size=0.5)


def lengths(mesh, x, y, radius):
    """The lengths of the edges within a disc."""
    ends = mesh.points[mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)]
    near = (np.hypot(*(ends - [x, y]).T) < radius).all(axis=0)
    return np.hypot(*(ends[:, 1] - ends[:, 0]).T)[near]


def wanted(points):
    return 0.05 + 0.2 * np.hypot(*(points - [1, 1]).T)


def test_a_function_gives_sizes():
    mesh = SQUARE.mesh(interior=True, sizes=wanted)
    assert 0.05 < lengths(mesh, 1, 1, 0.2).mean() < 0.12
    assert lengths(mesh, 3, 3, 0.6).mean() > 0.3
    assert mesh.report["sizes"]["near"] > 0.8
    only = SQUARE.mesh(interior=True, sizes=lambda points: np.where(points[:, 0] < 2, np.nan, 0.1))
    assert lengths(only, 3, 2, 0.7).mean() < 0.13 < 0.3 < lengths(only, 0.7, 2, 0.5).mean()


def test_grids_and_files_give_the_same_sizes(tmp_path):
    x = np.linspace(0, 4, 41)
    rows = wanted(np.stack(np.meshgrid(x, x), axis=-1).reshape(-1, 2)).reshape(41, 41)
    np.savez(tmp_path / "sizes.npz", values=rows, origin=[0, 0], spacing=[0.1, 0.1])
    with open(tmp_path / "sizes.asc", "w") as file:
        print("ncols 41\nnrows 41\nxllcenter 0\nyllcenter 0\ncellsize 0.1", file=file)
        np.savetxt(file, rows[::-1], fmt="%.17g")
    grid = SQUARE.mesh(interior=True, sizes={"origin": [0, 0], "spacing": [0.1, 0.1], "rows": rows})
    assert 0.05 < lengths(grid, 1, 1, 0.2).mean() < 0.12
    for name in ("sizes.npz", "sizes.asc"):
        mesh = SQUARE.mesh(interior=True, sizes=tmp_path / name)
        assert np.array_equal(mesh.points, grid.points), name
    both = SQUARE.mesh(interior=True, sizes=[(3, 3, 0.1), str(tmp_path / "sizes.npz")])
    assert len(both.points) > len(grid.points)


def test_sides_that_contradict_sizes_are_in_the_report():
    report = mindeg.rectangle(1, 1, intervals=1).mesh(interior=True, size_inside=0.1).report
    assert [side["name"] for side in report["coarse_sides"]] == ["side 1", "side 2", "side 3", "side 4"]
    assert report["coarse_sides"][0]["wanted_intervals"] == 10


def test_wrong_sizes_are_told(tmp_path):
    with pytest.raises(ValueError, match=r"the shape \(\) for 5120 points"):
        SQUARE.mesh(interior=True, sizes=lambda points: 1.0)
    with pytest.raises(ValueError, match="the function gave no size"):
        SQUARE.mesh(interior=True, sizes=lambda points: np.zeros(len(points)))
    (tmp_path / "sizes.asc").write_text("hello")
    with pytest.raises(ValueError, match="sizes are read from an ESRI grid"):
        SQUARE.mesh(interior=True, sizes=tmp_path / "sizes.asc")
