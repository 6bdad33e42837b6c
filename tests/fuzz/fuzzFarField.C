/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fuzzFarField.H"
#include "planeDomain.H"
#include "boxSides.H"
#include "makeHexCore.H"
#include "randomSurface.H"

using Foam::randomSurfaces::chance;
using Foam::randomSurfaces::logUniform;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

namespace
{

class farFieldMaker
{
    const wallSurface& wall_;
    const List<sidePatch>& sides_;
    const scalar thickness_;
    const scalar size_;
    Random& random_;

    //- Whether the wall ends on other side patches than planes
    const bool onParts_;

    fuzzFarField made_;

    //- Whether the normals of all planes are along the axes
    bool isAlongAxes() const;

    //- From the coordinates of the case to those of the box
    tensor rotation();

    //- A box around the wall, or some of it; its sides are in planes on which
    //  the wall ends, most of them
    boundBox boxAround(const wallSurface& wall, const List<sidePatch>& planes);

    //- Appends a plane of the domain, unless it is there
    void addPlane(const sidePlane& plane, const wordList& patches);

    //- Appends the planes on which the wall ends
    void addSides();

    void addBoxSides();

    void setSizes();

    void setBox();

    void setSphere();

    void setMesh();

    //- A mesh of equal hexahedra in the box of the controls, with its patches.
    //  There is no far boundary any more.
    void setEqualHexahedra();

    //- Couples the sides xMin and xMax of some meshes
    void setCyclic();

public:

    farFieldMaker
    (
        const wallSurface& wall,
        const scalar thickness,
        Random& random
    )
    :
        wall_(wall),
        sides_(wall.border.sides),
        thickness_(thickness),
        size_(cmptMax(boundBox(wall.points, false).span())),
        random_(random),
        onParts_(sides_.size() && sides_[0].isPart())
    {}

    fuzzFarField make();

    fuzzFarField make(const prismLayerControls& controls);
};

} // End anonymous namespace


bool farFieldMaker::isAlongAxes() const
{
    return std::all_of
    (
        sides_.begin(), sides_.end(), [](const sidePatch& side)
        {
            return cmptMax(cmptMag(side.normal)) > 1 - 1e-12;
        }
    );
}


tensor farFieldMaker::rotation()
{
    if (sides_.size())
    {
        const vector x(sides_[0].normal);
        const vector other
        (
            mag(x.x()) < 0.6 ? vector(1, 0, 0) : vector(0, 1, 0)
        );
        const vector y(normalised(x ^ other));

        return isAlongAxes() ? tensor(tensor::I) : tensor(x, y, x ^ y);
    }

    return
        chance(random_, 0.7)
      ? tensor(tensor::I) : randomSurfaces::rotation(random_);
}


boundBox farFieldMaker::boxAround
(
    const wallSurface& wall,
    const List<sidePatch>& planes
)
{
    boundBox box(wall.points, false);
    const scalar farthest = chance(random_, 0.4) ? 0.5 : 3;

    for (direction d = 0; d < 3; ++d)
    {
        const auto margin = [&]()
        {
            return
                thickness_ + size_*logUniform(random_, 0.02, farthest);
        };
        box.min()[d] -= margin();
        box.max()[d] += margin();
    }

    for (const sidePatch& plane : planes)
    {
        for (direction d = 0; d < 3; ++d)
        {
            if (plane.normal[d] > 1 - 1e-12 && chance(random_, 0.9))
            {
                box.max()[d] = plane.origin[d];
            }
            else if (plane.normal[d] < -1 + 1e-12 && chance(random_, 0.9))
            {
                box.min()[d] = plane.origin[d];
            }
        }
    }

    // Some of the wall is beyond
    if (chance(random_, 0.03))
    {
        const direction d = random_.position<label>(0, 2);
        box.max()[d] = box.min()[d]
          + random_.position<scalar>(0.1, 0.9)*box.span()[d];
    }

    return box;
}


void farFieldMaker::addPlane(const sidePlane& plane, const wordList& patches)
{
    forAll(made_.planes, i)
    {
        const sidePlane& other = made_.planes[i];
        if
        (
            mag(other.normal - plane.normal) < 1e-9
         && mag(other.distance(plane.origin)) < 1e-9*size_
        )
        {
            made_.planePatches[i].append(patches);
            return;
        }
    }

    made_.planes.append(plane);
    made_.planePatches.append(patches);
}


