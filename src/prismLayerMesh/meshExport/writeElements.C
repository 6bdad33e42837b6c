/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeElements.H"
#include "boundBox.H"

#include <limits>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- From here on, the same numbers are read as were written
static void writeAllDigits(std::ostream& os)
{
    os.precision(std::numeric_limits<scalar>::max_digits10);
}


//- Writes labels after a blank each, increased by an offset
static void writeLabels
(
    const UList<label>& labels,
    const label offset,
    std::ostream& os
)
{
    for (const label i : labels)
    {
        os << ' ' << i + offset;
    }
}


static void writePoint
(
    const point& x,
    const label dimension,
    std::ostream& os
)
{
    for (direction i = 0; i < dimension; ++i)
    {
        os << (i ? " " : "") << x[i];
    }
}


//- Writes version and names. The number of a group is its position among all
//  patches and then zones, from 1 on.
static void startMsh
(
    const elementMesh& mesh,
    const char* version,
    std::ostream& os
)
{
    writeAllDigits(os);
    os  << "$MeshFormat\n" << version << " 0 8\n$EndMeshFormat\n"
        << "$PhysicalNames\n" << mesh.patches.size() + mesh.zones.size()
        << '\n';

    label tag = 0;
    for (const elementGroup& patch : mesh.patches)
    {
        os  << mesh.dimension - 1 << ' ' << ++tag << " \"" << patch.name
            << "\"\n";
    }
    for (const elementGroup& zone : mesh.zones)
    {
        os  << mesh.dimension << ' ' << ++tag << " \"" << zone.name << "\"\n";
    }
    os  << "$EndPhysicalNames\n";
}


//- Writes the bounds and the number of each group, as entities
static void writeEntities
(
    const UList<elementGroup>& groups,
    const elementList& elements,
    const pointField& points,
    label tag,
    std::ostream& os
)
{
    for (const elementGroup& group : groups)
    {
        boundBox box(boundBox::invertedBox);
        for (label i = group.start; i < group.start + group.size; ++i)
        {
            box.add(points, elements.points(i));
        }
        os  << ++tag << ' ';
        writePoint(box.min(), 3, os);
        os  << ' ';
        writePoint(box.max(), 3, os);
        os  << " 1 " << tag << " 0\n";
    }
}


//- Number of the shapes that the elements of a group have, and of each shape
//  the number of the elements
static labelList countShapes
(
    const elementGroup& group,
    const elementList& elements
)
{
    labelList n(nElementShapes, Zero);
    for (label i = group.start; i < group.start + group.size; ++i)
    {
        ++n[int(elements.shape(i))];
    }

    return n;
}


static label countBlocks
(
    const UList<elementGroup>& groups,
    const elementList& elements
)
{
    label nBlocks = 0;
    for (const elementGroup& group : groups)
    {
        for (const label n : countShapes(group, elements))
        {
            nBlocks += n > 0;
        }
    }

    return nBlocks;
}


//- Writes the elements of groups in blocks of one shape
static void writeBlocks
(
    const UList<elementGroup>& groups,
    const elementList& elements,
    const label dimension,
    label group0,
    label& nWritten,
    std::ostream& os
)
{
    for (const elementGroup& group : groups)
    {
        const labelList n(countShapes(group, elements));
        ++group0;
        forAll(n, s)
        {
            if (n[s] == 0)
            {
                continue;
            }
            os  << dimension << ' ' << group0 << ' '
                << factsOf(elementShape(s)).gmsh << ' ' << n[s] << '\n';

            for (label i = group.start; i < group.start + group.size; ++i)
            {
                if (elements.shape(i) == elementShape(s))
                {
                    os << ++nWritten;
                    writeLabels(elements.points(i), 1, os);
                    os << '\n';
                }
            }
        }
    }
}


//- Writes the elements of groups in the format 2.2
static void writeElements2
(
    const UList<elementGroup>& groups,
    const elementList& elements,
    label tag,
    label& nWritten,
    std::ostream& os
)
{
    for (const elementGroup& group : groups)
    {
        ++tag;
        for (label i = group.start; i < group.start + group.size; ++i)
        {
            os  << ++nWritten << ' ' << factsOf(elements.shape(i)).gmsh
                << " 2 " << tag << ' ' << tag;
            writeLabels(elements.points(i), 1, os);
            os << '\n';
        }
    }
}


