/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "writeJson.H"
#include "ITstream.H"
#include "OStringStream.H"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static std::string quoted(const std::string& text)
{
    std::ostringstream os;
    os  << '"';
    for (const char c : text)
    {
        const unsigned char code = c;
        if (c == '"' || c == '\\')
        {
            os  << '\\' << c;
        }
        else if (c == '\n')
        {
            os  << "\\n";
        }
        else if (code < 0x20)
        {
            os  << "\\u" << std::hex << std::setfill('0') << std::setw(4)
                << int(code) << std::dec;
        }
        else
        {
            os  << c;
        }
    }
    os  << '"';

    return os.str();
}


static std::string numberOf(const scalar value)
{
    std::ostringstream os;
    os.precision(IOstream::defaultPrecision());
    os  << value;

    return std::isfinite(value) ? os.str() : "null";
}


//- The tokens of an entry; a list that is one token is its own tokens
static tokenList tokensOf(const entry& e)
{
    bool hasLists = false;
    const ITstream& tokens = e.stream();
    for (const token& t : tokens)
    {
        hasLists = hasLists || t.isCompound();
    }
    if (!hasLists)
    {
        return tokens;
    }

    OStringStream os;
    for (const token& t : tokens)
    {
        if (t.isCompound())
        {
            t.compoundToken().write(os);
        }
        else
        {
            os  << t;
        }
        os  << token::SPACE;
    }

    return ITstream(e.keyword(), os.str());
}


static std::string valueOf(const token& t)
{
    const std::string word
    (
        t.isWord() ? t.wordToken() : t.isString() ? t.stringToken() : string()
    );

    return
        t.isLabel() ? std::to_string(t.labelToken())
      : t.isScalar() ? numberOf(t.scalarToken())
      : t.isWord() && (word == "true" || word == "false") ? word
      : quoted(word);
}


static bool isMark(const token& t, const char mark)
{
    return t.isPunctuation() && char(t.pToken()) == mark;
}


static std::string joined(const List<std::string>& values)
{
    std::string text;
    for (const std::string& value : values)
    {
        text += (text.empty() ? "" : ", ") + value;
    }

    return '[' + text + ']';
}


//- Returns the values from token i on, up to a closing mark or the end. i is
//  then behind the mark.
static List<std::string> readValues(const tokenList& tokens, label& i)
{
    List<std::string> values;
    while (i < tokens.size())
    {
        const token& t = tokens[i++];
        const bool isSize =
            t.isLabel() && i < tokens.size()
         && (isMark(tokens[i], '(') || isMark(tokens[i], '{'));
        if (isMark(t, ')') || isMark(t, '}'))
        {
            break;
        }
        if (isSize && isMark(tokens[i], '{'))
        {
            // n{value}
            const List<std::string> one(readValues(tokens, ++i));
            values.append
            (
                joined(List<std::string>(t.labelToken(), one[0]))
            );
        }
        else if (isMark(t, '('))
        {
            values.append(joined(readValues(tokens, i)));
        }
        else if (!isSize && !t.isPunctuation())
        {
            values.append(valueOf(t));
        }
    }

    return values;
}


static std::string jsonOf(const dictionary& dict, const std::string& indent)
{
    std::string text;
    const std::string inner(indent + "    ");
    for (const entry& e : dict)
    {
        text += (text.empty() ? "\n" : ",\n") + inner + quoted(e.keyword());
        text += ": ";
        if (e.isDict())
        {
            text += jsonOf(e.dict(), inner);
            continue;
        }
        label i = 0;
        const List<std::string> values(readValues(tokensOf(e), i));
        text +=
            values.empty() ? "null"
          : values.size() == 1 ? values[0] : joined(values);
    }

    return text.empty() ? "{}" : '{' + text + '\n' + indent + '}';
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string jsonOf(const dictionary& dict)
{
    return jsonOf(dict, "") + '\n';
}

} // End namespace Foam

// ************************************************************************* //
