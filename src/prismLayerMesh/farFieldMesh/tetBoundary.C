/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetBoundary.H"
#include "refineSurface.H"
#include "removeUnused.H"
#include "sidePatchRemainders.H"
#include "sideShape.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Puts the points whose triangles are of one curved side patch, or of sectors
//  of one, on it; not those of the layers. Then merges patches of one name.
static void putOnSides
(
    const UList<sidePatch>& sides,
    const farFieldBoundary& coarse,
    wallSurface& far
)
{
    labelList patches(far.points.size(), -1);
    bitSet onSeveral(far.points.size());

    forAll(far.faces, facei)
    {
        const label patchi = far.patchIDs[facei];

        for (const label p : far.faces[facei])
        {
            const label other = patches[p];
            if (other >= 0 && far.patchNames[other] != far.patchNames[patchi])
            {
                onSeveral.set(p);
            }
            patches[p] = patchi;
        }
    }

    for (label p = coarse.columns.size(); p < far.points.size(); ++p)
    {
        const label s = patches[p] - coarse.firstSide;

        if (s >= 0 && sides[s].isCurved() && !onSeveral.test(p))
        {
            far.points[p] = sides[s].shape->nearest(far.points[p]).rawPoint();
        }
    }

    // In the order of the far boundary's patches: some of them are sides
    for (label& patchi : far.patchIDs)
    {
        patchi = far.patchNames.find(far.patchNames[patchi]);
    }
    mergePatches(far);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

tetBoundary makeTetBoundary
(
    const prismLayers& layers,
    const farBoundary& boundary,
    const std::function<scalar(const point&)>& size
)
{
    tetBoundary result;

    if (layers.border.sides.empty())
    {
        result.surface = boundary.surface;
        result.surface.patchTypes = boundary.patchTypes;
        refineSurface(result.surface, size, boundary.project);

        return result;
    }

    const farFieldBoundary coarse(makeFarFieldBoundary(layers, boundary, size));
    result.columns = coarse.columns;
    result.surface = coarse.surface;
    refineSurface(result.surface, size, boundary.project);
    putOnSides(layers.border.sides, coarse, result.surface);

    return result;
}


tetBoundary makePlaneBoundary
(
    const prismLayers& layers,
    const coreCut& cut,
    const meshPatches& patches,
    const std::function<scalar(const point&)>& size
)
{
    const farFieldBoundary remainders(makePlaneRemainders(layers, cut, size));
    tetBoundary result;
    result.columns = remainders.columns;

    // Better triangles, of the points that are used, then with all points
    const label nKept = remainders.columns.size() + cut.surface.points.size();
    wallSurface planes(remainders.surface);
    const labelList newLabels(removeUnusedPoints(planes.faces, planes.points));
    const labelList used(invert(planes.points.size(), newLabels));
    const label nUsedKept = std::count_if
    (
        newLabels.begin(), newLabels.begin() + nKept,
        [](const label p) { return p >= 0; }
    );
    refineSurface(planes, size, nullptr);

    result.surface = remainders.surface;
    result.surface.points.setSize(nKept);
    result.surface.points.append
    (
        SubList<point>
        (
            planes.points, planes.points.size() - nUsedKept, nUsedKept
        )
    );
    result.surface.faces = planes.faces;
    result.surface.patchIDs = planes.patchIDs;
    for (face& f : result.surface.faces)
    {
        for (label& p : f)
        {
            p = p < nUsedKept ? used[p] : p - nUsedKept + nKept;
        }
    }

    // By the names of the core's patches
    for (label& patchi : result.surface.patchIDs)
    {
        patchi = patches.names.find(remainders.surface.patchNames[patchi]);
    }
    result.surface.patchNames.clear();
    result.surface.patchTypes.clear();
    result.nCutPoints = cut.surface.points.size();

    return result;
}


void addCut
(
    const coreCut& cut,
    const meshPatches& patches,
    tetBoundary& boundary
)
{
    wallSurface& surface = boundary.surface;
    const label nPatches = surface.patchNames.size();
    const label nFaces = surface.faces.size();
    label first = boundary.columns.size();
    boundary.corePoints = labelList(surface.points.size(), -1);

    if (boundary.nCutPoints == 0)
    {
        first = surface.points.size();
        surface.points.append(cut.surface.points);
        boundary.corePoints.append(cut.points);
    }
    else
    {
        SubList<label>(boundary.corePoints, cut.points.size(), first) =
            cut.points;
    }

    surface.patchNames.append(patches.names);
    surface.patchTypes.append(patches.types());
    surface.faces.append(cut.surface.faces);
    surface.patchIDs.append(cut.surface.patchIDs);
    for (label i = nFaces; i < surface.faces.size(); ++i)
    {
        surface.patchIDs[i] += nPatches;
        for (label& p : surface.faces[i])
        {
            p += first;
        }
    }

    boundary.cutFaces = cut.cutFaces;
    boundary.cutCells = cut.cutCells;
    boundary.seeds = cut.seeds;

    // Triangles use all points of columns
    const labelList newLabels
    (
        removeUnusedPoints(surface.faces, surface.points)
    );
    inplaceReorder(newLabels, boundary.corePoints, true);
}


wallSurface joined(const wallSurface& outer, const tetBoundary& boundary)
{
    const wallSurface& far = boundary.surface;
    const labelList& common = boundary.columns;
    const label nCommon = common.size();
    const label n = far.points.size() - nCommon;

    wallSurface both;
    both.points = outer.points;
    both.points.append(SubList<point>(far.points, n, nCommon));
    both.faces = outer.faces;
    both.faces.append(far.faces);

    for (label i = outer.faces.size(); i < both.faces.size(); ++i)
    {
        for (label& p : both.faces[i])
        {
            p = p < nCommon ? common[p] : p - nCommon + outer.points.size();
        }
    }

    return both;
}

} // End namespace Foam

// ************************************************************************* //
