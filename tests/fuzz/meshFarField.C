/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFarField.H"
#include "boxSides.H"
#include "cyclicFaults.H"
#include "cellSizes.H"
#include "farBoundary.H"
#include "farFieldFaults.H"
#include "farFieldReport.H"
#include "makeFarFieldMesh.H"
#include "polygonCells.H"
#include "prismPolyMesh.H"

#include <omp.h>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

//- Why a far field may be refused
enum class reasons
{
    any,        // at any time
    nearLayers, // if the boundary is not clear of the layers
    offPlane,   // if the mesh does not end in a plane on which the wall ends
    parts,      // if the wall ends on other side patches
    bodies      // if the wall ends and has several bodies, of which one may be
                // outside of another that is around the fluid
};


//- What a message has to say
const struct
{
    const char* name;
    const char* words;
    reasons reason;
} refusals[] =
{
    {"noCellStays", "No cell of the mesh around the layers", reasons::any},
    {"tooManyCells", "cells, more than farField.maxCells", reasons::any},
    {"tooManyHexahedra", "hexahedra than farField.maxCells", reasons::any},
    {"coupledPatch", "layers need room at the patch", reasons::any},
    {"cutsLayers", "boundary cuts the layers", reasons::nearLayers},
    {"notAroundWall", "boundary is not around the wall", reasons::nearLayers},
    {"meshNotAround", "mesh is not around the layers", reasons::nearLayers},
    {"bodyOutside", "is outside of the fluid", reasons::bodies},
    {"edgesCross", "crosses another edge of its side", reasons::nearLayers},
    {"notInPlane", "no faces at the layers on the plane", reasons::offPlane},
    {"meshOnParts", "which is no plane of surface.sidePlanes", reasons::parts}
};


class farFieldStage
{
    const wallSurface& wall_;
    const prismLayerMesh& layered_;
    const fuzzFarField& asked_;
    const listener& tell_;
    const autoPtr<Time> time_;

    static autoPtr<Time> quietTime()
    {
        infoDetailLevel = 0;
        return Time::New();
    }

    farFieldMesh makeWith(const farFieldControls& controls) const;

    farFieldMesh make() const { return makeWith(asked_.controls); }

    //- Whether points of the layers are beyond the boundary, or nearly so
    bool isNearLayers() const;

    bool isJustified(reasons reason) const;

    void tellCut(const farFieldMesh& far) const;

    void check(farFieldMesh far) const;

    //- Makes polygons of layers and far field, or of layers alone, and tells
    //  the first fault
    void checkPolygons(farFieldMesh far) const;

    //- The far field, made by other numbers of threads too
    void makeAndCheck() const;

public:

    farFieldStage
    (
        const wallSurface& wall,
        const prismLayerMesh& layered,
        const fuzzFarField& asked,
        const listener& tell
    )
    :
        wall_(wall),
        layered_(layered),
        asked_(asked),
        tell_(tell),
        time_(quietTime())
    {}

    void run() const;
};

} // End anonymous namespace


farFieldMesh farFieldStage::makeWith(const farFieldControls& controls) const
{
    farFieldDomain domain;
    domain.core = asked_.core;
    domain.bounds = makeSizeBounds(controls, time_());
    if (controls.boundary.type != farBoundaryType::none)
    {
        domain.boundary = makeFarBoundary(controls.boundary, nullptr);
    }

    domain.boundary.cyclicSides = cyclicSides
    (
        controls.boundary, layered_.made.layers.border.sides
    );

    return makeFarFieldMesh(layered_.made.layers, domain, controls);
}


bool farFieldStage::isNearLayers() const
{
    const prismLayers& layers = layered_.made.layers;
    const farBoundaryControls& boundary = asked_.controls.boundary;
    const label nSides = layers.border.sides.size();

    for (const point& x : layers.points)
    {
        // Coarse triangles of a sphere are inside of it
        if
        (
            boundary.type == farBoundaryType::sphere
         && mag(x - boundary.origin) > 0.5*boundary.radius
        )
        {
            return true;
        }
        for (label i = nSides; i < asked_.planes.size(); ++i)
        {
            if (asked_.planes[i].distance(x) > 0)
            {
                return true;
            }
        }
    }

    return false;
}


