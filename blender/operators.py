# SPDX-License-Identifier: GPL-3.0-or-later
"""The operators: from a selection to loops, from triangles to faces. The work is in ``loops``."""

import math

import bmesh
import bpy
import mindeg
from bpy.props import BoolProperty, FloatProperty, IntProperty
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from mathutils.kdtree import KDTree

from . import loops, working


class _EditMesh:
    """Operators on a mesh in edit mode, with undo."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "EDIT_MESH"

    def execute(self, context):
        return self.ended(context, lambda bm: self.work(bm))

    def ended(self, context, work):
        """Does work on the mesh, and says what was done, or what is wrong."""
        mesh = context.edit_object.data
        try:
            words = work(_indexed(mesh))
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        bmesh.update_edit_mesh(mesh)
        self.report({"INFO"}, words)
        return {"FINISHED"}


class _LongWork(_EditMesh):
    """Operators whose work can take long: ``plan`` gives a task, which knows only arrays, and what to do with the mesh after it.

    Called from a menu, the task runs on a thread of its own: the status bar tells how far it is, and Esc cancels it.
    """

    def work(self, bm):
        task, finish = self.plan(bm)
        return finish(bm, task())

    def invoke(self, context, _event):
        try:
            task, self._finish = self.plan(_indexed(context.edit_object.data))
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        self._work = working.Work(task)
        # Most are over before anybody could see a bar.
        if self._work.is_over(wait=0.3):
            return self._over(context)
        manager = context.window_manager
        self._timer = manager.event_timer_add(0.1, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self._work.cancel()
        if not self._work.is_over():
            context.workspace.status_text_set(f"{self._work.words} (Esc cancels)")
            # Nothing else gets the event: the mesh stays as it is until the work is over.
            return {"RUNNING_MODAL"}
        context.workspace.status_text_set(None)
        context.window_manager.event_timer_remove(self._timer)
        return self._over(context)

    def _over(self, context):
        if self._work.is_cancelled:
            self.report({"INFO"}, "Cancelled; the mesh is as it was")
            return {"CANCELLED"}
        return self.ended(context, lambda bm: self._finish(bm, self._work.result()))


def _indexed(mesh):
    bm = bmesh.from_edit_mesh(mesh)
    for sequence in (bm.verts, bm.edges, bm.faces):
        sequence.index_update()
        sequence.ensure_lookup_table()
    return bm


def _open_loops(bm):
    """The loops of the selected edges that have a free side, turned so that new faces agree with those beside; and how many that
    are no holes are not among them: rims of flat sheets, unless they alone are selected, and the borders of single faces.
    """
    edges = [edge for edge in bm.edges if edge.select and len(edge.link_faces) < 2]
    beside = {
        (corner.vert.index, corner.link_loop_next.vert.index): corner.face for edge in edges for corner in edge.link_loops
    }
    found = loops.directed_loops(beside)
    if sum(map(len, found)) < len(edges):
        # Edges without a face, or chains; a chain is refused.
        return [_oriented(bm, loop) for loop in loops.loops_of([[v.index for v in edge.verts] for edge in edges])], 0
    normals = [[beside[pair].normal for pair in zip(loop, [*loop[1:], loop[0]])] for loop in found]
    rims = [loops.is_rim([bm.verts[vertex].co for vertex in loop], of_loop) for loop, of_loop in zip(found, normals)]
    if all(rims) and not any(face.select for face in bm.faces):
        rims = [False] * len(found)
    for index, loop in enumerate(found):
        around = {beside[pair] for pair in zip(loop, [*loop[1:], loop[0]])}
        rims[index] |= len(around) == 1 and len(next(iter(around)).verts) == len(loop)
    return [[loop[0], *reversed(loop[1:])] for loop, is_rim in zip(found, rims) if not is_rim], sum(rims)


def _oriented(bm, loop):
    """The loop, turned so that new faces agree with the face beside its first edge."""
    edge = bm.edges.get((bm.verts[loop[0]], bm.verts[loop[1]]))
    runs_forward = edge is not None and edge.link_loops and edge.link_loops[0].vert.index == loop[0]
    return [loop[0], *reversed(loop[1:])] if runs_forward else loop


def _edges_at(bm, patches):
    """The edges at the vertices of patches, as pairs of indices."""
    edges = {edge for patch in patches for name in patch.names for edge in bm.verts[name].link_edges}
    return [[vertex.index for vertex in edge.verts] for edge in edges]


def _find_triangles_beside(bm, patches, replaced=()):
    """For patches with points inside: the corners of the triangles at their vertices, without those of faces that go."""
    faces = {face for patch in patches for name in patch.names for face in bm.verts[name].link_faces}
    faces -= {bm.faces[face] for face in replaced}
    at = {}
    for corners in bm.calc_loop_triangles() if faces else ():
        if corners[0].face in faces:
            triangle = [tuple(corner.vert.co) for corner in corners]
            # A triangle has three corners that no other has.
            key = tuple(corner.index for corner in corners)
            for corner in corners:
                at.setdefault(corner.vert.index, {})[key] = triangle
    for patch in patches:
        beside = {key: triangle for name in patch.names for key, triangle in at.get(name, {}).items()}
        patch.around = [point for triangle in beside.values() for point in triangle]


def _corners_beside(vertices):
    """For vertices of a hole the corner of a face beside it."""
    found = {}
    for vertex in vertices:
        for edge in vertex.link_edges:
            if len(edge.link_loops) == 1:
                corner = edge.link_loops[0]
                found[vertex] = corner if corner.vert == vertex else corner.link_loop_next
                break
    return found


def _add_faces(bm, patch, vertices, corners, like, between):
    """Makes the faces of a patch, selected, with the material of the face ``like``. UVs, colors and all else of a corner come from
    ``corners`` by vertex, and at new points lie between those of the face ``between``, or without it are those of the nearest vertex that
    has some. Faces that are there already stay.
    """
    vertices = [*vertices, *(bm.verts.new(point) for point in patch.new)]
    if between is None and corners and patch.new:
        known = list(corners)
        tree = KDTree(len(known))
        for place, vertex in enumerate(known):
            tree.insert(vertex.co, place)
        tree.balance()
        nearest = {vertex: corners[known[tree.find(vertex.co)[1]]] for vertex in vertices[-len(patch.new) :]}
        corners = {**nearest, **corners}
    made = 0
    for triangle in patch.triangles:
        of_face = [vertices[place] for place in triangle]
        if bm.faces.get(of_face) is not None:
            continue
        face = bm.faces.new(of_face) if like is None else bm.faces.new(of_face, like)
        for corner in face.loops:
            if corner.vert in corners:
                corner.copy_from(corners[corner.vert])
            elif between is not None:
                corner.copy_from_face_interp(between, True, False)
        face.select = True
        made += 1
    return made


def _replace_face(bm, patch, vertices, face):
    corners = {corner.vert: corner for corner in face.loops}
    _add_faces(bm, patch, vertices, corners, face, face)
    bm.faces.remove(face)


def _fill_hole(bm, patch, vertices):
    corners = _corners_beside(vertices)
    like = next((corner.face for corner in corners.values()), None)
    between = None
    outer = vertices[: len(patch.rings[0])]
    if patch.new and like is not None and bm.faces.get(outer) is None:
        # For as long as new points take their values from it.
        between = bm.faces.new(outer, like)
        for corner in between.loops:
            corner.copy_from(corners[corner.vert])
    _add_faces(bm, patch, vertices, corners, like, between)
    if between is not None:
        bm.faces.remove(between)


def _goals():
    """A property for each goal of ``Domain.mesh`` with a number; 0 is none."""
    properties = {}
    for goal in mindeg.GOALS:
        words = {"name": goal["key"].replace("_", " ").title(), "description": goal["help"].split(". ")[0]}
        if goal["value"] == "degree":
            words["description"] += "; 0: any number. It goes before the share of the angle"
            properties[goal["key"]] = IntProperty(**words, min=0, default=0)
        elif goal["value"] == "share":
            words["description"] += "; 0: the least degree, whatever the angle"
            # Few artists want the least degree at any angle.
            properties[goal["key"]] = FloatProperty(**words, min=0, max=1, default=0.95, subtype="FACTOR")
    return properties


GOALS = _goals()


class MESH_OT_mindeg_fill(_LongWork, bpy.types.Operator):
    """Fill the holes that selected edges bound; without a hole, retriangulate the selected faces. Few edges meet at every vertex"""

    bl_idname = "mesh.mindeg_fill"
    bl_label = "Fill with Few Edges"

    interior: BoolProperty(name="Interior Points", description="Add points inside", default=False)

    def plan(self, bm):
        holes, rims = _open_loops(bm)
        faces = []
        if not holes:
            faces = [face.index for face in bm.faces if face.select and len(face.verts) > 3]
        groups = [[holes[ring] for ring in group] for group in loops.nested([_points(bm, ring) for ring in holes])]
        groups += [[[vertex.index for vertex in bm.faces[face].verts]] for face in faces]
        if not groups:
            more = "; the rim of a flat sheet stays open, unless it alone is selected" if rims else ""
            raise ValueError(f"no hole and no face with more than 3 corners is selected{more}")
        patches = [
            loops.Patch([name for ring in group for name in ring], [_points(bm, ring) for ring in group]) for group in groups
        ]
        if self.interior:
            _find_triangles_beside(bm, patches, faces)
        edges = _edges_at(bm, patches)
        wanted = {"interior": self.interior, **{key: value for key in GOALS if (value := getattr(self, key))}}

        def task():
            loops.fill_all(patches, edges, **wanted)
            return patches

        def finish(bm, patches):
            words = loops.said(patches, "face" if faces else "hole")
            # Vertices and faces are made on the way, so no index counts after that.
            vertices = [[bm.verts[name] for name in patch.names] for patch in patches]
            replaced = [bm.faces[face] for face in faces]
            for index, patch in enumerate(patches):
                if patch.fault is None and faces:
                    _replace_face(bm, patch, vertices[index], replaced[index])
                elif patch.fault is None:
                    _fill_hole(bm, patch, vertices[index])
            bm.normal_update()
            return words

        return task, finish


MESH_OT_mindeg_fill.__annotations__.update(GOALS)


def _points(bm, names):
    """Copies, which no thread needs Blender for."""
    return [tuple(bm.verts[name].co) for name in names]


class MESH_OT_mindeg_bridge(_LongWork, bpy.types.Operator):
    """Join two selected loops of edges, of equal or unequal counts, by triangles"""

    bl_idname = "mesh.mindeg_bridge"
    bl_label = "Bridge with Few Edges"

    interior: BoolProperty(name="Interior Points", description="Put points between loops that are far apart", default=False)
    max_degree: IntProperty(
        name="Maximum Degree", description="The most edges of a vertex; 0 for the least possible", min=0, default=0
    )

    def plan(self, bm):
        edges = [edge for edge in bm.edges if edge.select and len(edge.link_faces) < 2]
        if not edges:
            raise ValueError("no open edge is selected; select the edges of two holes")
        found = [_oriented(bm, loop) for loop in loops.loops_of([[v.index for v in edge.verts] for edge in edges])]
        if len(found) != 2:
            raise ValueError(f"{len(found)} {'loop is' if len(found) == 1 else 'loops are'} selected; select two")
        patch = loops.Patch([*found[0], *found[1]], [_points(bm, loop) for loop in found])
        external = [len(bm.verts[name].link_edges) for name in patch.names]
        wanted = {"interior": self.interior, "max_degree": self.max_degree or None}
        if self.interior:
            _find_triangles_beside(bm, [patch])

        def task():
            loops.bridge(patch, external, **wanted)
            return patch

        def finish(bm, patch):
            vertices = [bm.verts[name] for name in patch.names]
            corners = _corners_beside(vertices)
            like = next((corner.face for corner in corners.values()), None)
            made = _add_faces(bm, patch, vertices, corners, like, None)
            bm.normal_update()
            return f"Joined 2 loops with {made} triangles: degree {patch.degree} ({patch.words}), minimum angle {loops.angle(patch.min_angle)}"

        return task, finish


class MESH_OT_mindeg_remesh(_LongWork, bpy.types.Operator):
    """Mesh the whole surface anew with 5 to 7 edges at every vertex off its boundary; sharp edges stay"""

    bl_idname = "mesh.mindeg_remesh"
    bl_label = "Remesh with Few Poles"

    size: FloatProperty(
        name="Size", description="The length of edges; 0 for what suits the mesh", min=0, default=0, subtype="DISTANCE"
    )
    feature_angle: FloatProperty(
        name="Sharp Angle",
        description="Edges that turn by more than this stay edges",
        min=0,
        max=math.pi,
        default=math.radians(40),
        subtype="ANGLE",
    )
    keep_boundary: BoolProperty(
        name="Keep Boundary", description="Keep the vertices of open borders where they are", default=False
    )

    def plan(self, bm):
        points = _points(bm, range(len(bm.verts)))
        triangles = [[corner.vert.index for corner in triangle] for triangle in bm.calc_loop_triangles()]
        if not triangles:
            raise ValueError("the mesh has no face")
        wanted = {
            "size": self.size or None,
            "feature_angle": math.degrees(self.feature_angle),
            "keep_boundary": self.keep_boundary,
        }

        def task():
            return mindeg.remesh(points, triangles, **wanted)

        def finish(bm, made):
            old, tree = list(bm.faces), BVHTree.FromBMesh(bm)
            gone = list(bm.verts)
            vertices = [bm.verts.new((*point, 0)[:3]) for point in made.points.tolist()]
            for triangle in made.triangles:
                of_face = [vertices[vertex] for vertex in triangle]
                center = sum((vertex.co for vertex in of_face), Vector()) / 3
                # All three corners from one face, so that no triangle is torn along a seam.
                like = old[tree.find_nearest(center)[2]]
                face = bm.faces.new(of_face, like)
                for corner in face.loops:
                    corner.copy_from_face_interp(like, False, False)
                face.select = True
            for vertex in gone:
                bm.verts.remove(vertex)
            bm.normal_update()
            off = len(made.report["violations"])
            poles = "no pole" if off == 0 else f"{off} {'vertex' if off == 1 else 'vertices'} with other counts"
            return f"Made {len(vertices)} vertices with 5 to 7 edges, {poles}, minimum angle {loops.angle(made.min_angle)}"

        return task, finish


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
        return f"{poles} {'vertex has' if poles == 1 else 'vertices have'} more than {self.above} edges"


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
            raise ValueError("the mesh has no face")
        found = mindeg.inspect(np.array([vertex.co for vertex in bm.verts], dtype=float), triangles)
        degree = max(len(vertex.link_edges) for face in chosen for vertex in face.verts)
        return f"{len(triangles)} triangles, degree {degree}, minimum angle {loops.angle(found['min_angle'])}"


OPERATORS = [
    MESH_OT_mindeg_fill,
    MESH_OT_mindeg_bridge,
    MESH_OT_mindeg_remesh,
    MESH_OT_mindeg_select_poles,
    MESH_OT_mindeg_report,
]


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
