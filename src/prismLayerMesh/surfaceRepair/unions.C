/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unions.H"
#include "bitSet.H"
#include "cellPredicates.H"
#include "cutSurface.H"
#include "isolatedProcess.H"
#include "ListOps.H"
#include "ranges.H"
#include "readWallSurface.H"
#include "stageProgress.H"
#include "stitchSurface.H"
#include "StringStream.H"
#include "surfacePart.H"
#include "triangleIndex.H"
#include "wallSides.H"

namespace Foam
{

//- Points are one if they are nearer than this share of the diagonal of the
//  bounding box
static constexpr scalar rounding = 1e-12;


namespace
{

//- Faces but for faces with a point twice, and for pairs of faces on the same
//  points that are oriented otherwise
faceList withoutCollapsed(const faceList& faces)
{
    bitSet isKept(faces.size());
    triangleIndex single(2*faces.size());

    forAll(faces, i)
    {
        const face& f = faces[i];
        if (hasRepeatedPoint(f))
        {
            continue;
        }

        isKept.set(i);
        const triFace key(f);
        const label j = single.lookup(key, -1);
        if (j < 0)
        {
            single.insert(key, i);
        }
        else if (face::compare(faces[j], f) < 0)
        {
            isKept.unset(i);
            isKept.unset(j);
            single.erase(key);
        }
    }

    return subset(isKept, faces);
}


//- Makes points whose distance is rounding one; faces lose their patches
void mergeRounded(wallSurface& surface)
{
    wallReading untold;
    surface.patchIDs = labelList(surface.faces.size(), 0);
    mergeNearPoints(surface, rounding, untold);
}


//- The triangles of a surface but for triangles whose area is zero, exactly
faceList trianglesWithArea(const wallSurface& surface)
{
    labelList faceOf;
    const faceList triangles(wallTriangles(surface, faceOf));

    return subsetList(triangles, [&](const face& f)
    {
        const pointField& x = surface.points;

        return !isCollinear(x[f[0]], x[f[1]], x[f[2]]);
    });
}


//- Marks faces of components, connected by edges, that have no positive volume:
//  their normals point into them. Returns the number of such components.
label findInward(const wallSurface& surface, bitSet& isInward)
{
    const faceList& faces = surface.faces;
    const pointField& points = surface.points;
    labelList componentOf;
    const label nComponents = findComponents
    (
        makeWallSides(faces, points.size()), faces.size(), componentOf
    );

    scalarList volumes(nComponents, Zero);
    labelList firsts(nComponents, -1);
    forAll(faces, i)
    {
        const face& f = faces[i];
        label& first = firsts[componentOf[i]];
        first = first < 0 ? f[0] : first;
        const point& a = points[f[0]];
        volumes[componentOf[i]] +=
            (a - points[first]) & ((points[f[1]] - a) ^ (points[f[2]] - a));
    }

    isInward.resize(faces.size());
    forAll(faces, i)
    {
        isInward.set(i, volumes[componentOf[i]] <= 0);
    }

    return countOf(volumes, [](const scalar v) { return v <= 0; });
}


//- Turns components that have no positive volume
void turnOutwards(wallSurface& surface)
{
    bitSet isInward;
    findInward(surface, isInward);
    for (const label i : isInward)
    {
        surface.faces[i].flip();
    }
}


//- Removes components that have no positive volume: the boundaries of voids.
//  Returns their number.
label fillVoids(wallSurface& surface)
{
    bitSet isInward;
    const label nVoids = findInward(surface, isInward);
    surface.faces = subset(isInward, surface.faces, true);

    return nVoids;
}

} // End anonymous namespace


bool isBalanced(const wallSurface& surface)
{
    const wallSides sides(makeWallSides(surface));

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        label balance = 0;
        for (const wallSide& s : sides.on(e))
        {
            balance += s.up ? 1 : -1;
        }
        if (balance)
        {
            return false;
        }
    }

    return true;
}


void uniteExactly(wallSurface& surface, repairSteps& steps)
{
    mergeRounded(surface);
    surface.faces = trianglesWithArea(surface);
    turnOutwards(surface);

    unionBoundary boundary(findUnionBoundary(surface));
    addStep(steps, "faces divided where bodies meet", boundary.nDivided);
    addStep(steps, "faces removed inside of other bodies", boundary.nInside);

    surface.points = boundary.points;
    surface.faces = boundary.faces;
    mergeRounded(surface);
    surface.faces = withoutCollapsed(surface.faces);
    addStep(steps, "voids between bodies filled", fillVoids(surface));
    removeUnusedPoints(surface.faces, surface.points);
}


// * * * * * * * * * * * * * * *  Unite Bodies * * * * * * * * * * * * * * * //

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


//- Sends true and the places of two bodies before they are joined. At last
//  sends false and the surface
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


//- Takes what sendJoined or sendUnion sends. If no surface comes, sets the
//  places of the last two bodies
static void readSurface
(
    pipeReader& in,
    string& places,
    wallSurface& surface,
    repairSteps& steps
)
{
    label n = 0;
    bool isJoining = true;
    for (in(isJoining); isJoining; in(isJoining))
    {
        in(places);
        tellProgress("joining bodies, step", ++n);
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
