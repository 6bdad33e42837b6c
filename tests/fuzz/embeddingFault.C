/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "embeddingFault.H"
#include "wallDefects.H"

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string Foam::findEmbeddingFault
(
    const wallSurface& wall,
    const prismLayers& layers
)
{
    const label n = wall.points.size();
    wallSurface body(wall);

    for (face& f : body.faces)
    {
        f.flip();
    }

    for (label c = 0; c < layers.nColumns(); ++c)
    {
        body.points.append(layers(c, layers.nLayers));
    }

    for (face f : layers.faces)
    {
        for (label& column : f)
        {
            column += n;
        }

        body.faces.append(f);
    }

    body.patchIDs.setSize(body.faces.size(), 0);
    const List<wallDefect> defects(findWallDefects(body));

    return
        defects.empty()
      ? ""
      : "wall and outer surface have " + describe(defects);
}


// ************************************************************************* //
