/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "fieldStages.H"
#include "diffusionTensor.H"
#include "harmonicField.H"
#include "levelSets.H"
#include "localConductivity.H"
#include "stageText.H"
#include "throwingErrors.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often local conductivities aim at local heights
static const label nAims = 5;


static void requireHomeomorphic
(
    const surfaceTopology& levelSets,
    const surfaceTopology& wall
)
{
    if (!(levelSets == wall))
    {
        FatalErrorInFunction
            << "Level sets near the wall are not homeomorphic to it: "
            << levelSets.nComponents << " components for "
            << wall.nComponents << ", Euler characteristic "
            << levelSets.eulerCharacteristic << " for "
            << wall.eulerCharacteristic << exit(FatalError);
    }
}


//- Make a stage unless one has failed. If this one fails, there are no fields,
//  and its line in the log says why.
template<class Stage>
static void attempt
(
    const char* name,
    const stageObserver& observer,
    wallFields& fields,
    const Stage& stage
)
{
    if (fields.failure.size())
    {
        return;
    }

    observer.begin(name);
    string sizes;

    try
    {
        const throwingErrors throwing;
        sizes = stage();
    }
    catch (const Foam::error& e)
    {
        const offsetEnvelope envelope(std::move(fields.envelope));
        fields = wallFields();
        fields.envelope = envelope;
        fields.failure = e.message();
        sizes = fields.failure;
    }

    observer.end(sizes);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::wallFields Foam::makeFields
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const scalarField& radius,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    wallFields f;

    observer.begin("offsetEnvelope");
    f.envelope = makeOffsetEnvelope
    (
        wall, addressing, search, visibility, radius, controls.backgroundMesh
    );
    observer.end(sizesOf(f.envelope));

    attempt("backgroundMesh", observer, f, [&]()
    {
        f.background = makeBackgroundMesh(wall, search, visibility, f.envelope);
        f.topology = wallLevelSetTopology(f.background);
        requireHomeomorphic(f.topology, wallTopology(wall, addressing));

        return sizesOf(f.background, f.topology);
    });

    attempt("isotropicField", observer, f, [&]()
    {
        f.isotropic = makeHarmonicField
        (
            f.background, cotangentWeights(f.background), controls.field
        );

        return text(findIndices(f.background.free, true).size(), " unknowns");
    });

    attempt("anisotropicField", observer, f, [&]()
    {
        const autoPtr<diffusionTensor> tensor
        (
            diffusionTensor::New
            (
                controls.field.tensor, controls.field.tensorCoeffs
            )
        );
        f.tensors = tensor->tensors(f.background, f.isotropic);
        f.edgeWeights = tensor->edgeWeights(f.background, f.tensors);
        f.anisotropic =
            makeHarmonicField(f.background, f.edgeWeights, controls.field);

        return text("tensor model ", controls.field.tensor);
    });

    return f;
}


Foam::levelSetLayers Foam::makeLevelSets
(
    const wallFields& fields,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const List<pointKind>& kinds,
    const layerSpacing& asked,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    if (fields.failure.size())
    {
        FatalErrorInFunction
            << "marchingDistances levelSets needs a field, but there is none: "
            << fields.failure.c_str() << exit(FatalError);
    }

    observer.begin("levelSets");
    const backgroundMesh& mesh = fields.background;
    const layerSpacing uniform(uniformSpacing(asked));
    levelSetLayers result;
    result.field = fields.anisotropic;

    const scalarField energies
    (
        samplingEnergies
        (
            mesh, result.field, visibility.axes(), kinds, uniform
        )
    );
    const auto reached = [&]()
    {
        return levelSetSpacing
        (
            mesh, result.field, visibility, energies, uniform
        );
    };

    const bool local =
        min(asked.thickness) < uniform.thickness[0]
     || min(asked.firstThickness) < uniform.firstThickness[0];
    const List<wallSearch::foot> feet
    (
        local ? feetOfPoints(mesh, search) : List<wallSearch::foot>()
    );
    layerSpacing target(asked);

    for (label k = 0; local && k < nAims; ++k)
    {
        if (k > 0)
        {
            target = correctedTarget(target, asked, reached(), uniform);
        }

        const scalarField factors
        (
            localWeightFactors(mesh, feet, energies, uniform, target)
        );
        result.field = makeHarmonicField
        (
            mesh, fields.edgeWeights*factors, controls.field
        );
    }

    result.spacing = gradedSpacing
    (
        reached(), addressing, controls.layers.transitionRatio
    );
    observer.end
    (
        text("energies ", energies.first(), " to ", energies.last(),
            local ? ", local tensors" : "")
    );

    return result;
}


// ************************************************************************* //
