/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideSidePart.H"
#include "bitSet.H"
#include "edgeHashes.H"
#include "EdgeMap.H"
#include "ListOps.H"
#include "sidePatch.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class partDivider
{
    sectoredSurface& sectored_;
    wallSurface& surface_;
    const label part_;
    const scalar tolerance_;
    const labelList faces_;

    //- Edges between the part and the wall, and points of other parts
    edgeHashSet border_;
    bitSet onOthers_;

    sidePlane plane_;

    //- Distance [m] of each point from the plane, 0 for points on the plane
    scalarField distances_;

    //- The points at which edges cross the plane
    EdgeMap<label> crossings_;


    void findBorder()
    {
        edgeHashSet edges;
        for (const label f : faces_)
        {
            edges.insert(surface_.faces[f].edges());
        }

        onOthers_.setSize(surface_.points.size());
        forAll(surface_.faces, facei)
        {
            const face& f = surface_.faces[facei];

            if (sectored_.parts[facei] < 0)
            {
                for (const edge& e : f.edges())
                {
                    if (edges.found(e))
                    {
                        border_.insert(e);
                    }
                }
            }
            else if (sectored_.parts[facei] != part_)
            {
                onOthers_.set(f);
            }
        }
    }


    //- Through the middle of the part, between the faces that are nearer in
    //  their normals to one of those that differ most, and to the other
    void setPlane()
    {
        vectorField areas(faces_.size());
        point middle(Zero);
        forAll(faces_, i)
        {
            const face& f = surface_.faces[faces_[i]];
            areas[i] = f.areaNormal(surface_.points);
            middle += mag(areas[i])*f.centre(surface_.points);
        }

        vectorField normals(areas);
        for (vector& n : normals)
        {
            n.normalise();
        }
        const vector first(normals[findMin(scalarField(normals & sum(areas)))]);
        const vector second(normals[findMin(scalarField(normals & first))]);

        vector ofFirst(Zero), ofSecond(Zero);
        forAll(normals, i)
        {
            const bool isFirst = (normals[i] & (first - second)) > 0;
            (isFirst ? ofFirst : ofSecond) += areas[i];
        }

        plane_.origin = middle/max(sum(mag(areas)), VSMALL);
        plane_.normal = normalised(ofFirst - ofSecond);
    }


    //- The ends next to the plane of the border's edges that cross it, of those
    //  that are on no other part
    labelList nearPoints() const
    {
        labelHashSet nearest;

        for (const edge& e : border_)
        {
            if (distances_[e.start()]*distances_[e.end()] < 0)
            {
                const bool first =
                    mag(distances_[e.start()]) < mag(distances_[e.end()]);
                const label p = first ? e.start() : e.end();
                const label q = e.otherVertex(p);

                if (!onOthers_.test(p) || !onOthers_.test(q))
                {
                    nearest.insert(onOthers_.test(p) ? q : p);
                }
            }
        }

        return nearest.sortedToc();
    }


    void setDistances()
    {
        forAll(distances_, p)
        {
            const scalar d = plane_.distance(surface_.points[p]);
            distances_[p] = mag(d) < tolerance_ ? 0 : d;
        }
    }


    //- Put the plane through the points at the border that are the furthest
    //  apart, and the others on it
    void putOnBorder()
    {
        setDistances();
        const labelList ends(nearPoints());
        const pointField& points = surface_.points;

        if (ends.size())
        {
            plane_.origin = points[ends[0]];
            const pointField apart(points, ends);
            const vector along
            (
                apart[findMax(scalarField(mag(apart - apart[0])))] - apart[0]
            );
            const vector e(normalised(along));
            plane_.normal =
                normalised(plane_.normal - (plane_.normal & e)*e);
            setDistances();
        }

        for (const label p : nearPoints())
        {
            distances_[p] = 0;
        }
    }


    void findCrossings()
    {
        DynamicList<point> added;
        const label nPoints = surface_.points.size();

        for (const label f : faces_)
        {
            for (const edge& e : surface_.faces[f].edges())
            {
                const scalar a = distances_[e.start()];
                const scalar b = distances_[e.end()];

                if
                (
                    a*b < 0 && !border_.found(e)
                 && crossings_.insert(e, nPoints + added.size())
                )
                {
                    added.append
                    (
                        (b*surface_.points[e.start()]
                      - a*surface_.points[e.end()])/(b - a)
                    );
                }
            }
        }

        surface_.points.append(added);
        distances_.resize(surface_.points.size(), 0);
    }


    //- A face in triangles that none of the edges crosses; the face if none
    //  does
    DynamicList<face> pieces(const face& whole) const
    {
        DynamicList<face> left;
        DynamicList<face> done;
        left.append(whole);

        while (left.size())
        {
            const face f(left.remove());
            label k = 0;
            while (k < f.size() && !crossings_.found(f.faceEdge(k)))
            {
                ++k;
            }

            if (k == f.size())
            {
                done.append(f);
                continue;
            }

            const label x = crossings_[f.faceEdge(k)];
            for (label i = 1; i < f.size(); ++i)
            {
                const edge e(f.faceEdge((k + i) % f.size()));
                left.append(face({x, e.start(), e.end()}));
            }
        }

        return done;
    }


    //- Append to values of faces those of the faces that further ones are of
    static void extend(labelList& values, const labelUList& from)
    {
        const labelList added(values, from);
        values.append(added);
    }


    void cutFaces()
    {
        DynamicList<face> added;
        DynamicList<label> from;

        forAll(surface_.faces, facei)
        {
            const DynamicList<face> all(pieces(surface_.faces[facei]));
            surface_.faces[facei] = all[0];

            for (label i = 1; i < all.size(); ++i)
            {
                added.append(all[i]);
                from.append(facei);
            }
        }

        surface_.faces.append(added);
        extend(surface_.patchIDs, from);
        extend(sectored_.parts, from);
        extend(sectored_.sectors, from);
    }


public:

    partDivider
    (
        sectoredSurface& sectored,
        const label part,
        const scalar tolerance
    )
    :
        sectored_(sectored),
        surface_(sectored.surface),
        part_(part),
        tolerance_(tolerance),
        faces_(findIndices(sectored.parts, part)),
        distances_(surface_.points.size())
    {}


    void divide()
    {
        findBorder();
        setPlane();
        putOnBorder();
        findCrossings();
        cutFaces();

        const label sector = max(sectored_.sectors) + 1;
        for (const label f : findIndices(sectored_.parts, part_))
        {
            const scalarField d(distances_, surface_.faces[f]);
            if (sum(d) > 0)
            {
                sectored_.sectors[f] = sector;
            }
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void divideSidePart
(
    sectoredSurface& sectored,
    const label part,
    const scalar tolerance
)
{
    partDivider(sectored, part, tolerance).divide();
}

} // End namespace Foam

// ************************************************************************* //
