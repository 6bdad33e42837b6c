/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    columnMeasures

Description
    What the field is worth to the layers.

    Reads the wall and system/harmonicPrismMeshDict of the case, and makes the
    layers with straight columns, on the axes of the visibility cones, and with
    columns along each field. Prints a line, between tabs, for each: field,
    share of the wall's area at full thickness [%], share of the columns [%],
    mean thickness over the request, retreats, internal faces beyond 70 degrees
    and beyond 80, faces of a skewness beyond 4, seconds.

Usage
    columnMeasures [-fields '(name ...)']

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cpuTime.H"
#include "memoryMesh.H"
#include "patchReport.H"
#include "polyMeshTools.H"
#include "preparedCase.H"
#include "prismLayerMesh.H"

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Number of values beyond a bound, and what it is of
template<class Values, class Test>
static label count(const Values& values, const label n, const Test& isBeyond)
{
    label nBeyond = 0;
    for (label i = 0; i < n; ++i)
    {
        nBeyond += isBeyond(values[i]);
    }

    return nBeyond;
}


static void printQuality(const prismLayers& layers)
{
    const memoryMesh memory(layers);
    const polyMesh& mesh = memory();
    const scalarField cosines
    (
        polyMeshTools::faceOrthogonality
        (
            mesh, mesh.faceAreas(), mesh.cellCentres()
        )
    );
    const scalarField skewness
    (
        polyMeshTools::faceSkewness
        (
            mesh, mesh.points(), mesh.faceCentres(), mesh.faceAreas(),
            mesh.cellCentres()
        )
    );

    for (const scalar degrees : {70.0, 80.0})
    {
        const scalar bound =
            ::cos(degrees*constant::mathematical::pi/180);

        Info<< '\t' << count
        (
            cosines, mesh.nInternalFaces(),
            [&](const scalar cosine) { return cosine < bound; }
        );
    }

    Info<< '\t' << count
    (
        skewness, mesh.nFaces(), [](const scalar s) { return s > 4; }
    );
}


static void measure
(
    const wallSurface& wall,
    const prismLayerControls& controls,
    const word& name
)
{
    const cpuTime time;
    const prismLayerMesh m(makePrismLayerMesh(wall, controls, {}, {}));
    const scalar seconds = time.elapsedCpuTime();

    const faceHeights heights(makeFaceHeights(wall, m.request, m.made.layers));
    const label n = m.columns.nLayers;
    scalar full = 0, mean = 0;
    label nFull = 0;

    forAll(wall.faces, facei)
    {
        const scalar total = heights.totalOverRequest[facei];
        full += total >= 0.99 ? heights.areas[facei] : 0;
        mean += total*heights.areas[facei];
    }
    forAll(m.made.thickness, c)
    {
        nFull +=
            m.made.thickness[c] >= 0.99*m.columns.heights[c*n + n - 1];
    }

    const scalar area = sum(heights.areas);
    Info<< name.c_str() << '\t' << 100*full/area << '\t'
        << 100.0*nFull/m.made.thickness.size() << '\t' << mean/area << '\t'
        << m.made.certified.nRetreats;
    printQuality(m.made.layers);
    Info<< '\t' << seconds << endl;
}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::noBanner();
    argList::addOption("fields", "list", "Only these");

    #include "setRootCase.H"
    #include "createTime.H"

    preparedCase given(runTime);
    prismLayerControls& controls = given.controls;
    const wordList fields
    (
        args.getOrDefault
        (
            "fields",
            wordList({"straight", "isotropic", "anisotropic", "gradientPower"})
        )
    );

    for (const word& field : fields)
    {
        controls.layers.alongField = field != "straight";
        controls.field.tensor = field == "straight" ? "isotropic" : field;
        controls.field.tensorCoeffs.clear();
        measure(given.wall, controls, field);
    }

    return 0;
}


// ************************************************************************* //
