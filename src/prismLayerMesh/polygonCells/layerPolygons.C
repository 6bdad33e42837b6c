/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerPolygons.H"

#include "disjointSets.H"
#include "ListOps.H"
#include "outlines.H"
#include "prismQuality.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Joins corners of front faces, see frontGroups
class frontJoiner
{
    const prismLayers& layers_;
    const labelListList& neighbours_;
    const polygonControls& controls_;
    const groupExceptions& exceptions_;
    frontGroups front_;
    disjointSets sets_;

    bool onWall(const label facei) const
    {
        return facei < layers_.nWallFaces();
    }

    label corner(const label facei, const label column) const
    {
        return front_.starts[facei] + layers_.faces[facei].find(column);
    }

    //- Unit normal of a front face on a level
    vector normalAt(const label facei, const label level) const
    {
        const face& f = layers_.faces[facei];
        pointField x(f.size());
        forAll(f, k)
        {
            x[k] = layers_(f[k], level);
        }

        return normalised(face(identity(f.size())).areaNormal(x));
    }

    bool isSharp(const label a, const label b) const
    {
        const auto turn = [&](const label level)
        {
            return normalAt(a, level) & normalAt(b, level);
        };

        return
            layers_.patchIDs[a] != layers_.patchIDs[b]
         || turn(0) < Foam::cos(degToRad(controls_.sharpAngle))
         || turn(layers_.nLayers)
          < Foam::cos(degToRad(controls_.sharpOuterAngle));
    }

    void joinAll(const label facei)
    {
        forAll(layers_.faces[facei], k)
        {
            sets_.join(front_.starts[facei], front_.starts[facei] + k);
        }
    }

    //- Joins the corners at both ends of an edge with those across
    void joinAcross(const label facei, const label k, const label other)
    {
        const face& f = layers_.faces[facei];
        for (const label column : {f[k], f.nextLabel(k)})
        {
            join(corner(facei, column), corner(other, column));
        }
    }

    void join(const label a, const label b)
    {
        if (exceptions_.part(a) == exceptions_.part(b))
        {
            sets_.join(a, b);
        }
    }

    //- Whether a front face without area is on three columns of one point, or
    //  has a form that is not divided
    bool isWhole(const label facei) const
    {
        const face& f = layers_.faces[facei];
        label nShort = 0;
        forAll(f, k)
        {
            nShort += isShort(facei, k);
        }

        return
            exceptions_.whole.test(facei)
         || nShort != (f.size() == 4 ? 2 : 1);
    }

    bool isShort(const label facei, const label k) const
    {
        const face& f = layers_.faces[facei];

        return layers_.root(f[k]) == layers_.root(f.nextLabel(k));
    }

    void joinOnWall(const label facei)
    {
        forAll(neighbours_[facei], k)
        {
            const label other = neighbours_[facei][k];
            if
            (
                other > facei && onWall(other)
             && !exceptions_.whole.test(other) && !isSharp(facei, other)
            )
            {
                joinAcross(facei, k, other);
            }
        }
    }

    void joinBetweenColumns(const label facei)
    {
        const face& f = layers_.faces[facei];
        if (f.size() == 3)
        {
            joinAll(facei);
        }
        forAll(f, k)
        {
            if (!isShort(facei, k))
            {
                continue;
            }
            join
            (
                front_.starts[facei] + k, front_.starts[facei] + f.fcIndex(k)
            );
            const label other = neighbours_[facei][k];
            if (other > facei && !isWhole(other))
            {
                joinAcross(facei, k, other);
            }
        }
    }

    label nCorners() const { return front_.starts.last(); }

public:

    frontJoiner
    (
        const prismLayers& layers,
        const labelListList& faceNeighbours,
        const polygonControls& controls,
        const groupExceptions& exceptions,
        frontGroups&& front
    )
    :
        layers_(layers),
        neighbours_(faceNeighbours),
        controls_(controls),
        exceptions_(exceptions),
        front_(std::move(front)),
        sets_(nCorners())
    {}

    frontGroups join()
    {
        forAll(layers_.faces, facei)
        {
            if
            (
                onWall(facei)
              ? exceptions_.whole.test(facei) : isWhole(facei)
            )
            {
                joinAll(facei);
            }
            else if (onWall(facei))
            {
                joinOnWall(facei);
            }
            else
            {
                joinBetweenColumns(facei);
            }
        }

        // The first corner of a group has the smallest label
        front_.groups.setSize(nCorners());
        forAll(front_.groups, i)
        {
            const label first = sets_.find(i);
            front_.groups[i] =
                first == i ? front_.nGroups++ : front_.groups[first];
        }

        return front_;
    }
};


