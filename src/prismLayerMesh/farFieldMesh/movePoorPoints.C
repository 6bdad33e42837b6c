/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "improveTets.H"
#include "orientation.H"
#include "HashSet.H"
#include "prismQuality.H"
#include "triangleIndex.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Passes over all poor faces, at most
static const label maxPasses = 5;

//- Moves of a point in a pass, at most
static const label maxMoves = 20;

//- Lengths of the moves that are tried over the mean length of its edges
static const FixedList<scalar, 4> moves({0.3, 0.1, 0.03, 0.01});


class pointMover
{
    farFieldMesh& mesh_;
    const pointField& layerCentres_;
    const triangleIndex outer_;

    //- Tetrahedra of each point: from starts_[p] on
    labelList starts_;
    labelList pointTets_;

    point centre(const label t) const
    {
        const tetCell& tet = mesh_.tets[t];

        return 0.25
           *(
                mesh_.points[tet[0]] + mesh_.points[tet[1]]
              + mesh_.points[tet[2]] + mesh_.points[tet[3]]
            );
    }

    //- Cosine of the angle at a face; 1 on the far boundary
    scalar cosine(label t, label i) const;

    //- 12 (3 V)^(2/3) over the sum of the squares of the lengths of the edges:
    //  1 of a regular tetrahedron, -1 of one that is not positive
    scalar shape(label t) const;

    //- The least cosine or shape around a point
    scalar worstAround(label p) const;

    //- Mean length of its edges
    scalar sizeAt(label p) const;

public:

    pointMover(const pointField& layerCentres, farFieldMesh& mesh);

    //- Points that may move of the cells at faces with a smaller cosine
    labelList pointsAt(scalar poor) const;

    //- Returns whether it moved
    bool move(label p);
};


pointMover::pointMover(const pointField& layerCentres, farFieldMesh& mesh)
:
    mesh_(mesh),
    layerCentres_(layerCentres),
    outer_(makeTriangleIndex(mesh.outerTriangles)),
    starts_(mesh.points.size() + 1, Zero),
    pointTets_(4*mesh.tets.size())
{
    for (const tetCell& tet : mesh.tets)
    {
        for (const label p : tet)
        {
            ++starts_[p + 1];
        }
    }

    forAll(mesh.points, p)
    {
        starts_[p + 1] += starts_[p];
    }

    labelList next(starts_);
    forAll(mesh.tets, t)
    {
        for (const label p : mesh.tets[t])
        {
            pointTets_[next[p]++] = t;
        }
    }
}


scalar pointMover::cosine(const label t, const label i) const
{
    const triFace f(mesh_.tets[t].face(i));
    point beyond;

    if (mesh_.neighbours[t][i] >= 0)
    {
        beyond = centre(mesh_.neighbours[t][i]);
    }
    else
    {
        const label triangle = outer_.lookup(f, -1);

        if (triangle < 0)
        {
            return 1;
        }

        beyond = layerCentres_[triangle];
    }

    const vector area(f.areaNormal(mesh_.points));
    const vector delta(beyond - centre(t));

    return (area & delta)/(mag(area)*mag(delta) + VSMALL);
}


scalar pointMover::shape(const label t) const
{
    const tetCell& tet = mesh_.tets[t];
    const pointField& x = mesh_.points;

    if (orientation(x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]) <= 0)
    {
        return -1;
    }

    scalar squares = 0;
    for (label i = 0; i < 6; ++i)
    {
        const edge e(tet.tetEdge(i));
        squares += magSqr(x[e.start()] - x[e.end()]);
    }

    return 12*::cbrt(sqr(3*tet.tet(x).mag()))/squares;
}


scalar pointMover::worstAround(const label p) const
{
    scalar worst = 1;

    for (label k = starts_[p]; k < starts_[p + 1]; ++k)
    {
        const label t = pointTets_[k];

        worst = min(worst, shape(t));

        for (label i = 0; i < 4; ++i)
        {
            worst = min(worst, cosine(t, i));
        }
    }

    return worst;
}


scalar pointMover::sizeAt(const label p) const
{
    scalar sum = 0;
    label n = 0;

    for (label k = starts_[p]; k < starts_[p + 1]; ++k)
    {
        for (const label q : mesh_.tets[pointTets_[k]])
        {
            sum += mag(mesh_.points[q] - mesh_.points[p]);
            n += q != p;
        }
    }

    return sum/max(n, 1);
}


labelList pointMover::pointsAt(const scalar poor) const
{
    labelHashSet points;

    forAll(mesh_.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label beyond = mesh_.neighbours[t][i];

            if ((beyond > t || beyond < 0) && cosine(t, i) < poor)
            {
                points.insert(mesh_.tets[t].begin(), mesh_.tets[t].end());

                if (beyond >= 0)
                {
                    points.insert
                    (
                        mesh_.tets[beyond].begin(), mesh_.tets[beyond].end()
                    );
                }
            }
        }
    }

    DynamicList<label> mayMove;
    for (const label p : points.sortedToc())
    {
        if (p >= mesh_.nBoundaryPoints)
        {
            mayMove.append(p);
        }
    }

    return labelList(std::move(mayMove));
}


bool pointMover::move(const label p)
{
    const scalar size = sizeAt(p);
    scalar worst = worstAround(p);
    label nMoves = 0;

    for (const scalar length : moves)
    {
        for (bool better = true; better && nMoves < maxMoves;)
        {
            const point from(mesh_.points[p]);
            point to(from);
            better = false;

            // Along axes and diagonals
            for (label k = 0; k < 27; ++k)
            {
                const vector direction(k % 3 - 1, k/3 % 3 - 1, k/9 - 1);

                if (k != 13)
                {
                    mesh_.points[p] = from + length*size*normalised(direction);
                    const scalar there = worstAround(p);

                    if (there > worst + SMALL)
                    {
                        worst = there;
                        to = mesh_.points[p];
                        better = true;
                    }
                }
            }

            mesh_.points[p] = to;
            nMoves += better;
        }
    }

    return nMoves;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::movePoorPoints
(
    const pointField& layerCentres,
    const scalar poorAngle,
    farFieldMesh& mesh
)
{
    pointMover mover(layerCentres, mesh);
    bool moved = true;

    for (label pass = 0; moved && pass < maxPasses; ++pass)
    {
        moved = false;

        for (const label p : mover.pointsAt(::cos(poorAngle)))
        {
            moved = mover.move(p) || moved;
        }
    }
}


// ************************************************************************* //
