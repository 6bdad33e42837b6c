#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""Pictures by VTK: surfaces in colours, and the mesh in planes."""

import contextlib
import math
import os
import shutil
import subprocess

import numpy as np
import vtk
from vtk.util.numpy_support import (numpy_to_vtk, numpy_to_vtkIdTypeArray,
                                    vtk_to_numpy)

import harmonicPrismMesh as hpm
from .page import figure
from .polyMesh import ragged


# From low to high, perceived as even, told apart by all eyes
VIRIDIS = ("#440154", "#3b528b", "#21918c", "#5ec962", "#fde725")
DIVERGING = ("#2166ac", "#92c5de", "#dddddd", "#f4a582", "#b2182b")
NEAR_TO_FAR = ("#dddddd", "#fee08b", "#f46d43", "#a50026")

LAYER, FAR, LAYER_LINE, FAR_LINE = "#b9d7ee", "#f7f7f7", "#4a6f8f", "#c4c4c4"
NO_VALUE = (120, 120, 120)


def rgb(colour):
    return tuple(int(colour[i:i + 2], 16) for i in (1, 3, 5))


def colours_of(values, low, high, colours):
    """Colours of numbers, from low to high; grey where there is no number"""
    at = np.clip((values - low)/(high - low), 0, 1)*(len(colours) - 1)
    table = np.array([rgb(c) for c in colours], float)
    found = np.stack([np.interp(at, np.arange(len(table)), table[:, k])
                      for k in range(3)], axis=1)
    found[~np.isfinite(values)] = NO_VALUE
    return found.astype(np.uint8)


def _actor(data, colours=None, colour=None, width=1, lit=False):
    """Cells of a vtkPolyData in colours of their own, or in one"""
    if colours is not None:
        array = numpy_to_vtk(np.ascontiguousarray(colours), 1)
        data.GetCellData().SetScalars(array)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUseCellData()
    mapper.SetScalarVisibility(colours is not None)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetLineWidth(width)
    look.SetInterpolationToFlat()
    look.SetLighting(lit)
    look.SetAmbient(0.5)
    look.SetDiffuse(0.55)
    if colour:
        look.SetColor(*(c/255 for c in rgb(colour)))
    return actor


def _png(panels, size):
    """A picture of panels beside each other. A panel has actors, a centre, the
    direction to the eye, up, and half of its height."""
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    for i, (actors, centre, view, up, half) in enumerate(panels):
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(i/len(panels), 0, (i + 1)/len(panels), 1)
        renderer.SetBackground(1, 1, 1)
        for actor in actors:
            renderer.AddActor(actor)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*centre)
        camera.SetPosition(*(np.asarray(centre) + 100*half*np.asarray(view)))
        camera.SetViewUp(*up)
        camera.SetParallelScale(half)
        window.AddRenderer(renderer)
        renderer.ResetCameraClippingRange()
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetCompressionLevel(9)
    writer.WriteToMemoryOn()
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()
    data = vtk_to_numpy(writer.GetResult()).tobytes()
    window.Finalize()
    return data


def _views(surface, thin):
    """Two directions to the eye from which most of a surface is seen"""
    if thin is not None:
        up = np.array((0, 0, 1) if abs(thin[2]) < 0.9 else (0, 1, 0))
        return [thin + 0.3*up]
    views = [np.array((x, y, z)) for z in (0.7, -0.7)
             for x, y in ((1, -1), (-1, 1), (1, 1), (-1, -1))]
    seen = np.array([np.dot(surface.areas, np.maximum(surface.unit @ v, 0))
                     for v in views])
    # The first of those that are nearly best, and then from the other side: if
    # an open wall shows its back there, from the next best one
    first = int(np.argmax(seen > 0.85*seen.max()))
    worth = [s*(1.3 if np.dot(v[:2], views[first][:2]) < 0 else 1)
             * (1.1 if v[2]*views[first][2] < 0 else 1)
             for s, v in zip(seen, views)]
    worth[first] = 0
    return [views[first], views[int(np.argmax(worth))]]


