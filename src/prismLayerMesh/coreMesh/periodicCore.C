/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicCore.H"
#include "boundBox.H"
#include "ranges.H"
#include "sidePair.H"
#include "stayingCells.H"

namespace Foam
{

//- Largest distance of a point from an image, over the size of the core
static constexpr scalar coreTolerance = 1e-6;


namespace
{

//- Two patches of a core whose faces are to be images
struct patchesOfPair
{
    polyMeshParts& core;
    const rigidMotion& toSecond;
    const word& first;
    const word& second;

    label patchOf(const word& name, const word& other) const
    {
        const label patchi = core.patches.names.find(name);
        if (patchi < 0 || core.patches.types()[patchi] != "cyclic")
        {
            FatalErrorInFunction
                << "The mesh around the layers has no patch " << name
                << " of type cyclic. Beside layers that end on the cyclic"
                << " sides " << name << " and " << other
                << " it needs both patches"
                << exit(FatalError);
        }

        return patchi;
    }

    //- Calls with both labels for each point of each face and its image
    template<class Function>
    void forPoints(const labelPair& patches, const Function& each) const
    {
        const polyMeshTopology& t = core.topology;
        for (label i = 0; i < t.patchSizes[patches.first()]; ++i)
        {
            const label facei = t.patchStarts[patches.first()] + i;
            const label image = t.patchStarts[patches.second()] + i;
            const face& f = t.faces[facei];
            const face& g = t.faces[image];
            if (f.size() != g.size())
            {
                refuse
                (
                    Foam::name(f.size()) + " and " + Foam::name(g.size())
                  + " points on a face", f.centre(core.points)
                );
            }
            forAll(f, k)
            {
                each(f[k], g[(g.size() - k) % g.size()]);
            }
        }
    }

    void refuse(const string& how, const point& at) const
    {
        FatalErrorInFunction
            << "The mesh around the layers is not periodic: its patches "
            << first << " and " << second << " have " << how.c_str() << ", at "
            << at << nl << "Faces and points of both patches must be images, in"
            << " the same order" << exit(FatalError);
    }

    //- Returns the patches
    labelPair checkAndMove()
    {
        const labelPair patches(patchOf(first, second), patchOf(second, first));
        const labelList& sizes = core.topology.patchSizes;
        const label nFirst = sizes[patches.first()];
        const label nSecond = sizes[patches.second()];
        if (nFirst != nSecond)
        {
            const labelList& starts = core.topology.patchStarts;
            const label patchi =
                nFirst ? patches.first() : patches.second();
            refuse
            (
                Foam::name(nFirst) + " and " + Foam::name(nSecond) + " faces",
                core.topology.faces[starts[patchi]].centre(core.points)
            );
        }

        scalar largest = 0;
        label furthest = -1;
        pointField& x = core.points;
        forPoints(patches, [&](const label p, const label image)
        {
            const scalar distance = mag(toSecond(x[p]) - x[image]);
            if (distance > largest)
            {
                largest = distance;
                furthest = image;
            }
        });
        if (largest > coreTolerance*boundBox(x, false).mag())
        {
            refuse
            (
                "points that are up to " + Foam::name(largest)
              + " m from images", x[furthest]
            );
        }
        forPoints(patches, [&](const label p, const label image)
        {
            x[image] = toSecond(point(x[p]));
        });

        return patches;
    }
};

} // End anonymous namespace


List<labelPair> cyclicPatchesOf
(
    const UList<sidePatch>& cyclicSides,
    polyMeshParts& core
)
{
    DynamicList<labelPair> all;
    for (const sidePair& pair : pairsOf(cyclicSides))
    {
        patchesOfPair both
        {
            core, pair.toSecond, cyclicSides[pair.first].name,
            cyclicSides[pair.second].name
        };
        all.append(both.checkAndMove());
    }

    return List<labelPair>(std::move(all));
}


//- Whether the faces of two patches have equal numbers of points
static bool haveEqualFaces(const polyMeshTopology& t, const labelPair& patches)
{
    const label first = t.patchStarts[patches.first()];
    const label second = t.patchStarts[patches.second()];
    const label n = t.patchSizes[patches.first()];

    return
        t.patchSizes[patches.second()] == n
     && allOf(identity(n), [&](const label i)
        {
            return t.faces[first + i].size() == t.faces[second + i].size();
        });
}


List<labelPair> cyclicPatchesBeside
(
    const UList<sidePatch>& planes,
    const polyMeshParts& core
)
{
    const corePlanes inPlanes(core, planes);
    const auto isBeside = [&](const label patchi)
    {
        const polyMeshTopology& t = core.topology;

        return allOf
        (
            t.patchFaces(patchi).labels(),
            [&](const label facei) { return inPlanes.planeOf(facei) < 0; }
        );
    };
    const wordList types(core.patches.types());
    DynamicList<labelPair> all;
    forAll(types, patchi)
    {
        const label other = types[patchi] != "cyclic" ? -1
          : core.patches.names.find
            (
                core.patches.entries[patchi].get<word>("neighbourPatch")
            );
        const labelPair pair(patchi, other);
        if
        (
            other > patchi && haveEqualFaces(core.topology, pair)
         && isBeside(patchi) && isBeside(other)
        )
        {
            all.append(pair);
        }
    }

    return List<labelPair>(std::move(all));
}

} // End namespace Foam

// ************************************************************************* //
