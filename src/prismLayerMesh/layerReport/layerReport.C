/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "layerReport.H"
#include "faceHeights.H"
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

//- What is reported of the wall's faces and points
struct wallSample
{
    const wallSurface& wall;
    const layerSpacing& spacing;
    const faceHeights& heights;
    const layerCertificate& certificate;
    const UList<squeezeCause>& causes;

    patchReport report(const word& name, const labelUList& faces) const;

    //- Complete what the points of the faces say
    void addPoints(const labelUList& faces, patchReport& patch) const;
};


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
        patch.request.firstThickness.add(spacing.firstThickness[p]);
        patch.request.ratio.add(spacing.ratio[p]);
        patch.request.thickness.add(spacing.thickness[p]);
        ++patch.points[int(causes[p])];
    }
}


patchReport wallSample::report(const word& name, const labelUList& faces) const
{
    patchReport patch;
    patch.name = name;
    patch.nFaces = faces.size();

    const label n = spacing.nLayers - 1;
    scalar fullArea = 0;
    DynamicField<scalar> growth;

    for (const label facei : faces)
    {
        const scalar area = heights.areas[facei];
        patch.area += area;
        fullArea += heights.totalOverRequest[facei] >= 0.99 ? area : 0;
        growth.append(SubList<scalar>(heights.growthOverRequest, n, facei*n));
    }

    if (faces.size())
    {
        const scalarField jacobians(certificate.worstJacobian, faces);

        // The certificate is valid
        patch.layersReached = spacing.nLayers;
        patch.fullLayersArea = 100;
        patch.fullThicknessArea = 100*fullArea/max(patch.area, VSMALL);
        patch.worstJacobian = min(jacobians);
        patch.meanJacobian = average(jacobians);
    }

    patch.firstHeight =
        makePercentiles(scalarField(heights.firstOverRequest, faces));
    patch.totalThickness =
        makePercentiles(scalarField(heights.totalOverRequest, faces));
    patch.growth = makePercentiles(growth);
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


percentiles makePercentiles(scalarField values)
{
    percentiles result;

    if (values.empty())
    {
        return result;
    }

    // What is below a rank that was found need not be looked at again
    auto start = values.begin();

    const auto percentile = [&](const scalar percent)
    {
        const label rank = label(0.01*percent*(values.size() - 1) + 0.5);

        std::nth_element(start, values.begin() + rank, values.end());
        start = values.begin() + rank;

        return *start;
    };

    result.mean = average(values);
    result.min = percentile(0);
    result.p1 = percentile(1);
    result.p5 = percentile(5);
    result.p50 = percentile(50);
    result.p95 = percentile(95);
    result.p99 = percentile(99);
    result.max = percentile(100);

    return result;
}


layerReport makeLayerReport
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerSpacing& spacing,
    const prismLayers& layers,
    const layerCertificate& certificate,
    const UList<squeezeCause>& causes
)
{
    const faceHeights heights(makeFaceHeights(wall, spacing, layers));
    const wallSample sample{wall, spacing, heights, certificate, causes};

    layerReport report;
    report.nWallFaces = wall.faces.size();
    report.nWallPoints = wall.points.size();
    report.nCells = certificate.nCells;
    report.firstHeightChange =
        makePercentiles(changesOverEdges(addressing, heights.first));
    report.wall = sample.report("allPatches", identity(report.nWallFaces));

    const wordList names(prismPatchNames(wall.patchNames));
    const labelListList patchFaces
    (
        invertOneToMany(names.size(), wall.patchIDs)
    );
    report.patches.setSize(names.size(), report.wall);
    #pragma omp parallel for schedule(dynamic) if (names.size() > 1)
    forAll(names, patchi)
    {
        if (names.size() > 1)
        {
            report.patches[patchi] =
                sample.report(names[patchi], patchFaces[patchi]);
        }
        report.patches[patchi].name = names[patchi];
    }

    for (const squeezeCause cause : causes)
    {
        ++report.columns[int(cause)];
    }

    for (const label facei : certificate.outlyingCentres)
    {
        report.outlyingCentres.append(middleOnWall(layers, facei));
    }

    return report;
}


layerReport makeLayerReport
(
    const wallSurface& wall,
    const prismLayerMesh& mesh
)
{
    const madeLayers& made = mesh.made;
    layerReport report
    (
        makeLayerReport
        (
            wall, mesh.addressing, mesh.heights.request, made.layers,
            mesh.certificate, made.causes
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
