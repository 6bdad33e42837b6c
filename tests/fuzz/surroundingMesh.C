/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzFarField.H"
#include "farBoundary.H"
#include "makeFarFieldMesh.H"
#include "makeHexCore.H"
#include "meshCertificate.H"
#include "randomSurface.H"
#include "refineSurface.H"
#include "refineTets.H"
#include "tetEditor.H"
#include "tetrahedralize.H"
#include "wallSearch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Widths that cells are to have
class wantedWidths
{
    const wallSearch search_;

    //- On the wall and far from it, and how they grow
    scalar onWall_;
    scalar largest_;
    const scalar slope_;

    //- Balls in which the widths are smaller
    pointField centres_;
    scalarField radii_;


public:

    wantedWidths(const surroundings& around, Random& random)
    :
        search_(around.wall),
        onWall_
        (
            randomSurfaces::logUniform(random, 0.5, 2.5)
           *min
            (
                average(meanEdges(around.wall, makeWallAddressing(around.wall)))
              , 0.1*boundBox(around.wall.points, false).mag()
            )
        ),
        largest_
        (
            boundBox(around.wall.points, false).mag()
           *randomSurfaces::logUniform(random, 0.06, 0.3)
        ),
        slope_(random.position<scalar>(0.2, 1)),
        centres_(random.position<label>(0, 2)),
        radii_(centres_.size())
    {
        forAll(centres_, i)
        {
            const vector share(random.sample01<vector>());
            centres_[i] =
                around.box.min() + cmptMultiply(share, around.box.span());
            radii_[i] =
                around.box.mag()*randomSurfaces::logUniform(random, 0.05, 0.3);
        }
    }

    scalar largest() const { return largest_; }

    void coarsen()
    {
        onWall_ *= 1.3;
        largest_ *= 1.3;
    }

    scalar operator()(const point& x) const
    {
        scalar width =
            min(largest_, onWall_ + slope_*search_.footOf(x).distance);
        forAll(centres_, i)
        {
            if (mag(x - centres_[i]) < radii_[i])
            {
                width = min(width, 0.4*largest_);
            }
        }

        return width;
    }
};


//- The box with its patches, each name once
static hexCoreBox patchedBox(const surroundings& around)
{
    hexCoreBox made;
    made.box = around.box;
    made.sidePatches.setSize(6);
    forAll(around.names, i)
    {
        if (!made.patches.names.found(around.names[i]))
        {
            made.patches.append(around.names[i], "patch");
        }
        made.sidePatches[i] = made.patches.names.find(around.names[i]);
    }

    return made;
}


//- Hexahedra, divided where they are wider than wanted if that is asked for
static polyMeshParts makeHexahedra
(
    const surroundings& around,
    wantedWidths& widths,
    const bool divided,
    Random& random
)
{
    vector stretch(1, 1, 1);
    if (randomSurfaces::chance(random, 0.5))
    {
        stretch += 1.5*random.sample01<vector>();
    }
    if (!divided)
    {
        stretch *= 0.5;
    }

    while (true)
    {
        const vector counts
        (
            cmptDivide(around.box.span(), widths.largest()*stretch)
        );
        labelVector n;
        for (direction d = 0; d < 3; ++d)
        {
            n[d] = max(min(counts[d] + 0.5, scalar(30)), scalar(1));
        }
        const hexOctree tree
        (
            around.box, n,
            [&](const boundBox& b, bool&)
            {
                return divided && cmptMax(b.span()) > widths(b.midpoint())
                  ? hexOctree::parts::eight : hexOctree::parts::none;
            },
            40000
        );
        if (tree.complete)
        {
            return hexFaces(tree, patchedBox(around));
        }
        widths.coarsen();
    }
}


//- Moves the points inside the box by up to that share of their shortest edges
static void shake
(
    const boundBox& box,
    const scalar share,
    Random& random,
    polyMeshParts& mesh
)
{
    scalarField lengths(mesh.points.size(), GREAT);
    for (const face& f : mesh.topology.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar length = e.mag(mesh.points);
            lengths[e.start()] = min(lengths[e.start()], length);
            lengths[e.end()] = min(lengths[e.end()], length);
        }
    }

    forAll(mesh.points, p)
    {
        point& x = mesh.points[p];
        const scalar inside =
            min(cmptMin(x - box.min()), cmptMin(box.max() - x));
        const scalar length =
            share*lengths[p]*random.sample01<scalar>();
        if (inside > 1e-6*box.mag())
        {
            x += length*randomSurfaces::unitVector(random);
        }
    }
}


