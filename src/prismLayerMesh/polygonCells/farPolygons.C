/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farPolygons.H"

#include "disjointSets.H"
#include "prismPolyMesh.H"
#include "quadJoiner.H"
#include "unitConversion.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The quadrilateral at a corner of a face of the far field
cornerQuad quadAt
(
    const farFieldCorners& c,
    const label facei,
    const label k
)
{
    const face& f = c.far.topology.faces[facei];

    return cornerQuad
    ({
        c.points.ofFarPoint(f[k]),
        c.points.ofFarEdge(f[k], f.nextLabel(k)),
        c.points.ofFarFace(facei),
        c.points.ofFarEdge(f.prevLabel(k), f[k])
    });
}


class farFaces
{
    const farFieldCorners& c_;
    const placesInMesh& part_;
    const polyMeshTopology& t_;
    meshBuilder& faces_;

    //- Internal faces within one cell at each of their points. Their inner
    //  points would be on a line but for its bend.
    bitSet isInside_;

    label nInternal() const { return t_.neighbour.size(); }

    label cell(const label celli, const label p) const
    {
        return c_.firstCell() + c_.groups.at(c_.tets, celli, p);
    }

    //- Whether a cell has the same group at all its points
    bool isWhole(const label celli) const
    {
        if (celli >= c_.tets.size())
        {
            return true;
        }
        const FixedList<label, 4>& g = c_.groups.ofTets[celli];

        return g[0] == g[1] && g[1] == g[2] && g[2] == g[3];
    }

    //- A face as it is, with the points inside of its edges
    void appendWhole(const label facei, const label first, const label second)
    {
        const face& f = t_.faces[facei];
        DynamicList<label, 16> points;
        forAll(f, k)
        {
            points.append(c_.points.ofFarPoint(f[k]));
            const label m = c_.points.ofFarEdge(f[k], f.nextLabel(k));
            if (m >= 0)
            {
                points.append(m);
            }
        }
        faces_.append(points, first, second);
    }

    //- Whether a face is of a cell of the part
    bool isInPart(const label facei) const
    {
        return
            part_.hasFarCell(t_.owner[facei])
         || (facei < nInternal() && part_.hasFarCell(t_.neighbour[facei]));
    }

    void findInside()
    {
        isInside_.resize(t_.faces.size());
        for (label facei = 0; facei < nInternal(); ++facei)
        {
            bool same = isInPart(facei);
            for (const label p : t_.faces[facei])
            {
                same = same
                 && cell(t_.owner[facei], p) == cell(t_.neighbour[facei], p);
            }
            isInside_.set(facei, same);
        }
    }

    //- The inner point of a face, or the owner's in its place
    label facePoint(const label facei) const
    {
        return
            isInside_.test(facei)
          ? c_.points.ofTet(t_.owner[facei]) : c_.points.ofFarFace(facei);
    }

    //- The quadrilateral of edge i = 0..5 inside of a tetrahedron, if it is
    //  between two groups
    void addInside(const label t, const label i, quadJoiner& to)
    {
        const label* ends = farTets::edgeEnds[i];
        const FixedList<label, 4>& p = c_.tets.points(t);
        const FixedList<label, 4>& groups = c_.groups.ofTets[t];
        labelPair between(groups[ends[0]], groups[ends[1]]);
        labelPair sides(c_.tets.facesAt(t, i));
        if (p[ends[0]] > p[ends[1]])
        {
            between.flip();
            sides.flip();
        }
        if (between.first() == between.second())
        {
            return;
        }
        to.append
        (
            quadBetween
            {
                0, c_.firstCell() + between.first(),
                c_.firstCell() + between.second(),
                cornerQuad
                ({
                    c_.points.ofFarEdge(c_.tets.edges(t)[i]),
                    facePoint(sides.first()), c_.points.ofTet(t),
                    facePoint(sides.second())
                })
            }
        );
    }

