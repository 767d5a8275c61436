"""Parts as a CAD kernel tessellates them: sharp edges, fillets, bores, thin long triangles."""

import math

from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.StlAPI import StlAPI_Writer
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS


def cylinder(at, radius, height, direction=(0, 0, 1)):
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(*at), gp_Dir(*direction)), radius, height).Shape()


def flange():
    shape = cylinder((0, 0, 0), 50, 12)
    shape = BRepAlgoAPI_Fuse(shape, cylinder((0, 0, 12), 25, 30)).Shape()
    shape = BRepAlgoAPI_Cut(shape, cylinder((0, 0, -1), 18, 50)).Shape()
    for k in range(6):
        turn = math.tau * k / 6
        bore = cylinder((38 * math.cos(turn), 38 * math.sin(turn), -1), 5, 20)
        shape = BRepAlgoAPI_Cut(shape, bore).Shape()
    return shape


def block():
    """A block with rounded edges and two bores that meet inside."""
    shape = BRepPrimAPI_MakeBox(60.0, 40.0, 30.0).Shape()
    fillet = BRepFilletAPI_MakeFillet(shape)
    edges = TopExp_Explorer(shape, TopAbs_EDGE)
    while edges.More():
        fillet.Add(5.0, TopoDS.Edge(edges.Current()))
        edges.Next()
    shape = fillet.Shape()
    shape = BRepAlgoAPI_Cut(shape, cylinder((30, 20, -1), 8, 40)).Shape()
    return BRepAlgoAPI_Cut(shape, cylinder((-1, 20, 15), 6, 70, (1, 0, 0))).Shape()


def angle_bracket():
    shape = BRepPrimAPI_MakeBox(60.0, 40.0, 6.0).Shape()
    shape = BRepAlgoAPI_Fuse(shape, BRepPrimAPI_MakeBox(6.0, 40.0, 50.0).Shape()).Shape()
    for at, direction in [((40, 12, -1), (0, 0, 1)), ((40, 28, -1), (0, 0, 1)), ((-1, 20, 32), (1, 0, 0))]:
        shape = BRepAlgoAPI_Cut(shape, cylinder(at, 5, 20, direction)).Shape()
    return shape


PARTS = {"flange": flange, "block": block, "angle bracket": angle_bracket}


def write_stl(make, path):
    """The part through a STEP file, as users get theirs, then its triangles as STL."""
    step = path.with_suffix(".step")
    writer = STEPControl_Writer()
    writer.Transfer(make(), STEPControl_AsIs)
    assert writer.Write(str(step)) == IFSelect_RetDone
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(step)) == IFSelect_RetDone
    reader.TransferRoots()
    shape = reader.OneShape()
    BRepMesh_IncrementalMesh(shape, 0.05, False, 0.3)
    assert StlAPI_Writer().Write(shape, str(path))
