"""Renders the picture of docs/blender.md, and prints its table.

    PYTHON_WITH_BPY tests/blender/pictures.py

PYTHON_WITH_BPY is target/blender/venv/bin/python after tests/blender/run.
"""

import math
import sys
from pathlib import Path

import bpy  # Before bmesh, which it brings.
import bmesh

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Path(__file__).parent))
import test_extension as scenes

OURS = [{}, {"keep_angle": 0}, {"interior": True}]


def filled(points, edges, options):
    """An object with its loops filled by Blender, or by mindeg with options; and its degree and minimum angle in words."""
    thing = scenes.edit(points, edges)
    try:
        if options is None:
            bpy.ops.mesh.fill()
        else:
            bpy.ops.mesh.mindeg_fill(**options)
    except RuntimeError:
        return thing, "refused"
    bpy.ops.object.mode_set(mode="OBJECT")
    bm = bmesh.new()
    bm.from_mesh(thing.data)
    degree = max(len(vertex.link_edges) for vertex in bm.verts)
    angle = min(math.degrees(corner.calc_angle()) for face in bm.faces for corner in face.loops)
    bm.free()
    return thing, f"{degree} / {angle:.1f}"


def loops():
    ring = [scenes.circle(32, radius=4), scenes.circle(12, radius=1.5)]
    return {
        "rectangle with 12, 9, 4 and 4 edges": [scenes.rectangle()],
        "circle of 32": [scenes.circle(32)],
        "ring of 32 and 12": ring,
        "saddle of 24": [scenes.circle(24, wave=0.3)],
    }


def of_rings(rings):
    edges, first = [], 0
    for ring in rings:
        edges += scenes.ring_edges(len(ring), first)
        first += len(ring)
    return [point for ring in rings for point in ring], edges


def flat(name, color):
    """A material that shines in one color, whatever the light."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    shine, out = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    shine.inputs["Color"].default_value = (*color, 1)
    material.node_tree.links.new(shine.outputs[0], out.inputs[0])
    return material


def render(path):
    scene = bpy.context.scene
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    points, edges = of_rings(loops()["ring of 32 and 12"])
    paper, ink = flat("paper", (0.80, 0.86, 0.97)), flat("ink", (0.06, 0.09, 0.14))
    for place, options in enumerate([None, {}, {"interior": True}]):
        thing, _ = filled(points, edges, options)
        thing.location.x = 9 * (place - 1)
        thing.data.materials.clear()
        thing.data.materials.append(paper)
        wires = thing.copy()
        wires.data = thing.data.copy()
        wires.data.materials[0] = ink
        wires.location.z = 0.1
        frame = wires.modifiers.new("wires", "WIREFRAME")
        frame.thickness, frame.use_boundary = 0.045, True
        bpy.context.collection.objects.link(wires)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale, camera.location.z = "ORTHO", 27.5, 10
    bpy.context.collection.objects.link(camera)
    scene.camera = camera
    scene.world = scene.world or bpy.data.worlds.new("world")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 24, "CPU"
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 1320, 430, 100
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    module = scenes.loaded()
    module.register()
    for name, rings in loops().items():
        points, edges = of_rings(rings)
        cells = [filled(points, edges, options)[1] for options in [None, *OURS]]
        print(f"| {name} | {' | '.join(cells)} |")
    render(ROOT / "assets" / "images" / "blender-fill.png")
