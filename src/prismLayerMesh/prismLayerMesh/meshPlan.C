/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPlan.H"
#include "expectedFarField.H"
#include "layerStages.H"
#include "stageText.H"

#include <cmath>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Where straight columns are to end above each point of the wall
static pointField outerPointsOf
(
    const wallSurface& wall,
    const shareOfWall& start,
    prismLayerControls controls,
    const stageObserver& observer
)
{
    controls.layers.alongField = false;
    controls.layers.onLevelSets = false;
    const layerFront& front = start.share.front;
    const columnTeam team(start.share, processTeam::alone());
    const wallUnderShare under(front, start.kinds, start.curvature);
    const guidedColumns guided{wall, team, front, under, start.heights};
    const scalarField clearance(makeClearance(guided, controls, observer));
    const columnGuide guide
    (
        makeColumnGuide(guided, clearance, controls, observer, false)
    );
    const layerColumns columns
    (
        makeColumns(guided, clearance, guide, controls.layers, observer)
    );

    pointField outer(wall.points);
    forAll(outer, c)
    {
        const scalar height = columns.maxThickness[c];
        outer[c] += height*columns.axisOffset(front.visibility, c, height);
    }

    return outer;
}


//- A number to two digits
static scalar rounded(const scalar value)
{
    if (value <= 0)
    {
        return 0;
    }
    const scalar unit = std::pow(10.0, std::floor(std::log10(value)) - 1);

    return unit*std::round(value/unit);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

scalar meshPlan::peakBytes() const
{
    return
        planTuned.bytes
      + planTuned.bytesPerWallFace*nWallFaces
      + planTuned.bytesPerPrism*nPrisms()
      + planTuned.bytesPerFarCell*farCells
      + planTuned.bytesPerPolygonCell*nPolygonCells();
}


scalar meshPlan::seconds() const
{
    const scalar share = planTuned.parallelShare;

    return
        (1 - share + share/nThreads)
       *(
            planTuned.baseSeconds
          + planTuned.secondsPerWallFace*nWallFaces
          + planTuned.secondsPerFarCell*farCells
          + planTuned.secondsPerPolygonCell*nPolygonCells()
        );
}


meshPlan makeMeshPlan
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const farFieldDomain& domain,
    const label nThreads,
    const stageObserver& observer
)
{
    const shareOfWall start
    (
        makeShare
        (
            wall, controls.layers, {controls.layers.multipleNormalsAngle},
            local, observer, processTeam::alone()
        )
    );

    meshPlan plan;
    plan.nThreads = nThreads;
    plan.nWallPoints = wall.points.size();
    plan.nWallFaces = wall.faces.size();
    plan.nFrontFaces = start.share.front.surface.faces.size();
    plan.nLayers = start.heights.request.nLayers;
    plan.polygons = controls.polygons;
    plan.polyhedra =
        controls.polygons && controls.farField.type == farFieldType::tet;
    if (controls.farField.isWanted())
    {
        const pointField outer
        (
            outerPointsOf(wall, start, controls, observer)
        );
        observer.begin("expectedFarField");
        farFieldControls farField(controls.farField);
        farField.maxCells = max(farField.maxCells, planTuned.maxFarCells);
        plan.farCells = expectedFarCells(wall, outer, domain, farField);
        observer.end("");
    }

    return plan;
}


string describe(const meshPlan& plan, const farFieldControls& controls)
{
    string lines
    (
        text
        (
            "Plan\n    Wall          ", plan.nWallFaces, " faces\n"
            "    Layers        ", plan.nLayers,
            plan.polygons ? ": about " : ": ", label(plan.nLayerCells()),
            " cells\n"
        )
    );
    if (controls.isWanted())
    {
        lines += text
        (
            "    Far field     about ", rounded(plan.nFarCells()), " cells\n"
        );
    }
    lines += text
    (
        "    Memory        about ", rounded(1e-6*plan.peakBytes()),
        " MB at the peak\n    Time          about ", rounded(plan.seconds()),
        " s on ", plan.nThreads, plan.nThreads == 1 ? " thread" : " threads",
        "\n"
    );
    if (plan.farCells > controls.maxCells)
    {
        lines += text
        (
            "More than farField.maxCells ", controls.maxCells,
            ": the run would be refused\n"
        );
    }

    return lines;
}

} // End namespace Foam

// ************************************************************************* //
