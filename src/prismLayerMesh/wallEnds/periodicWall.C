/*---------------------------------------------------------------------------*\
    harmonicPrismMesh: boundary-layer meshes from an anisotropic harmonic field
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodicWall.H"
#include "boundBox.H"
#include "cyclicSides.H"
#include "DynamicList.H"
#include "ListOps.H"
#include "ranges.H"
#include "splitAtSidePatches.H"

namespace Foam
{

// * * * * * * * * * * * * * * *  Periodic Wall  * * * * * * * * * * * * * * //

//- Distance [m] within which points are equal but for rounding
static scalar roundingOf(const wallSurface& wall)
{
    return touchShare*sideTolerance*boundBox(wall.points, false).mag();
}


//- Moves the sides of a pair to the ends of the images, and makes other sides
//  whole planes.
static void moveSides(const sidePair& pair, wallSurface& wall)
{
    List<sidePatch>& sides = wall.border.sides;
    const scalar tolerance = roundingOf(wall);
    forAll(sides, s)
    {
        sidePatch& side = sides[s];
        if (s == pair.first || s == pair.second)
        {
            static_cast<sidePlane&>(side) = moved
            (
                side,
                s == pair.first ? pair.toSecond.inverse() : pair.toSecond
            );
            side.type = "patch";
        }
        else if
        (
            side.isCurved()
         || !isSamePlane(side, moved(side, pair.toSecond), tolerance)
        )
        {
            FatalErrorInFunction
                << "The side patch " << side.name << " is not the same beyond"
                << " the cyclic side patches " << sides[pair.first].name
                << " and " << sides[pair.second].name << nl
                << "Beside cyclic sides layers end only on planes that are"
                << " perpendicular to them" << exit(FatalError);
        }
        side.points.clear();
        side.faces.clear();
    }
}


//- Appends a motion after each of some motions. Returns the place of the first.
static label appendMotions
(
    const rigidMotion& motion,
    const UList<rigidMotion>& before,
    periodicWall& wall
)
{
    const label first = wall.motions.size();
    for (const rigidMotion& m : before)
    {
        wall.motions.append(motion.after(m));
    }

    return first;
}


namespace
{

//- Adds the images of a wall on both sides of a pair
struct imageMaker
{
    periodicWall& wall;
    const sidePair& pair;

    const wallSurface given = wall.surface;
    const labelList givenBases = wall.bases;
    const labelList givenMotions = wall.motionOfPoint;
    const List<rigidMotion> motions = wall.motions;

    DynamicList<edge> edges{};
    DynamicList<label> edgeSides{};

    //- The edges of the border that stay of an image
    void addBorder(const labelUList& labels, const label within)
    {
        forAll(given.border.edges, i)
        {
            const label side = given.border.edgeSides[i];
            const edge& e = given.border.edges[i];
            const bool isWithin =
                (side == pair.first || side == pair.second) && side != within;
            if (!isWithin)
            {
                edges.append(edge(labels[e.start()], labels[e.end()]));
                edgeSides.append(side);
            }
        }
    }

    //- Adds an image.
    //  joined: by point of the given wall that the image has in common with it,
    //  the label of that point there
    //  end: the side on which the image ends
    void add
    (
        const rigidMotion& motion,
        const Map<label>& joined,
        const label end
    )
    {
        const label firstMotion = appendMotions(motion, motions, wall);
        wallSurface& surface = wall.surface;
        labelList labels(given.points.size());
        DynamicList<point> points(surface.points);
        DynamicList<label> bases(wall.bases), motionOf(wall.motionOfPoint);
        forAll(labels, p)
        {
            labels[p] = joined.lookup(p, -1);
            if (labels[p] < 0)
            {
                labels[p] = points.size();
                points.append(motion(given.points[p]));
                bases.append(givenBases[p]);
                motionOf.append(firstMotion + givenMotions[p]);
            }
        }
        surface.points.transfer(points);
        wall.bases = std::move(bases);
        wall.motionOfPoint = std::move(motionOf);

        faceList faces(given.faces);
        for (face& f : faces)
        {
            inplaceRenumber(labels, f);
        }
        surface.faces.append(faces);
        surface.patchIDs.append(given.patchIDs);
        addBorder(labels, end);
    }
};

} // End anonymous namespace


//- Points on the second side become images of those on the first
static void joinSides
(
    const Map<label>& toSecond,
    const rigidMotion& motion,
    periodicWall& wall
)
{
    const label firstMotion =
        appendMotions(motion, List<rigidMotion>(wall.motions), wall);
    for (const label p : toSecond.sortedToc())
    {
        const label image = toSecond[p];
        wall.bases[image] = wall.bases[p];
        wall.motionOfPoint[image] = firstMotion + wall.motionOfPoint[p];
    }
}


//- Number of rings of faces beyond the given wall that its columns see
static const label nSeenRings = 2;


//- Whether columns see further than one image: few faces are between the sides
static bool isNarrow(const wallSurface& wall, const sidePair& pair)
{
    bitSet reached(wall.points.size()), end(wall.points.size());
    forAll(wall.border.edges, i)
    {
        const edge& e = wall.border.edges[i];
        for (const label p : {e.first(), e.second()})
        {
            const label side = wall.border.edgeSides[i];
            if (side == pair.first)
            {
                reached.set(p);
            }
            else if (side == pair.second)
            {
                end.set(p);
            }
        }
    }

    for (label ring = 0; ring < nSeenRings; ++ring)
    {
        const bitSet before(reached);
        for (const face& f : wall.faces)
        {
            if (anyOf(f, [&](const label p) { return before.test(p); }))
            {
                reached.set(f);
            }
        }
    }
    reached &= end;

    return reached.any();
}


static Map<label> inverseOf(const Map<label>& map)
{
    Map<label> inverse(2*map.size());
    forAllConstIters(map, iter)
    {
        inverse.insert(iter.val(), iter.key());
    }

    return inverse;
}


periodicWall::periodicWall(const wallSurface& given)
:
    surface(given),
    nPoints(given.points.size()),
    nFaces(given.faces.size()),
    bases(identity(nPoints)),
    motionOfPoint(nPoints, Zero),
    motions(1)
{
    DynamicList<sidePair> extensions;
    for (const sidePair& pair : pairsOf(given.border.sides))
    {
        extensions.append(pair);
        if (isNarrow(given, pair))
        {
            // Three periods become nine
            const rigidMotion& once = pair.toSecond;
            extensions.append(pair);
            extensions.last().toSecond = once.after(once.after(once));
        }
    }

    for (const sidePair& pair : extensions)
    {
        const Map<label> toSecond
        (
            imagesOnBorder(surface, pair, roundingOf(surface))
        );
        joinSides(toSecond, pair.toSecond, *this);

        imageMaker maker{*this, pair};
        maker.addBorder(identity(surface.points.size()), -1);
        maker.add(pair.toSecond, toSecond, pair.second);
        maker.add
        (
            pair.toSecond.inverse(), inverseOf(toSecond), pair.first
        );
        surface.border.edges = std::move(maker.edges);
        surface.border.edgeSides = std::move(maker.edgeSides);
        moveSides(pair, surface);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

labelList periodicWall::pointsOnSides(const wallSurface& given) const
{
    bitSet isOnSide(nPoints);
    for (const sidePair& pair : pairsOf(given.border.sides))
    {
        forAll(given.border.edges, i)
        {
            const label side = given.border.edgeSides[i];
            if (side == pair.first || side == pair.second)
            {
                isOnSide.set(given.border.edges[i]);
            }
        }
    }

    return subsetList
    (
        identity(bases.size()),
        [&](const label p) { return isOnSide.test(bases[p]); }
    );
}

} // End namespace Foam

// ************************************************************************* //
