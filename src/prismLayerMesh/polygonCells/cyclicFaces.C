/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cyclicFaces.H"

#include "boundBox.H"
#include "ListOps.H"
#include "UIndirectList.H"

#include <algorithm>
#include <map>
#include <vector>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The faces on both patches of a pair
class pairedFaces
{
    const polyMeshTopology& t_;
    const sidePair& pair_;

    //- By point on the first patch its image; the point itself elsewhere
    labelList images_;

    typedef std::vector<label> sortedPoints;

    bitSet pointsOn(const label patchi, const label nPoints) const
    {
        bitSet points(nPoints);
        for (const label facei : facesOn(patchi))
        {
            points.set(t_.faces[facei]);
        }

        return points;
    }

    sortedPoints pointsOf(const label facei, const bool areImages) const
    {
        sortedPoints points;
        for (const label p : t_.faces[facei])
        {
            points.push_back(areImages ? images_[p] : p);
        }
        std::sort(points.begin(), points.end());

        return points;
    }

public:

    pairedFaces(const polyMeshParts& mesh, const sidePair& pair)
    :
        t_(mesh.topology),
        pair_(pair),
        images_(mesh.points.size(), -1)
    {
        // Rounding of coordinates, over the size of the mesh
        static constexpr scalar rounding = 1e-11;
        const label n = mesh.points.size();
        const labelList first(pointsOn(pair.first, n).toc());
        const labelList second(pointsOn(pair.second, n).toc());
        const labelList places
        (
            imagesAmong
            (
                pointField(mesh.points, second),
                pointField(mesh.points, first), pair.toSecond,
                rounding*boundBox(mesh.points, false).mag()
            )
        );
        forAll(first, i)
        {
            images_[first[i]] = places[i] < 0 ? -1 : second[places[i]];
        }
    }

    labelList facesOn(const label patchi) const
    {
        return t_.patchFaces(patchi).labels();
    }

    label image(const label p) const { return images_[p]; }

    //- Returns the image of each face on the first patch, -1 if it has none
    labelList images() const
    {
        std::map<sortedPoints, label> faces;
        for (const label facei : facesOn(pair_.second))
        {
            faces.insert({pointsOf(facei, false), facei});
        }
        labelList found;
        for (const label facei : facesOn(pair_.first))
        {
            const auto at = faces.find(pointsOf(facei, true));
            found.append(at == faces.end() ? -1 : at->second);
        }

        return found;
    }
};

} // End anonymous namespace


//- Adds the faces on both patches of a pair that have no image
static void addWithoutImage
(
    const polyMeshParts& mesh,
    const sidePair& pair,
    DynamicList<label>& alone
)
{
    const pairedFaces faces(mesh, pair);
    const labelList first(faces.facesOn(pair.first));
    const labelList images(faces.images());
    bitSet isImage(mesh.topology.faces.size());
    forAll(images, i)
    {
        if (images[i] < 0)
        {
            alone.append(first[i]);
        }
        else
        {
            isImage.set(images[i]);
        }
    }
    for (const label facei : faces.facesOn(pair.second))
    {
        if (!isImage.test(facei))
        {
            alone.append(facei);
        }
    }
}


//- Aligns the faces of a pair
static void alignFaces(const sidePair& pair, polyMeshParts& mesh)
{
    const pairedFaces faces(mesh, pair);
    const labelList first(faces.facesOn(pair.first));
    const labelList second(faces.facesOn(pair.second));
    const labelList images(faces.images());
    polyMeshTopology& t = mesh.topology;
    DynamicList<face> ordered;
    DynamicList<label> owner;
    forAll(images, i)
    {
        const face& f = t.faces[images[i]];
        const label start = f.find(faces.image(t.faces[first[i]][0]));
        ordered.append(face(rotateList(f, -start)));
        owner.append(t.owner[images[i]]);
    }
    forAll(second, i)
    {
        t.faces[second[i]] = ordered[i];
        t.owner[second[i]] = owner[i];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

cyclicFaces::cyclicFaces
(
    const UList<sidePatch>& sides,
    const meshPatches& patches
)
{
    for (sidePair pair : pairsOf(sides))
    {
        pair.first = patches.names.find(sides[pair.first].name);
        pair.second = patches.names.find(sides[pair.second].name);
        if (pair.first >= 0 && pair.second >= 0)
        {
            pairs_.append(pair);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool cyclicFaces::has(const label patchi) const
{
    return std::any_of
    (
        pairs_.begin(), pairs_.end(), [&](const sidePair& pair)
        {
            return pair.first == patchi || pair.second == patchi;
        }
    );
}


labelList cyclicFaces::withoutImage(const polyMeshParts& mesh) const
{
    DynamicList<label> alone;
    for (const sidePair& pair : pairs_)
    {
        addWithoutImage(mesh, pair, alone);
    }

    return labelList(std::move(alone));
}


void cyclicFaces::align(polyMeshParts& mesh) const
{
    for (const sidePair& pair : pairs_)
    {
        alignFaces(pair, mesh);
    }
}

} // End namespace Foam

// ************************************************************************* //
