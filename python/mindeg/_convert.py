"""A mesh as other packages have it. Each is imported when it is asked for."""

import numpy as np


def _in_space(mesh):
    """The points with three columns."""
    points = mesh.points
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def to_meshio(mesh):
    """The mesh as a ``meshio.Mesh``: triangles, the lines of each side as a cell set of its name."""
    import meshio

    cells = [("triangle", mesh.triangles)]
    sets = {}
    for name, segments in mesh.lines:
        cells.append(("line", segments))
        sets[name] = [
            np.arange(len(segments)) if block == len(cells) - 1 else np.array([], dtype=int)
            for block in range(len(cells))
        ]
    for name, blocks in sets.items():
        blocks.extend(np.array([], dtype=int) for _ in range(len(cells) - len(blocks)))
    return meshio.Mesh(_in_space(mesh), cells, point_data={"degree": mesh.degrees}, cell_sets=sets)


def to_trimesh(mesh):
    """The mesh as a ``trimesh.Trimesh`` with the same vertices in the same order."""
    import trimesh

    return trimesh.Trimesh(
        _in_space(mesh), mesh.triangles, process=False, vertex_attributes={"degree": mesh.degrees}
    )


def to_pyvista(mesh):
    """The mesh as a ``pyvista.PolyData`` with the point array ``degree``."""
    import pyvista

    data = pyvista.PolyData.from_regular_faces(_in_space(mesh), mesh.triangles)
    data.point_data["degree"] = mesh.degrees
    return data
