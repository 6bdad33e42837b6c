/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cutSurface.H"
#include "boundBox.H"
#include "disjointSets.H"
#include "EdgeMap.H"
#include "ranges.H"
#include "splitAtSidePatches.H"
#include "surfacePart.H"
#include "unions.H"
#include "wallPredicates.H"
#include "wallVisibility.H"
#include "waysOnSurface.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Points nearer to the plane than this share of their mean edge are put on it
static constexpr scalar nearShare = 0.25;

//- Points closer than onShare*nearShare of their mean edge count as on the
//  plane: their edges would all be cut at one place
static constexpr scalar onShare = 1e-3;


namespace
{

struct planeCutter
{
    const sidePatch& plane;
    const scalarField& distances;
    wallSurface& surface;

    //- Labels of the points of edges on the plane, after those of the surface
    EdgeMap<label> cuts{};
    DynamicList<point> cutPoints{};

    //- The point of an edge that is on the plane
    label cut(const edge& e)
    {
        if (!cuts.found(e))
        {
            const label a = min(e.start(), e.end());
            const label b = max(e.start(), e.end());
            const scalar t = distances[a]/(distances[a] - distances[b]);
            const pointField& points = surface.points;
            const point x((1 - t)*points[a] + t*points[b]);

            cuts.insert(e, points.size() + cutPoints.size());
            cutPoints.append(x - plane.distance(x)*plane.normal);
        }

        return cuts[e];
    }

    //- The part of a face that is not beyond the plane
    face part(const face& f)
    {
        face left;

        forAll(f, k)
        {
            const scalar d = distances[f[k]];
            const edge e(f.faceEdge(k));

            if (d <= 0)
            {
                left.append(f[k]);
            }
            if (d*distances[e.end()] < 0)
            {
                left.append(cut(e));
            }
        }

        return left;
    }

    //- Cuts the faces. Points keep their labels.
    void cutFaces()
    {
        DynamicList<face> faces(surface.faces.size());
        DynamicList<label> patchIDs(faces.size());
        const auto add = [&](const face& f, const label facei)
        {
            faces.append(f);
            patchIDs.append(surface.patchIDs[facei]);
        };

        forAll(surface.faces, facei)
        {
            const face& f = surface.faces[facei];
            const bool isInFront =
                anyOf(f, [&](const label p) { return distances[p] < 0; });

            // Faces on the plane are beyond it
            const face left(isInFront ? part(f) : face());

            if (left.size() > 4)
            {
                for (label k = 1; k + 1 < left.size(); ++k)
                {
                    add(face({left[0], left[k], left[k + 1]}), facei);
                }
            }
            else if (left.size())
            {
                add(left, facei);
            }
        }

        surface.points.append(cutPoints);
        surface.faces.transfer(faces);
        surface.patchIDs.transfer(patchIDs);
    }
};

} // End anonymous namespace


//- Returns the points of connected parts in front of a plane of which all
//  points are to be put on it
static bitSet pointsOfLostParts
(
    const wallSurface& surface,
    const scalarField& distances,
    const bitSet& onPlane
)
{
    disjointSets parts(distances.size());
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            if (distances[e.start()] < 0 && distances[e.end()] < 0)
            {
                parts.join(e.start(), e.end());
            }
        }
    }

    bitSet isKept(distances.size());
    forAll(distances, p)
    {
        if (distances[p] < 0 && !onPlane.test(p))
        {
            isKept.set(parts.find(p));
        }
    }

    bitSet lost(distances.size());
    forAll(distances, p)
    {
        lost.set(p, distances[p] < 0 && !isKept.test(parts.find(p)));
    }

    return lost;
}


//- Returns for each point the distance [m] from a plane below which it is near
//  to the plane
static scalarField nearDistances(const wallSurface& surface)
{
    scalarField near(surface.points.size(), Zero);
    labelList n(near.size(), Zero);
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            const scalar length = e.mag(surface.points);
            for (const label p : {e.start(), e.end()})
            {
                near[p] += length;
                ++n[p];
            }
        }
    }
    forAll(near, p)
    {
        near[p] *= nearShare/max(n[p], label(1));
    }

    return near;
}


//- Returns the points near to the plane that have a neighbour further in front
//  and one further beyond, and points that are almost on it. Of two sides of a
//  surface the same points are near, whichever of them is in front.
static bitSet nearTheCutOfBoth
(
    const wallSurface& surface,
    const scalarField& distances,
    const scalarField& near
)
{
    bitSet hasFront(distances.size()), hasBack(distances.size());
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            for (const label p : {e.start(), e.end()})
            {
                const label q = e.otherVertex(p);
                if (distances[q] <= -near[q])
                {
                    hasFront.set(p);
                }
                if (distances[q] >= near[q])
                {
                    hasBack.set(p);
                }
            }
        }
    }

    bitSet points(distances.size());
    forAll(near, p)
    {
        const scalar d = mag(distances[p]);
        points.set
        (
            p,
            d < onShare*near[p]
         || (d < near[p] && hasFront.test(p) && hasBack.test(p))
        );
    }

    return points;
}


