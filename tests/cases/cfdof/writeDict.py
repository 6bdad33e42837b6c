#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Writes system/harmonicPrismMeshDict of refinements as CfdOF has them."""

import sys
import types

from CfdOF.Mesh import CfdHarmonicPrismMesh, harmonicPrismMesh


class Length:
    """A length in metres, as FreeCAD has quantities"""

    def __init__(self, metres):
        self.metres = metres

    def getValueAs(self, unit):
        assert unit == "m"
        return types.SimpleNamespace(Value=self.metres)


def refinement(name, layers, height, **others):
    values = dict(Name=name, Label=name, NumberLayers=layers,
                  ExpansionRatio=1.2, FirstLayerHeight=Length(height),
                  RefinementThickness=Length(0), RelativeLength=1.0,
                  Internal=False, Extrusion=False, MovingMeshRegion=False)
    return types.SimpleNamespace(**dict(values, **others))


def refuses(text, refinements, boundaries=()):
    try:
        CfdHarmonicPrismMesh._check(refinements, boundaries)
    except RuntimeError as error:
        assert text in str(error), error
    else:
        sys.exit("accepted: " + text)


walls = refinement("walls", 5, 1e-3)
refuses("needs a surface mesh refinement", [refinement("none", 0, 0)])
refuses("needs a surface mesh refinement",
        [refinement("inner", 5, 0, Internal=True)])
refuses("neither extrusions", [walls, refinement("e", 0, 0, Extrusion=True)])
refuses("a baffle lets fluid through", [walls], [
    types.SimpleNamespace(BoundaryType="baffle", Label="screen")])

sheets = {} if sys.argv[1] == "none" else {
    sys.argv[1]: refinement("sheet", 5, 0)}
case = CfdHarmonicPrismMesh.PrismCase(
    "duct.brep", 0.02, [walls],
    {"patch_1_0": ([0], None), "patch_2_0": ([1], None),
     "patch_3_1": ([2, 3, 4, 5], walls)}, sheets, [0.01, 0.05, 0.04])
harmonicPrismMesh.write_dictionary("system/harmonicPrismMeshDict",
                                   case.entries())
