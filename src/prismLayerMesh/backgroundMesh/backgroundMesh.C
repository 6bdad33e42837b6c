/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
-------------------------------------------------------------------------------
License
    This file is part of harmonicPrismMesh, free software under the GNU
    General Public License, version 3 or later; see COPYING.

\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "tetrahedralize.H"
#include "wallBridges.H"

#include <algorithm>
#include <cstdint>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

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
        const scalar tiny = 1e-6*::sqrt(f.mag(wall.points));

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
    box.inflate(0.1);
    box.min() -= point::uniform(2*max(envelope.radius));
    box.max() += point::uniform(2*max(envelope.radius));

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

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::FixedList<Foam::label, 4>> Foam::tetNeighbours
(
    const tetCellList& tets
)
{
    struct keyed
    {
        FixedList<label, 3> points;
        label tetFace;
    };

    List<keyed> keys(4*tets.size());
    forAll(tets, t)
    {
        const tetCell& tet = tets[t];

        for (label i = 0; i < 4; ++i)
        {
            keyed& k = keys[4*t + i];
            k.points[0] = tet[(i + 1) % 4];
            k.points[1] = tet[(i + 2) % 4];
            k.points[2] = tet[(i + 3) % 4];
            k.tetFace = 4*t + i;
            std::sort(k.points.begin(), k.points.end());
        }
    }

    std::sort
    (
        keys.begin(),
        keys.end(),
        [](const keyed& a, const keyed& b)
        {
            return std::lexicographical_compare
            (
                a.points.begin(), a.points.end(),
                b.points.begin(), b.points.end()
            );
        }
    );

    List<FixedList<label, 4>> neighbours(tets.size());
    for (FixedList<label, 4>& n : neighbours)
    {
        n = -1;
    }

    for (label i = 1; i < keys.size(); ++i)
    {
        if (keys[i].points == keys[i - 1].points)
        {
            const label a = keys[i].tetFace, b = keys[i - 1].tetFace;
            neighbours[a/4][a % 4] = b/4;
            neighbours[b/4][b % 4] = a/4;
        }
    }

    return neighbours;
}


void Foam::setAddressing(backgroundMesh& mesh)
{
    setEdges(mesh);
    mesh.neighbours = tetNeighbours(mesh.tets);
}


Foam::backgroundMesh Foam::makeBackgroundMesh
(
    const wallSurface& wall,
    const wallAddressing& addressing,
    const wallSearch& search,
    const wallVisibility& visibility,
    const offsetEnvelope& envelope
)
{
    const label nWallPoints = wall.points.size();
    const label nSheetPoints = envelope.points.size();

    tetDomain domain;
    labelList triangleFace;
    const faceList triangles(wallTriangles(wall, triangleFace));
    domain.facets = triangles;
    domain.points = wall.points;
    domain.points.append(envelope.points);
    domain.holes = bodySeeds(wall, search);

    if (enclosedVolume(wall) > 0)
    {
        addBox(envelope, domain);
    }

    tetMesh filled(tetrahedralize(domain));

    backgroundMesh mesh;
    mesh.nWallPoints = nWallPoints;
    mesh.points.transfer(filled.points);

    mesh.free.setSize(mesh.points.size(), false);
    mesh.gaps.setSize(mesh.points.size(), 0);
    forAll(mesh.points, p)
    {
        const label sheetPoint = p - nWallPoints;

        if (sheetPoint < 0)
        {
            mesh.gaps[p] = envelope.radius[p];
        }
        else if (sheetPoint < nSheetPoints)
        {
            mesh.gaps[p] = envelope.gaps[sheetPoint];
            mesh.free[p] = sheetPoint >= envelope.nEnvelope;
        }
        else
        {
            mesh.free[p] = p >= domain.points.size();
        }
    }

    DynamicList<tetCell> tets(filled.tets.size());
    for (const tetCell& tet : filled.tets)
    {
        bool between = false;
        for (const label p : tet)
        {
            between = between || mesh.onWall(p) || mesh.free[p];
        }

        if (between)
        {
            tets.append(tet);
        }
    }
    mesh.tets.transfer(tets);

    fillGaps(mesh.tets, mesh.gaps);
    splitWallBridges(triangles, visibility.axes(), mesh);
    setAddressing(mesh);

    return mesh;
}


// ************************************************************************* //
