/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "testStages.H"
#include "testSurfaces.H"
#include "tetrahedralize.H"
#include "Random.H"
#include "mathematicalConstants.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace testSurfaces
{

//- The tetrahedra of a cell of a grid, along the six ways from its lowest to
//  its highest corner
template<class Index>
static void addTets
(
    const Index& index,
    const FixedList<label, 3>& corner,
    const pointField& points,
    DynamicList<tetCell>& tets
)
{
    FixedList<label, 3> order({0, 1, 2});
    do
    {
        FixedList<label, 3> at(corner);
        tetCell tet;
        tet[0] = index(at[0], at[1], at[2]);
        for (label k = 0; k < 3; ++k)
        {
            ++at[order[k]];
            tet[k + 1] = index(at[0], at[1], at[2]);
        }
        if (tet.tet(points).mag() < 0)
        {
            std::swap(tet[2], tet[3]);
        }
        tets.append(tet);
    }
    while (std::next_permutation(order.begin(), order.end()));
}


static backgroundMesh filled
(
    const tetDomain& domain,
    const label nWallPoints,
    const label nBoundaryPoints
)
{
    tetMesh filled(tetrahedralize(domain));

    backgroundMesh mesh;
    mesh.points = filled.points;
    mesh.tets = filled.tets;
    mesh.nWallPoints = nWallPoints;
    mesh.gaps.setSize(mesh.points.size(), 1);
    mesh.free.setSize(mesh.points.size());
    forAll(mesh.free, p)
    {
        mesh.free[p] = p >= nBoundaryPoints;
    }
    setAddressing(mesh);

    return mesh;
}

} // End namespace testSurfaces
} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::backgroundMesh Foam::testSurfaces::cubeMesh(const label n)
{
    const wallSurface box(cube(n));
    Random random(7);

    tetDomain domain;
    domain.points = box.points;
    domain.facets = box.faces;

    for (label i = 0; i < n*n*n; ++i)
    {
        const vector x = random.sample01<vector>();
        domain.points.append(0.8*x + point::uniform(0.1));
    }

    return filled(domain, 0, box.points.size());
}


Foam::backgroundMesh Foam::testSurfaces::ballMesh(const label n)
{
    const wallSurface ball(sphere(n));

    tetDomain domain;
    domain.points = ball.points;
    domain.facets = ball.faces;

    return filled(domain, ball.points.size(), ball.points.size());
}


Foam::backgroundMesh Foam::testSurfaces::shellMesh
(
    const label n,
    const scalar a,
    const scalar b
)
{
    const wallSurface both(merge(sphere(n, a), reversed(sphere(n, b))));

    tetDomain domain;
    domain.points = both.points;
    domain.facets = both.faces;
    domain.holes = pointField(1, point(Zero));

    const label nLayers = max(label(2), n/2);
    for (label i = 1; i < nLayers; ++i)
    {
        domain.points.append(sphere(n, a + (b - a)*i/nLayers).points);
    }

    backgroundMesh mesh
    (
        filled(domain, both.points.size()/2, both.points.size())
    );
    mesh.gaps = b - a;

    return mesh;
}


Foam::backgroundMesh Foam::testSurfaces::tubeMesh
(
    const label n,
    const scalar a,
    const scalar b
)
{
    const label nAround = 6*n, nAlong = n;
    const auto index = [&](const label r, const label t, const label z)
    {
        return (r*nAround + t % nAround)*(nAlong + 1) + z;
    };

    backgroundMesh mesh;
    mesh.nWallPoints = index(1, 0, 0);
    mesh.points.setSize(index(n + 1, 0, 0));
    mesh.free.setSize(mesh.points.size(), false);
    mesh.gaps.setSize(mesh.points.size(), b - a);

    for (label r = 0; r <= n; ++r)
    {
        for (label t = 0; t < nAround; ++t)
        {
            for (label z = 0; z <= nAlong; ++z)
            {
                const scalar radius = a + (b - a)*r/n;
                const scalar angle = constant::mathematical::twoPi*t/nAround;
                mesh.points[index(r, t, z)] = point
                (
                    radius*std::cos(angle), radius*std::sin(angle),
                    z/scalar(nAlong)
                );
                mesh.free[index(r, t, z)] = r > 0 && r < n;
            }
        }
    }

    DynamicList<tetCell> tets;
    for (label r = 0; r < n; ++r)
    {
        for (label t = 0; t < nAround; ++t)
        {
            for (label z = 0; z < nAlong; ++z)
            {
                addTets(index, {r, t, z}, mesh.points, tets);
            }
        }
    }
    mesh.tets.transfer(tets);
    setAddressing(mesh);

    return mesh;
}


