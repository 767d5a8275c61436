"""Meshes of a domain from its boundary points, with low degree and good angles.

>>> import mindeg
>>> domain = mindeg.rectangle(4, 3, intervals=[12, 9, 4, 4])
>>> mesh = domain.mesh(keep_angle=0.95)
>>> mesh.max_degree, mesh.points.shape, mesh.triangles.shape
(6, (29, 2), (27, 3))

Vertices and sides are numbered from 0, counter-clockwise from the first corner; angles are in degrees. Faults in
what you give are ``ValueError`` with what to do.
"""

from ._domain import Domain, mesh_map, polygon, rectangle
from ._mindeg import (
    Degree,
    Mesh,
    Suggestion,
    TradeOffPoint,
    __version__,
    _goals,
    bridge_loops,
    fill_loop,
    inspect,
    read,
    remesh,
)
from ._options import improve

#: The goals of ``Domain.mesh``: for each a dict with its key, what its value is, and what it asks for.
GOALS = _goals()

__all__ = [
    "Degree",
    "Domain",
    "GOALS",
    "Mesh",
    "Suggestion",
    "TradeOffPoint",
    "__version__",
    "bridge_loops",
    "fill_loop",
    "improve",
    "inspect",
    "mesh_map",
    "polygon",
    "read",
    "rectangle",
    "remesh",
]


def _restored(points, triangles, name, lines, *rest):
    """A mesh that was pickled."""
    return Mesh._of_parts(points, triangles, name, lines, *rest)


def _add_conversions():
    """The conversions live in Python: each needs a package that mindeg does not."""
    from . import _convert

    Mesh.to_meshio = _convert.to_meshio
    Mesh.to_trimesh = _convert.to_trimesh
    Mesh.to_pyvista = _convert.to_pyvista


_add_conversions()
