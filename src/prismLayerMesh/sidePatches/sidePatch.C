/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sidePatch.H"
#include "ranges.H"
#include "sideShape.H"
#include "DynamicList.H"
#include "EdgeMap.H"
#include "error.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Bound on the projections, in turn, on side patches some of which are curved
static constexpr label maxPasses = 20;


//- The move of x onto a plane that leaves it on those before, whose directions
//  are orthonormal; the direction of the move is added to them
static point movedOnto
(
    const sidePlane& side,
    const point& x,
    DynamicList<vector>& directions
)
{
    vector e(side.normal);
    for (const vector& d : directions)
    {
        e -= (e & d)*d;
    }

    // The same plane once more
    if (magSqr(e) < 1e-12)
    {
        return x;
    }

    e.normalise();
    directions.append(e);

    return x - side.distance(x)/(side.normal & e)*e;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

sidePlane sidePatch::planeAt(const point& x) const
{
    return shape ? shape->planeAt(x) : sidePlane(*this);
}


Map<labelPair> wallBorder::pointSides() const
{
    Map<labelPair> sides(2*edges.size());

    forAll(edges, i)
    {
        sides(edges[i].start(), labelPair(-1, -1)).first() = edgeSides[i];
        sides(edges[i].end(), labelPair(-1, -1)).second() = edgeSides[i];
    }

    return sides;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void checkSides
(
    const UList<sidePatch>& sides,
    const UList<word>& wallPatchNames
)
{
    for (const sidePatch& side : sides)
    {
        if (wallPatchNames.found(side.name))
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " has the name of a patch"
                << " of the wall" << exit(FatalError);
        }

        if
        (
            side.isCurved()
         && (side.type == "symmetryPlane" || side.type == "empty")
        )
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " of type " << side.type
                << " is curved near " << side.origin << exit(FatalError);
        }

        for (const sidePatch& other : sides)
        {
            if
            (
                other.name == side.name && side.type == "symmetryPlane"
             && (side.normal & other.normal) < 1 - 1e-6
            )
            {
                FatalErrorInFunction
                    << "The side patch " << side.name << " of type"
                    << " symmetryPlane is in several planes, at "
                    << side.origin << " and at " << other.origin << nl
                    << "Give it the type symmetry" << exit(FatalError);
            }
        }
    }
}


bool hasPlanes(const UList<sidePatch>& sides)
{
    return anyOf(sides, [](const sidePatch& side) { return !side.isPart(); });
}


edgeList outline(const faceList& faces)
{
    EdgeMap<label> nFaces;
    for (const face& f : faces)
    {
        for (const edge& e : f.edges())
        {
            ++nFaces(e, 0);
        }
    }

    DynamicList<edge> edges;
    for (const face& f : faces)
    {
        forAll(f, k)
        {
            if (nFaces[f.faceEdge(k)] == 1)
            {
                edges.append(f.faceEdge(k));
            }
        }
    }

    return edgeList(std::move(edges));
}


point onAll
(
    const UList<sidePatch>& sides,
    const labelUList& some,
    point x
)
{
    // In planes the second pass takes away the rounding of the first
    const bool isCurved =
        anyOf(some, [&](const label s) { return sides[s].isCurved(); });

    const auto move = [&]()
    {
        const point before(x);
        DynamicList<vector> directions;

        for (const label s : some)
        {
            x = sides[s].isCurved()
              ? sides[s].shape->nearest(x).rawPoint()
              : movedOnto(sides[s], x, directions);
        }

        return x != before;
    };

    if (isCurved)
    {
        repeatUntilStable("moving onto curved sides", maxPasses, move);
    }
    else if (move())
    {
        move();
    }

    return x;
}

} // End namespace Foam

// ************************************************************************* //
