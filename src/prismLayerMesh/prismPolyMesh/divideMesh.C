/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "divideMesh.H"
#include "pieceMessages.H"
#include "prismFaces.H"
#include "prismPolyMesh.H"
#include "StringStream.H"
#include "SubField.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The faces that the far field adds to the whole mesh
struct facesOfFarField
{
    label nInternal = 0;
    labelList patchSizes;

    //- See farFieldMesh
    labelList frontFaces;
};


//- The counted stacks of a share
struct countedStacks
{
    const prismLayers& layers;
    const columnTeam& team;

    //- Of counted front faces; those of others are 0
    labelListList neighbours;

    //- Edges of counted front faces, in as many lists as on other processes
    List<DynamicList<labelPair>> open;

    //- By front face of the share; what is counted here is set
    List<meshStack> stacks;

    //- The first sides on the edges of each list of open edges. The first sides
    //  of one edge after the other follow in steps of the number of layers.
    List<labelList> openSides;

    //- Collective
    countedStacks(const prismLayers& own, const columnTeam& t)
    :
        layers(own),
        team(t),
        neighbours(findFaceNeighbours(own)),
        stacks(own.faces.size())
    {
        forAll(neighbours, facei)
        {
            if (!isCounted(facei))
            {
                neighbours[facei] = 0;
            }
        }
        open = openEdges(layers, neighbours);
        open.setSize
        (
            team.reduce
            (
                open.size(), [](label a, label b) { return max(a, b); }
            )
        );
    }

    bool isCounted(const label facei) const
    {
        return team.countsFace(facei);
    }
};

} // End anonymous namespace


//- Sets the internal faces of the stacks. Returns the number of internal faces
//  of all stacks. Collective
static label setInternalFaces(const facesOfFarField& far, countedStacks& share)
{
    const label n = share.layers.nLayers;
    labelList strides(share.stacks.size());
    forAll(strides, facei)
    {
        strides[facei] = 1 + nHigherNeighbours(share.neighbours[facei], facei);
    }
    strides = share.team.faces.onAll(strides);

    // Each face of the far field on a stack is an internal face of the stack
    labelList firstFaces(strides.size());
    label next = 0;
    label nOnFar = 0;
    forAll(strides, facei)
    {
        firstFaces[facei] = next + nOnFar;
        next += n*strides[facei] - 1;
        while
        (
            nOnFar < far.frontFaces.size() && far.frontFaces[nOnFar] == facei
        )
        {
            ++nOnFar;
        }
    }
    forAll(share.stacks, facei)
    {
        const label whole = share.team.wholeFace(facei);
        share.stacks[facei].stack = whole;
        share.stacks[facei].firstFace = firstFaces[whole];
        share.stacks[facei].stride = strides[whole];
    }

    return next + nOnFar;
}


//- Sets the faces on the patches of the wall, of which the first one is 'next'.
//  Returns the first face behind them. Collective
static label setWallFaces(label next, countedStacks& share)
{
    const prismLayers& layers = share.layers;
    labelList patches(layers.faces.size(), -1);
    SubList<label>(patches, layers.nWallFaces()) = layers.patchIDs;
    labelList wallFaces(share.team.faces.onAll(patches));
    for (const labelList& ofPatch : invertOneToMany
        (
            layers.patchNames.size(), wallFaces
        ))
    {
        for (const label facei : ofPatch)
        {
            wallFaces[facei] = next++;
        }
    }
    forAll(patches, facei)
    {
        share.stacks[facei].patch = patches[facei];
        share.stacks[facei].wallFace = wallFaces[share.team.wholeFace(facei)];
    }

    return next;
}


//- Sets the sides on a list of open edges, of which the first one is 'first'.
//  Returns the first face behind them. Collective
static label setOpenSides
(
    const label i,
    const label first,
    countedStacks& share
)
{
    const label n = share.layers.nLayers;
    List<labelPair> whole(share.open[i]);
    for (labelPair& e : whole)
    {
        e.first() = share.team.wholeFace(e.first());
    }
    List<labelPair> all(share.team.gather(whole));
    std::sort(all.begin(), all.end());

    labelList& sides = share.openSides[i];
    sides.setSize(whole.size());
    forAll(whole, k)
    {
        const label at =
            std::lower_bound(all.begin(), all.end(), whole[k]) - all.begin();
        sides[k] = first + at*n;
    }

    return first + all.size()*n;
}


