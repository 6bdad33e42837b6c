/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceValues.H"
#include "pointOrder.H"
#include "surfaceFile.H"
#include "FlatOutput.H"
#include "IFstream.H"
#include "scalarIOField.H"
#include "labelIOField.H"
#include "vtkUnstructuredReader.H"

#include <map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
            << flatOutput(reader.pointData().sortedToc())
            << ", of cells: " << flatOutput(reader.cellData().sortedToc())
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

} // End namespace Foam

// ************************************************************************* //
