/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementMesh.H"
#include "cellDivision.H"
#include "labelPair.H"
#include "planeElements.H"
#include "polyMesh.H"
#include "polyMeshParts.H"
#include "processorPolyPatch.H"

#include <map>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns the cells that are in the same zones, and at last the cells that are
//  in none
static List<cellZoneParts> cellsOfZones(const polyMesh& mesh)
{
    const cellZoneMesh& zones = mesh.cellZones();
    DynamicList<word> names;
    names.append("cells");

    // The group that a cell of some group joins by being in a zone, too
    std::map<labelPair, label> joined;
    labelList groupOf(mesh.nCells(), Zero);

    forAll(zones, zonei)
    {
        for (const label celli : zones[zonei])
        {
            label& group = groupOf[celli];
            const auto found =
                joined.emplace(labelPair(group, zonei), names.size());
            if (found.second)
            {
                const word before(group ? names[group] + '+' : word());
                names.append(before + zones[zonei].name());
            }
            group = found.first->second;
        }
    }
    const labelListList cells(invertOneToMany(names.size(), groupOf));
    List<cellZoneParts> parts(names.size());
    forAll(parts, i)
    {
        parts[i == 0 ? names.size() - 1 : i - 1] =
            cellZoneParts(names[i], cells[i]);
    }

    return parts;
}


static void checkPatches(const polyMesh& mesh)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<processorPolyPatch>(patch))
        {
            FatalErrorInFunction
                << "The patch " << patch.name() << " is of type "
                << patch.type() << ": reconstructParMesh makes one mesh of the"
                << " pieces" << exit(FatalError);
        }
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

void elementList::append(const elementShape shape, const UList<label>& points)
{
    shapes_.append(shape);
    starts_.append(points_.size());
    points_.append(points);
}


void elementList::endGroup
(
    const word& name,
    DynamicList<elementGroup>& groups
) const
{
    const label start =
        groups.empty() ? 0 : groups.last().start + groups.last().size;

    if (size() > start)
    {
        groups.append({name, start, size() - start});
    }
}


label elementMesh::count(const elementShape shape) const
{
    label n = 0;
    for (label i = 0; i < cells.size(); ++i)
    {
        n += cells.shape(i) == shape;
    }

    return n;
}


scalar elementMesh::volume(const label i) const
{
    const face labels(cells.points(i));

    if (labels.size() < 4 || dimension == 2)
    {
        return mag(labels.areaNormal(points));
    }
    scalar sum = 0;
    for (const face& f : facesOf(cells.shape(i)))
    {
        const face g(renumber(labels, f));
        sum += g.areaNormal(points)
            & (average(pointField(points, g)) - points[labels[0]]);
    }

    return sum/3;
}


scalar elementMesh::volume(const elementGroup& zone) const
{
    scalar sum = 0;
    for (label i = zone.start; i < zone.start + zone.size; ++i)
    {
        sum += volume(i);
    }

    return sum;
}


scalar elementMesh::area(const elementGroup& patch) const
{
    scalar sum = 0;
    for (label i = patch.start; i < patch.start + patch.size; ++i)
    {
        const face f(faces.points(i));
        sum += dimension == 2
          ? mag(points[f[1]] - points[f[0]]) : mag(f.areaNormal(points));
    }

    return sum;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

elementMesh elementsOf(const polyMesh& mesh)
{
    checkPatches(mesh);
    const List<cellZoneParts> zones(cellsOfZones(mesh));

    if (isPlane(mesh))
    {
        return planeElementsOf(mesh, zones);
    }
    const polyhedralMesh given
    (
        mesh.points(), mesh.faces(), mesh.faceOwner(), mesh.faceNeighbour()
    );
    const cellDivision division(given);

    elementMesh elements;
    elements.points = mesh.points();
    elements.points.append(division.apices());
    elements.nDivided = division.nDivided();

    for (const cellZoneParts& zone : zones)
    {
        for (const label celli : zone.cells)
        {
            division.appendCell(celli, mesh.nPoints(), elements.cells);
        }
        elements.cells.endGroup(zone.name, elements.zones);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; i < patch.size(); ++i)
        {
            division.appendFace(patch.start() + i, elements.faces);
        }
        elements.faces.endGroup(patch.name(), elements.patches);
    }

    return elements;
}

} // End namespace Foam

// ************************************************************************* //
