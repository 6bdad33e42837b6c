/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movePolygonPoints.H"

#include "CompactListList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A mesh whose points move one by one
class movingPoints
{
    polyMeshParts& mesh_;
    polygonGeometry& geometry_;
    polygonPoorness poorness_;

    //- Poorness of each cell with points that may move, and the cells of which
    //  the poorness is out of date
    scalarField poor_;
    bitSet isOld_;

    // Of the point that moves

        //- The cells around, the poorest first, and their poorness now
        DynamicList<label> cells_;
        DynamicList<scalar> now_;

    const polyMeshTopology& topology() const { return mesh_.topology; }

    bool isInternal(const label facei) const
    {
        return facei < topology().neighbour.size();
    }

    //- Sets cells_, with their poorness, and returns the sum
    scalar setCells(const labelUList& faces)
    {
        const polyMeshTopology& t = topology();
        cells_.clear();
        const auto add = [&](const label celli)
        {
            if (!cells_.found(celli))
            {
                cells_.append(celli);
            }
        };
        for (const label facei : faces)
        {
            add(t.owner[facei]);
            if (isInternal(facei))
            {
                add(t.neighbour[facei]);
            }
        }
        scalar sum = 0;
        for (const label celli : cells_)
        {
            if (isOld_.unset(celli))
            {
                poor_[celli] = poorness_(celli, GREAT);
            }
            sum += poor_[celli];
        }
        std::sort
        (
            cells_.begin(), cells_.end(), [&](const label a, const label b)
            {
                return
                    poor_[a] > poor_[b] || (poor_[a] == poor_[b] && a < b);
            }
        );

        return sum;
    }

    //- Sets now_, and returns the sum, or any sum from a bound on
    scalar sumNow(const scalar bound)
    {
        scalar sum = 0;
        now_.clear();
        for (const label celli : cells_)
        {
            now_.append(poorness_(celli, bound - sum));
            sum += now_.last();
            if (sum >= bound)
            {
                break;
            }
        }

        return sum;
    }

    //- Brings the geometry up to date
    void update(const labelUList& faces)
    {
        for (const label facei : faces)
        {
            geometry_.setFace(mesh_, facei);
        }
        for (const label celli : cells_)
        {
            geometry_.setCell(mesh_, celli);
        }
    }

    void setOldBeside()
    {
        for (const label celli : cells_)
        {
            for (const label facei : geometry_.cells[celli])
            {
                isOld_.set(topology().owner[facei]);
                if (isInternal(facei))
                {
                    isOld_.set(topology().neighbour[facei]);
                }
            }
        }
        isOld_.unset(cells_);
    }

public:

    //- The cells with points that may move are out of date
    movingPoints
    (
        const bitSet& isFixed,
        const poornessControls& controls,
        const label nLayerCells,
        polyMeshParts& mesh,
        polygonGeometry& geometry
    )
    :
        mesh_(mesh),
        geometry_(geometry),
        poorness_(controls, nLayerCells, mesh, geometry),
        poor_(mesh.nCells, 0),
        isOld_(mesh.nCells)
    {
        const polyMeshTopology& t = topology();
        forAll(t.faces, facei)
        {
            bool moves = false;
            for (const label p : t.faces[facei])
            {
                moves = moves || !isFixed.test(p);
            }
            if (moves)
            {
                isOld_.set(t.owner[facei]);
                if (isInternal(facei))
                {
                    isOld_.set(t.neighbour[facei]);
                }
            }
        }
        for (const label celli : isOld_)
        {
            poor_[celli] = poorness_(celli, GREAT);
        }
        isOld_.reset();
    }

    //- Returns the points of poor cells, or only of those with poor faces
    bitSet pointsOfPoor(const bool byFaces) const
    {
        bitSet points(mesh_.points.size());
        forAll(poor_, celli)
        {
            if (poor_[celli] > 0
             && (!byFaces || poorness_.ofFaces(celli, 0) > 0))
            {
                for (const label facei : geometry_.cells[celli])
                {
                    points.set(topology().faces[facei]);
                }
            }
        }

        return points;
    }

    //- Moves points by steps while that helps; halves the step if none does.
    //  Returns whether points have moved.
    //  faces: with the points
    //  nWays: number of ways to go
    //  go(way, step): moves the points one way from where they were best
    //  keep(): makes where the points are the best
    template<class Go, class Keep>
    bool move
    (
        const labelUList& faces,
        const label nWays,
        const Go& go,
        const Keep& keep,
        scalar& step
    )
    {
        scalar least = setCells(faces);
        bool hasMoved = false;
        bool isBest = true;
        for (label way = 0; way < nWays && least > 0; ++way)
        {
            go(way, step);
            update(faces);
            const scalar now = sumNow(0.999*least);
            isBest = now < 0.999*least;
            if (isBest)
            {
                least = now;
                keep();
                UIndirectList<scalar>(poor_, cells_) = now_;
                hasMoved = true;
            }
        }
        if (!isBest)
        {
            go(0, 0);
            update(faces);
        }
        if (hasMoved)
        {
            setOldBeside();
        }
        else
        {
            step *= 0.5;
        }

        return hasMoved;
    }
};


