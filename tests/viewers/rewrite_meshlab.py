"""Opens meshes in MeshLab and writes them in other formats, as a user does: with default options.

    rewrite_meshlab.py READINGS.jsonl FILE...

Writes FILE's name with -meshlab and each extension beside it; one line of JSON a file lists them.
"""

from pathlib import Path

import pymeshlab

from readings import write_readings

EXTENSIONS = (".obj", ".ply", ".stl", ".off")


def rewrite(path):
    path = Path(path)
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    # MeshLab keeps where a glTF places its mesh apart, and leaves it out of other formats.
    meshes.apply_matrix_freeze()
    written = []
    for extension in EXTENSIONS:
        target = path.with_name(f"{path.stem}-{path.suffix[1:]}-meshlab{extension}")
        meshes.save_current_mesh(str(target))
        written.append(str(target))
    return {"written": written}


if __name__ == "__main__":
    write_readings(rewrite)
