/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "waysOnSurface.H"
#include "boundBox.H"
#include "ranges.H"
#include "splitAtSidePatches.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points do not move along planes or faces that meet the plane of the cut at
//  less than 30 degrees: square of the part of its normal along them
static constexpr scalar leastWay = 0.25;

//- Normals that are further apart than this are normals of different smooth
//  parts of a surface: cos(20 degrees)
static constexpr scalar smoothCosine = 0.94;

//- A point may leave its faces by this share of the diagonal of what is in
//  front of the plane
static constexpr scalar leaveShare = 5e-4;


//- Removes the component along a normal from a direction.
//  across: normals that were removed before, orthonormal; gets this one
static void removeAlong
(
    vector normal,
    DynamicList<vector>& across,
    vector& direction
)
{
    for (const vector& n : across)
    {
        normal -= (normal & n)*n;
    }
    if (mag(normal) > sideTolerance)
    {
        normal /= mag(normal);
        direction -= (direction & normal)*normal;
        across.append(normal);
    }
}


//- The diagonal of what a point may leave a share of. At a cyclic plane it is
//  the diagonal of all of the surface: points move alike on both sides.
static scalar diagonalAt(const pointField& points, const sidePatch& plane)
{
    return
        plane.type == "cyclic"
      ? boundBox(points, false).mag()
      : diagonalInFront(points, List<sidePatch>(1, plane));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

waysOnSurface::waysOnSurface
(
    const sidePatch& plane,
    const UList<sidePatch>& others,
    const wallSurface& surface,
    const bitSet& points
)
:
    plane_(plane),
    others_(others),
    surface_(surface),
    onBorder_(borderPoints(surface)),
    rounding_
    (
        touchShare*sideTolerance*boundBox(surface.points, false).mag()
    ),
    mayLeave_(leaveShare*diagonalAt(surface.points, plane))
{
    const vectorField faceNormals(surface.faceNormals());
    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            if (points.test(p) && faceNormals[facei] != vector::zero)
            {
                normals_(p).append(normalised(faceNormals[facei]));
            }
        }
    }
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool waysOnSurface::leaves(const label p, const vector& moved) const
{
    return anyOf
    (
        normals_.lookup(p, DynamicList<vector>()),
        [&](const vector& n) { return mag(n & moved) > mayLeave_; }
    );
}


void waysOnSurface::removePlanes
(
    const label p,
    DynamicList<vector>& across,
    vector& direction
) const
{
    for (const sidePatch& other : others_)
    {
        if
        (
            onBorder_.test(p) && &other != &plane_
         && mag(other.distance(surface_.points[p])) <= rounding_
        )
        {
            removeAlong(other.normal, across, direction);
        }
    }
}


void waysOnSurface::removeFaces
(
    const label p,
    DynamicList<vector>& across,
    vector& direction
) const
{
    DynamicList<vector> parts;
    const DynamicList<vector> none;
    for (const vector& n : normals_.lookup(p, none))
    {
        const bool isNew = allOf(parts, [&](const vector& part)
        {
            return (part & n) < smoothCosine;
        });
        if (isNew)
        {
            parts.append(n);
            removeAlong(n, across, direction);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

vector waysOnSurface::move(const label p) const
{
    const scalar distance = plane_.distance(surface_.points[p]);
    DynamicList<vector> across;
    vector alongPlanes(plane_.normal);
    removePlanes(p, across, alongPlanes);
    vector alongFaces(alongPlanes);
    removeFaces(p, across, alongFaces);

    for (const vector& way : {alongFaces, alongPlanes})
    {
        const scalar length = -distance/max(magSqr(way), VSMALL);
        const vector moved(length*way);
        if (magSqr(way) >= leastWay && !leaves(p, moved))
        {
            return moved;
        }
    }

    return Zero;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet borderPoints(const wallSurface& surface)
{
    bitSet points(surface.points.size());
    for (const edge& e : outline(surface.faces))
    {
        points.set(e.start());
        points.set(e.end());
    }

    return points;
}


scalar diagonalInFront
(
    const pointField& points,
    const UList<sidePatch>& planes
)
{
    boundBox box(boundBox::invertedBox);
    for (point x : points)
    {
        for (const sidePatch& plane : planes)
        {
            x -= max(plane.distance(x), scalar(0))*plane.normal;
        }
        box.add(x);
    }

    return box.mag();
}

} // End namespace Foam

// ************************************************************************* //
