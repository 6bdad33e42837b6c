/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "patchReport.H"
#include "bitSet.H"
#include "ListOps.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

template<class Type>
static MinMax<Type> ofAll(const MinMax<Type>& range, const columnTeam& team)
{
    return MinMax<Type>
    (
        team.reduce(range.min(), minOp<Type>()),
        team.reduce(range.max(), maxOp<Type>())
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void wallSample::addPoints(const labelUList& faces, patchReport& patch) const
{
    bitSet points;

    for (const label facei : faces)
    {
        const face& f = wall.faces[facei];
        points.set(f);

        // Between patches, the thinner one's count
        patch.layersAsked =
            max(patch.layersAsked, min(labelList(spacing.layersAsked, f)));
    }

    for (const label p : points)
    {
        if (team.isOwn(p))
        {
            patch.request.firstThickness.add(spacing.firstThickness[p]);
            patch.request.ratio.add(spacing.ratio[p]);
            patch.request.thickness.add(spacing.thickness[p]);
            ++patch.points[int(causes[p])];
        }
    }

    layerRequest& request = patch.request;
    request.firstThickness = ofAll(request.firstThickness, team);
    request.ratio = ofAll(request.ratio, team);
    request.thickness = ofAll(request.thickness, team);
    patch.layersAsked = team.reduce(patch.layersAsked, maxOp<label>());
    for (label& n : patch.points)
    {
        n = team.sum(n);
    }
}


void wallSample::addFaces(const labelUList& counted, patchReport& patch) const
{
    const scalarField jacobians(certificate.worstJacobian, counted);
    scalar fullArea = 0;
    for (const label facei : counted)
    {
        const scalar area = heights.areas[facei];
        patch.area += area;
        fullArea += heights.totalOverRequest[facei] >= 0.99 ? area : 0;
    }
    patch.nFaces = team.sum(counted.size());
    patch.area = team.sum(patch.area);
    fullArea = team.sum(fullArea);
    const scalar worst = team.reduce(min(jacobians), minOp<scalar>());
    const scalar sumJacobians = team.sum(sum(jacobians));

    if (patch.nFaces)
    {
        // Layers are on every face
        patch.layersReached = layers.nLayers;
        patch.fullLayersArea = 100;
        patch.fullThicknessArea = 100*fullArea/max(patch.area, VSMALL);
        patch.worstJacobian = worst;
        patch.meanJacobian = sumJacobians/patch.nFaces;
    }
}


patchReport wallSample::report(const word& name, const labelUList& faces) const
{
    patchReport patch;
    patch.name = name;
    const labelList counted
    (
        subsetList
        (
            faces,
            [&](const label facei) { return team.counts(layers.faces[facei]); }
        )
    );
    addFaces(counted, patch);

    const label n = spacing.nLayers - 1;
    scalarField growth(n*counted.size());
    #pragma omp parallel for schedule(static)
    forAll(counted, i)
    {
        SubList<scalar>(growth, n, i*n) =
            SubList<scalar>(heights.growthOverRequest, n, counted[i]*n);
    }
    patch.firstHeight =
        makePercentiles(scalarField(heights.firstOverRequest, counted), team);
    patch.totalThickness =
        makePercentiles(scalarField(heights.totalOverRequest, counted), team);
    patch.growth = makePercentiles(growth, team);
    addPoints(faces, patch);

    return patch;
}

} // End namespace Foam

// ************************************************************************* //
