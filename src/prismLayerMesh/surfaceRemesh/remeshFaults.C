/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remeshFaults.H"
#include "edgeHashes.H"
#include "layerFront.H"
#include "wallSides.H"

#include <algorithm>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Faces of a surface that are further than a distance from another one, with
//  their centre or a point, and the nearest faces there of the other one
static List<labelPair> facesAway
(
    const wallSurface& surface,
    const nearestSurface& other,
    const scalar distance
)
{
    const pointField from(samplesOf(surface));
    pointField nearest;
    labelList faces;
    other.find(from, nearest, faces);
    DynamicList<labelPair> away;

    forAll(surface.faces, facei)
    {
        labelList samples(surface.faces[facei]);
        samples.append(surface.points.size() + facei);

        for (const label i : samples)
        {
            if (mag(nearest[i] - from[i]) > distance)
            {
                away.append(labelPair(facei, faces[i]));
            }
        }
    }

    return List<labelPair>(std::move(away));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList withFacesWithoutRoom
(
    const labelUList& faces,
    const remesher& mesher,
    const wallSurface& surface
)
{
    const edgeHashSet foldedBefore(mesher.edited().features(foldCosine()));
    const vectorField normals(surface.faceNormals());
    const wallSides all(makeWallSides(surface));
    DynamicList<label> faults(faces);

    for (label e = 0; e < all.nEdges(); ++e)
    {
        const label first = all.on(e)[0].facei;
        if (foldedBefore.found(edge(all.on(e)[0].low, all.on(e)[0].high)))
        {
            continue;
        }
        for (const wallSide& other : all.on(e))
        {
            if ((normals[first] & normals[other.facei]) < foldCosine())
            {
                faults.append(first);
                faults.append(other.facei);
            }
        }
    }

    const bitSet isBlind
    (
        surface.points.size(), pointsWithoutDirection(surface)
    );
    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        const auto blind = [&](const label p) { return isBlind.test(p); };
        if (std::any_of(f.begin(), f.end(), blind))
        {
            faults.append(facei);
        }
    }

    return labelList(std::move(faults));
}


labelHashSet trianglesNear
(
    const givenSurface& given,
    const wallSurface& made,
    const labelUList& nearest,
    const labelUList& faces
)
{
    labelHashSet result;

    for (const label facei : faces)
    {
        const face& f = made.faces[facei];
        const scalar reach =
            f.faceEdge(f.longestEdge(made.points)).mag(made.points);
        if (nearest[facei] >= 0)
        {
            const point centre(f.centre(made.points));
            result.insert(given.around(nearest[facei], centre, reach));
        }
    }

    return result;
}


labelHashSet trianglesAway
(
    const givenSurface& shape,
    const nearestSurface& search,
    const wallSurface& made,
    const labelUList& nearest,
    const surfaceRemeshControls& controls
)
{
    const wallSurface& given = shape.surface();
    const scalar deviation = controls.deviation;
    labelHashSet result;

    for (const labelPair& f : facesAway(given, nearestSurface(made), deviation))
    {
        result.insert(f.first());
        result.insert(nearest[f.second()]);
    }
    for (const labelPair& f : facesAway(made, search, deviation))
    {
        result.insert(nearest[f.first()]);
    }
    result.erase(-1);

    const scalarField lengths(shape.lengths());
    result.filterKeys([&](const label t)
    {
        return lengths[t] > controls.minEdge;
    });

    return result;
}

} // End namespace Foam

// ************************************************************************* //
