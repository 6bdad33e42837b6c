/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "improveTets.H"
#include "farFieldMeshControls.H"
#include "orientation.H"
#include "HashSet.H"
#include "ListOps.H"
#include "triangleIndex.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class pointMover
{
    farFieldMesh& mesh_;
    const pointField& layerCentres_;
    const triangleIndex outer_;
    const labelListList pointTets_;

    point centre(const label t) const
    {
        return mesh_.tets[t].tet(mesh_.points).centre();
    }

    //- Cosine of the non-orthogonality of a face; 1 on the far boundary
    scalar cosine(label t, label i) const;

    //- 12 (3 V)^(2/3) over the sum of the squares of the lengths of the edges:
    //  1 of a regular tetrahedron; -1 of one that is not positive
    scalar shape(label t) const;

    //- The least cosine or shape around a point
    scalar worstAround(label p) const;

    //- Mean length of the edges of a point
    scalar sizeAt(label p) const;

    //- Moves a point along an axis or diagonal to the best place at the given
    //  distance, if that is better than worst, which becomes the value there.
    //  Returns whether the point was moved.
    bool step(label p, scalar distance, scalar& worst);

public:

    pointMover(const pointField& layerCentres, farFieldMesh& mesh)
    :
        mesh_(mesh),
        layerCentres_(layerCentres),
        outer_(makeTriangleIndex(mesh.outerTriangles)),
        pointTets_
        (
            invertManyToMany<tetCell, labelList>(mesh.points.size(), mesh.tets)
        )
    {}

    //- Points inside, of the cells at faces with a smaller cosine
    labelList pointsAt(scalar poor) const;

    //- Moves a point while it becomes better. Returns whether it was moved.
    bool move(label p);
};


scalar pointMover::cosine(const label t, const label i) const
{
    const triFace f(mesh_.tets[t].face(i));
    const label neighbour = mesh_.neighbours[t][i];
    const label triangle = neighbour < 0 ? outer_.lookup(f, -1) : -1;

    if (neighbour < 0 && triangle < 0)
    {
        return 1;
    }

    const point beyond
    (
        neighbour < 0 ? layerCentres_[triangle] : centre(neighbour)
    );
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

    for (const label t : pointTets_[p])
    {
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

    for (const label t : pointTets_[p])
    {
        for (const label q : mesh_.tets[t])
        {
            sum += mag(mesh_.points[q] - mesh_.points[p]);
        }
    }

    return sum/max(3*pointTets_[p].size(), 1);
}


labelList pointMover::pointsAt(const scalar poor) const
{
    labelHashSet cells;

    forAll(mesh_.tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label beyond = mesh_.neighbours[t][i];

            if ((beyond > t || beyond < 0) && cosine(t, i) < poor)
            {
                cells.insert({t, max(beyond, t)});
            }
        }
    }

    labelHashSet points;
    for (const label t : cells)
    {
        for (const label p : mesh_.tets[t])
        {
            if (p >= mesh_.nBoundaryPoints)
            {
                points.insert(p);
            }
        }
    }

    return points.sortedToc();
}


bool pointMover::step(const label p, const scalar distance, scalar& worst)
{
    const point from(mesh_.points[p]);
    point to(from);
    bool moved = false;

    for (label k = 0; k < 27; ++k)
    {
        const vector direction(k % 3 - 1, k/3 % 3 - 1, k/9 - 1);

        if (k != 13)
        {
            mesh_.points[p] = from + distance*normalised(direction);
            const scalar there = worstAround(p);

            if (there > worst + SMALL)
            {
                worst = there;
                to = mesh_.points[p];
                moved = true;
            }
        }
    }

    mesh_.points[p] = to;

    return moved;
}


bool pointMover::move(const label p)
{
    const scalar size = sizeAt(p);
    scalar worst = worstAround(p);
    label nMoves = 0;

    for (const scalar length : farFieldTuned.moves)
    {
        while
        (
            nMoves < farFieldTuned.maxMoves && step(p, length*size, worst)
        )
        {
            ++nMoves;
        }
    }

    return nMoves;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void movePoorPoints
(
    const pointField& layerCentres,
    const scalar poorAngle,
    farFieldMesh& mesh
)
{
    pointMover mover(layerCentres, mesh);
    bool moved = true;

    for (label pass = 0; moved && pass < farFieldTuned.maxPasses; ++pass)
    {
        moved = false;

        for (const label p : mover.pointsAt(::cos(poorAngle)))
        {
            moved = mover.move(p) || moved;
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