//- Appends the faces of columns
class columnFaces
{
    const prismLayers& layers_;
    const labelListList& neighbours_;
    const frontGroups& front_;
    const cornerPoints& points_;
    const labelUList& sidePatches_;
    const placesInMesh& part_;
    meshBuilder& faces_;

    label n() const { return layers_.nLayers; }

    //- Labels in the plane of the front: columns, edges, front faces
    label planeEdge(const label a, const label b) const
    {
        return layers_.nColumns() + points_.frontEdges().find(a, b);
    }

    label planeFace(const label facei) const
    {
        return layers_.nColumns() + points_.frontEdges().size() + facei;
    }

    label onLevel(const label p, const label level) const
    {
        const label e = p - layers_.nColumns();
        const label f = e - points_.frontEdges().size();

        return
            e < 0 ? points_.ofColumn(p, level)
          : f < 0 ? points_.ofEdge(e, level) : points_.ofFace(f, level);
    }

    label cell(const label group, const label level) const
    {
        return group*n() + level - 1;
    }

    //- Appends the faces over a path, to the group on the right or to a patch
    void appendOver
    (
        const labelUList& path,
        const label left,
        const label right
    )
    {
        for (label i = 1; i <= n(); ++i)
        {
            DynamicList<label, 8> f;
            for (const label p : path)
            {
                f.append(onLevel(p, i - 1));
            }
            forAllReverse(path, k)
            {
                f.append(onLevel(path[k], i));
            }
            faces_.append(f, cell(left, i), right < 0 ? right : cell(right, i));
        }
    }

    //- Appends the faces over two parts of a path; together if both are between
    //  the same groups
    void appendBoth
    (
        const FixedList<label, 3>& path,
        const labelPair& first,
        const labelPair& second
    )
    {
        const labelList start({path[0], path[1]});
        const labelList end({path[1], path[2]});
        if (first == second && first.first() != first.second())
        {
            appendOver(labelList(path), first.first(), first.second());
            return;
        }
        if (first.first() != first.second())
        {
            appendOver(start, first.first(), first.second());
        }
        if (second.first() != second.second())
        {
            appendOver(end, second.first(), second.second());
        }
    }

    bool hasFrontFace(const label facei) const
    {
        return facei >= 0 && part_.hasOneOf(layers_.faces[facei]);
    }

    label group(const label facei, const label column) const
    {
        return front_.of(facei, layers_.faces[facei].find(column));
    }

    //- The faces over an edge, and across it from front face to front face.
    //  other: -1 if there is no front face beyond
    void appendEdge(const label facei, const label k, const label other)
    {
        const face& f = layers_.faces[facei];
        const label a = f[k], b = f.nextLabel(k), m = planeEdge(a, b);
        const labelPair here(group(facei, a), group(facei, b));
        if (other < 0)
        {
            const label patch = sidePatches_[front_.starts[facei] + k];
            appendBoth
            (
                {a, m, b}, {here.first(), meshBuilder::onPatch(patch)},
                {here.second(), meshBuilder::onPatch(patch)}
            );
            if (here.first() != here.second())
            {
                appendOver
                (
                    labelList({m, planeFace(facei)}), here.first(),
                    here.second()
                );
            }
            return;
        }
        const labelPair there(group(other, a), group(other, b));
        appendBoth({planeFace(other), m, planeFace(facei)}, there, here);
        appendBoth
        (
            {a, m, b}, {here.first(), there.first()},
            {here.second(), there.second()}
        );
    }

public:

    columnFaces
    (
        const prismLayers& layers,
        const labelListList& faceNeighbours,
        const frontGroups& front,
        const cornerPoints& points,
        const labelUList& sidePatches,
        const placesInMesh& part,
        meshBuilder& faces
    )
    :
        layers_(layers),
        neighbours_(faceNeighbours),
        front_(front),
        points_(points),
        sidePatches_(sidePatches),
        part_(part),
        faces_(faces)
    {}

    void appendSides()
    {
        forAll(layers_.faces, facei)
        {
            forAll(layers_.faces[facei], k)
            {
                const label other = neighbours_[facei][k];
                if
                (
                    (other < 0 || other > facei)
                 && (hasFrontFace(facei) || hasFrontFace(other))
                )
                {
                    appendEdge(facei, k, other);
                }
            }
        }
    }

