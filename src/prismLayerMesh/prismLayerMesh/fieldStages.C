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

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- How often local tensors aim at local heights
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


//- Sets noField where a stage of the field fails. Its line in the log ends with
//  sizes, or with why it failed.
template<class Stage, class Sizes>
static void attempt
(
    const char* name,
    const stageObserver& observer,
    prismLayerMesh& m,
    const Stage& stage,
    const Sizes& sizes
)
{
    if (m.noField.size())
    {
        return;
    }

    observer.begin(name);
    const bool throwing = FatalError.throwExceptions(true);

    try
    {
        stage();
    }
    catch (const Foam::error& e)
    {
        m.noField = e.message();
        m.background = backgroundMesh();
        m.isotropic.clear();
        m.tensors.clear();
        m.field.clear();
    }

    FatalError.throwExceptions(throwing);
    observer.end(m.noField.size() ? m.noField : sizes());
}


//- The spacing of the level sets of the field, which local tensors move to
//  where other heights are asked for
static void makeLevelSets
(
    const wallSearch& search,
    const prismLayerControls& controls,
    const scalarField& weights,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    if (m.noField.size())
    {
        FatalErrorInFunction
            << "marchingDistances levelSets needs a field, but there is none: "
            << m.noField.c_str() << exit(FatalError);
    }

    observer.begin("levelSets");
    const layerSpacing uniform(uniformSpacing(m.spacing));
    const scalarField energies
    (
        samplingEnergies
        (
            m.background, m.field, m.visibility.axes(), m.pointKinds, uniform
        )
    );
    const bool local =
        min(m.spacing.thickness) < uniform.thickness[0]
     || min(m.spacing.firstThickness) < uniform.firstThickness[0];
    const auto reached = [&]()
    {
        return levelSetSpacing
        (
            m.background, m.field, m.visibility, energies, uniform
        );
    };

    // Tensors for what is asked for do not reach it where the mesh is coarse
    layerSpacing aim(m.spacing);
    const List<wallSearch::foot> feet
    (
        local
      ? feetOfPoints(m.background, search) : List<wallSearch::foot>()
    );

    for (label k = 0; local && k < nAims; ++k)
    {
        if (k > 0)
        {
            aim = correctedTarget(aim, m.spacing, reached(), uniform);
        }

        m.field = makeHarmonicField
        (
            m.background,
            weights*localWeightFactors
            (
                m.background, feet, energies, uniform, aim
            ),
            controls.field
        );
    }

    m.spacing = gradedSpacing
    (
        reached(), m.addressing, controls.layers.transitionRatio
    );
    observer.end
    (
        text
        (
            "energies ", energies.first(), " to ", energies.last(),
            local ? ", local tensors" : ""
        )
    );
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::layerSpacing Foam::fieldSpacing
(
    const prismLayerControls& controls,
    const layerSpacing& spacing
)
{
    return controls.layers.onLevelSets ? uniformSpacing(spacing) : spacing;
}


void Foam::makeField
(
    const wallSurface& wall,
    const wallSearch& search,
    const prismLayerControls& controls,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    observer.begin("offsetEnvelope");
    m.envelope = makeOffsetEnvelope
    (
        wall, m.addressing, search, m.visibility,
        min
        (
            controls.envelope.scale*fieldSpacing(controls, m.spacing).thickness,
            m.front.smallest(m.clearance)
        ),
        controls.backgroundMesh
    );
    observer.end
    (
        text(m.envelope.nEnvelope, " points, ",
            m.envelope.points.size() - m.envelope.nEnvelope,
            " on sheets between")
    );

    attempt("backgroundMesh", observer, m, [&]()
    {
        m.background =
            makeBackgroundMesh(wall, search, m.visibility, m.envelope);
        m.topology = wallLevelSetTopology(m.background);
        requireHomeomorphic(m.topology, wallTopology(wall, m.addressing));
    },
    [&]()
    {
        return text(m.background.tets.size(), " tetrahedra; components ",
            m.topology.nComponents, ", Euler characteristic ",
            m.topology.eulerCharacteristic, " as the wall's");
    });

    attempt("isotropicField", observer, m, [&]()
    {
        m.isotropic = makeHarmonicField
        (
            m.background, cotangentWeights(m.background), controls.field
        );
    },
    [&]()
    {
        return text(findIndices(m.background.free, true).size(), " unknowns");
    });

    const autoPtr<diffusionTensor> tensor
    (
        diffusionTensor::New(controls.field.tensor, controls.field.tensorCoeffs)
    );
    scalarField weights;

    attempt("anisotropicField", observer, m, [&]()
    {
        m.tensors = tensor->tensors(m.background, m.isotropic);
        weights = tensor->edgeWeights(m.background, m.tensors);
        m.field = makeHarmonicField(m.background, weights, controls.field);
    },
    [&]()
    {
        return text("tensor model ", controls.field.tensor);
    });

    if (controls.layers.onLevelSets)
    {
        makeLevelSets(search, controls, weights, observer, m);
    }
}


// ************************************************************************* //
