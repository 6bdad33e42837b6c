/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideGroups.H"

#include "layerGeometry.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The corners of some groups
class cornersOfGroups
{
    Map<DynamicList<label>> corners_;
    Map<label> positions_;

    //- Whether a group is not divided by parts: it is one corner, or its parts
    //  stay together
    static bool isLast
    (
        const UList<label>& corners,
        const groupExceptions& exceptions
    )
    {
        bool isOnePart = true;
        for (const label corner : corners)
        {
            isOnePart = isOnePart
             && exceptions.part(corner) == exceptions.part(corners[0]);
        }

        return corners.size() == 1 || !isOnePart;
    }

public:

    void append(const label group, const label corner)
    {
        DynamicList<label>& of = corners_(group);
        positions_.insert(corner, of.size());
        of.append(corner);
    }

    //- Divides the groups.
    //  partOf(corner): the front face, or tetrahedron
    //  place(corner): as groupExceptions::divide has it
    //  visitBeside(corner, visit): calls visit for corners that are connected
    //  with a corner, and come before it
    template<class PartOf, class Place, class VisitBeside>
    bitSet divide
    (
        const label nGroups,
        const PartOf& partOf,
        const Place& place,
        const VisitBeside& visitBeside,
        groupExceptions& exceptions
    ) const
    {
        bitSet changed(nGroups);
        for (const label g : corners_.sortedToc())
        {
            const DynamicList<label>& corners = corners_[g];
            const label first = partOf(corners[0]);
            if (isLast(corners, exceptions) || exceptions.whole.test(first))
            {
                changed.set(g, exceptions.whole.set(first));
                continue;
            }
            List<vector> places(corners.size());
            DynamicList<labelPair> beside;
            forAll(corners, i)
            {
                places[i] = place(corners[i]);
                visitBeside(corners[i], [&](const label other)
                {
                    const label j = positions_.lookup(other, -1);
                    const bool isHere = j >= 0 && j < corners.size();
                    if (isHere && corners[j] == other)
                    {
                        beside.append(labelPair(i, j));
                    }
                });
            }
            exceptions.divide(corners, places, beside);
            changed.set(g);
        }

        return changed;
    }
};

//- The sum of the normals of a front face at the wall and at the outer surface.
//  Where these are equal, the way from the column of a corner decides.
vector bendOf(const prismLayers& layers, const label facei, const label k)
{
    const face& f = layers.faces[facei];
    const faceGeometry below(levelPoints{layers, f, 0});
    const faceGeometry above(levelPoints{layers, f, layers.nLayers});
    const vector way(above.centre - layers(f[k], layers.nLayers));

    return
        normalised(below.area) + normalised(above.area) + 0.1*normalised(way);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet divideFrontGroups
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const frontGroups& front,
    const bitSet& wanted,
    groupExceptions& exceptions
)
{
    cornersOfGroups corners;
    labelList faceOf(front.starts.last());
    forAll(layers.faces, facei)
    {
        forAll(layers.faces[facei], k)
        {
            const label corner = front.starts[facei] + k;
            faceOf[corner] = facei;
            if (wanted.test(front.groups[corner]))
            {
                corners.append(front.groups[corner], corner);
            }
        }
    }

    const auto place = [&](const label corner)
    {
        const label facei = faceOf[corner];

        return bendOf(layers, facei, corner - front.starts[facei]);
    };
    const auto visitBeside = [&](const label corner, const auto& visit)
    {
        const label facei = faceOf[corner];
        const face& f = layers.faces[facei];
        const label k = corner - front.starts[facei];
        for (const label e : {k, f.rcIndex(k)})
        {
            const label other = faceNeighbours[facei][e];
            if (other >= 0)
            {
                visit(front.starts[other] + layers.faces[other].find(f[k]));
            }
        }
    };

    return corners.divide
    (
        front.nGroups, [&](const label corner) { return faceOf[corner]; },
        place, visitBeside, exceptions
    );
}


bitSet divideFarGroups
(
    const farFieldMesh& far,
    const farTets& tets,
    const farGroups& groups,
    const bitSet& wanted,
    groupExceptions& exceptions
)
{
    cornersOfGroups corners;
    forAll(groups.ofTets, t)
    {
        for (label k = 0; k < 4; ++k)
        {
            if (wanted.test(groups.ofTets[t][k]))
            {
                corners.append(groups.ofTets[t][k], 4*t + k);
            }
        }
    }
    const auto place = [&](const label corner)
    {
        point centre(Zero);
        for (const label p : tets.points(corner/4))
        {
            centre += 0.25*far.points[p];
        }

        return centre;
    };
    const polyMeshTopology& topology = far.topology;
    const auto visitBeside = [&](const label corner, const auto& visit)
    {
        const label t = corner/4;
        for (label k = 0; k < 4; ++k)
        {
            const label facei = tets.faces(t)[k];
            if (k == corner % 4 || facei >= topology.neighbour.size())
            {
                continue;
            }
            const label owner = topology.owner[facei];
            const label other =
                owner == t ? topology.neighbour[facei] : owner;
            if (other < tets.size())
            {
                const label p = tets.points(t)[corner % 4];
                visit(4*other + tets.find(other, p));
            }
        }
    };

    return corners.divide
    (
        groups.nGroups, [](const label corner) { return corner/4; }, place,
        visitBeside, exceptions
    );
}

} // End namespace Foam

// ************************************************************************* //
