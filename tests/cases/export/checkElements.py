#!/usr/bin/env python3
#------------------------------------------------------------------------------
# Checks a mesh of elements: in SU2's native format, by the rules of its
# description, or as VTK for Python reads a file .vtu or .cgns.
#
#     checkElements.py mesh.su2 [mesh.vtu ...]
#
# Elements are positive in the order of their points, exact. Each face is one of
# two elements, or of one element and of one element of one patch. Prints the
# volume and the areas of the patches of each file, and the volumes of the zones
# of a file .vtu; in two dimensions areas and lengths.
#------------------------------------------------------------------------------
import collections
import fractions
import math
import sys

LINE, TRIANGLE, QUAD, TETRA, HEXA, PRISM, PYRAMID = 3, 5, 9, 10, 12, 13, 14
N_POINTS = {LINE: 2, TRIANGLE: 3, QUAD: 4, TETRA: 4, HEXA: 8, PRISM: 6,
            PYRAMID: 5}

# Faces of elements as VTK numbers the points, seen from outside
FACES = {
    TRIANGLE: ((0, 1), (1, 2), (2, 0)),
    QUAD: ((0, 1), (1, 2), (2, 3), (3, 0)),
    TETRA: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
    PYRAMID: ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    PRISM: ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    HEXA: ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5),
           (2, 3, 7, 6), (3, 0, 4, 7)),
}

# At each corner: the point, and its neighbours in positive order
CORNERS = {
    TETRA: ((0, 1, 2, 3),),
    PYRAMID: ((0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4)),
    PRISM: ((0, 2, 1, 3), (1, 0, 2, 4), (2, 1, 0, 5),
            (3, 4, 5, 0), (4, 5, 3, 1), (5, 3, 4, 2)),
    HEXA: ((0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7),
           (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)),
}


def bad(text):
    sys.exit("checkElements.py: " + text)


class Reader:
    """Lines without comments, and values after keywords"""

    def __init__(self, name):
        with open(name) as file:
            self.lines = [line for line in file
                          if line.strip() and not line.startswith("%")]
        self.at = 0

    def line(self):
        self.at += 1
        return self.lines[self.at - 1]

    def value(self, key):
        name, _, value = self.line().partition("=")
        if name.strip() != key:
            bad("%s expected, not %s" % (key, name))
        return value.strip()

    def element(self, kinds):
        numbers = [int(word) for word in self.line().split()]
        kind = numbers[0]
        if kind not in kinds:
            bad("element of type %d" % kind)
        if len(numbers) - 1 - N_POINTS[kind] not in (0, 1):
            bad("element with %d numbers" % len(numbers))
        return kind, tuple(numbers[1:1 + N_POINTS[kind]])


def read_su2(name):
    reader = Reader(name)
    dimension = int(reader.value("NDIME"))
    kinds = ((TRIANGLE, QUAD), (TETRA, HEXA, PRISM, PYRAMID))[dimension - 2]
    cells = [reader.element(kinds)
             for _ in range(int(reader.value("NELEM")))]
    points = [tuple(float(word) for word in reader.line().split()[:dimension])
              for _ in range(int(reader.value("NPOIN")))]
    markers = {}
    for _ in range(int(reader.value("NMARK"))):
        tag = reader.value("MARKER_TAG")
        if tag in markers:
            bad("two markers " + tag)
        kinds = ((LINE,), (TRIANGLE, QUAD))[dimension - 2]
        markers[tag] = [reader.element(kinds)[1]
                        for _ in range(int(reader.value("MARKER_ELEMS")))]
    if reader.at != len(reader.lines):
        bad("lines after the last marker")
    return dimension, cells, points, markers, {}


def vtk_cells(grid, labels):
    """Type and points of each cell, with other labels of the points"""
    return [(grid.GetCellType(i),
             tuple(labels[grid.GetCell(i).GetPointId(k)]
                   for k in range(grid.GetCell(i).GetNumberOfPoints())))
            for i in range(grid.GetNumberOfCells())]


def vtk_mesh(cells, points, patches, zones):
    dimension = 3 if any(kind > QUAD for kind, _ in cells) else 2
    return (dimension, cells, [p[:dimension] for p in points],
            {name: [face for _, face in patch]
             for name, patch in patches.items()}, zones)


def read_vtu(name):
    import vtk
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    points = [grid.GetPoint(i) for i in range(grid.GetNumberOfPoints())]
    elements = vtk_cells(grid, range(len(points)))

    groups = []
    for key in ("zone", "patch"):
        names = grid.GetFieldData().GetAbstractArray(key + "Names")
        values = grid.GetCellData().GetArray(key)
        groups.append({names.GetValue(i): []
                       for i in range(names.GetNumberOfTuples())})
        for i, element in enumerate(elements):
            group = int(values.GetValue(i))
            if group >= 0:
                groups[-1][names.GetValue(group)].append(element)
    zones, patches = groups
    cells = [cell for zone in zones.values() for cell in zone]
    if len(cells) + sum(map(len, patches.values())) != len(elements):
        bad("elements in a zone and in a patch")
    return vtk_mesh(cells, points, patches, zones)


