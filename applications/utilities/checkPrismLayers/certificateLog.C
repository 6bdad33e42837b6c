/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "certificateLog.H"
#include "IOmanip.H"
#include "ranges.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Number of faults that are named
static const label nExamples = 10;


//- The name of a row, as wide as those of the other rows
static std::string padded(const std::string& name)
{
    const size_t width = 20;
    const size_t used = min(name.size(), width - 1);

    return name + std::string(width - used, ' ');
}


static void writeRest(const label n)
{
    if (n > nExamples)
    {
        Info<< "    and " << n - nExamples << " more" << nl;
    }
}


static word nameOfPatch(const polyMesh& mesh, const label facei)
{
    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    return patchi < 0 ? word("internal") : mesh.boundaryMesh()[patchi].name();
}


//- Write a row for faces of walls, with the share of their area that has as
//  many layers as are asked for on the face, or as the face with most layers if
//  0 are. Returns whether all faces have as many.
static bool writeRow
(
    const string& name,
    const polyMesh& mesh,
    const labelUList& faces,
    const labelUList& layers,
    const labelUList& asked
)
{
    const label most = faces.empty() ? 0 : max(layers);
    const bool same = faces.size() && min(asked) == max(asked);
    label nIncomplete = 0;
    scalar area = 0;
    scalar incomplete = 0;

    forAll(faces, i)
    {
        const scalar a =
            mag(mesh.faces()[faces[i]].areaNormal(mesh.points()));
        const bool lacks = layers[i] < (asked[i] ? asked[i] : most);

        area += a;
        incomplete += lacks ? a : 0;
        nIncomplete += lacks;
    }

    Info<< "    " << padded(name).c_str() << setw(10) << faces.size()
        << setw(8) << (same && asked[0] ? Foam::name(asked[0]) : word("-"))
        << setw(8) << (faces.empty() ? 0 : min(layers)) << setw(8) << most
        << setw(12)
        << (nIncomplete && area > 0 ? 100*(1 - incomplete/area) : 100)
        << nl;

    return !nIncomplete;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::writeCells
(
    const meshCertificate& certificate,
    const polyhedralMesh& mesh
)
{
    Info<< nl << "Cells                        number  not positive" << nl;

    for (label i = 0; i < nMeshCellShapes; ++i)
    {
        if (certificate.nCells[i])
        {
            Info<< "    " << padded(meshCellShapeName(meshCellShape(i))).c_str()
                << setw(11) << certificate.nCells[i]
                << setw(14) << certificate.nInvalid[i] << nl;
        }
    }

    const labelList& cells = certificate.invalidCells;

    for (label i = 0; i < min(cells.size(), nExamples); ++i)
    {
        Info<< "    not positive: cell " << cells[i] << ", "
            << meshCellShapeName(certificate.invalidShapes[i]).c_str()
            << ", at " << mesh.centre(cells[i]) << nl;
    }

    writeRest(cells.size());
}


void Foam::writeIntersections
(
    const meshCertificate& certificate,
    const polyMesh& mesh,
    const labelUList& outer
)
{
    Info<< nl << "Wall and outer surface" << nl;

    if (outer.empty())
    {
        Info<< "    no outer patch: not tested for intersections" << nl;
        return;
    }

    const List<labelPair>& pairs = certificate.intersections;
    Info<< "    intersecting pairs of faces: " << pairs.size() << nl;

    for (label i = 0; i < min(pairs.size(), nExamples); ++i)
    {
        const label a = pairs[i].first();
        const label b = pairs[i].second();

        Info<< "    intersecting: face " << a << " of "
            << nameOfPatch(mesh, a).c_str() << " and face " << b << " of "
            << nameOfPatch(mesh, b).c_str() << ", at "
            << mesh.faces()[a].average(mesh.points(), mesh.points())
            << nl;
    }

    writeRest(pairs.size());
}


void Foam::writeWhole
(
    const meshCertificate& certificate,
    const polyMesh& mesh
)
{
    const List<labelPair>& pairs = certificate.doubleFaces;
    Info<< nl << "Mesh" << nl
        << "    pairs of faces with the same points: " << pairs.size() << nl;

    for (label i = 0; i < min(pairs.size(), nExamples); ++i)
    {
        Info<< "    the same points: faces " << pairs[i].first() << " and "
            << pairs[i].second() << ", at "
            << mesh.faces()[pairs[i].first()].centre(mesh.points()) << nl;
    }

    writeRest(pairs.size());
    Info<< "    volume of the cells: " << certificate.cellVolume
        << ", inside of the boundary: " << certificate.boundaryVolume << nl;
}


bool Foam::writeLayers
(
    const meshCertificate& certificate,
    const polyMesh& mesh,
    const labelUList& walls,
    const labelUList& asked
)
{
    Info<< nl << "Layers                       faces   asked     min     max"
        << "  area [%] with "
        << (anyOf(asked, [](const label n) { return n > 0; }) ? "asked" : "max")
        << nl;

    bool complete = true;
    DynamicList<label> allFaces;
    DynamicList<label> allAsked;

    forAll(walls, i)
    {
        const polyPatch& patch = mesh.boundaryMesh()[walls[i]];
        const labelList faces(identity(patch.size(), patch.start()));
        const labelList askedOfFaces(patch.size(), asked[i]);
        const SubList<label> layers
        (
            certificate.nLayers, patch.size(), allFaces.size()
        );

        const bool hasAll =
            writeRow(patch.name(), mesh, faces, layers, askedOfFaces);
        complete = complete && (hasAll || !asked[i]);
        allFaces.append(faces);
        allAsked.append(askedOfFaces);
    }

    writeRow("all walls", mesh, allFaces, certificate.nLayers, allAsked);

    return complete;
}


// ************************************************************************* //
