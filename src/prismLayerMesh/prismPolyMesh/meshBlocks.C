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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
