#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""The mesher harmonicPrismMesh in CfdOF, the workbench of FreeCAD: writes the
dictionary and the CAD files of a mesh case, and says what became of the run. See
README.md."""

import html
import json
import os
import re

from CfdOF.Mesh import harmonicPrismMesh


def _metres(quantity):
    return quantity.getValueAs("m").Value


def _relative_size(refinement):
    return min(max(refinement.RelativeLength, 0.001), 1.0)


def _layers(refinement):
    """Entries of layers for a patch; none without a refinement with layers"""
    if refinement is None or refinement.NumberLayers == 0:
        return {"nSurfaceLayers": 0}
    entries = {"nSurfaceLayers": refinement.NumberLayers,
               "expansionRatio": refinement.ExpansionRatio}
    height = _metres(refinement.FirstLayerHeight)
    if height > 0:
        entries["firstLayerThickness"] = height
    else:
        entries.update(relativeSizes=True, finalLayerThickness=0.5)
    return entries


def _check(refinements, boundaries):
    for boundary in boundaries:
        if boundary.BoundaryType == "baffle":
            raise RuntimeError(
                "Boundary '{}': a baffle lets fluid through, and "
                "harmonicPrismMesh makes walls. For a wall of no thickness "
                "take a boundary of type wall, and a mesh refinement with "
                "layers on its faces.".format(boundary.Label))
    for refinement in refinements:
        if refinement.Extrusion or refinement.MovingMeshRegion:
            raise RuntimeError(
                "Mesh refinement '{}': harmonicPrismMesh has neither "
                "extrusions nor moving regions.".format(refinement.Label))
    if not any(r.NumberLayers > 0 and not r.Internal for r in refinements):
        raise RuntimeError("harmonicPrismMesh needs a surface mesh refinement "
                           "with boundary layers.")


class PrismCase:
    """Patches, sheets and sizes of a mesh case. Lengths are in metres.

    file:        CAD file of the part, in millimetres; its faces count from 1
    size:        largest length of edges
    refinements: CfdOF's mesh refinements
    patches:     name: (labels of the faces from 0, refinement or None)
    sheets:      names of walls of no thickness: refinement. The CAD file of a
                 sheet is <name>.brep.
    point:       a point in the fluid; for sheets alone
    """

    def __init__(self, file, size, refinements, patches, sheets, point):
        self.file = file
        self.size = size
        self.refinements = refinements
        self.patches = patches
        self.sheets = sheets
        self.point = point

    def surface(self):
        patches = {name: {"file": self.file, "solid": "face({})".format(
            "|".join(str(face + 1) for face in faces))}
            for name, (faces, _) in self.patches.items()}
        entries = {"scale": 0.001, "cad": {"maxEdge": self.size},
                   "patches": patches}
        if self.sheets:
            patches.update({name: {"file": name + ".brep"}
                            for name in self.sheets})
            return dict(entries, baffles=list(self.sheets), files=[self.file] + [
                name + ".brep" for name in self.sheets])
        sizes = {name: {"maxEdge": self.size * _relative_size(refinement)}
                 for name, (_, refinement) in self.patches.items()
                 if refinement is not None and _relative_size(refinement) < 1}
        return dict(entries, file=self.file, fluid="inside", repair="stitch",
                    remesh={"maxEdge": self.size, "patches": sizes})

    def layers(self):
        patches = {name: _layers(refinement)
                   for name, (_, refinement) in self.patches.items()}
        patches.update({name: _layers(refinement)
                        for name, refinement in self.sheets.items()})
        most = max(patches.values(), key=lambda p: p["nSurfaceLayers"])
        return dict(most, patches=patches)

    def far_field(self):
        regions = {}
        for refinement in self.refinements:
            size = self.size * _relative_size(refinement)
            near = _metres(refinement.RefinementThickness)
            region = {"geometry": {"type": "triSurfaceMesh",
                                   "file": refinement.Name + ".stl"},
                      "cellSize": size}
            if refinement.Internal:
                regions[refinement.Name] = dict(region, mode="inside")
            elif near > 0:
                regions[refinement.Name] = dict(region, mode="distance",
                                                distance=near)
        return {"type": "tet", "maxCellSize": self.size, "regions": regions}

    def entries(self):
        """The dictionary of harmonicPrismMesh"""
        entries = {"surface": self.surface(), "layers": self.layers(),
                   "farField": self.far_field()}
        if self.sheets:
            entries["regions"] = {"fluid": {"inside": self.point}}
        return entries


def addSheet(tools, refinement, name, shape):
    """Notes a wall that is no face of the part: with layers on both sides.
    tools: CfdMeshTools; refinement: its label"""
    tools.prism_sheets = getattr(tools, "prism_sheets", {})
    tools.prism_sheets[name] = (refinement, shape)


def writeCase(tools, refinements, boundaries, gmsh):
    """Writes CAD files and system/harmonicPrismMeshDict of CfdMeshTools.
    gmsh: the program. Raises RuntimeError if CfdOF's objects ask for something
    that harmonicPrismMesh does not make"""
    _check(refinements, boundaries)

    file = tools.part_obj.Name + "_Geometry.brep"
    tools.part_obj.Shape.exportBrep(os.path.join(tools.triSurfaceDir, file))
    sheets = {}
    for name, (label, shape) in getattr(tools, "prism_sheets", {}).items():
        shape.exportBrep(os.path.join(tools.triSurfaceDir, name + ".brep"))
        sheets[name] = refinements[label]

    patches = {}
    for names, faces in zip(tools.patch_names, tools.patch_faces):
        for label, name in enumerate(names):
            if faces[label]:
                refinement = refinements[label - 1] if label else None
                patches[name] = (faces[label], refinement)

    point = tools.automaticInsidePointDetect() if sheets else ()
    if point is None:
        raise RuntimeError("No point inside of the part was found.")
    case = PrismCase(file, tools.clmax * tools.scale, refinements, patches,
                     sheets, [x * tools.scale for x in point])

    os.makedirs(tools.systemDir, exist_ok=True)
    harmonicPrismMesh.write_dictionary(
        os.path.join(tools.systemDir, "harmonicPrismMeshDict"), case.entries())
    tools.gmsh_settings["Executable"] = gmsh


# Types of CfdOF's colours for the grades of a verdict
_COLOURS = {"good": "Text", "poor": "Warning", "useless": "Error"}


def _read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def _html(text):
    return html.escape(text, quote=False).replace("\n", "<br>")


def _place(fields):
    return "at ({:g} {:g} {:g}) m".format(*fields["place"])


def _refusal(fields):
    lines = [fields["message"]]
    if "place" in fields:
        lines.append(_place(fields))
    remedy = fields.get("remedy", "")
    if " ".join(remedy.split()) not in " ".join(lines[0].split()):
        lines.append(remedy)
    return [(_html(line), "Error") for line in lines]


def _verdict(region, report):
    lines = []
    for name, line in report["verdict"].items():
        heading = re.sub("([A-Z])", lambda m: " " + m.group().lower(), name)
        parts = [heading.capitalize() + ": " + line["text"]]
        if "place" in line:
            parts.append(_place(line))
        if "remedy" in line:
            parts.append(line["remedy"])
        lines.append((_html(region + "; ".join(parts)),
                      _COLOURS[line["grade"]]))
    return lines


def outcome(case):
    """Returns what the last run of harmonicPrismMesh in a mesh case came to:
    pairs of a line in HTML and the type of its colour in CfdOF. For a refusal
    they are the message, the place and the remedy; otherwise the verdict, of
    each region if there are several. There are none if no run has ended."""
    folder = os.path.join(case, "postProcessing", "harmonicPrismMesh")
    refused = os.path.join(folder, "refused.json")
    if os.path.exists(refused):
        return _refusal(_read(refused))
    lines = []
    for path, _, files in sorted(os.walk(folder)):
        if "report.json" in files:
            region = os.path.relpath(path, folder)
            lines += _verdict("" if region == "." else region + ": ",
                              _read(os.path.join(path, "report.json")))
    return lines
