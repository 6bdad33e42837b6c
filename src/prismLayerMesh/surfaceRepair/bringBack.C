/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bringBack.H"
#include "cutSurface.H"
#include "indexedOctree.H"
#include "treeDataEdge.H"
#include "unitConversion.H"
#include "wallSides.H"
#include "wallVisibility.H"

namespace Foam
{

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

//- Passes over faces at fault, more than it ever takes: each point is held back
//  three times at most
static constexpr label maxPasses = 50;

//- Least angle [deg] between the axis of a point's visibility cone and a face:
//  layers can begin there
static constexpr scalar smallestAngle = 10;

//- Least height of a triangle over its longest edge
static constexpr scalar leastHeight = 0.1;

//- The search tree of sharp edges: levels at most, edges in a leaf, and share
//  of edges in several leaves
static constexpr label treeLevels = 10;
static constexpr scalar treeLeafSize = 10;
static constexpr scalar treeDuplicity = 3;


//- Edges with one face or more than two, or between faces whose normals differ
//  by more than an angle
static edgeList sharpEdges(const wallSurface& surface, const scalar minCos)
{
    const vectorField normals(surface.faceNormals());
    const wallSides sides
    (
        makeWallSides(surface.faces, surface.points.size())
    );
    DynamicList<edge> sharp;

    for (label e = 0; e < sides.nEdges(); ++e)
    {
        const label start = sides.edgeStarts[e];
        const wallSide& first = sides.sides[start];
        bool isFlat = sides.edgeStarts[e + 1] - start == 2;

        if (isFlat)
        {
            // Normals of neighbours may be opposite to each other
            const vector& other = normals[sides.sides[start + 1].facei];
            isFlat = mag(normals[first.facei] & other) >= minCos;
        }
        if (!isFlat)
        {
            sharp.append(edge(first.low, first.high));
        }
    }

    return edgeList(std::move(sharp));
}


namespace
{

class returner
{
    const wallSurface& surface_;
    const scalar distance_;
    const scalar minCos_;
    wallSurface& wrap_;

    const pointField from_;

    //- The nearest points of the surface, and the normals there
    pointField onFaces_;
    vectorField normals_;

    //- Points of sharp edges to which points go instead
    Map<point> onEdges_;

    //- How far points are held back: not at all, to the nearest face, half way,
    //  where they were
    labelList held_;


    point target(const label p) const
    {
        const auto edgePoint = onEdges_.cfind(p);

        return
            held_[p] == 0 && edgePoint.found() ? edgePoint.val()
          : held_[p] <= 1 ? onFaces_[p]
          : held_[p] == 2 ? 0.5*(onFaces_[p] + from_[p])
          : from_[p];
    }

    //- Whether the ends of an edge are on two sides of a sharp edge
    bool isAcross(const edge& e) const
    {
        return
            held_[e.start()] == 0 && held_[e.end()] == 0
         && (normals_[e.start()] & normals_[e.end()]) < minCos_;
    }

    void setNearest(const nearestSurface& nearest);

    void takeToEdges();

    //- Faces that intersect others or are flat, and those around points with
    //  narrow visibility cones
    labelList facesAtFault() const;

public:

    returner
    (
        const wallSurface& surface,
        const nearestSurface& nearest,
        const scalar distance,
        const scalar featureAngle,
        wallSurface& wrap
    )
    :
        surface_(surface),
        distance_(distance),
        minCos_(Foam::cos(degToRad(featureAngle))),
        wrap_(wrap),
        from_(wrap.points),
        held_(wrap.points.size(), Zero)
    {
        setNearest(nearest);
        takeToEdges();
    }

