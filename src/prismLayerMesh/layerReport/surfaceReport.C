/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceReport.H"
#include "layerReport.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static dictionary toDictionary(const surfaceDistance& distance)
{
    dictionary dict;
    dict.add("max", distance.largest);
    dict.add("mean", distance.mean);
    dict.add("place", distance.place);

    return dict;
}


static dictionary toDictionary(const surfaceMeasures& measures)
{
    dictionary dict;
    dict.add("faces", measures.angles.size());
    dict.add("area", measures.area);
    if (measures.volume > 0)
    {
        dict.add("volume", measures.volume);
    }
    dict.add("smallestAngle", toDictionary(makePercentiles(measures.angles)));
    dict.add("below15DegreesPercent", 100*measures.shareWithSmallAngles);

    return dict;
}


static dictionary toDictionary(const surfaceChange& change)
{
    dictionary dict;
    dict.add("distanceFromGiven", toDictionary(change.distance));
    dict.add("distanceOfGiven", toDictionary(change.distanceOfGiven));
    dict.add("before", toDictionary(change.before));
    dict.add("now", toDictionary(change.now));

    return dict;
}


//- Entries step0, ...
static dictionary toDictionary(const repairSteps& steps)
{
    dictionary dict;
    for (const repairStep& step : steps)
    {
        dictionary entry;
        entry.add("what", step.what);
        entry.add("count", step.count);
        if (step.places.size())
        {
            entry.add("firstPlace", step.places[0]);
        }
        dict.add(word("step" + Foam::name(dict.size())), entry);
    }

    return dict;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

dictionary changesOf
(
    const preparedWall& prepared,
    const stringList& cadFiles
)
{
    dictionary dict;
    if (cadFiles.size())
    {
        dict.add("cad", cadFiles);
    }
    if (prepared.nFacesInSides)
    {
        dict.add("facesInSidesRemoved", prepared.nFacesInSides);
    }
    if (prepared.steps.size())
    {
        dictionary repair(toDictionary(prepared.repair));
        repair.add("steps", toDictionary(prepared.steps));
        dict.add("repair", repair);
    }
    if (prepared.isRemeshed)
    {
        const remeshQuality& quality = prepared.quality;
        dictionary away;
        away.add
        (
            "below15DegreesPercent",
            100.0*quality.nSmallAngles/prepared.surface.faces.size()
        );
        away.add("edgesBeyond70Degrees", quality.nNonOrtho);
        dictionary remesh(toDictionary(prepared.remesh));
        remesh.add("awayFromFeatures", away);
        dict.add("remesh", remesh);
    }

    return dict;
}

} // End namespace Foam

// ************************************************************************* //
