/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshSurface.H"
#include "autoPtr.H"
#include "boundBox.H"
#include "cutSurface.H"
#include "edgeBounds.H"
#include "edgeHashes.H"
#include "HashSet.H"
#include "layerFront.H"
#include "nearestSurface.H"
#include "ranges.H"
#include "remesher.H"
#include "stageProgress.H"
#include "triFace.H"
#include "wallSides.H"

namespace Foam
{

//- Faces of a surface that are further than a distance from another one, with
//  their centre or a point, and the nearest faces there of the other one
static List<labelPair> facesAway
(
    const wallSurface& surface,
    const nearestSurface& other,
    const scalar distance
)
{
    const pointField from(samplesOf(surface));
    pointField nearest;
    labelList faces;
    other.find(from, nearest, faces);
    DynamicList<labelPair> away;
    forAll(surface.faces, facei)
    {
        labelList samples(surface.faces[facei]);
        samples.append(surface.points.size() + facei);

        for (const label i : samples)
        {
            if (mag(nearest[i] - from[i]) > distance)
            {
                away.append(labelPair(facei, faces[i]));
            }
        }
    }

    return List<labelPair>(std::move(away));
}


//- Returns the given faces, and those that leave no room for layers. A face
//  leaves none if it is folded onto a neighbour though the given surface is not
//  folded there, or if no direction sees all faces at one of its points. A fin
//  or groove as thin as the deviation may become so.
static labelList withFacesWithoutRoom
(
    const labelUList& faces,
    const editedSurface& edited,
    const wallSurface& surface
)
{
    const edgeHashSet foldedBefore(edited.features(foldCosine()));
    const vectorField normals(surface.faceNormals());
    const wallSides all(makeWallSides(surface));
    DynamicList<label> faults(faces);
    for (label e = 0; e < all.nEdges(); ++e)
    {
        const label first = all.on(e)[0].facei;
        if (foldedBefore.found(edge(all.on(e)[0].low, all.on(e)[0].high)))
        {
            continue;
        }
        for (const wallSide& other : all.on(e))
        {
            if ((normals[first] & normals[other.facei]) < foldCosine())
            {
                faults.append(first);
                faults.append(other.facei);
            }
        }
    }

    const bitSet isBlind
    (
        surface.points.size(), pointsWithoutDirection(surface)
    );
    const auto blind = [&](const label p) { return isBlind.test(p); };
    forAll(surface.faces, facei)
    {
        if (anyOf(surface.faces[facei], blind))
        {
            faults.append(facei);
        }
    }

    return labelList(std::move(faults));
}


//- Returns the triangles of the given surface that are near to faces.
//  nearest: for each face a triangle of the given surface, -1 for none
static labelHashSet trianglesNear
(
    const givenSurface& given,
    const wallSurface& made,
    const labelUList& nearest,
    const labelUList& faces
)
{
    labelHashSet result;

    for (const label facei : faces)
    {
        const face& f = made.faces[facei];
        const scalar reach =
            f.faceEdge(f.longestEdge(made.points)).mag(made.points);
        if (nearest[facei] >= 0)
        {
            const point centre(f.centre(made.points));
            result.insert(given.around(nearest[facei], centre, reach));
        }
    }

    return result;
}


//- Returns the triangles of the given surface that are further than the
//  deviation from the new one, those beneath the faces that are nearest to
//  them, and those beneath faces that are further from it; not where edges may
//  not be shorter
static labelHashSet trianglesAway
(
    const givenSurface& shape,
    const nearestSurface& search,
    const wallSurface& made,
    const labelUList& nearest,
    const surfaceRemeshControls& controls
)
{
    const wallSurface& given = shape.surface();
    const scalar deviation = controls.deviation;
    labelHashSet result;

    for (const labelPair& f : facesAway(given, nearestSurface(made), deviation))
    {
        result.insert(f.first());
        result.insert(nearest[f.second()]);
    }
    for (const labelPair& f : facesAway(made, search, deviation))
    {
        result.insert(nearest[f.first()]);
    }
    result.erase(-1);

    const scalarField lengths(shape.lengths());
    result.filterKeys([&](const label t)
    {
        return lengths[t] > controls.minEdge;
    });

    return result;
}


// * * * * * * * * * * * * * *  Remesh Surface * * * * * * * * * * * * * * * //

//- Rounds in which the surface is kept nearer to the given one where its faces
//  intersect or are folded, or where it is too far away. After faces that
//  intersect or are folded, changes are guarded.
static constexpr label maxRounds = 8;

//- Without a deviation of the user's own, no surface is kept nearer to the
//  given one once it has so many times the faces that the first round has made
static constexpr scalar moreFaces = 1.5;


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


static remeshedSurface resultOf(const editedSurface& edited)
{
    remeshedSurface result;
    result.surface = edited.surface();
    result.features = edited.features();

    return result;
}


namespace
{

//- The rounds in which a surface is remeshed
struct remeshRounds
{
    const nearestSurface& search;
    const surfaceRemeshControls& controls;
    const edgeBounds& bounds;

    //- Whether the deviation may give way to the number of faces
    const bool mayDeviate;

    givenSurface shape;
    bool guarded = false;
    autoPtr<editedSurface> edited{};
    autoPtr<remesher> mesher{};

    //- The new surface, its faces that intersect, and these with the faces
    //  without room
    remeshedSurface result{};
    labelList conflicts{};
    labelList faults{};

    //- The last new surface without intersections. A round that brings the
    //  surface nearer may make some.
    remeshedSurface valid{};

    label nFirst = 0;


    void restart()
    {
        edited.reset(new editedSurface(shape, guarded));
        mesher.reset
        (
            new remesher
            (
                edited(), [&](editedSurface& s) { bounds.setLengths(s); }
            )
        );
        mesher->remesh();
    }

    void takeResult()
    {
        result = resultOf(edited());
        conflicts = facesInConflict(result.surface);
        faults = withFacesWithoutRoom(conflicts, edited(), result.surface);
    }

    //- Triangles that the new surface must be nearer to
    labelHashSet tooFar() const
    {
        const wallSurface& surface = result.surface;
        const labelList nearest(edited->nearestFaces());
        labelHashSet triangles(trianglesNear(shape, surface, nearest, faults));
        if (!mayDeviate || surface.faces.size() < moreFaces*nFirst)
        {
            triangles |=
                trianglesAway(shape, search, surface, nearest, controls);
        }

        return triangles;
    }

    //- Returns whether there was something to do
    bool tighten()
    {
        const labelHashSet tightened(tooFar());
        valid = faults.empty() ? result : valid;
        if (faults.empty() && tightened.empty())
        {
            return false;
        }

        shape.tighten(tightened);
        if (faults.size() && !guarded)
        {
            // Guarded changes take longer, and few surfaces need them
            guarded = true;
            restart();
        }
        else
        {
            mesher->follow();
        }
        takeResult();

        return true;
    }

    //- Returns the new surface, and its features
    remeshedSurface make()
    {
        restart();
        takeResult();
        nFirst = result.surface.faces.size();
        repeatUntilStable
        (
            "tightening triangles", maxRounds, [&]() { return tighten(); }
        );

        if (valid.surface.faces.empty())
        {
            requireNone(conflicts, result.surface);
        }

        return conflicts.size() ? valid : result;
    }
};

} // End anonymous namespace


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

    remeshRounds rounds
    {
        search, controls, bounds, given.deviation <= 0,
        givenSurface
        (
            triangles, controls.featureAngle, controls.deviation,
            controls.maxEdge
        )
    };
    remeshedSurface result(rounds.make());
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
