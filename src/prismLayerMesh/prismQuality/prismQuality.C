/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "prismQuality.H"
#include "cellPredicates.H"
#include "HashSet.H"
#include "layerGeometry.H"
#include "layerOverlaps.H"
#include "markedGrid.H"
#include "prismLayers.H"
#include "ranges.H"
#include "scaledJacobian.H"

namespace Foam
{

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

boundBox stackBoxes::boxOf(const label group) const
{
    boundBox box(boundBox::invertedBox);
    for (const label facei : faces(group))
    {
        box.add(Foam::boxOf(layers_, facei, 0));
        box.add(Foam::boxOf(layers_, facei, layers_.nLayers));
    }

    return box;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

stackBoxes::stackBoxes(const prismLayers& layers)
:
    layers_(layers),
    boxes_((layers.faces.size() + groupSize - 1)/groupSize)
{
    #pragma omp parallel for schedule(static)
    forAll(boxes_, group)
    {
        boxes_[group] = boxOf(group);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void stackBoxes::update(const labelUList& faces)
{
    labelHashSet all;
    for (const label facei : faces)
    {
        all.insert(facei/groupSize);
    }
    const labelList groups(all.toc());

    #pragma omp parallel for schedule(dynamic, 1) if (groups.size() > 4)
    forAll(groups, i)
    {
        boxes_[groups[i]] = boxOf(groups[i]);
    }
}


labelRange stackBoxes::faces(const label group) const
{
    const label first = group*groupSize;

    return labelRange(first, min(groupSize, layers_.faces.size() - first));
}


boundBox boxOf(const prismLayers& layers, const label facei, const label level)
{
    boundBox box(boundBox::invertedBox);
    for (const label c : layers.faces[facei])
    {
        box.add(layers(c, level));
    }

    return box;
}


// * * * * * * * * * * * * * * *  Is Positive  * * * * * * * * * * * * * * * //

//- A prism; in layer 1 on a triangle without area one of which two or three
//  lower points are one
static bool isPositiveOnTriangle(const layerCell& cell, const bool hasArea)
{
    const point* p[6];

    for (label k = 0; k < 3; ++k)
    {
        p[k] = hasArea ? &cell.lower(k) : &cell.root(k);
        p[k + 3] = &cell.upper(k);
    }

    return hasArea ? isPositivePrism(p) : isPositiveCollapsedPrism(p);
}


//- Layer 1 on a quadrilateral without area: a prism that lies on an edge of the
//  wall, between the triangles at the edge's ends
static bool isPositiveOnEdge(const layerCell& cell)
{
    // From the first point to the second are two columns on one point
    const label k = &cell.root(0) == &cell.root(1) ? 0 : 3;

    const point* p[6] =
    {
        &cell.root(k), &cell.upper(k), &cell.upper((k + 1)%4),
        &cell.root((k + 2)%4), &cell.upper((k + 3)%4), &cell.upper((k + 2)%4)
    };

    return isPositiveLyingPrism(p);
}


static bool hasPositiveCorners(const layerCell& cell)
{
    const label n = cell.size();

    for (label k = 0; k < n; ++k)
    {
        const label next = (k + 1)%n;
        const label prev = (k + n - 1)%n;

        const point& a = cell.lower(k);
        const point& b = cell.upper(k);

        const point* p[6] =
        {
            &a, &cell.lower(next), &cell.lower(prev),
            &b, &cell.upper(next), &cell.upper(prev)
        };

        const tetSigns positive(p, 6);

        if (!positive(a, *p[1], *p[2], b) || !positive(a, b, *p[4], *p[5]))
        {
            return false;
        }
    }

    return true;
}


bool isPositive(const prismLayers& layers, const label facei, const label i)
{
    const layerCell cell(layers, facei, i);
    const bool hasArea = i > 1 || facei < layers.nWallFaces();

    if (cell.size() == 3)
    {
        return isPositiveOnTriangle(cell, hasArea);
    }

    return hasArea ? hasPositiveCorners(cell) : isPositiveOnEdge(cell);
}


// * * * * * * * * * * * * * * *  Face Pyramids  * * * * * * * * * * * * * * //

//- Whether the centre of a cell is on the inner side of all its faces. Those
//  are given with area vectors outwards; which is as in
//  primitiveMesh::checkFacePyramids.
static bool hasPositivePyramids(const UList<faceGeometry>& faces)
{
    const cellGeometry cell(faces);

    // Faces without area have no pyramid
    return cell.volume3 > VSMALL && allOf(faces, [&](const faceGeometry& f)
    {
        return f.pyramid3(cell.centre) >= -SMALL*cell.volume3;
    });
}


bool hasPositivePyramids(const prismLayers& layers, const label facei)
{
    return visitCells
    (
        layers, layers.faces[facei],
        [](label, const UList<faceGeometry>& faces)
        {
            return hasPositivePyramids(faces);
        }
    );
}


bool isFlatStack(const prismLayers& layers, const label facei)
{
    const face& front = layers.faces[facei];

    return !visitCells
    (
        layers, front,
        [&](const label i, const UList<faceGeometry>& faces)
        {
            boundBox box(boxOf(layers, facei, i - 1));
            box.add(boxOf(layers, facei, i));
            scalar area = 0;
            for (const faceGeometry& f : faces)
            {
                area += mag(f.area);
            }

            return
                cellGeometry(faces).volume3 > 3*roundingVolume(box, area);
        }
    );
}


// * * * * * * * * * * * * *  Prism Intersections  * * * * * * * * * * * * * //

// * * * * * * * * * * * * * * *  Outer Polygons  * * * * * * * * * * * * * * //

//- Six times the volume between the fan from corner k of a face and its fan
//  from corner 0
static scalar volumeBelow
(
    const pointField& points,
    const face& f,
    const label k
)
{
    const label n = f.size();
    const point& origin = points[f[0]];
    const vector apex(points[f[k]] - origin);
    scalar volume = 0;

    for (label i = 1; i + 1 < n; ++i)
    {
        const vector a(points[f[(k + i) % n]] - origin);
        const vector b(points[f[(k + i + 1) % n]] - origin);
        volume += apex & (a ^ b);
    }

    return volume;
}


label highestFan(const pointField& points, const face& f)
{
    label highest = 0;

    for (label k = 1; f.size() > 3 && k < f.size(); ++k)
    {
        if (volumeBelow(points, f, k) > volumeBelow(points, f, highest))
        {
            highest = k;
        }
    }

    return highest;
}


//- Whether the outermost cell on a polygon has a positive volume as OpenFOAM
//  computes it, if the outer face is a fan of triangles from its first corner
static bool isPositiveBelowFan(const prismLayers& layers, const face& f)
{
    const label n = layers.nLayers;
    DynamicList<faceGeometry> faces(2*f.size());
    faces.append(faceGeometry(levelPoints{layers, f, n - 1}));
    faces[0].area *= -1;
    forAll(f, k)
    {
        faces.append
        (
            faceGeometry(sidePoints{layers, f[k], f[f.fcIndex(k)], n})
        );
    }
    for (label k = 1; k + 1 < f.size(); ++k)
    {
        const face triangle({f[0], f[k], f[k + 1]});
        faces.append(faceGeometry(levelPoints{layers, triangle, n}));
    }

    return cellGeometry(faces).volume3 > 0;
}


face outerFan(const prismLayers& layers, const label facei)
{
    const face& f = layers.faces[facei];
    if (f.size() == 3 || !layers.isCut || isPositiveBelowFan(layers, f))
    {
        return f;
    }

    pointField corners(f.size());
    forAll(f, k)
    {
        corners[k] = layers(f[k], layers.nLayers);
    }
    const face all(identity(f.size()));

    return face(rotateList(f, -highestFan(corners, all)));
}


wallSurface outerPolygons(const prismLayers& layers)
{
    wallSurface outer;
    outer.points = layers.outerPoints();
    outer.faces.setSize(layers.faces.size());

    #pragma omp parallel for schedule(static, 256)
    forAll(outer.faces, facei)
    {
        outer.faces[facei] = outerFan(layers, facei);
    }

    return outer;
}


//- Faces whose triangles one thread makes at once
static const label facesPerBlock = 256;


//- Adds the triangles of front faces at levels, in the order of the faces, but
//  for those that are degenerate. Returns the faces that have such.
//  sides: front faces and their levels
static labelList addTriangles
(
    const prismLayers& layers,
    const UList<labelPair>& sides,
    const columnTeam& team,
    std::vector<labelledTriangle>& triangles
)
{
    const label nBlocks = (sides.size() + facesPerBlock - 1)/facesPerBlock;
    std::vector<std::vector<labelledTriangle>> blocks(nBlocks);
    boolList degenerate(sides.size(), false);

    #pragma omp parallel for schedule(dynamic, 1) if (nBlocks > 1)
    for (label block = 0; block < nBlocks; ++block)
    {
        const label end = min((block + 1)*facesPerBlock, sides.size());
        for (label i = block*facesPerBlock; i < end; ++i)
        {
            const labelPair& side = sides[i];
            for
            (
                const labelledTriangle& t
              : trianglesOf(layers, side.first(), side.second(), team)
            )
            {
                if (t.degenerate())
                {
                    degenerate[i] = true;
                }
                else
                {
                    blocks[block].push_back(t);
                }
            }
        }
    }

    for (const std::vector<labelledTriangle>& block : blocks)
    {
        triangles.insert(triangles.end(), block.begin(), block.end());
    }

    DynamicList<label> faces;
    for (const label i : findIndices(degenerate, true))
    {
        faces.append(sides[i].first());
    }

    return labelList(std::move(faces));
}


//- Returns the bounding boxes of the outer faces of some front faces
static std::vector<boundBox> boxesOf
(
    const prismLayers& layers,
    const labelUList& faces
)
{
    std::vector<boundBox> boxes(faces.size());

    #pragma omp parallel for schedule(static, 256) if (faces.size() > 256)
    forAll(faces, i)
    {
        boxes[i] = boxOf(layers, faces[i], layers.nLayers);
    }

    return boxes;
}


//- Adds the triangles that a process counts, on both levels, in marked cells of
//  a grid, but for the outer ones of candidates
static void addNear
(
    const prismLayers& layers,
    const stackBoxes& groups,
    const boolList& candidates,
    const markedGrid& grid,
    const columnTeam& team,
    std::vector<labelledTriangle>& triangles
)
{
    List<FixedList<bool, 2>> near
    (
        layers.faces.size(), FixedList<bool, 2>(false)
    );

    #pragma omp parallel for schedule(dynamic, 8)
    forAll(groups.all(), group)
    {
        if (!grid.mayTouch(groups.all()[group]))
        {
            continue;
        }
        for (const label facei : groups.faces(group))
        {
            const bool counts = team.countsFace(facei);
            near[facei][0] = counts && grid.mayTouch(boxOf(layers, facei, 0));
            near[facei][1] = counts && !candidates[facei]
             && grid.mayTouch(boxOf(layers, facei, layers.nLayers));
        }
    }

    DynamicList<labelPair> sides;
    forAll(near, facei)
    {
        for (const label side : {1, 0})
        {
            if (near[facei][side])
            {
                sides.append(labelPair(facei, side*layers.nLayers));
            }
        }
    }

    // Where the wall is degenerate it is nothing its neighbours are not
    addTriangles(layers, sides, team, triangles);
}


List<labelPair> findIntersections(const prismLayers& layers)
{
    return findIntersections(layers, identity(layers.faces.size()));
}


List<labelPair> findIntersections
(
    const prismLayers& layers,
    const labelUList& outerFaces
)
{
    return findIntersections
    (
        layers, outerFaces, stackBoxes(layers),
        std::vector<labelledTriangle>(), columnTeam::alone()
    );
}


std::vector<labelledTriangle> trianglesOf
(
    const prismLayers& layers,
    const label facei,
    const label level,
    const columnTeam& team
)
{
    std::vector<labelledTriangle> triangles;
    const face f(level ? outerFan(layers, facei) : layers.faces[facei]);

    for (label k = 1; k + 1 < f.size(); ++k)
    {
        labelledTriangle t;
        t.facei = facei + (level ? layers.faces.size() : 0);

        const label columns[3] = {f[0], f[k], f[k + 1]};

        for (int j = 0; j < 3; ++j)
        {
            const label c = level ? columns[j] : layers.root(columns[j]);
            t.labels[j] = 2*team.wholeColumn(c) + (level > 0);
            t.points[j] = layers(columns[j], level);
        }
        triangles.push_back(t);
    }

    return triangles;
}


List<labelPair> findIntersections
(
    const prismLayers& layers,
    const labelUList& outerFaces,
    const stackBoxes& groups,
    const std::vector<labelledTriangle>& others,
    const columnTeam& team
)
{
    DynamicList<labelPair> pairs;
    boolList candidates(layers.faces.size(), false);
    UIndirectList<bool>(candidates, outerFaces) = true;

    // Each pair has one of the first
    std::vector<labelledTriangle> first(others), second;
    DynamicList<labelPair> outer(outerFaces.size());
    for (const label facei : findIndices(candidates, true))
    {
        outer.append(labelPair(facei, layers.nLayers));
    }
    for (const label facei : addTriangles(layers, outer, team, first))
    {
        const label outerFace = layers.faces.size() + facei;
        pairs.append(labelPair(outerFace, outerFace));
    }

    std::vector<boundBox> boxes(boxesOf(layers, outerFaces));
    for (const labelledTriangle& t : others)
    {
        boxes.push_back(t.box());
    }
    addNear(layers, groups, candidates, markedGrid(boxes), team, second);
    addIntersections(first, second, pairs);

    return List<labelPair>(std::move(pairs));
}


// * * * * * * * * * * * * * * *  Prism Quality  * * * * * * * * * * * * * * //

bool isPositiveStack(const prismLayers& layers, const label facei)
{
    stackHeights stack(layers);
    stack.compute(facei);

    const face& f = layers.faces[facei];
    if
    (
        min(stack.heights()) <= 0
     ||
        (
            f.size() > 3 && layers.isCut
         && !isPositiveBelowFan(layers, outerFan(layers, facei))
        )
    )
    {
        return false;
    }

    for (label i = layers.nLayers; i > 0; --i)
    {
        if (!isPositive(layers, facei, i))
        {
            return false;
        }
    }

    return true;
}


layerCertificate certify(const prismLayers& layers, const columnTeam& team)
{
    const label nFaces = layers.faces.size();
    boolList outlying(nFaces, false);
    boolList flat(nFaces, false);
    label nCounted = 0, nNotPositive = 0;

    layerCertificate certificate;
    certificate.worstJacobian.setSize(nFaces, GREAT);

    #pragma omp parallel for schedule(dynamic, 64) \
        reduction(+: nCounted, nNotPositive)
    for (label facei = 0; facei < nFaces; ++facei)
    {
        if (!team.countsFace(facei))
        {
            continue;
        }
        ++nCounted;
        nNotPositive += !isPositiveStack(layers, facei);
        outlying[facei] = !hasPositivePyramids(layers, facei);
        flat[facei] = isFlatStack(layers, facei);
        certificate.worstJacobian[facei] = worstJacobian(layers, facei);
    }

    certificate.nCells = nCounted*layers.nLayers;
    certificate.nStacksNotPositive = nNotPositive;
    certificate.outlyingCentres = findIndices(outlying, true);
    certificate.flatStacks = findIndices(flat, true);
    certificate.nOverlaps = findOverlaps
    (
        layers, team.withOwn(identity(nFaces), layers.faces),
        findBodies(layers, team), stackBoxes(layers),
        scalarField(layers.nColumns(), 0), team
    ).size();

    return certificate;
}

} // End namespace Foam

// ************************************************************************* //
