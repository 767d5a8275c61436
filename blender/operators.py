# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators: from a selection to a loop, from triangles to faces. The work is in ``loops``."""

import bmesh
import bpy
import mindeg
from bpy.props import BoolProperty, FloatProperty, IntProperty

from . import loops


class _EditMesh:
    """Operators on a mesh in edit mode, with undo."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "EDIT_MESH"

    def execute(self, context):
        mesh = context.edit_object.data
        bm = bmesh.from_edit_mesh(mesh)
        bm.verts.index_update()
        bm.verts.ensure_lookup_table()
        try:
            words = self.work(bm)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        bmesh.update_edit_mesh(mesh)
        self.report({"INFO"}, words)
        return {"FINISHED"}


def _selected_loops(bm):
    """The loops of the selected edges that have a free side."""
    edges = [edge for edge in bm.edges if edge.select and len(edge.link_faces) < 2]
    if not edges:
        raise ValueError("no open edge is selected; select the edges of a hole, or faces")
    return loops.loops_of([[vertex.index for vertex in edge.verts] for edge in edges])


def _oriented(bm, loop):
    """The loop, turned so that new faces agree with the face beside its first edge."""
    a, b = bm.verts[loop[0]], bm.verts[loop[1]]
    edge = bm.edges.get((a, b))
    if edge is not None and edge.link_loops:
        runs_forward = edge.link_loops[0].vert.index == loop[0]
        if runs_forward:
            return [loop[0], *reversed(loop[1:])]
    return loop


def _add_faces(bm, names, triangles, like=None):
    """Makes faces of triangles of the named vertices, selected; those that are there already stay."""
    made = []
    for triangle in triangles:
        vertices = [names[vertex] for vertex in triangle]
        if bm.faces.get(vertices) is not None:
            continue
        face = bm.faces.new(vertices)
        if like is not None:
            face.material_index = like.material_index
            face.smooth = like.smooth
        face.select = True
        made.append(face)
    return made


def _goals():
    """A property for each goal of ``Domain.mesh`` with a number; 0 is none."""
    properties = {}
    for goal in mindeg.GOALS:
        words = {"name": goal["key"].replace("_", " ").title(), "description": goal["help"].split(". ")[0]}
        if goal["value"] == "degree":
            properties[goal["key"]] = IntProperty(**words, min=0, default=0)
        elif goal["value"] == "share":
            properties[goal["key"]] = FloatProperty(**words, min=0, max=1, default=0, subtype="FACTOR")
    return properties


GOALS = _goals()


class MESH_OT_mindeg_fill(_EditMesh, bpy.types.Operator):
    """Fill selected loops of edges, or retriangulate selected faces, with few edges at every vertex"""

    bl_idname = "mesh.mindeg_fill"
    bl_label = "Fill with Least Degree"

    interior: BoolProperty(name="Interior Points", description="Add points inside", default=False)

    def work(self, bm):
        faces = [face for face in bm.faces if face.select and len(face.verts) > 3]
        done = [self.fill_face(bm, face) for face in faces]
        if not faces:
            found = _selected_loops(bm)
            rings = [[bm.verts[vertex].co for vertex in loop] for loop in found]
            # Vertices are made on the way, so no index counts after that.
            groups = [
                [[bm.verts[vertex] for vertex in _oriented(bm, found[ring])] for ring in group]
                for group in loops.nested(rings)
            ]
            done = [self.fill_rings(bm, group) for group in groups]
        return "; ".join(done)

    def wanted(self):
        goals = {key: getattr(self, key) for key in GOALS}
        return {"interior": self.interior, **{key: value for key, value in goals.items() if value}}

    def fill_face(self, bm, face):
        names = list(face.verts)
        external = [len(vertex.link_edges) for vertex in names]
        rings = [[vertex.co for vertex in names]]
        new, triangles, words = loops.fill(rings, external=external, **self.wanted())
        like = face
        names += [bm.verts.new(point) for point in new]
        made = _add_faces(bm, names, triangles, like)
        bm.faces.remove(like)
        bm.normal_update()
        return f"{len(made)} triangles, {words}"

    def fill_rings(self, bm, rings):
        names = [vertex for ring in rings for vertex in ring]
        index = {vertex: position for position, vertex in enumerate(names)}
        external = [len(vertex.link_edges) for vertex in names]
        excluded = [
            [index[vertex] for vertex in edge.verts]
            for edge in {edge for vertex in names for edge in vertex.link_edges}
            if all(vertex in index for vertex in edge.verts)
        ]
        points = [[vertex.co for vertex in ring] for ring in rings]
        new, triangles, words = loops.fill(points, external=external, excluded=excluded, **self.wanted())
        names += [bm.verts.new(point) for point in new]
        made = _add_faces(bm, names, triangles)
        bm.normal_update()
        return f"{len(made)} triangles, {words}"


MESH_OT_mindeg_fill.__annotations__.update(GOALS)


class MESH_OT_mindeg_bridge(_EditMesh, bpy.types.Operator):
    """Join two selected loops of edges, of equal or unequal counts, by one strip of triangles"""

    bl_idname = "mesh.mindeg_bridge"
    bl_label = "Bridge with Least Degree"

    max_degree: IntProperty(
        name="Maximum Degree", description="The most edges of a vertex; 0 for the least possible", min=0, default=0
    )

    def work(self, bm):
        found = _selected_loops(bm)
        if len(found) != 2:
            raise ValueError(f"{len(found)} loops are selected; select two")
        first = _oriented(bm, found[0])
        names = [bm.verts[index] for index in [*first, *found[1]]]
        points = [vertex.co for vertex in names]
        triangles, words = loops.bridge(
            points[: len(first)],
            points[len(first) :],
            external=[len(vertex.link_edges) for vertex in names],
            max_degree=self.max_degree or None,
        )
        made = _add_faces(bm, names, triangles)
        bm.normal_update()
        return f"{len(made)} triangles, {words}"


class MESH_OT_mindeg_select_poles(_EditMesh, bpy.types.Operator):
    """Select the vertices with more edges than a limit"""

    bl_idname = "mesh.mindeg_select_poles"
    bl_label = "Select Poles"

    above: IntProperty(name="Above", description="Select vertices with more edges", min=0, default=6)

    def work(self, bm):
        poles = 0
        for vertex in bm.verts:
            is_pole = len(vertex.link_edges) > self.above
            vertex.select = is_pole
            poles += is_pole
        bm.select_mode = {"VERT"}
        bm.select_flush_mode()
        return f"{poles} vertices have more than {self.above} edges"


class MESH_OT_mindeg_report(_EditMesh, bpy.types.Operator):
    """Say the degrees and the minimum angle of the selected faces, or of all"""

    bl_idname = "mesh.mindeg_report"
    bl_label = "Report Degrees and Angles"

    def work(self, bm):
        import numpy as np

        chosen = {face for face in bm.faces if face.select} or set(bm.faces)
        triangles = [
            [corner.vert.index for corner in triangle]
            for triangle in bm.calc_loop_triangles()
            if triangle[0].face in chosen
        ]
        if not triangles:
            raise ValueError("the mesh has no faces")
        found = mindeg.inspect(np.array([vertex.co for vertex in bm.verts], dtype=float), triangles)
        degree = max(len(vertex.link_edges) for face in chosen for vertex in face.verts)
        return f"{len(triangles)} triangles, degree {degree}, minimum angle {found['min_angle']:.1f}°"


OPERATORS = [MESH_OT_mindeg_fill, MESH_OT_mindeg_bridge, MESH_OT_mindeg_select_poles, MESH_OT_mindeg_report]


def _menu(self, _context):
    self.layout.separator()
    for operator in OPERATORS:
        self.layout.operator(operator.bl_idname)


def register():
    for operator in OPERATORS:
        bpy.utils.register_class(operator)
    bpy.types.VIEW3D_MT_edit_mesh.append(_menu)


def unregister():
    bpy.types.VIEW3D_MT_edit_mesh.remove(_menu)
    for operator in reversed(OPERATORS):
        bpy.utils.unregister_class(operator)
