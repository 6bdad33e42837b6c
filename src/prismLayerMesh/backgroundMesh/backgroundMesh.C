/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "backgroundMesh.H"
#include "ListOps.H"
#include "ranges.H"
#include "refineTets.H"
#include "surfacePart.H"
#include "tetrahedralize.H"
#include "wallBridges.H"
#include "wallDomain.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The part of a domain that TetGen fills if it does not end on the whole
struct boundsOfDomain
{
    tetDomain domain;

    //- Labels in the whole domain of its points, and of the points of the
    //  envelope that are on no facet
    labelList points;
    labelList others;
};

} // End anonymous namespace


static boundsOfDomain makeBounds
(
    const tetDomain& domain,
    const offsetEnvelope& envelope
)
{
    const label first = envelope.radius.size();
    bitSet isOther(domain.points.size());
    isOther.set(labelRange(first, envelope.points.size()));
    isOther -= pointsOf(domain.facets, domain.points.size());

    boundsOfDomain bounds{domain, {}, isOther.toc()};
    isOther.flip();
    bounds.points = isOther.toc();
    bounds.domain.points = pointField(domain.points, bounds.points);
    const labelList toBounds(invert(domain.points.size(), bounds.points));
    for (face& f : bounds.domain.facets)
    {
        inplaceRenumber(toBounds, f);
    }
    bounds.domain.areInPlanes = true;

    return bounds;
}


//- Fills the room between the facets of a domain by TetGen, and adds the other
//  points of the envelope. The mesh has the points of the domain in their
//  order, then the points that TetGen has added.
static tetMesh fillInTwoSteps
(
    const tetDomain& domain,
    const offsetEnvelope& envelope
)
{
    const boundsOfDomain bounds(makeBounds(domain, envelope));
    tetMesh filled(tetrahedralize(bounds.domain));

    const label nFilled = filled.points.size();
    wantedPoints wanted{pointField(domain.points, bounds.others), {}};
    wanted.near.setSize(wanted.points.size());
    forAll(wanted.near, i)
    {
        wanted.near[i] =
            envelope.roots[bounds.others[i] - envelope.radius.size()];
    }
    const labelList added(insertPoints(wanted, bounds.domain.facets, filled));

    pointField points(domain.points);
    labelList labels(filled.points.size());
    SubList<label>(labels, bounds.points.size()) = bounds.points;
    for (label p = bounds.points.size(); p < nFilled; ++p)
    {
        labels[p] = points.size();
        points.append(filled.points[p]);
    }
    forAll(added, i)
    {
        if (added[i] >= 0)
        {
            labels[added[i]] = bounds.others[i];
        }
    }
    for (tetCell& tet : filled.tets)
    {
        for (label& p : tet)
        {
            p = labels[p];
        }
    }
    filled.points.transfer(points);

    return filled;
}


//- Fills a domain of a wall and an envelope. On wide flat faces TetGen may not
//  end with points of the envelope above them, but does without.
static tetMesh fillDomain
(
    const tetDomain& domain,
    const offsetEnvelope& envelope
)
{
    tetMesh filled;

    return tetrahedralizeBriefly(domain, filled)
      ? filled : fillInTwoSteps(domain, envelope);
}


//- A mesh without tetrahedra: the points of the wall, of the sheets, of the
//  rest of the domain, and those that TetGen has added
static backgroundMesh withPointData
(
    const wallSurface& wall,
    const offsetEnvelope& envelope,
    const tetDomain& domain,
    const pointField& points
)
{
    backgroundMesh mesh;
    mesh.points = points;
    mesh.nWallPoints = wall.points.size();
    mesh.free.setSize(points.size(), false);
    mesh.gaps.setSize(points.size(), 0);

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
            mesh.free[p] = p >= domain.points.size();
        }
    }

    return mesh;
}


//- Set the tetrahedra, those of a list with a point inside, and what depends on
//  them
static void setTets
(
    const tetCellList& tets,
    const faceList& triangles,
    const labelListList& pointPoints,
    const wallSearch& search,
    backgroundMesh& mesh
)
{
    mesh.tets = subsetList(tets, [&](const tetCell& tet)
    {
        return anyOf(tet, [&](const label p) { return mesh.inside(p); });
    });

    fillGaps(mesh);
    splitWallBridges(triangles, pointPoints, search, mesh);
    splitSlitEdges(search, mesh);
    setAddressing(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

scalar backgroundMesh::gap(const simplex& s) const
{
    const scalar least = min(gaps[s[1]], gaps[s[2]]);

    return s[0] >= 0 ? min(least, gaps[s[0]]) : least;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void fillGaps(backgroundMesh& mesh)
{
    scalarField& gaps = mesh.gaps;
    bool changed = true;

    while (changed)
    {
        changed = false;

        for (const tetCell& tet : mesh.tets)
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

    mesh.tets = subsetList
    (
        mesh.tets, [&](const tetCell& tet) { return gaps[tet[0]] > 0; }
    );
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
    splitTets(simplices, mesh.points, mesh.points.size(), mesh.tets);
    mesh.points.append(points);
    mesh.gaps.append(gaps);
    mesh.free.append(free);
}


void setAddressing(backgroundMesh& mesh)
{
    setTetEdges(mesh.tets, mesh.points.size(), mesh.edges, mesh.tetEdges);
    mesh.neighbours = tetNeighbours(mesh.tets, mesh.points.size());
}


backgroundMesh makeBackgroundMesh
(
    const wallContext& context,
    const offsetEnvelope& envelope
)
{
    const wallSurface& wall = context.wall;
    tetDomain domain(wallAndEnvelope(wall, envelope));
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
        domain.holes = bodySeeds(wall, context.search());
        if (enclosedVolume(wall) > 0)
        {
            addBox(box, domain);
        }
    }

    tetMesh filled(fillDomain(domain, envelope));
    if (isOpen)
    {
        const boolList isFront
        (
            isOnFront
            (
                filled.points, filled.tets, domain.facets, triangles.size(),
                [](const label) { return true; }
            )
        );
        filled.tets = subset(isFront, filled.tets);
    }

    backgroundMesh mesh(withPointData(wall, envelope, domain, filled.points));
    UIndirectList<bool>(mesh.free, onSides) = true;
    setTets
    (
        filled.tets, triangles, context.addressing.pointPoints,
        context.search(), mesh
    );

    return mesh;
}


backgroundMesh makeBackgroundMesh(const fieldBlock& block)
{
    tetDomain domain(wallAndEnvelope(block.wall, block.envelope));
    const faceList triangles(domain.facets);
    addBox(boxAround(domain.points, block.envelope), domain);

    const tetMesh filled(fillDomain(domain, block.envelope));
    backgroundMesh mesh
    (
        withPointData(block.wall, block.envelope, domain, filled.points)
    );
    const auto isWhole = [&](const label p)
    {
        return mesh.onWall(p) && block.isWhole[p];
    };
    boolList isFront
    (
        isOnFront
        (
            filled.points, filled.tets, triangles, triangles.size(), isWhole
        )
    );

    // Beyond whole points front and back are not told apart
    forAll(filled.tets, t)
    {
        const tetCell& tet = filled.tets[t];
        isFront[t] = anyOf(tet, isWhole)
          ? isFront[t]
          : anyOf(tet, [&](const label p) { return mesh.free[p]; });
    }
    setTets
    (
        subset(isFront, filled.tets), triangles, block.pointPoints,
        block.search(), mesh
    );

    return mesh;
}

} // End namespace Foam

// ************************************************************************* //
