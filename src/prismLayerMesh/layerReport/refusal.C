/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refusal.H"
#include "layerReport.H"
#include "pluginVersion.H"

#include <regex>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static const char* const codeNames[] =
{
    "request", "dictionary", "surface", "noRoom", "resources", "internal"
};


//- The stages that read and prepare the surface
static const wordList surfaceStages
({
    "wallSurface", "surfaceRepair", "surfaceRemesh", "flushPatches",
    "sidePatches", "wallDefects", "trial", "spaceRegions"
});


//- The first match of an expression in a text, or of a part of it
static std::string found
(
    const std::string& text,
    const char* expression,
    const int part = 0
)
{
    std::smatch match;
    std::regex_search(text, match, std::regex(expression));

    return match.empty() ? std::string() : match.str(part);
}


static pointField placeIn(const std::string& message)
{
    static const char* const expression =
        "at (places: )?"
        "\\(([-+.0-9e]+)\\s+([-+.0-9e]+)\\s+([-+.0-9e]+)\\)";
    std::smatch match;
    if (!std::regex_search(message, match, std::regex(expression)))
    {
        return pointField();
    }

    return pointField
    (
        1,
        point
        (
            std::strtod(match.str(2).c_str(), nullptr),
            std::strtod(match.str(3).c_str(), nullptr),
            std::strtod(match.str(4).c_str(), nullptr)
        )
    );
}


//- The sentences that begin with what to do
static std::string remedyIn(const std::string& message)
{
    static const std::regex sentence
    (
        "(^|[.:]\\s+|\\n\\s*)((Use|Give|Write|Rename|Make|Name|Install"
        "|Round off|Raise|Lower|Choose|Set|Put|Remesh|Turn|Leave|Move)"
        "\\s[^\\n]*)"
    );
    std::string remedy;
    for
    (
        std::sregex_iterator i(message.begin(), message.end(), sentence), end;
        i != end;
        ++i
    )
    {
        remedy += (remedy.empty() ? "" : " ") + i->str(2);
    }

    return remedy;
}


//- The entry of a dictionary: its path below the file, and the key that the
//  message names
static std::string entryOf(const std::string& name, const std::string& message)
{
    const std::string path(found(name, "[/:.][A-Za-z]*Dict[.:](.*)$", 1));
    const std::string key
    (
        found
        (
            message,
            "^(Value of|Unknown key|The entry|The dictionary|Both)\\s+"
            "([A-Za-z_]\\w*)",
            2
        )
    );

    return path + (path.empty() || key.empty() ? "" : ".") + key;
}


static refusal::codes codeOf(const std::string& message, const word& stage)
{
    const bool lacks = found
    (
        message,
        "not enough memory|Cannot write|Cannot replace|Install the program"
        "|takes longer than"
    ).size();

    return
        lacks ? refusal::codes::resources
      : surfaceStages.found(stage) ? refusal::codes::surface
      : refusal::codes::request;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

refusalError::refusalError(const refusal& fields)
:
    error("--> FOAM FATAL ERROR: "),
    fields_(fields)
{
    OSstream& os = *this;
    os  << fields.message.c_str();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

refusal refusalOf(const error& failure, const word& stage)
{
    refusal what;
    if (const auto* known = dynamic_cast<const refusalError*>(&failure))
    {
        what = known->fields();
    }
    else
    {
        const std::string message(failure.message());
        what.message = message;
        what.code = codeOf(message, stage);
        what.patch = found(message, "(side )?patch (?!of |is |that )(\\w+)", 2);
        what.entry = found
        (
            message, "\\b(surface|layers|farField|field|quality)(\\.\\w+)+"
        );
        what.place = placeIn(message);
        what.remedy = remedyIn(message);
        const auto* io = dynamic_cast<const IOerror*>(&failure);
        if (io && io->ioFileName().size())
        {
            const std::string& name = io->ioFileName();
            what.code = refusal::codes::dictionary;
            what.entry = entryOf(name, message);
            what.file = found(name, "^.*?Dict(?=[.:]|$)");
            what.file = what.file.empty() ? fileName(name) : what.file;
            what.line = io->ioStartLineNumber();
        }
    }
    what.stage = stage;

    return what;
}


dictionary toDictionary(const refusal& what)
{
    dictionary dict;
    dict.add("schemaVersion", reportVersion);
    dict.add("version", string(pluginVersion));
    dict.add("status", word("refused"));
    dict.add("code", word(codeNames[int(what.code)]));
    dict.add("exitStatus", label(what.status()));
    dict.add("stage", string(what.stage));
    dict.add("message", what.message);
    const auto addKnown = [&](const word& key, const std::string& text)
    {
        if (text.size())
        {
            dict.add(key, string(text));
        }
    };
    addKnown("patch", what.patch);
    addKnown("entry", what.entry);
    addKnown("file", what.file);
    if (what.line > 0)
    {
        dict.add("line", what.line);
    }
    if (what.place.size())
    {
        dict.add("place", what.place[0]);
    }
    addKnown("remedy", what.remedy);

    return dict;
}

} // End namespace Foam

// ************************************************************************* //
