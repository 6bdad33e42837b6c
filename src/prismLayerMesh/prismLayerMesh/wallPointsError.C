/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPointsError.H"
#include "flushSides.H"
#include "HashSet.H"
#include "HashTable.H"
#include "unitConversion.H"

namespace Foam
{

//- Product of the normals, into the fluid, of a face and of a side patch that
//  continues it: cos(18 degrees)
static constexpr scalar flushCosine = 0.95;

//- The same of a side patch on which layers cannot end well: the wall meets it
//  at 135 degrees in the fluid
static constexpr scalar obtuseCosine = 0.7072;


//- Returns the largest product of the normals, into the fluid, of each side
//  patch and of the faces at some points on it
static HashTable<scalar> sideCosines
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const labelUList& points
)
{
    HashTable<scalar> cosines;

    for (const label p : points)
    {
        for (const label s : addressing.sidesOf(p))
        {
            const sidePatch& side = wall.border.sides[s];
            for (const label facei : addressing.pointFaces[p])
            {
                scalar& largest = cosines(side.name, -1);
                largest = max(largest, sideCosine(wall, facei, side, p));
            }
        }
    }

    return cosines;
}


void checkSidesOf(const wallSurface& wall, const wallAddressing& addressing)
{
    labelHashSet points;
    for (const label k : flushEdges(wall))
    {
        points.insert(wall.border.edges[k]);
    }

    if (points.size())
    {
        const labelList all(points.sortedToc());
        throw wallPointsError
        (
            wall, all,
            "are where the wall meets a side patch at more than 177 degrees",
            adviceOnPoints(wall, addressing, all)
        );
    }
}


string adviceOnPoints
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const labelUList& points
)
{
    string advice;
    const HashTable<scalar> cosines(sideCosines(wall, addressing, points));

    for (const word& name : cosines.sortedToc())
    {
        const scalar cosine = cosines[name];

        if (cosine > flushCosine)
        {
            advice +=
                "The side patch " + name + " continues the wall in its plane:"
                " give it layers, too, by layers.patches { " + name
              + " { type patch; } }.\n";
        }
        else if (cosine > obtuseCosine)
        {
            const label angle = round(180 - radToDeg(::acos(cosine)));
            advice +=
                "The wall meets the side patch " + name + " at "
              + Foam::name(angle) + " degrees in the fluid, and layers end well"
                " at up to 135: turn the side patch, or the wall beside it.\n";
        }
    }

    return
        advice + "The faces around each of these points fold back on each"
        " other, so that no layer can begin there. Round the corners off: by"
        " surface { repair wrap; wrapCoeffs { size R; } }, which goes around"
        " what is smaller than R [m], or in CAD. If the triangles there are"
        " coarse or warped, surface { remesh { } } may do.";
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

wallPointsError::wallPointsError
(
    const wallSurface& wall,
    const labelUList& points,
    const string& what,
    const string& advice
)
:
    error("wallPointsError"),
    labels_(points),
    points_(wall.points, points)
{
    OSstream& os = *this;
    os  << points.size() << " points of the wall " << what.c_str()
        << ". The first of them:";

    for (label i = 0; i < min(points.size(), 10); ++i)
    {
        os  << nl << "    point " << labels_[i] << " at " << points_[i];
    }

    if (advice.size())
    {
        os  << nl << advice.c_str();
    }
}

} // End namespace Foam

// ************************************************************************* //
