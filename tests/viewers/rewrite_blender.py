"""Opens meshes in Blender and writes them in other formats, as a user does: with default options.

    rewrite_blender.py READINGS.jsonl FILE...

Writes FILE's name with -blender and each extension beside it; one line of JSON a file lists them.
"""

from pathlib import Path

import bpy

from readings import write_readings

IMPORTERS = {
    ".obj": lambda path: bpy.ops.wm.obj_import(filepath=path),
    ".ply": lambda path: bpy.ops.wm.ply_import(filepath=path),
    ".stl": lambda path: bpy.ops.wm.stl_import(filepath=path),
    ".glb": lambda path: bpy.ops.import_scene.gltf(filepath=path),
}
EXPORTERS = {
    ".obj": lambda path: bpy.ops.wm.obj_export(filepath=path),
    ".ply": lambda path: bpy.ops.wm.ply_export(filepath=path),
    ".stl": lambda path: bpy.ops.wm.stl_export(filepath=path),
    ".glb": lambda path: bpy.ops.export_scene.gltf(filepath=path, export_format="GLB"),
}


def rewrite(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    path = Path(path)
    IMPORTERS[path.suffix](str(path))
    written = []
    for extension, export in EXPORTERS.items():
        target = path.with_name(f"{path.stem}-{path.suffix[1:]}-blender{extension}")
        export(str(target))
        written.append(str(target))
    return {"written": written}


if __name__ == "__main__":
    write_readings(rewrite)
