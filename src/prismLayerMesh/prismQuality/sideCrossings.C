/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideCrossings.H"
#include "ListOps.H"
#include "partCrossings.H"
#include "ranges.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A side patch and the columns that stand on it
struct sideColumns
{
    const prismLayers& layers;
    const sidePatch& side;
    labelHashSet columns;

    //- A side patch of each column on one
    const Map<label>& sideOf;

    sideColumns(const prismLayers& l, const label s, const Map<label>& of)
    :
        layers(l),
        side(l.border.sides[s]),
        sideOf(of)
    {
        forAll(layers.border.edges, i)
        {
            if (layers.border.edgeSides[i] == s)
            {
                columns.insert(layers.border.edges[i]);
            }
        }
    }


    bool touches(const face& f) const
    {
        return anyOf(f, [&](const label c) { return columns.found(c); });
    }


    //- Whether a point of a column is on a side patch that continues this one
    bool isContinued(const label c, const point& x) const
    {
        const auto other = sideOf.cfind(c);

        return other.found() && side.isCurved()
            && (
                   side.planeAt(x).normal
                 & layers.border.sides[*other].planeAt(x).normal
               ) > curvedCosine;
    }


    //- Whether a stack has points that are not in front of the side patch, but
    //  for the columns on it, and those that begin beyond its plane: on a side
    //  patch with a reflex angle to it
    bool isBeyond(const face& f) const
    {
        for (const label c : f)
        {
            if (columns.found(c) || side.distance(layers(c, 0)) >= 0)
            {
                continue;
            }

            for (label i = 1; i <= layers.nLayers; ++i)
            {
                const point& x = layers(c, i);

                if (side.distance(x) >= 0 && !isContinued(c, x))
                {
                    return true;
                }
            }
        }

        return false;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList findSideCrossings
(
    const prismLayers& layers,
    const labelUList& faces,
    const columnTeam& team
)
{
    labelHashSet crossing;
    Map<label> sideOf;
    forAll(layers.border.edges, i)
    {
        const edge& e = layers.border.edges[i];
        sideOf.set(e.start(), layers.border.edgeSides[i]);
        sideOf.set(e.end(), layers.border.edgeSides[i]);
    }

    forAll(layers.border.sides, s)
    {
        const sideColumns columns(layers, s, sideOf);
        const bool isPart = columns.side.isPart();

        for (const label facei : faces)
        {
            const face& f = layers.faces[facei];

            if ((!isPart || columns.touches(f)) && columns.isBeyond(f))
            {
                crossing.insert(facei);
            }
        }

        if (isPart)
        {
            const auto isApart = [&](const label facei)
            {
                return !columns.touches(layers.faces[facei]);
            };
            crossing.insert
            (
                facesThroughPart(layers, s, subsetList(faces, isApart), team)
            );
        }
    }

    return crossing.sortedToc();
}

} // End namespace Foam

// ************************************************************************* //
