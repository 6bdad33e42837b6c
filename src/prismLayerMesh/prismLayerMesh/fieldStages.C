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
            << "Level sets near the wall are not homeomorphic to it: "
            << levelSets.nComponents << " components for "
            << wall.nComponents << ", Euler characteristic "
            << levelSets.eulerCharacteristic << " for "
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
            << fields.failure.c_str() << exit(FatalError);
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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

offsetEnvelope makeEnvelope
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const List<pointKind>& kinds,
    const scalarField& thickness,
    const scalarField& clearance,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    const scalarField wanted(controls.envelope.scale*thickness);

    observer.begin("offsetEnvelope");
    const offsetEnvelope envelope
    (
        makeOffsetEnvelope
        (
            wall, addressing, search, visibility, kinds,
            min(wanted, clearance), wanted, controls.backgroundMesh,
            controls.layers.maxStretch
        )
    );
    observer.end(sizesOf(envelope));

    return envelope;
}


wallFields makeFields
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const offsetEnvelope& envelope,
    const fieldControls& controls,
    const stageObserver& observer
)
{
    wallFields f;

    attempt("backgroundMesh", observer, f, [&]()
    {
        f.background = makeBackgroundMesh(wall, addressing, search, envelope);
        f.topology = wallLevelSetTopology(f.background);
        requireHomeomorphic(f.topology, wallTopology(wall, addressing));

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


columnLines makeLinesOfPieces
(
    const dividedWall& wall,
    const columnStarts& starts,
    const fieldControls& controls,
    const stageObserver& observer,
    string& failure
)
{
    observer.begin("columnLines");
    const columnLines made(makeColumnLines(wall, starts, controls, failure));
    observer.end
    (
        failure.empty()
      ? text(wall.parts.size(), " pieces")
      : "no field in front of " + failure
    );

    return made;
}


levelSetLayers makeLevelSets
(
    const wallFields& fields,
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const List<pointKind>& kinds,
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

    const scalarField energies
    (
        samplingEnergies(mesh, result.field, visibility.axes(), kinds, uniform)
    );
    const auto reached = [&]()
    {
        const scalarField& field = result.field;
        return levelSetSpacing(mesh, field, visibility, energies, uniform);
    };

    const bool local = isLowerSomewhere(asked, uniform);

    if (local)
    {
        const List<wallSearch::foot> feet(feetOfPoints(mesh, search));
        layerSpacing target(asked);

        for (label k = 0; k < nAims; ++k)
        {
            target = k > 0
              ? correctedTarget(target, asked, reached(), uniform) : target;
            const symmTensorField conductivities
            (
                localConductivities(mesh, feet, energies, uniform, target)
               *tetMeans(mesh, fields.tensors)
            );
            result.field = makeMonotoneField
            (
                mesh, conductivityWeights(mesh, conductivities), controls.field
            ).values;
        }
    }

    result.spacing = gradedSpacing
    (
        smoothedSpacing(reached(), wall, addressing, uniform.thickness[0]),
        addressing, controls.layers.transitionRatio
    );
    observer.end
    (
        text("energies ", energies.first(), " to ", energies.last(),
            local ? ", local tensors" : "")
    );

    return result;
}

} // End namespace Foam

// ************************************************************************* //
