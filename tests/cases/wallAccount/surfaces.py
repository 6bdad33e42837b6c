#------------------------------------------------------------------------------
#   harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
#   SPDX-License-Identifier: GPL-3.0-or-later
#------------------------------------------------------------------------------
"""surfaces.py <name> [number]: writes STL files into constant/triSurface."""

import math
import sys


def write(name, solids):
    with open("constant/triSurface/%s.stl" % name, "w") as file:
        for solid, triangles in solids.items():
            file.write("solid %s\n" % solid)
            for t in triangles:
                file.write("facet normal 0 0 0\nouter loop\n")
                for p in t:
                    file.write("vertex %.9g %.9g %.9g\n" % tuple(p))
                file.write("endloop\nendfacet\n")
            file.write("endsolid %s\n" % solid)


def fans(points, faces):
    return [(points[f[0]], points[f[k]], points[f[k + 1]])
            for f in faces for k in range(1, len(f) - 1)]


def box(a, b):
    points = [(x, y, z) for z in (a[2], b[2]) for y in (a[1], b[1])
              for x in (a[0], b[0])]
    return fans(points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4),
                         (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])


def circle(i, n, radius, z):
    angle = 2*math.pi*(i % n)/n
    return (radius*math.cos(angle), radius*math.sin(angle), z)


def tube(n, m, radius, length):
    """Triangles of n times m rectangles, normals outwards"""
    made = []
    for j in range(m):
        low, high = length*j/m, length*(j + 1)/m
        for i in range(n):
            a, b = circle(i, n, radius, low), circle(i + 1, n, radius, low)
            c, d = circle(i + 1, n, radius, high), circle(i, n, radius, high)
            made += [(a, b, c), (a, c, d)]
    return made


def feet(legs):
    """A block on feet, which begin inside of the block or below it"""
    made = box((0, -.2, .05), (1, .2, .35))
    for x in (.2, .8):
        for y in (-.12, .12):
            made += box((x - .03, y - .03, 0), (x + .03, y + .03, legs))
    write("feet", {"body": made})


def roundFeet():
    """Half of a plate with a foot of 16 sides in one piece with it: the bottom
    of the foot is in z = 0, and the plate is open at y = 0"""
    n, r = 16, .1
    square = [(.5, .5), (0, .5), (-.5, .5), (-.5, 0), (-.5, -.5), (0, -.5),
              (.5, -.5), (.5, 0)]
    rim = [(circle(i, n, r, 0)[0], circle(i, n, r, 0)[1] + .5)
           for i in range(n)]
    faces = []
    for i in range(n):
        (a, b), (c, d) = rim[i], rim[(i + 1) % n]
        faces.append(((a, b, 0), (a, b, .2), (c, d, .2), (c, d, 0))[::-1])
        faces.append(((0, .5, 0), (c, d, 0), (a, b, 0)))
    # The lower side of the plate around the foot, corner by corner
    outer = [(x, y + .5) for x, y in
             ((.5, 0), (.5, .5), (0, .5), (-.5, .5), (-.5, 0), (-.5, -.5),
              (0, -.5), (.5, -.5))]
    for i in range(8):
        p, q = outer[i], outer[(i + 1) % 8]
        a, b, c = rim[2*i], rim[2*i + 1], rim[(2*i + 2) % n]
        faces.append([(x, y, .2) for x, y in (p, a, b)])
        faces.append([(x, y, .2) for x, y in (p, b, q)])
        faces.append([(x, y, .2) for x, y in (q, b, c)])
        if i not in (5, 6):     # Open at y = 0
            faces.append(((*p, .2), (*q, .2), (*q, .3), (*p, .3)))
    faces.append([(*p, .3) for p in outer])
    write("roundFeet", {"plate": [t for f in faces
                                  for t in fans(f, [range(len(f))])]})


