/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "embeddingFault.H"
#include "prismQuality.H"
#include "surfacePart.H"
#include "wallDefects.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- The side of layer i (1..n) between two columns of a border; a triangle where
//  both begin at one point of the wall
static face sideFace
(
    const prismLayers& layers,
    const edge& columns,
    const label i
)
{
    const label a = columns.start();
    const label b = columns.end();
    face side({layers.pointLabel(b, i), layers.pointLabel(a, i)});
    side.append(layers.pointLabel(a, i - 1));

    if (layers.pointLabel(b, i - 1) != side.last())
    {
        side.append(layers.pointLabel(b, i - 1));
    }

    return side;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findEmbeddingFault
(
    const wallSurface& wall,
    const prismLayers& layers
)
{
    wallSurface body(wall);
    body.border = wallBorder();
    body.points = layers.meshPoints();

    for (face& f : body.faces)
    {
        for (label& p : f)
        {
            p = layers.pointLabel(p, 0);
        }

        f.flip();
    }

    for (face f : outerPolygons(layers).faces)
    {
        for (label& column : f)
        {
            column = layers.pointLabel(column, layers.nLayers);
        }

        body.faces.append(f);
    }

    for (const edge& columns : layers.border.edges)
    {
        for (label i = 1; i <= layers.nLayers; ++i)
        {
            body.faces.append(sideFace(layers, columns, i));
        }
    }

    removeUnusedPoints(body.faces, body.points);
    body.patchIDs.setSize(body.faces.size(), 0);
    const List<wallDefect> defects(findWallDefects(body));

    return
        defects.empty()
      ? ""
      : "wall and outer surface have " + describe(defects);
}


// ************************************************************************* //
