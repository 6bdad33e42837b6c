/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "farFieldFaults.H"
#include "faultText.H"
#include "makeFarFieldMesh.H"
#include "makeHexCore.H"
#include "meshCertificate.H"
#include "prismPolyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

labelList wallFaces(const polyMesh& mesh, const label nPatches)
{
    DynamicList<label> faces;
    for (label patchi = 0; patchi < nPatches; ++patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        faces.append(identity(patch.size(), patch.start()));
    }

    return labelList(std::move(faces));
}


class farFieldJudge : madeFarField
{
    std::string topologyFault() const;

    std::string certificateFault() const;

    //- Of the layers on each face of the wall
    std::string layersFault(const labelList& nLayers) const;

    std::string zoneFault() const;

public:

    explicit farFieldJudge(const madeFarField& made) : madeFarField(made) {}

    std::string fault() const;
};

} // End anonymous namespace


std::string farFieldJudge::topologyFault() const
{
    const bool isWrong =
        mesh.checkUpperTriangular(false)
     || mesh.checkPoints(false)
     || mesh.checkFaceVertices(false)
     || mesh.checkCellsZipUp(false)
     || mesh.boundaryMesh().checkDefinition(false)
     || mesh.cellZones().checkDefinition(false)
     || mesh.faceZones().checkDefinition(false);

    return isWrong ? "the faces are not the faces of a mesh" : "";
}


std::string farFieldJudge::certificateFault() const
{
    const polyhedralMesh cells
    (
        mesh.points(), mesh.faces(), mesh.faceOwner(), mesh.faceNeighbour()
    );
    const meshCertificate certificate
    (
        certifyMesh(cells, wallFaces(mesh, nWallPatches()), labelList())
    );

    if (certificate.invalidCells.size())
    {
        const label celli = certificate.invalidCells[0];
        const point x(cells.centre(celli));
        const label i = celli - nLayerCells();
        const label nTets = mesh.cellZones()[farFieldName].size();

        return faultText
        (
            certificate.invalidCells.size(), " cells are not positive, first ",
            celli, ", a ", meshCellShapeName[certificate.invalidShapes[0]],
            i < 0 ? " of the layers" : i < nTets ? " of tetrahedra"
          : " that stays", ", at ", x.x(), ' ', x.y(), ' ', x.z()
        );
    }
    if (certificate.doubleFaces.size())
    {
        return faultText
        (
            certificate.doubleFaces.size(), " pairs of faces are double, first "
            , certificate.doubleFaces[0].first(), " and ",
            certificate.doubleFaces[0].second()
        );
    }
    if (!certificate.fillsBoundary())
    {
        return faultText
        (
            "cells have the volume ", certificate.cellVolume,
            ", the boundary has ", certificate.boundaryVolume
        );
    }

    return layersFault(certificate.nLayers);
}


std::string farFieldJudge::layersFault(const labelList& nLayers) const
{
    const label nWall = wall.faces.size();
    if (nLayers.size() != nWall)
    {
        return faultText
        (
            nLayers.size(), " faces on the wall, not ", nWall
        );
    }
    forAll(nLayers, i)
    {
        if (nLayers[i] != layers.nLayers)
        {
            return faultText
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
    const cellZoneMesh& zones = mesh.cellZones();
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
    if (asked.controls.type == farFieldType::hexCore)
    {
        expected = identity(mesh.nCells() - first, first);
        return
            zones.size() == 3 && zones[hexCoreName] == expected
          ? "" : "the zone of the hexahedra is not theirs";
    }
    const label all = zones.findZoneID("all");
    if
    (
        asked.controls.type == farFieldType::mesh
     && (all < 0 || zones[all].size() != mesh.nCells())
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
    faults.append(findDomainFault(*this));

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

std::string Foam::findFarFieldFault(const madeFarField& made)
{
    return farFieldJudge(made).fault();
}


std::string Foam::findPolygonFault
(
    const polyMesh& mesh,
    const label nWallPatches,
    const label nLayers
)
{
    bitSet beyond;
    labelList outer;
    if (mesh.cellZones().size())
    {
        beyond = bitSet(mesh.nCells(), true);
        beyond.unset(mesh.cellZones()[boundaryLayerName]);
    }
    else
    {
        const polyPatch& patch = mesh.boundaryMesh()[layerOuterName];
        outer = identity(patch.size(), patch.start());
    }
    const labelList wall(wallFaces(mesh, nWallPatches));
    const meshCertificate certificate
    (
        certifyMesh
        (
            polyhedralMesh
            (
                mesh.points(), mesh.faces(), mesh.faceOwner(),
                mesh.faceNeighbour()
            ),
            wall, outer, beyond
        )
    );
    forAll(wall, i)
    {
        if (certificate.nLayers[i] != nLayers)
        {
            const point x(mesh.faceCentres()[wall[i]]);

            return faultText
            (
                "a polygon of the wall has ", certificate.nLayers[i],
                " layers, at ", x.x(), ' ', x.y(), ' ', x.z()
            );
        }
    }

    return
        certificate.invalidCells.size() ? "polyhedra are not positive"
      : certificate.intersections.size() ? "layers on polygons intersect"
      : certificate.doubleFaces.size() ? "faces of polygons are double"
      : certificate.fillsBoundary() ? ""
      : "polyhedra do not fill the boundary";
}


// ************************************************************************* //
