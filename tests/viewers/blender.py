"""Opens meshes in Blender and writes down what Blender sees in them.

    blender.py READINGS.jsonl FILE...

One line of JSON a file, in the order given; judging the numbers is left to expectations.py.
"""

import math

import bpy  # first: it is what makes bmesh importable
import bmesh
import numpy

from readings import write_readings


def open_mesh(path):
    """Imports a file into an empty scene and returns its mesh objects."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if path.endswith(".obj"):
        # Blender assumes that an OBJ has y up and turns it; these axes leave it as written.
        # Its validation would drop a triangle that is there twice.
        bpy.ops.wm.obj_import(
            filepath=path, forward_axis="Y", up_axis="Z", validate_meshes=False
        )
    elif path.endswith((".ply", ".stl")):
        importers = {".ply": bpy.ops.wm.ply_import, ".stl": bpy.ops.wm.stl_import}
        importers[path[-4:]](filepath=path)
    else:
        # Merging would hide a vertex written twice.
        bpy.ops.import_scene.gltf(filepath=path, merge_vertices=False)
    return [thing for thing in bpy.data.objects if thing.type == "MESH"]


def read(path):
    meshes = open_mesh(path)
    objects = [thing for thing in meshes if thing.data.polygons]
    lines = [thing for thing in meshes if not thing.data.polygons]
    if not objects:
        return {"error": "no mesh in the file"}
    # Where the domain's x and y are, with what sign, and where its normal points. On the floor,
    # the file has (x, 0, -y).
    is_turned, is_floor = path.endswith((".glb", ".gltf")), "-floor." in path
    if is_floor and not is_turned:
        across, front = ((0, 1), (2, -1)), (0, 1, 0)
    elif is_floor or not is_turned:
        across, front = ((0, 1), (1, 1)), (0, 0, 1)
    else:
        # The glTF importer turns y up into z up: the file's (x, y, z) arrives as (x, -z, y).
        across, front = ((0, 1), (2, 1)), (0, -1, 0)
    first = objects[0]
    mesh = bmesh.new()
    mesh.from_mesh(first.data)
    mesh.normal_update()
    angles = [math.degrees(loop.calc_angle()) for face in mesh.faces for loop in face.loops]
    world = [first.matrix_world @ vertex.co for vertex in mesh.verts]
    places = [[sign * place[axis] for axis, sign in across] for place in world]
    return {
        "meshes": len(objects),
        "vertices": len(mesh.verts),
        "faces": len(mesh.faces),
        "non_manifold_edges": sum(len(edge.link_faces) not in (1, 2) for edge in mesh.edges),
        "boundary_edges": sum(edge.is_boundary for edge in mesh.edges),
        "components": count_components(mesh),
        "max_degree": max(len(vertex.link_edges) for vertex in mesh.verts),
        "faces_turned_away": sum(not face.normal.dot(front) > 0 for face in mesh.faces),
        "area": sum(face.calc_area() for face in mesh.faces),
        "min_angle": min(angles),
        "max_angle": max(angles),
        "bounds": [[min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)]],
        "shortest_edge": min(edge.calc_length() for edge in mesh.edges),
        # Blender keeps single precision, for the vertices as for where the object stands.
        "shape_step": largest_step(vertex.co for vertex in mesh.verts),
        "place_step": largest_step(world),
        "line_segments": sum(len(thing.data.edges) for thing in lines),
        "has_colors": len(first.data.color_attributes) > 0,
    }


def largest_step(points):
    """The gap between neighbouring single-precision numbers at the largest coordinate."""
    largest = max(abs(coordinate) for point in points for coordinate in point)
    return float(numpy.spacing(numpy.float32(largest)))


def count_components(mesh):
    """How many pieces the mesh falls into, walking from vertex to vertex along edges."""
    unseen = set(mesh.verts)
    components = 0
    while unseen:
        components += 1
        frontier = [unseen.pop()]
        while frontier:
            vertex = frontier.pop()
            for edge in vertex.link_edges:
                neighbor = edge.other_vert(vertex)
                if neighbor in unseen:
                    unseen.remove(neighbor)
                    frontier.append(neighbor)
    return components


if __name__ == "__main__":
    write_readings(read)
