/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "boundBox.H"
#include "boxSides.H"
#include "cutSurface.H"
#include "cyclicSides.H"
#include "flushSides.H"
#include "OStringStream.H"
#include "ranges.H"
#include "splitAtSidePatches.H"
#include "wallChanges.H"
#include "wallVisibility.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

template<class Changed>
static surfaceChange changeBy(const wallSurface& given, const Changed& changed)
{
    return surfaceChange
    {
        measuresOf(given), measuresOf(changed.surface), changed.distance,
        changed.distanceOfGiven
    };
}


static Ostream& operator<<(Ostream& os, const surfaceDistance& distance)
{
    return os
        << " surface: " << distance.largest << " m at most, at "
        << distance.place << ", mean " << distance.mean << " m" << nl;
}


static Ostream& operator<<(Ostream& os, const surfaceMeasures& measures)
{
    os  << ": area " << measures.area << " m2";
    if (measures.volume > 0)
    {
        os  << ", volume " << measures.volume << " m3";
    }

    return os
        << ", smallest angle " << measures.smallestAngle
        << ", faces with angles below " << surfaceMeasures::smallAngle << ": "
        << 100*measures.shareWithSmallAngles << " %" << nl;
}


static Ostream& operator<<(Ostream& os, const surfaceChange& change)
{
    return os
        << "distance from the new surface to the given" << change.distance
        << "distance from the given surface to the new"
        << change.distanceOfGiven
        << "before" << change.before << "now" << change.now;
}


//- What the log says of a repair
static string sizesOf
(
    const wallSurface& repaired,
    const repairSteps& steps,
    const surfaceChange& change
)
{
    OStringStream os;
    os  << sizesOf(repaired).c_str() << nl;
    for (const repairStep& step : steps)
    {
        os  << step.what.c_str() << ' ' << step.count;
        if (step.places.size())
        {
            os  << ", at " << step.places[0];
        }
        os  << nl;
    }
    os  << change;

    return os.str();
}


//- What the log says of a remesh
static string sizesOf
(
    const wallSurface& remeshed,
    const surfaceChange& change,
    const remeshQuality& quality
)
{
    OStringStream os;
    os  << sizesOf(remeshed).c_str() << nl << change
        << "away from features: faces with angles below "
        << surfaceMeasures::smallAngle << ": "
        << 100.0*quality.nSmallAngles/remeshed.faces.size()
        << " %, edges beyond " << remeshQuality::nonOrtho
        << " degrees of non-orthogonality: " << quality.nNonOrtho;

    return os.str();
}


//- What the log says of a wall that ends on side patches
static string sizesOf
(
    const wallSurface& wall,
    const wallReading& reading,
    const label nFacesInSides,
    const cyclicAlignment& aligned
)
{
    wordHashSet curved;
    for (const sidePatch& side : wall.border.sides)
    {
        if (side.isCurved())
        {
            curved.insert(side.name);
        }
    }

    OStringStream os;
    os  << sizesOf(wall).c_str() << " of the wall" << nl << "ends on";
    for (const word& name : sidePatchNames(wall.border))
    {
        os  << ' ' << name.c_str() << (curved.found(name) ? " (curved)" : "");
    }
    os  << ", " << wall.border.edges.size() << " edges" << nl
        << "points put on their planes " << reading.pointsPutOnSides << ", by "
        << reading.largestMove << " m at most, faces turned to the fluid "
        << reading.flippedFaces;
    if (pairsOf(wall.border.sides).size())
    {
        os  << nl << "points on cyclic sides added " << aligned.nAdded
            << ", moved along the border " << aligned.nMoved << ", all by "
            << aligned.largestMove << " m at most";
    }
    if (nFacesInSides)
    {
        os  << nl << "faces of bodies that stand on sides, removed "
            << nFacesInSides;
    }

    return os.str();
}


static void repair
(
    const wallSurfaceControls& controls,
    const layerControls& layers,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    if (controls.repair.repair == surfaceRepairControls::method::none)
    {
        return;
    }

    observer.begin("surfaceRepair");
    repairedSurface repaired(repairSurface(prepared.surface, controls, layers));
    if (repaired.steps.empty())
    {
        observer.end("nothing to repair");
        return;
    }

    prepared.repair = changeBy(prepared.surface, repaired);
    prepared.steps = std::move(repaired.steps);
    prepared.surface = std::move(repaired.surface);
    observer.end(sizesOf(prepared.surface, prepared.steps, prepared.repair));
}


