/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prepareWall.H"
#include "boundBox.H"
#include "boxSides.H"
#include "cutSurface.H"
#include "cyclicSides.H"
#include "fluidSide.H"
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


//- Sets the side planes, the box, and the side on which the fluid is.
//  Errors: FatalError if the fluid is outside and nothing bounds it
static void setSides
(
    const wallSurface& surface,
    const farFieldControls& farField,
    wallSurfaceControls& controls,
    preparedWall& prepared
)
{
    const farBoundaryControls& boundary = farField.boundary;
    const List<sidePatch> given(controls.sidePlanes);
    const auto withSides = [&](const bool fluidOutside)
    {
        return withBoxSides(surface, given, boundary, fluidOutside);
    };
    controls.sidePlanes = withSides(controls.fluidOutside);
    prepared.fluidOutside =
        isFluidOutside(surface, controls.sidePlanes, controls);
    if (prepared.fluidOutside != controls.fluidOutside)
    {
        controls.sidePlanes = withSides(prepared.fluidOutside);
        controls.fluidOutside = prepared.fluidOutside;
    }
    prepared.farBox = boxBehind(surface, boundary, prepared.fluidOutside);

    if
    (
        controls.hasInside && prepared.fluidOutside && farField.isWanted()
     && farField.type != farFieldType::mesh
     && boundary.type == farBoundaryType::none && given.empty()
    )
    {
        FatalErrorInFunction
            << "The point surface.inside " << controls.inside << " is outside"
            << " of the surface, and the far field has no boundary: give"
            << " farField.boundary a box, a sphere or a surface"
            << exit(FatalError);
    }
}


//- Of a part or a patch of the files so much may be lost in its repair: samples
//  beside the edges of other bodies. A wrap goes around what is behind narrow
//  openings, and its user knows: of it patches count alone.
static constexpr scalar lossOfRepair = 0.01;
static constexpr scalar lossOfWrap = 0.5;

//- Remeshing with long edges rounds spikes off
static constexpr scalar lossOfRemesh = 0.1;


//- By how far repair and remesh may move faces [m]
static scalar largestMove
(
    const wallSurface& given,
    const wallSurfaceControls& controls,
    const preparedWall& prepared
)
{
    typedef surfaceRepairControls::method method;
    const scalar diagonal = boundBox(given.points, false).mag();
    const auto orShare = [&](const scalar length, const scalar share)
    {
        return length > 0 ? length : share*diagonal;
    };
    const surfaceRepairControls& repair = controls.repair;
    scalar move = 0;
    if (prepared.steps.size())
    {
        move =
            repair.repair == method::wrap
          ? orShare(repair.size, 0.01) : 2*orShare(repair.gap, 1e-4);
    }
    if (prepared.isRemeshed)
    {
        move += orShare(controls.remesh.deviation, 5e-4);
    }

    return move;
}


//- Makes the account of the surface of the files.
//  share: of a part or a patch, may be lost
//  Errors: FatalError if more is lost
static void certify
(
    const wallSurface& given,
    const wallSurface& apart,
    const prismLayerControls& controls,
    const scalar share,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    observer.begin("wallAccount");
    accountControls counting;
    counting.planes = controls.surface.sidePlanes;
    if (controls.farField.boundary.type == farBoundaryType::box)
    {
        counting.planes.append(sidesOf(prepared.farBox));
    }
    counting.fluidOutside = prepared.fluidOutside;
    counting.apart = apart;
    counting.move = largestMove(given, controls.surface, prepared);
    prepared.account = makeWallAccount(given, prepared.surface, counting);
    observer.end(describe(prepared.account));

    typedef surfaceRepairControls::method method;
    const bool isWrap = controls.surface.repair.repair == method::wrap;
    const string lost
    (
        describeLosses
        (
            prepared.account, controls.surface.acceptedLosses,
            isWrap ? lossOfWrap : share, !isWrap
        )
    );
    if (lost.size())
    {
        FatalErrorInFunction
            << "The wall is not the geometry of the files." << nl
            << lost.c_str()
            << "Repair, side planes or remesh have removed it or moved it. To"
            << " find a repair that loses nothing, write surface.repair none"
            << " and run harmonicPrismMesh -checkSurface. If the fluid is on"
            << " the wrong side, write a point in the fluid:" << nl
            << "    surface { inside (x y z); }" << nl
            << "To accept the loss, name the patch:" << nl
            << "    surface { acceptLoss (name); }" << exit(FatalError);
    }
}


