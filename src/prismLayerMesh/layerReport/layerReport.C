/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "faceHeights.H"
#include "limitHeightJumps.H"
#include "prismPolyMesh.H"
#include "bitSet.H"
#include "DynamicField.H"
#include "IOobject.H"
#include "ListOps.H"
#include "OFstream.H"

#include <algorithm>
#include <fstream>
#include <string>
#include <sys/resource.h>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What is reported of the wall's faces and points, as far as this process has
//  them
struct wallSample
{
    const wallSurface& wall;
    const layerSpacing& spacing;
    const faceHeights& heights;
    const layerCertificate& certificate;
    const prismLayers& layers;
    const UList<squeezeCause>& causes;
    const columnTeam& team;

    //- The report on some faces of the wall, of all processes. Collective
    patchReport report(const word& name, const labelUList& faces) const;

    //- Complete what own points of the faces say
    void addPoints(const labelUList& faces, patchReport& patch) const;

    //- Complete what areas and Jacobians of the faces say
    void addFaces(const labelUList& counted, patchReport& patch) const;
};


template<class Type>
static MinMax<Type> ofAll(const MinMax<Type>& range, const columnTeam& team)
{
    return MinMax<Type>
    (
        team.reduce(range.min(), minOp<Type>()),
        team.reduce(range.max(), maxOp<Type>())
    );
}


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
        // The certificate is valid
        patch.layersReached = spacing.nLayers;
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
    DynamicField<scalar> growth;
    for (const label facei : counted)
    {
        growth.append(SubList<scalar>(heights.growthOverRequest, n, facei*n));
    }
    patch.firstHeight =
        makePercentiles(scalarField(heights.firstOverRequest, counted), team);
    patch.totalThickness =
        makePercentiles(scalarField(heights.totalOverRequest, counted), team);
    patch.growth = makePercentiles(growth, team);
    addPoints(faces, patch);

    return patch;
}

} // End anonymous namespace

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


//- The wall under a share of a front
static wallSurface wallOf(const layerFront& front)
{
    const label nPoints =
        front.wallPoints.size() - front.extraColumnPoints().size();
    wallSurface wall;
    wall.points = SubList<point>(front.surface.points, nPoints);
    wall.faces = SubList<face>(front.surface.faces, front.nWallFaces);
    for (face& f : wall.faces)
    {
        inplaceRenumber(front.wallPoints, f);
    }
    wall.patchIDs = SubList<label>(front.surface.patchIDs, front.nWallFaces);
    wall.patchNames = front.surface.patchNames;

    return wall;
}


//- The two faces of each edge of the wall that this process counts. The master
//  counts the edges with one face, here with the same face twice.
static List<labelPair> edgesOfShare
(
    const frontShare& share,
    const wallSurface& whole,
    const columnTeam& team
)
{
    DynamicList<labelPair> edges;
    for (const labelPair& two : neighboursOnWall(share.front))
    {
        const label lower = min(two.first(), two.second());
        if (team.counts(share.front.surface.faces[lower]))
        {
            edges.append(two);
        }
    }
    if (team.isMaster())
    {
        edges.append
        (
            List<labelPair>(whole.border.edges.size(), labelPair(0, 0))
        );
    }

    return List<labelPair>(std::move(edges));
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
    report.firstHeightChange =
        makePercentiles(changesOverEdges(edgeFaces, heights.first), team);
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

    forAll(causes, c)
    {
        report.columns[int(causes[c])] += team.isOwn(c);
    }
    for (label& n : report.columns)
    {
        n = team.sum(n);
    }
    label nOwnPoints = 0;
    forAll(wall.points, p)
    {
        nOwnPoints += team.isOwn(p);
    }
    report.nWallPoints = team.sum(nOwnPoints);
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
    const madeLayers& made = mesh.made;
    layerReport report
    (
        team.isAlone()
      ? makeLayerReport
        (
            wall, mesh.addressing.edgeFaces, mesh.heights.request, made.layers,
            mesh.certificate, made.causes, team
        )
      : makeLayerReport
        (
            wallOf(mesh.share->front), edgesOfShare(*mesh.share, wall, team),
            mesh.heights.request.at(mesh.share->wallPoints()), made.layers,
            mesh.certificate, made.causes, team
        )
    );
    report.points = countKinds(mesh.pointKinds);
    report.nExtraColumns = mesh.front.extraColumnPoints().size();
    report.nRetreats = made.certified.nRetreats;
    report.noField = mesh.noField;
    report.faces = mesh.faces;

    return report;
}


void writeReport(const fileName& file, const dictionary& report)
{
    OFstream os(file);
    IOobject::writeBanner(os);
    report.write(os, false);
    IOobject::writeEndDivider(os);
    os.flush();

    if (!os.good())
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
