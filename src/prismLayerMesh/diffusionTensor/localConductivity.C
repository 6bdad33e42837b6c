/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "localConductivity.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- A field along a normal of the wall: energies at ascending heights, linear
//  between
struct profile
{
    scalarField heights;
    scalarField energies;

    scalar operator()(const scalar height) const
    {
        label i = 1;
        while (i < heights.size() - 1 && heights[i] < height)
        {
            ++i;
        }

        const scalar s =
            (height - heights[i - 1])/(heights[i] - heights[i - 1]);

        return energies[i - 1]
          + min(s, scalar(1))*(energies[i] - energies[i - 1]);
    }
};


//- From the wall through the layers to the envelope
static profile makeProfile
(
    const scalarField& heights,
    const scalarField& energies,
    const scalar gap
)
{
    const label n = heights.size();
    profile result{scalarField(n + 2, 0), scalarField(n + 2, 0)};
    result.energies[0] = 1;

    for (label i = 0; i < n; ++i)
    {
        result.heights[i + 1] = heights[i];
        result.energies[i + 1] = energies[i];
    }
    result.heights[n + 1] = max(gap, 1.001*heights[n - 1]);

    return result;
}


//- Where a point of the mesh is above the wall
struct wallProjection
{
    //- Heights that are asked for there
    scalarField heights;

    //- Distance to the wall, where the gap is that of a flat wall [m]
    scalar depth = 0;

    //- Whether they are others than those of all of the wall
    bool isLocal = false;
};


static wallProjection projectionOf
(
    const backgroundMesh& mesh,
    const label v,
    const wallSearch::foot& foot,
    const scalarField& requested,
    const scalarField& uniform,
    const scalar gap
)
{
    const label n = uniform.size();
    wallProjection result;
    result.heights.setSize(n, 0);

    forAll(foot.points, k)
    {
        for (label i = 0; i < n; ++i)
        {
            result.heights[i] +=
                foot.weights[k]*requested[foot.points[k]*n + i];
        }
    }

    result.depth = foot.distance*gap/max(mesh.gaps[v], VSMALL);
    result.isLocal = max(mag(result.heights/uniform - 1)) > 1e-6;

    return result;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::wallSearch::foot> Foam::feetOfPoints
(
    const backgroundMesh& mesh,
    const wallSearch& search
)
{
    List<wallSearch::foot> feet(mesh.points.size());
    forAll(feet, v)
    {
        feet[v] = search.footOf(mesh.points[v]);
    }

    return feet;
}


Foam::scalarField Foam::localWeightFactors
(
    const backgroundMesh& mesh,
    const List<wallSearch::foot>& feet,
    const scalarField& energies,
    const layerSpacing& uniform,
    const layerSpacing& local
)
{
    const label n = uniform.nLayers;
    const scalarField all(SubList<scalar>(requestedHeights(uniform), n));
    const scalarField requested(requestedHeights(local));
    const scalar gap = max(mesh.gaps);
    const profile flat(makeProfile(all, energies, gap));

    List<wallProjection> projections(mesh.points.size());
    forAll(projections, v)
    {
        projections[v] = projectionOf(mesh, v, feet[v], requested, all, gap);
    }

    scalarField factors(mesh.edges.size(), 1);
    forAll(factors, i)
    {
        const edge& e = mesh.edges[i];
        const wallProjection& a = projections[e.start()];
        const wallProjection& b = projections[e.end()];

        if (!a.isLocal && !b.isLocal)
        {
            continue;
        }

        const profile wanted
        (
            makeProfile(0.5*(a.heights + b.heights), energies, gap)
        );

        // Not nearer to each other than slopes need
        const scalar middle = 0.5*(a.depth + b.depth);
        const scalar half =
            max(0.5*mag(a.depth - b.depth), 0.05*middle);
        const scalar low = max(middle - half, scalar(0));
        const scalar high = min(middle + half, gap);

        factors[i] =
            max(flat(low) - flat(high), SMALL)
           /max(wanted(low) - wanted(high), SMALL);
    }

    return factors;
}


Foam::layerSpacing Foam::correctedTarget
(
    const layerSpacing& aim,
    const layerSpacing& asked,
    const layerSpacing& reached,
    const layerSpacing& uniform
)
{
    const label n = uniform.nLayers;
    layerSpacing corrected(aim);

    const auto correct = []
    (
        scalar& value,
        const scalar wanted,
        const scalar had,
        const scalar largest
    )
    {
        // Nothing to do where all of the wall is to be so
        if (wanted < largest*(1 - 1e-6))
        {
            const scalar change = wanted/max(had, VSMALL);
            value *= min(max(change, scalar(0.8)), scalar(1.25));
            value = min(max(value, 0.02*wanted), largest);
        }
    };

    forAll(corrected.thickness, p)
    {
        scalar& thickness = corrected.thickness[p];
        scalar& first = corrected.firstThickness[p];

        correct
        (
            thickness, asked.thickness[p], reached.thickness[p],
            uniform.thickness[p]
        );
        correct
        (
            first, asked.firstThickness[p], reached.firstThickness[p],
            uniform.firstThickness[p]
        );

        if (n > 1)
        {
            first = min(first, thickness/(1 + 0.1*n));
            corrected.ratio[p] = fittedRatio(n, first, thickness);
        }
    }

    return corrected;
}


// ************************************************************************* //