    //- The faces in a corner of which the sides are two cells
    void appendCorners(const label facei)
    {
        const label own = t_.owner[facei], nei = t_.neighbour[facei];
        const face& f = t_.faces[facei];
        if (isWhole(own) && isWhole(nei))
        {
            appendWhole(facei, cell(own, f[0]), cell(nei, f[0]));
            return;
        }
        quadJoiner quads;
        forAll(f, k)
        {
            const label first = cell(own, f[k]), second = cell(nei, f[k]);
            if (first != second)
            {
                quads.append
                (
                    quadBetween{0, first, second, quadAt(c_, facei, k)}
                );
            }
        }
        quads.moveTo(faces_);
    }

    //- Joins the corners of boundary faces of a patch that no sharp edge
    //  divides. Returns the smallest corner of those that are joined, for
    //  corner starts[facei - nInternal] + k.
    labelList smoothCorners
    (
        const labelUList& starts,
        const labelUList& patchOf,
        const scalar sharpAngle
    ) const;

public:

    farFaces
    (
        const farFieldCorners& corners,
        const placesInMesh& part,
        meshBuilder& faces
    )
    :
        c_(corners),
        part_(part),
        t_(corners.far.topology),
        faces_(faces)
    {
        findInside();
    }

    //- The faces around edges of tetrahedra
    void appendAroundEdges();

    //- The faces that are parts of internal faces of the far field
    void appendInFaces()
    {
        for (label facei = 0; facei < nInternal(); ++facei)
        {
            if (isInPart(facei) && !isInside_.test(facei))
            {
                appendCorners(facei);
            }
        }
    }

    void appendToLayers();

    void appendOnPatches(const labelUList& patches, scalar sharpAngle);
};


void farFaces::appendAroundEdges()
{
    // Edge i of tetrahedron t is 6*t + i
    const auto visit = [&](const auto& act)
    {
        for (label t = 0; t < c_.tets.size(); ++t)
        {
            for (label i = 0; i < 6 && part_.hasFarCell(t); ++i)
            {
                act(c_.tets.edges(t)[i], 6*t + i);
            }
        }
    };
    labelList n(c_.tets.edges().size(), Zero);
    visit([&](const label e, label) { ++n[e]; });
    CompactListList<label> around(n);
    visit([&](const label e, const label i) { around(e, --n[e]) = i; });
    quadJoiner quads;
    for (label e = 0; e < around.size(); ++e)
    {
        for (const label i : around[e])
        {
            addInside(i/6, i % 6, quads);
        }
        quads.moveTo(faces_);
    }
}


void farFaces::appendToLayers()
{
    const label n = c_.layers.nLayers;
    quadJoiner quads;
    for (label i = 0; n > 0 && i < c_.far.frontFaces.size(); ++i)
    {
        const label facei = t_.patchStarts[0] + i;
        const label fronti = c_.far.frontFaces[i];
        if (!isInPart(facei))
        {
            continue;
        }
        const face& f = t_.faces[facei];
        forAll(f, k)
        {
            const label g =
                c_.front.of(fronti, c_.layers.faces[fronti].find(f[k]));
            quads.append
            (
                quadBetween
                {
                    0, cell(t_.owner[facei], f[k]), g*n + n - 1,
                    quadAt(c_, facei, k)
                }
            );
        }
    }
    quads.moveTo(faces_);
}


labelList farFaces::smoothCorners
(
    const labelUList& starts,
    const labelUList& patchOf,
    const scalar sharpAngle
) const
{
    // Pairs of an edge and a face at the edge, sorted by edges
    std::vector<std::pair<endsOfEdge, label>> sides;
    forAll(patchOf, i)
    {
        const face& f = t_.faces[nInternal() + i];
        for (label k = 0; k < f.size() && isInPart(nInternal() + i); ++k)
        {
            sides.push_back({std::minmax(f[k], f.nextLabel(k)), i});
        }
    }
    std::sort(sides.begin(), sides.end());

    disjointSets sets(starts.last());
    const scalar least = Foam::cos(degToRad(sharpAngle));
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
        const label a = sides[i - 1].second, b = sides[i].second;
        if (sides[i - 1].first != sides[i].first || patchOf[a] != patchOf[b])
        {
            continue;
        }
        const face& f = t_.faces[nInternal() + a];
        const face& g = t_.faces[nInternal() + b];
        const pointField& x = c_.far.points;
        if ((f.unitNormal(x) & g.unitNormal(x)) >= least)
        {
            const endsOfEdge& e = sides[i].first;
            for (const label p : {e.first, e.second})
            {
                sets.join(starts[a] + f.find(p), starts[b] + g.find(p));
            }
        }
    }
    labelList joined(starts.last());
    forAll(joined, i)
    {
        joined[i] = sets.find(i);
    }

    return joined;
}


