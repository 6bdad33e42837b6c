/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/


#include "layerReport.H"
#include "faceHeights.H"
#include "prismPolyMesh.H"
#include "bitSet.H"
#include "DynamicField.H"

#include <algorithm>
#include <fstream>
#include <sys/resource.h>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- What is known of the faces of a patch, from which its report is made
struct patchSample
{
    label nFaces = 0;
    scalar area = 0;
    scalar fullLayersArea = 0;
    scalar fullThicknessArea = 0;

    layerRequest request;
    label layersAsked = 0;
    label layersReached = labelMax;
    scalar worstJacobian = GREAT;
    scalar sumJacobian = 0;

    DynamicField<scalar> firstHeight;
    DynamicField<scalar> totalThickness;
    DynamicField<scalar> growth;


    //- Add a face. Its cells are positive up to layersHere, of nLayers
    void add
    (
        const faceHeights& heights,
        label facei,
        label nLayers,
        label layersHere,
        scalar jacobian
    );

    void add(const patchSample& other);

    //- The values are reordered
    patchReport report(const word& name);
};


void patchSample::add
(
    const faceHeights& heights,
    const label facei,
    const label nLayers,
    const label layersHere,
    const scalar jacobian
)
{
    const label n = nLayers - 1;
    const scalar faceArea = heights.areas[facei];
    const scalar thickness = heights.totalOverRequest[facei];

    firstHeight.append(heights.firstOverRequest[facei]);
    totalThickness.append(thickness);
    growth.append(SubList<scalar>(heights.growthOverRequest, n, facei*n));

    ++nFaces;
    area += faceArea;
    fullLayersArea += layersHere == nLayers ? faceArea : 0;
    fullThicknessArea += thickness >= 0.99 ? faceArea : 0;

    layersReached = min(layersReached, layersHere);
    worstJacobian = min(worstJacobian, jacobian);
    sumJacobian += jacobian;
}


void patchSample::add(const patchSample& other)
{
    nFaces += other.nFaces;
    area += other.area;
    fullLayersArea += other.fullLayersArea;
    fullThicknessArea += other.fullThicknessArea;

    request.add(other.request);
    layersAsked = max(layersAsked, other.layersAsked);
    layersReached = min(layersReached, other.layersReached);
    worstJacobian = min(worstJacobian, other.worstJacobian);
    sumJacobian += other.sumJacobian;

    firstHeight.append(other.firstHeight);
    totalThickness.append(other.totalThickness);
    growth.append(other.growth);
}


patchReport patchSample::report(const word& name)
{
    patchReport patch;
    patch.name = name;
    patch.nFaces = nFaces;
    patch.area = area;
    patch.request = request;
    patch.layersAsked = layersAsked;

    if (nFaces)
    {
        patch.layersReached = layersReached;
        patch.fullLayersArea = 100*fullLayersArea/max(area, VSMALL);
        patch.fullThicknessArea = 100*fullThicknessArea/max(area, VSMALL);
        patch.worstJacobian = worstJacobian;
        patch.meanJacobian = sumJacobian/nFaces;
    }

    patch.firstHeight = makePercentiles(firstHeight);
    patch.totalThickness = makePercentiles(totalThickness);
    patch.growth = makePercentiles(growth);

    return patch;
}


//- Layers below the lowest cell that is not positive
static labelList validLayers
(
    const prismLayers& layers,
    const layerCertificate& certificate
)
{
    labelList valid(layers.faces.size(), layers.nLayers);

    return valid;
}


static List<patchSample> samplePatches
(
    const wallSurface& wall,
    const layerSpacing& spacing,
    const faceHeights& heights,
    const prismLayers& layers,
    const layerCertificate& certificate
)
{
    List<patchSample> samples(wall.patchNames.size());

    const labelList valid(validLayers(layers, certificate));

    forAll(wall.faces, facei)
    {
        patchSample& sample = samples[wall.patchIDs[facei]];
        const face& f = wall.faces[facei];

        sample.add
        (
            heights,
            facei,
            layers.nLayers,
            valid[facei],
            certificate.worstJacobian[facei]
        );

        // Between patches, the thinner one's count
        sample.layersAsked =
            max(sample.layersAsked, min(labelList(spacing.layersAsked, f)));

        for (const label p : f)
        {
            sample.request.add(spacing, p);
        }
    }

    return samples;
}

//- Points of the faces of patches by their cause
static void countCauses
(
    const wallSurface& wall,
    const UList<squeezeCause>& causes,
    List<patchReport>& patches
)
{
    List<bitSet> points(patches.size());

    forAll(wall.faces, facei)
    {
        points[wall.patchIDs[facei]].set(wall.faces[facei]);
    }

    forAll(patches, patchi)
    {
        patches[patchi].points = Zero;

        for (const label p : points[patchi])
        {
            ++patches[patchi].points[int(causes[p])];
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::layerRequest::add(const layerSpacing& spacing, const label p)
{
    firstThickness.add(spacing.firstThickness[p]);
    ratio.add(spacing.ratio[p]);
    thickness.add(spacing.thickness[p]);
}


void Foam::layerRequest::add(const layerRequest& other)
{
    firstThickness.add(other.firstThickness);
    ratio.add(other.ratio);
    thickness.add(other.thickness);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::peakMemory()
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


Foam::percentiles Foam::makePercentiles(scalarField& values)
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


Foam::layerReport Foam::makeLayerReport
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const layerSpacing& spacing,
    const prismLayers& layers,
    const layerCertificate& certificate,
    const UList<squeezeCause>& causes
)
{
    layerReport report;
    report.nWallFaces = wall.faces.size();
    report.nWallPoints = wall.points.size();
    report.nCells = certificate.nCells;
    report.nInvalidCells = certificate.nStacksNotPositive;
    report.nIntersectingPairs = certificate.nIntersectingPairs;

    for (const label facei : certificate.outlyingCentres)
    {
        const face& columns = layers.faces[facei];
        point mean(Zero);
        for (const label c : columns)
        {
            mean += layers(c, 0)/columns.size();
        }
        report.outlyingCentres.append(mean);
    }

    const faceHeights heights(makeFaceHeights(wall, spacing, layers));
    List<patchSample> samples
    (
        samplePatches(wall, spacing, heights, layers, certificate)
    );
    scalarField changes(changesOverEdges(addressing, heights.first));
    report.firstHeightChange = makePercentiles(changes);

    patchSample all;
    for (const patchSample& sample : samples)
    {
        all.add(sample);
    }
    report.wall = all.report("allPatches");
    report.wall.points = Zero;

    const wordList names(prismPatchNames(wall.patchNames));
    report.patches.setSize(names.size());
    forAll(samples, patchi)
    {
        report.patches[patchi] = samples[patchi].report(names[patchi]);
    }
    countCauses(wall, causes, report.patches);

    report.points = Zero;
    report.columns = Zero;
    for (const squeezeCause cause : causes)
    {
        ++report.columns[int(cause)];
    }
    for (label p = 0; p < report.nWallPoints; ++p)
    {
        ++report.wall.points[int(causes[p])];
    }

    return report;
}


// ************************************************************************* //
