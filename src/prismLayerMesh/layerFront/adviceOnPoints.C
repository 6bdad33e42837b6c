/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adviceOnPoints.H"
#include "HashSet.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Product of the normals, into the fluid, of a face and of a side patch that
//  continues it: cos(18 degrees)
static constexpr scalar flushCosine = 0.95;


static wordList flushSides
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const labelUList& points
)
{
    wordHashSet names;

    for (const label p : points)
    {
        for (const label s : addressing.sidesOf(p))
        {
            const sidePatch& side = wall.border.sides[s];
            const vector inward(-side.planeAt(wall.points[p]).normal);

            for (const label facei : addressing.pointFaces[p])
            {
                const vector normal(wall.faces[facei].unitNormal(wall.points));

                if ((inward & normal) > flushCosine)
                {
                    names.insert(side.name);
                }
            }
        }
    }

    return names.sortedToc();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string adviceOnPoints
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const labelUList& points
)
{
    string advice;

    for (const word& name : flushSides(wall, addressing, points))
    {
        advice +=
            "The side patch " + name + " continues the wall in its plane: give"
            " it layers, too, by layers.patches { " + name
          + " { type patch; } }.\n";
    }

    return
        advice + "Round off " + (advice.empty() ? "these" : "other")
      + " corners in the surface.";
}

} // End namespace Foam

// ************************************************************************* //
