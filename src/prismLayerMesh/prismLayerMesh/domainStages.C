/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainStages.H"
#include "boxSides.H"
#include "cellSizes.H"
#include "OStringStream.H"
#include "planarColumns.H"
#include "prismPolyMesh.H"
#include "readLocalHeights.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Errors: FatalError if the wall has a patch of the far boundary
static void requireNotOf(const wallSurface& wall, const word& farPatch)
{
    if (prismPatchNames(wall.patchNames).found(farPatch))
    {
        FatalErrorInFunction
            << "The far boundary and the wall both have a patch " << farPatch
            << ". Rename one of them, by farField.boundary.patches or by"
            << " surface.patches" << exit(FatalError);
    }
}


//- Cells of a hexCore are at most so many times as wide as two parallel sides
//  are apart
static constexpr scalar widthShare = 2;

//- A domain is thin if two parallel sides are nearer to each other than this
//  share of its diagonal
static constexpr scalar thinShare = 0.05;


//- Bounds the sizes by the least distance of two parallel sides. Returns what
//  the log says of a thin domain. Tetrahedra are not bounded: TetGen takes
//  minutes for two planes of small triangles that are near to each other.
static string boundByWidth
(
    const wallSurface& wall,
    const farFieldControls& controls,
    sizeBounds& bounds
)
{
    if (emptySides(wall.border).first() >= 0)
    {
        return "";
    }

    const scalar width = leastWidth(controls.boundary, wall.border.sides);
    const bool isHexCore = controls.type == farFieldType::hexCore;
    if (isHexCore)
    {
        bounds.largest = min(bounds.largest, widthShare*width);
    }
    if
    (
        controls.boundary.type != farBoundaryType::box
     || width > thinShare*controls.boundary.box.mag()
    )
    {
        return "";
    }

    OStringStream os;
    os  << nl << "parallel sides are only " << width << " m apart: "
        << (
               isHexCore
             ? "cells are at most twice as wide"
             : "tetrahedra are flat between them, farField.type hexCore is"
               " better there"
           );

    return os.str();
}


//- The type and the patches of a far boundary
static string textOf(const farBoundaryType type, const wordList& patches)
{
    string names;
    if (type != farBoundaryType::none)
    {
        names = farBoundaryTypes[int(type)];
    }
    for (const word& patch : patches)
    {
        names += ' ' + patch;
    }

    return names;
}


//- The far boundary of the surface files if there is one, otherwise the far
//  boundary that the controls ask for
static farBoundary readBoundary
(
    const caseSources& sources,
    const wallSurface& far,
    const farBoundaryControls& controls
)
{
    return
        far.faces.size()
      ? makeFarBoundary(far)
      : makeFarBoundary
        (
            controls,
            sources.surfaceFile
        );
}


//- Returns the largest edges that cells of the far field may have at points.
//  Errors: FatalError if no far field is made whose cells are known before
static scalarField largestCellsAt
(
    const pointField& points,
    const farFieldControls& controls,
    const Time& time
)
{
    if (!controls.isWanted() || controls.type == farFieldType::mesh)
    {
        FatalErrorInFunction
            << "With layers.relativeTo cells, farField.type must be tet or"
            << " hexCore: heights are in units of the cells that are made"
            << exit(FatalError);
    }

    const sizeBounds bounds(makeSizeBounds(controls, time));
    scalarField sizes(points.size(), bounds.largest);
    if (bounds.atPoints)
    {
        sizes = min(sizes, bounds.atPoints(points));
    }

    return sizes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

farFieldDomain readDomain
(
    const caseSources& sources,
    const wallSurface& wall,
    const wallSurface& far,
    const bool fluidOutside,
    const farFieldControls& controls,
    const stageObserver& observer
)
{
    farFieldDomain domain;

    if (!controls.isWanted())
    {
        return domain;
    }

    if
    (
        !fluidOutside && controls.boundary.type != farBoundaryType::none
     && wall.border.sides.empty() && far.faces.empty()
    )
    {
        FatalErrorInFunction
            << "The fluid is inside of the wall: remove farField.boundary, or"
            << " write surface { fluid outside; }" << exit(FatalError);
    }

    domain.bounds = makeSizeBounds(controls, sources.time);
    const auto cyclic(cyclicSides(controls.boundary, wall.border.sides));

    if (controls.type == farFieldType::mesh)
    {
        observer.begin("readMesh");
        domain.core = sources.core(controls.region);
        observer.end(name(domain.core.nCells) + " cells");
        domain.boundary.cyclicSides = cyclic;
        return domain;
    }

    observer.begin("farBoundary");
    domain.boundary = readBoundary(sources, far, controls.boundary);
    domain.boundary.cyclicSides = cyclic;

    for (const word& patch : domain.boundary.surface.patchNames)
    {
        requireNotOf(wall, patch);
    }
    observer.end
    (
        textOf(controls.boundary.type, domain.boundary.surface.patchNames)
      + boundByWidth(wall, controls, domain.bounds)
    );

    return domain;
}


localHeights readLocal
(
    const caseSources& sources,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    observer.begin("localHeights");
    string found;
    localHeights local
    (
        readLocalHeights
        (
            wall, controls,
            sources.surfaceFile,
            sources.time, found
        )
    );
    if (controls.layers.relativeToCells)
    {
        local.largestCells =
            largestCellsAt(wall.points, controls.farField, sources.time);
        found += "\nrelative heights are in units of the far field's cells";
    }
    observer.end(found);

    return local;
}

} // End namespace Foam

// ************************************************************************* //
