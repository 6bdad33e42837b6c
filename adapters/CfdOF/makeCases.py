#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Mesh cases of CfdOF, made in FreeCAD without its windows: see Alltest."""

import os

import FreeCAD
import withoutWindows

from CfdOF import CfdAnalysis, CfdTools
from CfdOF.Mesh import CfdMesh, CfdMeshRefinement, CfdMeshTools
from CfdOF.Solve import CfdFluidBoundary

WALLS = ("Face3", "Face4", "Face5", "Face6")


class Duct:
    """A box of 400 x 100 x 100 mm, with inlet, outlet and walls"""

    def __init__(self, name):
        self.name = name
        self.document = FreeCAD.newDocument(name)
        self.box = self.document.addObject("Part::Box", "Box")
        self.box.Length, self.box.Width, self.box.Height = 400, 100, 100
        self.document.recompute()
        self.analysis = CfdAnalysis.makeCfdAnalysis("CfdAnalysis")
        CfdTools.setActiveAnalysis(self.analysis)
        self.analysis.OutputPath = os.path.join(os.environ["CFDOF_CASES"], name)

        self.mesh = CfdMesh.makeCfdMesh("Box_Mesh")
        self.mesh.Part = self.box
        self.mesh.MeshUtility = "harmonicPrismMesh"
        self.mesh.CharacteristicLengthMax = "20 mm"
        self.analysis.addObject(self.mesh)
        self.boundary("inlet", "inlet", "uniformVelocityInlet", ["Face1"])
        self.boundary("outlet", "outlet", "staticPressureOutlet", ["Face2"])
        self.boundary("walls", "wall", "fixedWall", WALLS)

    def boundary(self, name, kind, subtype, faces, body=None):
        boundary = CfdFluidBoundary.makeCfdFluidBoundary(name)
        boundary.BoundaryType = kind
        boundary.BoundarySubType = subtype
        boundary.ShapeRefs = [(body or self.box, faces)]
        self.analysis.addObject(boundary)

    def refinement(self, name, faces, layers, body=None):
        refinement = CfdMeshRefinement.makeCfdMeshRefinement(self.mesh, name)
        refinement.ShapeRefs = [(body or self.box, faces)]
        refinement.RelativeLength = 1
        refinement.NumberLayers = layers
        refinement.ExpansionRatio = 1.2
        refinement.FirstLayerHeight = "1 mm"
        return refinement

    def vane(self):
        """A sheet along the duct"""
        vane = self.document.addObject("Part::Plane", "Vane")
        vane.Length, vane.Width = 100, 60
        vane.Placement = FreeCAD.Placement(
            FreeCAD.Vector(150, 50, 20), FreeCAD.Rotation(
                FreeCAD.Vector(1, 0, 0), 90))
        self.document.recompute()
        return vane

    def write(self):
        self.document.recompute()
        try:
            CfdMeshTools.CfdMeshTools(self.mesh).writeMesh()
        except RuntimeError as error:
            print("%s: %s" % (self.name, error))


FreeCAD.ParamGet(CfdTools.getPreferencesLocation()).SetString(
    "InstallationPath", os.environ["WM_PROJECT_DIR"])

duct = Duct("duct")
duct.refinement("layers", WALLS, 5)
duct.write()

vane = Duct("vane")
sheet = vane.vane()
vane.refinement("layers", WALLS, 5)
vane.refinement("vaneLayers", ["Face1"], 5, sheet)
vane.boundary("vane", "wall", "fixedWall", ["Face1"], sheet)
vane.write()

fine = Duct("fine")
fine.refinement("layers", WALLS, 5).RelativeLength = 0.7
ball = fine.document.addObject("Part::Sphere", "Ball")
ball.Radius = 20
ball.Placement.Base = FreeCAD.Vector(200, 50, 50)
fine.document.recompute()
inner = fine.refinement("inner", ["Solid1"], 0, ball)
inner.Internal = True
inner.RelativeLength = 0.25
fine.write()

porous = Duct("porous")
porous.refinement("layers", WALLS, 5)
porous.boundary("screen", "baffle", "porousBaffle", ["Face1"], porous.vane())
porous.write()

bare = Duct("bare")
bare.write()
