/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldNames.H"
#include "dictionaryEntry.H"
#include "IFstream.H"
#include "IOobject.H"
#include "ListOps.H"
#include "OSspecific.H"
#include "polyPatch.H"
#include "PtrList.H"
#include "throwingErrors.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Reads the header of a file, and sets the format of the stream that it names.
//  Returns whether there is a header.
static bool readHeader(Istream& is)
{
    token first(is);
    if (!first.isWord() || first.wordToken() != "FoamFile")
    {
        return false;
    }
    const dictionary header(is);
    is.format(header.lookupOrDefault<word>("format", "ascii"));

    return true;
}


//- Types of constraints, which cases set for whatever patches come, and
//  patterns of the patches that a decomposed mesh has
static bool isForAnyMesh(const keyType& key)
{
    return
        polyPatch::constraintType(key) || key == "overset"
     || key.match("procBoundary0to1") || key.match("procBoundary1to0");
}


static string listOf(const wordList& names)
{
    string text;
    for (const word& name : names)
    {
        text += ' ' + name;
    }

    return text;
}


//- What the log says of a comparison
static string textOf(const fieldNames& names)
{
    string text;
    if (names.failure.size())
    {
        text += " cannot be read: " + names.failure;
    }
    if (names.patchesWithoutEntry.size())
    {
        text += " no entry for the patches" + listOf(names.patchesWithoutEntry);
    }
    if (names.entriesWithoutPatch.size())
    {
        text +=
            (text.empty() ? "" : ";") + string(" no patch for the entries")
          + listOf(names.entriesWithoutPatch);
    }

    return text;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

List<namedPatch> readPatches(const fileName& boundary)
{
    IFstream is(boundary);
    readHeader(is);
    const PtrList<entry> entries(is);
    DynamicList<namedPatch> patches;
    for (const entry& e : entries)
    {
        namedPatch patch;
        patch.name = e.keyword();
        patch.type = e.dict().get<word>("type");
        e.dict().readIfPresent("inGroups", patch.groups);
        if (patch.type == "wall" || polyPatch::constraintType(patch.type))
        {
            patch.groups.append(patch.type);
        }
        if (!patch.type.startsWith("processor"))
        {
            patches.append(patch);
        }
    }

    return List<namedPatch>(std::move(patches));
}


fieldNames compareNames
(
    const UList<namedPatch>& patches,
    const dictionary& boundaryField
)
{
    const auto isFor = [](const keyType& key, const namedPatch& patch)
    {
        return key.match(patch.name)
            || (!key.isPattern() && patch.groups.found(key));
    };

    fieldNames names;
    for (const namedPatch& patch : patches)
    {
        bool isFound = patch.type == "empty";
        for (const entry& e : boundaryField)
        {
            isFound = isFound || (e.isDict() && isFor(e.keyword(), patch));
        }
        if (!isFound)
        {
            names.patchesWithoutEntry.append(patch.name);
        }
    }
    for (const entry& e : boundaryField)
    {
        const keyType& key = e.keyword();
        bool isFound = !e.isDict() || isForAnyMesh(key);
        for (const namedPatch& patch : patches)
        {
            isFound = isFound || isFor(key, patch);
        }
        if (!isFound)
        {
            names.entriesWithoutPatch.append(key);
        }
    }

    return names;
}


List<fieldNames> compareFields
(
    const UList<namedPatch>& patches,
    const fileName& folder
)
{
    const throwingErrors throwing(true);
    DynamicList<fieldNames> all;
    fileNameList files(readDir(folder, fileName::FILE));
    sort(files);
    for (const fileName& file : files)
    {
        fieldNames names;
        try
        {
            IFstream is(folder/file);
            const dictionary dict
            (
                readHeader(is) ? dictionary(is) : dictionary()
            );
            if (!dict.isDict("boundaryField"))
            {
                continue;
            }
            names = compareNames(patches, dict.subDict("boundaryField"));
        }
        catch (const Foam::error& failure)
        {
            names.failure = failure.message();
        }
        names.field = file;
        all.append(names);
    }

    return List<fieldNames>(std::move(all));
}


dictionary toDictionary(const UList<fieldNames>& fields)
{
    dictionary dict;
    for (const fieldNames& names : fields)
    {
        dictionary entries;
        entries.add("patchesWithoutEntry", names.patchesWithoutEntry);
        entries.add("entriesWithoutPatch", names.entriesWithoutPatch);
        if (names.failure.size())
        {
            entries.add("unreadable", names.failure);
        }
        dict.add(word(names.field), entries);
    }

    return dict;
}


void write(Ostream& os, const UList<fieldNames>& fields)
{
    DynamicList<string> texts;
    DynamicList<string> fieldsOfText;
    for (const fieldNames& names : fields)
    {
        const string text(textOf(names));
        const label i = texts.find(text);
        if (text.size() && i < 0)
        {
            texts.append(text);
            fieldsOfText.append(names.field);
        }
        else if (text.size())
        {
            fieldsOfText[i] += ' ' + names.field;
        }
    }
    forAll(texts, i)
    {
        os  << "WARNING: fields " << fieldsOfText[i].c_str() << ':'
            << texts[i].c_str() << nl;
    }
}

} // End namespace Foam

// ************************************************************************* //
