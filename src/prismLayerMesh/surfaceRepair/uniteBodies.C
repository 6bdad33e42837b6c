/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stitchSurface.H"
#include "isolatedProcess.H"
#include "joinBodies.H"
#include "StringStream.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

static void send(const char tag, const OStringStream& text, std::FILE* out)
{
    const string message(text.str());
    const size_t length = message.size();
    std::fwrite(&tag, 1, 1, out);
    std::fwrite(&length, sizeof(length), 1, out);
    std::fwrite(message.data(), 1, length, out);
    std::fflush(out);
}


//- Returns false if nothing more is sent
static bool receive(std::FILE* in, char& tag, string& message)
{
    size_t length;

    if
    (
        std::fread(&tag, 1, 1, in) != 1
     || std::fread(&length, sizeof(length), 1, in) != 1
    )
    {
        return false;
    }
    message.resize(length);

    return std::fread(&message[0], 1, length, in) == length;
}


//- Sends 'p' and the places of two bodies before they are joined; at last 's',
//  the surface and the steps
static void sendUnited
(
    wallSurface surface,
    const bool fluidOutside,
    const scalar step,
    std::FILE* out
)
{
    const joinObserver tellPlaces = [&](const point& a, const point& b)
    {
        OStringStream places;
        places << a << " and " << b;
        send('p', places, out);
    };

    repairSteps made;
    joinBodies(surface, fluidOutside, step, tellPlaces, made);

    OStringStream result(IOstream::BINARY);
    result << surface.points << surface.faces << surface.patchIDs;
    result << made.size();
    for (const repairStep& s : made)
    {
        result << token::SPACE << s.what << s.count;
    }
    send('s', result, out);
}


//- Reads what sendUnited sends. Returns false if no surface comes. Places are
//  then the places of the last two bodies.
static bool readUnited
(
    std::FILE* in,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    char tag;
    string message;

    while (receive(in, tag, message))
    {
        if (tag == 'p')
        {
            places = message;
            continue;
        }

        IStringStream result(message, IOstream::BINARY);
        label nSteps;
        result >> surface.points >> surface.faces >> surface.patchIDs
            >> nSteps;

        for (label i = 0; i < nSteps; ++i)
        {
            string what;
            label count;
            result >> what >> count;
            addStep(steps, what, count);
        }

        return true;
    }

    return false;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void uniteBodies
(
    wallSurface& surface,
    const bool fluidOutside,
    const scalar step,
    repairSteps& steps
)
{
    string places;
    const processEnd end = isolatedProcess
    (
        [&](std::FILE* out) { sendUnited(surface, fluidOutside, step, out); },
        [&](std::FILE* in) { return readUnited(in, places, surface, steps); }
    );

    if (end != processEnd::complete)
    {
        FatalErrorInFunction
            << "The bodies of the surface cannot be united"
            << (
                   places.empty()
                 ? string(": one of them intersects itself")
                 : ": CGAL ended while it joined the bodies about " + places
               ).c_str() << nl
            << "Unite them in CAD, or go around them with surface.repair wrap"
            << exit(FatalError);
    }
}

} // End namespace Foam

// ************************************************************************* //
