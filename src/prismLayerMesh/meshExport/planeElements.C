/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeElements.H"
#include "cellPredicates.H"
#include "emptyPolyPatch.H"
#include "planeOutlines.H"
#include "polyMesh.H"
#include "polyMeshParts.H"
#include "ranges.H"
#include "SubField.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The front of a mesh: its faces on patches of type empty that are
//  counter-clockwise in the plane
struct meshFront
{
    //- The face of each cell, and the points of the plane
    faceList faces;
    DynamicList<point> points;

    //- The label in the plane of each point of the mesh, or -1
    labelList newLabels;

    explicit meshFront(const polyMesh& mesh);
};

} // End anonymous namespace


//- The axis to which the normals of the faces on patches of type empty are
//  nearest
static direction emptyAxis(const polyMesh& mesh)
{
    vector sum(Zero);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (const vector& area : patch.faceAreas())
        {
            sum += isA<emptyPolyPatch>(patch) ? cmptMag(area) : vector::zero;
        }
    }

    return
        sum.x() > max(sum.y(), sum.z()) ? vector::X
      : sum.y() > sum.z() ? vector::Y : vector::Z;
}


static void noPlane(const polyMesh& mesh, const label celli)
{
    FatalErrorInFunction
        << "Cell " << celli << " at " << mesh.cellCentres()[celli]
        << " is not between two faces on patches of type empty: the mesh is no"
        << " plane" << exit(FatalError);
}


static bool isCounterClockwise(const point& a, const point& b, const point& c)
{
    return orientation(a, b, c, point(a.x(), a.y(), 1)) > 0;
}


static bool isConvex(const face& f, const pointField& x)
{
    for (label k = 0; k < f.size(); ++k)
    {
        if (!isCounterClockwise(x[f.prevLabel(k)], x[f[k]], x[f.nextLabel(k)]))
        {
            return false;
        }
    }

    return true;
}


meshFront::meshFront(const polyMesh& mesh)
:
    faces(mesh.nCells()),
    newLabels(mesh.nPoints(), -1)
{
    // The plane of (x z) is seen against the axis y
    const direction axis = emptyAxis(mesh);
    const scalar sign = axis == vector::Y ? -1 : 1;

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; isA<emptyPolyPatch>(patch) && i < patch.size(); ++i)
        {
            const label celli = patch.faceCells()[i];
            if (sign*patch.faceAreas()[i][axis] <= 0)
            {
                continue;
            }
            if (faces[celli].size())
            {
                noPlane(mesh, celli);
            }
            faces[celli] = patch[i];
            for (label& p : faces[celli])
            {
                if (newLabels[p] < 0)
                {
                    newLabels[p] = points.size();
                    const point& x = mesh.points()[p];
                    points.append
                    (
                        point(x[axis == 0], x[axis == 2 ? 1 : 2], 0)
                    );
                }
                p = newLabels[p];
            }
        }
    }
}


static void appendFace
(
    const polyMesh& mesh,
    const meshFront& front,
    const pointField& x,
    const label celli,
    elementList& cells
)
{
    const face& f = front.faces[celli];
    if (f.empty())
    {
        noPlane(mesh, celli);
    }
    const bool whole = f.size() < 5 && isConvex(f, x);

    for (const face& part : whole ? faceList(1, f) : splitPolygon(x, f))
    {
        if (!isConvex(part, x))
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh.cellCentres()[celli]
                << " cannot be divided into triangles" << exit(FatalError);
        }
        cells.append
        (
            part.size() == 3
          ? elementShape::triangle : elementShape::quadrilateral,
            part
        );
    }
}


//- Appends the edge in the plane of a face on the boundary
static void appendEdge
(
    const polyMesh& mesh,
    const meshFront& front,
    const label facei,
    elementList& lines
)
{
    const labelUIndList labels(front.newLabels, mesh.faces()[facei]);

    for (const edge& e : front.faces[mesh.faceOwner()[facei]].edges())
    {
        if (labels.found(e.first()) && labels.found(e.second()))
        {
            lines.append(elementShape::line, labelList({e[0], e[1]}));
            return;
        }
    }
    noPlane(mesh, mesh.faceOwner()[facei]);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bool isPlane(const polyMesh& mesh)
{
    return anyOf(mesh.boundaryMesh(), [](const polyPatch& patch)
    {
        return isA<emptyPolyPatch>(patch) && patch.size();
    });
}


elementMesh planeElementsOf
(
    const polyMesh& mesh,
    const UList<cellZoneParts>& zones
)
{
    const meshFront front(mesh);
    elementMesh elements;
    elements.dimension = 2;
    elements.points = front.points;

    for (const cellZoneParts& zone : zones)
    {
        for (const label celli : zone.cells)
        {
            const label start = elements.cells.size();
            appendFace(mesh, front, elements.points, celli, elements.cells);
            elements.nDivided += elements.cells.size() > start + 1;
        }
        elements.cells.endGroup(zone.name, elements.zones);
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        for (label i = 0; !isA<emptyPolyPatch>(patch) && i < patch.size(); ++i)
        {
            appendEdge(mesh, front, patch.start() + i, elements.faces);
        }
        elements.faces.endGroup(patch.name(), elements.patches);
    }

    return elements;
}

} // End namespace Foam

// ************************************************************************* //