//- Returns the points near to the plane with a neighbour that is further
//  beyond, and points that are almost on it. Of a part in front of the plane
//  that would be flat there are those that are almost on it alone.
static bitSet nearTheCut
(
    const wallSurface& surface,
    const scalarField& distances,
    const scalarField& near
)
{
    bitSet almostOn(distances.size());
    forAll(near, p)
    {
        almostOn.set(p, mag(distances[p]) < onShare*near[p]);
    }

    bitSet points(almostOn);
    for (const face& f : surface.faces)
    {
        for (const edge& e : f.edges())
        {
            for (const label p : {e.start(), e.end()})
            {
                const label q = e.otherVertex(p);

                if (mag(distances[p]) < near[p] && distances[q] >= near[q])
                {
                    points.set(p);
                }
            }
        }
    }
    for (const label p : pointsOfLostParts(surface, distances, points))
    {
        points.set(p, almostOn.test(p));
    }

    return points;
}


//- Returns the surface in front of a plane.
//  onPlane: points that are put on the plane
static wallSurface cutAt
(
    const sidePatch& plane,
    const scalarField& distances,
    const bitSet& onPlane,
    wallSurface surface
)
{
    scalarField cutDistances(distances);
    for (const label p : onPlane)
    {
        cutDistances[p] = 0;
    }
    planeCutter{plane, cutDistances, surface}.cutFaces();

    return surface;
}


//- Returns the points of a surface where faces touch that have no edge in
//  common there once the surface is cut
static DynamicList<label> pinchedPoints
(
    const sidePatch& plane,
    const scalarField& distances,
    const bitSet& onPlane,
    const wallSurface& surface
)
{
    return findContacts(cutAt(plane, distances, onPlane, surface)).points;
}


//- Returns the points on a plane at which a surface will not end once it is
//  cut: it would touch the plane there
static labelList touchingPoints
(
    const sidePatch& plane,
    const scalarField& distances,
    const bitSet& onPlane,
    const wallSurface& surface
)
{
    const wallSurface cut(cutAt(plane, distances, onPlane, surface));
    bitSet touching(cut.points.size());
    for (const face& f : cut.faces)
    {
        touching.set(f);
    }
    touching.resize(onPlane.size());
    touching &= onPlane;
    touching -= borderPoints(cut);

    return touching.sortedToc();
}


//- A column on a point in a cyclic plane stands in it. The point goes back if a
//  direction in the plane makes angles with the faces around it whose least
//  sine is smaller.
static constexpr scalar leastVisible = 0.1;


//- Returns the points in a plane from which no direction in the plane sees all
//  faces on both sides well
static bitSet blindPoints
(
    const sidePatch& plane,
    const bitSet& onPlane,
    const wallSurface& surface
)
{
    const vectorField faceNormals(surface.faceNormals());
    Map<DynamicList<vector>> normals;
    forAll(surface.faces, facei)
    {
        for (const label p : surface.faces[facei])
        {
            if (onPlane.test(p))
            {
                normals(p).append(faceNormals[facei]);
                normals(p).append(plane.reflected(faceNormals[facei]));
            }
        }
    }

    bitSet blind(onPlane.size());
    forAllConstIters(normals, iter)
    {
        blind.set
        (
            iter.key(), makeVisibilityCone(iter.val()).cosine < leastVisible
        );
    }

    return blind;
}


//- Returns the ends of edges in a plane both of whose faces are on one side of
//  it: the surface would touch the plane there, and not go through it
static bitSet pointsOfTouchingEdges
(
    const wallSurface& surface,
    const scalarField& distances,
    const bitSet& onPlane
)
{
    // For each edge: whether a face is in front of the plane, and whether a
    // face is beyond the plane
    EdgeMap<Pair<bool>> sides;
    for (const face& f : surface.faces)
    {
        bool isInFront = false, isBeyond = false;
        for (const label p : f)
        {
            isInFront = isInFront || (!onPlane.test(p) && distances[p] < 0);
            isBeyond = isBeyond || (!onPlane.test(p) && distances[p] > 0);
        }
        for (const edge& e : f.edges())
        {
            if (onPlane.test(e.start()) && onPlane.test(e.end()))
            {
                Pair<bool>& both = sides(e, Pair<bool>(false, false));
                both.first() = both.first() || isInFront;
                both.second() = both.second() || isBeyond;
            }
        }
    }

    bitSet points(onPlane.size());
    forAllConstIters(sides, iter)
    {
        if (iter.val().first() != iter.val().second())
        {
            points.set(iter.key().start());
            points.set(iter.key().end());
        }
    }

    return points;
}