static void remesh
(
    const wallSurfaceControls& controls,
    const PtrList<regionSearch>& regions,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    if (!controls.remesh.active)
    {
        return;
    }

    observer.begin("surfaceRemesh");
    remeshedSurface remeshed
    (
        remeshSurface(prepared.surface, controls.remesh, regions)
    );
    const scalar size = boundBox(remeshed.surface.points, false).mag();
    for (const sidePatch& plane : controls.sidePlanes)
    {
        // Two edges of the border may have become those of one triangle
        removeFacesOn(remeshed.surface, plane, touchShare*sideTolerance*size);
    }

    prepared.isRemeshed = true;
    prepared.remesh = changeBy(prepared.surface, remeshed);
    prepared.quality = remeshed.quality;
    prepared.surface = std::move(remeshed.surface);
    observer.end(sizesOf(prepared.surface, prepared.remesh, prepared.quality));
}


//- Returns the patches without layers that are flush with the wall
static wordList flushPatches
(
    const wallSurface& wall,
    const layerControls& layers
)
{
    wordHashSet names;
    for (const label k : flushEdges(wall))
    {
        const word& name = wall.border.sides[wall.border.edgeSides[k]].name;
        if (layers.isSide(name))
        {
            names.insert(name);
        }
    }

    return names.sortedToc();
}


//- Returns the controls with layers on patches
static layerControls withLayersOn
(
    const wordList& patches,
    const layerControls& given
)
{
    layerControls layers(given);
    for (const word& name : patches)
    {
        const word& type = given.entryOf(name)->type;
        patchLayers entry;
        entry.patches = name;
        entry.type = type.empty() ? word("patch") : type;
        layers.patches.append(entry);
    }

    return layers;
}


static void split
(
    const wallSurfaceControls& controls,
    const layerControls& layers,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    wallReading reading;
    wallSurface& wall = prepared.wall;
    wall = splitAtSidePatches(prepared.surface, controls, layers, reading);

    const wordList flush(flushPatches(wall, layers));
    if (flush.size())
    {
        reading = wallReading();
        wall = splitAtSidePatches
        (
            prepared.surface, controls, withLayersOn(flush, layers), reading
        );
        prepared.flushPatches = flush;
        observer.begin("flushPatches");
        observer.end
        (
            listed(flush) + ": flush with the wall, layers go on over them"
        );
    }
    if (wall.border.sides.empty())
    {
        return;
    }

    observer.begin("sidePatches");
    const scalar size = boundBox(wall.points, false).mag();
    const cyclicAlignment aligned(alignCyclicSides(wall, sideTolerance*size));
    observer.end(sizesOf(wall, reading, prepared.nFacesInSides, aligned));
    const List<wallDefect> defects(findWallDefects(wall, true));
    if (defects.size())
    {
        FatalErrorInFunction
            << "The wall has defects after its border was put on the side"
            << " patches" << nl << describe(defects).c_str()
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string sizesOf(const wallSurface& surface)
{
    return name(surface.faces.size()) + " faces, "
      + name(surface.points.size()) + " points, "
      + name(surface.patchNames.size()) + " patches";
}


preparedWall prepareWall
(
    const wallSurface& surface,
    const prismLayerControls& controls,
    const PtrList<regionSearch>& regions,
    const stageObserver& observer
)
{
    requirePatches(controls.layers, surface.patchNames);
    wallSurfaceControls onSides(controls.surface);
    onSides.sidePlanes = withBoxSides
    (
        surface, controls.surface.sidePlanes, controls.farField.boundary
    );

    preparedWall prepared;
    prepared.farBox = boxBehind(surface, controls.farField.boundary);
    prepared.surface = surface;
    typedef surfaceRepairControls::method method;
    if (onSides.repair.repair == method::none)
    {
        requireInFront(surface, onSides.sidePlanes);
    }
    repair(onSides, controls.layers, observer, prepared);
    prepared.nFacesInSides =
        removeFacesInSides(prepared.surface, onSides.sidePlanes);
    onSides.sidePlanes = withoutBareSides
    (
        prepared.surface, onSides.sidePlanes, controls.surface.sidePlanes.size()
    );

    observer.begin("wallDefects");
    prepared.defects =
        findWallDefects(prepared.surface, onSides.sidePlanes.size());
    if (const label n = prepared.defects.size())
    {
        observer.end(name(n) + " kinds");
        return prepared;
    }
    observer.end("none");

    remesh(onSides, regions, observer, prepared);
    split(onSides, controls.layers, observer, prepared);
    wallSurface& wall = prepared.wall;
    farBoundaryControls boundary(controls.farField.boundary);
    boundary.box = prepared.farBox;
    requireInBox(wall, boundary);
    prepared.nFlips = flipCaps(wall);
    // Repair may have folded some
    prepared.nCut = cutReflexFaces(wall);
    if (controls.farField.isWanted())
    {
        prepared.nCut += cutCrowdedFaces(wall);
    }
    prepared.nCut += cutBlindFaces(wall);
    renumberWall(wall);

    return prepared;
}

} // End namespace Foam

// ************************************************************************* //