def overlap(k):
    """A pyramid whose base is in z = 0, and a block that overlaps it"""
    base = [[(0, .1), (3, .1), (3, .5), (1, .5), (0, .3)],
            [(0, .1), (3, .1), (1.5, .5), (1, .5), (.3, .3), (0, .2)],
            [(0, .1), (3, .1), (1.5, .5), (0, .2)]][k]
    n = len(base)
    points = [(x, y, 0) for x, y in base] + [(1.2, .25, .5)]
    pyramid = fans(points, [[0] + list(range(n - 1, 0, -1))]
                   + [(i, (i + 1) % n, n) for i in range(n)])
    write("overlap", {"pyramid": pyramid,
                      "block": box((1.2, .02, .15), (1.6, .4, .9))})


def terrain(foundation):
    """A ground with its normals down, and a house on it"""
    n = 12
    at = [-20 + 40*i/n for i in range(n + 1)]

    def height(x, y):
        return .3*math.sin(x/6)*math.cos(y/7)

    ground = []
    for i in range(n):
        for j in range(n):
            p = [(x, y, height(x, y)) for x, y in
                 ((at[i], at[j]), (at[i + 1], at[j]), (at[i + 1], at[j + 1]),
                  (at[i], at[j + 1]))]
            ground += [(p[0], p[2], p[1]), (p[0], p[3], p[2])]
    write("terrain", {"ground": ground,
                      "house": box((-2, -3, -foundation), (3, 2, 4))})


def caps(n):
    """A tube of 26 facets whose ends are strips of n points"""
    def cap(z):
        made, a, b = [], 0, n - 1
        while b - a > 1:
            made.append([circle(i, n, 1, z) for i in (a, a + 1, b)])
            a += 1
            if b - a > 1:
                made.append([circle(i, n, 1, z) for i in (a, b - 1, b)])
                b -= 1
        return made

    write("caps", {"wall": tube(26, 60, 1, 45),
                   "inlet": [t[::-1] for t in cap(0)], "outlet": cap(45)})


def finerCaps():
    """A tube of 50 facets whose ends, both oriented alike, have 100 points"""
    ends = [[[circle(i, 100, .05, z) for i in (0, k, k + 1)]
             for k in range(1, 99)] for z in (0, .4)]
    write("finerCaps", {"wall": tube(50, 20, .05, .4),
                        "inlet": ends[0], "outlet": ends[1]})


def channel():
    """A channel with a round sill, on whose arc the bed has 18 points and the
    sides have 11: chords of the sides are up to 0.02 from the arc"""
    def arc(n):
        return [(4 + 1.5*(1 - math.cos(math.pi*k/n)),
                 1.5*math.sin(math.pi*k/n)) for k in range(n + 1)]

    length, height, width = 12, 3, 2
    q = arc(10)
    l, r = (0, height), (length, height)
    section = [((0, 0), q[0], l), (q[-1], (length, 0), r), (q[5], r, l)]
    section += [(q[k], q[k + 1], l if k < 5 else r) for k in range(10)]
    line = [(0, 0)] + arc(17) + [(length, 0)]

    def strip(a, b):
        return fans([(a[0], 0, a[1]), (b[0], 0, b[1]), (b[0], width, b[1]),
                     (a[0], width, a[1])], [range(4)])

    write("channel", {
        "bed": [t for a, b in zip(line, line[1:]) for t in strip(a, b)],
        "sides": [[(x, y, z) for x, z in t] for y in (0, width)
                  for t in section],
        "top": strip(l, r), "inlet": strip((0, 0), l),
        "outlet": strip((length, 0), r)})


def prism():
    """Twelve sides of an open prism, in two solids"""
    sides = tube(12, 1, .5, 2)
    write("prism", {"right": sides[-6:] + sides[:6], "left": sides[6:-6]})


def domain():
    """A body, and a box around it that does not touch it"""
    write("domain", {"body": box((-.5, -.5, -.5), (.5, .5, .5)),
                     "around": box((-2, -2, -2), (2, 2, 2))})


def nested():
    """A box in a box in a box"""
    write("nested", {name: box((-r, -r, -r), (r, r, r))
                     for name, r in (("outer", 2), ("middle", 1),
                                     ("inner", .5))})


if __name__ == "__main__":
    globals()[sys.argv[1]](*map(float if "." in "".join(sys.argv[2:]) else int,
                                sys.argv[2:]))
