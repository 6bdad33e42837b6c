/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gradientLines.H"
#include "columnControls.H"
#include "ListOps.H"
#include "harmonicField.H"
#include "ranges.H"
#include "stageProgress.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef FixedList<scalar, 4> barycentrics;

static barycentrics coordinates(const tetPointRef& tet, const point& x)
{
    const tetAreas areas(tet);
    const vector ax = x - tet.a();

    barycentrics l;
    for (label i = 1; i < 4; ++i)
    {
        l[i] = (areas.normals[i - 1] & ax)/areas.sixV;
    }
    l[0] = 1 - l[1] - l[2] - l[3];

    return l;
}


namespace
{

//- A point that moves through the mesh
struct walker
{
    const backgroundMesh& mesh;

    //- Whether the point stays on a side patch that it would cross
    bool staysOnSides;

    label tet;
    barycentrics l;

    //- Whether the face opposite to a point of the tetrahedron is on a side
    //  patch: a face on the wall has points of the wall alone, a face beyond
    //  the envelope has no point inside
    bool isOnSide(const label opposite) const
    {
        const triFace f(mesh.tets[tet].face(opposite));

        return mesh.neighbours[tet][opposite] < 0
         && anyOf(f, [&](const label p) { return mesh.inside(p); })
         && anyOf(f, [&](const label p) { return !mesh.onWall(p); });
    }

    //- Go to x, from the tetrahedron where it is. False where the boundary is
    //  on the way. If the point stays on side patches, x goes back to them.
    bool moveTo(point& x)
    {
        bool isThere = false;
        label low = -1;
        const auto enterNext = [&]()
        {
            l = coordinates(mesh.tet(tet), x);
            low = findMin(l);
            isThere = l[low] >= -columnControls::tetTolerance;
            const label next = isThere ? -1 : mesh.neighbours[tet][low];
            tet = next < 0 ? tet : next;

            return next >= 0;
        };
        repeatUntilStable
        (
            "walking to a point", columnControls::maxTets, enterNext
        );

        if (!isThere && staysOnSides && isOnSide(low))
        {
            scalar sum = 0;
            for (scalar& coordinate : l)
            {
                coordinate = max(coordinate, scalar(0));
                sum += coordinate;
            }
            for (scalar& coordinate : l)
            {
                coordinate /= sum;
            }
            x = interpolate(mesh.points);
            isThere = true;
        }

        return isThere;
    }

    template<class Type>
    Type interpolate(const Field<Type>& values) const
    {
        const tetCell& t = mesh.tets[tet];

        return l[0]*values[t[0]] + l[1]*values[t[1]] + l[2]*values[t[2]]
          + l[3]*values[t[3]];
    }
};


//- Traces lines from points of the wall
class lineTracer
{
    const backgroundMesh& mesh_;
    const scalarField& field_;
    const linesFor use_;

    //- Directions of the lines at the points of the mesh, as long as they count
    const vectorField directions_;

    labelListList pointTets_;


    //- On the wall the mean of the lines that begin there
    static vectorField directionsOf
    (
        const backgroundMesh& mesh,
        const scalarField& field,
        const labelList& wallPoints,
        const vectorField& wallDirections,
        const linesFor use
    )
    {
        const gradientMeans means(pointGradientMeans(mesh, field));
        vectorField directions(-means.gradients);

        SubList<vector>(directions, mesh.nWallPoints) = Zero;
        forAll(wallPoints, line)
        {
            directions[wallPoints[line]] += wallDirections[line];
        }
        forAll(directions, p)
        {
            const bool isUnit =
                p < mesh.nWallPoints || use == linesFor::columns;

            directions[p] = isUnit
              ? normalised(directions[p])
              : directions[p]/max(means.sizes[p], VSMALL);
        }

        return directions;
    }


    //- The tetrahedron at point p that d points into most; -1 if there is none
    label startTet(const label p, const vector& d) const
    {
        const point& x = mesh_.points[p];
        label best = -1;
        scalar bestLow = -GREAT;

        for (const label t : pointTets_[p])
        {
            const barycentrics l(coordinates(mesh_.tet(t), x + d));
            scalar low = GREAT;

            // The coordinate of the point itself is 1 minus the others
            for (label i = 0; i < 4; ++i)
            {
                if (mesh_.points[mesh_.tets[t][i]] != x)
                {
                    low = min(low, l[i]);
                }
            }

            if (low > bestLow)
            {
                bestLow = low;
                best = t;
            }
        }

        return best;
    }

public:

    lineTracer
    (
        const backgroundMesh& mesh,
        const scalarField& field,
        const labelList& wallPoints,
        const vectorField& wallDirections,
        const linesFor use
    )
    :
        mesh_(mesh),
        field_(field),
        use_(use),
        directions_
        (
            directionsOf(mesh, field, wallPoints, wallDirections, use)
        )
    {
        invertManyToMany(mesh.points.size(), mesh.tets, pointTets_);
    }


    //- Set the samples of one line, from point p of the wall along d
    void trace
    (
        const label p,
        vector d,
        const SubList<scalar>& arcLengths,
        SubList<point> points,
        SubList<scalar> energies
    ) const
    {
        const scalar gap = mesh_.gaps[p];
        point x = mesh_.points[p];
        scalar s = 0;

        walker w
        {
            mesh_, use_ == linesFor::levelSets,
            startTet(p, columnControls::probeShare*gap*d), {}
        };
        bool inside = w.tet >= 0;

        // If the gap is far less than the length, the line ends soon
        const scalar step = max
        (
            columnControls::stepShare*gap,
            columnControls::leastStep*arcLengths.last()
        );

        forAll(arcLengths, i)
        {
            while (inside && s < arcLengths[i])
            {
                const scalar ds = min(step, arcLengths[i] - s);
                x += ds*d;
                s += ds;

                inside = w.moveTo(x)
                 && w.interpolate(field_) > columnControls::endValue;

                if (inside)
                {
                    const vector g = w.interpolate(directions_);
                    d = normalised(mag(g) > SMALL ? g : d);
                }
            }

            points[i] = x + (arcLengths[i] - s)*d;
            energies[i] = inside ? w.interpolate(field_) : 0;
        }
    }
};

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

gradientLines makeGradientLines
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const labelList& wallPoints,
    const vectorField& wallDirections,
    const scalarField& arcLengths,
    const linesFor use
)
{
    gradientLines lines;
    const label n = lines.nSamples = arcLengths.size()/wallPoints.size();
    lines.points.setSize(arcLengths.size());
    lines.energies.setSize(arcLengths.size());

    const lineTracer tracer(mesh, field, wallPoints, wallDirections, use);

    #pragma omp parallel for schedule(dynamic, 256)
    forAll(wallPoints, line)
    {
        tracer.trace
        (
            wallPoints[line],
            wallDirections[line],
            SubList<scalar>(arcLengths, n, line*n),
            SubList<point>(lines.points, n, line*n),
            SubList<scalar>(lines.energies, n, line*n)
        );
    }

    return lines;
}


gradientLines makeStraightLines
(
    const pointField& starts,
    const vectorField& directions,
    const scalarField& arcLengths
)
{
    gradientLines lines;
    lines.nSamples = arcLengths.size()/starts.size();
    lines.points.setSize(arcLengths.size());
    lines.energies.setSize(arcLengths.size(), 0);

    #pragma omp parallel for schedule(static, 256)
    forAll(arcLengths, i)
    {
        const label line = i/lines.nSamples;
        lines.points[i] = starts[line] + arcLengths[i]*directions[line];
    }

    return lines;
}

} // End namespace Foam

// ************************************************************************* //