static void writeSu2Element
(
    const elementShape shape,
    const UList<label>& points,
    std::ostream& os
)
{
    os << factsOf(shape).vtk;
    writeLabels(vtkPoints(shape, points), 0, os);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList vtkPoints(const elementShape shape, const UList<label>& points)
{
    labelList ordered(points);
    if (shape == elementShape::prism)
    {
        Swap(ordered[1], ordered[2]);
        Swap(ordered[4], ordered[5]);
    }

    return ordered;
}


void writeSu2(const elementMesh& mesh, std::ostream& os)
{
    writeAllDigits(os);
    os  << "NDIME= " << mesh.dimension << "\nNELEM= " << mesh.cells.size()
        << '\n';
    for (label i = 0; i < mesh.cells.size(); ++i)
    {
        writeSu2Element(mesh.cells.shape(i), mesh.cells.points(i), os);
        os  << ' ' << i << '\n';
    }

    os  << "NPOIN= " << mesh.points.size() << '\n';
    forAll(mesh.points, p)
    {
        writePoint(mesh.points[p], mesh.dimension, os);
        os  << ' ' << p << '\n';
    }

    os  << "NMARK= " << mesh.patches.size() << '\n';
    for (const elementGroup& patch : mesh.patches)
    {
        os  << "MARKER_TAG= " << patch.name << "\nMARKER_ELEMS= "
            << patch.size << '\n';
        for (label i = patch.start; i < patch.start + patch.size; ++i)
        {
            writeSu2Element(mesh.faces.shape(i), mesh.faces.points(i), os);
            os  << '\n';
        }
    }
}


void writeMsh4(const elementMesh& mesh, std::ostream& os)
{
    startMsh(mesh, "4.1", os);
    const label nPoints = mesh.points.size();
    const label nPatches = mesh.patches.size();
    const label nElements = mesh.faces.size() + mesh.cells.size();

    os  << "$Entities\n0";
    for (label dimension = 1; dimension <= 3; ++dimension)
    {
        os  << ' '
            << (
                dimension == mesh.dimension ? mesh.zones.size()
              : dimension == mesh.dimension - 1 ? nPatches : 0
            );
    }
    os  << '\n';
    writeEntities(mesh.patches, mesh.faces, mesh.points, 0, os);
    writeEntities(mesh.zones, mesh.cells, mesh.points, nPatches, os);

    // All points belong to the first zone
    os  << "$EndEntities\n$Nodes\n1 " << nPoints << " 1 " << nPoints << '\n'
        << mesh.dimension << ' ' << nPatches + 1 << " 0 " << nPoints << '\n';
    forAll(mesh.points, p)
    {
        os  << p + 1 << '\n';
    }
    for (const point& x : mesh.points)
    {
        writePoint(x, 3, os);
        os  << '\n';
    }

    os  << "$EndNodes\n$Elements\n"
        << countBlocks(mesh.patches, mesh.faces)
         + countBlocks(mesh.zones, mesh.cells)
        << ' ' << nElements << " 1 " << nElements << '\n';
    label n = 0;
    writeBlocks(mesh.patches, mesh.faces, mesh.dimension - 1, 0, n, os);
    writeBlocks(mesh.zones, mesh.cells, mesh.dimension, nPatches, n, os);
    os  << "$EndElements\n";
}


void writeMsh2(const elementMesh& mesh, std::ostream& os)
{
    startMsh(mesh, "2.2", os);
    os  << "$Nodes\n" << mesh.points.size() << '\n';
    forAll(mesh.points, p)
    {
        os  << p + 1 << ' ';
        writePoint(mesh.points[p], 3, os);
        os  << '\n';
    }

    os  << "$EndNodes\n$Elements\n" << mesh.faces.size() + mesh.cells.size()
        << '\n';
    label n = 0;
    writeElements2(mesh.patches, mesh.faces, 0, n, os);
    writeElements2(mesh.zones, mesh.cells, mesh.patches.size(), n, os);
    os  << "$EndElements\n";
}

} // End namespace Foam

// ************************************************************************* //
