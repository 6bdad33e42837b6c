#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Prints what the panel of CfdOF says when a mesh case has ended: see Alltest.
CFDOF_CASE is the mesh case, CFDOF_STATUS the exit status of Allmesh."""

import os
from unittest import mock

import FreeCAD
import withoutWindows

if not hasattr(FreeCAD, "Qt"):
    FreeCAD.Qt = mock.MagicMock()

from CfdOF.Mesh import TaskPanelCfdMesh

panel = mock.MagicMock()
panel.mesh_obj.MeshUtility = "harmonicPrismMesh"
panel.mesh_obj.Proxy.cart_mesh.mesh_case_dir = os.environ["CFDOF_CASE"]
TaskPanelCfdMesh.TaskPanelCfdMesh.meshFinished(
    panel, int(os.environ["CFDOF_STATUS"]))
for call in panel.consoleMessage.call_args_list:
    print("panel:", *call.args)
