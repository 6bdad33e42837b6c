/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallPolygons.H"

#include "HashSet.H"
#include "Map.H"
#include "quadJoiner.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Calls onEdge(e, label) for the inner points of the edges of common
//  triangles, with the common edge and the label in cornerPoints, and
//  onTriangle(i, label) for the inner points of common triangles
template<class OnEdge, class OnTriangle>
static void visitCommonPoints
(
    const wallCorners& wall,
    const cornerPoints& points,
    const OnEdge& onEdge,
    const OnTriangle& onTriangle
)
{
    const prismLayers& layers = wall.layers;
    for (label facei = 0; facei < layers.nWallFaces(); ++facei)
    {
        if (!wall.common.isCommon.test(facei))
        {
            continue;
        }
        const face& f = layers.faces[facei];
        onTriangle(wall.common.faces[facei], points.ofFace(facei, 0));
        forAll(f, k)
        {
            const label a = f[k], b = f.nextLabel(k);
            onEdge
            (
                wall.common.edgeBetween(layers.root(a), layers.root(b)),
                points.ofEdge(points.frontEdges().find(a, b), 0)
            );
        }
    }
}


//- Returns the labels in cornerPoints of points on joined faces that become one
//  with others, and the first one of these
static Map<label> labelsToJoin
(
    const wallCorners& wall,
    const cornerPoints& points
)
{
    const prismLayers& layers = wall.layers;
    Map<label> first, ofPoint;
    EdgeMap<label> ofEdge;
    labelHashSet several;
    const auto add = [&](const label i, const label j)
    {
        first.set(i, j);
        if (i != j)
        {
            several.insert(j);
        }
    };
    for (const label facei : wall.common.isJoined)
    {
        const face& f = layers.faces[facei];
        forAll(f, k)
        {
            const label a = layers.root(f[k]), b = layers.root(f.nextLabel(k));
            const label p = points.ofColumn(a, 0);
            const label m = points.ofEdge
            (
                points.frontEdges().find(f[k], f.nextLabel(k)), 0
            );
            const edge e(wall.common.edgeBetween(a, b));
            ofPoint.insert(wall.common.points[a], p);
            ofEdge.insert(e, m);
            add(p, ofPoint[wall.common.points[a]]);
            add(m, ofEdge[e]);
        }
    }
    first.filterValues([&](const label j) { return several.found(j); });

    return first;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

label wallCorners::commonCorner(const label facei, const label k) const
{
    return common.corner(facei, rootsOf(layers, facei), k);
}


void joinCommonCorners(const wallCorners& wall, commonPolygons& polygons)
{
    const prismLayers& layers = wall.layers;
    const auto joinIfOne = [&]
    (
        const label facei,
        const label k,
        const label other,
        const label l
    )
    {
        const label a = wall.corner(facei, k), b = wall.corner(other, l);
        if
        (
            wall.cells[a] == wall.cells[b]
         && wall.front.groups[a] == wall.front.groups[b]
        )
        {
            const bitSet& isCommon = wall.common.isCommon;
            const bool isAlone = !isCommon.test(facei) && !isCommon.test(other);
            polygons.join
            (
                wall.commonCorner(facei, k), wall.commonCorner(other, l),
                isAlone ? 2 : 1
            );
        }
    };
    for (label facei = 0; facei < layers.nWallFaces(); ++facei)
    {
        const face& f = layers.faces[facei];
        forAll(f, k)
        {
            joinIfOne(facei, k, facei, f.fcIndex(k));
            const label other = wall.faceNeighbours[facei][k];
            if (other > facei && other < layers.nWallFaces())
            {
                const face& g = layers.faces[other];
                joinIfOne(facei, k, other, g.find(f[k]));
                joinIfOne
                (
                    facei, f.fcIndex(k), other, g.find(f.nextLabel(k))
                );
            }
        }
    }
}


void addCommonPoints
(
    const wallCorners& wall,
    const cornerPoints& points,
    const boolList& stays,
    commonPolygons& polygons
)
{
    visitCommonPoints
    (
        wall, points,
        [&](const edge& e, const label i)
        {
            if (stays[i])
            {
                polygons.addEdgePoint(e);
            }
        },
        [&](const label triangle, const label i)
        {
            if (stays[i])
            {
                polygons.addTrianglePoint(triangle);
            }
        }
    );
}


void keepCommonPoints
(
    const wallCorners& wall,
    const cornerPoints& points,
    const commonPolygons& polygons,
    boolList& stays
)
{
    visitCommonPoints
    (
        wall, points,
        [&](const edge& e, const label i)
        {
            stays[i] = stays[i] || polygons.hasEdgePoint(e);
        },
        [&](const label triangle, const label i)
        {
            stays[i] = stays[i] || polygons.hasTrianglePoint(triangle);
        }
    );
}


void divideGroups
(
    const wallCorners& wall,
    const commonPolygons& polygons,
    frontGroups& front
)
{
    // Both sides of a sheet have one polygon, and two groups
    const prismLayers& layers = wall.layers;
    HashTable<label, labelPair, labelPair::Hash<>> groupOf;
    front.nGroups = 0;
    forAll(layers.faces, facei)
    {
        const bool onWall = facei < layers.nWallFaces();
        forAll(layers.faces[facei], k)
        {
            label& group = front.groups[front.starts[facei] + k];
            const labelPair key
            (
                group,
                onWall ? polygons.polygon(wall.commonCorner(facei, k)) : -1
            );
            if (groupOf.insert(key, front.nGroups))
            {
                ++front.nGroups;
            }
            group = groupOf[key];
        }
    }
}


labelList pinchedCells
(
    const wallCorners& wall,
    const cornerPoints& points,
    const labelUList& labels,
    const polyMeshParts& mesh
)
{
    const Map<label> first(labelsToJoin(wall, points));
    if (first.empty())
    {
        return labelList();
    }
    const polyMeshTopology& t = mesh.topology;
    HashTable<label, labelPair, labelPair::Hash<>> pointIn;
    DynamicList<label> cells;
    const auto add = [&](const label celli, const label i)
    {
        const labelPair key(celli, first[i]);
        if (!pointIn.insert(key, i) && pointIn[key] != i)
        {
            cells.append(celli);
        }
    };
    forAll(t.faces, facei)
    {
        for (const label p : t.faces[facei])
        {
            const label i = labels[p];
            if (!first.found(i))
            {
                continue;
            }
            add(t.owner[facei], i);
            if (facei < t.neighbour.size())
            {
                add(t.neighbour[facei], i);
            }
        }
    }

    return labelList(std::move(cells));
}


void compareWalls
(
    const wallCorners& wall,
    const polyMeshParts& mesh,
    const polygonGeometry& geometry,
    scalar& distance,
    scalar& areaRatio
)
{
    const prismLayers& layers = wall.layers;
    labelList columnOf(mesh.nCells, -1);
    scalar area = 0;
    for (label facei = 0; facei < layers.nWallFaces(); ++facei)
    {
        const face& f = layers.faces[facei];
        pointField x(f.size());
        forAll(f, k)
        {
            columnOf[wall.cells[wall.corner(facei, k)]] = f[k];
            x[k] = layers(f[k], 0);
        }
        area += face(identity(f.size())).mag(x);
    }
    scalar polygons = 0;
    distance = 0;
    for (label patchi = 0; patchi < layers.patchNames.size(); ++patchi)
    {
        for (const label f : mesh.topology.patchFaces(patchi))
        {
            const label own = mesh.topology.owner[f];
            const vector& normal = geometry.faceAreas[f];
            const vector off
            (
                layers(columnOf[own], 0) - geometry.faceCentres[f]
            );
            polygons += mag(normal);
            distance = max
            (
                distance, mag(off & normal)/max(mag(normal), VSMALL)
            );
        }
    }
    areaRatio = polygons/area;
}


void appendWallFaces
(
    const wallCorners& wall,
    const cornerPoints& points,
    const commonPolygons& polygons,
    meshBuilder& faces,
    List<DynamicList<label>>& ofPatches
)
{
    const prismLayers& layers = wall.layers;
    quadJoiner quads;
    for (label facei = 0; facei < layers.nWallFaces(); ++facei)
    {
        const face& f = layers.faces[facei];
        const auto edgePoint = [&](const label k)
        {
            return points.ofEdge
            (
                points.frontEdges().find(f[k], f.nextLabel(k)), 0
            );
        };
        forAll(f, k)
        {
            const label corner = wall.corner(facei, k);
            quads.append
            (
                quadBetween
                {
                    polygons.polygon(wall.commonCorner(facei, k)),
                    wall.cells[corner],
                    meshBuilder::onPatch(layers.patchIDs[facei]),
                    cornerQuad
                    ({
                        points.ofColumn(f[k], 0), edgePoint(f.rcIndex(k)),
                        points.ofFace(facei, 0), edgePoint(k)
                    })
                }
            );
        }
    }
    quads.visitFaces
    (
        [&](const labelUList& outline, const quadBetween& quad)
        {
            faces.append(outline, quad.first, quad.second);
            ofPatches[meshBuilder::patchOf(quad.second)].append(quad.carrier);
        }
    );
}

} // End namespace Foam

// ************************************************************************* //
