/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "givenSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void givenSurface::setLines(const wallSides& sides, const scalar minCos)
{
    const faceList& faces = surface_.faces;
    FixedList<label, 3> none(-1);
    neighbours_ = List<FixedList<label, 3>>(faces.size(), none);
    DynamicList<edge> lines;
    DynamicList<scalar> cosines;

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const SubList<wallSide> all(sides.on(e));
        const wallSide& a = all[0];
        const edge both(a.low, a.high);

        if (all.size() != 2)
        {
            lines.append(both);
            cosines.append(1);
            continue;
        }

        const wallSide& b = all[1];
        const scalar cosine = normals_[a.facei] & normals_[b.facei];
        if
        (
            surface_.patchIDs[a.facei] != surface_.patchIDs[b.facei]
         || faces[a.facei].size() != 3 || faces[b.facei].size() != 3
         || cosine < minCos
        )
        {
            lines.append(both);
            cosines.append(min(cosine, scalar(1)));
            continue;
        }
        neighbours_[a.facei][faces[a.facei].edges().find(both)] = b.facei;
        neighbours_[b.facei][faces[b.facei].edges().find(both)] = a.facei;
    }

    lines_ = std::move(lines);
    lineCosines_ = scalarField(std::move(cosines));
}


void givenSurface::setCorners(const scalar minCos)
{
    const label nPoints = surface_.points.size();
    List<labelPair> linesOf(nPoints, labelPair(-1, -1));
    isOnLine_ = boolList(nPoints, false);
    isCorner_ = boolList(nPoints, false);

    forAll(lines_, l)
    {
        for (label k = 0; k < 2; ++k)
        {
            const label p = lines_[l][k];
            labelPair& two = linesOf[p];
            isOnLine_[p] = true;
            isCorner_[p] = isCorner_[p] || two.second() >= 0;
            (two.first() < 0 ? two.first() : two.second()) = l;
        }
    }

    nextLines_ = List<labelPair>(lines_.size(), labelPair(-1, -1));
    forAll(linesOf, p)
    {
        const labelPair& two = linesOf[p];
        if (!isOnLine_[p] || isCorner_[p])
        {
            continue;
        }
        isCorner_[p] = two.second() < 0;
        if (isCorner_[p])
        {
            continue;
        }

        const point& x = surface_.points[p];
        const edge& before = lines_[two.first()];
        const edge& after = lines_[two.second()];
        const vector in(x - surface_.points[before.otherVertex(p)]);
        const vector out(surface_.points[after.otherVertex(p)] - x);
        isCorner_[p] = (in & out) < minCos*mag(in)*mag(out);
        if (!isCorner_[p])
        {
            const label i = (before.start() == p ? 0 : 1);
            const label j = (after.start() == p ? 0 : 1);
            nextLines_[two.first()][i] = two.second();
            nextLines_[two.second()][j] = two.first();
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
