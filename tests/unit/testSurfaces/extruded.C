/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testSurfaces.H"
#include "flatMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

static face triangle(const label a, const label b, const label c)
{
    face f(3);
    f[0] = a;
    f[1] = b;
    f[2] = c;

    return f;
}

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::testSurfaces::extruded
(
    const List<vector2D>& polygon,
    const scalar height,
    const scalar edgeLength
)
{
    const flatMesh cap(triangulate(polygon, edgeLength));
    const label nLevels = max(label(1), label(height/edgeLength + 0.5));
    const label nB = cap.nBoundary;
    const label nP = cap.points.size();

    // The bottom cap, the boundary on each level between, the top cap
    DynamicList<point> points;
    DynamicList<face> faces;

    for (label level = 0; level <= nLevels; ++level)
    {
        const bool isCap = (level == 0 || level == nLevels);

        for (label i = 0; i < (isCap ? nP : nB); ++i)
        {
            const vector2D& p = cap.points[i];
            points.append(point(p.x(), p.y(), level*height/nLevels));
        }
    }

    const label top = points.size() - nP;

    for (const FixedList<label, 3>& t : cap.triangles)
    {
        faces.append(triangle(t[0], t[2], t[1]));
        faces.append(triangle(top + t[0], top + t[1], top + t[2]));
    }

    for (label level = 0; level < nLevels; ++level)
    {
        const label low = (level == 0 ? 0 : nP + (level - 1)*nB);
        const label high = nP + level*nB;

        for (label i = 0; i < nB; ++i)
        {
            const label j = (i + 1) % nB;
            faces.append(triangle(low + i, low + j, high + j));
            faces.append(triangle(low + i, high + j, high + i));
        }
    }

    wallSurface wall;
    wall.points.transfer(points);
    wall.faces.transfer(faces);
    wall.patchIDs.setSize(wall.faces.size());
    wall.patchIDs = 0;
    wall.patchNames = wordList(1, word("wall"));

    return wall;
}


// ************************************************************************* //
