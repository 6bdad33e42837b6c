/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parallelRun.H"
#include "decompositionMethod.H"
#include "hostThreads.H"
#include "IOdictionary.H"
#include "IPstream.H"
#include "OPstream.H"
#include "pieceMessages.H"
#include "pstreamTeam.H"
#include "returnMemory.H"
#include "Time.H"

#include <unistd.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- How often a process that waits looks for the master [microseconds]. Waiting
//  messages of MPI keep a processor busy, which the master's threads need.
static const unsigned lookInterval = 5000;

//- What the master sends: a piece of a mesh, or of layers
enum class pieceKind : char { mesh, layers };

static const auto blocking = UPstream::commsTypes::scheduled;


//- Means of the centres of the faces of cells. Centres of cells, and all else
//  that a polyMesh makes with them, would take more memory than the mesh.
static pointField centresOfFaces(const polyMesh& mesh)
{
    pointField centres(mesh.nCells(), Zero);
    labelList nFaces(mesh.nCells(), 0);
    const auto add = [&](const label celli, const point& x)
    {
        centres[celli] += x;
        ++nFaces[celli];
    };

    forAll(mesh.faces(), facei)
    {
        const point x(mesh.faces()[facei].centre(mesh.points()));
        add(mesh.faceOwner()[facei], x);
        if (mesh.isInternalFace(facei))
        {
            add(mesh.faceNeighbour()[facei], x);
        }
    }
    forAll(centres, celli)
    {
        centres[celli] /= nFaces[celli];
    }

    return centres;
}


static void sendByte(const char byte, const label process)
{
    UOPstream::write(blocking, process, &byte, 1);
}


//- Says which kind of piece comes next
static void sendKind(const pieceKind kind, const label process)
{
    sendByte(char(kind), process);
}


//- Sleeps until a byte of the master arrives
static char awaitByte()
{
    char byte = 0;
    const label request = UPstream::nRequests();
    UIPstream::read(UPstream::commsTypes::nonBlocking, 0, &byte, 1);
    while (!UPstream::finishedRequest(request))
    {
        usleep(lookInterval);
    }
    UPstream::resetRequests(request);

    return byte;
}


//- By stack of layers, and by other cell: the processes of all cells
static labelList processorsOfCells
(
    const decompositionMethod& decomposition,
    const polyMesh& mesh,
    const label nStacks,
    const label nLayers
)
{
    const label nLayerCells = nStacks*nLayers;
    const label nParts = nStacks + mesh.nCells() - nLayerCells;
    const pointField cellCentres(centresOfFaces(mesh));
    labelList parts(mesh.nCells());
    pointField centres(nParts, Zero);
    scalarField weights(nParts, Zero);

    forAll(parts, celli)
    {
        parts[celli] = celli < nLayerCells
          ? celli/nLayers : nStacks + celli - nLayerCells;
        centres[parts[celli]] += cellCentres[celli];
        weights[parts[celli]] += 1;
    }
    centres /= weights;

    return decomposition.decompose(mesh, parts, centres, weights);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

parallelRun::parallelRun(const Time& time)
:
    parallel_(UPstream::parRun()),
    nProcesses_(parallel_ ? UPstream::nProcs() : 1),
    processor_(parallel_ ? UPstream::myProcNo() : 0)
{
    const label nThreads = parallel_ ? useThreadsOfHost() : 1;
    if (parallel_)
    {
        decomposeParDict_ = IOdictionary
        (
            IOobject
            (
                "decomposeParDict", time.system(), time,
                IOobject::MUST_READ, IOobject::NO_WRITE, false
            )
        );
    }

    setParallel(false);

    if (parallel_ && isMaster())
    {
        const label n = decomposeParDict_.get<label>("numberOfSubdomains");
        if (n != nProcesses_)
        {
            FatalErrorInFunction
                << "numberOfSubdomains of decomposeParDict is " << n
                << ", but there are " << nProcesses_ << " processes"
                << exit(FatalError);
        }
        decomposition_ = decompositionMethod::New(decomposeParDict_);
        Info<< "The master makes the mesh on " << nThreads << " threads" << nl
            << endl;
    }
}


parallelRun::~parallelRun()
{
    setParallel(parallel_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

meshPiece parallelRun::sendPieces(prismLayers& layers) const
{
    layersPiece ofMaster;
    {
        const layersDivider divider(layers);
        const pointField centres(divider.centres());
        const labelList processors
        (
            decomposition_->decompose
            (
                divider.neighbours(), centres, scalarField(centres.size(), 1)
            )
        );

        for (label other = 1; other < nProcesses_; ++other)
        {
            sendKind(pieceKind::layers, other);
            sendPiece(divider.piece(processors, other), other);
        }
        ofMaster = divider.piece(processors, 0);
    }
    layers = prismLayers();
    returnMemory();

    return makeMeshPiece(ofMaster, 0);
}


meshPiece parallelRun::sendPieces
(
    const polyMesh& mesh,
    const label nStacks,
    const label nLayers
) const
{
    const labelList processors
    (
        processorsOfCells(decomposition_(), mesh, nStacks, nLayers)
    );

    for (label other = 1; other < nProcesses_; ++other)
    {
        sendKind(pieceKind::mesh, other);
        sendPiece(makeMeshPiece(mesh, processors, other), other);
    }

    return makeMeshPiece(mesh, processors, 0);
}


void parallelRun::requireWritten() const
{
    string failure;
    for (label other = 1; other < nProcesses_; ++other)
    {
        string message;
        IPstream stream(blocking, other);
        stream >> message;
        if (failure.empty() && message.size())
        {
            failure = "Process " + name(other) + ": " + message;
        }
    }
    for (label other = 1; other < nProcesses_; ++other)
    {
        OPstream stream(blocking, other);
        stream << failure.empty();
    }

    if (failure.size())
    {
        FatalErrorInFunction << failure.c_str() << exit(FatalError);
    }
}


bool parallelRun::sharesLayers(const bool saysMaster) const
{
    if (!isMaster())
    {
        return awaitByte();
    }
    for (label other = 1; other < nProcesses_; ++other)
    {
        sendByte(saysMaster, other);
    }

    return saysMaster && isParallel();
}


meshPiece parallelRun::receivePiece() const
{
    const pieceKind kind = pieceKind(awaitByte());

    return kind == pieceKind::mesh
      ? receiveMeshPiece(0)
      : makeMeshPiece(receiveLayersPiece(0), processor_);
}


bool parallelRun::reportWritten(const string& message) const
{
    {
        OPstream stream(blocking, 0);
        stream << message;
    }

    bool all = false;
    IPstream stream(blocking, 0);
    stream >> all;

    return all;
}

} // End namespace Foam

// ************************************************************************* //
