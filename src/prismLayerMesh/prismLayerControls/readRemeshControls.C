/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "readRemeshControls.H"
#include "readRegions.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- The longest edge in a part of the surface, no shorter than the shortest
static scalar readMaxEdge
(
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    return readMandatory(dict, "maxEdge", max(general.minEdge, SMALL), GREAT);
}


static patchEdges readPatch
(
    const keyType& key,
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    checkKeys(dict, {"maxEdge"});

    return patchEdges{key, readMaxEdge(dict, general)};
}


static edgeRegion readRegion
(
    const dictionary& dict,
    const surfaceRemeshControls& general
)
{
    wordList keys(geometryRegionKeys);
    keys.append("maxEdge");
    checkKeys(dict, keys);

    return edgeRegion{readGeometryRegion(dict), readMaxEdge(dict, general)};
}


static void readSharpEdges
(
    const dictionary& dict,
    surfaceRemeshControls& controls
)
{
    if (!dict.found("sharpEdges", keyType::LITERAL))
    {
        return;
    }

    const dictionary& sharp = optionalDict(dict, "sharpEdges");
    checkKeys(sharp, {"angle", "maxEdge"});
    controls.sharpAngle = max(controls.sharpAngle, controls.featureAngle);
    readBounded
    (
        sharp, "angle", controls.featureAngle, 180, controls.sharpAngle
    );
    controls.sharpMaxEdge = readMaxEdge(sharp, controls);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

surfaceRemeshControls readRemeshControls(const dictionary& surface)
{
    const dictionary& dict = optionalDict(surface, "remesh");
    checkKeys
    (
        dict,
        {
            "maxEdge", "minEdge", "deviation", "featureAngle", "growthRate",
            "patches", "regions", "sharpEdges", "edgePerGap"
        }
    );

    surfaceRemeshControls controls;
    controls.active = surface.found("remesh");
    readBounded(dict, "maxEdge", SMALL, GREAT, controls.maxEdge);
    readBounded
    (
        dict, "minEdge", SMALL,
        controls.maxEdge > 0 ? controls.maxEdge : GREAT, controls.minEdge
    );
    readBounded(dict, "deviation", SMALL, GREAT, controls.deviation);
    readBounded(dict, "featureAngle", 1, 90, controls.featureAngle);
    readBounded(dict, "growthRate", 1.01, 2, controls.growthRate);

    controls.patches = readEntries<patchEdges>
    (
        dict, "patches",
        [&](const keyType& key, const dictionary& entries)
        {
            return readPatch(key, entries, controls);
        }
    );
    controls.regions = readEntries<edgeRegion>
    (
        dict, "regions",
        [&](const keyType&, const dictionary& entries)
        {
            return readRegion(entries, controls);
        }
    );
    readSharpEdges(dict, controls);
    readBounded(dict, "edgePerGap", 0.1, 100, controls.edgePerGap);

    return controls;
}

} // End namespace Foam

// ************************************************************************* //
