/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "ListOps.H"
#include "sideFacets.H"
#include "slitEdges.H"
#include "tetrahedralize.H"
#include "triangleIndex.H"
#include "wallBridges.H"

#include <algorithm>
#include <array>
#include <cstdint>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points inside the bodies, one behind the largest face of each component
static pointField bodySeeds(const wallSurface& wall, const wallSearch& search)
{
    DynamicList<point> seeds;

    for (const label facei : largestFaces(wall))
    {
        // On one triangle of the face: its centre may be off a warped face
        const face& f = wall.faces[facei];
        const triPointRef tri
        (
            wall.points[f[0]], wall.points[f[1]], wall.points[f[2]]
        );
        const vector inwards = -tri.unitNormal();
        const scalar tiny =
            domainControls::seedShare*::sqrt(f.mag(wall.points));

        const pointIndexHit hit
        (
            search.firstHit
            (
                tri.centre() + tiny*inwards,
                tri.centre() + search.bounds().mag()*inwards
            )
        );

        // Without a hit the inner side is the outside, and not meshed anyway
        if (hit.hit())
        {
            seeds.append(0.5*(tri.centre() + hit.rawPoint()));
        }
    }

    return pointField(std::move(seeds));
}


//- A box around everything, so wide that its sides do not matter
static boundBox boxAround
(
    const pointField& points,
    const offsetEnvelope& envelope
)
{
    boundBox box(points);
    box.inflate(domainControls::boxShare);
    const vector margin =
        point::uniform(domainControls::boxHeights*max(envelope.radius));
    box.min() -= margin;
    box.max() += margin;

    return box;
}


static void addBox(const boundBox& box, tetDomain& domain)
{
    const label first = domain.points.size();
    domain.points.append(box.points());

    // In the order of boundBox::points
    static const label faces[6][4] =
    {
        {0, 4, 7, 3}, {1, 2, 6, 5}, {0, 1, 5, 4},
        {3, 7, 6, 2}, {0, 3, 2, 1}, {4, 5, 6, 7}
    };

    for (const label (&f)[4] : faces)
    {
        domain.facets.append(face({first+f[0], first+f[1], first+f[2]}));
        domain.facets.append(face({first+f[0], first+f[2], first+f[3]}));
    }
}


//- Gap of a point that has none of its own: the largest of its neighbours
static void fillGaps(const tetCellList& tets, scalarField& gaps)
{
    bool changed = true;

    while (changed)
    {
        changed = false;

        for (const tetCell& tet : tets)
        {
            const scalar largest =
                max(max(gaps[tet[0]], gaps[tet[1]]),
                    max(gaps[tet[2]], gaps[tet[3]]));

            for (const label p : tet)
            {
                if (gaps[p] <= 0 && largest > 0)
                {
                    gaps[p] = largest;
                    changed = true;
                }
            }
        }
    }
}


//- The tetrahedra that are joined to the wall's front by faces that are not on
//  the wall; the triangles of the wall are seen from there
static tetCellList frontOf
(
    const pointField& points,
    const tetCellList& tets,
    const faceList& triangles
)
{
    const triangleIndex onWall(makeTriangleIndex(triangles));
    const List<FixedList<label, 4>> neighbours(tetNeighbours(tets));
    boolList isFront(tets.size(), false);
    DynamicList<label> found;

    const auto triangleAt = [&](const label t, const label i)
    {
        return onWall.lookup
        (
            triFace
            (
                tets[t][(i + 1) % 4], tets[t][(i + 2) % 4], tets[t][(i + 3) % 4]
            ),
            -1
        );
    };
    const auto visit = [&](const label t)
    {
        if (t >= 0 && !isFront[t])
        {
            isFront[t] = true;
            found.append(t);
        }
    };

    forAll(tets, t)
    {
        for (label i = 0; i < 4; ++i)
        {
            const label triangle = triangleAt(t, i);

            if (triangle >= 0)
            {
                const face& f = triangles[triangle];
                const vector up(points[tets[t][i]] - points[f[0]]);
                visit((f.areaNormal(points) & up) > 0 ? t : -1);
            }
        }
    }

    for (label k = 0; k < found.size(); ++k)
    {
        for (label i = 0; i < 4; ++i)
        {
            if (triangleAt(found[k], i) < 0)
            {
                visit(neighbours[found[k]][i]);
            }
        }
    }

    return tetCellList(UIndirectList<tetCell>(tets, found));
}