Foam::backgroundMesh Foam::testSurfaces::platesMesh(const label n)
{
    // The points of the wall first, then those of the envelope
    const wallSurface box(cube(n));
    const auto partOf = [&](const label p)
    {
        const scalar z = box.points[p].z();
        return z < SMALL ? 0 : z > 1 - SMALL ? 1 : 2;
    };
    labelList order(identity(box.points.size()));
    std::stable_sort(order.begin(), order.end(), [&](label p, label q)
    {
        return partOf(p) < partOf(q);
    });
    const labelList renumbered(invert(order.size(), order));

    tetDomain domain;
    domain.points = pointField(box.points, order);
    domain.facets = box.faces;
    for (face& f : domain.facets)
    {
        inplaceRenumber(renumbered, f);
    }

    Random random(7);
    for (label i = 0; i < n*n*n; ++i)
    {
        const vector x = random.sample01<vector>();
        domain.points.append(0.9*x + point::uniform(0.05));
    }

    const label nPlate = (n + 1)*(n + 1);

    return filled(domain, nPlate, 2*nPlate);
}


Foam::backgroundMesh Foam::testSurfaces::sectorMesh
(
    const label n,
    const scalar degrees
)
{
    const label nRadii = 4*n;
    const auto indexInGrid = [&](const label r, const label t, const label z)
    {
        return (r*(n + 1) + t)*2 + z;
    };

    // In the order of the grid
    pointField points(indexInGrid(nRadii + 1, 0, 0));
    boolList onWall(points.size()), onEnvelope(points.size());
    forAll(points, i)
    {
        const label r = i/(2*(n + 1)), t = i/2 % (n + 1);
        const scalar radius = std::pow(1e-4, 1 - r/scalar(nRadii));
        const scalar angle = degrees*constant::mathematical::pi/180*t/n;
        const vector out(std::cos(angle), std::sin(angle), 0);
        points[i] = radius*out + vector(0, 0, 0.1*(i % 2));
        onWall[i] = r == 0 || t == 0 || t == n;
        onEnvelope[i] = r == nRadii;
    }

    labelList order(identity(points.size()));
    const auto firstInside = std::stable_partition
    (
        order.begin(), order.end(), [&](const label i) { return onWall[i]; }
    );
    const labelList renumbered(invert(order.size(), order));

    backgroundMesh mesh;
    mesh.nWallPoints = firstInside - order.begin();
    mesh.points = pointField(points, order);
    mesh.gaps.setSize(points.size(), 1);
    mesh.free.setSize(points.size());
    forAll(mesh.free, p)
    {
        mesh.free[p] = !onWall[order[p]] && !onEnvelope[order[p]];
    }

    const auto index = [&](const label r, const label t, const label z)
    {
        return renumbered[indexInGrid(r, t, z)];
    };
    DynamicList<tetCell> tets;
    for (label r = 0; r < nRadii; ++r)
    {
        for (label t = 0; t < n; ++t)
        {
            addTets(index, {r, t, 0}, mesh.points, tets);
        }
    }
    mesh.tets.transfer(tets);
    setAddressing(mesh);

    return mesh;
}


// ************************************************************************* //
