/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movePolygonPoints.H"

#include "CompactListList.H"
#include "faceQuality.H"
#include "unitConversion.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A mesh whose points move one by one
class movingPoints
{
    const pointMoveControls& controls_;
    polyMeshParts& mesh_;
    polygonGeometry& geometry_;
    const scalar leastCosine_;

    //- Poorness of each cell with points that may move, and the cells of which
    //  the poorness is out of date
    scalarField poor_;
    bitSet isOld_;

    // Of the point that moves

        //- The cells around, the poorest first, and their poorness now
        DynamicList<label> cells_;
        DynamicList<scalar> now_;

        DynamicList<schemeFace> seen_;

    const polyMeshTopology& topology() const { return mesh_.topology; }

    bool isInternal(const label facei) const
    {
        return facei < topology().neighbour.size();
    }

    //- The area of the triangles from the centre of a face to its edges that a
    //  point does not see, as share of the face
    scalar hidden
    (
        const label facei,
        const scalar way,
        const point& from
    ) const
    {
        const face& f = topology().faces[facei];
        if (f.size() == 3)
        {
            return 0;
        }
        const point& centre = geometry_.faceCentres[facei];
        const vector to(way*(centre - from));
        scalar sum = 0;
        vector last(mesh_.points[f.last()] - centre);
        for (const label p : f)
        {
            const vector next(mesh_.points[p] - centre);
            const vector area(0.5*(last ^ next));
            sum += (area & to) > 0 ? 0 : mag(area);
            last = next;
        }
        const scalar whole = max(mag(geometry_.faceAreas[facei]), sum);

        return sum > 0 ? 0.3 + sum/whole : 0;
    }

    //- How poor the angle and the skewness of a face between cells are
    scalar poornessBetween(const label facei) const
    {
        const polyMeshTopology& t = topology();
        const point& own = geometry_.cellCentres[t.owner[facei]];
        const point& other = geometry_.cellCentres[t.neighbour[facei]];
        const faceGeometry f(geometry_.faceAt(facei));
        const scalar most = controls_.maxSkewness;
        const scalar skewness =
            (f.area & (other - own)) <= 0 ? most + 5
          : skewnessAbove
            (
                f, UIndirectList<point>(mesh_.points, t.faces[facei]), own,
                other, most
            );

        return
            controls_.faceWeight
           *nonOrthoViolation(f.area, other - own, leastCosine_)
          + min(max(skewness - most, scalar(0)), scalar(5));
    }

    //- Returns how poor a cell is, or less if that is more than a bound
    scalar poorness(const label celli, const scalar bound)
    {
        const point& centre = geometry_.cellCentres[celli];
        const scalar size = ::cbrt(mag(geometry_.cellVolumes[celli]));
        scalar sum = 0;
        for (const label facei : geometry_.cells[celli])
        {
            const vector& area = geometry_.faceAreas[facei];
            const scalar way = topology().owner[facei] == celli ? 1 : -1;
            const scalar depth =
                way*(area & (geometry_.faceCentres[facei] - centre))
               /max(mag(area)*size, VSMALL);
            sum += depth > 0 ? 0 : 5 - 5*max(depth, scalar(-1));
            sum += hidden(facei, way, centre);
            sum += isInternal(facei) ? poornessBetween(facei) : 0;
            if (sum > bound)
            {
                return sum;
            }
        }
        const scalar gain = gainOf(geometry_.volumes(mesh_), celli, seen_);

        return sum + sqr(min(max(gain - controls_.gain, scalar(0)), scalar(2)));
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
                poor_[celli] = poorness(celli, GREAT);
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
            now_.append(poorness(celli, bound - sum));
            sum += now_.last();
            if (sum >= bound)
            {
                break;
            }
        }

        return sum;
    }

    void setPoint(const label p, const point& x, const labelUList& faces)
    {
        mesh_.points[p] = x;
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
        const pointMoveControls& controls,
        polyMeshParts& mesh,
        polygonGeometry& geometry
    )
    :
        controls_(controls),
        mesh_(mesh),
        geometry_(geometry),
        leastCosine_(Foam::cos(degToRad(controls.maxNonOrtho))),
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
            poor_[celli] = poorness(celli, GREAT);
        }
        isOld_.reset();
    }

    //- Returns the points of poor cells
    bitSet pointsOfPoor() const
    {
        bitSet points(mesh_.points.size());
        forAll(poor_, celli)
        {
            if (poor_[celli] > 0)
            {
                for (const label facei : geometry_.cells[celli])
                {
                    points.set(topology().faces[facei]);
                }
            }
        }

        return points;
    }

    //- Moves a point by steps along the axes while that helps; halves the step
    //  if none does. Returns whether the point has moved.
    bool move(const label p, const labelUList& faces, scalar& step)
    {
        scalar least = setCells(faces);
        point best(mesh_.points[p]);
        bool hasMoved = false;
        bool isBest = true;
        for (label i = 0; i < 6 && least > 0; ++i)
        {
            vector way(Zero);
            way[i/2] = (i % 2 ? -step : step);
            setPoint(p, best + way, faces);
            const scalar now = sumNow(0.999*least);
            isBest = now < 0.999*least;
            if (isBest)
            {
                least = now;
                best = mesh_.points[p];
                UIndirectList<scalar>(poor_, cells_) = now_;
                hasMoved = true;
            }
        }
        if (!isBest)
        {
            setPoint(p, best, faces);
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

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet movePolygonPoints
(
    const bitSet& isFixed,
    const pointMoveControls& controls,
    polyMeshParts& mesh,
    polygonGeometry& geometry
)
{
    const faceList& faces = mesh.topology.faces;
    bitSet hasMoved(mesh.points.size());
    movingPoints moving(isFixed, controls, mesh, geometry);
    const bitSet isWanted(moving.pointsOfPoor() - isFixed);
    const CompactListList<label> at(facesAt(isWanted, faces));

    // Mean distances to the points beside
    scalarField steps(mesh.points.size(), 0);
    for (const label p : isWanted)
    {
        for (const label facei : at[p])
        {
            const face& f = faces[facei];
            steps[p] +=
                controls.step/at[p].size()
               *mag(mesh.points[f.nextLabel(f.find(p))] - mesh.points[p]);
        }
    }
    for (label round = 0; round < controls.nRounds; ++round)
    {
        for (const label p : isWanted)
        {
            if (moving.move(p, at[p], steps[p]))
            {
                hasMoved.set(p);
            }
        }
    }

    return hasMoved;
}

} // End namespace Foam

// ************************************************************************* //
