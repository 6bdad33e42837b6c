#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Draws the cases of Allrun. Needs VTK, NumPy and Matplotlib for Python, and no
# display.
#
#     verification/pictures.py cases
#
# overview.png           wall, envelope, background mesh, field, layers
# bodies.png             the walls
# <name>.field.png       level sets 0.1, 0.2, ... 0.9 of all fields
# <name>.levelSets.png   layers on level sets
# <name>.layers.png      layers at the requested heights
#------------------------------------------------------------------------------
import collections
import os
import sys
import matplotlib
import numpy
import vtk
from matplotlib.collections import LineCollection, PolyCollection
from vtk.util.numpy_support import vtk_to_numpy

matplotlib.use("Agg")
from matplotlib import pyplot

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "../doc/pictures"))
import layers

FIELDS = ("isotropic", "anisotropic", "gradientPower")

# Normal of a cut, its direction up, its middle, and its height [m]
View = collections.namedtuple("View", "normal up centre height")

VIEWS = {
    "wedge90": View((0, 0, 1), (0, 1, 0), (0, 0.13, 0.508), 0.40),
    "slit": View((0, 0, 1), (0, 1, 0), (0, 0.08, 0.483), 0.28),
    "corner60": View((0, 0, 1), (0, 1, 0), (0, 0.18, 0.508), 0.44),
}

# Direction from which a body is seen, direction up, and what it is called
BODIES = collections.OrderedDict([
    ("missile", ((0.4, -1, 0.45), (0, 0, 1), "missile")),
    ("submarine", ((0.4, -1, 0.35), (0, 0, 1), "submarine")),
    ("unmanned", ((-0.6, 1, -0.4), (0, 1, 0), "unmanned aircraft, with slits")),
    ("corner60", ((0.2, 0.55, 1), (0, 1, 0), "corner under 90 degrees")),
    ("ringPlane", ((-0.7, -1, 0.6), (0, 0, 1), "aircraft of genus 2")),
])

WALL = "#7a2f13"
DARK = "#193764"
LIGHT = "#d1e5f7"


def basis(view):
    normal = numpy.array(view.normal, float)/numpy.linalg.norm(view.normal)
    right = numpy.cross(view.up, normal)
    right /= numpy.linalg.norm(right)

    return numpy.array([right, numpy.cross(normal, right)])


def read(file):
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(file)
    reader.ReadAllFieldsOn()
    reader.Update()

    return reader.GetOutput()


def cut(grid, view, triangles=False):
    cutter = layers.cut(layers.near(grid, view), view)
    cutter.SetGenerateTriangles(triangles)
    cutter.Update()

    return cutter.GetOutput()


def shapes(surface, view):
    """Cells of a cut, by points in the plane of the picture"""
    if surface.GetNumberOfPoints() == 0:
        return []
    points = vtk_to_numpy(surface.GetPoints().GetData()) - view.centre
    flat = points @ basis(view).T

    return [flat[[surface.GetCell(i).GetPointId(k)
                  for k in range(surface.GetCell(i).GetNumberOfPoints())]]
            for i in range(surface.GetNumberOfCells())]


def results(case):
    return case + "/postProcessing/harmonicPrismMesh/"


def draw_wall(axes, case, view):
    lines = shapes(cut(read(results(case) + "wall.vtk"), view), view)
    axes.add_collection(LineCollection(lines, colors=WALL, linewidths=2))


def draw_cells(axes, cells, view):
    axes.add_collection(PolyCollection(shapes(cells, view), facecolors=LIGHT,
                                       edgecolors=DARK, linewidths=0.4))


def draw_field(axes, case, view):
    grid = read(results(case) + "backgroundMesh.vtk")
    grid.GetPointData().SetActiveScalars("H")
    section = cut(grid, view, triangles=True)
    axes.add_collection(PolyCollection(shapes(section, view),
                                       facecolors=LIGHT, edgecolors=LIGHT,
                                       linewidths=0.3))
    contour = vtk.vtkContourFilter()
    contour.SetInputData(section)
    for i in range(1, 10):
        contour.SetValue(i - 1, 0.1*i)
    contour.Update()
    axes.add_collection(LineCollection(shapes(contour.GetOutput(), view),
                                       colors=DARK, linewidths=0.8))