    broughtBack move();
};


void returner::setNearest(const nearestSurface& nearest)
{
    labelList faces;
    nearest.find(from_, onFaces_, faces);
    const vectorField faceNormals(surface_.faceNormals());
    normals_ = UIndirectList<vector>(faceNormals, faces)();

    forAll(held_, p)
    {
        const vector out(from_[p] - onFaces_[p]);

        if (mag(out) > distance_)
        {
            held_[p] = 3;
        }

        // Faces of the surface need not be oriented alike
        if ((normals_[p] & out) < 0)
        {
            normals_[p] *= -1;
        }
    }
}


void returner::takeToEdges()
{
    const edgeList sharp(sharpEdges(surface_, minCos_));
    if (sharp.empty())
    {
        return;
    }

    treeBoundBox box(surface_.points);
    box.inflate(0.01);
    const indexedOctree<treeDataEdge> tree
    (
        treeDataEdge
        (
            false, sharp, surface_.points, identity(sharp.size())
        ),
        box, treeLevels, treeLeafSize, treeDuplicity
    );
    const auto nearestTo = [&](const label p)
    {
        return tree.findNearest(onFaces_[p], sqr(2*distance_));
    };

    for (const face& f : wrap_.faces)
    {
        for (const edge& e : f.edges())
        {
            // Each edge is of two faces
            if (e.start() > e.end() || !isAcross(e))
            {
                continue;
            }

            const pointIndexHit a(nearestTo(e.start()));
            const pointIndexHit b(nearestTo(e.end()));
            const scalar da =
                a.hit() ? mag(a.rawPoint() - onFaces_[e.start()]) : GREAT;
            const scalar db =
                b.hit() ? mag(b.rawPoint() - onFaces_[e.end()]) : GREAT;

            if (min(da, db) < GREAT)
            {
                const bool first = da <= db;
                onEdges_.set
                (
                    first ? e.start() : e.end(),
                    first ? a.rawPoint() : b.rawPoint()
                );
            }
        }
    }
}


labelList returner::facesAtFault() const
{
    bitSet fault(wrap_.faces.size(), facesInConflict(wrap_));
    forAll(wrap_.faces, facei)
    {
        const face& f = wrap_.faces[facei];
        const scalar longest =
            f.faceEdge(f.longestEdge(wrap_.points)).mag(wrap_.points);
        if (2*f.mag(wrap_.points) < leastHeight*sqr(longest))
        {
            fault.set(facei);
        }
    }

    const wallAddressing addressing(makeWallAddressing(wrap_));
    const boolList narrow
    (
        makeWallVisibility(wrap_, addressing).narrowCones
        (
            degToRad(smallestAngle)
        )
    );
    forAll(narrow, p)
    {
        if (narrow[p])
        {
            fault.set(addressing.pointFaces[p]);
        }
    }

    return fault.sortedToc();
}


broughtBack returner::move()
{
    const auto place = [&](const label p) { wrap_.points[p] = target(p); };
    forAll(held_, p)
    {
        place(p);
    }

    for (label pass = 0; pass < maxPasses; ++pass)
    {
        bitSet back(held_.size());
        for (const label facei : facesAtFault())
        {
            for (const label p : wrap_.faces[facei])
            {
                back.set(p, held_[p] < 3);
            }
        }
        if (back.none())
        {
            break;
        }
        for (const label p : back)
        {
            held_[p] =
                min(held_[p] + (held_[p] || onEdges_.found(p) ? 1 : 2), 3);
            place(p);
        }
    }

    broughtBack result;
    forAll(held_, p)
    {
        ++
        (
            held_[p] == 0 && onEdges_.found(p) ? result.nOnEdges
          : held_[p] <= 1 ? result.nOnFaces
          : held_[p] == 2 ? result.nBetween
          : result.nLeft
        );
    }

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

broughtBack bringBack
(
    const wallSurface& surface,
    const nearestSurface& nearest,
    const scalar distance,
    const scalar featureAngle,
    wallSurface& wrap
)
{
    return returner(surface, nearest, distance, featureAngle, wrap).move();
}

} // End namespace Foam

// ************************************************************************* //
