/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLayers.H"
#include "divideMesh.H"
#include "layerSurfaces.H"
#include "readPrismLayerControls.H"
#include "returnMemory.H"
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
                << "There is not enough memory" << exit(FatalError);
            throw;
        }
    };
    try
    {
        return parallel.isParallel()
          ? parallel.team().guard(workInMemory) : workInMemory();
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
    order.addText(text.str());

    List<message> all(team.size(), order);
    all[team.rank()].clear();

    return all;
}


//- The layers of all processes as layers() of caseLayers has them
static prismLayers gathered
(
    const wallSurface& wall,
    const prismLayerMesh& mesh,
    const columnTeam& team,
    const bool hasFarField
)
{
    const prismLayers& own = mesh.made.layers;
    if (hasFarField || endOnParts(own))
    {
        return gatherLayers
        (
            wall, mesh.front, own.points, own.nLayers, team
        );
    }

    pointField ends(2*own.nColumns());
    for (label c = 0; c < own.nColumns(); ++c)
    {
        ends[2*c] = own(c, 0);
        ends[2*c + 1] = own(c, own.nLayers);
    }

    return gatherLayers(wall, mesh.front, ends, 1, team);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::columnTeam Foam::caseLayers::team() const
{
    return columnTeam(mesh_.share.get(), &parallel_.team());
}


void Foam::caseLayers::setCosts()
{
    const processTeam& team = parallel_.team();
    const scalarList peaks(team.gather(scalarList(1, peakMemory())));
    const scalarList sent
    (
        team.gather(scalarList(1, 1e-6*team.nBytesSent()))
    );
    costs_.add("number", team.size());
    costs_.add("exchanges", team.nCalls());
    costs_.add("sentMB", sent);
    costs_.add("peakMemoryMB", peaks);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::caseLayers::caseLayers
(
    const parallelRun& parallel,
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const bool keepStages
)
:
    parallel_(parallel)
{
    inTeam(parallel, [&]()
    {
        mesh_ = makePrismLayerMesh
        (
            wall, controls, local, observer, keepStages,
            parallel.isParallel() ? &parallel.team() : nullptr
        );
        report_ = makeLayerReport(wall, mesh_, team());

        if (mesh_.share)
        {
            whole_ = gathered
            (
                wall, mesh_, team(), controls.farField.isWanted()
            );
        }

        return true;
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::meshPiece Foam::caseLayers::makePiece()
{
    return inTeam(parallel_, [&]()
    {
        meshPiece piece(makeMeshPiece
        (
            mesh_.made.layers, team(), whole_, mesh_.farField,
            [&](const meshParts& parts) { return parallel_.divide(parts); }
        ));
        mesh_ = prismLayerMesh();
        whole_ = prismLayers();
        returnMemory();
        setCosts();

        return piece;
    });
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::sendOrder
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


Foam::meshPiece Foam::makePieceForMaster(const parallelRun& parallel)
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
    caseLayers layers
    (
        parallel, wallSurface(), controls, localHeights(), silent, false
    );

    if (controls.farField.isWanted())
    {
        parallel.begin();
    }

    return layers.makePiece();
}


// ************************************************************************* //