//- Sets the labels that faces have in the whole mesh, also in the piece.
//  Collective
static void setLabels
(
    const facesOfFarField& far,
    countedStacks& share,
    meshPiece& piece
)
{
    const label nWall = share.layers.patchNames.size();
    share.openSides.setSize(share.open.size());

    label next = setInternalFaces(far, share) + far.nInternal;
    next = setWallFaces(next, share);
    for (label i = nWall; i < piece.patchParts.size(); ++i)
    {
        const labelPair& parts = piece.patchParts[i];
        if (parts.first() == nWall)
        {
            piece.firstOuter = next;
            next += share.team.faces.nWhole(share.layers.faces.size());
        }
        else if (parts.first() > nWall)
        {
            next = setOpenSides(parts.first() - nWall - 1, next, share);
        }
        if (parts.second() >= 0)
        {
            next += far.patchSizes[parts.second()];
        }
    }
}


//- Sets patches, zones and numbers of the whole mesh in a piece. The master
//  knows them. Returns the numbers of faces that the far field adds. Collective
static facesOfFarField setWholeMesh
(
    const countedStacks& share,
    const prismLayers& whole,
    farFieldMesh& far,
    meshPiece& piece
)
{
    const columnTeam& team = share.team;
    const prismLayers& layers = far.empty() ? share.layers : whole;
    const label nOpen = share.open.size();
    const meshPatches patches(patchesOfMesh(layers, nOpen, far));
    message ofMaster;
    wordList zones(far.cellZones.size());
    forAll(zones, i)
    {
        zones[i] = far.cellZones[i].name;
    }
    ofMaster
    (
        patches.names, patches.types(), partsOfPatches(layers, nOpen, far),
        zones, far.topology.neighbour.size(), far.topology.patchSizes,
        far.frontFaces
    );

    facesOfFarField faces;
    wordList names, types;
    const List<message> received
    (
        team.exchange(List<message>(team.size(), ofMaster))
    );
    messageReader reader(received[0]);
    reader
    (
        names, types, piece.patchParts, zones, faces.nInternal,
        faces.patchSizes, faces.frontFaces
    );
    forAll(names, i)
    {
        piece.patches.append(names[i], types[i]);
    }
    forAll(zones, i)
    {
        piece.far.cellZones.append(cellZoneParts(zones[i], labelList()));
    }
    piece.far.topology.patchSizes.setSize(faces.patchSizes.size(), 0);
    piece.layers.nLayers = share.layers.nLayers;
    piece.layers.patchNames = share.layers.patchNames;
    piece.open.setSize(nOpen);
    piece.process = team.rank();
    piece.nStacks = team.faces.nWhole(share.layers.faces.size());
    piece.nColumns = team.columns.nWhole(share.layers.nColumns());
    piece.nWallPoints = team.points.nWhole(share.layers.nWallPoints());

    return faces;
}


//- The stacks as parts, on the master. Collective
static meshParts partsOfLayers(const countedStacks& share)
{
    const columnTeam& team = share.team;
    DynamicList<labelPair> pairs;
    forAll(share.stacks, facei)
    {
        for (const label other : share.neighbours[facei])
        {
            if (other >= 0 && share.isCounted(facei))
            {
                pairs.append
                (
                    labelPair(team.wholeFace(facei), team.wholeFace(other))
                );
            }
        }
    }
    List<message> sent(team.size());
    sent[0](pairs);

    meshParts parts;
    parts.centres = team.faces.onMaster(centresOfStacks(share.layers));
    parts.weights = scalarField(parts.centres.size(), 1);
    parts.neighbours.setSize(parts.centres.size());
    for (const message& m : team.exchange(sent))
    {
        messageReader reader(m);
        if (!reader.atEnd())
        {
            for (const labelPair& pair : reader.list<labelPair>())
            {
                parts.neighbours[pair.first()].append(pair.second());
            }
        }
    }

    return parts;
}


