/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wrapLeaks.H"
#include "boundBox.H"
#include "disjointSets.H"
#include "Map.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- A point is on a side of a face if the sine of its elevation is larger: not
//  beside an edge of the face
static constexpr scalar leastElevation = 0.5;

static constexpr label nPlaces = 10;


static void addFaces
(
    const wallSurface& surface,
    const bitSet& faces,
    repairSteps& steps
)
{
    DynamicList<point> places;
    scalar area = 0;
    scalar all = 0;

    forAll(surface.faces, facei)
    {
        const face& f = surface.faces[facei];
        all += f.mag(surface.points);

        if (faces.test(facei))
        {
            area += f.mag(surface.points);

            if (places.size() < nPlaces)
            {
                places.append(f.centre(surface.points));
            }
        }
    }

    OStringStream what;
    what.precision(3);
    what << "faces with the wrap on both sides, " << 100*area/all
        << " % of the area:";
    addStep(steps, what.str(), faces.count(), places);
}


static void addOpenings
(
    const wallSurface& surface,
    const scalar size,
    repairSteps& steps
)
{
    const edgeList open(outline(surface.faces));
    disjointSets loops(connectedPoints(surface.points.size(), open));

    Map<boundBox> boxes;
    for (const edge& e : open)
    {
        boundBox& box = boxes(loops.find(e.start()), boundBox());
        box.add(surface.points[e.start()]);
        box.add(surface.points[e.end()]);
    }

    DynamicList<point> places;
    label count = 0;
    for (const label root : boxes.sortedToc())
    {
        if (boxes[root].mag() > size)
        {
            ++count;
            if (places.size() < nPlaces)
            {
                places.append(boxes[root].centre());
            }
        }
    }
    addStep(steps, "openings wider than the size", count, places);
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

bitSet facesInside
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const wallSurface& wrap
)
{
    const vectorField normals(surface.faceNormals());
    pointField feet;
    labelList faces;
    nearest.find(wrap.points, feet, faces);
    bitSet front(surface.faces.size());
    bitSet back(surface.faces.size());

    forAll(feet, p)
    {
        const vector out(wrap.points[p] - feet[p]);
        const scalar height = out & normals[faces[p]];

        if (mag(height) > leastElevation*mag(out))
        {
            (height > 0 ? front : back).set(faces[p]);
        }
    }

    return front &= back;
}


void addLeaks
(
    const wallSurface& surface,
    const bitSet& inside,
    const scalar size,
    repairSteps& steps
)
{
    addFaces(surface, inside, steps);

    if (inside.any())
    {
        addOpenings(surface, size, steps);
    }
}

} // End namespace Foam

// ************************************************************************* //
