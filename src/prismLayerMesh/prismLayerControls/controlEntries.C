/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlEntries.H"
#include "ListOps.H"
#include "label.H"
#include "scalar.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Number of letters to insert, delete or replace to turn a into b
static label editDistance(const std::string& a, const std::string& b)
{
    labelList row(identity(b.size() + 1));
    for (size_t i = 0; i < a.size(); ++i)
    {
        label diagonal = row[0]++;

        for (size_t j = 0; j < b.size(); ++j)
        {
            const label above = row[j + 1];
            row[j + 1] = min(diagonal + (a[i] != b[j]), 1 + min(above, row[j]));
            diagonal = above;
        }
    }

    return row[b.size()];
}


//- "; did you mean x?" if one of the valid words is near
static string suggestion(const std::string& given, const wordList& valid)
{
    label nearest = 1 + label(given.size())/3;
    string text;

    for (const word& candidate : valid)
    {
        const label distance = editDistance(given, candidate);

        if (distance <= nearest)
        {
            nearest = distance - 1;
            text = "; did you mean " + candidate + "?";
        }
    }

    return text;
}


//- "a, b, c"
static string joined(const wordList& words)
{
    string text;

    for (const word& w : words)
    {
        text += (text.empty() ? "" : ", ") + w;
    }

    return text;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

OSstream& entryError(const dictionary& dict, const word& key)
{
    label line = dict.startLineNumber();

    for (const entry& e : dict)
    {
        if (e.keyword() == key)
        {
            line = e.startLineNumber();
        }
    }

    return FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, dict.name(), line);
}


void missingEntry(const dictionary& dict, const word& key)
{
    entryError(dict, key)
        << "The entry " << key << " of " << dict.dictName() << " is missing"
        << exit(FatalIOError);

    std::abort();
}


void checkKeys(const dictionary& dict, const wordList& validKeys)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();

        if (key != "FoamFile" && (key.isPattern() || !validKeys.found(key)))
        {
            entryError(dict, key)
                << "Unknown key " << key << " in " << dict.dictName()
                << suggestion(key, validKeys).c_str() << nl
                << "Valid keys: " << joined(validKeys).c_str()
                << exit(FatalIOError);
        }
    }
}


const dictionary& optionalDict(const dictionary& dict, const word& key)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        return dictionary::null;
    }

    if (!dict.isDict(key, keyType::LITERAL))
    {
        entryError(dict, key)
            << "The entry " << key << " of " << dict.dictName()
            << " must be a dictionary" << exit(FatalIOError);
    }

    return dict.subDict(key, keyType::LITERAL);
}


const dictionary& mandatoryDict(const dictionary& dict, const word& key)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        entryError(dict, key)
            << "The dictionary " << key << " of " << dict.dictName()
            << " is missing" << nl << "Write: " << key << " { ... }"
            << exit(FatalIOError);
    }

    return optionalDict(dict, key);
}


template<class Type>
bool readBounded
(
    const dictionary& dict,
    const word& key,
    const typename std::common_type<Type>::type& min,
    const typename std::common_type<Type>::type& max,
    Type& value
)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        return false;
    }

    const Type read = dict.get<Type>(key, keyType::LITERAL);

    // Written so that a value that is not a number fails
    if (!(read >= min && read <= max))
    {
        entryError(dict, key)
            << "Value of " << key << " is " << read
            << "; it must be from " << min << " to " << max
            << exit(FatalIOError);
    }

    value = read;

    return true;
}


scalar readMandatory
(
    const dictionary& dict,
    const word& key,
    const scalar min,
    const scalar max
)
{
    scalar value = 0;

    if (!readBounded(dict, key, min, max, value))
    {
        missingEntry(dict, key);
    }

    return value;
}


bool readChoice
(
    const dictionary& dict,
    const word& key,
    const wordList& choices,
    word& value
)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        return false;
    }

    const word read(dict.get<word>(key, keyType::LITERAL));

    if (!choices.found(read))
    {
        entryError(dict, key)
            << "Value of " << key << " is " << read << ", which is not"
            << " available" << suggestion(read, choices).c_str() << nl
            << "Valid values: " << joined(choices).c_str()
            << exit(FatalIOError);
    }

    value = read;

    return true;
}


template bool readBounded
(
    const dictionary&, const word&,
    const scalar&, const scalar&, scalar&
);

template bool readBounded
(
    const dictionary&, const word&,
    const label&, const label&, label&
);

} // End namespace Foam

// ************************************************************************* //
