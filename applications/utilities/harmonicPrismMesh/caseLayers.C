/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLayers.H"
#include "divideMesh.H"
#include "gatherShares.H"
#include "readPrismLayerControls.H"
#include "StringStream.H"
#include "throwingErrors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Returns work(). If it fails, all processes of the team end what they do, and
//  FatalError has the reason.
template<class Work>
static auto inTeam(const parallelRun& parallel, const Work& work)
{
    const throwingErrors throwing(true);
    const auto workInMemory = [&]()
    {
        try
        {
            return work();
        }
        catch (const std::bad_alloc&)
        {
            FatalErrorInFunction
                << "There is not enough memory for the layers. Ask for fewer"
                << " layers, or for larger faces (surface.remesh.maxEdge)"
                << exit(FatalError);
            throw;
        }
    };
    try
    {
        return parallel.team().guard(workInMemory);
    }
    catch (const teamError& e)
    {
        FatalErrorInFunction
            << "Another process has failed: " << e.what() << exit(FatalError);
        throw;
    }
}


//- What the other processes need, for all of them
static List<message> orders
(
    const processTeam& team,
    const dictionary& dict
)
{
    OStringStream text;
    text.precision(17);
    dict.write(text, false);

    message order;
    order(text.str());

    List<message> all(team.size(), order);
    all[team.rank()].clear();

    return all;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

caseLayers makeCaseLayers
(
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const stageViewer& view
)
{
    return inTeam(parallel, [&]()
    {
        const processTeam& team = parallel.team();
        caseLayers made;
        prismLayers own;
        frontShare share;
        {
            prismLayerMesh mesh
            (
                makePrismLayerMesh
                (
                    wall, controls, local, observer, bool(view), team
                )
            );
            made.report =
                makeLayerReport(wall, mesh, columnTeam(mesh.share, team));
            if (view)
            {
                view(mesh);
            }
            own = std::move(mesh.made.layers);
            share = std::move(mesh.share);
        }
        made.layers =
            team.size() == 1
          ? std::move(own) : layersOnMaster(own, share, wall, team);

        return made;
    });
}


meshPiece makePieces
(
    const parallelRun& parallel,
    const meshInBlocks& mesh,
    dictionary& costs
)
{
    parallel.begin();

    return inTeam(parallel, [&]()
    {
        const processTeam& team = parallel.team();
        meshPiece piece
        (
            makeMeshPiece
            (
                mesh, team,
                [&](const meshParts& parts) { return parallel.divide(parts); }
            )
        );
        const scalarList peaks(team.gather(scalarList(1, peakMemory())));
        const scalarList sent
        (
            team.gather(scalarList(1, 1e-6*team.nBytesSent()))
        );
        costs.add("number", team.size());
        costs.add("exchanges", team.nCalls());
        costs.add("sentMB", sent);
        costs.add("peakMemoryMB", peaks);

        return piece;
    });
}


void sendOrder
(
    const parallelRun& parallel,
    const dictionary& dict
)
{
    if (parallel.isParallel())
    {
        parallel.begin();
        parallel.team().exchange(orders(parallel.team(), dict));
    }
}


meshPiece makePieceForMaster(const parallelRun& parallel)
{
    const stageObserver silent{[](const word&) {}, [](const string&) {}};
    const label n = parallel.size();
    parallel.begin();
    const List<message> received
    (
        parallel.team().exchange(List<message>(n))
    );
    messageReader reader(received[0]);
    IStringStream text(reader.text());
    const prismLayerControls controls(readPrismLayerControls(dictionary(text)));
    makeCaseLayers
    (
        parallel, wallSurface(), controls, localHeights(), silent, nullptr
    );
    dictionary costs;

    return makePieces(parallel, meshInBlocks(), costs);
}

} // End namespace Foam

// ************************************************************************* //
