/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    moveNumbers

Description
    What half and double of each tuned number of the moves do to the layers.

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
#include "cpuTime.H"
#include "memoryMesh.H"
#include "patchReport.H"
#include "polyMeshTools.H"
#include "preparedCase.H"
#include "prismLayerMesh.H"
#include "throwingErrors.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

typedef layerMoveControls tuned;


//- A tuned number: a scalar, a label, or a list of scalars
class tunedNumber
{
    scalar tuned::* scalar_ = nullptr;
    label tuned::* label_ = nullptr;
    scalarList tuned::* list_ = nullptr;

    //- Whether its distance from 1 is what counts
    bool fromOne_ = false;

public:

    const char* name;

    tunedNumber(const char* n, scalar tuned::* number, bool fromOne = false)
    :
        scalar_(number),
        fromOne_(fromOne),
        name(n)
    {}

    tunedNumber(const char* n, label tuned::* number)
    :
        label_(number),
        name(n)
    {}

    tunedNumber(const char* n, scalarList tuned::* numbers)
    :
        list_(numbers),
        name(n)
    {}

    string text(const tuned& controls) const
    {
        if (label_)
        {
            return Foam::name(controls.*label_);
        }

        string text;
        for
        (
            const scalar value
          : list_ ? controls.*list_ : scalarList(1, controls.*scalar_)
        )
        {
            text += (text.empty() ? "" : ", ") + Foam::name(value);
        }

        return text;
    }

    //- Name, value, and changed value, between tabs
    string change(const tuned& changed) const
    {
        return string(name) + '\t' + text(tuned()) + '\t' + text(changed);
    }

    void scale(tuned& controls, const scalar factor) const
    {
        if (label_)
        {
            controls.*label_ = label(factor*(controls.*label_) + 0.5);
        }
        else if (list_)
        {
            for (scalar& value : controls.*list_)
            {
                value *= factor;
            }
        }
        else
        {
            scalar& value = controls.*scalar_;
            value = fromOne_ ? 1 + factor*(value - 1) : factor*value;
        }
    }
};


static const std::initializer_list<tunedNumber> numbers =
{
    {"minJacobian", &tuned::minJacobian},
    {"goodJacobian", &tuned::goodJacobian},
    {"centreJacobian", &tuned::centreJacobian},
    {"maxCentreTries", &tuned::maxCentreTries},
    {"retreatFactor", &tuned::retreatFactor, true},
    {"straightenShare", &tuned::straightenShare},
    {"shortShare", &tuned::shortShare},
    {"tallShare", &tuned::tallShare, true},
    {"hopelessShare", &tuned::hopelessShare},
    {"maxTurns", &tuned::maxTurns},
    {"turnShare", &tuned::turnShare, true},
    {"maxLeans", &tuned::maxLeans},
    {"leanGain", &tuned::leanGain, true},
    {"leanSize", &tuned::leanSize},
    {"nLeanSides", &tuned::nLeanSides},
    {"maxRounds", &tuned::maxRounds},
    {"angleMargin", &tuned::angleMargin},
    {"skewnessShare", &tuned::skewnessShare, true},
    {"targetPlanarity", &tuned::targetPlanarity},
    {"planarityWeight", &tuned::planarityWeight},
    {"targetJacobian", &tuned::targetJacobian},
    {"jacobianShare", &tuned::jacobianShare},
    {"jacobianWeight", &tuned::jacobianWeight},
    {"targetGain", &tuned::targetGain},
    {"gainWeight", &tuned::gainWeight},
    {"maxGain", &tuned::maxGain},
    {"largeGainWeight", &tuned::largeGainWeight},
    {"firstHeightWeight", &tuned::firstHeightWeight},
    {"thicknessWeight", &tuned::thicknessWeight},
    {"heightSlack", &tuned::heightSlack},
    {"displacementWeight", &tuned::displacementWeight},
    {"lowFirstHeightWeight", &tuned::lowFirstHeightWeight},
    {"lowThicknessWeight", &tuned::lowThicknessWeight},
    {"bendGain", &tuned::bendGain, true},
    {"maxBend", &tuned::maxBend},
    {"maxBends", &tuned::maxBends},
    {"heightTolerance", &tuned::heightTolerance},
    {"largeTolerance", &tuned::largeTolerance},
    {"thicknessTolerance", &tuned::thicknessTolerance},
    {"reaches", &tuned::reaches},
    {"thicknessReach", &tuned::thicknessReach},
    {"nRings", &tuned::nRings},
    {"maxDisplacement", &tuned::maxDisplacement},
    {"maxLowerings", &tuned::maxLowerings},
    {"leftOutShare", &tuned::leftOutShare},
    {"damping", &tuned::damping},
    {"maxExcess", &tuned::maxExcess, true},
    {"maxHeightJump", &tuned::maxHeightJump, true},
    {"maxLimits", &tuned::maxLimits},
    {"maxSweeps", &tuned::maxSweeps},
    {"leastForJump", &tuned::leastForJump, true},
    {"leastOverNeighbour", &tuned::leastOverNeighbour, true},
    {"slack", &tuned::slack}
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
                m.share.front,
                m.guide.spacing.at(m.share.front.wallPoints), m.columns,
                controls
            )
        );
        const scalar seconds = time.elapsedCpuTime();

        const faceHeights heights
        (
            makeFaceHeights(wall, m.request, made.layers)
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

    measure(wall, m, tuned(), "as they are\t\t");

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
                tuned changed;
                number.scale(changed, factor);
                measure(wall, m, changed, number.change(changed));
            }
        }
    }

    return 0;
}


// ************************************************************************* //
