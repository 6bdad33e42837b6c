/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "controlEntries.H"
#include "ListOps.H"
#include "label.H"
#include "scalar.H"
#include "Switch.H"

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


//- A number as in a dictionary, 2e8 in place of 2e+08
static string shortest(const scalar value)
{
    string text(name(value));
    text.replaceAll("e-0", "e-");
    text.replaceAll("e+0", "e");
    text.replaceAll("e+", "e");

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


// * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * * //

void controlEntries::read
(
    const dictionary& dict,
    const declaration& declare
)
{
    controlEntries keys(nullptr, nullptr, "");
    declare(keys);
    checkKeys(dict, wordList(std::move(keys.keys_)));

    controlEntries entries(&dict, nullptr, "");
    declare(entries);
}


List<entryText> controlEntries::list(const declaration& declare)
{
    DynamicList<entryText> texts;
    controlEntries entries(nullptr, &texts, "");
    declare(entries);

    return List<entryText>(std::move(texts));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool controlEntries::has
(
    const word& key,
    const string& text,
    const string& range,
    const string& standard
)
{
    keys_.append(key);
    if (texts_)
    {
        texts_->append(entryText{scope_ + key, standard, range, text});
    }

    return dict_ && dict_->found(key, keyType::LITERAL);
}


template<class Number>
bool controlEntries::readBounded
(
    const word& key,
    Number& value,
    const scalar min,
    const scalar max,
    const string& text,
    const string& standard
)
{
    const bool isPositive = min <= SMALL && max >= GREAT;
    const bool isThere = has
    (
        key,
        text,
        isPositive ? "> 0" : '[' + shortest(min) + ", " + shortest(max) + ']',
        standard.empty() && value ? shortest(value) : standard
    );
    if (!isThere)
    {
        return false;
    }

    const Number read = dict_->get<Number>(key, keyType::LITERAL);

    // Written so that a value that is not a number fails
    if (!(read >= min && read <= max))
    {
        entryError(*dict_, key)
            << "Value of " << key << " is " << read
            << "; it must be from " << min << " to " << max
            << exit(FatalIOError);
    }
    value = read;

    return true;
}


template bool controlEntries::readBounded
(
    const word&, scalar&, scalar, scalar, const string&, const string&
);

template bool controlEntries::readBounded
(
    const word&, label&, scalar, scalar, const string&, const string&
);


bool controlEntries::readChoice
(
    const word& key,
    word& value,
    const wordList& choices,
    const string& text
)
{
    word read(value);
    const bool isThere = this->read(key, read, text, joined(choices), value);
    if (isThere && !choices.found(read))
    {
        entryError(*dict_, key)
            << "Value of " << key << " is " << read << ", which is not"
            << " available" << suggestion(read, choices).c_str() << nl
            << "Valid values: " << joined(choices).c_str()
            << exit(FatalIOError);
    }
    value = read;

    return isThere;
}


bool controlEntries::readFlag
(
    const word& key,
    bool& value,
    const string& text
)
{
    Switch read(value);
    const bool isThere =
        this->read(key, read, text, "yes, no", value ? "yes" : "no");
    value = read;

    return isThere;
}


bool controlEntries::readDict
(
    const word& key,
    const string& text,
    const declaration& declare
)
{
    const bool isThere = has(key, text, "dictionary");
    if (texts_)
    {
        controlEntries entries(nullptr, texts_, scope_ + key + '.');
        declare(entries);
    }
    if (isThere)
    {
        read(optionalDict(*dict_, key), declare);
    }

    return isThere;
}

} // End namespace Foam

// ************************************************************************* //
