/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    levelSetMeasures

Description
    Prints how even the first level sets of each field are, without making
    layers: a line for each field, with tabs between its name, the unevenness
    and the largest height over the points on concave edges alone, both over the
    points on convex edges alone, and the saddle points above the last energy.

    An edge of the wall counts if the normals of its faces are more than 20
    degrees apart. Unevenness is exp(mean |ln(h/h_1)|), h the height of the
    first level set and h_1 the first height that is asked for.

Usage
    levelSetMeasures -case <case with a harmonicPrismMeshDict>

    \table
        Option       | Meaning
        -shuffle n   | the wall is numbered at random, with the seed n
        -fields list | only these of (isotropic anisotropic gradientPower)
    \endtable

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "criticalPoints.H"
#include "fieldStages.H"
#include "levelSets.H"
#include "preparedCase.H"
#include "testSurfaces.H"
#include "unitConversion.H"
#include "wallClearance.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Marks the points on concave edges alone and on convex edges alone
static void markEdges
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    bitSet& concave,
    bitSet& convex
)
{
    const vectorField normals(wall.faceNormals());
    concave.resize(wall.points.size());
    convex.resize(wall.points.size());

    forAll(addressing.edges, i)
    {
        const label a = addressing.edgeFaces[i].first();
        const label b = addressing.edgeFaces[i].second();

        if (b < 0 || (normals[a] & normals[b]) >= ::cos(degToRad(scalar(20))))
        {
            continue;
        }

        const vector ab =
            wall.faces[b].centre(wall.points)
          - wall.faces[a].centre(wall.points);
        const edge& e = addressing.edges[i];
        ((normals[a] & ab) > 0 ? concave : convex).set(labelList({e[0], e[1]}));
    }

    const bitSet both(concave & convex);
    concave -= both;
    convex -= both;
}


static void printHeights(const scalarField& heights, const bitSet& points)
{
    scalar sum = 0, largest = 0;

    for (const label p : points)
    {
        sum += mag(::log(max(heights[p], scalar(1e-3))));
        largest = max(largest, heights[p]);
    }

    if (points.none())
    {
        Info<< "\t-\t-";
    }
    else
    {
        Info<< '\t' << ::exp(sum/points.count()) << '\t' << largest;
    }
}


namespace
{

//- What all fields of a wall have in common
struct fieldInput
{
    const wallContext& context;
    const offsetEnvelope& envelope;
    const layerSpacing uniform;
    const stageObserver& silent;
};


void measure(const fieldInput& in, const fieldControls& controls)
{
    const wallFields fields
    (
        makeFields(in.context, in.envelope, controls, in.silent)
    );
    if (fields.failure.size())
    {
        FatalErrorInFunction << fields.failure.c_str() << exit(FatalError);
    }

    const scalarField& field = fields.anisotropic;
    const scalarField energies
    (
        samplingEnergies
        (
            fields.background, field, in.context.visibility.axes(),
            in.context.kinds, in.uniform
        )
    );
    const layerSpacing levelSets
    (
        levelSetSpacing
        (
            fields.background, field, in.context.visibility, energies,
            in.uniform
        )
    );
    const scalarField heights
    (
        levelSets.firstThickness/in.uniform.firstThickness
    );
    bitSet concave, convex;
    markEdges(in.context.wall, in.context.addressing, concave, convex);

    label nSaddles = 0;
    for (const label p : findCriticalPoints(fields.background, field).saddles)
    {
        nSaddles += field[p] > energies.last();
    }

    Info<< controls.tensor.c_str();
    printHeights(heights, concave);
    printHeights(heights, convex);
    Info<< '\t' << nSaddles << endl;
}


offsetEnvelope envelopeFor
(
    const wallContext& context,
    const layerSpacing& request,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    const scalarField radius(controls.envelope.scale*request.thickness);
    const scalarField clearance
    (
        makeWallClearance
        (
            context.wall, context.search(), context.visibility, 2*radius,
            controls.layers.maxStretch
        )
    );

    const envelopeRadii radii
    (
        makeEnvelopeRadii
        (
            context.wall, context.addressing,
            controls.envelope.scale*request.thickness, clearance
        )
    );

    return makeEnvelope(context, radii, controls, observer);
}

} // End anonymous namespace


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noBanner();
    argList::addOption("fields", "list", "Only these");
    argList::addOption("shuffle", "seed", "Number the wall at random");

    #include "setRootCase.H"
    #include "createTime.H"

    preparedCase given(runTime);
    prismLayerControls& controls = given.controls;
    label seed = 0;
    const wallSurface wall
    (
        args.readIfPresent("shuffle", seed)
      ? testSurfaces::renumbered(given.wall, seed) : given.wall
    );
    const stageObserver silent;
    const wallContext context(wall);
    const layerSpacing request
    (
        makeLayerSpacing(wall, context.addressing, controls.layers)
    );
    const offsetEnvelope envelope
    (
        envelopeFor(context, request, controls, silent)
    );
    const fieldInput in{context, envelope, uniformSpacing(request), silent};
    const wordList fields
    (
        args.getOrDefault
        (
            "fields", wordList({"isotropic", "anisotropic", "gradientPower"})
        )
    );

    for (const word& field : fields)
    {
        controls.field.tensor = field;
        measure(in, controls.field);
    }

    return 0;
}


// ************************************************************************* //