//- Makes the account of a surface that was not remeshed yet
static void certifyRepair
(
    const wallSurface& given,
    const wallSurface& apart,
    const prismLayerControls& controls,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    prepared.account = makeWallAccount(given);
    if (prepared.steps.size() || prepared.nFacesInSides || apart.faces.size())
    {
        certify(given, apart, controls, lossOfRepair, observer, prepared);
    }
}


//- Returns the surface without the pieces around it that have no wall, and sets
//  these as the far boundary
static wallSurface withoutFar
(
    const layerControls& layers,
    const farBoundaryControls& boundary,
    preparedWall& prepared
)
{
    wallSurface surface(prepared.surface);
    const bool hasSides = anyOf(surface.patchNames, [&](const word& name)
    {
        return layers.isSide(name);
    });
    if (!hasSides)
    {
        return surface;
    }

    wallSurface far(takeFarBoundary(layers, surface));
    if (far.faces.empty() || outline(far.faces).size())
    {
        return prepared.surface;
    }
    if (boundary.type != farBoundaryType::none)
    {
        FatalErrorInFunction
            << "There are two far boundaries: farField.boundary, and the patch "
            << far.patchNames[0] << " of the files, which has no layers and"
            << " does not touch the wall" << nl
            << "Remove farField.boundary, or the patch" << exit(FatalError);
    }
    prepared.far = far;

    return surface;
}


static void split
(
    const wallSurfaceControls& controls,
    const prismLayerControls& all,
    const stageObserver& observer,
    preparedWall& prepared
)
{
    const layerControls& layers = all.layers;
    const wallSurface surface
    (
        withoutFar(layers, all.farField.boundary, prepared)
    );
    wallReading reading;
    wallSurface& wall = prepared.wall;
    wall = splitAtSidePatches(surface, controls, layers, reading);

    const wordList flush(flushPatches(wall, layers));
    if (flush.size())
    {
        reading = wallReading();
        wall = splitAtSidePatches
        (
            surface, controls, withLayersOn(flush, layers), reading
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


//- Takes the surface, and turns it to the fluid
static void orient
(
    const wallSurface& surface,
    const wallSurfaceControls& given,
    const wallSurfaceControls& onSides,
    preparedWall& prepared
)
{
    prepared.surface = surface;
    if (prepared.fluidOutside != given.fluidOutside)
    {
        orientWallSurface(prepared.surface, prepared.fluidOutside);
    }
    turnSheets
    (
        prepared.surface, onSides.sidePlanes, given, prepared.fluidOutside,
        prepared.sideOfSheets
    );
}


//- Checks that the wall is in the box, flips its caps, cuts faces on which no
//  cell can be good, and renumbers it
static void finish(const farFieldControls& farField, preparedWall& prepared)
{
    wallSurface& wall = prepared.wall;
    farBoundaryControls boundary(farField.boundary);
    boundary.box = prepared.farBox;
    requireInBox(wall, boundary);
    prepared.nFlips = flipCaps(wall);
    // Repair may have folded some
    prepared.nCut = cutReflexFaces(wall);
    if (farField.isWanted())
    {
        prepared.nCut += cutCrowdedFaces(wall);
    }
    prepared.nCut += cutBlindFaces(wall);
    renumberWall(wall);
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
    preparedWall prepared;
    wallSurfaceControls onSides(controls.surface);
    setSides(surface, controls.farField, onSides, prepared);
    orient(surface, controls.surface, onSides, prepared);

    const wallSurface given(prepared.surface);
    typedef surfaceRepairControls::method method;
    if (onSides.repair.repair == method::none)
    {
        requireInFront(surface, onSides.sidePlanes);
    }
    repair(onSides, controls.layers, observer, prepared);
    const wallSurface apart
    (
        keepBesideFluid
        (
            prepared.surface, onSides.sidePlanes, controls.surface
        )
    );
    prepared.nFacesInSides = removeFacesInSides
    (
        prepared.surface, onSides.sidePlanes, prepared.fluidOutside
    );
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

    certifyRepair(given, apart, controls, observer, prepared);
    remesh(onSides, regions, observer, prepared);
    if (prepared.isRemeshed)
    {
        certify(given, apart, controls, lossOfRemesh, observer, prepared);
    }
    split(onSides, controls, observer, prepared);
    finish(controls.farField, prepared);

    return prepared;
}

} // End namespace Foam

// ************************************************************************* //
