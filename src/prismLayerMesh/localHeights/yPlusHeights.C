/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "yPlusHeights.H"
#include "boundBox.H"
#include "expectedYPlus.H"
#include "readLocalHeights.H"

namespace Foam
{

//- The area around each point of a surface: a share of each face
static scalarField pointAreas(const wallSurface& surface)
{
    scalarField areas(surface.points.size(), 0);
    for (const face& f : surface.faces)
    {
        const scalar share = f.mag(surface.points)/f.size();

        for (const label p : f)
        {
            areas[p] += share;
        }
    }

    return areas;
}


//- The mean at each point, by area, of the values of faces around it
static scalarField meansAtPoints
(
    const wallSurface& surface,
    const scalarField& ofFaces
)
{
    scalarField sums(surface.points.size(), 0);
    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const scalar share = f.mag(surface.points)/f.size();

        for (const label p : f)
        {
            sums[p] += share*ofFaces[facei];
        }
    }

    return sums/max(pointAreas(surface), VSMALL);
}


//- Whether each point is on a patch that the run has
static boolList onPatchesOf(const wallsOfRun& walls, const wallSurface& wall)
{
    boolList isOn(wall.points.size(), false);
    forAll(wall.faces, facei)
    {
        const word& name = wall.patchNames[wall.patchIDs[facei]];

        if (walls.surface.patchNames.found(name))
        {
            for (const label p : wall.faces[facei])
            {
                isOn[p] = true;
            }
        }
    }

    return isOn;
}


//- Raises values to the percentile of those at known points
static void raiseToFloor
(
    const boolList& isKnown,
    const scalarField& areas,
    const scalar percent,
    scalarField& values
)
{
    scalarField weights(areas);
    forAll(weights, p)
    {
        weights[p] = isKnown[p] ? weights[p] : 0;
    }

    values = max(values, weightedPercentile(values, weights, percent));
}


//- Replaces values by geometric means of points and their neighbours
static void smooth
(
    const wallAddressing& addressing,
    const label nSmooth,
    scalarField& values
)
{
    scalarField logs(log(values));

    for (label sweep = 0; sweep < nSmooth; ++sweep)
    {
        const scalarField before(logs);

        forAll(logs, p)
        {
            const labelList& neighbours = addressing.pointPoints[p];
            scalar sum = 0;
            for (const label other : neighbours)
            {
                sum += before[other];
            }
            logs[p] = neighbours.size()
              ? 0.5*(before[p] + sum/neighbours.size()) : before[p];
        }
    }

    values = exp(logs);
}


//- Errors: as makeHeightsOfRun
static void checkDistances
(
    const surfaceValues& source,
    const wallSurface& wall,
    const boolList& isKnown,
    const yPlusRun& run
)
{
    const pointField known(wall.points, findIndices(isKnown, true));
    scalarField unused;
    const scalar distance = interpolate(source, known, unused);
    const scalar allowed =
        maxSurfaceDistance*boundBox(wall.points, false).mag();

    if (distance > allowed)
    {
        FatalErrorInFunction
            << "The walls of the case " << run.folder << " of"
            << " layers.yPlus.from are " << distance << " m away from a point"
            << " of the wall; at most " << allowed << " m are allowed. Does the"
            << " case have another body, or other units?" << exit(FatalError);
    }
}


heightsOfRun makeHeightsOfRun
(
    const wallSurface& wall,
    const wallsOfRun& walls,
    const yPlusRun& run,
    const yPlusHeightControls& controls
)
{
    const boolList isKnown(onPatchesOf(walls, wall));
    surfaceValues source{walls.surface, scalarField()};
    source.values =
        meansAtPoints(source.surface, walls.yPlus/walls.firstHeight);
    checkDistances(source, wall, isKnown, run);

    heightsOfRun heights;
    interpolate(source, wall.points, heights.yPlusPerHeight);
    scalarField even(heights.yPlusPerHeight);
    raiseToFloor(isKnown, pointAreas(wall), controls.floorPercent, even);
    smooth(makeWallAddressing(wall), controls.nSmooth, even);
    heights.first = run.target/even;

    source.values = meansAtPoints(source.surface, walls.thickness);
    interpolate(source, wall.points, heights.thickness);

    forAll(isKnown, p)
    {
        heights.yPlusPerHeight[p] *= isKnown[p] ? 1 : 0;
    }

    return heights;
}

} // End namespace Foam

// ************************************************************************* //
