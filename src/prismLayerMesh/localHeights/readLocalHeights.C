/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLocalHeights.H"
#include "regionSearch.H"
#include "surfaceValues.H"
#include "boundBox.H"
#include "OStringStream.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Largest distance of a point of the wall from the surface with values, over
//  the diagonal of the wall's bounding box
static const scalar maxDistance = 0.01;


static void checkHeights
(
    const heightField& field,
    const pointField& points,
    const scalarField& heights
)
{
    forAll(heights, p)
    {
        // Written so that a value that is not a number fails
        if
        (
           !(
                heights[p] >= heightSeries::minThickness
             && heights[p] <= heightSeries::maxThickness
            )
        )
        {
            FatalErrorInFunction
                << "The value of " << field.file << " at the point "
                << points[p] << " of the wall is " << heights[p]
                << "; it must be from " << heightSeries::minThickness << " to "
                << heightSeries::maxThickness << exit(FatalError);
        }
    }
}


static scalarField readHeights
(
    const heightField& field,
    const wallSurface& wall,
    const wallSurfaceControls& surface,
    const std::function<fileName(const fileName&)>& file,
    const Time& time,
    string& found
)
{
    scalarField heights;

    if (!field.isGiven())
    {
        return heights;
    }

    if (field.field.empty() && surface.files.size() > 1)
    {
        FatalErrorInFunction
            << field.file << " has values for one surface file, but the wall"
            << " has " << surface.files.size() << " files: give the values in"
            << " a VTK file" << exit(FatalError);
    }

    const surfaceValues source
    (
        field.field.size()
      ? readVtkValues(file(field.file), field.field, time)
      : readListValues(file(field.file), file(surface.files[0]), surface.scale)
    );
    const scalar distance = interpolate(source, wall.points, heights);
    const scalar diagonal = boundBox(wall.points, false).mag();

    if (distance > maxDistance*diagonal)
    {
        FatalErrorInFunction
            << "The surface with values " << field.file << " is " << distance
            << " m away from a point of the wall. Does it belong to another"
            << " body, or has it other units?" << exit(FatalError);
    }

    checkHeights(field, wall.points, heights);

    OStringStream os;
    os  << nl << field.file.c_str() << ' ' << field.field << ": "
        << min(heights) << " to " << max(heights)
        << " m, farthest point of the wall " << distance << " m";
    found += os.str();

    return heights;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

localHeights readLocalHeights
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const std::function<fileName(const fileName&)>& file,
    const Time& time,
    string& found
)
{
    const layerControls& layers = controls.layers;
    localHeights local;
    found = name(layers.regions.size()) + " regions, "
      + name
        (
            label(layers.firstLayerField.isGiven())
          + label(layers.thicknessField.isGiven())
        )
      + " fields";

    local.firstThickness = readHeights
    (
        layers.firstLayerField, wall, controls.surface, file, time, found
    );
    local.thickness = readHeights
    (
        layers.thicknessField, wall, controls.surface, file, time, found
    );

    for (const layerRegion& region : layers.regions)
    {
        local.inRegion.append(regionSearch(region, time).contains(wall.points));

        found += "\nregion " + region.name + ": "
          + name(findIndices(local.inRegion.last(), true).size())
          + " points of the wall";
    }

    return local;
}

} // End namespace Foam

// ************************************************************************* //