//- Adds a counted stack to what is sent.
//  open: index of the list of open edges that each edge is in, or -1
static void addStack
(
    const countedStacks& share,
    const label facei,
    const labelUList& open,
    const labelUList& processOfStack,
    List<sentStacks>& sent
)
{
    const prismLayers& layers = share.layers;
    const columnTeam& team = share.team;
    const face& f = layers.faces[facei];
    const labelList& beside = share.neighbours[facei];
    const label whole = team.wholeFace(facei);
    sentStacks& own = sent[processOfStack[whole]];

    own.stacks.append(share.stacks[facei]);
    own.stacks.last().firstEdge = own.edges.size();
    own.stacks.last().nEdges = f.size();
    forAll(f, k)
    {
        const label other = beside[k] < 0 ? -1 : team.wholeFace(beside[k]);
        own.edges.append
        (
            stackEdge
            {
                team.wholeColumn(f[k]), team.wholeColumn(layers.root(f[k])),
                other, other < 0 ? -1 : processOfStack[other], open[k], -1, -1
            }
        );
    }

    const label stride = share.stacks[facei].stride;
    label side = share.stacks[facei].firstFace;
    visitInternalFaces
    (
        1, beside, facei,
        [&](const label k, label, const label higher)
        {
            // The other runs along the edge the other way
            const label other = team.wholeFace(higher);
            const label otherEdge = layers.faces[higher].find(f.nextLabel(k));
            own.sides.append(stackSide{whole, k, side, stride});
            sent[processOfStack[other]].sides.append
            (
                stackSide{other, otherEdge, side, stride}
            );
            ++side;
        }
    );
}


//- The stacks for each process
static List<message> stackMessages
(
    const countedStacks& share,
    const labelUList& processOfStack
)
{
    const prismLayers& layers = share.layers;
    List<sentStacks> sent(share.team.size());
    labelListList openOf(layers.faces.size());
    forAll(openOf, facei)
    {
        openOf[facei].setSize(layers.faces[facei].size(), -1);
    }
    forAll(share.open, i)
    {
        forAll(share.openSides[i], j)
        {
            const label facei = share.open[i][j].first();
            const label k = share.open[i][j].second();
            const label whole = share.team.wholeFace(facei);
            openOf[facei][k] = i;
            sent[processOfStack[whole]].sides.append
            (
                stackSide{whole, k, share.openSides[i][j], 1}
            );
        }
    }
    forAll(layers.faces, facei)
    {
        if (share.isCounted(facei))
        {
            addStack(share, facei, openOf[facei], processOfStack, sent);
        }
    }

    List<message> messages(sent.size());
    forAll(messages, p)
    {
        messages[p](sent[p].stacks, sent[p].edges, sent[p].sides);
    }

    return messages;
}


//- Set the points of a piece, from the owners of its columns. Collective
static void setPoints
(
    const prismLayers& own,
    const columnTeam& team,
    meshPiece& piece
)
{
    labelList owners(piece.columns.size());
    forAll(owners, c)
    {
        owners[c] = team.owner(piece.columns[piece.layers.root(c)]);
    }
    piece.layers.points = team.columns.at
    (
        piece.columns, owners, own.points, own.nLayers + 1
    );
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

pointField centresOfStacks(const prismLayers& layers)
{
    pointField centres(layers.faces.size(), Zero);
    const label n = layers.nLayers + 1;

    forAll(centres, facei)
    {
        const face& f = layers.faces[facei];
        for (const label c : f)
        {
            centres[facei] += sum(SubField<point>(layers.points, n, c*n));
        }
        centres[facei] /= f.size()*n;
    }

    return centres;
}


meshPiece makeMeshPiece
(
    const prismLayers& own,
    const columnTeam& team,
    const prismLayers& whole,
    farFieldMesh& far,
    const meshDivision& divide
)
{
    meshPiece piece;
    List<message> stacks;
    sentFarField ownFar;
    {
        countedStacks share(own, team);
        const facesOfFarField faces(setWholeMesh(share, whole, far, piece));
        const bool hasFarField = faces.patchSizes.size();
        setLabels(faces, share, piece);

        labelList processes;
        List<sentFarField> pieces;
        if (!hasFarField)
        {
            const meshParts parts(partsOfLayers(share));
            processes = team.isMaster() ? divide(parts) : labelList();
        }
        else if (team.isMaster())
        {
            processes = divideFarField
            (
                whole, far, piece.patchParts, team.size(), divide, pieces
            );
        }
        if (hasFarField)
        {
            ownFar = receiveFarField(team, piece.far.cellZones.size(), pieces);
        }
        processes.setSize(team.isMaster() ? piece.nStacks : 0);
        team.broadcast(processes);
        stacks = team.exchange(stackMessages(share, processes));
    }
    assemblePiece(stacks, ownFar, piece);
    setPoints(own, team, piece);

    return piece;
}

} // End namespace Foam

// ************************************************************************* //