def draw_background(axes, case, view):
    grid = read(results(case) + "backgroundMesh.vtk")
    draw_cells(axes, cut(grid, view), view)


def draw_envelope(axes, case, view):
    points = vtk_to_numpy(read(results(case) + "envelope.vtk")
                          .GetPoints().GetData())
    away = numpy.abs((points - view.centre) @ numpy.array(view.normal))
    flat = (points[away < view.height] - view.centre) @ basis(view).T
    axes.plot(flat[:, 0], flat[:, 1], ".", color=DARK, markersize=2)


def draw_layers(axes, case, view):
    draw_cells(axes, cut(layers.read_mesh(case), view), view)


def finish(axes, view, title):
    half = 0.5*view.height
    axes.set_xlim(-half, half)
    axes.set_ylim(-half, half)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.set_title(title, fontsize=10)


def panels(file, view, pictures):
    """Pictures beside each other: title, case and what draws it"""
    figure, row = pyplot.subplots(1, len(pictures), squeeze=False,
                                  figsize=(3.4*len(pictures), 3.6))
    for axes, (title, case, draw) in zip(row[0], pictures):
        draw(axes, case, view)
        draw_wall(axes, case, view)
        finish(axes, view, title)
    figure.tight_layout()
    figure.savefig(file, dpi=110)
    pyplot.close(figure)


def has_mesh(case):
    return os.path.exists(case + "/constant/polyMesh")


def compare(root, name, kind, ending, draw):
    cases = [os.path.join(root, name, field + ending) for field in FIELDS]
    if all(has_mesh(case) for case in cases):
        panels(os.path.join(root, name + "." + kind + ".png"), VIEWS[name],
               [(field, case, draw) for field, case in zip(FIELDS, cases)])


def overview(root):
    case = os.path.join(root, "wedge90", "anisotropic")
    if has_mesh(case):
        panels(os.path.join(root, "overview.png"), VIEWS["wedge90"],
               [("wall and envelope", case, draw_envelope),
                ("background mesh", case, draw_background),
                ("level sets of the field", case, draw_field),
                ("layers", case, draw_layers)])


def draw_body(axes, case, direction, up):
    wall = read(results(case) + "wall.vtk")
    points = vtk_to_numpy(wall.GetPoints().GetData())
    towards = numpy.array(direction)/numpy.linalg.norm(direction)
    flat = points @ basis(View(direction, up, None, None)).T
    faces = [[wall.GetCell(i).GetPointId(k)
              for k in range(wall.GetCell(i).GetNumberOfPoints())]
             for i in range(wall.GetNumberOfCells())]
    normals = numpy.array([numpy.cross(points[f[1]] - points[f[0]],
                                       points[f[2]] - points[f[0]])
                           for f in faces])
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    depth = numpy.array([(points[f] @ towards).mean() for f in faces])
    light = 0.45 + 0.5*numpy.abs(normals @ towards)
    order = numpy.argsort(depth)
    colours = numpy.outer(light[order], (0.82, 0.88, 0.95))
    axes.add_collection(PolyCollection([flat[faces[i]] for i in order],
                                       facecolors=colours, edgecolors=colours,
                                       linewidths=0.2))
    axes.set_xlim(flat[:, 0].min(), flat[:, 0].max())
    axes.set_ylim(flat[:, 1].min(), flat[:, 1].max())
    axes.set_aspect("equal")
    axes.axis("off")


def bodies(root):
    cases = {name: os.path.join(root, name, "anisotropic") for name in BODIES}
    if not all(has_mesh(case) for case in cases.values()):
        return
    figure, row = pyplot.subplots(1, len(BODIES),
                                  figsize=(2.8*len(BODIES), 2.6))
    for axes, (name, (direction, up, title)) in zip(row, BODIES.items()):
        draw_body(axes, cases[name], direction, up)
        axes.set_title(title, fontsize=10)
    figure.tight_layout()
    figure.savefig(os.path.join(root, "bodies.png"), dpi=110)


def main():
    if len(sys.argv) != 2:
        sys.exit("Usage: verification/pictures.py <folder of cases>")
    root = sys.argv[1]
    overview(root)
    bodies(root)
    for name in VIEWS:
        compare(root, name, "field", "", draw_field)
        compare(root, name, "levelSets", ".levelSets", draw_layers)
        compare(root, name, "layers", "", draw_layers)


main()
