/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomSurface.H"
#include "boundBox.H"
#include "EdgeMap.H"
#include "endWall.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace randomSurfaces
{

//- Cuts what is beyond a plane off a surface
class planeCutter
{
    const sidePatch& plane_;
    wallSurface& surface_;

    //- Of the points; those on the plane have zero
    scalarField distances_;

    EdgeMap<label> cuts_;

    //- The point of an edge that is on the plane
    label cut(const edge& e)
    {
        if (!cuts_.found(e))
        {
            const label a = min(e.start(), e.end());
            const label b = max(e.start(), e.end());
            const scalar t = distances_[a]/(distances_[a] - distances_[b]);
            const pointField& points = surface_.points;
            const point x((1 - t)*points[a] + t*points[b]);

            cuts_.insert(e, points.size());
            surface_.points.append(x - plane_.distance(x)*plane_.normal);
        }

        return cuts_[e];
    }

    //- The part of a face that is not beyond the plane
    face part(const face& f)
    {
        face left;

        forAll(f, k)
        {
            const scalar d = distances_[f[k]];
            const edge e(f.faceEdge(k));

            if (d <= 0)
            {
                left.append(f[k]);
            }
            if (d*distances_[e.end()] < 0)
            {
                left.append(cut(e));
            }
        }

        return left;
    }

public:

    //- Points nearer to the plane than the tolerance [m] are put there
    planeCutter
    (
        const sidePatch& plane,
        const scalar tolerance,
        wallSurface& surface
    )
    :
        plane_(plane),
        surface_(surface),
        distances_(surface.points.size())
    {
        forAll(distances_, p)
        {
            distances_[p] = plane.distance(surface.points[p]);

            if (mag(distances_[p]) < tolerance)
            {
                surface.points[p] -= distances_[p]*plane.normal;
                distances_[p] = 0;
            }
        }
    }

    void cutAll()
    {
        faceList faces;
        faces.swap(surface_.faces);

        for (const face& f : faces)
        {
            scalar nearest = 0;
            for (const label p : f)
            {
                nearest = min(nearest, distances_[p]);
            }

            // Faces on the plane are beyond it
            const face left(nearest < 0 ? part(f) : face());

            for (label k = 1; left.size() > 4 && k + 1 < left.size(); ++k)
            {
                surface_.faces.append(face({left[0], left[k], left[k + 1]}));
            }
            if (left.size() && left.size() <= 4)
            {
                surface_.faces.append(left);
            }
        }

        removeUnusedPoints(surface_.faces, surface_.points);
        setPatch(surface_);
    }
};


//- A plane through the middle half of a surface
static sidePatch randomPlane(const wallSurface& surface, Random& random)
{
    const boundBox box(surface.points, false);
    sidePatch plane;
    plane.name = "plane";
    plane.normal = unitVector(random);
    plane.origin =
        box.centre()
      + random.position<scalar>(-0.25, 0.25)*box.minDim()*plane.normal;

    return plane;
}

} // End namespace randomSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallSurface Foam::randomSurfaces::cutBody(Random& random)
{
    const kind whole = kind(random.position<label>(0, nKinds - 2));
    wallSurface surface(makeRandomSurface(whole, random));
    const bool fluidInside = chance(random, 0.5);
    const label nPlanes = chance(random, 0.3) ? 2 : 1;
    const scalar size = boundBox(surface.points, false).mag();
    wallSurfaceControls controls;

    for (label i = 0; i < nPlanes; ++i)
    {
        const scalar tolerance = size*logUniform(random, 1e-5, 1e-3);
        sidePatch plane(randomPlane(surface, random));
        plane.name += Foam::name(i);
        planeCutter(plane, tolerance, surface).cutAll();
        controls.sidePlanes.append(plane);
    }

    controls.fluidOutside = !fluidInside;
    wallReading reading;

    return endWall(surface, controls, layerControls(), reading);
}


// ************************************************************************* //
