"""Renders the mesh of a solid to a PNG with Blender, without a display.

    target/viewers/blender/bin/python tests/viewers/render_model.py IN.obj OUT.png

The solid is seen from the front right, with its edges as thin tubes and its vertices as beads,
and the maximum degree's vertices in red.
"""

import math
import sys

sys.dont_write_bytecode = True  # leave no compiled files in the source tree

import bpy  # first: it is what makes bmesh importable
import bmesh
from mathutils import Vector

import render
from blender import open_mesh

SIZE = 7.4
PLAIN = (0.05, 0.11, 0.22)
WORST = (0.78, 0.09, 0.05)


def main(source, target):
    # The groups of an OBJ are objects with vertices of their own: equal ones are merged.
    mesh = bmesh.new()
    for thing in open_mesh(source):
        mesh.from_mesh(thing.data)
        bpy.data.objects.remove(thing)
    bmesh.ops.remove_doubles(mesh, verts=mesh.verts, dist=1e-6)
    for face in mesh.faces:
        face.smooth = False
    surface = render.add("surface", bpy.data.meshes.new("surface"))
    mesh.to_mesh(surface.data)

    vertices = surface.data.vertices
    degrees = [0] * len(vertices)
    for edge in surface.data.edges:
        for vertex in edge.vertices:
            degrees[vertex] += 1
    low = Vector(map(min, zip(*(vertex.co for vertex in vertices))))
    high = Vector(map(max, zip(*(vertex.co for vertex in vertices))))
    scale = SIZE / (high - low).length
    places = [(vertex.co - (low + high) / 2) * scale for vertex in vertices]
    for vertex, place in zip(vertices, places):
        vertex.co = place
    surface.matrix_world.identity()

    edges = [[places[vertex] for vertex in edge.vertices] for edge in surface.data.edges]
    lengths = sorted((start - end).length for start, end in edges)
    bead = min(0.1, 0.22 * lengths[len(lengths) // 4])
    surface.data.materials.clear()
    surface.data.materials.append(render.paint("face", render.FACE))
    render.add_tubes(edges, 0.25 * bead)
    most = max(degrees)
    for place, degree in zip(places, degrees):
        render.add_bead(place, bead, WORST if degree == most else PLAIN)
    render.light_and_camera()
    camera = bpy.context.scene.camera
    camera.data.ortho_scale = SIZE * 1.35
    camera.location = Vector((10, -11, 7.5))
    camera.rotation_euler = (-camera.location).to_track_quat("-Z", "Y").to_euler()
    bpy.data.objects["sun"].rotation_euler = (math.radians(40), math.radians(12), math.radians(20))
    bpy.data.lights["sun"].energy = 2.2
    bpy.data.worlds["paper"].node_tree.nodes["Background"].inputs["Strength"].default_value = 0.85
    render.WIDTH, render.HEIGHT = 800, 600
    render.render(target)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    main(*sys.argv[1:])
