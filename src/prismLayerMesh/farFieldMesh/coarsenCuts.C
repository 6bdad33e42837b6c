/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coarsenCuts.H"
#include "edgeHashes.H"
#include "HashSet.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static bool isSmooth
(
    const sidePatch& a,
    const sidePatch& b,
    const point& x
)
{
    return (a.planeAt(x).normal & b.planeAt(x).normal) > curvedCosine;
}


//- For edges of the first region that are of the second one too, in the other
//  direction, and smooth: the end of each by its start
static Map<label> commonEdges
(
    const pointField& points,
    const UList<sidePatch>& sides,
    const UList<planeRegion>& regions,
    const label s,
    const label t
)
{
    Map<label> backward;
    for (const edge& e : regions[t].boundary)
    {
        backward.insert(e.end(), e.start());
    }

    Map<label> common;
    for (const edge& e : regions[s].boundary)
    {
        if
        (
            backward.lookup(e.start(), -1) == e.end()
         && isSmooth(sides[s], sides[t], e.centre(points))
        )
        {
            common.insert(e.start(), e.end());
        }
    }

    return common;
}


//- The points of lines, in their order; a closed line begins at its lowest
static List<labelList> linesOf(const Map<label>& next)
{
    labelHashSet ends;
    forAllConstIters(next, iter)
    {
        ends.insert(iter.val());
    }

    labelHashSet done;
    DynamicList<labelList> lines;
    for (const bool isClosed : {false, true})
    {
        for (const label start : next.sortedToc())
        {
            if (done.found(start) || (!isClosed && ends.found(start)))
            {
                continue;
            }

            DynamicList<label> line;
            for (label p = start; p >= 0; p = next.lookup(p, -1))
            {
                line.append(p);
                if (!done.insert(p))
                {
                    break;
                }
            }
            lines.append(labelList(std::move(line)));
        }
    }

    return List<labelList>(std::move(lines));
}


//- The line with fewer points
static labelList coarsened
(
    const pointField& points,
    const labelList& line,
    const std::function<scalar(const point&)>& size
)
{
    // Lengths in units of the size
    scalarField at(line.size(), 0);
    for (label i = 1; i < line.size(); ++i)
    {
        const point& a = points[line[i - 1]];
        const point& b = points[line[i]];
        at[i] = at[i - 1] + mag(b - a)/size(0.5*(a + b));
    }

    const label n = max(label(::round(at.last())), label(1));
    DynamicList<label> kept;
    kept.append(line[0]);

    for (label k = 1, i = 0; k < n; ++k)
    {
        const scalar aim = at.last()*k/n;
        while (i < line.size() - 2 && mag(at[i + 1] - aim) <= mag(at[i] - aim))
        {
            ++i;
        }
        if (line[i] != kept.last())
        {
            kept.append(line[i]);
        }
    }
    kept.append(line.last());

    return labelList(std::move(kept));
}


//- Remove edges with both ends in a line, and add those of another
static void replace
(
    const labelUList& line,
    const labelUList& by,
    const bool forwards,
    planeRegion& region
)
{
    edgeHashSet gone;
    for (label i = 1; i < line.size(); ++i)
    {
        gone.insert(edge(line[i - 1], line[i]));
    }

    DynamicList<edge> left;
    for (const edge& e : region.boundary)
    {
        if (!gone.found(e))
        {
            left.append(e);
        }
    }
    for (label i = 1; i < by.size(); ++i)
    {
        left.append
        (
            forwards ? edge(by[i - 1], by[i]) : edge(by[i], by[i - 1])
        );
    }
    region.boundary.transfer(left);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void coarsenCuts
(
    const pointField& points,
    const UList<sidePatch>& sides,
    const std::function<scalar(const point&)>& size,
    List<planeRegion>& regions
)
{
    forAll(sides, s)
    {
        for (label t = s + 1; t < sides.size(); ++t)
        {
            if
            (
                !sides[s].isCurved() || !sides[t].isCurved()
             || sides[s].name != sides[t].name
            )
            {
                continue;
            }

            const Map<label> common(commonEdges(points, sides, regions, s, t));
            for (const labelList& line : linesOf(common))
            {
                const labelList fewer(coarsened(points, line, size));
                replace(line, fewer, true, regions[s]);
                replace(line, fewer, false, regions[t]);
            }
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
