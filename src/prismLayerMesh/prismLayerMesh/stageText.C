/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "stageText.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::string Foam::sizesOf(const List<pointKind>& kinds)
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


Foam::string Foam::sizesOf(const layerFront& front)
{
    return text(front.wallPoints.size(), " columns, ",
        front.extraColumnPoints().size(), " by multiple normals");
}


Foam::string Foam::sizesOf(const offsetEnvelope& envelope)
{
    return text(envelope.nEnvelope, " points, ",
        envelope.points.size() - envelope.nEnvelope, " on sheets between");
}


Foam::string Foam::sizesOf
(
    const backgroundMesh& mesh,
    const surfaceTopology& levelSets
)
{
    return text(mesh.tets.size(), " tetrahedra; components ",
        levelSets.nComponents, ", Euler characteristic ",
        levelSets.eulerCharacteristic, " as the wall's");
}


Foam::string Foam::sizesOf(const madeLayers& made)
{
    return text(made.layers.faces.size()*made.layers.nLayers,
        " cells; columns retreated ", made.nRetreats, " times");
}


Foam::string Foam::sizesOf(const layerCertificate& certificate)
{
    return text(certificate.nStacksNotPositive, " stacks not positive, ",
        certificate.nIntersectingPairs, " intersecting pairs");
}


Foam::string Foam::sizesOf(const farFieldMesh& far)
{
    return text(far.tets.size(), " tetrahedra on ", far.outerTriangles.size(),
        " triangles of the layers and ", far.boundaryTriangles.size(),
        " of the far boundary");
}


// ************************************************************************* //