def body_picture(surface, colours, thin=None, both_sides=False):
    """A surface in colours of its polygons, from two sides, as a figure"""
    width, height = 1120, 400
    views = _views(surface, thin)
    middle = (surface.points.min(axis=0) + surface.points.max(axis=0))/2
    panels, half = [], 0
    for view in views:
        view = view/np.linalg.norm(view)
        up = np.array((0.0, 0.0, 1.0)) if abs(view[2]) < 0.9 \
            else np.array((0.0, 1.0, 0.0))
        right = np.cross(up, view)
        right /= np.linalg.norm(right)
        up = np.cross(view, right)
        local = np.stack(((surface.points - middle) @ right,
                          (surface.points - middle) @ up))
        low, high = local.min(axis=1), local.max(axis=1)
        centre = middle + right*(low + high)[0]/2 + up*(low + high)[1]/2
        size = (high - low)/2*1.04
        half = max(half, size[1], size[0]*height/(width/len(views)))
        panels.append((centre, view, up))
    whole = []
    for centre, view, up in panels:
        actor = _actor(surface.poly_data(), colours, lit=thin is None)
        # What is seen through the body is not seen
        actor.GetProperty().SetBackfaceCulling(
            not both_sides and thin is None)
        whole.append(([actor], centre, view, up, half))
    return figure(_png(whole, (width, height)), width, height, 2*half/height)


class Cut:
    """The mesh in a plane through a point: segments of faces, and triangles
    that fill cells, in coordinates of the plane. window: half the width and
    half the height [m] of what is needed"""

    def __init__(self, mesh, point, normal, up, window):
        self.point, self.normal = np.asarray(point), normal
        self.right = np.cross(up, normal)
        self.right /= np.linalg.norm(self.right)
        self.up = np.cross(normal, self.right)
        self.window = window
        local = (mesh.points - point) @ np.stack(
            (self.right, self.up, normal)).T
        above = local[:, 2] >= 0

        # Faces that the plane cuts, and of these all faces of the cells that
        # are within the window
        count = np.add.reduceat(above[mesh.labels].astype(np.int32),
                                mesh.offsets[:-1])
        faces = np.flatnonzero((count > 0) & (count < mesh.sizes))
        at, row = ragged(mesh.offsets, faces)
        within = np.ones(len(faces), bool)
        for k in range(2):
            value = local[mesh.labels[at], k]
            low, high = np.full((2, len(faces)), np.inf)
            np.minimum.at(low, row, value)
            np.minimum.at(high, row, -value)
            within &= (low < window[k]) & (high < window[k])
        self.shown = np.zeros(mesh.n_cells + 1, bool)
        self.shown[mesh.owner[faces[within]]] = True
        self.shown[mesh.neighbour[faces[within]]] = True
        self.shown[-1] = False
        faces = faces[self.shown[mesh.owner[faces]]
                      | self.shown[mesh.neighbour[faces]]]
        self._segments(mesh, local, above, faces)

    def _segments(self, mesh, local, above, faces):
        at, row = ragged(mesh.offsets, faces)
        following = np.where(at + 1 == mesh.offsets[faces + 1][row],
                             mesh.offsets[faces][row], at + 1)
        a, b = mesh.labels[at], mesh.labels[following]
        crossing = above[a] != above[b]
        a, b, row = a[crossing], b[crossing], row[crossing]
        t = local[a, 2]/(local[a, 2] - local[b, 2])
        points = local[a, :2] + t[:, None]*(local[b, :2] - local[a, :2])

        # The plane enters and leaves a face at crossings in turn. A warped
        # face may have four: two short segments are more likely than long ones
        four = np.bincount(row, minlength=len(faces))[row] == 4
        p = points[four].reshape(-1, 4, 2)
        ahead, around = (np.linalg.norm(p[:, [0, 2]] - p[:, to], axis=2).sum(1)
                         for to in ([1, 3], [3, 1]))
        p[ahead > around] = p[ahead > around][:, [0, 3, 2, 1]]
        points[four] = p.reshape(-1, 2)
        self.segments = points.reshape(-1, 2, 2)
        self.faces = faces[row[::2]]
        cells = np.concatenate((mesh.owner[self.faces],
                                mesh.neighbour[self.faces]))
        own = np.concatenate((self.segments, self.segments))[self.shown[cells]]
        self.cells, index = np.unique(cells[self.shown[cells]],
                                      return_inverse=True)
        middles = np.stack([np.bincount(index, own[:, :, k].mean(axis=1))
                            for k in range(2)], axis=1)
        middles /= np.maximum(np.bincount(index), 1)[:, None]
        self.triangles = np.concatenate((own, middles[index][:, None]), axis=1)
        self.cell = self.cells[index] if len(index) else index

    def picture(self, mesh, walls, size, thickness, marks=()):
        """A figure. walls: faces of the wall. Lines of layers are left out if
        they would be a black line. marks: squares, as centre and half of the
        height in the plane"""
        half = self.window[1]
        inner = np.isin(self.faces, walls, invert=True)
        is_layer = np.ones(mesh.n_cells, bool) if mesh.layer_cells is None \
            else mesh.layer_cells
        own = is_layer[mesh.owner[self.faces]]
        other = mesh.neighbour[self.faces]
        layer_line = inner & (own | ((other >= 0) & is_layer[other]))
        fill = np.array([rgb(FAR), rgb(LAYER)],
                        np.uint8)[is_layer[self.cell].astype(int)]
        actors = [_actor(_plane_data(self.triangles, half, 0), fill)]
        kinds = [(inner & ~layer_line, FAR_LINE, 1), (~inner, "#000000", 2.5)]
        if thickness/(2*half)*size[1] > 12:
            kinds.insert(1, (layer_line, LAYER_LINE, 1))
        for i, (chosen, colour, width) in enumerate(kinds):
            if chosen.any():
                actors.append(_actor(
                    _plane_data(self.segments[chosen], half, 0.01*(i + 1)),
                    colour=colour, width=width))
        png = _png([(actors, (0, 0, 0), (0, 0, 1), (0, 1, 0), 1)], size)
        return figure(png, *size, 2*half/size[1], [
            (size[0]/2 + x/half*size[1]/2, size[1]/2 - y/half*size[1]/2,
             h/half*size[1]/2) for (x, y), h in marks])


