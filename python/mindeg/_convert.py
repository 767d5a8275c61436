"""A mesh as other packages have it. Each is imported when it is asked for."""

import numpy as np


def _in_space(mesh):
    """The points with three columns."""
    points = mesh.points
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def to_meshio(mesh):
    """The mesh as a ``meshio.Mesh``: triangles, lines and named points, with a cell set for each name."""
    import meshio

    cells = [("triangle", mesh.triangles)]
    items = [(name, 0, triangles) for name, triangles in mesh.groups.items()]
    for name, segments in mesh.lines.items():
        items.append((name, len(cells), np.arange(len(segments))))
        cells.append(("line", segments))
    for name, vertices in mesh.named_points.items():
        items.append((name, len(cells), np.arange(len(vertices))))
        cells.append(("vertex", vertices[:, None]))
    sets = {name: [np.array([], dtype=int)] * len(cells) for name, _, _ in items}
    for name, block, indices in items:
        sets[name][block] = indices
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
