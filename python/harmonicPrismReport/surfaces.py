#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""The wall with its values, and the given files."""

import os
import shutil
import subprocess
import tempfile

import numpy as np
import vtk
from vtk.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                    vtk_to_numpy)

import harmonicPrismMesh as hpm
from .polyMesh import areas_of, file_bytes, ragged


class Surface:
    """Polygons. values: of the polygons, by name; causes: of their points, or
    None. Normals point into the fluid."""

    def __init__(self, points, offsets, labels):
        self.points, self.offsets, self.labels = points, offsets, labels
        self.centres, self.normals = areas_of(points, offsets, labels)
        self.areas = np.linalg.norm(self.normals, axis=1)
        self.unit = self.normals/np.maximum(self.areas, 1e-300)[:, None]
        self.values = {}
        self.causes = None
        self.request = None

    def __len__(self):
        return len(self.areas)

    def diagonal(self):
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    def near(self, low, high):
        """The polygons with a point in a box"""
        inside = ((self.points > low) & (self.points < high)).all(axis=1)
        rows = np.flatnonzero(np.logical_or.reduceat(
            inside[self.labels], self.offsets[:-1]))
        at, _ = ragged(self.offsets, rows)
        used, labels = np.unique(self.labels[at], return_inverse=True)
        sizes = np.diff(self.offsets)[rows]
        return Surface(self.points[used],
                       np.concatenate(([0], np.cumsum(sizes))), labels)

    def crossed(self, point, normal):
        """The points of the polygons that a plane crosses, and the point"""
        above = (self.points - point) @ normal > 0
        count = np.add.reduceat(above[self.labels].astype(int),
                                self.offsets[:-1])
        sizes = np.diff(self.offsets)
        at, _ = ragged(self.offsets,
                       np.flatnonzero((count > 0) & (count < sizes)))
        return np.concatenate((self.points[self.labels[at]], [point]))

    def poly_data(self):
        cells = vtk.vtkCellArray()
        cells.SetData(numpy_to_vtkIdTypeArray(self.offsets, 1),
                      numpy_to_vtkIdTypeArray(self.labels, 1))
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(np.ascontiguousarray(self.points), 1))
        data = vtk.vtkPolyData()
        data.SetPoints(points)
        data.SetPolys(cells)
        return data


def _surface_of(data, scale=1):
    """Of a data set of VTK, its polygons; scale: a factor on coordinates"""
    cells = data.GetPolys() if hasattr(data, "GetPolys") else data.GetCells()
    return Surface(
        scale*vtk_to_numpy(data.GetPoints().GetData()).astype(float),
        vtk_to_numpy(cells.GetOffsetsArray()).astype(np.int64),
        vtk_to_numpy(cells.GetConnectivityArray()).astype(np.int64))


def wall_of_file(path, report):
    """The wall with all values, as harmonicPrismMesh -writeFields writes it;
    None if the file is not there, or is of another run"""
    if not os.path.exists(path):
        return None
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(path)
    reader.ReadAllScalarsOn()
    reader.Update()
    data = reader.GetOutput()
    if data.GetNumberOfCells() != report["wall"]["faces"]:
        return None
    wall = _surface_of(data)
    for i in range(data.GetCellData().GetNumberOfArrays()):
        array = data.GetCellData().GetArray(i)
        wall.values[array.GetName()] = vtk_to_numpy(array).astype(float)
    of_points = data.GetPointData()
    wall.causes = vtk_to_numpy(of_points.GetArray("squeezeCause")).astype(int)
    request = vtk_to_numpy(of_points.GetArray("thicknessRequest"))
    wall.request = np.add.reduceat(request[wall.labels], wall.offsets[:-1]) \
        / np.diff(wall.offsets)
    return wall


def wall_patches(mesh, report):
    """The patches of the mesh with layers, each with its part of the report. In
    the mesh of a region, interfaces have names of their own."""
    with_layers = {name: patch for name, patch in report["patches"].items()
                   if patch.get("layersAsked", 0) > 0}
    found = {name: patch for name, patch in with_layers.items()
             if len(mesh.faces_of(name))}
    others = [p for name, p in with_layers.items() if name not in found]
    if others:
        highest = max(others, key=lambda p: p["request"]["thickness"]["max"])
        found.update({name: highest for name, (kind, faces)
                      in mesh.patches.items()
                      if kind.startswith("mapped") and len(faces)})
    return found


