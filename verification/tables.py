#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Prints tables of the cases of Allrun: how even the level sets of the fields
# are, and how good the meshes. Writes tables.tsv into the folder, with the
# first of these. Needs VTK and NumPy for Python.
#
#     verification/tables.py cases
#------------------------------------------------------------------------------
import collections
import math
import os
import re
import sys
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)),
                                "..", "python"))
from harmonicPrismMesh import read_dictionary

# Edges of the wall that count, by the angle between the normals [deg]
SHARP = 20

FIELDS = ("isotropic", "anisotropic", "gradientPower")


def read_wall(case):
    reader = vtk.vtkUnstructuredGridReader()
    reader.SetFileName(case + "/postProcessing/harmonicPrismMesh/wall.vtk")
    reader.ReadAllFieldsOn()
    reader.Update()
    grid = reader.GetOutput()

    wall = {"points": vtk_to_numpy(grid.GetPoints().GetData())}
    wall["faces"] = [
        [grid.GetCell(i).GetPointId(k)
         for k in range(grid.GetCell(i).GetNumberOfPoints())]
        for i in range(grid.GetNumberOfCells())]

    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            wall[data.GetArrayName(i)] = vtk_to_numpy(data.GetArray(i))

    return wall


def edge_points(wall):
    """Points on concave edges alone, and on convex ones alone"""
    points, faces = wall["points"], wall["faces"]
    normals = numpy.array([numpy.cross(points[f[1]] - points[f[0]],
                                       points[f[2]] - points[f[0]])
                           for f in faces])
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    centres = numpy.array([points[f].mean(axis=0) for f in faces])

    edges = collections.defaultdict(list)
    for i, f in enumerate(faces):
        for k in range(len(f)):
            edges[tuple(sorted((f[k], f[(k + 1) % len(f)])))].append(i)

    concave, convex = set(), set()
    for edge, (a, b) in edges.items():
        if normals[a] @ normals[b] < math.cos(math.radians(SHARP)):
            hollow = normals[a] @ (centres[b] - centres[a]) > 0
            (concave if hollow else convex).update(edge)

    return sorted(concave - convex), sorted(convex - concave)


def number(text, pattern, default="-"):
    found = re.search(pattern, text)
    return found.group(1) if found else default


def short(text, digits=3):
    """A number with so many digits"""
    try:
        return "%.*g" % (digits, float(text))
    except ValueError:
        return text


def read(file):
    with open(file) as stream:
        return stream.read()


def spread(values):
    """Mean and largest"""
    if len(values) == 0:
        return "-"
    return "%.2f (%.2f)" % (values.mean(), values.max())


def unevenness(values):
    """Geometric mean of how far values are from 1, as a factor >= 1"""
    return math.exp(numpy.abs(numpy.log(numpy.maximum(values, 1e-3))).mean())


def row(cells):
    print("| " + " | ".join(str(c) for c in cells) + " |")


def header(names):
    row(names)
    print("|" + "|".join("---" for _ in names) + "|")


def cases(root, ending=""):
    """Name, field and folder of the cases that have a mesh"""
    for name in sorted(os.listdir(root),
                       key=lambda n: (len(re.sub(r"\D", "", n)) == 0,
                                      re.sub(r"\d", "", n),
                                      int(re.sub(r"\D", "", n) or 0))):
        for field in FIELDS:
            case = os.path.join(root, name, field + ending)
            if os.path.exists(case + "/postProcessing/harmonicPrismMesh/report"):
                yield name, field, case


def level_sets(root):
    """The table of level sets, printed and, tab-separated, in tables.tsv"""
    print("## Level sets\n")
    print("Heights of the first and the last level set over those on a flat"
          " wall: mean (largest)\nof the points on concave, and on convex,"
          " edges. Unevenness is the geometric mean of the\nfactor by which"
          " first level sets miss, over the points on both.\n")
    header(("case", "field", "concave first", "concave last", "convex first",
            "convex last", "unevenness concave", "convex", "extrema",
            "saddles"))

    with open(root + "/tables.tsv", "w") as stream:
        stream.write("\t".join(("case", "field", "concaveMean", "concaveMax",
                                "convexMean", "convexMax", "unevennessConcave",
                                "unevennessConvex", "extrema", "saddles"))
                     + "\n")

        for name, field, case in cases(root):
            wall = read_wall(case)
            concave, convex = edge_points(wall)
            first, last = wall["firstLevelSet"], wall["lastLevelSet"]
            counts = read_dictionary(
                case + "/postProcessing/harmonicPrismMesh/levelSets")
            critical = [str(counts[key]) for key in ("extrema", "saddlePoints")]
            uneven = [unevenness(first[points]) if points else None
                      for points in (concave, convex)]
            spreads = [value for points in (concave, convex) if points
                       for value in (first[points].mean(),
                                     first[points].max())]
            if not concave:
                spreads = [None, None] + spreads

            row([name, field, spread(first[concave]), spread(last[concave]),
                 spread(first[convex]), spread(last[convex])]
                + ["-" if u is None else "%.2f" % u for u in uneven]
                + critical)
            stream.write("\t".join([name, field]
                                   + ["-" if v is None else "%.4g" % v
                                      for v in spreads + uneven] + critical)
                         + "\n")