//- The faces at each of some points
CompactListList<label> facesAt(const bitSet& points, const faceList& faces)
{
    const auto visit = [&](const auto& act)
    {
        forAll(faces, facei)
        {
            for (const label p : faces[facei])
            {
                if (points.test(p))
                {
                    act(p, facei);
                }
            }
        }
    };
    labelList n(points.size(), Zero);
    visit([&](const label p, label) { ++n[p]; });
    CompactListList<label> at(n);
    visit([&](const label p, const label facei) { at(p, --n[p]) = facei; });

    return at;
}


//- A point that may be anywhere
class freePoint
{
    const label p_;
    const UList<label> faces_;
    scalar step_ = 0;

public:

    //- step: as share of the mean distance to the points beside
    freePoint
    (
        const label p,
        const UList<label>& faces,
        const scalar step,
        const polyMeshParts& mesh
    )
    :
        p_(p),
        faces_(faces)
    {
        for (const label facei : faces)
        {
            const face& f = mesh.topology.faces[facei];
            const point& next = mesh.points[f.nextLabel(f.find(p))];
            step_ += step/faces.size()*mag(next - mesh.points[p]);
        }
    }

    bool move(movingPoints& moving, pointField& x)
    {
        point best(x[p_]);

        return moving.move
        (
            faces_, 6,
            [&](const label way, const scalar step)
            {
                x[p_] = best;
                x[p_][way/2] += way % 2 ? -step : step;
            },
            [&] { best = x[p_]; },
            step_
        );
    }
};


//- The points inside of a front face on all levels
class facePoints
{
    const label facei_;

    //- Points of the mesh, their levels, and the faces there
    labelList points_;
    DynamicList<label> levels_;
    labelList faces_;

    //- As share of the way to a corner
    scalar step_;

public:

    facePoints
    (
        const label facei,
        const labelUList& pointsInFace,
        const labelUList& labels,
        const cornerPoints& points,
        const CompactListList<label>& facesAt,
        const scalar step
    )
    :
        facei_(facei),
        points_(pointsInFace),
        step_(step)
    {
        labelHashSet all;
        for (const label p : points_)
        {
            levels_.append(points.levelOf(labels[p]));
            all.insert(facesAt[p]);
        }
        faces_ = all.sortedToc();
    }

    //- Corners of the face that have no weight stay without one
    bool move
    (
        movingPoints& moving,
        const scalar leastWeight,
        cornerPoints& points,
        pointField& x
    )
    {
        scalarList best(points.weights(facei_));
        scalarList now(best);

        return moving.move
        (
            faces_, 2*best.size(),
            [&](const label way, const scalar step)
            {
                const label k = way/2;
                const scalar share = way % 2 ? -step : step;
                bool isInside = best[k] > 0;
                forAll(best, i)
                {
                    now[i] = (1 - share)*best[i] + (i == k ? share : 0);
                    isInside = isInside
                     && (best[i] == 0 || now[i] >= leastWeight);
                }
                points.setWeights(facei_, isInside ? now : best);
                now = points.weights(facei_);
                forAll(points_, i)
                {
                    x[points_[i]] = points.inFace(facei_, levels_[i]);
                }
            },
            [&] { best = now; },
            step_
        );
    }
};

//- The points of the mesh inside of some front faces, by face
Map<DynamicList<label>> pointsInFaces
(
    const bitSet& wanted,
    const labelUList& labels,
    const cornerPoints& points
)
{
    Map<DynamicList<label>> inFaces;
    for (const label p : wanted)
    {
        const label facei = points.wallFaceOf(labels[p]);
        if (facei >= 0)
        {
            inFaces.insert(facei, DynamicList<label>());
        }
    }
    forAll(labels, p)
    {
        auto found = inFaces.find(points.wallFaceOf(labels[p]));
        if (found.good())
        {
            found.val().append(p);
        }
    }

    return inFaces;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void movePolygonPoints
(
    const bitSet& isFixed,
    const pointMoveControls& controls,
    const label nLayerCells,
    const labelUList& labels,
    cornerPoints& points,
    polyMeshParts& mesh,
    polygonGeometry& geometry
)
{
    movingPoints moving(isFixed, controls, nLayerCells, mesh, geometry);
    const Map<DynamicList<label>> inFaces
    (
        pointsInFaces(moving.pointsOfPoor(true) - isFixed, labels, points)
    );
    bitSet singles(moving.pointsOfPoor(false) - isFixed);
    forAll(labels, p)
    {
        if (points.wallFaceOf(labels[p]) >= 0)
        {
            singles.unset(p);
        }
    }
    bitSet all(singles);
    forAllConstIters(inFaces, iter)
    {
        all.set(iter.val());
    }
    const CompactListList<label> at(facesAt(all, mesh.topology.faces));
    std::vector<facePoints> stacks;
    for (const label facei : inFaces.sortedToc())
    {
        stacks.emplace_back
        (
            facei, inFaces[facei], labels, points, at, controls.step
        );
    }
    std::vector<freePoint> free;
    for (const label p : singles)
    {
        free.emplace_back(p, at[p], controls.step, mesh);
    }
    for (label round = 0; round < controls.nRounds; ++round)
    {
        for (facePoints& stack : stacks)
        {
            stack.move(moving, controls.leastWeight, points, mesh.points);
        }
        for (freePoint& single : free)
        {
            single.move(moving, mesh.points);
        }
    }
    for (const label p : singles)
    {
        points.move(labels[p], mesh.points[p]);
    }
}

} // End namespace Foam

// ************************************************************************* //
