/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldFaults.H"
#include "meshCertificate.H"
#include "prismPolyMesh.H"
#include "makeFarFieldMesh.H"
#include "hexFaces.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

template<class... Items>
std::string textOf(const Items&... items)
{
    std::ostringstream os;
    os.precision(12);
    (os << ... << items);

    return os.str();
}


class farFieldJudge
{
    const wallSurface& wall_;
    const prismLayers& layers_;
    const fuzzFarField& asked_;
    const polyMesh& mesh_;

    label nLayerCells() const
    {
        return layers_.faces.size()*layers_.nLayers;
    }

    //- The first patches are those of the wall
    label nWallPatches() const { return layers_.patchNames.size(); }

    labelList wallFaces() const;

    std::string topologyFault() const;

    std::string certificateFault() const;

    //- Of the layers on each face of the wall
    std::string layersFault(const labelList& nLayers) const;

    std::string zoneFault() const;

public:

    farFieldJudge
    (
        const wallSurface& wall,
        const prismLayers& layers,
        const fuzzFarField& asked,
        const polyMesh& mesh
    )
    :
        wall_(wall),
        layers_(layers),
        asked_(asked),
        mesh_(mesh)
    {}

    std::string fault() const;
};

} // End anonymous namespace


labelList farFieldJudge::wallFaces() const
{
    DynamicList<label> faces;
    for (label patchi = 0; patchi < nWallPatches(); ++patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        faces.append(identity(patch.size(), patch.start()));
    }

    return labelList(std::move(faces));
}


std::string farFieldJudge::topologyFault() const
{
    const bool isWrong =
        mesh_.checkUpperTriangular(false)
     || mesh_.checkPoints(false)
     || mesh_.checkFaceVertices(false)
     || mesh_.checkCellsZipUp(false)
     || mesh_.boundaryMesh().checkDefinition(false)
     || mesh_.cellZones().checkDefinition(false)
     || mesh_.faceZones().checkDefinition(false);

    return isWrong ? "the topology is not that of a mesh" : "";
}


std::string farFieldJudge::certificateFault() const
{
    const polyhedralMesh cells
    (
        mesh_.points(), mesh_.faces(), mesh_.faceOwner(), mesh_.faceNeighbour()
    );
    const meshCertificate certificate
    (
        certifyMesh(cells, wallFaces(), labelList())
    );

    if (certificate.invalidCells.size())
    {
        const label celli = certificate.invalidCells[0];
        const point x(cells.centre(celli));
        const label i = celli - nLayerCells();
        const label nTets = mesh_.cellZones()[farFieldName].size();

        return textOf
        (
            certificate.invalidCells.size(), " cells are not positive, first ",
            celli, ", a ", meshCellShapeName[certificate.invalidShapes[0]],
            i < 0 ? " of the layers" : i < nTets ? " of tetrahedra"
          : " that stays", ", at ", x.x(), ' ', x.y(), ' ', x.z()
        );
    }
    if (certificate.doubleFaces.size())
    {
        return textOf
        (
            certificate.doubleFaces.size(), " pairs of faces are double, first "
            , certificate.doubleFaces[0].first(), " and ",
            certificate.doubleFaces[0].second()
        );
    }
    if (!certificate.fillsBoundary())
    {
        return textOf
        (
            "cells have the volume ", certificate.cellVolume,
            ", the boundary has ", certificate.boundaryVolume
        );
    }

    return layersFault(certificate.nLayers);
}


std::string farFieldJudge::layersFault(const labelList& nLayers) const
{
    const label nWall = wall_.faces.size();
    if (nLayers.size() != nWall)
    {
        return textOf
        (
            nLayers.size(), " faces on the wall, not ", nWall
        );
    }
    forAll(nLayers, i)
    {
        if (nLayers[i] != layers_.nLayers)
        {
            return textOf
            (
                "face ", i, " of the wall has ", nLayers[i],
                " layers"
            );
        }
    }

    return "";
}


std::string farFieldJudge::zoneFault() const
{
    const cellZoneMesh& zones = mesh_.cellZones();
    labelList expected(identity(nLayerCells()));
    if (zones[boundaryLayerName] != expected)
    {
        return "the zone of the layers is not theirs";
    }
    const label nTets = zones[farFieldName].size();
    expected = identity(nTets, nLayerCells());
    if (zones[farFieldName] != expected)
    {
        return "the zone of the tetrahedra is not theirs";
    }

    const label first = nLayerCells() + nTets;
    if (asked_.controls.type == "hexCore")
    {
        expected = identity(mesh_.nCells() - first, first);
        return
            zones.size() == 3 && zones[hexCoreName] == expected
          ? "" : "the zone of the hexahedra is not theirs";
    }
    const label all = zones.findZoneID("all");
    if
    (
        asked_.controls.type == "mesh"
     && (all < 0 || zones[all].size() != mesh_.nCells())
    )
    {
        return "cells have left the zone of all";
    }

    return "";
}


std::string farFieldJudge::fault() const
{
    DynamicList<std::string> faults;
    faults.append(topologyFault());
    faults.append(certificateFault());
    faults.append(zoneFault());
    faults.append(findDomainFault(wall_, layers_, asked_, mesh_));

    for (const std::string& fault : faults)
    {
        if (fault.size())
        {
            return fault;
        }
    }

    return "";
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findFarFieldFault
(
    const wallSurface& wall,
    const prismLayers& layers,
    const fuzzFarField& asked,
    const polyMesh& mesh
)
{
    return farFieldJudge(wall, layers, asked, mesh).fault();
}


// ************************************************************************* //
