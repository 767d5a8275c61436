"""Renders a mesh to a PNG with Blender, without a display.

    target/viewers/blender/bin/python tests/viewers/render.py IN.glb OUT.png

The mesh is seen square on, with its edges as thin tubes and its vertices as beads. If the
file has vertex colours the beads take them, and where each degree has one colour of its
own a legend says which.
"""

import sys
from pathlib import Path

sys.dont_write_bytecode = True  # leave no compiled files in the source tree

import bpy
from mathutils import Vector

from blender import open_mesh

WIDTH, HEIGHT = 1200, 900
# The mesh is scaled into a window this large, in Blender's units; the rest is margin.
FRAME = Vector((12.0, 9.0))
MARGIN = 0.7
LEGEND_HEIGHT = 0.9
LEGEND_LENGTH = 9

# Linear light, as Blender takes colours.
PAPER = (1.0, 1.0, 1.0)
FACE = (0.66, 0.74, 0.84)
INK = (0.012, 0.018, 0.03)


def main(source, target):
    objects = open_mesh(source)
    if len(objects) != 1:
        sys.exit(f"{source}: expected one mesh, saw {len(objects)}")
    surface = objects[0]
    colors = vertex_colors(surface.data)
    degrees = [0] * len(surface.data.vertices)
    for edge in surface.data.edges:
        for vertex in edge.vertices:
            degrees[vertex] += 1
    legend = legend_of(degrees, colors)

    places = fit(surface, LEGEND_HEIGHT if legend else 0.0)
    edges = [[places[vertex] for vertex in edge.vertices] for edge in surface.data.edges]
    lengths = sorted((start - end).length for start, end in edges)
    # Beads should not touch, save on the few shortest edges: one short edge in a corner
    # must not shrink them all. Nor may they vanish on a dense mesh.
    bead = min(0.15, max(0.02, 0.35 * lengths[len(lengths) // 10]))
    surface.data.materials.clear()
    surface.data.materials.append(paint("face", FACE))
    add_tubes(edges, 0.18 * bead)
    for number, place in enumerate(places):
        add_bead(place, bead, colors[number] if colors else INK)
    if legend:
        add_legend(legend)
    light_and_camera()
    render(target)


def fit(surface, legend_height):
    """Lays the mesh flat, facing up, and scales it into the frame; returns its vertices."""
    largest = max(surface.data.polygons, key=lambda face: face.area)
    upward = largest.normal.rotation_difference(Vector((0, 0, 1)))
    places = [upward @ vertex.co for vertex in surface.data.vertices]
    low = Vector(map(min, zip(*places)))
    high = Vector(map(max, zip(*places)))
    room = FRAME - Vector((2 * MARGIN, 2 * MARGIN + legend_height))
    size = high - low
    scale = min(room.x / size.x, room.y / size.y)
    middle = Vector((0, legend_height / 2, 0))
    places = [(place - (low + high) / 2) * scale + middle for place in places]
    for vertex, place in zip(surface.data.vertices, places):
        vertex.co = place
    surface.matrix_world.identity()
    return places


def vertex_colors(mesh):
    """One colour a vertex, or nothing if the file has none."""
    if not mesh.color_attributes:
        return None
    layer = mesh.color_attributes[0]
    if layer.domain == "POINT":
        return [tuple(entry.color[:3]) for entry in layer.data]
    colors = [INK] * len(mesh.vertices)
    for loop, entry in zip(mesh.loops, layer.data):
        colors[loop.vertex_index] = tuple(entry.color[:3])
    return colors


def legend_of(degrees, colors):
    """Which colour stands for which degree; nothing if they don't, or if they are too many."""
    if not colors:
        return {}
    legend = {}
    for degree, color in zip(degrees, colors):
        known = legend.setdefault(degree, color)
        if (Vector(known) - Vector(color)).length > 0.02:
            return {}
    return dict(sorted(legend.items())) if len(legend) <= LEGEND_LENGTH else {}


def paint(name, color, rough=0.6):
    material = bpy.data.materials.new(name)
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Roughness"].default_value = rough
    return material


def add(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_tubes(edges, radius):
    curve = bpy.data.curves.new("edges", "CURVE")
    curve.dimensions = "3D"
    curve.bevel_depth = radius
    for ends in edges:
        spline = curve.splines.new("POLY")
        spline.points.add(1)
        for point, end in zip(spline.points, ends):
            point.co = (*end, 1)
    curve.materials.append(paint("edge", INK))
    add("edges", curve)


def add_bead(place, radius, color):
    """A ball; all of one colour share their shape and paint."""
    name = "bead " + " ".join(f"{part:.3f}" for part in color)
    shape = bpy.data.meshes.get(name)
    if not shape:
        bpy.ops.mesh.primitive_uv_sphere_add(segments=48, ring_count=24, radius=1)
        pattern = bpy.context.object
        bpy.ops.object.shade_smooth()
        shape = pattern.data
        shape.name = name
        shape.materials.append(paint(name, color, rough=0.35))
        bpy.data.objects.remove(pattern)
    bead = add(name, shape)
    bead.location = place
    bead.scale = (radius, radius, radius)


def add_legend(legend):
    line = -FRAME.y / 2 + MARGIN
    step = 1.0
    title_width = 1.6
    left = -(title_width + step * (len(legend) - 0.5)) / 2
    add_text("degree", Vector((left, line, 0)))
    for position, (degree, color) in enumerate(legend.items()):
        place = Vector((left + title_width + step * position, line, 0))
        add_bead(place, 0.14, color)
        add_text(str(degree), place + Vector((0.28, 0, 0)))


def add_text(words, place):
    text = bpy.data.curves.new(words, "FONT")
    text.body = words
    text.size = 0.42
    text.align_y = "CENTER"
    text.materials.append(paint("text", INK))
    add(words, text).location = place


def light_and_camera():
    scene = bpy.context.scene
    world = bpy.data.worlds.new("paper")
    scene.world = world
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (*PAPER, 1)
    background.inputs["Strength"].default_value = 1.0

    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = 0.5
    sun.angle = 0.3
    add("sun", sun).rotation_euler = (0.5, -0.4, 0)

    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.ortho_scale = FRAME.x
    scene.camera = add("camera", camera)
    scene.camera.location = (0, 0, 10)


def render(target):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = 24
    scene.cycles.use_denoising = True
    scene.cycles.max_bounces = 2
    scene.view_settings.view_transform = "Standard"
    scene.render.film_transparent = False
    scene.render.resolution_x = WIDTH
    scene.render.resolution_y = HEIGHT
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.compression = 100
    # Dithering would double the size of the file.
    scene.render.dither_intensity = 0
    scene.render.filepath = str(Path(target).resolve())
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    main(*sys.argv[1:])
