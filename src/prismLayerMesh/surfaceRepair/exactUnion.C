/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactUnion.H"
#include "bitSet.H"
#include "ListOps.H"
#include "mergeNearPoints.H"
#include "orientation.H"
#include "ranges.H"
#include "surfacePart.H"
#include "triangleIndex.H"
#include "unionBoundary.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points are one if they are nearer than this share of the diagonal of the
//  bounding box
static constexpr scalar rounding = 1e-12;


namespace
{

//- Faces but for faces with a point twice, and for pairs of faces on the same
//  points that are oriented otherwise
faceList withoutCollapsed(const faceList& faces)
{
    bitSet isKept(faces.size());
    triangleIndex single(2*faces.size());

    forAll(faces, i)
    {
        const face& f = faces[i];
        if (hasRepeatedPoint(f))
        {
            continue;
        }

        isKept.set(i);
        const triFace key(f);
        const label j = single.lookup(key, -1);
        if (j < 0)
        {
            single.insert(key, i);
        }
        else if (face::compare(faces[j], f) < 0)
        {
            isKept.unset(i);
            isKept.unset(j);
            single.erase(key);
        }
    }

    return subset(isKept, faces);
}


//- Makes points whose distance is rounding one; faces lose their patches
void mergeRounded(wallSurface& surface)
{
    wallReading untold;
    surface.patchIDs = labelList(surface.faces.size(), 0);
    mergeNearPoints(surface, rounding, untold);
}


//- The triangles of a surface but for triangles whose area is zero, exactly
faceList trianglesWithArea(const wallSurface& surface)
{
    labelList faceOf;
    const faceList triangles(wallTriangles(surface, faceOf));

    return subsetList(triangles, [&](const face& f)
    {
        const pointField& x = surface.points;

        return !isCollinear(x[f[0]], x[f[1]], x[f[2]]);
    });
}


//- Marks faces of components, connected by edges, that have no positive volume:
//  their normals point into them. Returns the number of such components.
label findInward(const wallSurface& surface, bitSet& isInward)
{
    const faceList& faces = surface.faces;
    const pointField& points = surface.points;
    labelList componentOf;
    const label nComponents = findComponents
    (
        makeWallSides(faces, points.size()), faces.size(), componentOf
    );

    scalarList volumes(nComponents, Zero);
    labelList firsts(nComponents, -1);
    forAll(faces, i)
    {
        const face& f = faces[i];
        label& first = firsts[componentOf[i]];
        first = first < 0 ? f[0] : first;
        const point& a = points[f[0]];
        volumes[componentOf[i]] +=
            (a - points[first]) & ((points[f[1]] - a) ^ (points[f[2]] - a));
    }

    isInward.resize(faces.size());
    forAll(faces, i)
    {
        isInward.set(i, volumes[componentOf[i]] <= 0);
    }

    return countOf(volumes, [](const scalar v) { return v <= 0; });
}


//- Turns components that have no positive volume
void turnOutwards(wallSurface& surface)
{
    bitSet isInward;
    findInward(surface, isInward);
    for (const label i : isInward)
    {
        surface.faces[i].flip();
    }
}


//- Removes components that have no positive volume: the boundaries of voids.
//  Returns their number.
label fillVoids(wallSurface& surface)
{
    bitSet isInward;
    const label nVoids = findInward(surface, isInward);
    surface.faces = subset(isInward, surface.faces, true);

    return nVoids;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isBalanced(const wallSurface& surface)
{
    const wallSides sides(makeWallSides(surface));

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        label balance = 0;
        for (const wallSide& s : sides.on(e))
        {
            balance += s.up ? 1 : -1;
        }
        if (balance)
        {
            return false;
        }
    }

    return true;
}


void uniteExactly(wallSurface& surface, repairSteps& steps)
{
    mergeRounded(surface);
    surface.faces = trianglesWithArea(surface);
    turnOutwards(surface);

    unionBoundary boundary(findUnionBoundary(surface));
    addStep(steps, "faces divided where bodies meet", boundary.nDivided);
    addStep(steps, "faces removed inside of other bodies", boundary.nInside);

    surface.points = boundary.points;
    surface.faces = boundary.faces;
    mergeRounded(surface);
    surface.faces = withoutCollapsed(surface.faces);
    addStep(steps, "voids between bodies filled", fillVoids(surface));
    removeUnusedPoints(surface.faces, surface.points);
}

} // End namespace Foam

// ************************************************************************* //
