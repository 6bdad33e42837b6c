/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remesher.H"

#include "remeshSurface.H"
#include "autoPtr.H"
#include "boundBox.H"
#include "cutSurface.H"
#include "remeshFaults.H"
#include "stageProgress.H"
#include "triFace.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Rounds in which the surface is kept nearer to the given one where its faces
//  intersect or are folded, or where it is too far away. After faces that
//  intersect or are folded, changes are guarded.
static constexpr label maxRounds = 8;


static surfaceRemeshControls withDefaults
(
    const surfaceRemeshControls& given,
    const scalar diagonal
)
{
    surfaceRemeshControls controls(given);
    const auto setDefault = [](scalar& length, const scalar value)
    {
        length = length > 0 ? length : value;
    };
    setDefault(controls.maxEdge, 0.02*diagonal);
    setDefault(controls.minEdge, 0.02*controls.maxEdge);
    setDefault(controls.deviation, 5e-4*diagonal);

    return controls;
}


//- Polygons as triangles, except those that need not be changed
static wallSurface trianglesOf
(
    const wallSurface& surface,
    const surfaceRemeshControls& controls,
    const edgeBounds& bounds
)
{
    const scalarField longest(bounds.atPoints(surface));
    wallSurface result(surface);
    DynamicList<face> faces;
    DynamicList<label> patchIDs;

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        bool isKept = f.size() > 3;
        for (const edge& e : f.edges())
        {
            const scalar length = e.mag(surface.points);
            isKept = isKept
             && length >= controls.minEdge
             && length <= min(longest[e.start()], longest[e.end()]);
        }

        if (isKept)
        {
            faces.append(f);
            patchIDs.append(surface.patchIDs[facei]);
            continue;
        }

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            faces.append(triFace(f[0], f[k], f[k + 1]));
            patchIDs.append(surface.patchIDs[facei]);
        }
    }

    result.faces = std::move(faces);
    result.patchIDs = std::move(patchIDs);

    return result;
}


static void requireNone(const labelList& conflicts, const wallSurface& made)
{
    if (conflicts.size())
    {
        FatalErrorInFunction
            << conflicts.size() << " faces intersect after surface.remesh,"
            << " the first at "
            << made.faces[conflicts[0]].centre(made.points) << nl
            << "A smaller surface.remesh.deviation or minEdge may help."
            << exit(FatalError);
    }
}


static remeshedSurface resultOf(const remesher& mesher)
{
    remeshedSurface result;
    result.surface = mesher.edited().surface();
    result.features = mesher.edited().features();

    return result;
}


//- The new surface on given triangles, and its features
static remeshedSurface remeshed
(
    const wallSurface& triangles,
    const nearestSurface& search,
    const surfaceRemeshControls& controls,
    const edgeBounds& bounds
)
{
    givenSurface shape(triangles, controls.featureAngle, controls.deviation);
    bool guarded = false;
    autoPtr<remesher> mesher(new remesher(shape, controls, bounds, guarded));
    mesher->remesh();
    remeshedSurface result(resultOf(mesher()));
    labelList conflicts(facesInConflict(result.surface));
    labelList faces(withFacesWithoutRoom(conflicts, mesher(), result.surface));

    // The last without intersections, which a round for distances may bring
    remeshedSurface valid;

    const auto tighten = [&]()
    {
        const wallSurface& surface = result.surface;
        const labelList nearest(mesher->edited().nearestFaces());
        labelHashSet tightened(trianglesNear(shape, surface, nearest, faces));
        tightened |= trianglesAway(shape, search, surface, nearest, controls);

        valid = faces.empty() ? result : valid;
        if (faces.empty() && tightened.empty())
        {
            return false;
        }

        shape.tighten(tightened);
        if (faces.size() && !guarded)
        {
            // Guarded changes take longer, and few surfaces need them
            guarded = true;
            mesher.reset(new remesher(shape, controls, bounds, guarded));
            mesher->remesh();
        }
        else
        {
            mesher->follow();
        }
        result = resultOf(mesher());
        conflicts = facesInConflict(result.surface);
        faces = withFacesWithoutRoom(conflicts, mesher(), result.surface);

        return true;
    };
    repeatUntilStable("tightening triangles", maxRounds, tighten);

    if (valid.surface.faces.empty())
    {
        requireNone(conflicts, result.surface);
    }

    return conflicts.size() ? valid : result;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

remeshedSurface remeshSurface
(
    const wallSurface& surface,
    const surfaceRemeshControls& given,
    const PtrList<regionSearch>& regions
)
{
    const surfaceRemeshControls controls
    (
        withDefaults(given, boundBox(surface.points, false).mag())
    );
    const edgeBounds bounds(surface, controls, regions);
    const wallSurface triangles(trianglesOf(surface, controls, bounds));
    const nearestSurface search(triangles);

    remeshedSurface result(remeshed(triangles, search, controls, bounds));
    bounds.requirePointsInRegions(result.surface);
    result.distance = distanceTo(search, result.surface);
    result.distanceOfGiven =
        distanceTo(nearestSurface(result.surface), surface);
    result.quality = qualityAwayFromFeatures
    (
        result.surface, result.features, controls.minEdge
    );

    return result;
}

} // End namespace Foam

// ************************************************************************* //
