/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "changedPart.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class ringMaker
{
    const prismLayers& layers_;
    const farFieldMesh& far_;
    const farTets& tets_;

    //- Calls visit(celli, face) for the faces of cells that are no tetrahedra
    template<class Visit>
    void visitOthers(const Visit& visit) const
    {
        const polyMeshTopology& t = far_.topology;
        const bool hasOthers = far_.nCells > tets_.size();
        for (label facei = 0; hasOthers && facei < t.faces.size(); ++facei)
        {
            if (t.owner[facei] >= tets_.size())
            {
                visit(t.owner[facei], t.faces[facei]);
            }
            if (t.beyond(facei) >= tets_.size())
            {
                visit(t.beyond(facei), t.faces[facei]);
            }
        }
    }

    //- Adds the columns on the points of the wall that have one of the columns:
    //  a group may be on all of them
    void addColumns(bitSet& points) const
    {
        bitSet roots(layers_.nColumns());
        for (label c = 0; c < layers_.nColumns(); ++c)
        {
            if (points.test(c))
            {
                roots.set(layers_.root(c));
            }
        }
        for (label c = 0; c < layers_.nColumns(); ++c)
        {
            if (roots.test(layers_.root(c)))
            {
                points.set(c);
            }
        }
    }

public:

    ringMaker
    (
        const prismLayers& layers,
        const farFieldMesh& far,
        const farTets& tets
    )
    :
        layers_(layers),
        far_(far),
        tets_(tets)
    {}

    //- Returns the points of front faces and of cells of the far field
    bitSet pointsOf(const bitSet& frontFaces, const bitSet& farCells) const
    {
        bitSet points(max(layers_.nColumns(), far_.points.size()));
        for (const label facei : frontFaces)
        {
            points.set(layers_.faces[facei]);
        }
        for (const label celli : farCells)
        {
            if (celli < tets_.size())
            {
                points.set(tets_.points(celli));
            }
        }
        visitOthers
        (
            [&](const label celli, const face& f)
            {
                if (farCells.test(celli))
                {
                    points.set(f);
                }
            }
        );
        addColumns(points);

        return points;
    }

    bitSet farCellsAt(const placesInMesh& places) const
    {
        bitSet cells(far_.nCells);
        for (label t = 0; t < tets_.size(); ++t)
        {
            cells.set(t, places.hasOneOf(tets_.points(t)));
        }
        visitOthers
        (
            [&](const label celli, const face& f)
            {
                if (places.hasOneOf(f))
                {
                    cells.set(celli);
                }
            }
        );

        return cells;
    }

    placesInMesh at(bitSet&& points) const
    {
        placesInMesh places{std::move(points), bitSet()};
        places.farCells = farCellsAt(places);

        return places;
    }

    //- Returns the next ring
    placesInMesh around(const placesInMesh& places) const
    {
        bitSet frontFaces(layers_.faces.size());
        forAll(layers_.faces, facei)
        {
            frontFaces.set(facei, places.hasOneOf(layers_.faces[facei]));
        }

        return at(pointsOf(frontFaces, places.farCells));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

changedPart::changedPart
(
    const prismLayers& layers,
    const farFieldMesh& far,
    const farTets& tets,
    const bitSet& frontFaces,
    const bitSet& changedTets
)
{
    if (frontFaces.none() && changedTets.none())
    {
        return;
    }
    const ringMaker rings(layers, far, tets);
    first = rings.around(rings.at(rings.pointsOf(frontFaces, changedTets)));
    second = rings.around(first);
    third = rings.around(second);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

changedPart changedParts::since
(
    const labelUList& starts,
    const groupExceptions& onFront,
    const groupExceptions& inFar
) const
{
    const bitSet frontFaces
    (
        changedBetween
        (
            onFront_, onFront, layers_.faces.size(),
            [&](const label corner) { return findLower(starts, corner + 1); }
        )
    );
    const bitSet tets
    (
        changedBetween
        (
            inFar_, inFar, tets_.size(),
            [](const label corner) { return corner/4; }
        )
    );

    return changedPart(layers_, far_, tets_, frontFaces, tets);
}

} // End namespace Foam

// ************************************************************************* //
