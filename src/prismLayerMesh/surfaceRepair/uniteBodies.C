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


//- Calls wire(item) for a surface without patches, and for the steps that made
//  it
template<class Wire, class Surface, class Steps>
static void visit(Wire& wire, Surface& surface, Steps& steps)
{
    wire(surface.points, surface.faces, surface.patchIDs);
    label n = steps.size();
    wire(n);
    steps.resize(n);
    for (auto& s : steps)
    {
        wire(s.what, s.count, s.places);
    }
}


//- Sends true and the places of two bodies before they are joined. At last sends
//  false and the surface
static void sendJoined
(
    wallSurface surface,
    const bool fluidOutside,
    const scalar step,
    pipeWriter& out
)
{
    const joinObserver tellPlaces = [&](const point& a, const point& b)
    {
        OStringStream places;
        places << a << " and " << b;
        out(true, string(places.str()));
        out.flush();
    };

    repairSteps made;
    joinBodies(surface, fluidOutside, step, tellPlaces, made);
    out(false);
    visit(out, surface, made);
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
static void sendUnion(wallSurface surface, const scalar step, pipeWriter& out)
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
    out(false);
    visit(out, surface, made);
}


//- Takes what sendJoined or sendUnion sends. If no surface comes, sets the places
//  of the last two bodies
static void readSurface
(
    pipeReader& in,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    bool isJoining = true;
    for (in(isJoining); isJoining; in(isJoining))
    {
        in(places);
    }

    wallSurface united(surface);
    repairSteps made;
    visit(in, united, made);
    surface = united;
    steps.append(made);
}


//- Runs what sends a surface in a process of its own. Returns whether the
//  surface came; sets the places of the last two bodies of which it was told.
static bool receiveSurface
(
    const std::function<void(pipeWriter&)>& sender,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    const processEnd end = isolatedProcess
    (
        sender,
        [&](pipeReader& in) { readSurface(in, places, surface, steps); }
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
    const auto sender = [&](pipeWriter& out) { sendUnion(surface, step, out); };

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
    const auto sender = [&](pipeWriter& out)
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
