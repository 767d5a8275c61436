"""Triangle meshes of polygons, maps, models and surfaces: few edges at every vertex, good angles, with proofs.

>>> import mindeg
>>> domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
>>> mesh = domain.mesh(keep_angle=0.95)
>>> mesh.max_degree, mesh.points.shape, mesh.triangles.shape
(6, (29, 2), (27, 3))
>>> mesh = domain.mesh(interior=True)
>>> mesh.report["share_of_limit"] > 0.9
True

``mindeg.mesh(source)`` does both steps for what you have: arrays, shapely's polygons, a GeoDataFrame, files.
Vertices and sides are numbered from 0, counter-clockwise from the first corner; angles are in degrees. Faults in
what you give are ``ValueError`` with what to do.
"""

from inspect import signature as _signature
from typing import TYPE_CHECKING as _TYPE_CHECKING

from ._domain import Domain, polygon, rectangle
from ._mesh import improve, mesh
from ._mindeg import (
    Degree,
    Mesh,
    Suggestion,
    TradeOffPoint,
    __version__,
    _goals,
    _presets,
    bridge,
    bridge_loops,
    fill,
    fill_loop,
    inspect,
    read,
    remesh,
    stitch,
    verify,
)
from ._options import shows_its_options as _shows_its_options
from ._options import shows_its_types as _shows_its_types
from ._progress import progress

if _TYPE_CHECKING:
    import numpy.typing as npt

bridge = _shows_its_types(bridge)
bridge_loops = _shows_its_types(bridge_loops)
fill = _shows_its_types(fill)
fill_loop = _shows_its_types(fill_loop)
inspect = _shows_its_types(inspect)
read = _shows_its_types(read)
remesh = _shows_its_types(remesh)
stitch = _shows_its_types(stitch)
verify = _shows_its_types(verify)

#: The goals of ``Domain.mesh``: for each a dict with its key, what its value is, and what it asks for.
GOALS = _goals()

#: The programs whose rules ``inspect`` and ``verify`` can check, and these rules, by name.
PRESETS = _presets()

__all__ = [
    "Degree",
    "Domain",
    "GOALS",
    "Mesh",
    "PRESETS",
    "Suggestion",
    "TradeOffPoint",
    "__version__",
    "bridge",
    "bridge_loops",
    "fill",
    "fill_loop",
    "improve",
    "inspect",
    "mesh",
    "polygon",
    "progress",
    "read",
    "rectangle",
    "remesh",
    "stitch",
    "verify",
]


def _restored(points, triangles, name, lines, *rest):
    """A mesh that was pickled."""
    return Mesh._of_parts(points, triangles, name, lines, *rest)


def _add_methods():
    """These live in Python: each needs a package that mindeg does not, and is imported when it is called."""

    def plot(self, ax=None, *, values=None):
        """Draw the mesh with matplotlib, and give the axes: edges, groups in light colors, named lines in strong ones.

        ``ax`` are axes to draw in; without them a new figure is made. ``values`` are numbers to show as colors, one for each
        vertex or for each triangle, such as ``mesh.degrees`` or a solution.
        """
        from ._convert import plot

        return plot(self, ax, values)

    def to_meshio(self):
        """The mesh as a ``meshio.Mesh``: triangles, lines and named points, with a cell set for each name."""
        from ._convert import to_meshio

        return to_meshio(self)

    def to_trimesh(self):
        """The mesh as a ``trimesh.Trimesh`` with the same vertices in the same order."""
        from ._convert import to_trimesh

        return to_trimesh(self)

    def to_pyvista(self):
        """The mesh as a ``pyvista.PolyData`` with the point array ``degree``."""
        from ._convert import to_pyvista

        return to_pyvista(self)

    @_shows_its_options()
    def made(points: "npt.ArrayLike", triangles: "npt.ArrayLike", name: "str | None" = None) -> "Mesh":
        return Mesh(points, triangles, name)

    # A class in Rust has no types.
    setattr(Mesh, "__signature__", _signature(made))
    for method in (plot, to_meshio, to_trimesh, to_pyvista):
        method.__qualname__ = f"Mesh.{method.__name__}"
        setattr(Mesh, method.__name__, method)


_add_methods()
