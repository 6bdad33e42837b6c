/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localConductivity.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
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


//- The heights of the wall below a point of the mesh
struct wallProjection
{
    //- Heights that are asked for there [m]
    scalarField heights;

    //- Distance to the wall [m], scaled to the gap of a flat wall
    scalar depth = 0;

    //- Whether the heights differ from the uniform ones
    bool isLocal = false;
};

} // End anonymous namespace


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
    SubList<scalar>(result.heights, n, 1) = heights;
    SubList<scalar>(result.energies, n, 1) = energies;
    result.heights[n + 1] =
        max(gap, conductivityControls::leastGap*heights[n - 1]);

    return result;
}


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
    result.isLocal = max(mag(result.heights/uniform - 1))
      > conductivityControls::sameHeight;

    return result;
}

//- Correct one height of a target by what was reached of what was asked for
static void correct
(
    const scalar asked,
    const scalar reached,
    const scalar largest,
    scalar& height
)
{
    // The largest height is that of the uniform spacing
    if (asked < largest*(1 - conductivityControls::sameHeight))
    {
        const scalar change = asked/max(reached, VSMALL);
        height *= min
        (
            max(change, conductivityControls::leastChange),
            conductivityControls::mostChange
        );
        height = min
        (
            max(height, conductivityControls::leastTarget*asked), largest
        );
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<wallSearch::foot> feetOfPoints
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


scalarField localConductivities
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

    scalarField conductivities(mesh.tets.size(), 1);
    forAll(conductivities, t)
    {
        scalarField heights(n, 0);
        scalar nearest = GREAT, farthest = 0;
        bool isLocal = false;

        for (const label v : mesh.tets[t])
        {
            const wallProjection& foot = projections[v];
            heights += 0.25*foot.heights;
            nearest = min(nearest, foot.depth);
            farthest = max(farthest, foot.depth);
            isLocal = isLocal || foot.isLocal;
        }

        if (isLocal)
        {
            const profile wanted(makeProfile(heights, energies, gap));

            // Not nearer to each other than slopes need
            const scalar middle = 0.5*(nearest + farthest);
            const scalar half = max
            (
                0.5*(farthest - nearest),
                conductivityControls::leastDistance*middle
            );
            const scalar low = max(middle - half, scalar(0));
            const scalar high = min(middle + half, gap);

            conductivities[t] =
                max(flat(low) - flat(high), SMALL)
               /max(wanted(low) - wanted(high), SMALL);
        }
    }

    return conductivities;
}


layerSpacing correctedTarget
(
    const layerSpacing& target,
    const layerSpacing& asked,
    const layerSpacing& reached,
    const layerSpacing& uniform
)
{
    const label n = uniform.nLayers;
    layerSpacing corrected(target);

    forAll(corrected.thickness, p)
    {
        scalar& thickness = corrected.thickness[p];
        scalar& first = corrected.firstThickness[p];

        correct
        (
            asked.thickness[p], reached.thickness[p], uniform.thickness[p],
            thickness
        );
        correct
        (
            asked.firstThickness[p], reached.firstThickness[p],
            uniform.firstThickness[p], first
        );

        if (n > 1)
        {
            first = min
            (
                first, thickness/(1 + conductivityControls::leastExcess*n)
            );
            corrected.ratio[p] = fittedRatio(n, first, thickness);
        }
    }

    return corrected;
}

} // End namespace Foam

// ************************************************************************* //
