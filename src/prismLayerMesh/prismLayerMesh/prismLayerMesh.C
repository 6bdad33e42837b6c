/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismLayerMesh.H"
#include "levelSets.H"
#include "nameCauses.H"
#include "returnMemory.H"
#include "stageText.H"
#include "straightShares.H"
#include "unitConversion.H"
#include "wallClearance.H"
#include "wallPointsError.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

class pipeline
{
    const wallSurface& wall_;
    const prismLayerControls& controls_;
    const stageObserver& observer_;
    const bool keepStages_;
    const wallSearch search_;

    prismLayerMesh m_;

    //- The thickness [m] of clearance and envelope, uniform on level sets
    scalarField thickness() const;

    void makeHeights(const localHeights& local);
    void makeCones();

    //- The front with multiple normals at angles below one [deg], and the room
    //  in front of it
    void makeFront(scalar angle);

    void makeField();

    //- The lines of the isotropic field, the exact and the smooth one: on the
    //  lines of the others columns beside concave edges cross
    columnLines linesOfField(const columnStarts& starts);

    void makeColumns();

    //- Certified layers
    void makeLayers();

    //- Drop what columns alone need, unless stages are kept
    void dropField();

    //- Make from the front on what a member makes; if no layers are possible
    //  with the multiple normals that were chosen, with those that are needed
    template<class Make>
    void withFewerNormals(const Make& make);

public:

    pipeline
    (
        const wallSurface& wall,
        const prismLayerControls& controls,
        const stageObserver& observer,
        const bool keepStages
    )
    :
        wall_(wall),
        controls_(controls),
        observer_(observer),
        keepStages_(keepStages),
        search_(wall)
    {}

    prismLayerMesh run(const localHeights& local);
};


scalarField pipeline::thickness() const
{
    return controls_.layers.onLevelSets
      ? uniformSpacing(m_.graded).thickness : m_.graded.thickness;
}


void pipeline::makeHeights(const localHeights& local)
{
    observer_.begin("layerSpacing");
    m_.addressing = makeWallAddressing(wall_);
    m_.request =
        makeLayerSpacing(wall_, m_.addressing, controls_.layers, local);
    requireCountable(m_.addressing.edges.size(), m_.request.nLayers);
    m_.graded = gradedSpacing
    (
        m_.request, m_.addressing, controls_.layers.transitionRatio
    );
    observer_.end
    (
        text(m_.graded.nLayers, " layers\n",
            describe(m_.request, wall_, controls_.layers).c_str())
    );
}


void pipeline::makeCones()
{
    observer_.begin("wallVisibility");
    m_.visibility = makeWallVisibility(wall_, m_.addressing);
    m_.pointKinds = kindsOfPoints(wall_, m_.addressing, m_.visibility);
    observer_.end(sizesOf(m_.pointKinds));
}


void pipeline::makeFront(const scalar angle)
{
    observer_.begin("layerFront");
    m_.front = makeLayerFront
    (
        wall_, m_.addressing, m_.visibility, degToRad(angle)
    );
    observer_.end(sizesOf(m_.front));

    observer_.begin("wallClearance");
    m_.clearance = makeWallClearance
    (
        m_.front.surface, search_, m_.front.visibility,
        2*controls_.envelope.scale*m_.front.ofColumns(thickness()),
        controls_.layers.maxStretch
    );
    observer_.end(text("room from ", min(m_.clearance), " m"));
}


void pipeline::makeField()
{
    m_.pieces.clear();
    m_.noField.clear();

    if (!controls_.layers.alongField && !controls_.layers.onLevelSets)
    {
        m_.noField = "marchingDirections axes needs none";
        m_.fields.failure = m_.noField;
        m_.spacing = m_.graded;
        return;
    }

    m_.envelope = makeEnvelope
    (
        wall_, m_.addressing, search_, m_.visibility, m_.pointKinds,
        thickness(), m_.front.smallest(m_.clearance), controls_, observer_
    );

    // Closed walls that are large
    if (wall_.border.sides.empty() && !controls_.layers.onLevelSets)
    {
        m_.pieces =
            divideWall(wall_.points, m_.envelope.radius, pieceControls());
    }
    if (m_.pieces.empty() || keepStages_)
    {
        m_.fields = makeFields
        (
            wall_, m_.addressing, search_, m_.envelope, controls_.field,
            observer_
        );
    }
    if (m_.pieces.empty())
    {
        m_.noField = m_.fields.failure;
    }

    if (controls_.layers.onLevelSets)
    {
        const levelSetLayers onSets
        (
            makeLevelSets
            (
                m_.fields, wall_, m_.addressing, search_, m_.visibility,
                m_.pointKinds, m_.graded, controls_, observer_
            )
        );
        m_.field = onSets.field;
        m_.spacing = onSets.spacing;
    }
    else
    {
        m_.field = m_.fields.anisotropic;
        m_.spacing = m_.graded;
    }
}


