/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideBorders.H"
#include "checkInFront.H"
#include "StringStream.H"
#include "wallSides.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct borderFinder
{
    const wallSurface& surface;
    const sideParts& parts;
    const UList<sidePatch>& planes;
    const scalar tolerance;

    sideBorders borders{};


    //- The side patch of the plane that is nearest to both ends of an edge, -1
    //  if none is near
    label planeOf(const wallSide& edge) const;

    void addPointSide(const label p, const label s)
    {
        if (!borders.pointSides[p].found(s))
        {
            borders.pointSides[p].append(s);
        }
    }

    //- An edge of a face is on a side patch: a border if the face is the wall's
    void addBorder(const wallSide& edge, const label side);

    //- Adds the border on an edge, if there is one. Returns false if the edge
    //  has one face and is near no plane.
    bool addBorders(const UList<wallSide>& onEdge);

    //- Refuses borders at some places: no plane is near to them
    void refuseFar(const UList<point>& places) const;

    //- The points of faces on side patches are on these patches
    void addPointsOfSides();

    sideBorders find();
};


label borderFinder::planeOf(const wallSide& edge) const
{
    label nearest = -1;
    scalar least = tolerance;

    forAll(planes, i)
    {
        const scalar distance = max
        (
            mag(planes[i].distance(surface.points[edge.low])),
            mag(planes[i].distance(surface.points[edge.high]))
        );

        if (distance <= least)
        {
            least = distance;
            nearest = parts.sides.size() + i;
        }
    }

    return nearest;
}


void borderFinder::addBorder(const wallSide& edge, const label side)
{
    addPointSide(edge.low, side);
    addPointSide(edge.high, side);

    if (parts.sideOfFace[edge.facei] < 0)
    {
        borders.edges.append(edge.along());
        borders.edgeSides.append(side);
    }
}


bool borderFinder::addBorders(const UList<wallSide>& onEdge)
{
    const wallSide& first = onEdge[0];

    if (onEdge.size() == 1)
    {
        const label plane = planeOf(first);
        if (plane >= 0)
        {
            addBorder(first, plane);
        }
        return plane >= 0;
    }

    const wallSide& second = onEdge[1];
    const label side = parts.sideOfFace[first.facei];
    const label other = parts.sideOfFace[second.facei];

    if (side < 0 && other >= 0)
    {
        addBorder(first, other);
    }
    else if (side >= 0 && other < 0)
    {
        addBorder(second, side);
    }

    return true;
}


void borderFinder::refuseFar(const UList<point>& places) const
{
    OStringStream bound;
    bound << tolerance;
    refuseAt
    (
        places,
        "The surface is open and its border is further than " + bound.str()
      + " m from all side planes"
    );
}


void borderFinder::addPointsOfSides()
{
    forAll(parts.sideOfFace, facei)
    {
        const face& f = surface.faces[facei];
        const label side = parts.sideOfFace[facei];

        for (label k = 0; side >= 0 && k < f.size(); ++k)
        {
            addPointSide(f[k], side);
        }
    }
}


sideBorders borderFinder::find()
{
    borders.pointSides.setSize(surface.points.size());
    const wallSides edges(makeWallSides(surface));
    DynamicList<point> lost;

    for (label e = 0; e < edges.nEdges(); ++e)
    {
        if (!addBorders(edges.on(e)))
        {
            const wallSide& side = edges.on(e)[0];
            lost.append
            (
                0.5*(surface.points[side.low] + surface.points[side.high])
            );
        }
    }

    refuseFar(lost);
    addPointsOfSides();

    return borders;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

sideBorders findSideBorders
(
    const wallSurface& surface,
    const sideParts& parts,
    const UList<sidePatch>& planes,
    const scalar tolerance
)
{
    return borderFinder{surface, parts, planes, tolerance}.find();
}

} // End namespace Foam

// ************************************************************************* //