def read_cgns(name):
    import vtk
    reader = vtk.vtkCGNSReader()
    reader.SetFileName(name)
    reader.UpdateInformation()
    reader.LoadBndPatchOn()
    reader.Update()

    # Blocks have points of their own
    blocks = {}
    points, label_of = [], {}
    iterator = reader.GetOutput().NewIterator()
    while not iterator.IsDoneWithTraversal():
        grid = iterator.GetCurrentDataObject()
        labels = []
        for i in range(grid.GetNumberOfPoints()):
            point = grid.GetPoint(i)
            if point not in label_of:
                label_of[point] = len(points)
                points.append(point)
            labels.append(label_of[point])
        key = iterator.GetCurrentMetaData().Get(vtk.vtkCompositeDataSet.NAME())
        blocks[key] = vtk_cells(grid, labels)
        iterator.GoToNextItem()

    # The reader leaves prisms in the order of CGNS
    cells = [(kind, tuple(p[k] for k in (0, 2, 1, 3, 5, 4)))
             if kind == PRISM else (kind, p)
             for kind, p in blocks.pop("Internal")]
    return vtk_mesh(cells, points, blocks, {})


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return (a[1]*b[2] - a[2]*b[1], a[2]*b[0] - a[0]*b[2],
            a[0]*b[1] - a[1]*b[0])


def dot(a, b):
    return sum(x*y for x, y in zip(a, b))


def determinant(points):
    """Six times the volume of four points, twice the area of three in a plane;
    by fractions unless the sign is certain"""
    edges = [minus(p, points[0]) for p in points[1:]]
    if len(edges) == 2:
        return edges[0][0]*edges[1][1] - edges[0][1]*edges[1][0]
    value = dot(cross(edges[0], edges[1]), edges[2])
    bound = 1
    for k in range(3):
        bound *= max(abs(e[k]) for e in edges)
    if isinstance(value, float) and abs(value) <= 1e-14*bound:
        return determinant([tuple(map(fractions.Fraction, p))
                            for p in points])
    return value


def area(face, points):
    """Area vector; of a line in a plane its normal"""
    if len(points[0]) == 2:
        a, b = (points[p] for p in face)
        return (b[1] - a[1], a[0] - b[0])
    total = (0, 0, 0)
    for i in range(1, len(face) - 1):
        one = cross(minus(points[face[i]], points[face[0]]),
                    minus(points[face[i + 1]], points[face[0]]))
        total = tuple(t + x/2 for t, x in zip(total, one))
    return total


def check_cells(dimension, cells, points, faces):
    """Returns the volume, and appends the faces of the cells, seen from outside,
    to those with the same points"""
    volume = 0
    for kind, labels in cells:
        if len(set(labels)) != len(labels):
            bad("element with a point twice: %s" % (labels,))
        n = len(labels)
        for corner in CORNERS.get(kind) or [(k, (k + 1) % n, (k - 1) % n)
                                            for k in range(n)]:
            if determinant([points[labels[c]] for c in corner]) <= 0:
                bad("element that is not positive: %d %s at %s"
                    % (kind, labels, points[labels[0]]))
        origin = points[labels[0]]
        for local in FACES[kind]:
            face = tuple(labels[p] for p in local)
            mean = [sum(x)/len(face) for x in zip(*(points[p] for p in face))]
            volume += dot(area(face, points), minus(mean, origin))/dimension
            faces[tuple(sorted(face))].append(face)
    return volume


def is_opposite(a, b):
    """Whether faces on the same points are seen from opposite sides"""
    if len(a) == 2:
        return a != b
    k = b.index(a[0])
    return a[1:] == tuple(reversed(b[k + 1:] + b[:k]))


def check_faces(faces, patches):
    """Each face is of two elements, or of one and of one of a patch"""
    marked = set()
    for name, patch in patches.items():
        for face in patch:
            key = tuple(sorted(face))
            if key in marked:
                bad("face %s is of two elements of patches" % (face,))
            if len(faces.get(key, ())) != 1:
                bad("face %s of %s is not of one element" % (face, name))
            marked.add(key)
    for key, sides in faces.items():
        if key not in marked and (len(sides) != 2 or not is_opposite(*sides)):
            bad("face of wrong elements and no patch: %s" % (sides,))


def check(name):
    read = {"su2": read_su2, "vtu": read_vtu, "cgns": read_cgns}
    dimension, cells, points, patches, zones = read[name.split(".")[-1]](name)
    if {p for _, labels in cells for p in labels} != set(range(len(points))):
        bad("points that are of no element")

    faces = collections.defaultdict(list)
    volumes = {zone: check_cells(dimension, elements, points, faces)
               for zone, elements in (zones or {"all": cells}).items()}
    check_faces(faces, patches)
    if zones:
        volumes["all"] = sum(volumes.values())
    for zone, volume in volumes.items():
        print("%s %.12g" % (zone, volume))
    for patch, elements in patches.items():
        print("%s %.12g" % (patch, sum(math.hypot(*area(f, points))
                                       for f in elements)))


if __name__ == "__main__":
    for file_name in sys.argv[1:]:
        check(file_name)