def _plane_data(polygons, half, depth):
    """Triangles or segments of a plane, in units of half the height"""
    n, corners, _ = polygons.shape
    points = np.full((n*corners, 3), float(depth))
    points[:, :2] = polygons.reshape(-1, 2)/half
    cells = vtk.vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, n*corners + 1, corners),
                                          1),
                  numpy_to_vtkIdTypeArray(np.arange(n*corners), 1))
    data, vertices = vtk.vtkPolyData(), vtk.vtkPoints()
    vertices.SetData(numpy_to_vtk(points, 1))
    data.SetPoints(vertices)
    (data.SetPolys if corners == 3 else data.SetLines)(cells)
    return data


@contextlib.contextmanager
def display():
    """VTK before 9.4 draws on an X server only: Xvfb, or the user's"""
    version = vtk.vtkVersion()
    new = (version.GetVTKMajorVersion(), version.GetVTKMinorVersion())
    if new >= (9, 4) or (os.environ.get("DISPLAY")
                         and not shutil.which("Xvfb")):
        yield
        return
    if not shutil.which("Xvfb"):
        raise hpm.MeshError("VTK needs a display, or the program Xvfb (Debian: "
                            "sudo apt-get install xvfb)")
    reading, writing = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24",
         "-nolisten", "tcp", "-noreset"], pass_fds=[writing],
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL)
    os.close(writing)
    before = os.environ.get("DISPLAY")
    try:
        with os.fdopen(reading) as file:
            os.environ["DISPLAY"] = ":" + file.readline().strip()
        yield
    finally:
        server.terminate()
        server.wait()
        os.environ.pop("DISPLAY")
        if before is not None:
            os.environ["DISPLAY"] = before
