#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Lets CfdOF run in a FreeCAD without windows: to be imported before CfdOF."""

import builtins
import os
import sys

import FreeCADGui
import PySide2.QtWidgets

# What CfdOF expects of a FreeCAD that is newer, and has windows
if not hasattr(FreeCADGui, "addCommand"):
    FreeCADGui.addCommand = lambda *arguments: None
builtins.FreeCADGui = FreeCADGui
sys.modules["PySide.QtWidgets"] = PySide2.QtWidgets
sys.path.insert(0, os.environ["CFDOF"])
