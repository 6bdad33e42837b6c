/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "ListOps.H"
#include "slitEdges.H"
#include "tetrahedralize.H"
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
static void addBox(const offsetEnvelope& envelope, tetDomain& domain)
{
    boundBox box(domain.points);
    box.inflate(domainControls::boxShare);
    const vector margin =
        point::uniform(domainControls::boxHeights*max(envelope.radius));
    box.min() -= margin;
    box.max() += margin;

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
    domain.holes = bodySeeds(wall, search);
    const faceList triangles(domain.facets);

    if (enclosedVolume(wall) > 0)
    {
        addBox(envelope, domain);
    }

    tetMesh filled(tetrahedralize(domain));

    backgroundMesh mesh;
    mesh.nWallPoints = wall.points.size();
    mesh.points.transfer(filled.points);
    setPointData(envelope, domain.points.size(), mesh);

    mesh.tets = subsetList(filled.tets, [&](const tetCell& tet)
    {
        return std::any_of(tet.begin(), tet.end(), [&](const label p)
        {
            return mesh.onWall(p) || mesh.free[p];
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
