/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "gradientLines.H"
#include "ListOps.H"
#include "harmonicField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

typedef FixedList<scalar, 4> barycentrics;

//- Floor on the volume of a sliver relative to its edges
static const scalar smallestShape = 1e-14;

//- A step is no longer than this share of the local gap
static const scalar stepShare = 0.125;


static barycentrics coordinates(const tetPointRef& tet, const point& x)
{
    const vector ab = tet.b() - tet.a();
    const vector ac = tet.c() - tet.a();
    const vector ad = tet.d() - tet.a();
    const vector ax = x - tet.a();
    const scalar sixV =
        max((ab ^ ac) & ad, smallestShape*mag(ab)*mag(ac)*mag(ad));

    barycentrics l;
    l[1] = ((ac ^ ad) & ax)/sixV;
    l[2] = ((ad ^ ab) & ax)/sixV;
    l[3] = ((ab ^ ac) & ax)/sixV;
    l[0] = 1 - l[1] - l[2] - l[3];

    return l;
}


static label lowest(const barycentrics& l)
{
    label low = 0;

    for (label i = 1; i < 4; ++i)
    {
        if (l[i] < l[low])
        {
            low = i;
        }
    }

    return low;
}


//- A point that moves through the mesh
struct walker
{
    const backgroundMesh& mesh;

    label tet;
    barycentrics l;

    //- Go to x, from the tetrahedron where it is. False where the boundary is
    //  on the way.
    bool moveTo(const point& x)
    {
        const scalar tolerance = 1e-9;

        for (label step = 0; step < 1000; ++step)
        {
            l = coordinates(mesh.tet(tet), x);
            const label low = lowest(l);

            if (l[low] >= -tolerance)
            {
                return true;
            }

            const label next = mesh.neighbours[tet][low];

            if (next < 0)
            {
                return false;
            }

            tet = next;
        }

        return false;
    }

    template<class Type>
    Type interpolate(const Field<Type>& values) const
    {
        const tetCell& t = mesh.tets[tet];

        return l[0]*values[t[0]] + l[1]*values[t[1]] + l[2]*values[t[2]]
          + l[3]*values[t[3]];
    }
};


//- The tetrahedron among those that d points into most
static label startTet
(
    const backgroundMesh& mesh,
    const labelList& tets,
    const point& p,
    const vector& d
)
{
    label best = -1;
    scalar bestLow = -GREAT;

    for (const label t : tets)
    {
        const barycentrics l(coordinates(mesh.tet(t), p + d));
        scalar low = GREAT;

        // Of the point itself, the coordinate is 1 minus the others
        for (label i = 0; i < 4; ++i)
        {
            if (mesh.points[mesh.tets[t][i]] != p)
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


//- Trace one line, from point p of the wall along start
static void trace
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const vectorField& directions,
    const labelList& tets,
    const label p,
    const vector& start,
    const label line,
    const scalarField& arcLengths,
    gradientLines& lines
)
{
    const label n = lines.nSamples;
    point x = mesh.points[p];
    vector d = start;

    walker w{mesh, -1, {}};
    w.tet = startTet(mesh, tets, x, 1e-3*mesh.gaps[p]*d);
    bool inside = w.tet >= 0;

    // Where the gap is far less than the length, the line ends soon
    const scalar step =
        max(stepShare*mesh.gaps[p], 1e-3*arcLengths[line*n + n - 1]);

    scalar s = 0;
    lines.lengths[line] = arcLengths[line*n + n - 1];

    for (label i = 0; i < n; ++i)
    {
        const scalar target = arcLengths[line*n + i];

        while (inside && s < target)
        {
            const scalar ds = min(step, target - s);
            x += ds*d;
            s += ds;

            inside = w.moveTo(x) && w.interpolate(field) > 1e-3;

            if (inside)
            {
                const vector g = w.interpolate(directions);
                d = normalised(mag(g) > SMALL ? g : d);
            }
            else
            {
                lines.lengths[line] = s;
            }
        }

        lines.points[line*n + i] = x + (target - s)*d;
        lines.energies[line*n + i] = inside ? w.interpolate(field) : 0;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::gradientLines Foam::makeGradientLines
(
    const backgroundMesh& mesh,
    const scalarField& field,
    const labelList& wallPoints,
    const vectorField& wallDirections,
    const scalarField& arcLengths
)
{
    // On the wall the mean of the lines that begin there
    vectorField directions(-pointGradients(mesh, field));
    for (label p = 0; p < mesh.nWallPoints; ++p)
    {
        directions[p] = Zero;
    }
    forAll(wallPoints, line)
    {
        directions[wallPoints[line]] += wallDirections[line];
    }
    for (vector& d : directions)
    {
        d = normalised(d);
    }

    gradientLines lines;
    lines.nSamples = arcLengths.size()/wallPoints.size();
    lines.points.setSize(arcLengths.size());
    lines.energies.setSize(arcLengths.size());
    lines.lengths.setSize(wallPoints.size());

    labelListList pointTets;
    invertManyToMany(mesh.points.size(), mesh.tets, pointTets);

    forAll(wallPoints, line)
    {
        const label p = wallPoints[line];

        trace
        (
            mesh, field, directions, pointTets[p], p, wallDirections[line],
            line, arcLengths, lines
        );
    }

    return lines;
}


Foam::gradientLines Foam::makeStraightLines
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
    lines.lengths.setSize(starts.size());

    forAll(arcLengths, i)
    {
        const label line = i/lines.nSamples;
        lines.points[i] = starts[line] + arcLengths[i]*directions[line];
        lines.lengths[line] = arcLengths[i];
    }

    return lines;
}


// ************************************************************************* //
