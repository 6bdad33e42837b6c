/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepFaceNames.H"
#include "List.H"
#include "Map.H"

#include <algorithm>
#include <cctype>
#include <string>

namespace Foam
{

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
        const std::string name(between(entity, "CONVERSION_BASED_UNIT('", "'"));

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


word cadUnit(std::istream& is, const word& type)
{
    return
        type == "step" ? stepUnit(is)
      : type == "iges" ? igesUnit(is)
      : word();
}


// * * * * * * * * * * * * * *  Step Face Names  * * * * * * * * * * * * * * //

namespace
{

struct stepEntity
{
    std::string type;

    //- The first parameter if it is a text, without quotes
    std::string name;

    //- Labels of entities among the parameters
    labelList references;
};

} // End anonymous namespace


//- Reads up to a semicolon outside of texts, without blanks outside of texts.
//  False at the end of the file.
static bool readEntity(std::istream& is, std::string& entity)
{
    entity.clear();
    bool inText = false;

    for (char c = 0; is.get(c);)
    {
        inText = inText != (c == '\'');

        if (c == ';' && !inText)
        {
            return true;
        }
        if (inText || !std::isspace(static_cast<unsigned char>(c)))
        {
            entity += c;
        }
    }

    return false;
}


//- Parameters of an entity such as #12=TYPE('name',(#3,#4))
static stepEntity parse(const std::string& text, const std::size_t equals)
{
    const std::size_t open = std::min(text.find('(', equals), text.size());
    stepEntity entity;
    entity.type = text.substr(equals + 1, open - equals - 1);
    DynamicList<label> references;
    bool inText = false;

    for (std::size_t i = open; i < text.size(); ++i)
    {
        if (text[i] == '\'')
        {
            inText = !inText;
        }
        else if (inText && references.empty())
        {
            entity.name += text[i];
        }
        else if (!inText && text[i] == '#')
        {
            references.append(std::atol(text.c_str() + i + 1));
        }
    }
    entity.references.transfer(references);

    return entity;
}


static bool isShell(const std::string& type)
{
    return type == "CLOSED_SHELL" || type == "OPEN_SHELL"
        || type == "ORIENTED_CLOSED_SHELL";
}


static bool isSolid(const std::string& type)
{
    return type == "MANIFOLD_SOLID_BREP" || type == "BREP_WITH_VOIDS"
        || type == "FACETED_BREP";
}


//- Faces of a shell, or of the shells of a body, in their order
static void addNames
(
    const Map<stepEntity>& entities,
    const stepEntity& body,
    DynamicList<string>& names
)
{
    for (const label i : body.references)
    {
        const auto entity = entities.cfind(i);

        if (!entity.good())
        {
            continue;
        }
        if (isShell(entity.val().type))
        {
            addNames(entities, entity.val(), names);
        }
        else
        {
            names.append(entity.val().name);
        }
    }
}


List<stringList> readStepFaceNames(std::istream& is)
{
    const auto isFace = [](const std::string& type)
    {
        return type == "ADVANCED_FACE" || type == "FACE_SURFACE";
    };

    Map<stepEntity> entities;
    DynamicList<stepEntity> solids, shellModels;

    for (std::string text; readEntity(is, text);)
    {
        const std::size_t equals = text.find('=');
        if (text[0] != '#' || equals == std::string::npos)
        {
            continue;
        }

        stepEntity entity(parse(text, equals));
        if (isSolid(entity.type))
        {
            solids.append(entity);
        }
        else if (entity.type == "SHELL_BASED_SURFACE_MODEL")
        {
            shellModels.append(entity);
        }
        else if (isShell(entity.type) || isFace(entity.type))
        {
            entities.insert(std::atol(text.c_str() + 1), entity);
        }
    }

    List<stringList> result;
    for (const stepEntity& body : solids.size() ? solids : shellModels)
    {
        DynamicList<string> names;
        addNames(entities, body, names);
        const bool isOne = names.size() > 1
         && std::equal(names.cbegin() + 1, names.cend(), names.cbegin());
        result.append(isOne ? stringList(names.size()) : stringList(names));
    }

    return result;
}


void nameFaces(const List<stringList>& names, cadModel& model)
{
    List<labelList> bodies(model.facesOfSolid);
    if (bodies.empty())
    {
        bodies.append(model.faces);
    }

    Map<label> bodyWith, nWith;
    forAll(names, i)
    {
        bodyWith.set(names[i].size(), i);
        ++nWith(names[i].size(), 0);
    }

    const bool areInOrder = std::equal
    (
        bodies.cbegin(), bodies.cend(), names.cbegin(), names.cend(),
        [](const labelList& body, const stringList& ofBody)
        {
            return body.size() == ofBody.size();
        }
    );

    Map<string> nameOfTag;
    forAll(bodies, i)
    {
        const labelList& body = bodies[i];

        if (areInOrder || nWith.lookup(body.size(), 0) == 1)
        {
            const label k = areInOrder ? i : bodyWith[body.size()];
            forAll(body, j)
            {
                nameOfTag.set(body[j], names[k][j]);
            }
        }
    }

    forAll(model.faces, i)
    {
        const string name(nameOfTag.lookup(model.faces[i], string()));
        if (name.size())
        {
            model.faceLabels[i] = name;
        }
    }
}

} // End namespace Foam

// ************************************************************************* //
