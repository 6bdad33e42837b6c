/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    moveNumbers

Description
    What half and double of the tuned numbers of the moves do to the layers.

    Reads the wall and system/harmonicPrismMeshDict of the case, makes all that
    stands before the moves once, and then the layers with each of the numbers
    halved and doubled; of shares and ratios near 1 their distance from 1 is.
    Prints a line, between tabs, for each: number, its value, the changed value,
    share of the wall's area at full thickness [%], mean thickness over the
    request, share of faces with a first height within 1 % [%], worst scaled
    Jacobian, internal faces beyond 70 degrees, seconds of the moves.

Usage
    moveNumbers [-numbers '(name ...)'] [-factors '(0.5 2)']

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "throwingErrors.H"
#include "cpuTime.H"
#include "faceHeights.H"
#include "memoryMesh.H"
#include "polyMeshTools.H"
#include "preparedCase.H"
#include "prismLayerMesh.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef layerMoveControls tuned;


//- A tuned number, a scalar or a label
struct tunedNumber
{
    const char* name;
    scalar layerMoveControls::* value;
    label layerMoveControls::* count;

    //- Whether its distance from 1 is what counts
    bool fromOne;

    scalar in(const layerMoveControls& controls) const
    {
        return count ? scalar(controls.*count) : controls.*value;
    }

    //- Name, value, and changed value, between tabs
    string change(const layerMoveControls& changed) const
    {
        return string(name) + '\t' + Foam::name(in(layerMoveControls()))
          + '\t' + Foam::name(in(changed));
    }

    void scale(layerMoveControls& controls, const scalar factor) const
    {
        if (count)
        {
            controls.*count = label(factor*(controls.*count) + 0.5);
        }
        else if (fromOne)
        {
            controls.*value = 1 + factor*(controls.*value - 1);
        }
        else
        {
            controls.*value *= factor;
        }
    }
};


static const std::initializer_list<tunedNumber> numbers =
{
    {"minJacobian", &tuned::minJacobian, nullptr, false},
    {"goodJacobian", &tuned::goodJacobian, nullptr, false},
    {"centreJacobian", &tuned::centreJacobian, nullptr, false},
    {"maxCentreTries", nullptr, &tuned::maxCentreTries, false},
    {"retreatFactor", &tuned::retreatFactor, nullptr, true},
    {"straightenShare", &tuned::straightenShare, nullptr, false},
    {"shortShare", &tuned::shortShare, nullptr, false},
    {"tallShare", &tuned::tallShare, nullptr, true},
    {"hopelessShare", &tuned::hopelessShare, nullptr, false},
    {"maxTurns", nullptr, &tuned::maxTurns, false},
    {"turnShare", &tuned::turnShare, nullptr, true},
    {"maxLeans", nullptr, &tuned::maxLeans, false},
    {"leanGain", &tuned::leanGain, nullptr, true},
    {"leanSize", &tuned::leanSize, nullptr, false},
    {"nLeanSides", nullptr, &tuned::nLeanSides, false},
    {"maxRounds", nullptr, &tuned::maxRounds, false},
    {"angleMargin", &tuned::angleMargin, nullptr, false},
    {"skewnessShare", &tuned::skewnessShare, nullptr, true},
    {"targetJacobian", &tuned::targetJacobian, nullptr, false},
    {"jacobianShare", &tuned::jacobianShare, nullptr, false},
    {"jacobianWeight", &tuned::jacobianWeight, nullptr, false},
    {"targetPlanarity", &tuned::targetPlanarity, nullptr, false},
    {"planarityWeight", &tuned::planarityWeight, nullptr, false},
    {"firstHeightWeight", &tuned::firstHeightWeight, nullptr, false},
    {"thicknessWeight", &tuned::thicknessWeight, nullptr, false},
    {"heightSlack", &tuned::heightSlack, nullptr, false},
    {"displacementWeight", &tuned::displacementWeight, nullptr, false},
    {"lowFirstHeightWeight", &tuned::lowFirstHeightWeight, nullptr, false},
    {"lowThicknessWeight", &tuned::lowThicknessWeight, nullptr, false},
    {"bendGain", &tuned::bendGain, nullptr, true},
    {"bendSlack", &tuned::bendSlack, nullptr, false},
    {"maxBend", &tuned::maxBend, nullptr, false},
    {"maxBends", nullptr, &tuned::maxBends, false},
    {"heightTolerance", &tuned::heightTolerance, nullptr, false},
    {"largeTolerance", &tuned::largeTolerance, nullptr, false},
    {"thicknessTolerance", &tuned::thicknessTolerance, nullptr, false},
    {"thicknessReach", &tuned::thicknessReach, nullptr, false},
    {"nRings", nullptr, &tuned::nRings, false},
    {"maxDisplacement", &tuned::maxDisplacement, nullptr, false},
    {"maxLowerings", nullptr, &tuned::maxLowerings, false},
    {"leftOutShare", &tuned::leftOutShare, nullptr, false},
    {"damping", &tuned::damping, nullptr, false},
    {"maxExcess", &tuned::maxExcess, nullptr, true},
    {"maxHeightJump", &tuned::maxHeightJump, nullptr, true},
    {"maxLimits", nullptr, &tuned::maxLimits, false},
    {"maxSweeps", nullptr, &tuned::maxSweeps, false},
    {"leastForJump", &tuned::leastForJump, nullptr, true},
    {"leastOverNeighbour", &tuned::leastOverNeighbour, nullptr, true},
    {"slack", &tuned::slack, nullptr, false}
};


