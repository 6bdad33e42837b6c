/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stageText.H"

namespace Foam
{

string sizesOf(const List<pointKind>& kinds)
{
    const FixedList<label, nPointKinds> counts(countKinds(kinds));
    string sizes("cones of points:");

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        sizes += text(kind ? ", " : " ", name(pointKind(kind)), ' ',
            counts[kind]);
    }

    return sizes;
}


string sizesOf(const layerFront& front)
{
    if (front.pointsWithoutDirection.size())
    {
        return text("none: ", front.pointsWithoutDirection.size(),
            " points have no direction from which all their faces are visible");
    }

    return text(front.wallPoints.size(), " columns, ",
        front.extraColumnPoints().size(), " by multiple normals");
}


string sizesOf
(
    const labelListList& blocks,
    const label nPoints,
    const string& failure
)
{
    label n = 0;
    for (const labelList& block : blocks)
    {
        n += block.size();
    }

    return failure.empty()
      ? text(blocks.size(), " blocks for ", n, " of ", nPoints, " points")
      : "no field in front of " + failure;
}


string sizesOf(const offsetEnvelope& envelope)
{
    return text(envelope.nEnvelope, " points, ",
        envelope.points.size() - envelope.nEnvelope, " on sheets between");
}


string sizesOf(const backgroundMesh& mesh, const surfaceTopology& levelSets)
{
    return text(mesh.tets.size(), " tetrahedra; components ",
        levelSets.nComponents, ", Euler characteristic ",
        levelSets.eulerCharacteristic, " as the wall's");
}


string sizesOf(const backgroundMesh& mesh, const monotoneField& field)
{
    return text(findIndices(mesh.free, true).size(), " unknowns, ",
        field.nClipped, " negative weights set to 0");
}


string sizesOf(const madeLayers& made, const label nFaces)
{
    if (made.certified.pointsWithoutHeight.size())
    {
        return text("none: ", made.certified.pointsWithoutHeight.size(),
            " points have no height left");
    }

    return text(nFaces*made.layers.nLayers,
        " cells; columns retreated ", made.certified.nRetreats, " times");
}


string sizesOf(const layerCertificate& certificate)
{
    return text(certificate.nStacksNotPositive, " stacks not positive, ",
        certificate.nOverlaps, " overlapping stacks");
}


string sizesOf(const farFieldMesh& far)
{
    string sizes
    (
        text(far.nCells, " cells on ", far.frontFaces.size(),
            " faces of the layers")
    );
    for (const cellZoneParts& zone : far.cellZones)
    {
        sizes += text(", ", zone.cells.size(), " in ", zone.name);
    }
    for (const string& note : far.notes)
    {
        sizes += '\n' + note;
    }

    return sizes;
}

} // End namespace Foam

// ************************************************************************* //
