/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadPatches.H"
#include "HashTable.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

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


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

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
