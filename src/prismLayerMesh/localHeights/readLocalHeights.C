/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readLocalHeights.H"
#include "boundBox.H"
#include "expectedYPlus.H"
#include "IFstream.H"
#include "labelIOField.H"
#include "OStringStream.H"
#include "pointOrder.H"
#include "ranges.H"
#include "regionSearch.H"
#include "scalarIOField.H"
#include "surfaceFile.H"
#include "triSurfaceSearch.H"
#include "vtkUnstructuredReader.H"
#include "yPlusHeights.H"

#include <map>

namespace Foam
{

static barycentric2D coordinates
(
    const pointField& points,
    const labelledTri& triangle,
    const point& x
)
{
    // Scaled to a length of 1, because triangle takes small ones for degenerate
    const point& origin = points[triangle[0]];
    const vector a(points[triangle[1]] - origin);
    const vector b(points[triangle[2]] - origin);
    const scalar length = max(max(mag(a), mag(b)), VSMALL);

    return triPointRef(Zero, a/length, b/length)
       .pointToBarycentric((x - origin)/length);
}


scalar interpolate
(
    const surfaceValues& source,
    const pointField& points,
    scalarField& values
)
{
    const triSurface surface(toTriSurface(source.surface));
    const triSurfaceSearch search(surface);

    List<pointIndexHit> hits;
    search.findNearest(points, scalarField(points.size(), GREAT), hits);

    values.setSize(points.size());
    scalar farthest = 0;

    forAll(points, p)
    {
        const labelledTri& f = surface[hits[p].index()];
        const barycentric2D weights
        (
            coordinates(source.surface.points, f, hits[p].hitPoint())
        );

        values[p] = 0;
        for (direction i = 0; i < 3; ++i)
        {
            values[p] += weights[i]*source.values[f[i]];
        }

        farthest = max(farthest, mag(hits[p].hitPoint() - points[p]));
    }

    return farthest;
}


// * * * * * * * * * * * * *  Read Surface Values  * * * * * * * * * * * * * //

//- The smallest value of the faces around each point and around other points at
//  the same place
static scalarField smallestOfFaces
(
    const wallSurface& surface,
    const scalarField& ofFaces
)
{
    std::map<point, scalar, decltype(&isBefore)> smallest(&isBefore);

    forAll(surface.faces, facei)
    {
        for (const point& x : surface.faces[facei].points(surface.points))
        {
            scalar& value = smallest.emplace(x, ofFaces[facei]).first->second;
            value = min(value, ofFaces[facei]);
        }
    }

    scalarField ofPoints(surface.points.size(), 0);
    for (const face& f : surface.faces)
    {
        for (const label p : f)
        {
            ofPoints[p] = smallest.at(surface.points[p]);
        }
    }

    return ofPoints;
}


//- The values of a field that may have been written as integers. Returns
//  whether the registry has it.
static bool findValues
(
    const objectRegistry& fields,
    const word& name,
    scalarField& values
)
{
    if (fields.foundObject<scalarIOField>(name))
    {
        values = fields.lookupObject<scalarIOField>(name);

        return true;
    }

    if (fields.foundObject<labelIOField>(name))
    {
        const labelIOField& labels = fields.lookupObject<labelIOField>(name);
        values.setSize(labels.size());

        forAll(labels, i)
        {
            values[i] = labels[i];
        }

        return true;
    }

    return false;
}


static scalarField readList(const fileName& file)
{
    IFstream is(file);
    token first(is);
    is.putBack(first);

    if (first.isWord() && first.wordToken() == "FoamFile")
    {
        is.read(first);
        const dictionary header(is);
        is.format(header.lookupOrDefault<word>("format", "ascii"));
    }

    return scalarField(is);
}


namespace
{

//- As long as it lives, the reader of VTK files does not print its steps
class quietVtkReading
{
    const int debug_ = vtkUnstructuredReader::debug;

public:

    quietVtkReading()
    {
        vtkUnstructuredReader::debug = 0;
    }

