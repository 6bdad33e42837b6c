/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSurface.H"
#include "CompactListList.H"
#include "disjointSets.H"
#include "pointOrder.H"
#include "ranges.H"
#include "triSurface.H"
#include "wallSides.H"

#include <algorithm>

namespace Foam
{

//- Visit (low, high, face, up) of every side
template<class Visitor>
static void visitSides(const faceList& faces, const Visitor& visit)
{
    forAll(faces, facei)
    {
        const face& f = faces[facei];

        forAll(f, i)
        {
            const label a = f[i];
            const label b = f[f.fcIndex(i)];

            if (a != b)
            {
                visit(wallSide{min(a, b), max(a, b), facei, a < b});
            }
        }
    }
}


bool hasRepeatedPoint(const face& f)
{
    for (label i = 0; i < f.size(); ++i)
    {
        if (f[i] == f[f.fcIndex(i)])
        {
            return true;
        }
    }

    return false;
}


wallSides makeWallSides(const faceList& faces, const label nPoints)
{
    // A counting sort on low leaves runs of a few sides to be sorted by high
    labelList nSides(nPoints, Zero);
    visitSides(faces, [&](const wallSide& s) { ++nSides[s.low]; });

    CompactListList<wallSide> byLow(nSides);
    List<wallSide>& sides = byLow.m();
    labelList next(SubList<label>(byLow.offsets(), nPoints));
    visitSides(faces, [&](const wallSide& s) { sides[next[s.low]++] = s; });

    #pragma omp parallel for schedule(static, 256)
    for (label p = 0; p < nPoints; ++p)
    {
        UList<wallSide> run(byLow[p]);

        std::stable_sort
        (
            run.begin(),
            run.end(),
            [](const wallSide& s, const wallSide& t)
            {
                return s.high < t.high;
            }
        );
    }

    DynamicList<label> edgeStarts(sides.size()/2 + 1);
    forAll(sides, i)
    {
        if
        (
            i == 0
         || sides[i].low != sides[i - 1].low
         || sides[i].high != sides[i - 1].high
        )
        {
            edgeStarts.append(i);
        }
    }
    edgeStarts.append(sides.size());

    wallSides result;
    result.sides.transfer(sides);
    result.edgeStarts.transfer(edgeStarts);

    return result;
}


label findComponents
(
    const wallSides& sides,
    const label nFaces,
    labelList& componentOfFace,
    const label maxOnEdge
)
{
    disjointSets sets(nFaces);

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        if (sides.on(e).size() > maxOnEdge)
        {
            continue;
        }

        for (const wallSide& s : sides.on(e))
        {
            sets.join(sides.on(e)[0].facei, s.facei);
        }
    }

    componentOfFace.setSize(nFaces);
    label nComponents = 0;

    for (label i = 0; i < nFaces; ++i)
    {
        // The representative of a set is its first member
        const label first = sets.find(i);
        componentOfFace[i] =
            (first == i ? nComponents++ : componentOfFace[first]);
    }

    return nComponents;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

vectorField wallSurface::faceNormals() const
{
    vectorField normals(faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(faces, i)
    {
        const vector area(faces[i].areaNormal(points));
        const scalar size = mag(area);
        normals[i] = (size > 0 ? area/size : vector::zero);
    }

    return normals;
}


scalarField meanEdges(const wallSurface& wall, const wallAddressing& addressing)
{
    scalarField means(wall.points.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(means, p)
    {
        const labelList& neighbours = addressing.pointPoints[p];

        for (const label q : neighbours)
        {
            means[p] += mag(wall.points[q] - wall.points[p])/neighbours.size();
        }
    }

    return means;
}


scalar enclosedVolume(const wallSurface& wall)
{
    const point& origin = wall.points[0];
    scalar volume = 0;

    const auto add = [&](const faceList& faces, const pointField& points)
    {
        for (const face& f : faces)
        {
            volume += (f.centre(points) - origin) & f.areaNormal(points);
        }
    };

    add(wall.faces, wall.points);
    for (const sidePatch& side : wall.border.sides)
    {
        add(side.faces, side.points);
    }

    return volume/3;
}


labelList largestFaces(const wallSurface& wall)
{
    disjointSets components(connectedPoints(wall.points.size(), wall.faces));

    labelList largest(wall.points.size(), -1);
    scalarField areas(wall.points.size(), -1);
    forAll(wall.faces, facei)
    {
        const label component = components.find(wall.faces[facei][0]);
        const scalar area = wall.faces[facei].mag(wall.points);

        if (area > areas[component])
        {
            areas[component] = area;
            largest[component] = facei;
        }
    }

    return subsetList(largest, [](const label facei) { return facei >= 0; });
}


faceList wallTriangles(const wallSurface& wall, labelList& triangleFace)
{
    label nTriangles = 0;

    for (const face& f : wall.faces)
    {
        nTriangles += max(label(0), f.size() - 2);
    }

    faceList triangles(nTriangles, face(3));
    triangleFace.setSize(nTriangles);

    label i = 0;
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        for (label j = 2; j < f.size(); ++j)
        {
            face& t = triangles[i];
            t[0] = f[0];
            t[1] = f[j - 1];
            t[2] = f[j];
            triangleFace[i++] = facei;
        }
    }

    return triangles;
}


triSurface toTriSurface(const wallSurface& wall)
{
    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));

