/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "disjointSets.H"
#include "farPolygons.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class farGrouper
{
    const prismLayers& layers_;
    const labelListList& neighbours_;
    const frontGroups& front_;
    const farFieldMesh& far_;
    const farTets& tets_;
    const groupExceptions& exceptions_;

    //- Sides of convex edges: groups of the front, joined where they are on one
    //  side of the edges at a column
    Map<labelList> groupsAt_;

    farGroups groups_;
    label nSplit_ = 0;
    label nApart_ = 0;

    //- Whether the outer surface is convex at the edge of two front faces
    bool isConvex
    (
        const pointField& outer,
        const label facei,
        const label other
    ) const
    {
        const face& f = layers_.faces[facei];
        const vector way
        (
            layers_.faces[other].centre(outer) - f.centre(outer)
        );
        const vector normal(f.unitNormal(outer));

        // At least a turn of some ten degrees
        return (normal & way) < -0.2*mag(way);
    }

    label group(const label facei, const label column) const
    {
        return front_.of(facei, layers_.faces[facei].find(column));
    }

    //- Sets groupsAt_: pairs of a group and the group that stands for its side
    void findSides()
    {
        const pointField outer(layers_.outerPoints());
        List<DynamicList<labelPair>> joined(layers_.nColumns());
        List<DynamicList<label>> groupsOf(layers_.nColumns());
        forAll(layers_.faces, facei)
        {
            const face& f = layers_.faces[facei];
            forAll(f, k)
            {
                const label g = group(facei, f[k]);
                if (!groupsOf[f[k]].found(g))
                {
                    groupsOf[f[k]].append(g);
                }
                const label other = neighbours_[facei][k];
                if (other < facei || isConvex(outer, facei, other))
                {
                    continue;
                }
                for (const label c : {f[k], f.nextLabel(k)})
                {
                    joined[c].append
                    (
                        labelPair(group(facei, c), group(other, c))
                    );
                }
            }
        }
        forAll(groupsOf, c)
        {
            setSides(c, groupsOf[c], joined[c]);
        }
    }

    void setSides
    (
        const label c,
        const UList<label>& groups,
        const UList<labelPair>& joined
    )
    {
        disjointSets sides(groups.size());
        for (const labelPair& pair : joined)
        {
            sides.join(groups.find(pair.first()), groups.find(pair.second()));
        }
        labelList sideOf(2*groups.size());
        bool several = false;
        forAll(groups, i)
        {
            sideOf[2*i] = groups[i];
            sideOf[2*i + 1] = sides.find(i);
            several = several || sides.find(i) > 0;
        }
        if (several)
        {
            groupsAt_.insert(c, sideOf);
        }
    }

    label sideOf(const label c, const label g) const
    {
        const labelList& sides = groupsAt_[c];
        label i = 0;
        while (sides[i] != g)
        {
            i += 2;
        }

        return sides[i + 1];
    }

    //- Mean normals of the outer surface on the sides of a column.
    //  onLayers: the faces of the far field on layers at the column
    Map<vector> normalsOfSides(const label c, const labelUList& onLayers) const
    {
        Map<vector> normals;
        for (const label facei : onLayers)
        {
            const face& f = far_.topology.faces[facei];
            normals(sideBelow(c, facei), Zero) -= f.unitNormal(far_.points);
        }
        forAllIters(normals, iter)
        {
            iter.val().normalise();
        }

        return normals;
    }

    label sideBelow(const label c, const label facei) const
    {
        const label k = facei - far_.topology.patchStarts[0];

        return sideOf(c, group(far_.frontFaces[k], c));
    }

    //- The sides of the tetrahedra at a column: those on the layers are on the
    //  side below, the others on the side whose normal they are most along
    void setSidesOfTets
    (
        const label c,
        const labelUList& around,
        const labelUList& onLayers
    )
    {
        const Map<vector> normals(normalsOfSides(c, onLayers));
        const label first = far_.points.size() + far_.nCells + nSplit_;
        for (const label t : around)
        {
            point centre(Zero);
            for (const label p : tets_.points(t))
            {
                centre += 0.25*far_.points[p];
            }
            scalar most = -GREAT;
            label side = 0;
            for (const label s : normals.sortedToc())
            {
                const scalar along = normals[s] & (centre - far_.points[c]);
                if (along > most)
                {
                    most = along;
                    side = s;
                }
            }
            groups_.ofTets[t][tets_.find(t, c)] = first + side;
        }
        for (const label facei : onLayers)
        {
            const label t = far_.topology.owner[facei];
            groups_.ofTets[t][tets_.find(t, c)] = first + sideBelow(c, facei);
        }
        nSplit_ += groupsAt_[c].size()/2;
    }

    void split()
    {
        Map<DynamicList<label>> around;
        forAll(groups_.ofTets, t)
        {
            for (const label p : tets_.points(t))
            {
                if (groupsAt_.found(p))
                {
                    around(p).append(t);
                }
            }
        }
        Map<DynamicList<label>> onLayers;
        const polyMeshTopology& t = far_.topology;
        forAll(far_.frontFaces, k)
        {
            const label facei = t.patchStarts[0] + k;
            for (const label p : t.faces[facei])
            {
                if (groupsAt_.found(p))
                {
                    onLayers(p).append(facei);
                }
            }
        }
        for (const label c : around.sortedToc())
        {
            setSidesOfTets(c, around[c], onLayers[c]);
        }
    }

    //- The exceptions become groups
    void setApart()
    {
        const label first = far_.points.size() + far_.nCells + nSplit_;
        forAllConstIters(exceptions_.parts(), iter)
        {
            const label corner = iter.key();
            groups_.ofTets[corner/4][corner % 4] = first + iter.val();
        }
        nApart_ = exceptions_.nParts();
        for (const label t : exceptions_.whole)
        {
            groups_.ofTets[t] = first + nApart_++;
        }
    }

    //- Gives numbers without gaps
    void renumber()
    {
        labelList numbers
        (
            far_.points.size() + far_.nCells + nSplit_ + nApart_, -1
        );
        const auto use = [&](const label g) { numbers[g] = 0; };
        for (const FixedList<label, 4>& groups : groups_.ofTets)
        {
            for (const label g : groups)
            {
                use(g);
            }
        }
        for (const label g : groups_.ofOthers)
        {
            use(g);
        }
        for (label& number : numbers)
        {
            number = number < 0 ? -1 : groups_.nGroups++;
        }
        for (FixedList<label, 4>& groups : groups_.ofTets)
        {
            for (label& g : groups)
            {
                g = numbers[g];
            }
        }
        for (label& g : groups_.ofOthers)
        {
            g = numbers[g];
        }
    }

public:

    farGrouper
    (
        const prismLayers& layers,
        const labelListList& faceNeighbours,
        const frontGroups& front,
        const farFieldMesh& far,
        const farTets& tets,
        const groupExceptions& exceptions
    )
    :
        layers_(layers),
        neighbours_(faceNeighbours),
        front_(front),
        far_(far),
        tets_(tets),
        exceptions_(exceptions)
    {}

    farGroups make()
    {
        const label nPoints = far_.points.size();
        groups_.ofTets.setSize(tets_.size());
        forAll(groups_.ofTets, t)
        {
            groups_.ofTets[t] = tets_.points(t);
        }
        groups_.ofOthers =
            identity(far_.nCells - tets_.size(), nPoints + tets_.size());
        findSides();
        split();
        setApart();
        renumber();

        return std::move(groups_);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farGroups groupFarField
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const frontGroups& front,
    const farFieldMesh& far,
    const farTets& tets,
    const groupExceptions& exceptions
)
{
    return farGrouper
    (
        layers, faceNeighbours, front, far, tets, exceptions
    ).make();
}

} // End namespace Foam

// ************************************************************************* //