columnLines pipeline::linesOfField(const columnStarts& starts)
{
    if (m_.pieces.empty())
    {
        return makeColumnLines
        (
            m_.fields.background, m_.fields.isotropic, starts,
            controls_.layers.onLevelSets
          ? lineDirections::agreeing : lineDirections::unit
        );
    }

    const dividedWall wall
    {
        wall_, m_.addressing, search_, m_.envelope, m_.pieces, pieceControls()
    };
    return makeLinesOfPieces
    (
        wall, starts, controls_.field, observer_, m_.noField
    );
}


void pipeline::makeColumns()
{
    const layerFront& front = m_.front;
    const layerSpacing spacing(m_.spacing.at(front.wallPoints));
    const columnStarts starts
    {
        front.wallPoints, front.visibility.axes(), requestedHeights(spacing)
    };
    gradientLines straight
    (
        makeStraightLines
        (
            front.surface.points, starts.directions, starts.arcLengths
        )
    );

    const bool hasField = m_.pieces.size() || m_.noField.empty();
    if (hasField && controls_.layers.alongField)
    {
        columnLines along(linesOfField(starts));
        if (!controls_.layers.onLevelSets)
        {
            const scalarField shares
            (
                straightShares(front, along.slopes, spacing.thickness)
            );
            straighten(straight, shares, along.lines);
        }
        m_.lines = std::move(along.lines);
    }
    else
    {
        m_.lines = std::move(straight);
    }

    observer_.begin("layerColumns");
    m_.columns = makeLayerColumns
    (
        front, m_.clearance, spacing, m_.lines, controls_.layers
    );
    observer_.end(text(front.wallPoints.size(), " columns"));
}


void pipeline::makeLayers()
{
    const layerFront& front = m_.front;
    const layerSpacing spacing(m_.spacing.at(front.wallPoints));

    observer_.begin("prismLayers");
    layerMoveControls moves;
    moves.quality = controls_.quality;
    m_.made = makePrismLayers(front, spacing, m_.columns, moves);
    nameCauses
    (
        front, m_.pointKinds, m_.request.at(front.wallPoints), spacing,
        m_.columns, m_.made
    );
    observer_.end(sizesOf(m_.made));

    observer_.begin("prismQuality");
    m_.certificate = certify(m_.made.layers);
    m_.bounds = controls_.quality;
    m_.faces = boundsOfLayers
    (
        m_.made.layers, layerGeometry(m_.made.layers, front.addressing),
        m_.bounds
    );
    observer_.end(sizesOf(m_.certificate));

    if (!m_.certificate.valid())
    {
        FatalErrorInFunction
            << "The layers could not be certified" << exit(FatalError);
    }
}


void pipeline::dropField()
{
    if (keepStages_)
    {
        return;
    }
    m_.envelope = offsetEnvelope();
    m_.fields = wallFields();
    m_.field.clear();
    m_.lines = gradientLines();
    returnMemory();
}


template<class Make>
void pipeline::withFewerNormals(const Make& make)
{
    const scalar angle = controls_.layers.multipleNormalsAngle;

    try
    {
        make(angle);
    }
    catch (const wallPointsError& e)
    {
        if (angle <= 0)
        {
            throw;
        }

        observer_.end
        (
            text("Not with multipleNormalsAngle ", angle, ", now with 0. ",
                e.message().c_str())
        );
        make(0);
    }
}


prismLayerMesh pipeline::run(const localHeights& local)
{
    makeHeights(local);
    makeCones();
    withFewerNormals([&](const scalar angle)
    {
        makeFront(angle);
        makeField();
        makeColumns();
        dropField();
        makeLayers();
    });

    if (!keepStages_)
    {
        m_.visibility = wallVisibility();
        m_.front.visibility = wallVisibility();
        m_.columns = layerColumns();
    }

    return std::move(m_);
}

} // End anonymous namespace

// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerMesh makePrismLayerMesh
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const localHeights& local,
    const stageObserver& observer,
    const bool keepStages
)
{
    return pipeline(wall, controls, observer, keepStages).run(local);
}


void addFarField
(
    const farFieldControls& controls,
    farFieldDomain domain,
    const stageObserver& observer,
    prismLayerMesh& m
)
{
    observer.begin("farFieldMesh");
    m.farField = makeFarFieldMesh
    (
        m.made.layers, m.front.addressing, std::move(domain), controls
    );
    observer.end(sizesOf(m.farField));
}

} // End namespace Foam

// ************************************************************************* //
