"""Draws a bracket in Blender, as a person would, and exports it as OBJ with its materials.

    draw.py FILE.obj

An L-shaped profile, 60 x 50 and 6 thick, is extruded by 40; a boolean cuts a hexagonal bolt hole through its foot.
The profile makes concave faces, the hole a face with a hole. Prints the exact volume as JSON.
"""

import json
import sys

import bpy

PROFILE = [(0, 0), (60, 0), (60, 6), (6, 6), (6, 50), (0, 50)]
WIDTH = 40
THICK = 6
RADIUS = 8  # of the hexagon's corners
PAINTS = {"steel": (0.5, 0.5, 0.625, 1.0), "red paint": (0.75, 0.125, 0.0625, 1.0)}


def main(path):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bracket = solid("bracket", PROFILE, 0, WIDTH)
    for name, color in PAINTS.items():
        material = bpy.data.materials.new(name)
        material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = color
        bracket.data.materials.append(material)
    # The two ends are painted.
    for face in bracket.data.polygons:
        face.material_index = int(len(face.vertices) == len(PROFILE))
    bpy.ops.mesh.primitive_cylinder_add(
        vertices=6, radius=RADIUS, depth=4 * THICK, location=(35, WIDTH / 2, THICK / 2)
    )
    bolt = bpy.context.object
    cut = bracket.modifiers.new("hole", "BOOLEAN")
    cut.operation, cut.object, cut.solver = "DIFFERENCE", bolt, "EXACT"
    bpy.context.view_layer.objects.active = bracket
    bpy.ops.object.modifier_apply(modifier="hole")
    bpy.data.objects.remove(bolt)
    bpy.ops.wm.obj_export(filepath=path, export_materials=True, export_uv=False)
    hexagon = 1.5 * 3**0.5 * RADIUS**2
    area = 60 * THICK + (50 - THICK) * THICK
    print(json.dumps({"volume": area * WIDTH - hexagon * THICK}))


def solid(name, profile, start, end):
    """The profile in x and z, extruded along y."""
    n = len(profile)
    points = [(x, y, z) for y in (start, end) for x, z in profile]
    faces = [tuple(range(n)), tuple(range(2 * n - 1, n - 1, -1))]
    faces += [((i + 1) % n, i, n + i, n + (i + 1) % n) for i in range(n)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    mesh.validate()
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


if __name__ == "__main__":
    main(sys.argv[1])
