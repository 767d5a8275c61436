"""Meshes of anything at once, and meshes made better."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _mindeg
from ._domain import Domain, has_reference_system, is_domain, path_or_text, polygon_text, reading_of, warn
from ._options import InteriorOptions, MeshOptions, ReadingOptions, as_json, separated, shows_its_options, wish

if TYPE_CHECKING:
    import numpy.typing as npt
    from typing_extensions import Unpack

    class _Options(MeshOptions, ReadingOptions, total=False):
        pass


@shows_its_options(ReadingOptions, MeshOptions)
def mesh(
    source: str | os.PathLike[str] | Mapping[str, Any] | npt.ArrayLike | Any,
    *,
    interior: bool | None = None,
    preset: str | None = None,
    merge_coplanar: bool = False,
    planar_tolerance: float | None = None,
    effort: float = 1.0,
    **options: Unpack[_Options],
) -> _mindeg.Mesh:
    """One mesh of what you have, as ``mindeg mesh`` makes it.

    ``source`` is all that ``Domain`` takes, with its options, meshed as ``Domain.mesh`` does with the same options. Besides:

    - polygons that do not hang together, in a file, GeoJSON or a GeoDataFrame, or made by ``repair``, become the regions of one mesh:
      ``groups`` of the mesh, called after the property or column ``name_by``; ``docs/maps.md`` explains maps;
    - a model, whose faces are planar polygons in space, becomes one watertight mesh: the path of an OBJ with faces or of a
      glTF, a ``Mesh``, or a dict with "faces". ``size`` is the length of edges; ``merge_coplanar`` makes neighbouring
      faces in one plane one face; a corner may be ``planar_tolerance`` off the plane of its face; ``effort`` is how
      long to look for a smaller degree, as a multiple of what is usual. ``docs/models.md`` explains models.
    """
    goal, wanted, reading = separated(options)
    wished = wish(interior, preset, goal, {} if "sizes" in wanted else wanted)
    of_model = {"merge_coplanar": merge_coplanar, "planar_tolerance": planar_tolerance, "effort": effort}
    if isinstance(source, _mindeg.Mesh):
        for key in reading:
            if key != "size":
                raise ValueError(f"{key} is for polygons and files, not for a Mesh")
        return _mindeg._mesh_of_faces(source, reading.get("size"), wished, of_model)
    path, text = path_or_text(source)
    sizes = wanted.get("sizes")
    is_called = callable(sizes) or isinstance(sizes, (list, tuple)) and any(callable(size) for size in sizes)
    if path is None and text is None and reading.get("repair") and not is_called and not is_domain(source):
        # One ring can become several polygons.
        text, reading["called"] = polygon_text(source)
    if path is None and text is None:
        domain = source if isinstance(source, Domain) and not reading else Domain(source, **reading)
        return domain.mesh(interior=interior, preset=preset, **goal, **wanted)
    if is_called:
        try:
            domain = Domain(source, **reading)
        except ValueError as fault:
            raise ValueError(f"sizes: a function is for a single domain, and there is none: {fault}") from None
        return domain.mesh(interior=interior, preset=preset, **goal, **wanted)
    if sizes is not None:
        from ._sizes import given_sizes

        wished = wish(interior, preset, goal, {**wanted, "sizes": given_sizes(sizes, None)})
    if path is None and not has_reference_system(source):
        reading = {"project": "none", **reading}
    made, notes = _mindeg._mesh_of_file(reading_of(path, text, **reading), wished, of_model)
    warn(notes, 3)
    return made


@shows_its_options(InteriorOptions)
def improve(
    points: _mindeg.Mesh | npt.ArrayLike,
    triangles: npt.ArrayLike | None = None,
    *,
    preset: str | None = None,
    **options: Unpack[InteriorOptions],
) -> _mindeg.Mesh:
    """The optimiser alone on a planar mesh, given as a mesh or as points and triangles: the boundary stays.

    Options as for points inside in ``Domain.mesh``; ``report["before"]`` has what the mesh was like. A result that breaks
    a rule of ``preset``, a program of ``mindeg.PRESETS``, is a ``ValueError``.
    """
    goal, wanted, reading = separated(options)
    for key in [*goal, *reading]:
        raise TypeError(f"{key} has no meaning here; the options are {', '.join(InteriorOptions.__annotations__)}")
    return _mindeg._improve(points, triangles, preset, as_json(wanted))