void farFaces::appendOnPatches
(
    const labelUList& patches,
    const scalar sharpAngle
)
{
    const label n = t_.faces.size() - nInternal();
    labelList starts(n + 1, Zero);
    labelList patchOf(n, -1);
    forAll(patchOf, i)
    {
        starts[i + 1] = starts[i] + t_.faces[nInternal() + i].size();
    }
    for (label patchi = 1; patchi < t_.patchStarts.size(); ++patchi)
    {
        SubList<label>
        (
            patchOf, t_.patchSizes[patchi],
            t_.patchStarts[patchi] - nInternal()
        ) = patchi;
    }
    const labelList smooth(smoothCorners(starts, patchOf, sharpAngle));

    quadJoiner quads;
    forAll(patchOf, i)
    {
        const label facei = nInternal() + i;
        const face& f = t_.faces[facei];
        const label own = t_.owner[facei];
        if (patchOf[i] < 0 || !isInPart(facei))
        {
            continue;
        }
        const label patch = meshBuilder::onPatch(patches[patchOf[i]]);
        if (isWhole(own))
        {
            appendWhole(facei, cell(own, f[0]), patch);
            continue;
        }
        forAll(f, k)
        {
            quads.append
            (
                quadBetween
                {
                    smooth[starts[i] + k], cell(own, f[k]), patch,
                    quadAt(c_, facei, k)
                }
            );
        }
    }
    quads.moveTo(faces_);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bitSet farFieldCorners::cellsAt(const placesInMesh& places) const
{
    const label n = layers.nLayers;
    bitSet cells(firstCell() + groups.nGroups);
    visit
    (
        [&](const label g, const label facei, const label k)
        {
            if (places.hasPoint(layers.faces[facei][k]))
            {
                cells.set(identity(n, g*n));
            }
        },
        [&](const label g, const label t, const label k)
        {
            if (places.hasPoint(tets.points(t)[k]))
            {
                cells.set(firstCell() + g);
            }
        }
    );
    forAll(groups.ofOthers, i)
    {
        if (places.hasFarCell(tets.size() + i))
        {
            cells.set(firstCell() + groups.ofOthers[i]);
        }
    }

    return cells;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void appendFarFaces
(
    const farFieldCorners& corners,
    const placesInMesh& part,
    const labelUList& patches,
    const scalar sharpAngle,
    meshBuilder& faces
)
{
    farFaces far(corners, part, faces);
    far.appendAroundEdges();
    far.appendInFaces();
    far.appendToLayers();
    far.appendOnPatches(patches, sharpAngle);
}


List<cellZoneParts> zonesOf(const farFieldCorners& corners)
{
    const farGroups& groups = corners.groups;
    const label nLayerCells = corners.firstCell();
    List<cellZoneParts> zones;
    zones.append(cellZoneParts(boundaryLayerName, identity(nLayerCells)));
    const label nTets = groups.ofTets.size();
    for (const cellZoneParts& zone : corners.far.cellZones)
    {
        bitSet cells(nLayerCells + groups.nGroups);
        for (const label celli : zone.cells)
        {
            if (celli >= nTets)
            {
                cells.set(nLayerCells + groups.ofOthers[celli - nTets]);
                continue;
            }
            for (const label g : groups.ofTets[celli])
            {
                cells.set(nLayerCells + g);
            }
        }
        zones.append(cellZoneParts(zone.name, cells.toc()));
    }

    return zones;
}

} // End namespace Foam

// ************************************************************************* //
