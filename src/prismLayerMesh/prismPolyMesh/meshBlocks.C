/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshBlocks.H"
#include "error.H"

#include <cstdint>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Replaces sizes by the sums of the sizes before
static void accumulate(labelList& sizes)
{
    std::int64_t before = 0;
    for (label& size : sizes)
    {
        const label own = size;
        size = before;
        before += own;

        if (before > labelMax)
        {
            FatalErrorInFunction
                << "Labels of " << label(8*sizeof(label)) << " bits cannot"
                << " count the corners of all faces of the mesh. Ask for fewer"
                << " layers or cells, or use an OpenFOAM with WM_LABEL_SIZE=64"
                << exit(FatalError);
        }
    }
}


//- Copies a block of faces to its place in a mesh
static void copyFaces
(
    const faceBlock& block,
    const label firstFace,
    const label firstInternal,
    polyMeshTopology& mesh
)
{
    forAll(block.ends, i)
    {
        mesh.faces[firstFace + i] = face(block.face(i));
        mesh.owner[firstFace + i] = block.owner[i];
    }
    forAll(block.neighbour, i)
    {
        mesh.neighbour[firstInternal + i] = block.neighbour[i];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void faceBlock::endFace(const label ownerCell, const label neighbourCell)
{
    ends.append(points.size());
    owner.append(ownerCell);

    if (neighbourCell >= 0)
    {
        neighbour.append(neighbourCell);
    }
}


const SubList<label> faceBlock::face(const label i) const
{
    const label start = i ? ends[i - 1] : 0;

    return SubList<label>(points, ends[i] - start, start);
}


void meshBlocks::count()
{
    firstFaces = labelList(nFaceBlocks + 1, Zero);
    firstInternal = firstFaces;
    firstFacePoints = firstFaces;

    #pragma omp parallel for schedule(dynamic)
    for (label i = 0; i < nFaceBlocks; ++i)
    {
        const faceBlock block(faces(i));
        firstFaces[i] = block.owner.size();
        firstInternal[i] = block.neighbour.size();
        firstFacePoints[i] = block.points.size();
    }

    accumulate(firstFaces);
    accumulate(firstInternal);
    accumulate(firstFacePoints);
}


pointField meshBlocks::allPoints() const
{
    DynamicList<point> all(nPoints);
    for (label i = 0; i < nPointBlocks; ++i)
    {
        all.append(points(i));
    }

    return pointField(std::move(all));
}


void meshInBlocks::setPoints(const pointField& all)
{
    nPoints = all.size();
    nPointBlocks = max(label(1), numberOfBlocks(nPoints, blockSize));
    points = [&all](const label i)
    {
        const labelRange range(rangeOfBlock(all.size(), blockSize, i));

        return pointField(SubList<point>(all, range.size(), range.start()));
    };
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

meshInBlocks blocksOf(const polyMeshParts& mesh)
{
    const polyMeshTopology& given = mesh.topology;
    meshInBlocks blocks;
    blocks.nCells = mesh.nCells;
    blocks.setPoints(mesh.points);
    blocks.setFaces
    (
        given.owner, given.neighbour,
        [&given](const label i) -> const face& { return given.faces[i]; }
    );
    blocks.patches = mesh.patches;
    blocks.patchStarts = given.patchStarts;
    blocks.patchStarts.append(given.faces.size());
    blocks.cellZones = mesh.cellZones;
    blocks.faceZones = mesh.faceZones;

    return blocks;
}


polyMeshParts partsOf(const meshInBlocks& mesh)
{
    polyMeshParts parts;
    parts.points = mesh.allPoints();
    parts.nCells = mesh.nCells;
    parts.patches = mesh.patches;
    parts.cellZones = mesh.cellZones;
    parts.faceZones = mesh.faceZones;

    polyMeshTopology& made = parts.topology;
    made.faces.setSize(mesh.nFaces());
    made.owner.setSize(mesh.nFaces());
    made.neighbour.setSize(mesh.nInternalFaces());

    #pragma omp parallel for schedule(dynamic)
    for (label i = 0; i < mesh.nFaceBlocks; ++i)
    {
        copyFaces
        (
            mesh.faces(i), mesh.firstFaces[i], mesh.firstInternal[i], made
        );
    }

    const label nPatches = mesh.patches.names.size();
    made.patchStarts = SubList<label>(mesh.patchStarts, nPatches);
    made.patchSizes.setSize(nPatches);
    forAll(made.patchSizes, patchi)
    {
        made.patchSizes[patchi] =
            mesh.patchStarts[patchi + 1] - mesh.patchStarts[patchi];
    }

    return parts;
}


labelRange rangeOfBlock(const label nItems, const label perBlock, const label i)
{
    return labelRange(i*perBlock, min(perBlock, nItems - i*perBlock));
}


label numberOfBlocks(const label nItems, const label perBlock)
{
    return (nItems + perBlock - 1)/perBlock;
}

} // End namespace Foam

// ************************************************************************* //
