/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicStages.H"
#include "layerStages.H"
#include "periodicShare.H"
#include "planarColumns.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

template<class Type>
static List<Type> some(const UList<Type>& values, const labelUList& which)
{
    return List<Type>(UIndirectList<Type>(values, which));
}


//- The proposals for the columns of a share: the proposals for own columns, and
//  the images of these proposals
static layerColumns columnsOfShare
(
    const layerColumns& all,
    const frontShare& share
)
{
    layerColumns columns(all.at(share.ownColumns));
    forAll(share.ownColumns, c)
    {
        const rigidMotion& motion = share.motions[share.motionOfColumn[c]];
        for (label i = 0; i < columns.nLayers; ++i)
        {
            vector& offset = columns.offsets[c*columns.nLayers + i];
            offset = motion.turned(offset);
        }
    }

    return columns;
}


//- The layers on some columns of a share.
//  front: on these columns
static madeLayers layersOf
(
    const madeLayers& ofShare,
    const frontShare& share,
    const layerFront& front,
    const labelUList& columns
)
{
    const prismLayers& from = ofShare.layers;
    madeLayers made;
    made.layers = layersWithoutPoints(front, from.nLayers);
    made.layers.isCut = from.isCut;
    made.layers.points.setSize(columns.size()*(from.nLayers + 1));
    forAll(columns, c)
    {
        for (label i = 0; i <= from.nLayers; ++i)
        {
            made.layers.points[made.layers.index(c, i)] = from(columns[c], i);
        }
    }
    made.thickness = scalarField(ofShare.thickness, columns);
    made.causes = some(ofShare.causes, columns);
    made.certified.nRetreats = ofShare.certified.nRetreats;

    const labelHashSet gaveWay(some(share.ownColumns, ofShare.gaveWay));
    forAll(columns, c)
    {
        if (gaveWay.found(share.ownColumns[columns[c]]))
        {
            made.gaveWay.append(c);
        }
    }

    return made;
}


//- Keeps the stages of some columns, if stages are kept
static void keepStagesOf(const labelUList& columns, prismLayerMesh& mesh)
{
    if (mesh.clearance.empty())
    {
        return;
    }

    mesh.clearance = scalarField(mesh.clearance, columns);
    mesh.columns = mesh.columns.at(columns);
    const gradientLines all(std::move(mesh.guide.lines));
    gradientLines& lines = mesh.guide.lines;
    const label n = all.nSamples;
    lines.nSamples = n;
    lines.points.setSize(columns.size()*n);
    lines.energies.setSize(columns.size()*n);
    forAll(columns, c)
    {
        for (label i = 0; i < n; ++i)
        {
            lines.points[c*n + i] = all.points[columns[c]*n + i];
            lines.energies[c*n + i] = all.energies[columns[c]*n + i];
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

prismLayerControls withImages
(
    prismLayerControls controls,
    const UList<sidePatch>& given,
    const UList<sidePatch>& ofImages
)
{
    farBoundaryControls& boundary = controls.farField.boundary;
    for (const sidePair& pair : pairsOf(given))
    {
        const boundBox box(boundary.box);
        for (const label s : {pair.first, pair.second})
        {
            const vector move(ofImages[s].origin - given[s].origin);
            boundary.box.add(boundBox(box.min() + move, box.max() + move));
        }
        if (pair.toSecond.turns)
        {
            boundary.type = farBoundaryType::none;
        }
    }

    return controls;
}


localHeights withImages(const localHeights& local, const periodicWall& images)
{
    const auto ofImages = [&](const scalarField& values)
    {
        return values.empty() ? values : scalarField(values, images.bases);
    };
    localHeights all;
    for (const boolList& inRegion : local.inRegion)
    {
        all.inRegion.append(some(inRegion, images.bases));
    }
    all.firstThickness = ofImages(local.firstThickness);
    all.thickness = ofImages(local.thickness);
    all.yPlusPerHeight = ofImages(local.yPlusPerHeight);
    all.largestCells = ofImages(local.largestCells);

    return all;
}


void makePeriodicLayers
(
    const wallSurface& given,
    const periodicWall& images,
    const plannedColumns& planned,
    const prismLayerControls& controls,
    const stageObserver& observer,
    prismLayerMesh& mesh
)
{
    const frontShare share
    (
        makePeriodicShare(given, images, mesh.share.front)
    );
    const layerFront& front = share.front;
    const labelList points
    (
        SubList<label>
        (
            share.columns.whole,
            front.wallPoints.size() - front.extraColumnPoints().size()
        )
    );
    const layerSpacing spacing(planned.spacing.at(share.ownColumns));
    const layerColumns columns(columnsOfShare(planned.columns, share));

    madeLayers made
    (
        makeLayers
        (
            front, some(mesh.pointKinds, points), mesh.request.at(points),
            spacing, columns, controls,
            columnTeam(share, processTeam::alone()), observer
        )
    );
    if (made.certified.pointsWithoutHeight.size())
    {
        mesh.made = std::move(made);
        return;
    }

    labelList kept;
    layerFront ofGiven(givenFront(given, share, kept));
    mesh.made = layersOf(made, share, ofGiven, kept);
    makePlanar
    (
        columnsAcross
        (
            ofGiven.surface.faces, ofGiven.surface.border,
            ofGiven.surface.points
        ),
        mesh.made.layers
    );
    keepStagesOf(some(share.columns.whole, kept), mesh);
    mesh.share = frontShare();
    mesh.share.front = std::move(ofGiven);
    mesh.pointKinds.setSize(images.nPoints);
    mesh.request = mesh.request.at(identity(images.nPoints));
}

} // End namespace Foam

// ************************************************************************* //
