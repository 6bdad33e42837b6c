/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldMesh.H"
#include "surfaceMeasures.H"
#include "UIndirectList.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

flatCellError::flatCellError(const point& place)
:
    error("--> FOAM FATAL ERROR: ")
{
    OSstream& os = *this;
    os  << "A cell of the far field at " << place << " is flat but for rounding"
        << nl << "Change farField.growthRate or maxCellSize a little, or remesh"
        << " the surface there";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void farFieldMesh::keepPatches(const labelUList& kept)
{
    meshPatches keptPatches;
    labelList starts(1, topology.patchStarts[0]);
    labelList sizes(1, topology.patchSizes[0]);
    for (const label patchi : kept)
    {
        keptPatches.names.append(patches.names[patchi]);
        keptPatches.entries.append(patches.entries[patchi]);
        starts.append(topology.patchStarts[1 + patchi]);
        sizes.append(topology.patchSizes[1 + patchi]);
    }

    patches = keptPatches;
    topology.patchStarts = starts;
    topology.patchSizes = sizes;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void requireVolumes(const farFieldMesh& far, const label nCells)
{
    const polyMeshTopology& t = far.topology;
    List<faceGeometry> geometries(t.faces.size());

    #pragma omp parallel for schedule(static)
    forAll(geometries, facei)
    {
        geometries[facei] =
            faceGeometry(UIndirectList<point>(far.points, t.faces[facei]));
    }

    scalarField volumes(far.nCells, 0), areas(far.nCells, 0);
    List<boundBox> boxes(far.nCells, boundBox(boundBox::invertedBox));
    labelList apex(far.nCells, -1);
    const auto add = [&](const label celli, const label facei, const scalar way)
    {
        const face& f = t.faces[facei];
        const faceGeometry& g = geometries[facei];
        apex[celli] = apex[celli] < 0 ? f[0] : apex[celli];
        volumes[celli] += way*g.pyramid3(far.points[apex[celli]])/3;
        areas[celli] += mag(g.area);
        for (const label p : f)
        {
            boxes[celli].add(far.points[p]);
        }
    };
    forAll(t.faces, facei)
    {
        add(t.owner[facei], facei, 1);
        if (t.beyond(facei) >= 0)
        {
            add(t.beyond(facei), facei, -1);
        }
    }

    for (label celli = 0; celli < nCells; ++celli)
    {
        if (volumes[celli] <= roundingVolume(boxes[celli], areas[celli]))
        {
            throw flatCellError(far.points[apex[celli]]);
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