//- Moves points that were put on a cyclic plane back to where they were, until
//  on both sides no faces are in conflict, none are in the plane, and columns
//  can stand in the plane
static void takeBackConflictsOfBoth
(
    const sidePatch& plane,
    const pointField& from,
    const scalarField& distances,
    wallSurface& surface,
    bitSet& onPlane
)
{
    const scalarField reversed(-distances);
    for (bool more = true; more;)
    {
        bitSet back(blindPoints(plane, onPlane, surface));
        back |= pointsOfTouchingEdges(surface, distances, onPlane);
        for (const label facei : facesInConflict(surface))
        {
            back.set(surface.faces[facei]);
        }
        for (const face& f : surface.faces)
        {
            if (allOf(f, [&](const label p) { return onPlane.test(p); }))
            {
                back.set(f);
            }
        }
        for (const scalarField* side : {&distances, &reversed})
        {
            for (const label p : pinchedPoints(plane, *side, onPlane, surface))
            {
                if (p < onPlane.size())
                {
                    back.set(p);
                }
            }
        }

        back &= onPlane;
        more = back.any();
        for (const label p : back)
        {
            onPlane.unset(p);
            surface.points[p] = from[p];
        }
    }
}


//- Moves points that were put on a plane back to where they were, until no
//  faces are in conflict. Faces that will be cut off may be. A point on the
//  plane in which alone faces would touch is moved beyond the plane, by as much
//  as is near, so that no short edges are left between the faces.
static void takeBackConflicts
(
    const sidePatch& plane,
    const scalarField& near,
    const pointField& from,
    scalarField& distances,
    wallSurface& surface,
    bitSet& onPlane
)
{
    const auto isCutOff = [&](const face& f)
    {
        return allOf(f, [&](const label p)
        {
            return distances[p] >= 0 || onPlane.test(p);
        });
    };

    bool more = true;
    const auto takeBack = [&](const label p)
    {
        if (onPlane.test(p))
        {
            onPlane.unset(p);
            surface.points[p] = from[p];
            more = true;
        }
    };

    while (more)
    {
        more = false;
        bitSet gone(surface.faces.size());
        forAll(surface.faces, facei)
        {
            gone.set(facei, isCutOff(surface.faces[facei]));
        }
        for (const label facei : facesInConflict(surface, gone))
        {
            for (const label p : surface.faces[facei])
            {
                takeBack(p);
            }
        }
        for (const label p : pinchedPoints(plane, distances, onPlane, surface))
        {
            if (onPlane.test(p))
            {
                takeBack(p);
                surface.points[p] += (near[p] - distances[p])*plane.normal;
                distances[p] = near[p];
            }
        }
        for (const label p : touchingPoints(plane, distances, onPlane, surface))
        {
            takeBack(p);
        }
    }
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

labelList facesInConflict(const wallSurface& surface, const bitSet& skip)
{
    const vectorField normals(surface.faceNormals());
    bitSet faces(surface.faces.size());
    bitSet skipped(skip);
    skipped.resize(surface.faces.size());
    forAll(normals, facei)
    {
        if (!skipped.test(facei) && normals[facei] == vector::zero)
        {
            faces.set(facei);
            skipped.set(facei);
        }
    }

    for (const labelPair& pair : findIntersectingFaces(surface, skipped))
    {
        faces.set(pair.first());
        faces.set(pair.second());
    }

    return faces.sortedToc();
}


void cutOff
(
    wallSurface& surface,
    const sidePatch& plane,
    const scalarField& distances
)
{
    planeCutter{plane, distances, surface}.cutFaces();
    removeUnusedPoints(surface.faces, surface.points);
}


void removeFacesOn
(
    wallSurface& surface,
    const sidePatch& plane,
    const scalar tolerance
)
{
    const scalarField distances(distancesTo(plane, surface.points));
    const auto isOff = [&](const label p)
    {
        return mag(distances[p]) > tolerance;
    };
    bitSet kept(surface.faces.size());
    forAll(surface.faces, facei)
    {
        kept.set(facei, anyOf(surface.faces[facei], isOff));
    }

    keepFaces(kept, surface);
}


void cutSurface
(
    wallSurface& surface,
    const sidePatch& plane,
    repairSteps& steps,
    const UList<sidePatch>& ends
)
{
    scalarField distances(distancesTo(plane, surface.points));
    const pointField from(surface.points);
    const scalarField near(nearDistances(surface));
    const bool isCyclic = plane.type == "cyclic";
    const auto find = isCyclic ? nearTheCutOfBoth : nearTheCut;
    bitSet onPlane(find(surface, distances, near));
    const waysOnSurface ways(plane, ends, surface, onPlane);
    for (const label p : onPlane)
    {
        const vector move(ways.move(p));
        if (move == vector(Zero) && distances[p] != 0)
        {
            onPlane.unset(p);
        }
        else
        {
            surface.points[p] += move;
        }
    }

    if (isCyclic)
    {
        takeBackConflictsOfBoth(plane, from, distances, surface, onPlane);
    }
    else
    {
        takeBackConflicts(plane, near, from, distances, surface, onPlane);
    }
    for (const label p : onPlane)
    {
        distances[p] = 0;
    }

    const label nFaces = surface.faces.size();
    cutOff(surface, plane, distances);
    addStep
    (
        steps, "points put on the side plane " + plane.name, onPlane.count()
    );
    addStep
    (
        steps, "faces removed beyond the side plane " + plane.name,
        max(nFaces - surface.faces.size(), label(1))
    );
}

} // End namespace Foam

// ************************************************************************* //
