/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionStages.H"
#include "boundBox.H"
#include "layerStages.H"
#include "OStringStream.H"
#include "readWallSurface.H"
#include "splitAtSidePatches.H"
#include "stringListOps.H"
#include "surfaceMeasures.H"
#include "surfacePart.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Puts points that are nearly in the sides of a box into them. Returns their
//  number.
static label putOnSides(const boundBox& box, pointField& points)
{
    const scalar tolerance = regionTolerance*boundBox(points, false).mag();
    label nMoved = 0;
    for (point& x : points)
    {
        bool isMoved = false;
        for (direction d = 0; d < 3; ++d)
        {
            for (const scalar side : {box.min()[d], box.max()[d]})
            {
                const scalar distance = mag(x[d] - side);
                if (distance > 0 && distance < tolerance)
                {
                    x[d] = side;
                    isMoved = true;
                }
            }
        }
        nMoved += isMoved;
    }

    return nMoved;
}


//- Gives each side of a box two triangles
static void useLargeTriangles(const boundBox& box, farBoundary& sides)
{
    wallSurface& surface = sides.surface;
    surface.points = box.points();
    surface.faces.clear();
    surface.patchIDs.clear();
    forAll(boundBox::faces, side)
    {
        // Normals point into the box
        const face f(boundBox::faces[side].reverseFace());
        surface.faces.append(face({f[0], f[1], f[2]}));
        surface.faces.append(face({f[0], f[2], f[3]}));
        surface.patchIDs.append(labelList(2, sides.boxPatches[side]));
    }
}


static farBoundary makeSides
(
    const caseSources& sources,
    const farBoundaryControls& boundary
)
{
    farBoundary sides(makeFarBoundary(boundary, sources.surfaceFile));
    if (boundary.type == farBoundaryType::box)
    {
        useLargeTriangles(boundary.box, sides);
    }

    return sides;
}


//- Reads the surface of all regions, with the far boundary
static wallSurface readSurface
(
    const UList<fileName>& files,
    const regionsControls& controls,
    const stageObserver& observer
)
{
    observer.begin("wallSurface");
    wallReading reading;
    wallSurface surface
    (
        readWallSurface(fileNameList(files), controls.surface, reading)
    );
    const string sizes(sizesOf(surface));
    label nMoved = 0;
    if (controls.boundary.type != farBoundaryType::none)
    {
        if (controls.boundary.type == farBoundaryType::box)
        {
            nMoved = putOnSides(controls.boundary.box, surface.points);
        }

        // Where a face is in a side, it is of the side
        wallSurface all(controls.sides.surface);
        appendSurface(surface, labelList(), all);
        surface = all;
    }
    observer.end
    (
        sizes
      + (nMoved ? ", " + name(nMoved) + " points put on sides" : string())
    );

    return surface;
}


//- Refuses entries of layers.patches and of surface.baffles that match no patch
static void requirePatches
(
    const regionsControls& controls,
    const wallSurface& surface
)
{
    for (const regionControls& region : controls.regions)
    {
        requirePatches(region.controls.layers, surface.patchNames);
    }
    for (const wordRe& baffle : controls.baffles)
    {
        if (findMatchingStrings(baffle, surface.patchNames).empty())
        {
            FatalErrorInFunction
                << "The entry " << baffle << " of surface.baffles matches no"
                << " patch of the surface" << nl << "Its patches: "
                << flatOutput(surface.patchNames) << exit(FatalError);
        }
    }
}


//- Says which parts of the files are beside no region.
//  sides: patches of the far boundary
static void describeUnused
(
    const spaceRegions& all,
    const wordList& sides,
    Ostream& os
)
{
    const List<unusedArea> areas(unusedAreas(all));
    forAll(areas, patchi)
    {
        const unusedArea& area = areas[patchi];
        const word& patch = all.surface.patchNames[patchi];
        if (area.unused > 0 && !sides.found(patch))
        {
            os  << nl << 100*area.unused/area.whole << " % of the patch "
                << patch << " is beside no region, first at " << area.place;
        }
    }
}


//- Says what the regions are
static string describe
(
    const spaceRegions& all,
    const regionsControls& controls
)
{
    OStringStream os;
    os  << all.surface.faces.size() << " faces";
    forAll(all.regions, r)
    {
        const spaceRegion& region = all.regions[r];
        os  << nl << region.name.c_str()
            << (controls.regions[r].hasLayers ? "" : ", without layers")
            << ": " << region.surface.faces.size() << " faces, volume "
            << region.volume << " m3";
    }
    describeUnused(all, controls.sides.surface.patchNames, os);

    return os.str();
}


//- Whether triangles are all of the far boundary
static bool isWhole(const wallSurface& far, const farBoundary& whole)
{
    static constexpr scalar rounding = 1e-9;
    const scalar area = measuresOf(whole.surface).area;

    return mag(measuresOf(far).area - area) < rounding*area;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

regionsControls readRegions(const dictionary& dict, const caseSources& sources)
{
    return readRegionControls
    (
        dict,
        [&](const farBoundaryControls& boundary)
        {
            return makeSides(sources, boundary);
        }
    );
}


spaceRegions makeRegions
(
    const UList<fileName>& files,
    const regionsControls& controls,
    const stageObserver& observer
)
{
    const wallSurface surface(readSurface(files, controls, observer));
    requirePatches(controls, surface);

    observer.begin("spaceRegions");
    List<regionSeed> seeds;
    for (const regionControls& region : controls.regions)
    {
        seeds.append(region.seed);
    }
    const scalar tolerance =
        max(regionTolerance, controls.surface.mergeTolerance);
    spaceRegions all
    (
        makeSpaceRegions
        (
            makeArrangement(surface, tolerance), seeds, controls.baffles,
            tolerance
        )
    );
    forAll(all.regions, r)
    {
        const regionControls& asked = controls.regions[r];
        all.open
        (
            r,
            [&](const word& patch)
            {
                return asked.controls.layers.isSide(patch);
            },
            asked.hasLayers ? layerOpening : tetOpening
        );
    }
    observer.end(describe(all, controls));

    return all;
}


farFieldDomain readDomain
(
    const caseSources& sources,
    const regionWall& walls,
    const regionsControls& all,
    prismLayerControls& controls,
    const stageObserver& observer
)
{
    farBoundaryControls& boundary = controls.farField.boundary;
    const bool isAlone = walls.far.faces.empty();
    const bool isAround = !isAlone && isWhole(walls.far, all.sides);
    if (isAround)
    {
        boundary = all.boundary;
    }
    const bool isOwn = !isAlone && !isAround;
    if (isOwn)
    {
        boundary.type = farBoundaryType::surface;
    }

    return readDomain
    (
        sources, walls.wall, isOwn ? walls.far : wallSurface(), !isAlone,
        controls.farField, observer
    );
}

} // End namespace Foam

// ************************************************************************* //
