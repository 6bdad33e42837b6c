/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "meshCertificate.H"
#include "labelledTriangle.H"
#include "wallStacks.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static bool isFinite(const point& p)
{
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}


static void addTriangles
(
    const polyhedralMesh& mesh,
    const label facei,
    const bool isOuter,
    std::vector<labelledTriangle>& triangles,
    DynamicList<labelPair>& intersections
)
{
    const face& f = mesh.faces()[facei];

    for (label k = 1; k + 1 < f.size(); ++k)
    {
        labelledTriangle t;
        t.facei = facei;

        const label labels[3] = {f[0], f[k], f[k + 1]};
        bool finite = true;

        for (int j = 0; j < 3; ++j)
        {
            t.labels[j] = labels[j];
            t.points[j] = mesh.points()[labels[j]];
            finite = finite && isFinite(t.points[j]);
        }

        if (finite && !t.degenerate())
        {
            triangles.push_back(t);
        }
        else if (isOuter || !finite)
        {
            intersections.append(labelPair(facei, facei));
        }
    }
}


static boolList pointsOf(const polyhedralMesh& mesh, const labelUList& faces)
{
    boolList found(mesh.points().size(), false);

    for (const label facei : faces)
    {
        for (const label p : mesh.faces()[facei])
        {
            found[p] = true;
        }
    }

    return found;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::findIntersections
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const labelUList& outerFaces
)
{
    DynamicList<labelPair> pairs;
    std::vector<labelledTriangle> triangles;

    for (const label facei : wallFaces)
    {
        addTriangles(mesh, facei, false, triangles, pairs);
    }
    for (const label facei : outerFaces)
    {
        addTriangles(mesh, facei, true, triangles, pairs);
    }

    addIntersections(triangles, std::vector<labelledTriangle>(), pairs);

    return List<labelPair>(std::move(pairs));
}


Foam::meshCertificate Foam::certifyMesh
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const labelUList& outerFaces
)
{
    meshCertificate certificate;

    const boolList onWall(pointsOf(mesh, wallFaces));
    boolList positive(mesh.nCells());
    DynamicList<label> cells;
    DynamicList<meshCellShape> shapes;

    meshCell cell(mesh, onWall);

    forAll(positive, celli)
    {
        const meshCellVerdict verdict(cell(celli));

        positive[celli] = verdict.positive;
        ++certificate.nCells[label(verdict.shape)];

        if (!verdict.positive)
        {
            ++certificate.nInvalid[label(verdict.shape)];
            cells.append(celli);
            shapes.append(verdict.shape);
        }
    }

    certificate.invalidCells.transfer(cells);
    certificate.invalidShapes.transfer(shapes);
    certificate.nLayers = countLayers(mesh, wallFaces, positive);

    if (outerFaces.size())
    {
        certificate.intersections =
            findIntersections(mesh, wallFaces, outerFaces);
    }

    return certificate;
}


// ************************************************************************* //
