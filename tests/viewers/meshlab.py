"""Opens meshes in MeshLab and writes down what MeshLab sees in them.

    meshlab.py READINGS.jsonl FILE...

One line of JSON a file, in the order given; judging the numbers is left to expectations.py.
"""

import numpy
import pymeshlab

from readings import write_readings


def read(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(path)
    mesh = meshes.current_mesh()
    topology = meshes.get_topological_measures()
    meshes.compute_normal_per_face()
    local = mesh.vertex_matrix()
    world = mesh.transformed_vertex_matrix()
    faces = mesh.face_matrix()

    # MeshLab has no filter for a vertex's degree: count the distinct edges of its faces.
    edges = numpy.unique(numpy.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2)), axis=0)
    lengths = numpy.linalg.norm(local[edges[:, 0]] - local[edges[:, 1]], axis=1)
    angles = corner_angles(local[faces])

    # pymeshlab keeps doubles, so an OBJ keeps its digits; glTF itself stores single precision.
    keeps_digits = path.endswith(".obj") and "-converted." not in path
    stored = numpy.float64 if keeps_digits else numpy.float32
    # On the floor, (x, y) of the domain is (x, 0, -y), and the normal is +y.
    up, across = (1, (0, 2)) if "-floor." in path else (2, (0, 1))
    places = world[:, across] * ((1, -1) if up == 1 else (1, 1))
    step = float(numpy.spacing(stored(numpy.abs(local).max())))
    return {
        "meshes": meshes.mesh_number(),
        "vertices": mesh.vertex_number(),
        "faces": mesh.face_number(),
        "non_manifold_edges": topology["non_two_manifold_edges"],
        "boundary_edges": topology["boundary_edges"],
        "components": topology["connected_components_number"],
        "max_degree": int(numpy.bincount(edges.ravel()).max()),
        # A face without area has a normal of zeros or NaN and counts as turned away too.
        "faces_turned_away": int(numpy.sum(~(mesh.face_normal_matrix()[:, up] > 0))),
        "area": meshes.get_geometric_measures()["surface_area"],
        "min_angle": float(angles.min()),
        "max_angle": float(angles.max()),
        "bounds": [places.min(axis=0).tolist(), places.max(axis=0).tolist()],
        "shortest_edge": float(lengths.min()),
        "shape_step": step,
        "place_step": step,
        "line_segments": mesh.edge_number(),
        "has_colors": has_colors(mesh),
    }


def has_colors(mesh):
    """Whether vertices differ in color; MeshLab gives those of a plain GLB one color."""
    return mesh.has_vertex_color() and len(numpy.unique(mesh.vertex_color_matrix(), axis=0)) > 1


def corner_angles(triangles):
    """The three angles of every triangle, in degrees."""
    ahead = numpy.roll(triangles, -1, axis=1) - triangles
    behind = numpy.roll(triangles, 1, axis=1) - triangles
    sines = numpy.linalg.norm(numpy.cross(ahead, behind), axis=2)
    cosines = numpy.sum(ahead * behind, axis=2)
    return numpy.degrees(numpy.arctan2(sines, cosines))


if __name__ == "__main__":
    write_readings(read)
