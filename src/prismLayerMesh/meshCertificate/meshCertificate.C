/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshCertificate.H"
#include "labelledTriangle.H"
#include "ListOps.H"
#include "ranges.H"

#include <algorithm>
#include <cmath>

namespace Foam
{

//- Whether a cell is the last one of the layers on a face: all of its faces
//  that are apart from the face lead to cells beyond the layers
static bool isLastLayer
(
    const polyhedralMesh& mesh,
    const label facei,
    const label celli,
    const bitSet& beyondLayers
)
{
    const labelList tops(mesh.apart(facei, celli));

    return tops.size() && allOf(tops, [&](const label top)
    {
        const label above = mesh.across(top, celli);

        return above >= 0 && beyondLayers.test(above);
    });
}


//- The face through which a stack leaves a cell: the face and the given one are
//  opposite to each other; -1 if there is none. A walk along these faces ends.
static label topOfStack
(
    const polyhedralMesh& mesh,
    const label facei,
    const label celli
)
{
    const label top = mesh.opposite(facei, celli);

    return top >= 0 && mesh.opposite(top, celli) == facei ? top : -1;
}


//- Number of layers of positive cells on each face of the wall. A stack goes on
//  from a face to the opposite face of the cell, the only one without a common
//  point, and from there to the next cell. It ends at the boundary, or at a
//  cell that has no face opposite to the one below. The last cell may have
//  several faces there: if they are what one face is cut into, as below the
//  tetrahedra of a far field, or if all of them lead beyond the layers, as
//  below polyhedra. A stack ends where it leaves the layers. If it does not
//  begin in the layers, none of its cells is counted. Cells that are not
//  positive, and those above them, are not counted either.
static labelList countLayers
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const boolList& positive,
    const bitSet& beyondLayers
)
{
    labelList nLayers(wallFaces.size(), Zero);
    forAll(wallFaces, i)
    {
        label facei = wallFaces[i];
        label celli = mesh.owner(facei);
        bool counts = !beyondLayers.test(celli);
        const bool hasLayers = counts;

        while (celli >= 0 && !(hasLayers && beyondLayers.test(celli)))
        {
            counts = counts && positive[celli];
            const label next = topOfStack(mesh, facei, celli);
            if (next < 0)
            {
                nLayers[i] += counts
                 && (
                        mesh.hasCutTop(facei, celli)
                     || isLastLayer(mesh, facei, celli, beyondLayers)
                    );
                break;
            }

            nLayers[i] += counts;
            facei = next;
            celli = mesh.across(facei, celli);
        }
    }

    return nLayers;
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


static scalar boundaryVolumeOf(const polyhedralMesh& mesh)
{
    const point middle(boundBox(mesh.points(), false).midpoint());
    scalar volume = 0;
    forAll(mesh.faces(), facei)
    {
        const label owner = mesh.owner(facei);
        if (mesh.across(facei, owner) < 0)
        {
            volume += mesh.pyramidVolume(facei, owner, middle);
        }
    }

    return volume;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool meshCertificate::fillsBoundary() const
{
    return mag(cellVolume - boundaryVolume) < 1e-9*mag(boundaryVolume);
}


List<labelPair> findDoubleFaces(const faceList& faces)
{
    // Faces of the same points have the same smallest point
    label nPoints = 0;
    labelList smallest(faces.size());
    forAll(faces, facei)
    {
        smallest[facei] = min(faces[facei]);
        nPoints = max(nPoints, smallest[facei] + 1);
    }
    const labelListList facesAt(invertOneToMany(nPoints, smallest));

    DynamicList<labelPair> pairs;
    for (const labelList& candidates : facesAt)
    {
        forAll(candidates, i)
        {
            for (label j = i + 1; j < candidates.size(); ++j)
            {
                const labelPair pair(candidates[i], candidates[j]);
                if (face::sameVertices(faces[pair[0]], faces[pair[1]]))
                {
                    pairs.append(pair);
                }
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());

    return List<labelPair>(std::move(pairs));
}


//- The shapes of cells, and whether they are positive. Returns their volume
//  [m3]. Given cells stay positive.
static scalar judgeCells
(
    const polyhedralMesh& mesh,
    const boolList& onWall,
    const bitSet& given,
    boolList& positive,
    List<meshCellShape>& shapes
)
{
    scalarField volumes(mesh.nCells(), 0);

    #pragma omp parallel
    {
        meshCell cell(mesh, onWall);

        #pragma omp for schedule(static)
        forAll(positive, celli)
        {
            if (given.test(celli))
            {
                continue;
            }
            const meshCellVerdict verdict(cell(celli));
            shapes[celli] = verdict.shape;
            positive[celli] = verdict.positive && cell.hasVolume();
            volumes[celli] = cell.volume();
        }
    }

    return sum(volumes);
}


meshCertificate certifyMesh
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const labelUList& outerFaces,
    const bitSet& beyondLayers,
    const bitSet& given
)
{
    meshCertificate certificate;

    const boolList onWall(pointsOf(mesh, wallFaces));
    meshCell cell(mesh, onWall);
    boolList positive(mesh.nCells(), true);
    List<meshCellShape> shapes(mesh.nCells(), meshCellShape::polyhedron);
    certificate.cellVolume = judgeCells(mesh, onWall, given, positive, shapes);

    certificate.nLayers = countLayers(mesh, wallFaces, positive, beyondLayers);

    DynamicList<label> cells;
    forAll(positive, celli)
    {
        // Such as a hexahedron that was snapped so that a corner is flat
        if
        (
            !positive[celli] && beyondLayers.test(celli)
         && cell.isPositivePolyhedron(celli)
         && cell.hasVolume()
        )
        {
            shapes[celli] = meshCellShape::polyhedron;
            positive[celli] = true;
        }

        ++certificate.nCells[label(shapes[celli])];
        if (!positive[celli])
        {
            ++certificate.nInvalid[label(shapes[celli])];
            cells.append(celli);
        }
    }

    certificate.invalidShapes = UIndirectList<meshCellShape>(shapes, cells);
    certificate.invalidCells.transfer(cells);
    certificate.doubleFaces = findDoubleFaces(mesh.faces());
    certificate.boundaryVolume = boundaryVolumeOf(mesh);

    if (outerFaces.size())
    {
        certificate.intersections =
            findIntersections(mesh, wallFaces, outerFaces);
    }

    return certificate;
}


bool isBelowLayers
(
    const polyhedralMesh& mesh,
    const label wallFace,
    const bitSet& beyondLayers,
    const bitSet& outerFaces
)
{
    label facei = wallFace;
    label celli = mesh.owner(facei);
    if (beyondLayers.test(celli))
    {
        return false;
    }

    while (celli >= 0 && !beyondLayers.test(celli))
    {
        const label top = topOfStack(mesh, facei, celli);
        if (top < 0)
        {
            return isLastLayer(mesh, facei, celli, beyondLayers);
        }
        facei = top;
        celli = mesh.across(facei, celli);
    }

    return celli >= 0 || outerFaces.test(facei);
}


// * * * * * * * * * * * * *  Mesh Intersections * * * * * * * * * * * * * * //

static bool isFinite(const point& p)
{
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}


//- Cuts faces into fans, and leaves out the triangles that have no area or are
//  not finite. A face with a triangle that is not finite or, with addFlat, has
//  no area is paired with itself.
static std::vector<labelledTriangle> fansOf
(
    const polyhedralMesh& mesh,
    const labelUList& faces,
    const bool addFlat,
    DynamicList<labelPair>& pairs
)
{
    DynamicList<face> fans;
    DynamicList<label> faceOf;
    for (const label facei : faces)
    {
        const face& f = mesh.faces()[facei];

        for (label k = 1; k + 1 < f.size(); ++k)
        {
            fans.append(face({f[0], f[k], f[k + 1]}));
            faceOf.append(facei);
        }
    }

    std::vector<labelledTriangle> sound;

    for
    (
        const labelledTriangle& t
      : labelledTriangles(fans, mesh.points(), faceOf)
    )
    {
        const bool finite =
            isFinite(t.points[0]) && isFinite(t.points[1])
         && isFinite(t.points[2]);

        if (finite && !t.degenerate())
        {
            sound.push_back(t);
        }
        else if (addFlat || !finite)
        {
            pairs.append(labelPair(t.facei, t.facei));
        }
    }

    return sound;
}


List<labelPair> findIntersections
(
    const polyhedralMesh& mesh,
    const labelUList& wallFaces,
    const labelUList& outerFaces
)
{
    DynamicList<labelPair> pairs;
    std::vector<labelledTriangle> triangles
    (
        fansOf(mesh, wallFaces, false, pairs)
    );
    const std::vector<labelledTriangle> outer
    (
        fansOf(mesh, outerFaces, true, pairs)
    );
    triangles.insert(triangles.end(), outer.begin(), outer.end());

    addIntersections(triangles, {}, pairs);

    return List<labelPair>(std::move(pairs));
}

} // End namespace Foam

// ************************************************************************* //