static bool isSound(const polyMeshParts& mesh)
{
    const labelList owner(mesh.topology.owner);
    const labelList neighbour(mesh.topology.neighbour);
    const faceList faces(mesh.topology.faces);
    const polyhedralMesh cells(mesh.points, faces, owner, neighbour);

    return certifyMesh(cells, labelList(), labelList()).invalidCells.empty();
}


//- The same mesh with points moved, as far as its cells remain positive
static polyMeshParts shaken
(
    const polyMeshParts& mesh,
    const boundBox& box,
    Random& random
)
{
    scalar share = random.position<scalar>(0.02, 0.3);
    for (label attempt = 0; attempt < 5; ++attempt)
    {
        polyMeshParts moved(mesh);
        shake(box, share, random, moved);
        if (isSound(moved))
        {
            return moved;
        }
        share *= 0.5;
    }

    return mesh;
}


static polyMeshParts makeTetrahedra
(
    const surroundings& around,
    wantedWidths& widths
)
{
    farBoundaryControls boxControls;
    boxControls.type = farBoundaryType::box;
    boxControls.box = around.box;
    wallSurface surface(makeFarBoundary(boxControls, nullptr).surface);
    widths.coarsen();
    const std::function<scalar(const point&)> size(std::cref(widths));
    refineSurface(surface, size);

    tetMesh filled
    (
        tetrahedralize
        (
            tetDomain{surface.points, surface.faces, pointField()}
        )
    );
    refineTets(wantedPoints(), size, 60000, filled);
    farFieldTets tets;
    tets.nBoundaryPoints = surface.points.size();
    tets.boundaryTriangles = surface.faces;
    const hexCoreBox box(patchedBox(around));
    tets.patchIDs = UIndirectList<label>(box.sidePatches, surface.patchIDs)();
    tets.patches = box.patches;
    tets.points.transfer(filled.points);
    tets.tets.transfer(filled.tets);
    tets.neighbours = tetNeighbours(tets.tets, tets.points.size());

    // Without the patch on layers
    polyMeshParts none;
    polyMeshParts made(joinCells(tets, none, coreCut()));
    polyMeshTopology& t = made.topology;
    t.patchStarts = labelList
    (
        SubList<label>(t.patchStarts, t.patchStarts.size() - 1, 1)
    );
    t.patchSizes = labelList
    (
        SubList<label>(t.patchSizes, t.patchSizes.size() - 1, 1)
    );

    return made;
}


//- Zones of all cells, of those on one side of the middle along x, and of the
//  faces between
static void setZones(polyMeshParts& mesh)
{
    pointField centres;
    scalarField volumes;
    setCentresAndVolumes(mesh, identity(mesh.nCells), centres, volumes);
    const scalar middle = boundBox(mesh.points, false).centre().x();
    DynamicList<label> half;
    forAll(centres, celli)
    {
        if (centres[celli].x() < middle)
        {
            half.append(celli);
        }
    }

    faceZoneParts between;
    between.name = "between";
    DynamicList<label> faces;
    DynamicList<bool> flips;
    forAll(mesh.topology.neighbour, facei)
    {
        const bool own = centres[mesh.topology.owner[facei]].x() < middle;
        const bool nei = centres[mesh.topology.neighbour[facei]].x() < middle;
        if (own != nei)
        {
            faces.append(facei);
            flips.append(!own);
        }
    }
    between.faces.transfer(faces);
    between.flips.transfer(flips);

    mesh.cellZones = List<cellZoneParts>
    ({
        cellZoneParts("all", identity(mesh.nCells)),
        cellZoneParts("half", half)
    });
    mesh.faceZones = List<faceZoneParts>(1, between);
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::polyMeshParts Foam::makeSurroundingMesh
(
    const surroundings& around,
    Random& random,
    std::string& kind
)
{
    const scalar what = random.sample01<scalar>();
    wantedWidths widths(around, random);
    polyMeshParts mesh;

    if (what < 0.15)
    {
        kind += "tets";
        mesh = makeTetrahedra(around, widths);
    }
    else
    {
        const bool divided = what < 0.8;
        mesh = makeHexahedra(around, widths, divided, random);
        kind += divided ? "octree" : "uniform";
        if (randomSurfaces::chance(random, 0.4))
        {
            kind += "Shaken";
            mesh = shaken(mesh, around.box, random);
        }
    }

    // Without the patch that has no name and, around all of a box, no faces
    const label nPatches = mesh.patches.names.size();
    mesh.topology.patchStarts.setSize(nPatches);
    mesh.topology.patchSizes.setSize(nPatches);
    setZones(mesh);

    return mesh;
}


// ************************************************************************* //
