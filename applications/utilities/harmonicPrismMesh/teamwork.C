/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "teamwork.H"
#include "OSspecific.H"
#include "pstreamTeam.H"
#include "readPrismLayerControls.H"
#include "StringStream.H"
#include "throwingErrors.H"
#include "wallMessages.H"
#include "wallPointsError.H"
#include "writeStageFields.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static pstreamTeam teamOf(const parallelRun& parallel)
{
    return pstreamTeam(parallel.size(), parallel.processor());
}


//- What the other processes need, for all of them
static List<message> orders
(
    const processTeam& team,
    const dictionary& dict,
    const wallSurface& wall,
    const localHeights& local
)
{
    OStringStream text;
    text.precision(17);
    dict.write(text, false);

    message order;
    addText(order, text.str());
    addWall(order, wall);
    addHeights(order, local);

    List<message> all(team.size(), order);
    all[team.rank()].clear();

    return all;
}


//- Call work(). If it fails, all processes of the team end their work, and the
//  error is thrown again.
template<class Work>
static auto inTeam(const processTeam& team, const Work& work)
{
    try
    {
        const throwingErrors throwing;

        return work();
    }
    catch (const teamError&)
    {
        throw;
    }
    catch (const Foam::error& e)
    {
        team.fail(e.message());
        throw;
    }
    catch (const std::exception& e)
    {
        team.fail(e.what());
        throw;
    }
}


//- On the master: makes the layers with the other processes
static prismLayerMesh makeWithTeam
(
    const processTeam& team,
    const dictionary& dict,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer
)
{
    return inTeam(team, [&]()
    {
        team.exchange(orders(team, dict, wall, local));

        return makePrismLayerMesh
        (
            wall, controls, local, observer, false, &team
        );
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerMesh makeLayers
(
    const prismCase& files,
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const bool keepStages,
    stageLog& log
)
{
    try
    {
        if (!parallel.sharesLayers(!keepStages))
        {
            return makePrismLayerMesh
            (
                wall, controls, local, log.observer(), keepStages
            );
        }

        return makeWithTeam
        (
            teamOf(parallel), files.dict(),
            wall, controls, local, log.observer()
        );
    }
    catch (const wallPointsError& failure)
    {
        mkDir(files.reportFolder());
        writeFailedPoints(files.failedPointsFile(), failure);

        FatalErrorInFunction
            << failure.message().c_str() << nl
            << "Their places are in " << files.failedPointsFile()
            << exit(FatalError);
    }
    catch (const teamError& failure)
    {
        FatalErrorInFunction
            << "Another process has failed: " << failure.what()
            << exit(FatalError);
    }
    catch (Foam::error& failure)
    {
        failure.throwExceptions(false);
        failure.exit();
    }

    return prismLayerMesh();
}


bool helpMaster(const parallelRun& parallel)
{
    if (!parallel.sharesLayers(false))
    {
        return true;
    }

    const pstreamTeam team(teamOf(parallel));
    const stageObserver silent{[](const word&) {}, [](const string&) {}};

    try
    {
        inTeam(team, [&]()
        {
            const List<message> received
            (
                team.exchange(List<message>(team.size()))
            );
            messageReader reader(received[0]);
            IStringStream text(takeText(reader));
            const prismLayerControls controls
            (
                readPrismLayerControls(dictionary(text))
            );
            const wallSurface wall(takeWall(reader));
            const localHeights local(takeHeights(reader));

            return makePrismLayerMesh
            (
                wall, controls, local, silent, false, &team
            );
        });
    }
    catch (const Foam::error&)
    {
        return false;
    }
    catch (const std::exception&)
    {
        return false;
    }

    return true;
}

} // End namespace Foam

// ************************************************************************* //
