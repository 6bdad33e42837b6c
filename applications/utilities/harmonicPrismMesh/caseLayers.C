/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseLayers.H"
#include "divideMesh.H"
#include "prismQuality.H"
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

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::caseLayers::takeLayers
(
    const wallSurface& wall,
    const bool hasFarField,
    const bool hasPolygons,
    prismLayerMesh& mesh
)
{
    const processTeam& team = parallel_.team();
    const bool isAlone = team.size() == 1;
    layers_ = std::move(mesh.made.layers);
    const bool hasSides = !hasFarField && endOnParts(layers_);

    if (!isAlone && (hasFarField || hasPolygons || hasSides))
    {
        whole_ = layersOnMaster(layers_, mesh.share, wall, team);
    }
    if (hasSides && team.isMaster())
    {
        surfaces_.sides.reset(new wallSurface(sideSurface(wholeLayers())));
    }
    if (hasFarField || hasSides)
    {
        const wallSurface outer(outerPolygons(wholeLayers()));
        surfaces_.outer = outerSurface{outer.points, outer.faces};
    }
    else
    {
        surfaces_.outer = outerOnMaster(layers_, mesh.share, wall, team);
    }
    if (!hasFarField && !hasPolygons)
    {
        whole_ = prismLayers();
    }
    labels_ = std::move(mesh.share);
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
    const stageViewer& view
)
:
    parallel_(parallel)
{
    inTeam(parallel, [&]()
    {
        const processTeam& team = parallel.team();
        prismLayerMesh mesh
        (
            makePrismLayerMesh
            (
                wall, controls, local, observer, bool(view), team
            )
        );
        report_ = makeLayerReport(wall, mesh, columnTeam(mesh.share, team));
        if (view)
        {
            view(mesh);
        }
        takeLayers
        (
            wall, controls.farField.isWanted(), controls.polygons, mesh
        );

        return true;
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::meshPiece Foam::caseLayers::makePiece(farFieldMesh& farField)
{
    return inTeam(parallel_, [&]()
    {
        const prismLayers own(std::move(layers_));
        const prismLayers whole(std::move(whole_));
        meshPiece piece(makeMeshPiece
        (
            own, columnTeam(labels_, parallel_.team()), whole, farField,
            [&](const meshParts& parts) { return parallel_.divide(parts); }
        ));
        setCosts();

        return piece;
    });
}


Foam::meshPiece Foam::caseLayers::makePiece(polygonMesh&& polygons)
{
    return inTeam(parallel_, [&]()
    {
        const label nLayers = layers_.nLayers;
        layers_ = prismLayers();
        whole_ = prismLayers();
        meshPiece piece(makeMeshPiece
        (
            stackedMesh
            {
                std::move(polygons.mesh), polygons.counts.nLayerCells, nLayers
            },
            parallel_.team(),
            [&](const meshParts& parts) { return parallel_.divide(parts); }
        ));
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
        parallel, wallSurface(), controls, localHeights(), silent, nullptr
    );

    if (controls.farField.isWanted() || controls.polygons)
    {
        parallel.begin();
    }
    farFieldMesh noFarField;

    return
        controls.polygons
      ? layers.makePiece(polygonMesh()) : layers.makePiece(noFarField);
}


// ************************************************************************* //
