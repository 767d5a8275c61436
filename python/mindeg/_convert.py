"""A mesh as other packages have it, and a picture of it. Each package is imported when it is asked for."""

import numpy as np


def _in_space(mesh):
    """The points with three columns."""
    points = mesh.points
    if points.shape[1] == 3:
        return points
    return np.column_stack([points, np.zeros(len(points))])


def to_meshio(mesh):
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
    # Gmsh's formats have names by number alone.
    numbers, names = [np.zeros(len(of_block), dtype=np.int32) for _, of_block in cells], {}
    for number, (name, block, indices) in enumerate(items, 1):
        numbers[block][indices] = number
        names[name] = np.array([number, {"triangle": 2, "line": 1, "vertex": 0}[cells[block][0]]])
    tags = {"gmsh:physical": numbers, "gmsh:geometrical": numbers} if items else {}
    return meshio.Mesh(
        _in_space(mesh), cells, point_data={"degree": mesh.degrees}, cell_data=tags, cell_sets=sets, field_data=names
    )


def to_trimesh(mesh):
    import trimesh

    return trimesh.Trimesh(
        _in_space(mesh), mesh.triangles, process=False, vertex_attributes={"degree": mesh.degrees}
    )


def to_pyvista(mesh):
    import pyvista

    data = pyvista.PolyData.from_regular_faces(_in_space(mesh), mesh.triangles)
    data.point_data["degree"] = mesh.degrees
    return data


def plot(mesh, ax, values):
    import matplotlib.pyplot as plt

    points, triangles = mesh.points, mesh.triangles
    if values is not None:
        values = np.asarray(values, dtype=float)
        if values.shape not in ((len(points),), (len(triangles),)):
            raise ValueError(
                f"values has the shape {values.shape}; give {len(points)} numbers, one for each vertex, or {len(triangles)}, "
                "one for each triangle"
            )
    is_flat = points.shape[1] == 2
    if ax is None:
        # The layout makes room for the legend and the colors.
        ax = plt.figure(layout="constrained").add_subplot(projection=None if is_flat else "3d")
    if is_flat:
        _plot_in_plane(ax, mesh, values)
    else:
        _plot_in_space(ax, mesh, values)
    ax.set_aspect("equal")
    if mesh.name:
        ax.set_title(mesh.name)
    return ax


def _plot_in_plane(ax, mesh, values):
    (x, y), triangles = mesh.points.T, mesh.triangles
    if values is None:
        for index, of_group in enumerate(mesh.groups.values()):
            ax.tripcolor(x, y, triangles[of_group], facecolors=np.full(len(of_group), index % 10), cmap="tab10", vmin=0, vmax=9, alpha=0.2)
    else:
        of_what = (values,) if len(values) == len(x) else ()
        how = {"shading": "gouraud"} if of_what else {"facecolors": values}
        ax.figure.colorbar(ax.tripcolor(x, y, triangles, *of_what, **how), ax=ax)
    ax.triplot(x, y, triangles, color="0.45", linewidth=0.5)
    for name, segments in mesh.lines.items():
        # A gap after each segment, so that all are one line of the legend.
        path = np.insert(mesh.points[segments], 2, np.nan, axis=1).reshape(-1, 2)
        ax.plot(*path.T, linewidth=2, label=name)
    if 1 < len(mesh.lines) <= 10:
        ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.08), ncols=min(len(mesh.lines), 4))


def _plot_in_space(ax, mesh, values):
    x, y, z = mesh.points.T
    surface = ax.plot_trisurf(x, y, z, triangles=mesh.triangles, color="0.85", edgecolor="0.3", linewidth=0.3)
    if values is not None:
        of_triangles = values[mesh.triangles].mean(axis=1) if len(values) == len(x) else values
        surface.set(array=of_triangles, cmap="viridis")
        ax.figure.colorbar(surface, ax=ax, shrink=0.7)
