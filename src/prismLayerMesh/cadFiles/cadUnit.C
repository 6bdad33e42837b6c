/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cadUnit.H"
#include "List.H"

#include <algorithm>
#include <cctype>
#include <string>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static word lowerCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(), ::tolower);

    return word(text);
}


//- What is between two texts; empty if they are not there
static std::string between
(
    const std::string& text,
    const std::string& before,
    const std::string& after
)
{
    const auto start = text.find(before);
    if (start == std::string::npos)
    {
        return std::string();
    }

    const auto first = start + before.size();
    const auto end = text.find(after, first);

    return end == std::string::npos
      ? std::string() : text.substr(first, end - first);
}


//- The unit of a STEP file. If it has several, one that is defined by another
//  is the unit.
static word stepUnit(std::istream& is)
{
    std::string entity;
    word unit;

    while (std::getline(is, entity, ';'))
    {
        if (entity.find("LENGTH_UNIT") == std::string::npos)
        {
            continue;
        }
        entity.erase
        (
            std::remove_if(entity.begin(), entity.end(), ::isspace),
            entity.end()
        );
        const std::string name
        (
            between(entity, "CONVERSION_BASED_UNIT('", "'")
        );

        if (name.size())
        {
            return lowerCase(name);
        }
        if (unit.empty() && entity.find(".METRE.") != std::string::npos)
        {
            unit = lowerCase(between(entity, "SI_UNIT(.", ".") + "metre");
        }
    }

    return unit;
}


//- The unit of an IGES file: its global section, marked by G in column 73, has
//  the name with its length and H in front
static word igesUnit(std::istream& is)
{
    std::string line, section;

    while (std::getline(is, line))
    {
        if (line.size() > 72 && line[72] == 'G')
        {
            section += line.substr(0, 72);
        }
    }

    const List<std::pair<const char*, const char*>> names
    ({
        {",2HMM,", "millimetre"}, {",2HCM,", "centimetre"},
        {",1HM,", "metre"}, {",2HKM,", "kilometre"}, {",2HUM,", "micrometre"},
        {",2HIN,", "inch"}, {",4HINCH,", "inch"}, {",2HFT,", "foot"}
    });

    for (const auto& name : names)
    {
        if (section.find(name.first) != std::string::npos)
        {
            return name.second;
        }
    }

    return word();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

word cadUnit(std::istream& is, const word& type)
{
    return
        type == "step" ? stepUnit(is)
      : type == "iges" ? igesUnit(is)
      : word();
}

} // End namespace Foam

// ************************************************************************* //
