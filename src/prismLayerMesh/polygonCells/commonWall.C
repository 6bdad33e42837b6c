/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "commonWall.H"

#include "disjointSets.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

label commonTriangles::rank(const face& f, const label k) const
{
    label n = 0;
    for (const label p : f)
    {
        n += points[p] < points[f[k]];
    }

    return n;
}


commonPolygons::commonPolygons(const label nTriangles)
:
    whole_(nTriangles),
    polygons_(identity(3*nTriangles)),
    triangles_(nTriangles)
{}


void commonPolygons::clear()
{
    pairs_.clear();
    polygons_ = identity(polygons_.size());
    edges_.clear();
    triangles_.reset();
}


void commonPolygons::divide()
{
    disjointSets sets(polygons_.size());
    forAllConstIters(pairs_, iter)
    {
        if (iter.val() == 2)
        {
            sets.join(iter.key().first(), iter.key().second());
        }
    }
    forAll(polygons_, corner)
    {
        polygons_[corner] = sets.find(corner);
    }
}

} // End namespace Foam

// ************************************************************************* //