def wall_of_mesh(mesh, report):
    """The faces of the patches with layers, with heights of the mesh, over the
    requests of the patches. If no zone says which cells of the mesh are in
    layers, those on these faces are, from now on."""
    faces, asked = [], []
    for name, patch in wall_patches(mesh, report).items():
        request = patch["request"]
        faces.append(mesh.faces_of(name))
        asked.append(np.repeat(
            [[request["firstLayerThickness"]["max"],
              request["thickness"]["max"], patch["layersAsked"]]],
            len(faces[-1]), axis=0))
    if not faces:
        return None
    faces, asked = np.concatenate(faces), np.concatenate(asked)
    at, _ = ragged(mesh.offsets, faces)
    used, labels = np.unique(mesh.labels[at], return_inverse=True)
    offsets = np.concatenate(([0], np.cumsum(mesh.sizes[faces])))

    # Faces of the mesh point out of the fluid
    ends = np.repeat(offsets[:-1] + offsets[1:] - 1, np.diff(offsets))
    wall = Surface(mesh.points[used], offsets,
                   labels[ends - np.arange(len(labels))])
    first, total, reached, cells = mesh.stacks(faces, asked[:, 2])
    if mesh.layer_cells is None and "farField" in report:
        mesh.layer_cells = cells
    wall.request = asked[:, 1]
    wall.values = {"firstHeight": first,
                   "firstHeightOverRequest": first/asked[:, 0],
                   "thicknessOverRequest": total/asked[:, 1],
                   "layers": reached}
    return wall


#------------------------------------------------------------------------------
# The given files
#------------------------------------------------------------------------------

def _surface_entries(case):
    """The entry surface of the dictionary, macros expanded if OpenFOAM's
    foamDictionary is there"""
    path = os.path.join(case, "system", "harmonicPrismMeshDict")
    if not os.path.exists(path):
        return {}
    if shutil.which("foamDictionary"):
        with tempfile.NamedTemporaryFile("w+") as file:
            if not subprocess.call(
                    ["foamDictionary", "-case", case, "-expand", path],
                    stdin=subprocess.DEVNULL, stdout=file,
                    stderr=subprocess.DEVNULL):
                entries = hpm.read_dictionary(file.name)
                if isinstance(entries.get("surface"), dict):
                    return entries["surface"]
    entries = hpm.read_dictionary(path).get("surface", {})
    return entries if isinstance(entries, dict) else {}


def _read_file(path):
    """The triangles of a surface file; None if VTK does not read its format"""
    readers = {".stl": vtk.vtkSTLReader, ".obj": vtk.vtkOBJReader,
               ".vtk": vtk.vtkPolyDataReader, ".ply": vtk.vtkPLYReader}
    name = path[:-3] if path.endswith(".gz") else path
    reader = readers.get(os.path.splitext(name)[1].lower())
    data = file_bytes(name)
    if reader is None or data is None:
        return None
    with tempfile.NamedTemporaryFile() as file:
        file.write(data)
        file.flush()
        reader = reader()
        reader.SetFileName(file.name)
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputConnection(reader.GetOutputPort())
        triangles.PassLinesOff()
        triangles.PassVertsOff()
        triangles.Update()
    return triangles.GetOutput()


def given_files(case):
    """The surface files of the dictionary as one surface, and names of files
    that cannot be read here"""
    entries = _surface_entries(case)
    names = entries.get("files", entries.get("file", []))
    together, missing = vtk.vtkAppendPolyData(), []
    for name in [names] if isinstance(names, str) else names:
        path = os.path.join(case, "constant", "triSurface", name)
        if not os.path.exists(path):
            path = os.path.join(case, name)
        data = _read_file(path)
        if data is None or not data.GetNumberOfCells():
            missing.append(name)
        else:
            together.AddInputData(data)
    if missing or not names:
        return None, missing
    together.Update()
    return _surface_of(together.GetOutput(),
                       float(entries.get("scale", 1))), []


def distances(surface, target):
    """Distance of each polygon's centre from another surface [m]"""
    # What is around the surface. In a wide far field the locator is slow
    margin = 0.5*surface.diagonal()
    low, high = (end(axis=0) for end in (surface.points.min,
                                         surface.points.max))
    near = target.near(low - margin, high + margin)
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet((near if len(near) else target).poly_data())
    locator.BuildLocator()
    cell, identity, part = vtk.vtkGenericCell(), vtk.mutable(0), vtk.mutable(0)
    nearest, square = [0.0, 0.0, 0.0], vtk.mutable(0.0)
    found = np.empty(len(surface))
    for i, centre in enumerate(surface.centres.tolist()):
        locator.FindClosestPoint(centre, nearest, cell, identity, part, square)
        found[i] = square.get()
    return np.sqrt(found)
