/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stayingCells.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Constants that were tuned
const struct
{
    //- Faces of a patch on the wall are nearer to the obstacles than so many
    //  widths of their cells
    scalar onWall = 2;

    //- Cosine of the angle between the normal of one of them and the way to the
    //  obstacles, at least: all faces on a side of the domain look away
    scalar towardsWall = 0.1;

    //- Where the owner of a face begins: share of the way to its centre
    scalar within = 0.1;

} tunedPatches;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool stayingCells::looksAtObstacles(const label facei) const
{
    const face& f = core_.topology.faces[facei];
    const vector fromFoot
    (
        obstacles_.surface.footOf(f.centre(core_.points)).direction
    );

    return (-fromFoot & f.unitNormal(core_.points)) > tunedPatches.towardsWall;
}


bool stayingCells::liesOnWall(const label patchi) const
{
    const polyMeshTopology& t = core_.topology;
    const label start = t.patchStarts[patchi];
    const label size = t.patchSizes[patchi];
    bool near = size > 0 && isPlain(patchi);
    label nBehind = 0;
    bool looksAtWall = false;

    for (label facei = start; near && facei < start + size; ++facei)
    {
        const point centre(t.faces[facei].centre(core_.points));
        if (planeOf(facei) >= 0)
        {
            near = false;
        }
        else if (!inFluid(facei))
        {
            ++nBehind;
        }
        else
        {
            near = obstacles_.surface.nearer
            (
                centre, tunedPatches.onWall*width(t.owner[facei])
            );
            looksAtWall = looksAtWall || looksAtObstacles(facei);
        }
    }

    return near && (looksAtWall || 2*nBehind > size);
}


void stayingCells::removeOnWall()
{
    DynamicList<word> names;

    forAll(core_.patches.names, patchi)
    {
        if (liesOnWall(patchi))
        {
            const label start = core_.topology.patchStarts[patchi];
            const label size = core_.topology.patchSizes[patchi];
            names.append(core_.patches.names[patchi]);
            for (label i = start; i < start + size; ++i)
            {
                leave(core_.topology.owner[i]);
            }
        }
    }

    wallPatches_.transfer(names);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool stayingCells::isPlain(const label patchi) const
{
    const wordList plain({"patch", "wall", "symmetry", "symmetryPlane"});

    return plain.found(core_.patches.entries[patchi].get<word>("type"));
}


bool stayingCells::inFluid(const label facei) const
{
    const label own = core_.topology.owner[facei];
    const point centre(core_.topology.faces[facei].centre(core_.points));

    return obstacles_.fluid.inFront
    (
        centre + tunedPatches.within*(boxes_[own].midpoint() - centre)
    );
}

} // End namespace Foam

// ************************************************************************* //
