/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "diffusionTensor.H"
#include "harmonicField.H"
#include "makePrismLayers.H"
#include "wallClearance.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- "12 points, 20 tets"
template<class... Items>
static string text(const Items&... items)
{
    OStringStream os;
    (void)std::initializer_list<int>{((os << items), 0)...};

    return os.str();
}


static void refuseEmptyCones
(
    const wallSurface& wall,
    const wallVisibility& visibility
)
{
    const labelList& points = visibility.emptyCones;

    if (points.empty())
    {
        return;
    }

    FatalErrorInFunction
        << points.size() << " points of the wall see no direction that is in"
        << " front of all their faces; no column can stand there."
        << " The first of them:" << nl;

    for (label i = 0; i < min(points.size(), 10); ++i)
    {
        FatalError
            << "    point " << points[i] << " at " << wall.points[points[i]]
            << nl;
    }

    FatalError
        << "Round off these corners in the surface." << exit(FatalError);
}


static void requireHomeomorphic
(
    const surfaceTopology& levelSets,
    const surfaceTopology& wall
)
{
    if (!(levelSets == wall))
    {
        FatalErrorInFunction
            << "Level sets near the wall are not homeomorphic to it: "
            << levelSets.nComponents << " components for "
            << wall.nComponents << ", Euler characteristic "
            << levelSets.eulerCharacteristic << " for "
            << wall.eulerCharacteristic << exit(FatalError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::prismLayerMesh Foam::makePrismLayerMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const stageObserver& observer
)
{
    prismLayerMesh m;

    observer.begin("layerSpacing");
    m.addressing = makeWallAddressing(wall);
    m.spacing = makeLayerSpacing(wall, controls.layers);
    observer.end
    (
        "layerSpacing",
        text(m.spacing.nLayers, " layers, total thickness ",
            min(m.spacing.thickness), " to ", max(m.spacing.thickness), " m")
    );

    observer.begin("wallVisibility");
    m.visibility = makeWallVisibility(wall, m.addressing);
    refuseEmptyCones(wall, m.visibility);
    observer.end("wallVisibility", text(wall.points.size(), " cones"));

    observer.begin("wallClearance");
    const wallSearch search(wall);
    const scalarField reach(2*controls.envelope.scale*m.spacing.thickness);
    m.clearance = makeWallClearance(wall, search, m.visibility, reach);
    observer.end
    (
        "wallClearance",
        text("room from ", min(m.clearance), " m")
    );

    observer.begin("offsetEnvelope");
    m.envelope = makeOffsetEnvelope
    (
        wall, m.addressing, search, m.visibility, m.clearance, m.spacing,
        controls.envelope, controls.backgroundMesh.radiusEdgeRatio
    );
    observer.end
    (
        "offsetEnvelope",
        text(m.envelope.nEnvelope, " points, ",
            m.envelope.points.size() - m.envelope.nEnvelope,
            " on sheets between")
    );

    observer.begin("backgroundMesh");
    m.background =
        makeBackgroundMesh
        (
            wall, m.addressing, search, m.visibility, m.envelope
        );
    observer.end
    (
        "backgroundMesh",
        text(m.background.points.size(), " points, ",
            m.background.tets.size(), " tetrahedra")
    );

    observer.begin("isotropicField");
    m.isotropic = makeHarmonicField
    (
        m.background, cotangentWeights(m.background), controls.field
    );
    observer.end
    (
        "isotropicField",
        text(findIndices(m.background.free, true).size(), " unknowns")
    );

    observer.begin("anisotropicField");
    const autoPtr<diffusionTensor> tensor
    (
        diffusionTensor::New(controls.field.tensor, controls.field.tensorCoeffs)
    );
    m.tensors = tensor->tensors(m.background, m.isotropic);
    m.field = makeHarmonicField
    (
        m.background,
        tensor->edgeWeights(m.background, m.tensors),
        controls.field
    );
    m.topology = wallLevelSetTopology(m.background);
    requireHomeomorphic(m.topology, wallTopology(wall, m.addressing));
    observer.end
    (
        "anisotropicField",
        text("level sets of ", m.topology.nComponents,
            " components, Euler characteristic ",
            m.topology.eulerCharacteristic, ": as the wall")
    );

    observer.begin("layerColumns");
    m.lines = makeGradientLines
    (
        m.background, m.field, m.visibility.axes(),
        requestedHeights(m.spacing)
    );
    m.columns = makeLayerColumns
    (
        wall, m.addressing, m.visibility, m.clearance, m.spacing, m.lines,
        controls.layers.maxStretch
    );
    observer.end("layerColumns", text(m.columns.room.size(), " columns"));

    observer.begin("prismLayers");
    m.layers = makePrismLayers
    (
        wall, m.addressing, m.visibility, m.spacing,
        controls.layers.maxStretch, m.columns
    );
    observer.end
    (
        "prismLayers",
        text(wall.faces.size()*m.spacing.nLayers, " cells")
    );

    observer.begin("prismQuality");
    m.certificate = certify(m.layers);
    observer.end
    (
        "prismQuality",
        text(m.certificate.nInvalidCells, " invalid cells, ",
            m.certificate.nIntersectingPairs, " intersecting pairs")
    );

    return m;
}


// ************************************************************************* //