def beside_edges(wall, points):
    marked = set(points)
    return numpy.array([i for i, f in enumerate(wall["faces"])
                        if marked.intersection(f)], dtype=int)


def meshes(root, ending):
    header(("case", "field", "prisms", "full layers %", "first/asked p1 to p99",
            "beside concave edges: first", "last", "worst Jacobian", "mean",
            "max non-orth.", "mean", "growth p99", "seconds"))

    for name, field, case in cases(root, ending):
        folder = case + "/postProcessing/harmonicPrismMesh/"
        report = read_dictionary(folder + "report")
        check = read(case + "/log.checkMesh")
        wall = read_wall(case)
        beside = beside_edges(wall, edge_points(wall)[0])
        seconds = [stage["seconds"] for stage in report["stages"].values()]
        everywhere = report["allPatches"]
        first = everywhere["firstHeightOverRequest"]
        row((name, field, report["certificate"]["cells"],
             everywhere["fullLayersAreaPercent"],
             short(first["p1"]) + " to " + short(first["p99"]),
             spread(wall["firstHeightOverRequest"][beside]),
             spread(wall["thicknessOverRequest"][beside]),
             short(everywhere["worstScaledJacobian"], 2),
             short(everywhere["meanScaledJacobian"]),
             short(number(check, r"non-orthogonality Max: ([\d.]+)")),
             short(number(check,
                          r"non-orthogonality Max: [\d.]+ average: ([\d.]+)")),
             short(everywhere["growthOverRequest"]["p99"], 4),
             "%.1f" % sum(seconds)))


def stages(root, name):
    case = os.path.join(root, name, "anisotropic")
    if not os.path.exists(case):
        return
    report = read_dictionary(case + "/postProcessing/harmonicPrismMesh/report")
    print("\n## Stages: %s, anisotropic\n" % name)
    header(("stage", "seconds", "peak MB"))
    for stage, cost in report["stages"].items():
        row((stage, "%.2f" % cost["seconds"], "%.0f" % cost["peakMemoryMB"]))


def local(root):
    case = os.path.join(root, "local", "anisotropic.levelSets")
    if not os.path.exists(case):
        return
    wall = read_wall(case)
    centres = numpy.array([wall["points"][f].mean(axis=0)
                           for f in wall["faces"]])
    asked = numpy.array([wall["thicknessRequest"][f].mean()
                         for f in wall["faces"]])
    got = wall["thicknessOverRequest"]*asked
    full = asked.max()
    change = wall["firstHeightChange"]

    print("\n## Local tensors: thickness along a hull\n")
    header(("part", "asked", "first quartile", "median", "third quartile"))
    for text, where in (("fore", centres[:, 0] < 1.9),
                        ("transition", (centres[:, 0] > 1.9)
                         & (centres[:, 0] < 2.5)),
                        ("stern", centres[:, 0] > 2.5)):
        row([text, "%.3f" % (numpy.median(asked[where])/full)]
            + ["%.3f" % q for q in
               numpy.percentile(got[where]/full, (25, 50, 75))])
    print("\nThe first height changes from face to face by a factor of %.3f"
          " on 99 %% of the faces." % numpy.percentile(change, 99))


def main():
    if len(sys.argv) != 2:
        sys.exit("Usage: verification/tables.py <folder of cases>")
    root = sys.argv[1]
    level_sets(root)
    print("\n## Meshes, distances as requested\n")
    meshes(root, "")
    print("\n## Meshes on level sets\n")
    meshes(root, ".levelSets")
    stages(root, "missile")
    local(root)


main()