void farFieldMaker::addSides()
{
    for (const sidePatch& side : sides_)
    {
        if (!side.isPart())
        {
            addPlane(side, wordList(1, side.name));
        }
    }
}


void farFieldMaker::addBoxSides()
{
    const farBoundaryControls& boundary = made_.controls.boundary;
    for (const sidePatch& side : sidesOf(boundary.box))
    {
        word patch(side.name);
        for (const farPatch& wanted : boundary.patches)
        {
            patch = wanted.sides.match(side.name) ? wanted.name : patch;
        }
        addPlane(side, wordList(1, patch));
    }
}


void farFieldMaker::setSizes()
{
    farFieldControls& controls = made_.controls;
    controls.growthRate = random_.position<scalar>(1.1, 1.5);
    controls.gap = random_.position<scalar>(0.1, 1.5);
    controls.maxCells = chance(random_, 0.03) ? 3000 : 150000;

    // Most walls are coarse: between them hexahedra need smaller sizes
    if (chance(random_, made_.fluidInside ? 0.95 : 0.6))
    {
        const scalar most = made_.fluidInside ? 0.12 : 0.3;
        controls.maxCellSize = size_*logUniform(random_, 0.025, most);
    }

    if (chance(random_, 0.2))
    {
        const boundBox bounds(wall_.points, false);
        const vector share(random_.sample01<vector>());
        const point x(bounds.min() + cmptMultiply(share, bounds.span()));

        sizeRegion region;
        region.name = "region";
        region.geometry.add("type", word("searchableSphere"));
        region.geometry.add("centre", x);
        region.geometry.add
        (
            "radius", size_*logUniform(random_, 0.05, 0.5)
        );
        region.cellSize = size_*logUniform(random_, 0.03, 0.2);
        controls.regions = List<sizeRegion>(1, region);
    }
}


void farFieldMaker::setBox()
{
    farBoundaryControls& boundary = made_.controls.boundary;
    boundary.type = farBoundaryType::box;
    boundary.box = boxAround(wall_, sides_);
    made_.kind += "box";

    if (chance(random_, 0.4))
    {
        farPatch inlet;
        inlet.name = "inlet";
        inlet.sides = wordRes(1, wordRe("xMin"));
        farPatch around;
        around.name = "around";
        around.type = "symmetry";
        around.sides = wordRes(1, wordRe("[yz].*", wordRe::REGEX));
        boundary.patches = List<farPatch>({inlet, around});
    }

    if (!onParts_)
    {
        addBoxSides();
    }
}


void farFieldMaker::setSphere()
{
    const boundBox bounds(wall_.points, false);
    farBoundaryControls& boundary = made_.controls.boundary;
    boundary.type = farBoundaryType::sphere;
    boundary.radius =
        thickness_ + 0.5*bounds.mag()*logUniform(random_, 1.1, 4);
    boundary.origin =
        bounds.centre()
      + 0.05*size_*randomSurfaces::unitVector(random_);
    made_.kind += "sphere";
}


void farFieldMaker::setMesh()
{
    const tensor R(rotation());
    wallSurface turned(wall_);
    turned.points = R & turned.points;
    turned.border = wallBorder();
    List<sidePatch> planes(sides_);
    for (sidePatch& plane : planes)
    {
        plane.origin = R & plane.origin;
        plane.normal = R & plane.normal;
    }

    surroundings around{turned, boxAround(turned, planes), wordList(6)};
    const bool isGrouped = chance(random_, 0.4);
    List<sidePatch> boxSides(sidesOf(around.box));
    forAll(boxSides, i)
    {
        around.names[i] =
            isGrouped ? (i ? "around" : "inlet") : boxSides[i].name;
        for (const sidePatch& plane : planes)
        {
            if (mag(plane.normal - boxSides[i].normal) < 1e-9)
            {
                around.names[i] =
                    chance(random_, 0.7) ? plane.name : around.names[i];
            }
        }
    }
    made_.core = makeSurroundingMesh(around, random_, made_.kind);
    made_.core.points = made_.core.points & R;

    setCyclic();

    forAll(boxSides, i)
    {
        boxSides[i].origin = boxSides[i].origin & R;
        boxSides[i].normal = boxSides[i].normal & R;
        addPlane(boxSides[i], wordList(1, around.names[i]));
    }
}


