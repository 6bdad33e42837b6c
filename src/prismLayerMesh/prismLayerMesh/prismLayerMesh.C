/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "fieldStages.H"
#include "makeFarFieldMesh.H"
#include "makePrismLayers.H"
#include "nameCauses.H"
#include "wallClearance.H"
#include "stageText.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- " flat 8, convex 2"
static string numbersOf(const FixedList<label, nPointKinds>& counts)
{
    string numbers;

    for (label kind = 0; kind < nPointKinds; ++kind)
    {
        numbers += text(kind ? ", " : " ", name(pointKind(kind)), ' ',
            counts[kind]);
    }

    return numbers;
}


//- From the request to the room for it
static void makeRoom
(
    const wallSurface& wall,
    const wallSearch& search,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    observer.begin("layerSpacing");
    m.addressing = makeWallAddressing(wall);
    m.request = makeLayerSpacing(wall, m.addressing, controls.layers, local);
    m.spacing = gradedSpacing
    (
        m.request, m.addressing, controls.layers.transitionRatio
    );
    observer.end
    (
        text
        (
            m.spacing.nLayers, " layers\n",
            describe(m.request, wall, controls.layers).c_str()
        )
    );

    observer.begin("wallVisibility");
    m.visibility = makeWallVisibility(wall, m.addressing);
    m.pointKinds = kindsOfPoints(wall, m.addressing, m.visibility);
    observer.end
    (
        text("cones of points:", numbersOf(countKinds(m.pointKinds)).c_str())
    );

    observer.begin("layerFront");
    m.front = makeLayerFront
    (
        wall, m.addressing, m.visibility,
        degToRad(controls.layers.multipleNormalsAngle)
    );
    observer.end
    (
        text(m.front.wallPoints.size(), " columns, ",
            m.front.extraColumnPoints().size(), " by multiple normals")
    );

    observer.begin("wallClearance");
    m.clearance = makeWallClearance
    (
        m.front.surface, search, m.front.visibility,
        2*controls.envelope.scale
       *m.front.ofColumns(fieldSpacing(controls, m.spacing).thickness)
    );
    observer.end(text("room from ", min(m.clearance), " m"));
}


//- From the field to certified layers
static void makeLayers
(
    const prismLayerControls& controls,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    const layerFront& front = m.front;
    const layerSpacing spacing(m.spacing.at(front.wallPoints));

    observer.begin("layerColumns");
    const scalarField heights(requestedHeights(spacing));
    const vectorField axes(front.visibility.axes());
    m.lines = m.noField.size()
      ? makeStraightLines(front.surface.points, axes, heights)
      : makeGradientLines
        (
            m.background, m.field, front.wallPoints, axes, heights
        );
    m.columns = makeLayerColumns
    (
        front, m.clearance, spacing, m.lines, controls.layers
    );
    observer.end(text(m.columns.room.size(), " columns"));

    observer.begin("prismLayers");
    m.made = makePrismLayers(front, spacing, m.columns);
    nameCauses
    (
        front, m.pointKinds, m.request.at(front.wallPoints), spacing,
        m.columns, m.made
    );
    const prismLayers& layers = m.made.layers;
    observer.end
    (
        text(layers.faces.size()*layers.nLayers, " cells; columns ",
            "retreated ", m.made.nRetreats, " times")
    );

    observer.begin("prismQuality");
    m.certificate = certify(layers);
    observer.end
    (
        text(m.certificate.nStacksNotPositive, " stacks not positive, ",
            m.certificate.nIntersectingPairs, " intersecting pairs")
    );

    if (!m.certificate.valid())
    {
        FatalErrorInFunction
            << "The layers could not be certified" << exit(FatalError);
    }
}


static void makeAll
(
    const wallSurface& wall,
    const wallSearch& search,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    makeRoom(wall, search, controls, local, observer, m);
    makeField(wall, search, controls, observer, m);
    makeLayers(controls, observer, m);
}


//- False, and said in the log, where layers are not possible with the multiple
//  normals that were chosen rather than needed
static bool tryAll
(
    const wallSurface& wall,
    const wallSearch& search,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    const bool throwing = FatalError.throwExceptions(true);
    bool made = true;

    try
    {
        makeAll(wall, search, controls, local, observer, m);
    }
    catch (const Foam::error& e)
    {
        made = false;
        observer.end
        (
            "Not with multipleNormalsAngle "
          + name(controls.layers.multipleNormalsAngle)
          + ", now with 0. " + e.message()
        );
    }

    FatalError.throwExceptions(throwing);

    return made;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayerMesh Foam::makePrismLayerMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer
)
{
    const wallSearch search(wall);

    if (controls.layers.multipleNormalsAngle > 0)
    {
        prismLayerMesh m;

        if (tryAll(wall, search, controls, local, observer, m))
        {
            return m;
        }
    }

    prismLayerControls needed(controls);
    needed.layers.multipleNormalsAngle = 0;

    prismLayerMesh m;
    makeAll(wall, search, needed, local, observer, m);

    return m;
}


void Foam::addFarField
(
    const farFieldControls& controls,
    const farFieldDomain& domain,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    observer.begin("farFieldMesh");
    m.farField = makeFarFieldMesh
    (
        m.made.layers, m.front.addressing, domain.boundary, controls,
        domain.bounds
    );
    observer.end
    (
        text(m.farField.tets.size(), " tetrahedra on ",
            m.farField.outerTriangles.size(), " triangles of the layers and ",
            m.farField.boundaryTriangles.size(), " of the far boundary")
    );
}


// ************************************************************************* //
