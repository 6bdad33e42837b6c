/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sideParts.H"
#include "bitSet.H"
#include "disjointSets.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Faces with a larger angle than that between them are not of one plane
//  part: cos(5 degrees)
static constexpr scalar samePlaneCosine = 0.996;


namespace
{

class partFinder
{
    const wallSurface& surface_;
    const wallSides& edges_;
    const layerControls& layers_;
    const scalar tolerance_;

    sideParts parts_;


    //- Faces of patches that are to have no layers
    bitSet sideFaces() const
    {
        boolList isSide(surface_.patchNames.size(), false);
        forAll(isSide, patchi)
        {
            const patchLayers* entry =
                layers_.entryOf(surface_.patchNames[patchi]);
            isSide[patchi] = entry && entry->isSide;
        }

        bitSet faces(surface_.faces.size());
        forAll(surface_.patchIDs, facei)
        {
            faces.set(facei, isSide[surface_.patchIDs[facei]]);
        }

        return faces;
    }


    //- Label of the part of each of the faces: those of a patch that are joined
    //  by edges, with angles for which a test of the normals holds
    template<class Test>
    labelList partsOf(const bitSet& faces, const Test& areJoined) const
    {
        disjointSets sets(surface_.faces.size());

        for (label e = 0; e < edges_.nEdges(); ++e)
        {
            const label start = edges_.edgeStarts[e];

            if (edges_.edgeStarts[e + 1] - start == 2)
            {
                const label f = edges_.sides[start].facei;
                const label g = edges_.sides[start + 1].facei;

                if
                (
                    faces.test(f) && faces.test(g)
                 && surface_.patchIDs[f] == surface_.patchIDs[g]
                 && areJoined(f, g)
                )
                {
                    sets.join(f, g);
                }
            }
        }

        labelList parts(surface_.faces.size(), -1);
        for (const label f : faces)
        {
            parts[f] = sets.find(f);
        }

        return parts;
    }


    //- A plane through faces
    sidePatch planeThrough(const labelUList& faces) const
    {
        vector normal(Zero);
        point centre(Zero);
        scalar area = 0;

        for (const label f : faces)
        {
            const scalar a = surface_.faces[f].mag(surface_.points);
            normal += surface_.faces[f].areaNormal(surface_.points);
            centre += a*surface_.faces[f].centre(surface_.points);
            area += a;
        }

        sidePatch side;
        side.normal = -normalised(normal);
        side.origin = centre/max(area, VSMALL);

        return side;
    }


    //- The largest distance of the points of faces from a plane
    scalar deviation(const labelUList& faces, const sidePatch& side) const
    {
        scalar largest = 0;

        for (const label f : faces)
        {
            for (const label p : surface_.faces[f])
            {
                largest =
                    max(largest, mag(side.distance(surface_.points[p])));
            }
        }

        return largest;
    }


    void addPart(const labelUList& faces, const sidePatch& plane)
    {
        sidePatch side(plane);
        side.name = surface_.patchNames[surface_.patchIDs[faces[0]]];
        const word& type = layers_.entryOf(side.name)->type;
        side.type = type.empty() ? "patch" : type;

        for (const label f : faces)
        {
            parts_.sideOfFace[f] = parts_.sides.size();
        }
        parts_.sides.append(side);
    }

public:

    partFinder
    (
        const wallSurface& surface,
        const wallSides& edges,
        const layerControls& layers,
        const scalar tolerance
    )
    :
        surface_(surface),
        edges_(edges),
        layers_(layers),
        tolerance_(tolerance)
    {
        parts_.sideOfFace.setSize(surface.faces.size(), -1);
    }

    sideParts find();
};


sideParts partFinder::find()
{
    const bitSet faces(sideFaces());
    const vectorField normals(surface_.faceNormals());

    const auto byPart = [&](const labelList& parts)
    {
        Map<DynamicList<label>> lists;
        for (const label f : faces)
        {
            if (parts_.sideOfFace[f] < 0)
            {
                lists(parts[f]).append(f);
            }
        }

        return lists;
    };

    // All of a part that is joined at any angle, where it is plane
    const Map<DynamicList<label>> whole
    (
        byPart(partsOf(faces, [](label, label) { return true; }))
    );
    for (const label first : whole.sortedToc())
    {
        const sidePatch side(planeThrough(whole[first]));

        if (deviation(whole[first], side) <= tolerance_)
        {
            addPart(whole[first], side);
        }
    }

    const Map<DynamicList<label>> smooth
    (
        byPart(partsOf(faces, [&](const label f, const label g)
        {
            return (normals[f] & normals[g]) > samePlaneCosine;
        }))
    );
    for (const label first : smooth.sortedToc())
    {
        const sidePatch side(planeThrough(smooth[first]));
        const scalar distance = deviation(smooth[first], side);

        if (distance > tolerance_)
        {
            const label patchi = surface_.patchIDs[first];

            FatalErrorInFunction
                << "The side patch " << surface_.patchNames[patchi]
                << " is not plane at "
                << surface_.faces[first].centre(surface_.points)
                << ": points are up to " << distance << " m away from a plane"
                << exit(FatalError);
        }
        addPart(smooth[first], side);
    }

    return parts_;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

sideParts findSideParts
(
    const wallSurface& surface,
    const wallSides& edges,
    const layerControls& layers,
    const scalar tolerance
)
{
    return partFinder(surface, edges, layers, tolerance).find();
}

} // End namespace Foam

// ************************************************************************* //