    List<labelledTri> tris(triangles.size());
    forAll(tris, i)
    {
        const face& f = triangles[i];
        tris[i] = labelledTri(f[0], f[1], f[2], 0);
    }

    return triSurface(tris, wall.points);
}


// * * * * * * * * * * * * * *  Wall Addressing  * * * * * * * * * * * * * * //

namespace
{

//- A corner of a face at a point: the points after and before it
struct wallCorner
{
    label next;
    label previous;
    label facei;
};

} // End anonymous namespace


typedef CompactListList<wallCorner> wallCorners;


//- The corners at each point
static wallCorners makeCorners(const wallSurface& wall)
{
    labelList nCorners(wall.points.size(), Zero);

    for (const face& f : wall.faces)
    {
        for (const label p : f)
        {
            ++nCorners[p];
        }
    }

    wallCorners corners(nCorners);
    labelList next(SubList<label>(corners.offsets(), nCorners.size()));
    forAll(wall.faces, facei)
    {
        const face& f = wall.faces[facei];

        forAll(f, i)
        {
            corners.m()[next[f[i]]++] =
                {f[f.fcIndex(i)], f[f.rcIndex(i)], facei};
        }
    }

    return corners;
}


//- Returns the corner that begins at an edge on which none ends. If there is no
//  such edge, returns the corner whose next point is before the others.
static label firstCorner
(
    const UList<wallCorner>& corners,
    const pointField& points
)
{
    label first = 0;

    forAll(corners, i)
    {
        const bool follows = anyOf(corners, [&](const wallCorner& other)
        {
            return other.previous == corners[i].next;
        });

        if (!follows)
        {
            return i;
        }
        if (isBefore(points[corners[i].next], points[corners[first].next]))
        {
            first = i;
        }
    }

    return first;
}


//- Sorts corners so that each begins at the edge on which the one before ends.
//  The first one does not depend on the labels of points and faces.
static void sortByRotation(UList<wallCorner>& corners, const pointField& points)
{
    std::swap(corners[0], corners[firstCorner(corners, points)]);

    for (label i = 1; i < corners.size(); ++i)
    {
        for (label j = i; j < corners.size(); ++j)
        {
            if (corners[j].next == corners[i - 1].previous)
            {
                std::swap(corners[i], corners[j]);
                break;
            }
        }
    }
}


//- The face that runs from a to b; -1 if there is none
static label faceAlong(const wallCorners& corners, const label a, const label b)
{
    for (const wallCorner& corner : corners[a])
    {
        if (corner.next == b)
        {
            return corner.facei;
        }
    }

    return -1;
}


static void setEdges(const wallCorners& corners, wallAddressing& addressing)
{
    DynamicList<edge> edges(corners.m().size()/2);
    DynamicList<labelPair> edgeFaces(corners.m().size()/2);
    forAll(corners, a)
    {
        for (const wallCorner& corner : corners[a])
        {
            const label b = corner.next;
            const label other = faceAlong(corners, b, a);

            if (a < b || other < 0)
            {
                edges.append(edge(a, b));
                edgeFaces.append(labelPair(corner.facei, other));
            }
        }
    }

    addressing.edges.transfer(edges);
    addressing.edgeFaces.transfer(edgeFaces);
}


static void setPointSides(const wallSurface& wall, wallAddressing& addressing)
{
    if (wall.border.edges.empty())
    {
        return;
    }

    addressing.pointSides.setSize(wall.points.size(), labelPair(-1, -1));

    const Map<labelPair> sides(wall.border.pointSides());
    forAllConstIters(sides, iter)
    {
        addressing.pointSides[iter.key()] = iter.val();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList wallAddressing::sidesOf(const label p) const
{
    if (!isOnBorder(p))
    {
        return labelList();
    }

    const labelPair& sides = pointSides[p];

    return sides.first() == sides.second()
      ? labelList({sides.first()})
      : labelList({sides.first(), sides.second()});
}


wallAddressing makeWallAddressing(const wallSurface& wall)
{
    wallCorners corners(makeCorners(wall));

    wallAddressing addressing;
    setEdges(corners, addressing);

    addressing.pointFaces.setSize(corners.size());
    addressing.pointPoints.setSize(corners.size());

    #pragma omp parallel for schedule(static, 256)
    for (label p = 0; p < corners.size(); ++p)
    {
        UList<wallCorner> around(corners[p]);
        if (around.empty())
        {
            continue;
        }
        sortByRotation(around, wall.points);

        labelList& faces = addressing.pointFaces[p];
        labelList& points = addressing.pointPoints[p];
        faces.setSize(around.size());
        points.setSize(around.size());

        forAll(around, i)
        {
            faces[i] = around[i].facei;
            points[i] = around[i].next;
        }

        // On a border the last edge begins no corner
        if (around.last().previous != points[0])
        {
            points.append(around.last().previous);
        }
    }

    setPointSides(wall, addressing);

    return addressing;
}

} // End namespace Foam

// ************************************************************************* //