bool farFieldStage::isJustified(const reasons reason) const
{
    if (asked_.isChecked)
    {
        return reason == reasons::any;
    }

    const List<sidePatch>& sides = wall_.border.sides;
    const bool onParts = sides.size() && sides[0].isPart();
    bool offPlane = false;
    for (label i = 0; i < sides.size() && !onParts; ++i)
    {
        offPlane = offPlane || asked_.planePatches[i].size() == 1;
    }

    switch (reason)
    {
        case reasons::any: return true;
        case reasons::nearLayers: return onParts || isNearLayers();
        case reasons::offPlane: return offPlane;
        case reasons::parts: return onParts;
        case reasons::bodies:
            return sides.size() && largestFaces(wall_).size() > 1;
    }

    return false;
}


void farFieldStage::tellCut(const farFieldMesh& far) const
{
    const faceQualityCounts cut
    (
        makeFarFieldReport(layered_.made.layers, far, qualityControls()).cut
    );
    if (cut.nFaces)
    {
        std::ostringstream os;
        os  << cut.nFaces << ' ' << cut.maxNonOrtho << ' ' << cut.minWeight;
        tell_("cut", os.str());
    }
}


void farFieldStage::check(farFieldMesh far) const
{
    tell_("stage", "farFieldChecks");
    tellCut(far);
    const autoPtr<polyMesh> mesh
    (
        makePrismPolyMesh
        (
            layered_.made.layers, far,
            IOobject("mesh", time_->constant(), *time_)
        )
    );
    const std::string fault
    (
        findFarFieldFault({wall_, layered_.made.layers, asked_, *mesh})
      + findCyclicFault(*mesh)
    );
    if (fault.size())
    {
        tell_("failed", fault);
    }
}


void farFieldStage::checkPolygons(farFieldMesh far) const
{
    tell_("stage", "polygons");
    const prismLayers& layers = layered_.made.layers;
    List<sidePatch> sides(layers.border.sides);
    if (!far.empty())
    {
        sides = cyclicSides(asked_.controls.boundary, sides);
    }
    polygonMesh polygons(makePolygonCells(layers, far, sides));
    if
    (
        polygons.counts.nLayerCells
     != polygons.counts.nColumns*layers.nLayers
    )
    {
        tell_("failed", "columns of polygons without all layers");
    }
    const autoPtr<polyMesh> mesh
    (
        makePolyMesh
        (
            std::move(polygons.mesh),
            IOobject("polygons", time_->constant(), *time_)
        )
    );
    const bool isFaulty =
        mesh->checkTopology(false) || mesh->checkFaceVertices(false)
     || mesh->checkClosedBoundary(false) || mesh->checkCellVolumes(false);
    if (isFaulty)
    {
        tell_("failed", "checkMesh finds faults of the polygons");
    }
    const std::string fault
    (
        findPolygonFault(*mesh, layers.patchNames.size(), layers.nLayers)
      + findCyclicFault(*mesh)
    );
    if (fault.size())
    {
        tell_("failed", fault);
    }
}


void farFieldStage::makeAndCheck() const
{
    const farFieldMesh far(make());

    // Now and then, as the numbers of the case have it
    if (label(1000*asked_.controls.gap) % 8 == 0)
    {
        const label nThreads = omp_get_max_threads();
        omp_set_num_threads(nThreads == 1 ? 2 : 1);
        const farFieldMesh other(make());
        omp_set_num_threads(nThreads);
        if
        (
            other.points != far.points
         || other.topology.faces != far.topology.faces
         || other.topology.owner != far.topology.owner
         || other.topology.neighbour != far.topology.neighbour
        )
        {
            tell_("failed", "the number of threads changes the far field");
        }
    }

    check(far);

    if (asked_.hasPolygons && asked_.controls.type != farFieldType::mesh)
    {
        farFieldControls controls(asked_.controls);
        controls.forPolygons = true;
        checkPolygons(makeWith(controls));
        checkPolygons(farFieldMesh());
    }
}


void farFieldStage::run() const
{
    tell_("farField", asked_.kind);
    tell_("stage", "farFieldMesh");

    try
    {
        makeAndCheck();
    }
    catch (const Foam::error& e)
    {
        const std::string message(oneLine(e.message()));
        for (const auto& refusal : refusals)
        {
            if
            (
                message.find(refusal.words) != std::string::npos
             && isJustified(refusal.reason)
            )
            {
                tell_("refused", refusal.name);
                return;
            }
        }
        throw;
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::meshFarField
(
    const wallSurface& wall,
    const prismLayerMesh& made,
    const fuzzFarField& asked,
    const listener& tell
)
{
    farFieldStage(wall, made, asked, tell).run();
}


// ************************************************************************* //