    //- Calls visit(group, outline, facei) for each outline of a group in the
    //  plane of the front, seen from the fluid, with a front face of the group.
    //  If that stays whole, the outline begins where it begins.
    template<class Visit>
    void visitOutlines(const Visit& visit) const
    {
        bitSet isWanted(front_.nGroups);
        forAll(layers_.faces, facei)
        {
            const face& f = layers_.faces[facei];
            forAll(f, k)
            {
                if (part_.hasPoint(f[k]))
                {
                    isWanted.set(front_.of(facei, k));
                }
            }
        }
        List<DynamicList<cornerQuad>> quads(front_.nGroups);
        labelList faceOf(front_.nGroups);
        forAll(layers_.faces, facei)
        {
            const face& f = layers_.faces[facei];
            forAll(f, k)
            {
                const label g = front_.of(facei, k);
                if (!isWanted.test(g))
                {
                    continue;
                }
                faceOf[g] = facei;
                quads[g].append
                (
                    cornerQuad
                    ({
                        f[k], planeEdge(f[k], f.nextLabel(k)),
                        planeFace(facei), planeEdge(f.prevLabel(k), f[k])
                    })
                );
            }
        }
        outlineFinder outlinesOf;
        for (const label g : isWanted)
        {
            const label first = layers_.faces[faceOf[g]][0];
            outlinesOf(quads[g], [&](const labelUList& outline)
            {
                labelList turned(outline);
                inplaceRotateList(turned, -max(outline.find(first), label(0)));
                visit(g, turned, faceOf[g]);
            });
        }
    }

    //- Appends the face on a level
    void appendFlat
    (
        const labelUList& outline,
        const label level,
        const label first,
        const label second
    )
    {
        DynamicList<label, 16> f;
        for (const label p : outline)
        {
            f.append(onLevel(p, level));
        }
        if (level == 0)
        {
            // The first point stays
            Foam::reverse(f);
            inplaceRotateList(f, 1);
        }
        faces_.append(f, first, second);
    }

    void appendLevels(const bool hasWall)
    {
        visitOutlines
        (
            [&](const label g, const labelUList& outline, const label facei)
            {
                if (hasWall && facei < layers_.nWallFaces())
                {
                    const label patchi = layers_.patchIDs[facei];
                    appendFlat
                    (
                        outline, 0, cell(g, 1), meshBuilder::onPatch(patchi)
                    );
                }
                for (label i = 1; i < n(); ++i)
                {
                    appendFlat(outline, i, cell(g, i), cell(g, i + 1));
                }
            }
        );
    }

    //- Faces that stay whole begin where the certificate of the layers has them
    //  begin
    void appendOuter(const label patchi)
    {
        visitOutlines
        (
            [&](const label g, const labelUList& outline, const label facei)
            {
                const label first = outerFan(layers_, facei)[0];
                labelList turned(outline);
                inplaceRotateList(turned, -max(outline.find(first), label(0)));
                appendFlat
                (
                    turned, n(), cell(g, n()), meshBuilder::onPatch(patchi)
                );
            }
        );
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList cornerStarts(const prismLayers& layers)
{
    labelList starts(layers.faces.size() + 1, Zero);
    forAll(layers.faces, facei)
    {
        starts[facei + 1] = starts[facei] + layers.faces[facei].size();
    }

    return starts;
}


frontGroups groupFront
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const polygonControls& controls,
    const groupExceptions& exceptions
)
{
    frontGroups front;
    front.starts = cornerStarts(layers);

    return frontJoiner
    (
        layers, faceNeighbours, controls, exceptions, std::move(front)
    ).join();
}


void appendLayerFaces
(
    const prismLayers& layers,
    const labelListList& faceNeighbours,
    const frontGroups& front,
    const cornerPoints& points,
    const labelUList& sidePatches,
    const bool hasWall,
    const placesInMesh& part,
    meshBuilder& faces
)
{
    columnFaces columns
    (
        layers, faceNeighbours, front, points, sidePatches, part, faces
    );
    columns.appendSides();
    columns.appendLevels(hasWall);
}


void appendOuterFaces
(
    const prismLayers& layers,
    const frontGroups& front,
    const cornerPoints& points,
    const label patchi,
    const placesInMesh& part,
    meshBuilder& faces
)
{
    columnFaces
    (
        layers, labelListList::null(), front, points, labelUList::null(), part,
        faces
    ).appendOuter(patchi);
}

} // End namespace Foam

// ************************************************************************* //
