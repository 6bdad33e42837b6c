/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testStages.H"
#include "testLayers.H"
#include "testSurfaces.H"
#include "wallClearance.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::testSurfaces::stages::stages
(
    const wallSurface& w,
    const label n,
    const scalar thickness
)
:
    wall(w),
    context(wall),
    spacing(makeLayerSpacing(wall, context.addressing, layersOf(n, thickness))),
    clearance
    (
        makeWallClearance
        (
            wall,
            context.search(),
            context.visibility,
            scalarField(2*envelopeControls().scale*spacing.thickness)
        )
    ),
    radii
    (
        makeEnvelopeRadii
        (
            wall, context.addressing,
            envelopeControls().scale*spacing.thickness, clearance
        )
    ),
    envelope
    (
        makeOffsetEnvelope
        (
            context, radii, identity(wall.points.size()),
            backgroundMeshControls()
        )
    )
{}


Foam::testSurfaces::wallOfOne::wallOfOne(const wallSurface& wall)
:
    front(frontOf(wall, 0)),
    kinds(kindsOfPoints(wall, front.addressing, front.visibility)),
    curvature
    (
        inwardCurvature
        (
            wall, front.addressing, front.visibility, kinds,
            scalarField(kinds.size(), 0)
        )
    ),
    under(front, kinds, curvature)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::backgroundMesh Foam::testSurfaces::stages::background() const
{
    return makeBackgroundMesh(context, envelope);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::layerControls Foam::testSurfaces::layersOf
(
    const label n,
    const scalar thickness
)
{
    layerControls controls;
    controls.heights.nSurfaceLayers = n;
    controls.heights.expansionRatio = 1.2;
    controls.heights.firstLayerThickness =
        thickness/totalThickness(n, 1, 1.2);

    return controls;
}


Foam::prismLayerMesh Foam::testSurfaces::layeredMesh
(
    const wallSurface& wall,
    const label n,
    const scalar thickness
)
{
    prismLayerControls controls;
    controls.layers = layersOf(n, thickness);

    return layeredMesh(wall, controls);
}


Foam::prismLayerMesh Foam::testSurfaces::layeredMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local
)
{
    return makePrismLayerMesh
    (
        wall,
        controls,
        local,
        stageObserver()
    );
}


Foam::tensor Foam::testSurfaces::rotation()
{
    const vector x(normalised(vector(1, 0.3, -0.7)));
    const vector y(normalised(x ^ vector(0.2, 1, 0.9)));

    return tensor(x, y, x ^ y);
}


// ************************************************************************* //
