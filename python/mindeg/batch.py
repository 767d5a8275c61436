"""Many domains on many machines, over a Dask client.

>>> from dask.distributed import Client  # doctest: +SKIP
>>> with Client() as client:  # doctest: +SKIP
...     written = mindeg.batch.mesh_files(client, sources, "meshes", keep_angle=0.95)

Meshing one domain takes milliseconds, so domains go to the workers in chunks: Dask's own work for a task is about
a millisecond. Each output is written whole or not at all, by one task; a task that runs twice writes the same bytes.
"""

import os
from collections.abc import Iterable, Mapping

from . import mesh


def mesh_files(
    client,
    sources: Mapping[str, object],
    folder: str | os.PathLike[str],
    *,
    extension: str = "obj",
    chunk: int = 64,
    **options,
) -> dict[str, str | None]:
    """Mesh every source into ``folder/<name>.<extension>``, as ``mindeg.mesh`` does with the same ``options``.

    Gives for each name ``None``, or what is wrong with its source: one fault does not keep the others from their files.
    """
    folder = os.fspath(folder)
    os.makedirs(folder, exist_ok=True)
    for name in sources:
        if name in ("", ".", "..") or os.path.basename(name) != name:
            raise ValueError(f"{name!r} is no file name; give names without folders")
    futures = client.map(
        _mesh_chunk,
        list(_chunks(list(sources.items()), chunk)),
        folder=folder,
        extension=extension,
        options=options,
        pure=False,
    )
    outcomes: dict[str, str | None] = {}
    for part in client.gather(futures):
        outcomes.update(part)
    return outcomes


def _chunks(items: list, size: int) -> Iterable[list]:
    if size < 1:
        raise ValueError(f"chunk is {size}; give 1 or more")
    return (items[start : start + size] for start in range(0, len(items), size))


def _mesh_chunk(items, *, folder, extension, options):
    outcomes = {}
    for name, source in items:
        try:
            mesh(source, **options).save(os.path.join(folder, f"{name}.{extension}"))
            outcomes[name] = None
        except (ValueError, OSError) as error:
            outcomes[name] = str(error)
    return outcomes
