/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polygonFaces.H"

#include "CompactListList.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Starts patches until there are n
static void startPatches(const label n, polyMeshTopology& topology)
{
    while (topology.patchStarts.size() < n)
    {
        topology.startPatch();
    }
}


//- Appends a face between two cells, or on a patch
static void appendTo
(
    polyMeshTopology& topology,
    face&& f,
    const labelPair& cells
)
{
    const label first = cells.first(), second = cells.second();
    if (second < 0)
    {
        startPatches(-second, topology);
        topology.append(std::move(f), first);
        return;
    }
    topology.append
    (
        first < second ? std::move(f) : f.reverseFace(),
        min(first, second), max(first, second)
    );
}


//- The area of the smallest triangle of the fan from a corner of a face, seen
//  along a normal of any length
static scalar smallestOfFan
(
    const face& f,
    const label start,
    const UList<point>& points,
    const vector& normal
)
{
    const point& a = points[f[start]];
    scalar least = GREAT;
    for (label k = 1; k + 1 < f.size(); ++k)
    {
        const point& b = points[f[(start + k) % f.size()]];
        const point& c = points[f[(start + k + 1) % f.size()]];
        least = min(least, normal & ((b - a) ^ (c - a)));
    }

    return least;
}


//- Rotates a face so that the smallest triangle of the fan from its first point
//  is as large as can be: certificates cut faces into these fans, and at a
//  straight edge of the wall there are three points in a line. A quadrilateral
//  without such points stays, because the layers have their certificate with
//  this diagonal.
static face withBestFan(const face& f, const UList<point>& points)
{
    const vector normal(f.areaNormal(points));
    const bool isQuad = f.size() == 4;
    if (isQuad && smallestOfFan(f, 0, points, normal) > SMALL*magSqr(normal))
    {
        return f;
    }
    label best = 0;
    scalar most = -GREAT;
    forAll(f, start)
    {
        const scalar least = smallestOfFan(f, start, points, normal);
        if (least > most)
        {
            most = least;
            best = start;
        }
    }

    return face(rotateList(f, -best));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const SubList<label> polygonFaces::pointsOf(const label facei) const
{
    const label start = facei ? ends_[facei - 1] : 0;

    return SubList<label>(points_, ends_[facei] - start, start);
}


labelList polygonFaces::order
(
    const label nCells,
    const label nPatches
) const
{
    // Faces by their smaller cell, or behind these by their patch
    const auto bucketOf = [&](const labelPair& cells)
    {
        const label first = cells.first(), second = cells.second();

        return second < 0 ? nCells - 1 - second : min(first, second);
    };
    labelList n(nCells + nPatches, Zero);
    for (const labelPair& cells : cells_)
    {
        ++n[bucketOf(cells)];
    }
    CompactListList<label> faces(n);
    forAllReverse(cells_, facei)
    {
        const label bucket = bucketOf(cells_[facei]);
        faces(bucket, --n[bucket]) = facei;
    }
    for (label celli = 0; celli < nCells; ++celli)
    {
        UList<label> ofCell(faces[celli]);
        std::sort
        (
            ofCell.begin(), ofCell.end(), [&](const label a, const label b)
            {
                const label other = max(cells_[a].first(), cells_[a].second());

                return
                    labelPair(other, a)
                  < labelPair(max(cells_[b].first(), cells_[b].second()), b);
            }
        );
    }

    return faces.m();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void polygonFaces::append
(
    const UList<label>& f,
    const label first,
    const label second
)
{
    const label start = points_.size();
    for (const label p : f)
    {
        if (points_.size() == start || points_.last() != p)
        {
            points_.append(p);
        }
    }
    if (points_.size() > start && points_.last() == points_[start])
    {
        points_.remove();
    }
    if (points_.size() < start + 3)
    {
        points_.setSize(start);
        return;
    }
    ends_.append(points_.size());
    cells_.append(labelPair(first, second));
}


boolList polygonFaces::stayingPoints(const cornerPoints& points) const
{
    // Two neighbours of each point; a third one makes it stay
    boolList stays(points.size(), false);
    List<labelPair> neighbours(points.size(), labelPair(-1, -1));
    const auto add = [&](const label p, const label q)
    {
        labelPair& known = neighbours[p];
        if (known.first() < 0 || known.first() == q)
        {
            known.first() = q;
        }
        else if (known.second() < 0 || known.second() == q)
        {
            known.second() = q;
        }
        else
        {
            stays[p] = true;
        }
    };
    forAll(ends_, facei)
    {
        const SubList<label> f(pointsOf(facei));
        forAll(f, k)
        {
            const label next = f[f.fcIndex(k)];
            add(f[k], next);
            add(next, f[k]);
            stays[f[k]] = stays[f[k]] || points.isGiven(f[k]);
        }
    }

    return stays;
}


polyMeshParts polygonFaces::makeParts
(
    const cornerPoints& points,
    const boolList& stays,
    const bitSet& cells,
    const label nPatches,
    labelList& labels
) const
{
    polyMeshParts mesh;
    mesh.nCells = cells.size();
    mesh.topology.reserve(ends_.size(), ends_.size());
    labelList newLabels(points.size(), -1);
    DynamicList<point> places;
    DynamicList<label> labelsOf;
    DynamicList<label> kept;
    for (const label facei : order(cells.size(), nPatches))
    {
        const labelPair& sides = cells_[facei];
        if (!cells.test(sides.first()) && !cells.test(sides.second()))
        {
            continue;
        }
        kept.clear();
        for (const label p : pointsOf(facei))
        {
            if (!stays[p])
            {
                continue;
            }
            if (newLabels[p] < 0)
            {
                newLabels[p] = places.size();
                places.append(points.position(p));
                labelsOf.append(p);
            }
            kept.append(newLabels[p]);
        }
        if (kept.size() < 3)
        {
            FatalErrorInFunction
                << "A face between polygons is a line, at "
                << points.position(pointsOf(facei)[0]) << nl
                << "Use cells triangles" << exit(FatalError);
        }
        face f(kept);
        if (sides.second() < 0)
        {
            f = withBestFan(f, places);
        }
        appendTo(mesh.topology, std::move(f), sides);
    }
    startPatches(nPatches, mesh.topology);
    mesh.points.transfer(places);
    labels.transfer(labelsOf);

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
