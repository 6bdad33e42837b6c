/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadTriangulation.H"
#include "bitSet.H"
#include "boundBox.H"
#include "HashSet.H"
#include "HashTable.H"
#include "Map.H"
#include "StringStream.H"
#include "triFace.H"

namespace Foam
{

//- For each tag the patch of its face, -1 if the face is between two solids
static labelList findPatches(const cadModel& model, label& nBetween)
{
    const labelList nSolids(model.nSolids());
    labelList patchOfTag(nSolids.size(), -1);
    forAll(model.faces, i)
    {
        const label tag = model.faces[i];

        if (nSolids[tag] < 2)
        {
            patchOfTag[tag] = i;
        }
        else
        {
            ++nBetween;
        }
    }

    return patchOfTag;
}


static void countFaults(cadTriangulation& made)
{
    const wallSurface& wall = made.wall;
    HashSet<triFace, triFace::Hash<>> triangles;
    bitSet hasTriangles(wall.patchNames.size());
    hasTriangles.set(wall.patchIDs);

    for (const face& f : wall.faces)
    {
        made.nTwins += !triangles.insert(triFace(f));
    }
    made.nOpen = made.model.solidLabels.size() ? outline(wall.faces).size() : 0;
    made.nBare = wall.patchNames.size() - made.nBetween - hasTriangles.count();
}


cadTriangulation makeCadTriangulation
(
    const cadModel& model,
    const cadTriangles& mesh
)
{
    cadTriangulation made;
    made.model = model;
    const labelList patchOfTag(findPatches(model, made.nBetween));

    DynamicList<face> faces(mesh.faces.size());
    DynamicList<label> patchIDs(mesh.faces.size());
    forAll(mesh.faces, i)
    {
        const label tag = mesh.tags[i];
        const label patchi =
            tag >= 0 && tag < patchOfTag.size() ? patchOfTag[tag] : -1;

        if (patchi >= 0)
        {
            faces.append(mesh.faces[i]);
            patchIDs.append(patchi);
        }
    }

    made.wall.points = mesh.points;
    made.wall.patchNames = cadPatchNames(model);
    made.wall.faces.transfer(faces);
    made.wall.patchIDs.transfer(patchIDs);
    countFaults(made);

    return made;
}


string describe
(
    const cadTriangulation& made,
    const word& unit,
    const scalar scale,
    const string& by
)
{
    boundBox box;
    for (const face& f : made.wall.faces)
    {
        for (const label p : f)
        {
            box.add(made.wall.points[p]);
        }
    }
    const vector size(scale*box.span());

    OStringStream os;
    os  << "unit: " << (unit.empty() ? "none, taken for metres" : unit.c_str())
        << (scale < 1 || scale > 1 ? ", scaled" : "")
        << "; " << size.x() << " x " << size.y() << " x " << size.z()
        << " m; solids " << made.model.solidLabels.size()
        << ", faces " << made.model.faces.size()
        << ", triangles " << made.wall.faces.size()
        << " by gmsh " << by.c_str();

    const auto add = [&](const label n, const char* what)
    {
        if (n)
        {
            os << "; " << what << ' ' << n;
        }
    };
    add(made.model.nLoose, "faces of no solid, left out");
    add(made.nBetween, "faces between two solids, left out");
    add(made.nBare, "faces without triangles");
    add(made.nOpen, "open edges of solids");
    add(made.nTwins, "triangles on each other");

    return os.str();
}


// * * * * * * * * * * * * * * *  Cad Patches  * * * * * * * * * * * * * * * //

//- Whether a part of a label is from a program rather than from the user
static bool isGeneric(const std::string& part)
{
    const wordList kinds
    ({
        "", "NONE", "Shapes", "SOLID", "COMPOUND", "COMPSOLID", "SHELL", "FACE"
    });

    return kinds.found(word(part, false))
     || part.find_first_not_of("0123456789") == std::string::npos
     || part.rfind("=>", 0) == 0
     || part.rfind("Open CASCADE STEP translator", 0) == 0;
}


//- The last part of a label such as Shapes/Assembly/Part/SOLID that is a name;
//  empty if there is none
static word nameIn(const string& label)
{
    std::string rest(label);

    while (rest.size())
    {
        const auto slash = rest.rfind('/');
        const std::string part
        (
            slash == std::string::npos ? rest : rest.substr(slash + 1)
        );
        rest.resize(slash == std::string::npos ? 0 : slash);

        const word name(word::validate(part, true));
        if (!isGeneric(part) && name.size())
        {
            return name;
        }
    }

    return word();
}


//- Different names of the solids
static wordList solidNames(const cadModel& model)
{
    wordList names(model.solidLabels.size());
    HashTable<label> total, used;

    forAll(names, i)
    {
        names[i] = nameIn(model.solidLabels[i]);
        if (names[i].empty())
        {
            names[i] = "solid";
        }
        ++total(names[i], 0);
    }

    for (word& name : names)
    {
        if (total[name] > 1 || name == "solid")
        {
            const label k = ++used(name, 0);
            name += Foam::name(k);
        }
    }

    return names;
}


wordList cadPatchNames(const cadModel& model)
{
    const wordList solids(solidNames(model));
    const bool several = solids.size() > 1;
    Map<word> prefixes;
    Map<label> numbers;
    wordHashSet ofSolids;

    forAll(solids, i)
    {
        ofSolids.insert(nameIn(model.solidLabels[i]));

        forAll(model.facesOfSolid[i], k)
        {
            const label tag = model.facesOfSolid[i][k];
            prefixes.insert(tag, several ? solids[i] + '.' : word());
            numbers.insert(tag, k + 1);
        }
    }

    wordList names(model.faces.size());
    forAll(names, i)
    {
        // Files give faces without names the name of their solid
        const word own(nameIn(model.faceLabels[i]));
        const label tag = model.faces[i];

        names[i] = prefixes.lookup(tag, word())
          + (
                own.size() && !ofSolids.found(own)
              ? own : word("face" + name(numbers.lookup(tag, i + 1)))
            );
    }

    return names;
}

} // End namespace Foam

// ************************************************************************* //
