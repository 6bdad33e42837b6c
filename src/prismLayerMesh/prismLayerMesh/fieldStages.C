/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldStages.H"
#include "isotropicDiffusionTensor.H"
#include "levelSets.H"
#include "localConductivity.H"
#include "stageText.H"
#include "throwingErrors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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
            << "Level sets near the wall do not have its topology: "
            << levelSets.nComponents << " components, the wall has "
            << wall.nComponents << "; Euler characteristic "
            << levelSets.eulerCharacteristic << ", the wall has "
            << wall.eulerCharacteristic << exit(FatalError);
    }
}


static bool isLowerSomewhere
(
    const layerSpacing& asked,
    const layerSpacing& uniform
)
{
    return min(asked.thickness) < uniform.thickness[0]
        || min(asked.firstThickness) < uniform.firstThickness[0];
}


static void requireField(const wallFields& fields)
{
    if (fields.failure.size())
    {
        FatalErrorInFunction
            << "marchingDistances levelSets needs a field, but there is none: "
            << fields.failure.c_str() << nl
            << "Write layers.marchingDistances requested" << exit(FatalError);
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
        fields = wallFields();
        fields.failure = e.message();
        sizes = fields.failure;
    }

    observer.end(sizes);
}


//- Make the field for the tensors of the model. Returns what the log says.
static string makeAnisotropicField(const fieldControls& controls, wallFields& f)
{
    if (controls.tensor == diffusionTensors::isotropic::typeName)
    {
        f.tensors.setSize(f.background.points.size(), symmTensor::I);
        f.anisotropic = f.isotropic;

        return "the isotropic field";
    }

    f.tensors =
        diffusionTensor::New(controls.tensor, controls.tensorCoeffs)
      ->tensors(f.background, f.isotropic);
    const scalarField weights
    (
        conductivityWeights(f.background, tetMeans(f.background, f.tensors))
    );
    const monotoneField field
    (
        makeMonotoneField(f.background, weights, controls)
    );
    f.anisotropic = field.values;

    return controls.tensor + ": " + sizesOf(f.background, field);
}


//- The field for the tensors of the model times local conductivities, which
//  move its level sets to the heights that are asked for. reached: the heights
//  that the level sets of a field have.
static scalarField localField
(
    const wallFields& fields,
    const List<wallSearch::foot>& feet,
    const scalarField& energies,
    const layerSpacing& asked,
    const fieldControls& controls,
    const std::function<layerSpacing(const scalarField&)>& reached
)
{
    const backgroundMesh& mesh = fields.background;
    const layerSpacing uniform(uniformSpacing(asked));
    scalarField field(fields.anisotropic);
    layerSpacing target(asked);

    for (label k = 0; k < nAims; ++k)
    {
        target = k > 0
          ? correctedTarget(target, asked, reached(field), uniform) : target;
        const symmTensorField conductivities
        (
            localConductivities(mesh, feet, energies, uniform, target)
           *tetMeans(mesh, fields.tensors)
        );
        field = makeMonotoneField
        (
            mesh, conductivityWeights(mesh, conductivities), controls
        ).values;
    }

    return field;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

offsetEnvelope makeEnvelope
(
    const wallContext& context,
    const envelopeRadii& radii,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    observer.begin("offsetEnvelope");
    const offsetEnvelope envelope
    (
        makeOffsetEnvelope
        (
            context, radii, identity(context.wall.points.size()),
            controls.backgroundMesh, controls.layers.maxStretch
        )
    );
    observer.end(sizesOf(envelope));

    return envelope;
}


wallFields makeFields
(
    const wallContext& context,
    const offsetEnvelope& envelope,
    const fieldControls& controls,
    const stageObserver& observer
)
{
    wallFields f;

    attempt("backgroundMesh", observer, f, [&]()
    {
        f.background = makeBackgroundMesh(context, envelope);
        f.topology = wallLevelSetTopology(f.background);
        requireHomeomorphic
        (
            f.topology, wallTopology(context.wall, context.addressing)
        );

        return sizesOf(f.background, f.topology);
    });

    attempt("isotropicField", observer, f, [&]()
    {
        const monotoneField field
        (
            makeMonotoneField
            (
                f.background, cotangentWeights(f.background), controls
            )
        );
        f.isotropic = field.values;

        return sizesOf(f.background, field);
    });

    attempt("anisotropicField", observer, f, [&]()
    {
        return makeAnisotropicField(controls, f);
    });

    return f;
}


levelSetLayers makeLevelSets
(
    const wallContext& context,
    const wallFields& fields,
    const layerSpacing& asked,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    requireField(fields);
    observer.begin("levelSets");
    const backgroundMesh& mesh = fields.background;
    const layerSpacing uniform(uniformSpacing(asked));
    levelSetLayers result{fields.anisotropic, asked};

    const vectorField axes(context.visibility.axes());
    const scalarField energies
    (
        samplingEnergies(mesh, result.field, axes, context.kinds, uniform)
    );
    const auto reached = [&](const scalarField& field)
    {
        return levelSetSpacing
        (
            mesh, field, context.visibility, energies, uniform
        );
    };

    const bool isLocal = isLowerSomewhere(asked, uniform);
    if (isLocal)
    {
        result.field = localField
        (
            fields, feetOfPoints(mesh, context.search()), energies, asked,
            controls.field, reached
        );
    }

    const layerSpacing smoothed
    (
        smoothedSpacing
        (
            reached(result.field), context.wall, context.addressing,
            uniform.thickness[0]
        )
    );
    result.spacing = gradedSpacing
    (
        smoothed, context.addressing, controls.layers.transitionRatio
    );
    observer.end
    (
        text("energies ", energies.first(), " to ", energies.last(),
            isLocal ? ", local tensors" : "")
    );

    return result;
}

} // End namespace Foam

// ************************************************************************* //