//- Set free and gaps of the points: those of the wall, of the sheets, of the
//  box up to nGiven, and those that TetGen has added
static void setPointData
(
    const offsetEnvelope& envelope,
    const label nGiven,
    backgroundMesh& mesh
)
{
    mesh.free.setSize(mesh.points.size(), false);
    mesh.gaps.setSize(mesh.points.size(), 0);

    forAll(mesh.points, p)
    {
        const label sheetPoint = p - mesh.nWallPoints;

        if (sheetPoint < 0)
        {
            mesh.gaps[p] = envelope.radius[p];
        }
        else if (sheetPoint < envelope.points.size())
        {
            mesh.gaps[p] = envelope.gaps[sheetPoint];
            mesh.free[p] = sheetPoint >= envelope.nEnvelope;
        }
        else
        {
            mesh.free[p] = p >= nGiven;
        }
    }
}


static void setEdges(backgroundMesh& mesh)
{
    typedef std::pair<std::uint64_t, label> keyed;

    List<keyed> keys(6*mesh.tets.size());
    forAll(mesh.tets, t)
    {
        const tetCell& tet = mesh.tets[t];
        label k = 6*t;

        for (label i = 0; i < 4; ++i)
        {
            for (label j = i + 1; j < 4; ++j, ++k)
            {
                const std::uint64_t low = min(tet[i], tet[j]);
                keys[k] = keyed((low << 32) | max(tet[i], tet[j]), k);
            }
        }
    }

    std::sort(keys.begin(), keys.end());

    DynamicList<edge> edges(keys.size()/4);
    mesh.tetEdges.setSize(mesh.tets.size());

    forAll(keys, i)
    {
        if (i == 0 || keys[i].first != keys[i - 1].first)
        {
            edges.append
            (
                edge(label(keys[i].first >> 32), label(keys[i].first))
            );
        }
        mesh.tetEdges[keys[i].second/6][keys[i].second % 6] = edges.size() - 1;
    }

    mesh.edges.transfer(edges);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar backgroundMesh::gap(const simplex& s) const
{
    const scalar least = min(gaps[s[1]], gaps[s[2]]);

    return s[0] >= 0 ? min(least, gaps[s[0]]) : least;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<FixedList<label, 4>> tetNeighbours(const tetCellList& tets)
{
    // Points of a face in ascending order, and 4*tet + the opposite point
    typedef std::pair<std::array<label, 3>, label> keyed;

    List<keyed> keys(4*tets.size());
    forAll(keys, k)
    {
        const tetCell& tet = tets[k/4];
        keys[k] = keyed
        (
            {tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]}, k
        );
        std::sort(keys[k].first.begin(), keys[k].first.end());
    }

    std::sort(keys.begin(), keys.end());

    List<FixedList<label, 4>> neighbours(tets.size(), FixedList<label, 4>(-1));

    for (label i = 1; i < keys.size(); ++i)
    {
        if (keys[i].first == keys[i - 1].first)
        {
            const label a = keys[i].second, b = keys[i - 1].second;
            neighbours[a/4][a % 4] = b/4;
            neighbours[b/4][b % 4] = a/4;
        }
    }

    return neighbours;
}


void splitAt
(
    const simplexSet& simplices,
    const UList<point>& points,
    const UList<scalar>& gaps,
    const UList<bool>& free,
    backgroundMesh& mesh
)
{
    splitTets(simplices, mesh.points.size(), mesh.tets);
    mesh.points.append(points);
    mesh.gaps.append(gaps);
    mesh.free.append(free);
}


void setAddressing(backgroundMesh& mesh)
{
    setEdges(mesh);
    mesh.neighbours = tetNeighbours(mesh.tets);
}


backgroundMesh makeBackgroundMesh
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const offsetEnvelope& envelope
)
{
    labelList triangleFace;
    tetDomain domain;
    domain.facets = wallTriangles(wall, triangleFace);
    domain.points = wall.points;
    domain.points.append(envelope.points);
    const faceList triangles(domain.facets);
    const boundBox box(boxAround(domain.points, envelope));
    const bool isOpen = wall.border.sides.size();
    labelList onSides;

    if (isOpen)
    {
        onSides = addSideFacets(wall, envelope, box, domain);
    }
    else
    {
        domain.holes = bodySeeds(wall, search);
        if (enclosedVolume(wall) > 0)
        {
            addBox(box, domain);
        }
    }

    tetMesh filled(tetrahedralize(domain));
    if (isOpen)
    {
        filled.tets = frontOf(filled.points, filled.tets, triangles);
    }

    backgroundMesh mesh;
    mesh.nWallPoints = wall.points.size();
    mesh.points.transfer(filled.points);
    setPointData(envelope, domain.points.size(), mesh);
    UIndirectList<bool>(mesh.free, onSides) = true;

    mesh.tets = subsetList(filled.tets, [&](const tetCell& tet)
    {
        return std::any_of(tet.begin(), tet.end(), [&](const label p)
        {
            return mesh.inside(p);
        });
    });

    fillGaps(mesh.tets, mesh.gaps);
    splitWallBridges(triangles, addressing, search, mesh);
    splitSlitEdges(search, mesh);
    setAddressing(mesh);

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
