"""Opens the mesh of a solid in MeshLab, Blender or trimesh and prints what it sees, as one line of JSON.

    solids.py meshlab|blender|trimesh FILE

The groups of a file are parts with vertices of their own: equal ones are merged, exactly.
"""

import json
import sys


def in_meshlab(path):
    import numpy
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(path)
    if meshes.mesh_number() > 1:
        meshes.generate_by_merging_visible_meshes()
    meshes.meshing_remove_duplicate_vertices()
    topology = meshes.get_topological_measures()
    mesh = meshes.current_mesh()
    faces = mesh.face_matrix()
    edges = numpy.unique(numpy.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    return {
        "vertices": mesh.vertex_number(),
        "faces": mesh.face_number(),
        "boundary_edges": topology["boundary_edges"],
        "non_manifold_edges": topology["non_two_manifold_edges"],
        "components": topology["connected_components_number"],
        "max_degree": int(numpy.bincount(edges.ravel()).max()),
        "volume": meshes.get_geometric_measures()["mesh_volume"],
    }


def in_blender(path):
    import bpy  # first: it is what makes bmesh importable
    import bmesh

    from blender import open_mesh

    mesh = bmesh.new()
    materials = {}
    for thing in open_mesh(path):
        mesh.from_mesh(thing.data)
        for material in thing.data.materials:
            shader = material.node_tree.nodes["Principled BSDF"]
            color = list(shader.inputs["Base Color"].default_value)[:3]
            materials[material.name] = [round(channel, 4) for channel in color]
    bmesh.ops.remove_doubles(mesh, verts=mesh.verts, dist=1e-6)
    left = set(mesh.faces)
    components = 0
    while left:
        components += 1
        open_faces = [left.pop()]
        while open_faces:
            for edge in open_faces.pop().edges:
                for face in edge.link_faces:
                    if face in left:
                        left.remove(face)
                        open_faces.append(face)
    return {
        "vertices": len(mesh.verts),
        "faces": len(mesh.faces),
        "boundary_edges": sum(edge.is_boundary for edge in mesh.edges),
        "non_manifold_edges": sum(len(edge.link_faces) != 2 for edge in mesh.edges),
        "components": components,
        "max_degree": max(len(vertex.link_edges) for vertex in mesh.verts),
        "volume": mesh.calc_volume(signed=True),
        "materials": materials,
    }


def in_trimesh(path):
    import numpy
    import trimesh

    scene = trimesh.load_scene(path, process=False)
    materials = {}
    for part in scene.geometry.values():
        material = part.visual.material
        color = getattr(material, "baseColorFactor", None)
        color = material.diffuse if color is None else color
        materials[material.name] = [round(int(channel) / 255, 4) for channel in color[:3]]
    whole = scene.to_mesh()
    whole.merge_vertices(merge_norm=True, merge_tex=True)
    return {
        "vertices": len(whole.vertices),
        "faces": len(whole.faces),
        "closed": bool(whole.is_watertight),
        "max_degree": int(numpy.bincount(whole.edges_unique.ravel()).max()),
        "volume": float(whole.volume),
        "materials": materials,
    }


if __name__ == "__main__":
    viewer, path = sys.argv[1:]
    print(json.dumps({"meshlab": in_meshlab, "blender": in_blender, "trimesh": in_trimesh}[viewer](path)))