static label nSteepFaces(const prismLayers& layers)
{
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();
    const scalarField cosines
    (
        polyMeshTools::faceOrthogonality
        (
            mesh, mesh.faceAreas(), mesh.cellCentres()
        )
    );

    label nSteep = 0;
    for (label facei = 0; facei < mesh.nInternalFaces(); ++facei)
    {
        nSteep += cosines[facei] < ::cos(70*constant::mathematical::pi/180);
    }

    return nSteep;
}


static void measure
(
    const wallSurface& wall,
    const prismLayerMesh& m,
    const layerMoveControls& controls,
    const string& what
)
{
    Info<< what.c_str();

    try
    {
        const cpuTime time;
        const madeLayers made
        (
            makePrismLayers
            (
                m.front, m.guide.spacing.at(m.front.wallPoints), m.columns,
                controls
            )
        );
        const scalar seconds = time.elapsedCpuTime();

        const faceHeights heights
        (
            makeFaceHeights(wall, m.heights.request, made.layers)
        );
        const label n = wall.faces.size();
        scalar full = 0, mean = 0;
        label nExact = 0;

        forAll(wall.faces, facei)
        {
            const scalar total = heights.totalOverRequest[facei];
            full += total >= 0.99 ? heights.areas[facei] : 0;
            mean += total*heights.areas[facei];
            nExact += mag(heights.firstOverRequest[facei] - 1) < 0.01;
        }

        const scalar area = sum(heights.areas);
        Info<< '\t' << 100*full/area << '\t' << mean/area << '\t'
            << 100.0*nExact/n << '\t' << min(certify(made.layers).worstJacobian)
            << '\t' << nSteepFaces(made.layers) << '\t' << seconds << endl;
    }
    catch (const Foam::error&)
    {
        Info<< "\tno layers" << endl;
    }
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noBanner();
    argList::addOption("numbers", "list", "Only these");
    argList::addOption("factors", "list", "Instead of 0.5 and 2");

    #include "setRootCase.H"
    #include "createTime.H"

    const preparedCase given(runTime);
    const wallSurface& wall = given.wall;
    const throwingErrors throwing;
    const prismLayerMesh m(makePrismLayerMesh(wall, given.controls, {}, {}));
    const wordList only(args.getOrDefault("numbers", wordList()));

    measure(wall, m, layerMoveControls(), "as they are\t\t");

    for (const tunedNumber& number : numbers)
    {
        for
        (
            const scalar factor
          : args.getOrDefault("factors", scalarList({0.5, 2}))
        )
        {
            if (only.empty() || only.found(number.name))
            {
                layerMoveControls changed;
                number.scale(changed, factor);
                measure(wall, m, changed, number.change(changed));
            }
        }
    }

    return 0;
}


// ************************************************************************* //
