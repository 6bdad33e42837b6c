/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "distributeFront.H"
#include "IOobject.H"
#include "limitHeightJumps.H"
#include "ListOps.H"
#include "OFstream.H"
#include "patchReport.H"
#include "pluginVersion.H"
#include "prismPolyMesh.H"
#include "writeJson.H"

#include <algorithm>
#include <fstream>
#include <string>
#include <sys/resource.h>

namespace Foam
{

//- The mean of the points on the wall below a front face
static point middleOnWall(const prismLayers& layers, const label facei)
{
    const face& columns = layers.faces[facei];
    point mean(Zero);
    for (const label c : columns)
    {
        mean += layers(c, 0)/columns.size();
    }

    return mean;
}


//- Places on the wall below front faces of all processes, in the order of the
//  whole front
static pointField placesOf
(
    const labelUList& faces,
    const prismLayers& layers,
    const columnTeam& team
)
{
    DynamicList<label> labels;
    DynamicList<point> middles;
    for (const label facei : faces)
    {
        labels.append(team.wholeFace(facei));
        middles.append(middleOnWall(layers, facei));
    }
    const labelList order(sortedOrder(team.gather(labels)));

    return pointField(pointField(team.gather(middles)), order);
}


//- Returns the place on the wall of the face, of all processes, whose value is
//  least; of several the first face in the whole front. Collective
//  values: of the faces of the wall of this process
static point placeOfLeast
(
    const scalarField& values,
    const prismLayers& layers,
    const columnTeam& team
)
{
    label own = -1;
    forAll(values, facei)
    {
        const bool isLess = own < 0 || values[facei] < values[own];
        own = team.countsFace(facei) && isLess ? facei : own;
    }
    const label n = own < 0 ? 0 : 1;
    const auto gather = [&](const auto& value)
    {
        return team.gather(List<std::decay_t<decltype(value)>>(n, value));
    };
    const scalarList leasts(gather(n ? values[own] : scalar(0)));
    const labelList faces(gather(n ? team.wholeFace(own) : label(0)));
    const List<point> places
    (
        gather(n ? middleOnWall(layers, own) : point(Zero))
    );

    label least = 0;
    forAll(leasts, i)
    {
        const bool isLess = leasts[i] < leasts[least];
        const bool isEqual = !isLess && !(leasts[least] < leasts[i]);
        least = isLess || (isEqual && faces[i] < faces[least]) ? i : least;
    }

    return places.empty() ? point(Zero) : places[least];
}


//- Sets the places where heights are furthest from the request
static void setWorstPlaces
(
    const faceHeights& heights,
    const prismLayers& layers,
    const columnTeam& team,
    layerReport& report
)
{
    const auto factor = [](scalarField ratios)
    {
        for (scalar& ratio : ratios)
        {
            ratio = min(ratio, 1/max(ratio, VSMALL));
        }

        return ratios;
    };
    scalarField growths(heights.areas.size());
    forAll(growths, facei)
    {
        growths[facei] = heights.leastGrowth(facei);
    }

    report.worstFirstHeight =
        placeOfLeast(factor(heights.firstOverRequest), layers, team);
    report.worstThickness =
        placeOfLeast(factor(heights.totalOverRequest), layers, team);
    report.worstGrowth = placeOfLeast(growths, layers, team);
}


//- Edges of all processes at which the first height of faces changes too much
static pointField jumpsOf
(
    const UList<labelPair>& edgeFaces,
    const scalarField& changes,
    const prismLayers& layers,
    const columnTeam& team
)
{
    DynamicList<scalar> large;
    DynamicList<point> middles;
    forAll(changes, e)
    {
        if (changes[e] > layerReport::largeHeightChange)
        {
            const labelPair& faces = edgeFaces[e];
            large.append(-changes[e]);
            middles.append
            (
                0.5
               *(
                    middleOnWall(layers, faces.first())
                  + middleOnWall(layers, faces.second())
                )
            );
        }
    }
    const labelList order(sortedOrder(team.gather(large)));

    return pointField(pointField(team.gather(middles)), order);
}


//- Sets the numbers of columns by cause, and the number of points of the wall.
//  nPoints: number of points of this process, the first columns
static void countColumns
(
    const UList<squeezeCause>& causes,
    const label nPoints,
    const columnTeam& team,
    layerReport& report
)
{
    forAll(causes, c)
    {
        report.columns[int(causes[c])] += team.isOwn(c);
        report.nWallPoints += c < nPoints && team.isOwn(c);
    }
    for (label& n : report.columns)
    {
        n = team.sum(n);
    }
    report.nWallPoints = team.sum(report.nWallPoints);
}


//- The two faces of each edge of the wall that this process counts. The master
//  counts the edges with one face, here with the same face twice.
static List<labelPair> edgesOfShare
(
    const layerFront& front,
    const wallBorder& border,
    const columnTeam& team
)
{
    DynamicList<labelPair> edges;
    for (const labelPair& two : neighboursOnWall(front))
    {
        const label lower = min(two.first(), two.second());
        if (team.countsFace(lower))
        {
            edges.append(two);
        }
    }
    if (team.isMaster())
    {
        edges.append(List<labelPair>(border.edges.size(), labelPair(0, 0)));
    }

    return List<labelPair>(std::move(edges));
}


scalar peakMemory()
{
    // In units of 1024 bytes. Children: TetGen runs in a process of its own
    rusage children;
    ::getrusage(RUSAGE_CHILDREN, &children);
    scalar peak = children.ru_maxrss;

    // Linux: "VmHWM:   123456 kB"
    std::ifstream status("/proc/self/status");

    for (std::string key; status >> key;)
    {
        scalar own = 0;

        if (key == "VmHWM:" && status >> own)
        {
            peak = max(peak, own);
        }
    }

    return 1.024e-3*peak;
}


layerReport makeLayerReport
(
    const wallSurface& wall,
    const UList<labelPair>& edgeFaces,
    const layerSpacing& spacing,
    const prismLayers& layers,
    const layerCertificate& certificate,
    const UList<squeezeCause>& causes,
    const columnTeam& team
)
{
    const faceHeights heights(makeFaceHeights(wall, spacing, layers));
    const wallSample sample
    {
        wall, spacing, heights, certificate, layers, causes, team
    };

    layerReport report;
    report.nCells = certificate.nCells;
    report.valid = certificate.valid();
    report.nStacksNotPositive = certificate.nStacksNotPositive;
    report.nOverlaps = certificate.nOverlaps;
    const scalarField changes(changesOverEdges(edgeFaces, heights.first));
    report.firstHeightChange = makePercentiles(changes, team);
    report.heightJumps = jumpsOf(edgeFaces, changes, layers, team);
    setWorstPlaces(heights, layers, team, report);
    report.wall = sample.report("allPatches", identity(wall.faces.size()));
    report.nWallFaces = report.wall.nFaces;

    const wordList names(prismPatchNames(wall.patchNames));
    const labelListList patchFaces
    (
        invertOneToMany(names.size(), wall.patchIDs)
    );
    report.patches.setSize(names.size(), report.wall);
    #pragma omp parallel for schedule(dynamic) if (team.isAlone())
    forAll(names, patchi)
    {
        if (names.size() > 1)
        {
            report.patches[patchi] =
                sample.report(names[patchi], patchFaces[patchi]);
        }
        report.patches[patchi].name = names[patchi];
    }

    countColumns(causes, wall.points.size(), team, report);
    report.outlyingCentres =
        placesOf(certificate.outlyingCentres, layers, team);

    return report;
}


layerReport makeLayerReport
(
    const wallSurface& wall,
    const prismLayerMesh& mesh,
    const columnTeam& team
)
{
    const layerFront& front = mesh.share.front;
    const madeLayers& made = mesh.made;
    layerReport report
    (
        makeLayerReport
        (
            wallOfFront(front), edgesOfShare(front, wall.border, team),
            mesh.request, made.layers, mesh.certificate, made.causes, team
        )
    );

    const label nPoints = mesh.pointKinds.size();
    forAll(front.wallPoints, c)
    {
        if (team.isOwn(c))
        {
            ++(c < nPoints
              ? report.points[int(mesh.pointKinds[c])] : report.nExtraColumns);
        }
    }
    for (label& n : report.points)
    {
        n = team.sum(n);
    }
    report.nExtraColumns = team.sum(report.nExtraColumns);
    report.nRetreats = made.certified.nRetreats;
    report.noField = mesh.noField;
    report.faces = mesh.faces;

    return report;
}


void writeReport(const fileName& file, const dictionary& report)
{
    OFstream os(file);
    if (file.ext() == "json")
    {
        os.stdStream() << jsonOf(report);
    }
    else
    {
        IOobject::writeBanner(os);
        report.write(os, false);
        IOobject::writeEndDivider(os);
    }
    os.flush();

    if (!os.good())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
