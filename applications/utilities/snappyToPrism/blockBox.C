/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "blockBox.H"
#include "blockMesh.H"
#include "boxSides.H"
#include "controlEntries.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "StringStream.H"

namespace Foam
{

//- Area of the faces that are in a side of the box, up to a distance [m]
static scalar areaInSide
(
    const faceList& faces,
    const pointField& points,
    const sidePatch& side,
    const scalar tolerance
)
{
    scalar area = 0;
    for (const face& f : faces)
    {
        const scalar distance = mag(side.distance(f.centre(points)));
        area += distance < tolerance ? f.mag(points) : 0;
    }

    return area;
}


//- The type of a patch as a far boundary can have it
static word farType
(
    const word& name,
    const word& type,
    remarkList& remarks
)
{
    static const wordList kept({"patch", "wall", "symmetry", "symmetryPlane"});
    const word other(type == "empty" ? "symmetry" : "patch");
    const word now(kept.found(type) ? type : other);
    if (now != type)
    {
        remarks.append("blockMesh: " + name + " is " + type + ", here " + now);
    }

    return now;
}


//- Entries of farField.boundary.patches: each side has the patch with the
//  largest area
static dictionary patchesOf
(
    const blockMesh& blocks,
    const boundBox& box,
    remarkList& remarks
)
{
    const wordList names(blocks.patchNames());
    const PtrList<dictionary> dicts(blocks.patchDicts());
    const pointField& points = blocks.points();
    List<wordList> sides(names.size());
    for (const sidePatch& side : sidesOf(box))
    {
        scalarField areas(names.size());
        forAll(names, i)
        {
            areas[i] =
                areaInSide(blocks.patches()[i], points, side, 1e-6*box.mag());
        }
        const label largest = findMax(areas);
        const word& name = side.name;
        if (largest < 0 || areas[largest] <= 0)
        {
            continue;
        }
        sides[largest].append(name);
        if (sum(areas) > 1.001*areas[largest])
        {
            remarks.append
            (
                "blockMesh: the side " + name + " has several patches; all of"
                " it is " + names[largest]
            );
        }
    }

    dictionary patches;
    forAll(names, i)
    {
        if (sides[i].size())
        {
            const word type(dicts[i].get<word>("type"));
            dictionary patch;
            patch.add("type", farType(names[i], type, remarks));
            patch.add("sides", sides[i]);
            patches.add(names[i], patch);
        }
        else
        {
            remarks.append("blockMesh: " + names[i] + " is on no side");
        }
    }

    return patches;
}


static IOobject findDict(const Time& time)
{
    const auto at = [&](const fileName& instance, const fileName& local)
    {
        return IOobject
        (
            "blockMeshDict", instance, local, time, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        );
    };
    IOobject inSystem(at(time.system(), ""));

    return inSystem.typeHeaderOk<IOdictionary>(false)
      ? inSystem : at(time.constant(), "polyMesh");
}


//- Checks that vertices and blocks are there. Adds an empty boundary if there
//  is none.
static void complete(dictionary& dict, remarkList& remarks)
{
    for (const char* key : {"vertices", "blocks"})
    {
        if (!dict.found(key))
        {
            missingEntry(dict, key);
        }
    }
    if (!dict.found("boundary") && !dict.found("patches"))
    {
        IStringStream none("boundary ();");
        dict.merge(dictionary(none));
        remarks.append
        (
            "blockMeshDict has no boundary: all sides of the box are one patch."
            " Name others in farField.boundary.patches"
        );
    }
}


blockBox readBlockBox(const Time& time, remarkList& remarks)
{
    blockBox box;
    IOobject io(findDict(time));
    if (!io.typeHeaderOk<IOdictionary>(false))
    {
        return box;
    }
    IOdictionary dict(io);
    dict.set("verbose", false);
    complete(dict, remarks);
    const blockMesh blocks(dict, polyMesh::defaultRegion);
    const pointField& points = blocks.points();

    scalar volume = 0;
    box.shortest = GREAT;
    for (const cellShape& cell : blocks.cells())
    {
        volume += cell.mag(points);
        for (const edge& e : cell.edges())
        {
            // Edges of collapsed blocks have no length
            const scalar length = e.mag(points);
            box.shortest = min(box.shortest, length > 0 ? length : GREAT);
        }
    }

    box.isFound = true;
    box.isRefined = isFile(time.system()/"refineMeshDict");
    if (box.isRefined)
    {
        remarks.append("refineMesh divides cells: set sizes by hand");
    }
    box.names = blocks.patchNames();
    box.bounds = boundBox(points, false);
    box.width = Foam::cbrt(volume/blocks.cells().size());
    box.isBox = mag(volume/box.bounds.volume() - 1) < 1e-6;
    if (box.isBox)
    {
        box.patches = patchesOf(blocks, box.bounds, remarks);
    }

    return box;
}

} // End namespace Foam

// ************************************************************************* //
