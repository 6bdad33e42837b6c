/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPointsError.H"

namespace Foam
{

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