void farFieldMaker::setCyclic()
{
    const wordList ends({"xMin", "xMax"});
    meshPatches& patches = made_.core.patches;
    if
    (
        made_.kind != "mesh uniform" || !chance(random_, 0.3)
     || !patches.names.found(ends[0]) || !patches.names.found(ends[1])
    )
    {
        return;
    }

    for (const label i : {0, 1})
    {
        dictionary& entry = patches.entries[patches.names.find(ends[i])];
        entry.set("type", word("cyclic"));
        entry.set("neighbourPatch", ends[1 - i]);
    }
    made_.kind += "Cyclic";
}


void farFieldMaker::setEqualHexahedra()
{
    static const scalar most = 30;
    farBoundaryControls& boundary = made_.controls.boundary;
    hexCoreBox box;
    box.box = boundary.box;
    box.sidePatches = identity(6);
    for (const sidePatch& side : sidesOf(boundary.box))
    {
        box.patches.append(side.name, "patch");
    }
    for (const farPatch& patch : boundary.patches)
    {
        const label i = box.patches.names.find(string(patch.sides[0]));
        box.patches.entries[i].set("type", patch.type);
        box.patches.names[i] = patch.name;
    }

    labelVector n;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar counts = box.box.span()[d]/made_.controls.maxCellSize;
        n[d] = max(min(2*counts + 1, most), scalar(1));
        for (const label side : {2*d, 2*d + 1})
        {
            box.patches.entries[side].set
            (
                "neighbourPatch", box.patches.names[side ^ 1]
            );
        }
    }
    const hexOctree tree
    (
        box.box, n,
        [](const boundBox&, bool&) { return hexOctree::parts::none; }, 100000
    );
    made_.core = hexFaces(tree, box);
    made_.core.topology.patchStarts.setSize(6);
    made_.core.topology.patchSizes.setSize(6);
    made_.core.cellZones.append
    (
        cellZoneParts("all", identity(made_.core.nCells))
    );
    boundary = farBoundaryControls();
}


fuzzFarField farFieldMaker::make()
{
    made_.fluidInside = boundsFluid(wall_);
    setSizes();

    addSides();

    // A mesh ends in planes that are at right angles to each other
    const bool isMeshable = sides_.size() <= 1 || isAlongAxes();
    const scalar share = onParts_ || !isMeshable ? 0.02 : 0.5;
    farFieldType& type = made_.controls.type;
    type =
        chance(random_, share) ? farFieldType::mesh
      : chance(random_, 0.9) ? farFieldType::hexCore : farFieldType::tet;
    made_.kind = farFieldTypes[int(type)] + ' ';

    const bool isBounded =
        !made_.fluidInside
     || (sides_.size() && !onParts_ && chance(random_, 0.3));
    if (type == farFieldType::mesh)
    {
        setMesh();
    }
    else if (!isBounded)
    {
        made_.kind += "inside";
    }
    else if (sides_.empty() && chance(random_, 0.3))
    {
        setSphere();
    }
    else
    {
        setBox();
    }

    if (onParts_)
    {
        made_.planes.clear();
    }

    return made_;
}


fuzzFarField farFieldMaker::make(const prismLayerControls& controls)
{
    made_.kind = kindOf(controls);
    made_.controls = controls.farField;
    made_.isChecked = true;
    made_.fluidInside = boundsFluid(wall_);
    addSides();
    addBoxSides();
    if (made_.controls.type == farFieldType::mesh)
    {
        setEqualHexahedra();
    }

    return made_;
}

} // End namespace Foam


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::fuzzFarField Foam::makeFuzzFarField
(
    const wallSurface& wall,
    const scalar thickness,
    Random& random
)
{
    return farFieldMaker(wall, thickness, random).make();
}


std::string Foam::kindOf(const prismLayerControls& controls)
{
    typedef surfaceRepairControls::method method;

    return
        (controls.surface.repair.repair == method::none ? "" : "stitch ")
      + farFieldTypes[int(controls.farField.type)];
}


Foam::fuzzFarField Foam::fuzzFarFieldOf
(
    const wallSurface& wall,
    const prismLayerControls& controls
)
{
    Random none(0);

    return farFieldMaker(wall, 0, none).make(controls);
}


// ************************************************************************* //