    ~quietVtkReading()
    {
        vtkUnstructuredReader::debug = debug_;
    }
};

} // End anonymous namespace


static void checkFile(const fileName& file)
{
    if (!isFile(file))
    {
        FatalErrorInFunction
            << "Cannot read the values " << file << ": there is no such file"
            << exit(FatalError);
    }
}


//- The reader's message does not say what to do
static void checkAsciiVtk(const fileName& file)
{
    checkFile(file);

    IFstream is(file);
    string line;
    is.getLine(line);
    is.getLine(line);
    is.getLine(line);

    if (line != "ASCII")
    {
        FatalErrorInFunction
            << "Cannot read the values " << file << ": it is not a legacy"
            << " VTK file in ascii; ParaView saves a surface as one"
            << exit(FatalError);
    }
}


surfaceValues readVtkValues
(
    const fileName& file,
    const word& field,
    const Time& time
)
{
    checkAsciiVtk(file);

    const quietVtkReading guard;
    IFstream is(file);
    const vtkUnstructuredReader reader(time, is);

    surfaceValues result;
    result.surface.points = reader.points();
    result.surface.faces = reader.faces();

    if (result.surface.faces.empty())
    {
        FatalErrorInFunction
            << "Cannot read the values " << file << ": it has no triangles,"
            << " quadrilaterals or polygons" << exit(FatalError);
    }

    scalarField ofCells;

    if (findValues(reader.pointData(), field, result.values))
    {
        return result;
    }

    if (!findValues(reader.cellData(), field, ofCells))
    {
        FatalErrorInFunction
            << "Cannot read the values " << file << ": it has no field "
            << field << nl << "Fields of points: "
            << listed(reader.pointData().sortedToc()).c_str()
            << ", of cells: " << listed(reader.cellData().sortedToc()).c_str()
            << exit(FatalError);
    }

    result.values = smallestOfFaces
    (
        result.surface, scalarField(ofCells, reader.faceMap())
    );

    return result;
}


surfaceValues readListValues
(
    const fileName& file,
    const fileName& surfaceFile,
    const scalar scale
)
{
    checkFile(file);

    bool separateFaces = false;
    surfaceValues result;
    result.surface = readSurfaceFile(surfaceFile, separateFaces);
    result.surface.points *= scale;
    result.values = readList(file);

    const label nPoints = result.surface.points.size();
    const label nFaces = result.surface.faces.size();
    const label n = result.values.size();

    if ((n == nPoints) == (n == nFaces) || (n == nPoints && separateFaces))
    {
        FatalErrorInFunction
            << "The list " << file << " has " << n << " values. The surface "
            << surfaceFile << " has " << nPoints << " points and " << nFaces
            << " faces. The list needs a value for each "
            << (separateFaces ? "face" : "point, or for each face; use a VTK"
                " file if the surface has as many faces as points")
            << exit(FatalError);
    }

    if (n == nFaces)
    {
        result.values =
            smallestOfFaces(result.surface, scalarField(result.values));
    }

    return result;
}


// * * * * * * * * * * * * *  Read Local Heights * * * * * * * * * * * * * * //

static void checkHeights
(
    const string& source,
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
                << "The value of " << source << " at the point "
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

    if (distance > maxSurfaceDistance*diagonal)
    {
        FatalErrorInFunction
            << "The surface with values " << field.file << " is " << distance
            << " m away from a point of the wall. Does it belong to another"
            << " body, or has it other units?" << exit(FatalError);
    }

    checkHeights(field.file, wall.points, heights);

    OStringStream os;
    os  << nl << field.file.c_str() << ' ' << field.field << ": "
        << min(heights) << " to " << max(heights)
        << " m, farthest point of the wall " << distance << " m";
    found += os.str();

    return heights;
}


//- Whether the layers of the earlier run say how thick the layers are
static bool needsThickness(const layerControls& layers)
{
    const heightEntries& given = layers.heights;

    return
        given.nSurfaceLayers > 1
     && !(given.thickness > 0) && !(given.finalLayerThickness > 0)
     && !(given.expansionRatio > 0) && !layers.thicknessField.isGiven();
}


//- Sets the heights that the earlier run says
static void setHeightsOfRun
(
    const wallSurface& wall,
    const layerControls& layers,
    const Time& time,
    localHeights& local,
    string& found
)
{
    const yPlusRun& run = layers.fromRun;
    fileName folder(run.folder);
    folder.expand();
    if (!folder.isAbsolute())
    {
        folder = time.globalPath()/folder;
    }
    folder.clean();

    const wallsOfRun walls(readWallsOfRun(run, folder, wall.patchNames));
    const heightsOfRun heights(makeHeightsOfRun(wall, walls, run));
    checkHeights("layers.yPlus", wall.points, heights.first);
    local.firstThickness = heights.first;
    local.yPlusPerHeight = heights.yPlusPerHeight;
    if (needsThickness(layers))
    {
        checkHeights("layers.yPlus", wall.points, heights.thickness);
        local.thickness = heights.thickness;
    }

    OStringStream os;
    os  << nl << "y+ of " << folder << " at time " << walls.time << ": "
        << describeYPlus(walls.surface, walls.yPlus, run.target).c_str()
        << "first heights for y+ " << run.target << ": " << min(heights.first)
        << " to " << max(heights.first) << " m";
    found += os.str();
}


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
    if (layers.fromRun.isGiven())
    {
        setHeightsOfRun(wall, layers, time, local, found);
    }

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
