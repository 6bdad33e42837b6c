/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stitchSurface.H"
#include "cutSurface.H"
#include "isolatedProcess.H"
#include "exactUnion.H"
#include "fillContacts.H"
#include "joinBodies.H"
#include "removeSlivers.H"
#include "StringStream.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Bodies are united so many times more at most
static constexpr label maxUnions = 10;


static void send(const char tag, const OStringStream& text, std::FILE* out)
{
    writeItems(tag + text.str(), out);
    std::fflush(out);
}


//- Sends 's', a surface and the steps that made it
static void sendSurface
(
    const wallSurface& surface,
    const repairSteps& made,
    std::FILE* out
)
{
    OStringStream result(IOstream::BINARY);
    result << surface.points << surface.faces << surface.patchIDs;
    result << made.size();
    for (const repairStep& s : made)
    {
        result << token::SPACE << s.what << s.count << s.places;
    }
    send('s', result, out);
}


//- Sends 'p' and the places of two bodies before they are joined; at last the
//  surface
static void sendJoined
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
    sendSurface(surface, made, out);
}


//- Adds the places of contacts to the steps
static void addContacts
(
    const surfaceContacts& contacts,
    const pointField& points,
    repairSteps& steps
)
{
    DynamicList<point> places;
    for (const label p : contacts.points)
    {
        places.append(points[p]);
    }
    for (const edge& e : contacts.edges)
    {
        places.append(e.centre(points));
    }
    addStep(steps, "contacts of bodies filled", places.size(), places);
}


//- Sends the exact union, without contacts
static void sendUnion(wallSurface surface, const scalar step, std::FILE* out)
{
    repairSteps made;
    uniteExactly(surface, made);

    // A filler may touch other bodies, and rounded faces may intersect or lose
    // their area
    for (label n = 0; n < maxUnions; ++n)
    {
        const surfaceContacts contacts(findContacts(surface));
        repairSteps untold;

        if (!contacts.empty())
        {
            addContacts(contacts, surface.points, made);
            addContactFillers(contacts, surface);
            mergeEqualPoints(surface, untold);
        }
        else if (facesInConflict(surface).empty())
        {
            break;
        }
        uniteExactly(surface, untold);
    }

    // Without low triangles first: some have no area in floating point, and
    // would leave a hole
    addStep
    (
        made, "needles and low triangles removed", removeSlivers(step, surface)
    );
    stitchFaces(surface, made);
    sendSurface(surface, made, out);
}


//- Reads what sendJoined or sendUnion sends. Returns false if no surface comes;
//  the places are those of the last two bodies then.
static bool readSurface
(
    std::FILE* in,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    std::string message;
    while (readItems(in, message))
    {
        const std::string text(message, 1);
        if (message[0] == 'p')
        {
            places = text;
            continue;
        }

        IStringStream result(text, IOstream::BINARY);
        label nSteps;
        result >> surface.points >> surface.faces >> surface.patchIDs
            >> nSteps;

        for (label i = 0; i < nSteps; ++i)
        {
            string what;
            label count;
            DynamicList<point> at;
            result >> what >> count >> at;
            addStep(steps, what, count, at);
        }

        return true;
    }

    return false;
}


//- Runs what sends a surface in a process of its own. Returns whether the
//  surface came; sets the places of the last two bodies of which it was told.
static bool receiveSurface
(
    const std::function<void(std::FILE*)>& sender,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    const processEnd end = isolatedProcess
    (
        sender,
        [&](std::FILE* in) { return readSurface(in, places, surface, steps); }
    );

    return end == processEnd::complete;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

string uniteBalanced
(
    wallSurface& surface,
    const scalar step,
    repairSteps& steps
)
{
    string places;
    const auto sender = [&](std::FILE* out) { sendUnion(surface, step, out); };

    return
        receiveSurface(sender, places, surface, steps)
      ? string()
      : string("CGAL ended while it divided the faces");
}


string uniteBodies
(
    wallSurface& surface,
    const bool fluidOutside,
    const scalar step,
    repairSteps& steps
)
{
    string places;
    const auto sender = [&](std::FILE* out)
    {
        sendJoined(surface, fluidOutside, step, out);
    };

    if (receiveSurface(sender, places, surface, steps))
    {
        return string();
    }

    return
        places.empty()
      ? string("one of them intersects itself")
      : string("CGAL ended while it joined the bodies about " + places);
}

} // End namespace Foam

// ************************************************************************* //
